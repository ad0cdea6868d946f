"""Validation of arguments: one decorator above each public function.

    @validated(theta=data(3), a2=positive(), unreachable=one_of("raise", "nan"))
    def inverse(theta, a2, unreachable="raise"): …

Inside the function these arguments are arrays of floats whose batch shapes broadcast, and NumPy's
warnings are silent. *Parameters* (`positive`, `finite`, …) with an impossible value are refused.
*Data* are refused for their shape or type only: NaN and infinity go through the arithmetic.
"""

import inspect
from collections import UserList, deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, wraps
from itertools import combinations
from typing import Any, TypeAlias, TypeVar, cast

import numpy as np

from robokin._arrays import Array, Bools, Shape, first
from robokin.errors import RobokinError, at_index, describe

F = TypeVar("F", bound=Callable[..., Any])
Sizes: TypeAlias = dict[Any, int]  # what the letters in the shapes stand for in one call
Check: TypeAlias = Callable[[str, Any, Sizes], Any]  # an argument's name, its value, the sizes

MOST_AXES = 24  # NumPy's own limit is 32 in places, and a result may have more axes than its data
STEPS = "N"  # along this axis an argument may also be a single number, for all steps of a path
quiet = np.errstate(all="ignore")


@dataclass(frozen=True)
class Rule:
    """An argument that is an array: the shape of one item, and what is allowed of its numbers."""

    core: tuple[int | str, ...] = ()  # a letter: a size that arguments have in common
    ok: Callable[[Array], Bools] | None = None
    allowed: str = ""

    @cached_property
    def has_steps(self) -> bool:
        """Whether the argument belongs to the steps of a path."""
        return self.core[:1] == (STEPS,)

    def __call__(self, name: str, value: Any, sizes: Sizes) -> Array:
        array = real_numbers(name, value)
        if self.has_steps and array.ndim < len(self.core):
            array = array[None]
        if self.core and self.core != (STEPS,):
            self.check_shape(name, array.shape, sizes)
        if self.ok:
            refuse(name, array, self.ok(array), self.allowed)
        return array

    def check_shape(self, name: str, shape: Shape, sizes: Sizes) -> None:
        """Refuse a shape that does not end in the core; learn the letters not yet known."""
        letters = self.core[self.has_steps :]  # the numbers of steps broadcast
        last = shape[-len(letters) :]
        if last == letters:
            return
        core = [sizes.get(n, n) for n in letters]
        pairs = zip(core, last, strict=False)
        if len(last) < len(core) or any(m != n and (isinstance(n, int) or m < 1) for n, m in pairs):
            wanted = ", ".join(["…", *(f"{n}" if isinstance(n, int) else f"{n} ≥ 1" for n in core)])
            raise RobokinError(f"{name} must have shape ({wanted}), got {shape}")
        sizes.update(zip(letters, last, strict=True))


def data(*core: int | str) -> Rule:
    """Return the rule for poses, angles, rates: any numbers, NaN and infinity among them."""
    return Rule(core)


def whole(*core: int | str) -> Rule:
    """Return the rule for data in whole numbers: ticks."""
    allowed = "whole numbers (NaN where a reading is missing)"
    return Rule(core, lambda a: (np.rint(a) == a) | np.isnan(a), allowed)


def positive(*core: int | str) -> Rule:
    """Return the rule for a parameter greater than zero: a length."""
    return Rule(core, lambda a: (a > 0) & (a < np.inf), "positive and finite")


def not_negative(*core: int | str) -> Rule:
    """Return the rule for a parameter that may be zero."""
    return Rule(core, lambda a: (a >= 0) & (a < np.inf), "zero or more and finite")


def finite(*core: int | str) -> Rule:
    """Return the rule for a parameter that may be any finite number."""
    return Rule(core, np.isfinite, "finite")


def one_of(*allowed: str) -> Check:
    """Return the rule for a name that must be one of a few."""

    def check(name: str, value: Any, sizes: Sizes) -> str:
        if not isinstance(value, str) or value not in allowed:
            raise RobokinError(f"{name} must be one of {', '.join(allowed)}, got {describe(value)}")
        return value

    return check


def validated(**rules: Check) -> Callable[[F], F]:
    """Decorate a public function with a rule for each argument; they are applied in this order."""

    def decorate(function: F) -> F:
        parameters = inspect.signature(function).parameters
        defaults = {n: p.default for n, p in parameters.items() if p.default is not p.empty}
        required = [name for name in parameters if defaults.get(name, ...) is not None]

        @wraps(function)
        @quiet
        def wrapper(*args: Any, **kwargs: Any) -> Any:
            passed = dict(zip(parameters, args, strict=False)) | kwargs
            given = defaults | passed  # Signature.bind takes longer than most of the formulas
            if len(passed) < len(args) + len(kwargs) or given.keys() != parameters.keys():
                return function(*args, **kwargs)  # raises Python's own error
            validate(given, {n: rules[n] for n in rules if given[n] is not None or n in required})
            result = function(**given)
            return result[()] if isinstance(result, np.ndarray) else result

        return cast(F, wrapper)

    return decorate


def validate(given: dict[str, Any], rules: Mapping[str, Check]) -> None:
    """Put arrays that broadcast in place of the arguments, or refuse one of them."""
    sizes: Sizes = {}
    batches: dict[Shape, str] = {}  # each batch shape, and the first argument that has it
    lengths: dict[Shape, str] = {}  # likewise the numbers of steps
    for name, rule in rules.items():
        array = given[name] = rule(name, given[name], sizes)
        if isinstance(rule, Rule):
            axes = array.ndim - len(rule.core)
            batches.setdefault(array.shape[:axes], name)
            if rule.has_steps:
                lengths.setdefault(array.shape[axes : axes + 1], name)
    for shapes in batches, lengths:
        for s, t in combinations(shapes, 2):
            if any(m != n and 1 not in (m, n) for m, n in zip(s[::-1], t[::-1], strict=False)):
                raise RobokinError(f"shapes do not broadcast: {shapes[s]} {s}, {shapes[t]} {t}")


def real_numbers(name: str, value: Any) -> Array:
    """Return an array of floats; refuse masked arrays, strings, objects, complex, ragged lists."""
    try:
        masked = has_mask(value)
        array = np.asarray(0.0 if masked else value)
    except Exception as error:  # whatever a ragged list or a strange object does in there
        raise RobokinError(f"{name} must be a regular array, got {describe(value)}") from error
    if masked:
        raise RobokinError(f"{name} must not be masked; .filled(np.nan) makes masked values NaN")
    if array.dtype.kind not in "iuf":
        raise RobokinError(f"{name} must be real numbers, got {array.dtype} in {describe(value)}")
    if array.ndim > MOST_AXES:
        raise RobokinError(f"{name} must have at most {MOST_AXES} axes, got {array.ndim}")
    return array.astype(np.float64, copy=False)[()]  # a single one as a number, which is faster


def has_mask(value: Any) -> bool:
    """Return whether a value is a masked array or, as a list or a queue, holds one."""
    if isinstance(value, list | tuple | deque | UserList):
        return any(map(has_mask, value))
    return isinstance(value, np.ma.MaskedArray)


def refuse(name: str, array: Array, ok: Bools, allowed: str) -> None:
    """Raise for the first element that is not ok."""
    if not (ok.all() if ok.ndim else ok):  # all() of one takes 1 µs, as long as some formulas
        index = first(~ok)
        got = np.broadcast_to(array, ok.shape)[index]
        raise RobokinError(f"{name} must be {allowed}, got {got}{at_index(index)}")
