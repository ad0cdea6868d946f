"""Validation of arguments: a decorator above each public function, whose body is the formula.

    @validated(theta=data(3), a2=positive(), unreachable=one_of("raise", "nan"))
    def inverse(theta, a2, unreachable="raise"): …

Inside the function these arguments are arrays of floats, and NumPy's warnings are silent.
*Parameters* (`positive`, `finite`, …) with an impossible value are refused. *Data* are refused for
their shape or type only: NaN and infinity go through the arithmetic.
"""

from collections.abc import Callable
from functools import wraps
from inspect import signature
from typing import Any, TypeAlias, TypeVar, cast

import numpy as np

from robokin._arrays import Array, Bools, Shape, first
from robokin.errors import RobokinError, at_index, describe

F = TypeVar("F", bound=Callable[..., Any])
Sizes: TypeAlias = dict[Any, int]  # what the letters in the shapes mean in one call
Rule: TypeAlias = Callable[[str, Any, Sizes], Any]  # an argument's name, its value, the sizes

quiet = np.errstate(all="ignore")


def validated(**rules: Rule) -> Callable[[F], F]:
    """Decorate a public function with a rule for each argument; they are applied in this order."""

    def decorate(function: F) -> F:
        parameters = signature(function).parameters
        defaults = {n: p.default for n, p in parameters.items() if p.default is not p.empty}
        optional = {name for name, default in defaults.items() if default is None}
        defaults |= {n: rules[n](n, defaults[n], {}) for n in defaults.keys() - optional}

        @wraps(function)
        @quiet
        def wrapper(*args: Any, **kwargs: Any) -> Any:
            given = dict(zip(parameters, args, strict=False)) | kwargs
            if len(given) < len(args) + len(kwargs):
                return function(*args, **kwargs)  # raises Python's own error
            sizes: Sizes = {}
            for name, rule in rules.items():
                if name in given and (given[name] is not None or name not in optional):
                    given[name] = rule(name, given[name], sizes)
            try:
                result = function(**(defaults | given))
            except RobokinError:
                raise
            except ValueError as error:
                got = [f"{n} {a.shape}" for n, a in given.items() if getattr(a, "ndim", 0)]
                message = f"leading dimensions must be equal or 1, got {', '.join(got)}"
                raise RobokinError(message) from error
            return result[()] if isinstance(result, np.ndarray) else result

        return cast(F, wrapper)

    return decorate


def data(*core: int | str, ok: Callable[[Array], Bools] | None = None, allowed: str = "") -> Rule:
    """Return the rule for poses, angles, rates: any numbers, NaN and infinity among them.

    core: the shape of one item; a letter is a size that arguments have in common. ok: whether each
    number is allowed.
    """

    def check(name: str, value: Any, sizes: Sizes) -> Array:
        array = real_numbers(name, value)
        if core:
            check_shape(name, array.shape, core, sizes)
        if ok:
            refuse(name, array, ok(array), allowed)
        return array

    return check


def positive(*core: int | str) -> Rule:
    """Return the rule for a parameter greater than zero: a length."""
    return data(*core, ok=lambda a: (a > 0) & (a < np.inf), allowed="positive and finite")


def not_negative(*core: int | str) -> Rule:
    """Return the rule for a parameter that may be zero."""
    return data(*core, ok=lambda a: (a >= 0) & (a < np.inf), allowed="zero or more and finite")


def finite(*core: int | str) -> Rule:
    """Return the rule for a parameter that may be any finite number."""
    return data(*core, ok=np.isfinite, allowed="finite")


def one_of(*allowed: str) -> Rule:
    """Return the rule for a name that must be one of a few."""

    def check(name: str, value: Any, sizes: Sizes) -> str:
        if not isinstance(value, str) or value not in allowed:
            raise RobokinError(f"{name} must be one of {', '.join(allowed)}, got {describe(value)}")
        return value

    return check


def whole(name: str, value: Any, sizes: Sizes) -> Array:
    """Validate data in whole numbers: ticks."""
    array = real_numbers(name, value)
    if np.asarray(value).dtype.kind == "f":
        allowed = "whole numbers (NaN where a reading is missing)"
        refuse(name, array, (np.rint(array) == array) | np.isnan(array), allowed)
    return array


def check_shape(name: str, shape: Shape, core: tuple[int | str, ...], sizes: Sizes) -> None:
    """Refuse a shape that does not end in the core; learn the letters not yet known."""
    last = shape[-len(core) :]
    if last == core:
        return
    wanted = [sizes.get(n, n) for n in core]
    fits = (m == n or (m > 0 and isinstance(n, str)) for m, n in zip(last, wanted, strict=False))
    if len(last) < len(core) or not all(fits):
        sides = ", ".join(["…", *(f"{n} ≥ 1" if isinstance(n, str) else f"{n}" for n in wanted)])
        raise RobokinError(f"{name} must have shape ({sides}), got {shape}")
    sizes.update(zip(core, last, strict=True))


def real_numbers(name: str, value: Any) -> Array:
    """Return an array of floats; refuse masked arrays, strings, objects, complex, ragged lists."""
    if isinstance(value, float):
        return cast(Array, np.float64(value))  # a quick call for most numbers
    if has_mask(value):
        raise RobokinError(f"{name} must not be masked; .filled(np.nan) makes masked values NaN")
    try:
        array = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise RobokinError(f"{name} must be a regular array, got {describe(value)}") from error
    if array.dtype.kind not in "iuf":
        raise RobokinError(f"{name} must be real numbers, got {array.dtype} in {describe(value)}")
    return array.astype(np.float64, copy=False)[()]  # a single one as a number, which is faster


def has_mask(value: Any) -> bool:
    """Return whether a value is a masked array, or a list that holds one."""
    if isinstance(value, list | tuple):
        return any(map(has_mask, value))
    return hasattr(value, "mask")  # without numpy.ma, which takes 50 ms to import


def refuse(name: str, array: Array, ok: Bools, allowed: str) -> None:
    """Raise for the first element that is not ok."""
    if not (ok.all() if ok.ndim else ok):  # all() of one takes 1 µs, as long as some formulas
        index = first(~ok)
        got = np.broadcast_to(array, ok.shape)[index]
        raise RobokinError(f"{name} must be {allowed}, got {got}{at_index(index)}")
