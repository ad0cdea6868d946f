"""The door of every public function: what its arguments must be, in one line above it.

    @door(theta=data(3), a2=positive(), unreachable=one_of("raise", "nan"))
    def inverse(theta, a2, unreachable="raise"): …

Inside, the arguments are arrays of floats whose batch shapes broadcast, and NumPy's warnings are
silent. *Parameters* (`positive`, `finite`, …) are refused when they cannot be meant. *Data* are
refused for their shape or type only: a row in which any of them is NaN or infinite becomes NaN in
all of them, and in every result. Where a function goes step by step (`steps`), a bad step becomes
NaN by itself, and what has no steps gets an axis of length 1 for them, data of one row apart.
"""

import inspect
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import reduce, wraps
from typing import Any, ParamSpec, TypeAlias, TypeVar, cast

import numpy as np

from robokin._checks import (
    Array,
    ArrayLike,
    Bools,
    Shape,
    every,
    is_finite,
    numbers,
    refuse,
    shown,
)
from robokin.errors import RobokinError

P = ParamSpec("P")
T = TypeVar("T")
Sizes = dict[str, int]  # what the letters in the shapes stand for in one call
Good: TypeAlias = Callable[[Array], Bools | np.bool_]  # for each number, or once for all
Check: TypeAlias = Callable[[str, Any, Sizes], Any]  # an argument's name, its value, the sizes

steps = "steps"  # the last axis of data and parameters that belong to the steps of a path


@dataclass(frozen=True)
class Rule:
    """An argument that is an array: the shape of one item, and what is refused."""

    core: tuple[int | str, ...] = ()  # a letter: a size that arguments have in common
    good: Good | None = None  # of data: what is neither NaN nor infinite
    ok: Callable[[Array], Bools] | None = None
    allowed: str = ""
    rows_ok: Callable[[str, Array], None] | None = None  # a look at data, bad rows all NaN
    per_step: bool = False

    def __call__(self, name: str, value: ArrayLike, sizes: Sizes) -> Array:
        array = numbers(name, value)
        if self.core:
            self.fit(name, array.shape, sizes)
        elif not array.ndim:
            array = array[()]  # a number: faster than an array of one
        if self.ok:
            refuse(name, array, self.ok(array), self.allowed)
        return array.reshape(1) if self.per_step and not array.ndim else array

    def fit(self, name: str, shape: Shape, sizes: Sizes) -> None:
        """Refuse a shape that does not end as it must; learn the sizes that are not yet known."""
        last = shape[-len(self.core) :]
        if last == self.core:
            return
        core = tuple(sizes.get(n, n) if isinstance(n, str) else n for n in self.core)
        pairs = zip(last, core, strict=False)
        if len(last) < len(core) or any(a != b if isinstance(b, int) else a < 1 for a, b in pairs):
            wanted = ", ".join(["…", *map(str, core)])
            letters = "".join(f", {n} at least 1" for n in core if isinstance(n, str))
            raise RobokinError(f"{name} must have shape ({wanted}){letters}, got {shape}")
        sizes.update((n, m) for n, m in zip(self.core, last, strict=True) if isinstance(n, str))


def _rule(core: tuple[int | str, ...], **fields: Any) -> Rule:
    return Rule(tuple(n for n in core if n != steps), per_step=steps in core, **fields)


def data(*core: int | str, good: Good = is_finite) -> Rule:
    """Poses, angles, rates: any numbers, NaN and infinity among them."""
    return _rule(core, good=good)


def whole(*core: int | str) -> Rule:
    """Data in whole numbers: ticks."""
    allowed = "whole numbers (NaN where a reading is missing)"
    return _rule(core, good=is_finite, allowed=allowed, ok=_is_whole)


def _is_whole(array: Array) -> Bools:
    same: Bools = np.rint(array) == array
    return same if every(same) else same | np.isnan(array)


def positive(*core: int | str) -> Rule:
    """A parameter greater than zero: a length."""
    return _rule(core, allowed="positive and finite", ok=lambda a: (a > 0) & (a < np.inf))


def not_negative(*core: int | str) -> Rule:
    """A parameter that may be zero."""
    return _rule(core, allowed="zero or more and finite", ok=lambda a: (a >= 0) & (a < np.inf))


def finite(*core: int | str) -> Rule:
    """A parameter that may be any finite number."""
    return _rule(core, allowed="finite", ok=np.isfinite)


def one(rule: Rule) -> Check:
    """A parameter that is a single number."""

    def check(name: str, value: ArrayLike, sizes: Sizes) -> float:
        array = rule(name, value, sizes)
        if array.ndim:
            raise RobokinError(f"{name} must be one number, got {shown(value)}")
        return float(array)

    return check


