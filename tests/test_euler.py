"""robokin.euler: turns about the axes, all 24 sequences; axis and angle."""

import itertools
import re

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from scipy.spatial.transform import Rotation
from support import EPS, NEAR_ZERO, angles, assert_angles, assert_close, on_circle, reals, vectors

from robokin.errors import RobokinError
from robokin.euler import axis_angle, from_matrix, is_locked, solutions, steps, to_matrix

mpmath.mp.dps = 50

EXTRINSIC = [
    "".join(axes)
    for axes in itertools.product("xyz", repeat=3)
    if axes[0] != axes[1] and axes[1] != axes[2]
]
ALL = EXTRINSIC + [seq.upper() for seq in EXTRINSIC]
SHORT = sorted({seq[:n] for seq in ALL for n in (1, 2)})

seqs = st.sampled_from(ALL)
rotations = vectors(4, -1, 1).filter(lambda q: np.linalg.norm(q) > 0.1).map(
    lambda q: Rotation.from_quat(q).as_matrix()
)
round_angles = st.integers(-4, 4).map(lambda n: n * np.pi / 2)
turns = st.lists(st.one_of(angles, round_angles), min_size=3, max_size=3)

# An entry of a matrix is at most a sum of two products of three sines and cosines: five roundings
# of numbers up to 1. The promise for matrix → angles → matrix is 2e-15.
ROUND_TRIP = 2e-15


def is_proper(seq):
    return seq[0].lower() == seq[2].lower()


def turn(axis, angle):
    """The matrix of one turn, written down from the definition."""
    c, s = np.cos(angle), np.sin(angle)
    return {
        "x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
        "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
        "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
    }[axis.lower()]


# Laws


@given(seqs, turns)
def test_the_matrix_is_a_rotation(seq, turns):
    R = to_matrix(seq, turns)
    assert_close(R @ R.T, np.eye(3), atol=8 * EPS)
    assert_close(np.linalg.det(R), 1.0, atol=8 * EPS)


@given(seqs, turns)
def test_intrinsic_turns_are_extrinsic_turns_in_the_other_order(seq, turns):
    assert_close(to_matrix(seq, turns), to_matrix(seq[::-1].swapcase(), turns[::-1]), atol=4 * EPS)


@given(seqs, turns)
def test_turning_back_from_the_end_is_the_transpose(seq, turns):
    back = to_matrix(seq[::-1], -np.array(turns)[::-1])
    assert_close(back, to_matrix(seq, turns).T, atol=4 * EPS)


@given(seqs, st.integers(0, 3), turns)
def test_intrinsic_turns_are_multiplied_on_the_right_extrinsic_ones_on_the_left(seq, cut, turns):
    first = to_matrix(seq[:cut], turns[:cut]) if cut else np.eye(3)
    then = to_matrix(seq[cut:], turns[cut:]) if cut < 3 else np.eye(3)
    expected = first @ then if seq.isupper() else then @ first
    assert_close(to_matrix(seq, turns), expected, atol=8 * EPS)


@given(seqs, rotations)
def test_matrix_to_angles_to_matrix(seq, R):
    assert_close(to_matrix(seq, from_matrix(seq, R)), R, atol=ROUND_TRIP)


@given(seqs, turns)
def test_round_turns_survive_matrix_to_angles_to_matrix(seq, turns):
    R = to_matrix(seq, turns)
    assert_close(to_matrix(seq, from_matrix(seq, R)), R, atol=ROUND_TRIP)


@given(seqs, reals(-3.1, 3.1), reals(0.1, 1.4), reals(-3.1, 3.1))
def test_angles_to_matrix_to_angles(seq, a, b, c):
    # the outer angles come from entries of size sin(b) or cos(b) ≥ 0.1: ten times the rounding
    assert_angles(from_matrix(seq, to_matrix(seq, [a, b, c])), [a, b, c], atol=4e-15)


@given(seqs, rotations)
def test_angles_are_in_scipys_range(seq, R):
    a, b, c = from_matrix(seq, R)
    low, high = (0, np.pi) if is_proper(seq) else (-np.pi / 2, np.pi / 2)
    assert low <= b <= high
    assert -np.pi <= min(a, c)
    assert max(a, c) <= np.pi


@given(seqs, rotations)
def test_both_solutions_make_the_matrix(seq, R):
    both = solutions(seq, R)
    np.testing.assert_array_equal(both[0], from_matrix(seq, R))
    assert_close(to_matrix(seq, both), np.stack([R, R]), atol=ROUND_TRIP)


@given(seqs, rotations)
def test_the_second_solution_starts_the_other_way_round(seq, R):
    (a, b, c), second = solutions(seq, R)
    expected = [a + np.pi, -b if is_proper(seq) else np.pi - b, c + np.pi]
    assert_angles(second, expected, atol=4 * EPS)  # π is added or subtracted once
    assert -np.pi < min(second)
    assert max(second) <= np.pi


@given(seqs, rotations, reals(1e-6, 1))
def test_is_locked_looks_at_the_middle_angle(seq, R, tol):
    b = from_matrix(seq, R)[1]
    size = np.sin(b) if is_proper(seq) else np.cos(b)
    if abs(size - tol) > 4 * EPS:  # nearer, rounding decides
        assert is_locked(seq, R, tol) == (size <= tol)


@given(seqs, turns, st.integers(1, 3))
def test_steps_start_straight_and_add_one_turn_at_a_time(seq, turns, length):
    way = steps(seq[:length], turns[:length])
    np.testing.assert_array_equal(way[0], np.eye(3))
    for n in range(1, length + 1):
        np.testing.assert_array_equal(way[n], to_matrix(seq[:n], turns[:n]))


