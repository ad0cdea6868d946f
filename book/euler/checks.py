"""How the library agrees with each formula of `formulas.py`."""

from functools import partial
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from book.euler import formulas
from book.euler.formulas import RATES, TURNS, first, middle, third, turn
from courseware.equations import Array, Check
from robokin import euler

OPEN = {middle: (-1.4, 1.4)}  # rad: not near gimbal lock
QUARTERS = tuple({turn: quarter * pi / 2} for quarter in (-2, -1, 0, 1, 2))
STILL = dict.fromkeys(TURNS, 0.0)
EXERCISE = {first: -pi / 2, middle: 0.0, third: -pi / 2}
LOCK = ({middle: pi / 2}, {middle: -pi / 2})


def read_back(angles: ArrayLike) -> Array:
    """The angles of the matrix that turns about x, y and z make."""
    return euler.from_matrix("XYZ", euler.to_matrix("XYZ", angles))


def other_answer(seq: str, angles: ArrayLike) -> Array:
    """The angles of a sequence's other answer."""
    return euler.solutions(seq, euler.to_matrix(seq, angles))[..., 1, :]


def third_angle_first(angles: ArrayLike) -> Array:
    """The angles of the matrix that turns about x, y and z make, in the order γ, α, β."""
    return read_back(angles)[..., [2, 0, 1]]


def along_axis(angles: ArrayLike) -> Array:
    """The axis, times twice the sine of the angle, of the rotation that three turns make."""
    axis, angle = euler.to_axis_angle(euler.to_matrix("XYZ", angles))
    vector: Array = axis * 2 * np.sin(angle)[..., None]
    return vector


def angle_of_turn(angles: ArrayLike) -> Array:
    """The angle of the rotation that three turns make."""
    return euler.to_axis_angle(euler.to_matrix("XYZ", angles))[1]


def cosine_of_turn(angles: ArrayLike) -> Array:
    """Twice the cosine of the angle of the rotation that three turns make."""
    cosine: Array = 2 * np.cos(angle_of_turn(angles))
    return cosine


def angular_velocity(angles: Array, rates: Array) -> Array:
    """The matrix of the three turns, differentiated by four of its neighbours, and turned back."""
    h = 1e-3  # s

    def change(time: float) -> Array:
        ahead, before = (euler.to_matrix("XYZ", angles + t * rates) for t in (time, -time))
        return ahead - before

    R_dot = (8 * change(h) - change(2 * h)) / (12 * h)
    spin = R_dot @ np.swapaxes(euler.to_matrix("XYZ", angles), -1, -2)
    return np.stack([spin[..., 2, 1], spin[..., 0, 2], spin[..., 1, 0]], axis=-1)


def volume_of_axes(angles: Array) -> Array:
    """The determinant of the axes of the turns, each as the turns before it have left it."""
    on_the_way = euler.steps("XYZ", angles)
    axes = np.stack([on_the_way[..., k, :, k] for k in range(3)], axis=-1)
    determinant: Array = np.linalg.det(axes)
    return determinant


def about(along: Array, up: Array, turn: Array) -> Array:
    """A turn about the x axis of a frame that was turned along about z, then up."""
    there = euler.to_matrix("ZY", np.stack([along, -up], axis=-1))
    return there @ euler.to_matrix("X", turn[..., None]) @ np.swapaxes(there, -1, -2)


def quaternion(along: Array, up: Array, turn: Array) -> Array:
    """From half the turn: its matrix holds cosine and sine of half the angle."""
    half = about(along, up, turn / 2)
    w = (np.trace(half, axis1=-2, axis2=-1) - 1) / 2
    twice = half - np.swapaxes(half, -1, -2)
    return np.stack([w, twice[..., 2, 1] / 2, twice[..., 0, 2] / 2, twice[..., 1, 0] / 2], axis=-1)


CHECKS = (
    *(
        Check(
            turn_about,
            function=partial(euler.to_matrix, axis),
            arguments=((turn,),),
            tolerance=2e-16,
            reason="sine and cosine, each rounded once",
            specials=QUARTERS,
        )
        for axis, turn_about in zip(
            "XYZ", (formulas.turn_x, formulas.turn_y, formulas.turn_z), strict=True
        )
    ),
    *(
        Check(
            matrix,
            function=partial(euler.to_matrix, seq),
            arguments=(TURNS,),
            tolerance=1e-15,
            reason="sines and cosines, two products and a sum, each rounded once, of sizes up to 1",
            specials=(STILL, EXERCISE, *LOCK),
        )
        for seq, matrix in {"XYZ": formulas.xyz, "ZYX": formulas.zyx}.items()
    ),
    Check(
        formulas.rates,
        function=angular_velocity,
        arguments=(TURNS, RATES),
        tolerance=2e-11,
        reason="a fifth derivative, up to 243, times 1e-12/30; and rounding, over 1e-3",
        specials=(STILL, EXERCISE, *LOCK),
    ),
    Check(
        formulas.determinant,
        function=volume_of_axes,
        arguments=(TURNS,),
        tolerance=2e-15,
        reason="products of three entries up to 1, and their sum, each rounded",
        specials=(STILL, EXERCISE, *LOCK),
    ),
    Check(
        formulas.angles_at_once,
        function=read_back,
        arguments=(TURNS,),
        ranges=OPEN,
        tolerance=5e-15,
        reason="a few roundings of entries, divided by the cosine of the middle angle, 0.17",
        specials=(STILL, EXERCISE),
    ),
    Check(
        formulas.third_first,
        function=third_angle_first,
        arguments=(TURNS,),
        ranges=OPEN,
        tolerance=5e-15,
        reason="as euler.angles_at_once",
        specials=(STILL, EXERCISE),
    ),
    Check(
        formulas.other_cardan,
        function=partial(other_answer, "XYZ"),
        arguments=(TURNS,),
        ranges=OPEN,
        tolerance=5e-15,
        reason="as euler.angles_at_once",
        specials=(STILL, EXERCISE),
    ),
    Check(
        formulas.other_proper,
        function=partial(other_answer, "ZXZ"),
        arguments=(TURNS,),
        ranges={middle: (0.17, 2.97)},
        tolerance=5e-15,
        reason="a few roundings of entries, divided by the sine of the middle angle, 0.17",
        specials=({**STILL, middle: pi / 2},),
    ),
    Check(
        formulas.rodrigues,
        function=about,
        arguments=(first, middle, turn),
        tolerance=2e-15,
        reason="five turns one after the other, each rounded",
        specials=QUARTERS,
    ),
    Check(
        formulas.turn_vector,
        function=along_axis,
        arguments=(TURNS,),
        tolerance=5e-15,
        reason="a few roundings of entries, an angle up to 3.1, and twice its sine",
        specials=(STILL, EXERCISE, *LOCK),
    ),
    Check(
        formulas.turn_cosine,
        function=cosine_of_turn,
        arguments=(TURNS,),
        tolerance=1e-14,
        reason="as euler.turn_angle, and twice its cosine",
        specials=(STILL, EXERCISE, *LOCK),
    ),
    Check(
        formulas.turn_angle,
        function=angle_of_turn,
        arguments=(TURNS,),
        tolerance=5e-15,
        reason="a few roundings of entries up to 1, and an angle up to 3.1",
        specials=(STILL, EXERCISE, *LOCK),
    ),
    Check(
        formulas.unit_quaternion,
        function=quaternion,
        arguments=(first, middle, turn),
        ranges={turn: (0.0, 3.14)},
        tolerance=2e-15,
        reason="as euler.rodrigues",
    ),
)
