"""Comparison of formulas with functions: at generated and special points, in 50 digits."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import inf, isfinite
from typing import Any
from zlib import crc32

import mpmath
import numpy as np
import sympy as sp
from numpy.typing import NDArray

from courseware.equations.declared_checks import Check
from courseware.equations.equation import Where
from courseware.equations.functions import MPMATH
from courseware.errors import CourseError

Array = NDArray[np.float64]
SAMPLES = 100
DIGITS = 50


@dataclass(frozen=True)
class Result:
    """The largest difference between a formula and its function, and the point where it is."""

    check: Check
    samples: int
    difference: float
    worst: dict[str, float]

    @property
    def agrees(self) -> bool:
        return self.difference <= self.check.tolerance

    def __str__(self) -> str:
        point = ", ".join(f"{name} = {value:.6g}" for name, value in self.worst.items())
        return (
            f"{self.check.name} and its function are {self.difference:.1g} apart, "
            f"allowed {self.check.tolerance:.1g}, at {point}"
        )


def verify(check: Check, samples: int = SAMPLES) -> Result:
    """Return the largest difference between a formula's right side and its function."""
    equation, points = check.equation, draw_points(check, samples)
    exact = evaluate_exactly(equation.right, check.symbols, points, equation.where)
    computed = call_function(check, points)
    if computed.shape != exact.shape:
        raise CourseError(
            f"{check.name} has {exact.shape[1]} components, its function {computed.shape[1]}"
        )
    apart = differences(computed, exact, equation.is_angle).max(axis=1, initial=0.0)
    worst = int(apart.argmax())
    where = {str(s): float(v) for s, v in zip(check.symbols, points[worst], strict=True)}
    return Result(check, len(points), float(apart[worst]), where)


def draw_points(check: Check, samples: int = SAMPLES) -> Array:
    """Return points (n, symbols): the special ones, then random ones, the same every time."""
    symbols = check.symbols
    ranges = [check.ranges.get(s, (s.low, s.high)) for s in symbols]
    low, high = np.array(ranges).T
    random = np.random.default_rng(crc32(check.name.encode()))
    points = random.uniform(low, high, (len(check.specials) + samples, len(symbols)))
    whole = [symbols.index(symbol) for symbol in check.whole]
    points[:, whole] = np.rint(points[:, whole])
    for row, special in zip(points, check.specials, strict=False):
        for symbol, value in special.items():
            row[symbols.index(symbol)] = value
    return points


def evaluate_exactly(
    expression: Any, symbols: Sequence[sp.Symbol], points: Array, where: Where = ()
) -> NDArray[np.object_]:
    """Evaluate an expression or matrix at points in 50-digit arithmetic: (n, components)."""
    flat = tuple(expression) if isinstance(expression, sp.MatrixBase) else (expression,)
    known = (*symbols, *(symbol for symbol, _ in where))
    parts = (*(step for _, step in where), flat)
    *steps, function = (_in_mpmath(known[: len(symbols) + k], p) for k, p in enumerate(parts))
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


@lru_cache(maxsize=1024)  # a loop asks for its step many times
def _in_mpmath(symbols: tuple[sp.Symbol, ...], expression: Any) -> Callable[..., Any]:
    function: Callable[..., Any] = sp.lambdify(symbols, expression, modules=[MPMATH, "mpmath"])
    return function


def _real(value: Any) -> Any:
    if isinstance(value, mpmath.mpc):
        raise CourseError(f"an equation is not real in its range: {value}")
    return value if isinstance(value, mpmath.mpf) else mpmath.mpf(value)


def call_function(check: Check, points: Array) -> Array:
    """Call the function at the points: (n, components)."""
    found = np.asarray(check.function(*_arguments(check, points)), dtype=float)
    if check.component is not None:
        found = found[..., check.component]
    return found.reshape(len(points), -1)


def _arguments(check: Check, points: Array) -> list[Array]:
    columns = dict(zip(check.symbols, points.T, strict=True))
    return [_argument(a, columns, len(points)) for a in check.arguments]


def _argument(argument: Any, columns: dict[sp.Symbol, Array], n: int) -> Array:
    if isinstance(argument, tuple):
        return np.stack([_argument(a, columns, n) for a in argument], axis=-1)
    function = sp.lambdify(list(columns), argument, modules="numpy")
    return np.broadcast_to(np.asarray(function(*columns.values()), dtype=float), (n,))


def differences(computed: Array, exact: NDArray[np.object_], is_angle: bool = False) -> Array:
    """Return the distance of each element; infinite where infinities or NaN do not match."""
    pairs = zip(computed.ravel().tolist(), exact.flat, strict=True)
    with mpmath.workdps(DIGITS):
        return np.array([_apart(c, e, is_angle) for c, e in pairs]).reshape(computed.shape)


def _apart(computed: float, exact: Any, is_angle: bool) -> float:
    if not (isfinite(computed) and mpmath.isfinite(exact)):
        return 0.0 if str(computed) == str(float(exact)) else inf
    difference = abs(computed - exact)
    if is_angle:
        turns = mpmath.nint(difference / (2 * mpmath.pi))
        difference = abs(difference - 2 * mpmath.pi * turns)
    return float(difference)