@given(rotations)
def test_axis_and_angle_make_the_matrix(R):
    axis, angle = axis_angle(R)
    assert_close(np.linalg.norm(axis), 1.0, atol=2 * EPS)
    assert 0 <= angle <= np.pi
    # Rodrigues' formula in floats: half a dozen roundings, beside those of the quaternion
    assert_close(rodrigues(axis, angle), R, atol=10 * EPS)


@given(rotations)
def test_the_axis_stays_where_it_is_and_the_inverse_turns_about_the_opposite_one(R):
    axis, angle = axis_angle(R)
    assert_close(R @ axis, axis, atol=8 * EPS)
    back, same = axis_angle(R.T)
    assert same == angle
    if 0 < angle < 3.14:  # no turn and half a turn are their own inverses
        np.testing.assert_array_equal(back, -axis)


def rodrigues(axis, angle):
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * K + 2 * np.sin(angle / 2) ** 2 * (K @ K)


# The numbers of the hand solution

# Exercise 2: {B} is {A} turned by +90° about y, then by −90° about its new z axis.
R_AB = np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]])

# The six of the 24 sequences for which it sits on gimbal lock: first angle with the third angle 0
# (sum or difference, as the exercise gives it) and the middle one. By hand, e.g. intrinsic XYZ:
# sin(middle) = R_xz = 1, and R = R_x(a) R_y(90°) has R_zy = sin(a) = −1.
LOCKED = {
    "XYZ": (-90, 90),
    "YZX": (90, -90),
    "ZXY": (-90, -90),
    "zyx": (-90, 90),
    "xzy": (-90, -90),
    "yxz": (90, -90),
}


def test_the_exercise_makes_the_matrix():
    # cos(π/2) is 6e-17 in floats
    assert_close(to_matrix("YZ", [np.pi / 2, -np.pi / 2]), R_AB, atol=EPS)
    assert_close(to_matrix("zy", [-np.pi / 2, np.pi / 2]), R_AB, atol=EPS)


def test_the_exercise_step_by_step():
    way = steps("YZ", [np.pi / 2, -np.pi / 2])
    assert_close(way, [np.eye(3), [[0, 0, 1], [0, 1, 0], [-1, 0, 0]], R_AB], atol=EPS)


def test_the_exercise_is_read_back():
    # YZ is YZX with nothing about x, or YZY with nothing about y; the others by hand:
    # ZYX: −sin b = R_zx = 0, tan a = R_yx/R_xx = −1/0, tan c = R_zy/R_zz = −1/0
    # ZYZ: cos b = R_zz = 0, tan a = R_yz/R_xz = 0/1, tan c = R_zy/−R_zx = −1/0
    for seq, degrees in (("YZY", [90, 90, 0]), ("ZYX", [-90, 0, -90]), ("ZYZ", [0, 90, -90])):
        expected = to_matrix(seq, np.radians(degrees))
        if seq == "YZY":
            expected = to_matrix("YZY", np.radians([-90, 90, 180]))  # b ≥ 0: turned round
            degrees = [-90, 90, 180]
        assert_close(expected, R_AB, atol=2 * EPS)
        assert_angles(from_matrix(seq, R_AB), np.radians(degrees), atol=EPS)


def test_the_exercise_sits_on_gimbal_lock_for_six_of_24_sequences():
    assert {seq for seq in ALL if is_locked(seq, R_AB)} == set(LOCKED)
    for seq, (first, middle) in LOCKED.items():
        assert_close(from_matrix(seq, R_AB), np.radians([first, middle, 0]), atol=EPS)
        sign = -1 if seq in ("YZX", "ZXY", "xzy", "yxz") else 1
        for c in (-2.0, 0.3, 1.0):  # any third angle will do, if the sum or difference stays
            same = to_matrix(seq, [np.radians(first) - sign * c, np.radians(middle), c])
            assert_close(same, R_AB, atol=4 * EPS)


def test_the_exercise_as_axis_and_angle():
    # trace 0, so cos(angle) = −1/2; the axis along [R_zy − R_yz, R_xz − R_zx, R_yx − R_xy]
    axis, angle = axis_angle(R_AB)
    assert_close(axis, np.array([-1, 1, -1]) / np.sqrt(3), atol=EPS)
    assert_close(angle, 2 * np.pi / 3, atol=2 * EPS)


def test_the_wrong_readings_of_the_exercise_give_something_else():
    right = to_matrix("YZ", [np.pi / 2, -np.pi / 2])
    other_order = to_matrix("yz", [np.pi / 2, -np.pi / 2])  # M6
    left_handed = to_matrix("YZ", [-np.pi / 2, np.pi / 2])  # M7
    for wrong in (other_order, left_handed):
        assert np.abs(wrong - right).max() > 0.9


# Singular and boundary cases


def near_lock(seq, distance, count=20):
    """Rotations with the middle angle this far from lock, exact before they are rounded."""
    rng = np.random.default_rng(ALL.index(seq))
    locks = [mpmath.mpf(0), mpmath.pi] if is_proper(seq) else [mpmath.pi / 2, -mpmath.pi / 2]
    return np.array(
        [
            floats(exact(seq, [a, locks[n % 2] + mpmath.mpf(distance), c]))
            for n, (a, c) in enumerate(rng.uniform(-np.pi, np.pi, (count, 2)))
        ]
    )


def turn_exactly(axis, angle):
    return mpmath.matrix(
        [[turned.subs(ANGLE, 0) for turned in row] for row in []] or _turn_exactly(axis, angle)
    )


def _turn_exactly(axis, angle):
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    return {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }[axis.lower()]
