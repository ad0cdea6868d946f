"""What one value must be, and what is said when it is not."""

import reprlib
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from robokin.errors import RobokinError

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]
Shape = tuple[int, ...]
if TYPE_CHECKING:  # who calls may give anything; past the door (robokin._door) it is an array
    ArrayLike: TypeAlias = Array | Any
else:
    from numpy.typing import ArrayLike

FLOAT = np.dtype(np.float64)
MANY = 10_000  # from so many numbers on, a pass over all of them takes longer than some calls
MOST_AXES = 24  # NumPy's own limit is 32 in places, and a result may have more axes than its data


def numbers(name: str, value: ArrayLike) -> Array:
    """`value` as an array of floats, NaN where it is masked; strings, objects, complex and ragged
    lists are refused.
    """
    try:
        if isinstance(value, np.ma.MaskedArray):  # what is masked is missing
            value = np.ma.filled(value.astype(FLOAT), np.nan)
        array = np.asarray(value)
    except Exception as error:  # whatever a ragged list or a strange object does in there
        raise RobokinError(
            f"{name} must be numbers in a regular array, got {shown(value)}"
        ) from error
    if array.dtype.kind not in "iuf":
        more = "; float(…) makes one of it" if array.dtype == object else ""
        raise RobokinError(
            f"{name} must be real numbers, got {array.dtype} in {shown(value)}{more}"
        )
    if array.ndim > MOST_AXES:
        raise RobokinError(f"{name} must have at most {MOST_AXES} axes, got {array.ndim}")
    return array if array.dtype is FLOAT else array.astype(FLOAT, copy=False)


def refuse(name: str, array: Array, ok: Bools | np.bool_, allowed: str) -> None:
    """Name the first element that is not ok; in a batch of them, if `ok` is one."""
    if not every(ok):
        index = first(~ok)
        got = np.broadcast_to(array, np.shape(ok))[index]
        raise RobokinError(f"{name} must be {allowed}, got {got}{at(index)}")


def is_finite(array: Array) -> Bools | np.bool_:
    """Which numbers are finite; one True for many that all are, if their sum of squares is.

    That sum is taken several times as fast. It may overflow, then each number is looked at.
    """
    if array.size > MANY and array.flags.c_contiguous and np.isfinite(np.vdot(array, array)):
        return np.True_
    return np.isfinite(array)


def every(ok: Bools | np.bool_) -> bool:
    """The same as ok.all(), and several times as fast."""
    return bool(ok) if ok.ndim == 0 else np.count_nonzero(ok) == ok.size


def first(bad: Bools | np.bool_) -> tuple[int, ...]:
    """The index of the first bad element."""
    return tuple(map(int, np.argwhere(bad)[0]))


def at(index: tuple[int, ...]) -> str:
    """Which element of a batch is meant, as a message says it."""
    return f" at index {', '.join(map(str, index))}" if index else ""


def shown(value: Any) -> str:
    """What was got, cut short for a message; some objects cannot even be printed."""
    try:
        return reprlib.repr(value)
    except Exception:
        return f"a {type(value).__name__}"
