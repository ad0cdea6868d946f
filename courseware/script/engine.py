"""JavaScript without a page: the parts' script, run by an engine, or by the browser itself.

Python in a browser (Pyodide) asks that browser; elsewhere the package `mini-racer` is the engine.
"""

import atexit
import json
import sys
from collections.abc import Callable
from functools import cache
from typing import Any

from courseware.script import parts

_loaded: list[str] = []  # parts


@cache
def _evaluate() -> Callable[[str], Any]:
    """Return what evaluates JavaScript, one for the whole process."""
    if sys.platform == "emscripten":
        from pyodide.code import run_js  # only there

        return run_js
    from py_mini_racer import MiniRacer  # not in a browser

    engine = MiniRacer()
    atexit.register(engine.close)  # an engine left open keeps Python from ending
    evaluate: Callable[[str], Any] = engine.eval
    return evaluate


def run(code: str) -> Any:
    """Return the value of JavaScript, which finds in `courseware` what the parts export.

    It crosses over as JSON, but with NaN and infinities.
    """
    evaluate = _evaluate()
    if _loaded != parts.list_parts():
        evaluate(f"globalThis.courseware = {parts.bundle_all()}; 0")
        _loaded[:] = parts.list_parts()
    wrapped = (
        f"JSON.stringify({code}, (_, x) => typeof x === 'number' && !Number.isFinite(x)"
        " ? {number: String(x)} : x)"
    )
    return json.loads(str(evaluate(wrapped)), object_hook=_number)


def call(function: str, *arguments: Any) -> Any:
    """Return the value of a JavaScript function for arguments that JSON can carry."""
    return run(f"{function}({', '.join(map(json.dumps, arguments))})")


def _number(value: dict[str, Any]) -> Any:
    return float(value["number"]) if set(value) == {"number"} else value