def one_of(*allowed: str) -> Check:
    """A name that must be one of a few."""

    def check(name: str, value: Any, sizes: Sizes) -> str:
        if not isinstance(value, str) or value not in allowed:
            raise RobokinError(f"{name} must be one of {', '.join(allowed)}, got {shown(value)}")
        return value

    return check


def door(**rules: Check) -> Callable[[Callable[P, T]], Callable[P, T]]:
    """Declare what the arguments of a public function must be; looked at in this order."""

    def decorate(function: Callable[P, T]) -> Callable[P, T]:
        parameters = inspect.signature(function).parameters
        names, accepted = list(parameters), parameters.keys()
        defaults = {n: p.default for n, p in parameters.items() if p.default is not p.empty}
        optional = {name for name, default in defaults.items() if default is None}
        formula: Callable[..., T] = function  # past the door its arguments are arrays

        @wraps(function)
        @quiet
        def checked(*args: P.args, **kwargs: P.kwargs) -> T:
            given: dict[str, Any] = dict(zip(names, args, strict=False))
            if kwargs or len(args) != len(names):
                twice = not kwargs.keys().isdisjoint(given)
                given = {**defaults, **given, **kwargs}
                if twice or len(args) > len(names) or given.keys() != accepted:
                    return function(*args, **kwargs)  # Python itself says what is wrong
            bad = admit(given, rules, optional)
            return cast(T, _finished(formula(**given), bad))

        return checked

    return decorate


def quiet(function: Callable[P, T]) -> Callable[P, T]:
    """Keep NumPy's warnings inside, where a function has no such door."""
    decorated: Callable[P, T] = np.errstate(all="ignore")(function)
    return decorated


def inside(function: Callable[P, T]) -> Callable[P, T]:
    """A public function without its door, for arguments that have come through one."""
    formula: Callable[P, T] = vars(function)["__wrapped__"]
    return formula


def admit(
    given: dict[str, Any], rules: Mapping[str, Check], optional: Collection[str] = ()
) -> Bools | None:
    """Look at all that is given, and put arrays in its place, which broadcast.

    Where there are bad rows they are returned; bad steps are not, for NaN finds its own way there.
    """
    sizes: Sizes = {}
    rows: dict[str, Rule] = {}
    stepped: dict[str, Rule] = {}
    batches: dict[str, Shape] = {}
    for name, rule in rules.items():
        if given[name] is not None or name not in optional:
            array = given[name] = rule(name, given[name], sizes)
            if isinstance(rule, Rule):
                (stepped if rule.per_step else rows)[name] = rule
                batches[name] = array.shape[: array.ndim - len(rule.core)]
    for name in rows if stepped else ():
        batches[name] += (1,)
        given[name] = given[name] if rows[name].core else given[name][..., None]
    shape = _broadcast(batches)
    bad = _spread_nan(given, rows)
    _spread_nan(given, stepped)
    for name, rule in rows.items():
        if rule.rows_ok:
            rule.rows_ok(name, given[name])
    return None if bad is None else np.broadcast_to(bad, shape[:-1] if stepped else shape)


def _broadcast(batches: Mapping[str, Shape]) -> Shape:
    shapes = set(batches.values()) - {()}
    if len(shapes) < 2:  # most calls; np.broadcast_shapes is slow
        return next(iter(shapes), ())
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError as error:
        got = ", ".join(f"{name} {batch}" for name, batch in batches.items() if batch)
        raise RobokinError(f"the batch shapes do not broadcast together: {got}") from error


def _spread_nan(given: dict[str, Any], rules: Mapping[str, Rule]) -> Bools | None:
    """Make a row NaN in all data if it is bad in any; the rows, if there are any."""
    good = {name: rule.good(given[name]) for name, rule in rules.items() if rule.good}
    if all([every(of) for of in good.values()]):
        return None
    axes = {name: tuple(range(-len(rules[name].core), 0)) for name in good}
    each = {name: np.broadcast_to(of, given[name].shape) for name, of in good.items()}
    rows: Any = ~reduce(np.logical_and, (of.all(axis=axes[name]) for name, of in each.items()))
    for name in good:
        given[name] = _blank(given[name], rows, len(axes[name]))
    return cast(Bools, rows)


def _blank(array: Any, rows: Bools, axes: int) -> Array:
    """The array with NaN in some rows, of so many axes each."""
    return np.where(rows[(..., *[None] * axes)], np.nan, array)[()]


def _finished(result: Any, bad: Bools | None) -> Any:
    """What is given back: NaN in bad rows, and a number in place of an array of one."""
    if type(result) is tuple:
        return tuple(_finished(part, bad) for part in result)
    if bad is not None and isinstance(result, np.ndarray | np.floating) and result.dtype != bool:
        return _blank(result, bad, result.ndim - bad.ndim)
    return result[()] if isinstance(result, np.ndarray) and result.ndim == 0 else result
