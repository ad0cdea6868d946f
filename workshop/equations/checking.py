"""Every equation against its function: generated points and special points, in 50 digits."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any
from zlib import crc32

import mpmath
import numpy as np
import sympy as sp
from numpy.typing import NDArray

from workshop.equations.core import Equation, Where, declared
from workshop.equations.functions import MPMATH
from workshop.errors import CourseError

Array = NDArray[np.float64]
SAMPLES = 1000
DIGITS = 50


@dataclass(frozen=True)
class Result:
    """How far an equation and its function are apart, over how many points, and where most."""

    equation: Equation
    samples: int
    difference: float
    worst: dict[str, float]

    @property
    def agrees(self) -> bool:
        """Whether the largest difference is within the equation's tolerance."""
        return self.difference <= self.equation.tolerance


def check(equations: Iterable[Equation] | None = None, samples: int = SAMPLES) -> list[Result]:
    """Hold every declared equation (or those given) that has a function to that function."""
    chosen = declared().values() if equations is None else equations
    return [check_one(e, samples) for e in chosen if e.function is not None]


def check_one(equation: Equation, samples: int = SAMPLES) -> Result:
    """The largest difference between an equation's right side and its function."""
    points = sample(equation, samples)
    exact = evaluate(equation.right, equation.symbols, points, equation.where)
    computed = _component(equation, points)
    if computed.shape != exact.shape:
        raise CourseError(
            f"{equation.name} has {exact.shape[1]} components, its function {computed.shape[1]}"
        )
    apart = differences(computed, exact, equation.is_angle).max(axis=1, initial=0.0)
    worst = int(apart.argmax())
    where = {str(s): float(v) for s, v in zip(equation.symbols, points[worst], strict=True)}
    return Result(equation, len(points), float(apart[worst]), where)


def sample(equation: Equation, samples: int = SAMPLES) -> Array:
    """Points (n, symbols): the special ones first, then generated ones, the same every time."""
    symbols = equation.symbols
    ranges = [equation.ranges.get(s, (s.low, s.high)) for s in symbols]
    low, high = np.array(ranges).T
    random = np.random.default_rng(crc32(equation.name.encode()))
    points = random.uniform(low, high, (len(equation.specials) + samples, len(symbols)))
    for row, special in zip(points, equation.specials, strict=False):
        for symbol, value in special.items():
            row[symbols.index(symbol)] = value
    return points


def evaluate(
    expression: Any, symbols: Sequence[sp.Symbol], points: Array, where: Where = ()
) -> NDArray[np.object_]:
    """An expression or matrix at every point in 50-digit arithmetic: (n, components)."""
    flat = list(expression) if isinstance(expression, sp.MatrixBase) else [expression]
    known = list(symbols)
    steps = []
    for symbol, step in where:
        steps.append(sp.lambdify(known, step, modules=[MPMATH, "mpmath"]))
        known.append(symbol)
    function = sp.lambdify(known, flat, modules=[MPMATH, "mpmath"])
    rows = []
    with mpmath.workdps(DIGITS):
        for point in points.tolist():
            values = [mpmath.mpf(x) for x in point]
            for step in steps:
                values.append(step(*values))
            try:
                rows.append([_real(x) for x in function(*values)])
            except ZeroDivisionError as error:
                place = ", ".join(f"{s} = {x:.6g}" for s, x in zip(symbols, point, strict=True))
                raise CourseError(
                    f"{expression} divides by zero at {place}: "
                    "give that case a branch (Piecewise), or narrow the ranges"
                ) from error
    return np.array(rows, dtype=object).reshape(len(points), len(flat))


def _real(value: Any) -> Any:
    if isinstance(value, mpmath.mpc):
        raise CourseError(f"an equation is not real in its range: {value}")
    return mpmath.mpf(value)


def _component(equation: Equation, points: Array) -> Array:
    """The function's own answer at the points, (n, components)."""
    columns = dict(zip(equation.symbols, points.T, strict=True))
    arguments = [_argument(a, columns, len(points)) for a in equation.arguments]
    assert equation.function is not None
    answer = np.asarray(equation.function(*arguments), dtype=float)
    if equation.component is not None:
        answer = answer[..., equation.component]
    return answer.reshape(len(points), -1)


def _argument(argument: Any, columns: dict[sp.Symbol, Array], n: int) -> Array:
    if isinstance(argument, tuple):
        return np.stack([_argument(a, columns, n) for a in argument], axis=-1)
    function = sp.lambdify(list(columns), argument, modules="numpy")
    return np.broadcast_to(np.asarray(function(*columns.values()), dtype=float), (n,))


def differences(computed: Array, exact: NDArray[np.object_], is_angle: bool = False) -> Array:
    """How far apart, element by element; infinite where infinities or NaN do not match."""
    apart = [_apart(float(c), e, is_angle) for c, e in zip(computed.flat, exact.flat, strict=True)]
    return np.array(apart).reshape(computed.shape)


def _apart(computed: float, exact: Any, is_angle: bool) -> float:
    if not (np.isfinite(computed) and mpmath.isfinite(exact)):
        same = str(computed) == str(float(exact))
        return 0.0 if same else np.inf
    with mpmath.workdps(DIGITS):
        difference = abs(mpmath.mpf(computed) - exact)
        if is_angle:
            turns = mpmath.nint(difference / (2 * mpmath.pi))
            difference = abs(difference - 2 * mpmath.pi * turns)
        return float(difference)
