"""Functions of the chapter, until the library has them; arrays broadcast, lengths are in metres."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["focal_length", "image_distance", "image_height"]

Array = NDArray[np.float64]


def image_distance(d_o: ArrayLike, f: ArrayLike) -> Array:
    """Return how far behind a lens the image is of an object farther away than the focus.

    Examples
    --------
    >>> float(image_distance(0.3, 0.1).round(3))
    0.15
    """
    return np.asarray(1 / (1 / np.asarray(f, dtype=float) - 1 / np.asarray(d_o, dtype=float)))


def image_height(d_o: ArrayLike, d_i: ArrayLike, h_o: ArrayLike) -> Array:
    """Return the height of the image, negative because it is upside down."""
    return -np.multiply(h_o, np.divide(d_i, d_o))


def focal_length(d_o: ArrayLike, d_i: ArrayLike) -> Array:
    """Return the focal length from the distances of object and image."""
    return np.asarray(1 / (1 / np.asarray(d_o, dtype=float) + 1 / np.asarray(d_i, dtype=float)))
