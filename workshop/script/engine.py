"""The JavaScript engine of the build: the same script as in the page, run without a page."""

import atexit
import json
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from py_mini_racer import MiniRacer

from workshop.script.runtime import runtime


@cache
def engine() -> MiniRacer:
    """One engine for the whole process, with the runtime loaded."""
    context = MiniRacer()
    atexit.register(context.close)  # an engine left open keeps Python from ending
    context.eval(runtime() + "\nglobalThis.robokin = robokin;")
    return context


def run(code: str) -> Any:
    """Evaluate JavaScript and bring its value over as JSON; NaN and infinities survive."""
    wrapped = (
        f"JSON.stringify({code}, (_, x) => typeof x === 'number' && !Number.isFinite(x)"
        " ? {number: String(x)} : x)"
    )
    return json.loads(str(engine().eval(wrapped)), object_hook=_number)


def _number(value: dict[str, Any]) -> Any:
    if set(value) == {"number"}:
        return float(value["number"])
    return value


def evaluate(function: str, points: ArrayLike) -> NDArray[np.float64]:
    """A JavaScript function `(f, c) => […]` at many points (n, k) in one call → (n, values)."""
    listed = json.dumps(np.asarray(points, dtype=float).tolist(), allow_nan=False)
    return np.array(run(f"{listed}.map((c) => ({function})(robokin.f, c))"), dtype=float)
