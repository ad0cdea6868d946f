"""What every public function does at its door.

Parameters (lengths, radii, times) are refused when they cannot be meant. Data (poses, angles,
rates) are refused only for their shape or type; a value in them that is NaN or infinite makes
its own row NaN and touches no other.
"""

import reprlib
from collections.abc import Callable, Sequence
from typing import Any, ParamSpec, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robokin.errors import RobokinError

Array = NDArray[np.float64]
Shape = tuple[int, ...]
P = ParamSpec("P")
T = TypeVar("T")

MOST_AXES = 24  # NumPy's own limit is 32 in places, and a result may have more axes than its data


def quiet(function: Callable[P, T]) -> Callable[P, T]:
    """Keep NumPy's warnings inside: the result itself (NaN, inf) says what happened."""
    decorated: Callable[P, T] = np.errstate(all="ignore")(function)
    return decorated


def numbers(name: str, value: ArrayLike) -> Array:
    """`value` as an array of floats; strings, objects, complex and ragged lists are refused."""
    try:
        array = np.asarray(value)
    except Exception as error:  # whatever a ragged list or a strange object does in there
        raise RobokinError(
            f"{name} must be numbers in a regular array, got {shown(value)}"
        ) from error
    if array.dtype.kind not in "iuf":
        raise RobokinError(f"{name} must be real numbers, got {array.dtype} in {shown(value)}")
    if array.ndim > MOST_AXES:
        raise RobokinError(f"{name} must have at most {MOST_AXES} axes, got {array.ndim}")
    return array.astype(np.float64, copy=False)


def finite(name: str, value: ArrayLike) -> Array:
    """A parameter that may be any finite number; scalar or batch."""
    array = numbers(name, value)
    return _refuse(name, array, ~np.isfinite(array), "finite")


def positive(name: str, value: ArrayLike) -> Array:
    """A parameter that must be finite and greater than zero; scalar or batch."""
    array = numbers(name, value)
    return _refuse(name, array, ~((array > 0) & (array < np.inf)), "positive and finite")


def _refuse(name: str, array: Array, bad: NDArray[np.bool_], allowed: str) -> Array:
    if np.count_nonzero(bad):  # as any(), and twice as fast
        index = np.argwhere(bad)[0]
        where = f" at index {', '.join(map(str, index))}" if array.ndim else ""
        raise RobokinError(f"{name} must be {allowed}, got {array[tuple(index)]}{where}")
    return array


def choice(name: str, value: Any, allowed: Sequence[str]) -> str:
    """A name that must be one of a few."""
    if not isinstance(value, str) or value not in allowed:
        raise RobokinError(f"{name} must be one of {', '.join(allowed)}, got {shown(value)}")
    return value


def shown(value: Any) -> str:
    """What was got, cut short for a message; some objects cannot even be printed."""
    try:
        return reprlib.repr(value)
    except Exception:
        return f"a {type(value).__name__}"


def rows(
    *items: tuple[str, ArrayLike, Shape], parameters: Sequence[Array] = ()
) -> tuple[Shape, list[Array]]:
    """The data arguments as float arrays, and the batch shape that they broadcast to.

    Each item is (name, value, core shape): `("pose", pose, (3,))` takes (…, 3). A row in which
    any argument is NaN or infinite becomes NaN in all of them, so that its result is NaN.
    `parameters` (already checked scalars or batches) take part in the batch shape.
    """
    arrays = [numbers(name, value) for name, value, _ in items]
    cores = [core for _, _, core in items]
    for (name, _, core), array in zip(items, arrays, strict=True):
        if array.ndim < len(core) or array.shape[array.ndim - len(core) :] != core:
            wanted = ", ".join(["…", *map(str, core)])
            raise RobokinError(f"{name} must have shape ({wanted}), got {array.shape}")
    shape = _batch_shape(items, arrays, parameters)
    if any(np.count_nonzero(np.isfinite(array)) < array.size for array in arrays):
        arrays = _spread_nan(arrays, cores, shape)
    return shape, arrays


def _batch_shape(
    items: Sequence[tuple[str, ArrayLike, Shape]],
    arrays: Sequence[Array],
    parameters: Sequence[Array],
) -> Shape:
    batches = [
        array.shape[: array.ndim - len(core)]
        for (_, _, core), array in zip(items, arrays, strict=True)
    ]
    shapes = {*batches, *(array.shape for array in parameters)} - {()}
    if len(shapes) < 2:  # most calls; np.broadcast_shapes is slow
        return next(iter(shapes), ())
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError as error:
        got = ", ".join(
            f"{name} {batch}" for (name, _, _), batch in zip(items, batches, strict=True)
        )
        got += "".join(f", a parameter {array.shape}" for array in parameters if array.ndim)
        raise RobokinError(f"the batch shapes do not broadcast together: {got}") from error


def _spread_nan(arrays: list[Array], cores: list[Shape], shape: Shape) -> list[Array]:
    bad = np.zeros(shape, dtype=bool)
    for array, core in zip(arrays, cores, strict=True):
        bad |= ~np.isfinite(array).all(axis=tuple(range(-len(core), 0)))
    spread = []
    for array, core in zip(arrays, cores, strict=True):
        copy = np.broadcast_to(array, shape + core).copy()
        copy[bad] = np.nan
        spread.append(copy)
    return spread
