"""robokin.euler: turns about the axes, all 24 sequences; axis and angle."""

import itertools

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given
from scipy.spatial.transform import Rotation
from support import (
    EPS,
    NEAR_ZERO,
    angles,
    assert_angles,
    assert_close,
    floats,
    reals,
    rotations,
    vectors,
)

from robokin.errors import RobokinError
from robokin.euler import (
    from_axis_angle,
    from_matrix,
    is_locked,
    solutions,
    steps,
    to_axis_angle,
    to_matrix,
)

mpmath.mp.dps = 50

EXTRINSIC = [
    "".join(axes)
    for axes in itertools.product("xyz", repeat=3)
    if axes[0] != axes[1] and axes[1] != axes[2]
]
ALL = EXTRINSIC + [seq.upper() for seq in EXTRINSIC]
SHORT = sorted({seq[:n] for seq in ALL for n in (1, 2)})

seqs = st.sampled_from(ALL)
round_angles = st.integers(-4, 4).map(lambda n: n * np.pi / 2)
turns = st.lists(st.one_of(angles, round_angles), min_size=3, max_size=3)

# An entry of a matrix is at most a sum of two products of three sines and cosines: five roundings
# of numbers up to 1. The promise for matrix → angles → matrix is 2e-15.
ROUND_TRIP = 2e-15


def is_proper(seq):
    return seq[0].lower() == seq[2].lower()


def entries(axis, c, s):
    """The matrix of one turn by its cosine and sine, written down from the definition."""
    return {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }[axis.lower()]


def turn(axis, angle):
    return np.array(entries(axis, np.cos(angle), np.sin(angle)))


# Laws


@given(seqs, turns)
def test_the_matrix_is_a_rotation(seq, turns):
    R = to_matrix(seq, turns)
    assert_close(R @ R.T, np.eye(3), atol=8 * EPS)
    assert_close(np.linalg.det(R), 1.0, atol=8 * EPS)


@given(seqs, turns)
def test_intrinsic_turns_are_extrinsic_turns_in_the_other_order(seq, turns):
    assert_close(to_matrix(seq, turns), to_matrix(seq[::-1].swapcase(), turns[::-1]), atol=4 * EPS)


@given(seqs, st.integers(0, 3), turns)
def test_intrinsic_turns_are_multiplied_on_the_right_extrinsic_ones_on_the_left(seq, cut, turns):
    first = to_matrix(seq[:cut], turns[:cut]) if cut else np.eye(3)
    then = to_matrix(seq[cut:], turns[cut:]) if cut < 3 else np.eye(3)
    expected = first @ then if seq.isupper() else then @ first
    assert_close(to_matrix(seq, turns), expected, atol=8 * EPS)


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
    axis, angle = to_axis_angle(R)
    assert_close(np.linalg.norm(axis), 1.0, atol=2 * EPS)
    assert 0 <= angle <= np.pi
    # Rodrigues' formula in floats: half a dozen roundings, beside those of the quaternion
    assert_close(rodrigues(axis, angle), R, atol=10 * EPS)


@given(rotations)
def test_the_axis_stays_where_it_is_and_the_inverse_turns_about_the_opposite_one(R):
    axis, angle = to_axis_angle(R)
    assert_close(R @ axis, axis, atol=8 * EPS)
    back, same = to_axis_angle(R.T)
    assert same == angle
    if 0 < angle < 3.14:  # no turn and half a turn are their own inverses
        np.testing.assert_array_equal(back, -axis)


def rodrigues(axis, angle):
    x, y, z = axis
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * K + 2 * np.sin(angle / 2) ** 2 * (K @ K)


@given(vectors(3, -3, 3).filter(lambda v: np.linalg.norm(v) > 0.1), angles)
def test_a_turn_about_an_axis_leaves_it_where_it_is(axis, angle):
    R = from_axis_angle(axis, angle)
    assert_close(R @ axis, np.array(axis), atol=16 * EPS * 3)
    assert_close(R @ R.T, np.eye(3), atol=16 * EPS)
    assert_close(from_axis_angle(axis, -angle), R.T, atol=8 * EPS)
    assert_close(from_axis_angle(-2 * np.array(axis), -angle), R, atol=8 * EPS)


@given(rotations)
def test_from_axis_angle_undoes_to_axis_angle(R):
    assert_close(from_axis_angle(*to_axis_angle(R)), R, atol=16 * EPS)


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


# By hand: ZYX: sin b = −R_zx = 0, tan a = R_yx/R_xx = −1/0, tan c = R_zy/R_zz = −1/0; ZYZ:
# cos b = R_zz = 0, tan a = R_yz/R_xz = 0/1, tan c = R_zy/−R_zx = −1/0; YZY is YZ and no third
# turn, [90, −90, 0], turned round so that b ≥ 0
@pytest.mark.parametrize(
    ("seq", "degrees"), [("ZYX", [-90, 0, -90]), ("ZYZ", [0, 90, -90]), ("YZY", [-90, 90, 180])]
)
def test_the_exercise_is_read_back(seq, degrees):
    assert_close(from_matrix(seq, R_AB), np.radians(degrees), atol=EPS)


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
    axis, angle = to_axis_angle(R_AB)
    assert_close(axis, np.array([-1, 1, -1]) / np.sqrt(3), atol=EPS)
    assert_close(angle, 2 * np.pi / 3, atol=2 * EPS)


def test_a_third_of_a_turn_about_the_diagonal_changes_the_axes_round():
    assert_close(
        from_axis_angle([1, 1, 1], 2 * np.pi / 3), np.roll(np.eye(3), 1, axis=0), atol=4 * EPS
    )
    assert_close(from_axis_angle([0, 0, 7], np.pi / 2), turn("z", np.pi / 2), atol=EPS)


# Singular and boundary cases


def exact(seq, turns):
    """The product of the turns in 50 digits, from the definition."""
    R = mpmath.eye(3)
    for axis, angle in zip(seq, turns, strict=True):
        one = mpmath.matrix(entries(axis, mpmath.cos(angle), mpmath.sin(angle)))
        R = R * one if seq.isupper() else one * R
    return R


def lock(seq, n=0):
    """The middle angle at gimbal lock, one of two, in 50 digits."""
    return n * mpmath.pi if is_proper(seq) else mpmath.pi / 2 - n * mpmath.pi


@pytest.mark.parametrize("seq", ALL)
def test_near_lock_no_digits_are_lost(seq):
    rng = np.random.default_rng(ALL.index(seq))
    for distance in [0.0, 1e-1, -1e-1, 1e-2, -1e-2, *NEAR_ZERO, 0.9e-15, 1.1e-15]:
        for n in (0, 1):
            a, c = rng.uniform(-np.pi, np.pi, 2)
            R = floats(exact(seq, [a, lock(seq, n) + mpmath.mpf(distance), c]))
            back = from_matrix(seq, R)
            assert_close(floats(exact(seq, back)), R, atol=ROUND_TRIP)
            assert_close(to_matrix(seq, back), R, atol=ROUND_TRIP)
            assert_close(to_matrix(seq, solutions(seq, R)[1]), R, atol=ROUND_TRIP)


def test_rounded_matrices_at_lock_survive_too():
    # turns multiplied in floats: the zeros are 1e-16 and more, of either sign
    rng = np.random.default_rng(1)
    a, c = rng.uniform(-np.pi, np.pi, (2, 500))
    noise = rng.uniform(-3e-15, 3e-15, 500)
    for seq in ALL:
        for n in (0, 1):
            R = to_matrix(seq, np.stack([a, float(lock(seq, n)) + noise, c], axis=-1))
            R += rng.uniform(-2 * EPS, 2 * EPS, R.shape)
            back = from_matrix(seq, R)
            # the matrix itself is no better a rotation than its noise, 2 EPS, twice over
            assert_close(to_matrix(seq, back), R, atol=ROUND_TRIP + 4 * EPS)


@pytest.mark.parametrize("seq", ALL)
def test_lock_is_what_lies_within_1e_15(seq):
    for n, sign in itertools.product((0, 1), (1, -1)):
        for distance, locked in ((0.9e-15, True), (1.1e-15, False)):
            middle = lock(seq, n) + sign * mpmath.mpf(distance)
            R = floats(exact(seq, [0.4, middle, 0.7]))
            _, b, c = from_matrix(seq, R)
            assert (c == 0) == locked
            if locked:
                assert b == float(lock(seq, n))
            else:
                # the entries are small but have all their digits; over the pole the other answer
                assert min(abs(c - 0.7), abs(c - 0.7 + np.pi)) <= 2 * EPS


def test_the_third_angle_is_zero_at_lock_and_the_first_takes_all():
    for seq, sign, n in itertools.product(ALL, (1, -1), (0, 1)):
        R = to_matrix(seq, [0.4, float(lock(seq, n)), sign * 0.7])
        a, b, c = from_matrix(seq, R)
        assert c == 0
        assert not np.signbit(c)
        assert b == float(lock(seq, n))
        # sum or difference of the first and third; sums rounded, and the zeros of R are 1e-16
        assert_close(min(abs(a - 0.4 - 0.7), abs(a - 0.4 + 0.7)), 0.0, atol=8 * EPS)


def cube():
    """The 24 rotations that take the axes to axes, with whole numbers."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            R = np.eye(3, dtype=int)[list(order)] * signs
            if np.linalg.det(R) > 0:
                yield R


@pytest.mark.parametrize("seq", ALL)
def test_quarter_turns_are_read_exactly(seq):
    quarters = np.array([-np.pi / 2, 0.0, np.pi / 2, np.pi])
    for R in cube():
        both = solutions(seq, R)
        assert np.isin(both, quarters).all()
        assert not np.signbit(both[both == 0]).any()  # no −0
        assert_close(to_matrix(seq, both), np.stack([R, R]), atol=4 * EPS)


@pytest.mark.parametrize("seq", ALL)
def test_the_second_solution_is_pi_and_not_minus_pi(seq):
    # a little off no turn at all, to either side: π less a little is still π in floats
    for axis, sign in itertools.product("xyz", (1, -1)):
        both = solutions(seq, turn(axis, sign * 1e-20))
        assert both.min() > -np.pi
        outer = both[1, [0, 2]]
        np.testing.assert_array_equal(outer, np.pi)


def test_no_turn():
    for seq in ALL:
        for length in (1, 2, 3):
            R = to_matrix(seq[:length], np.zeros(length))
            np.testing.assert_array_equal(R, np.eye(3))
            assert not np.signbit(R).any()
        np.testing.assert_array_equal(from_matrix(seq, np.eye(3)), [0, 0, 0])


@pytest.mark.parametrize("axis", "xyzXYZ")
@pytest.mark.parametrize("angle", [0.0, 1.0, -2.5, 100.0, *NEAR_ZERO])
def test_one_turn_is_its_sine_and_cosine(axis, angle):
    np.testing.assert_array_equal(to_matrix(axis, [angle]), turn(axis, angle))


@pytest.mark.parametrize("k", range(1, 16))
def test_is_locked_at_the_tolerance(k):
    tol = 10.0**-k
    for seq, (n, sign) in itertools.product(
        ("xyz", "YXY", "zxy"), itertools.product((0, 1), (1, -1))
    ):
        for share, locked in ((0.99, True), (1.01, False)):
            middle = lock(seq, n) + sign * share * mpmath.asin(tol)
            R = floats(exact(seq, [0.4, middle, 0.7]))
            assert is_locked(seq, R, tol) == locked
            assert is_locked(seq, R, [tol / 2, 2 * tol]).tolist() == [False, True]
            if k == 9:  # what is meant unless said otherwise
                assert is_locked(seq, R) == locked


def test_is_locked_includes_the_tolerance():
    assert is_locked("xyz", np.eye(3), 1.0)  # cos(0) = 1


@pytest.mark.parametrize("k", range(17))
def test_small_angles_keep_their_digits(k):
    rng = np.random.default_rng(k)
    for axis in unit(rng.normal(size=(10, 3))):
        angle = mpmath.mpf(float(rng.uniform(0.5, 1))) * mpmath.mpf(10) ** -k
        found, size = to_axis_angle(floats(exact_turn(axis, angle)))
        assert size == pytest.approx(float(angle), rel=4 * EPS)
        assert_close(found, axis, atol=4 * EPS)


@pytest.mark.parametrize("k", range(15))
def test_angles_near_a_half_turn_keep_their_digits(k):
    rng = np.random.default_rng(k)
    for axis in unit(rng.normal(size=(10, 3))):
        angle = mpmath.pi - mpmath.mpf(float(rng.uniform(0.5, 1))) * mpmath.mpf(10) ** -k
        found, size = to_axis_angle(floats(exact_turn(axis, angle)))
        assert_close(size, float(angle), atol=4 * EPS)  # of π
        assert_close(found, axis, atol=4 * EPS)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("distance", [0.0, *NEAR_ZERO[-8:], 0.9e-15, -0.9e-15, 1.1e-15, -1.1e-15])
def test_the_direction_at_a_half_turn(distance, sign):
    # about the x axis, or against it, by π − distance: within 1e-15 the axis is x, beyond it
    # is what it was; past the half turn it is the opposite one
    s = sign * distance
    R = np.array([[1, 0, 0], [0, -1, -s], [0, s, -1]])
    axis, angle = to_axis_angle(R)
    if abs(distance) <= 1e-15:
        np.testing.assert_array_equal(axis, [1, 0, 0])
        assert angle == np.pi
    else:
        np.testing.assert_array_equal(axis, [np.sign(s), 0, 0])
        assert_close(angle, np.pi - abs(distance), atol=2 * EPS)  # of π


def test_a_half_turn_has_its_first_component_positive():
    rng = np.random.default_rng(3)
    axes = unit([*rng.normal(size=(200, 3)), *itertools.product([-1, 0, 1], repeat=3)])
    axes = axes[np.isfinite(axes).all(axis=-1)]
    found, angle = to_axis_angle(2 * axes[:, :, None] * axes[:, None, :] - np.eye(3))
    lead = np.array([axis[np.abs(axis) > 0][0] for axis in axes])
    assert_close(found, axes * np.sign(lead)[:, None], atol=4 * EPS)
    np.testing.assert_array_equal(angle, np.pi)
    assert not np.signbit(found[found == 0]).any()


@pytest.mark.parametrize(
    ("axis", "expected"),
    [
        ([-1e-8, 1, 0], [1e-8, -1, 0]),
        ([-2e-15, 1, 0], [2e-15, -1, 0]),
        ([-5e-16, 1, 0], [-5e-16, 1, 0]),  # within 1e-15 a component is zero
        ([-5e-16, -1e-8, 1], [5e-16, 1e-8, -1]),
        ([-5e-16, -2e-15, 1], [5e-16, 2e-15, -1]),
        ([-5e-16, -5e-16, 1], [-5e-16, -5e-16, 1]),
        ([5e-16, 5e-16, -1], [-5e-16, -5e-16, 1]),
        ([5e-16, -1, 1e-8], [-5e-16, 1, -1e-8]),
    ],
)
def test_which_component_of_a_half_turn_counts_as_zero(axis, expected):
    found, angle = to_axis_angle(2 * np.outer(axis, axis) / np.dot(axis, axis) - np.eye(3))
    np.testing.assert_allclose(found, expected, rtol=4 * EPS)
    assert angle == np.pi


def test_half_turns_multiplied_in_floats():
    # z after x is y, but for zeros of 1e-16
    R = turn("z", np.pi) @ turn("x", np.pi)
    axis, angle = to_axis_angle(R)
    assert_close(axis, [0, 1, 0], atol=EPS)
    assert angle == np.pi


def test_no_rotation_is_about_z():
    for R in (np.eye(3), to_matrix("xyz", [0, 0, 0]), [np.eye(3)] * 2):
        axis, angle = to_axis_angle(R)
        np.testing.assert_array_equal(axis, np.broadcast_to([0, 0, 1], axis.shape))
        np.testing.assert_array_equal(angle, np.zeros(axis.shape[:-1]))
    R = np.eye(3)
    R[0, 1], R[1, 0] = 1e-200, -1e-200  # the smallest turn is still one
    axis, angle = to_axis_angle(R)
    np.testing.assert_array_equal(axis, [0, 0, -1])
    assert angle == pytest.approx(1e-200, rel=EPS)


@pytest.mark.parametrize("angle", NEAR_ZERO)
def test_a_small_turn_keeps_its_digits(angle):
    R = from_axis_angle([2, 0, 0], angle)
    assert_close(R[2, 1], np.sin(angle), atol=0)
    assert to_axis_angle(R)[1] == pytest.approx(abs(angle), rel=4 * EPS)


def test_axes_of_any_length_but_none():
    for length in (1e-320, 1e-200, 1.0, 1e200, 1e308):
        R = from_axis_angle([0, length, 0], 0.3)
        assert_close(R, turn("y", 0.3), atol=EPS)
    turned = from_axis_angle([[0, 0, 0], [0, 0, 1]], 0.3)
    assert np.isnan(turned[0]).all()
    assert_close(turned[1], turn("z", 0.3), atol=EPS)


# Errors


@pytest.mark.parametrize("seq", ["", "W", "XYZX", "XXY", "Xy", "xyw", None, ["x"]])
def test_a_bad_sequence_is_refused(seq):
    for function, data in ((to_matrix, np.zeros(3)), (from_matrix, np.eye(3))):
        message = r"1 to 3 letters, all of XYZ \(intrinsic\) or all of xyz \(extrinsic\), no axis"
        with pytest.raises(RobokinError, match=message):
            function(seq, data)


@pytest.mark.parametrize("function", [from_matrix, solutions, is_locked])
def test_a_short_sequence_is_refused_where_three_angles_are_asked_for(function):
    with pytest.raises(RobokinError, match="seq must have three letters here, got 'zy'"):
        function("zy", np.eye(3))


# Independent oracles


def unit(v):
    v = np.asarray(v, dtype=float)
    with np.errstate(invalid="ignore"):
        return v / np.linalg.norm(v, axis=-1, keepdims=True)


def exact_turn(axis, angle):
    """Rodrigues' formula in 50 digits; the axis made of length 1 first."""
    n = mpmath.matrix([float(v) for v in axis])
    x, y, z = n / mpmath.norm(n)
    K = mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return mpmath.eye(3) + mpmath.sin(angle) * K + (1 - mpmath.cos(angle)) * K * K


@pytest.mark.parametrize("seq", ALL + SHORT)
def test_matrices_against_50_digits(seq):
    turns = np.random.default_rng(len(seq)).uniform(-2 * np.pi, 2 * np.pi, (20, len(seq)))
    expected = [floats(exact(seq, [mpmath.mpf(a) for a in item])) for item in turns]
    assert_close(to_matrix(seq, turns), expected, atol=2 * EPS)


@pytest.mark.parametrize("seq", ALL + SHORT)
def test_matrices_against_scipy(seq):
    turns = np.random.default_rng(4).uniform(-2 * np.pi, 2 * np.pi, (500, len(seq)))
    assert_close(to_matrix(seq, turns), Rotation.from_euler(seq, turns).as_matrix(), atol=8 * EPS)


@pytest.mark.parametrize("seq", ALL)
def test_angles_against_scipy(seq):
    R = Rotation.random(1000, rng=np.random.default_rng(5)).as_matrix()
    R = R[~is_locked(seq, R, 0.1)]
    # ten times the rounding in both, as the outer angles come from entries of size 0.1
    assert_angles(from_matrix(seq, R), Rotation.from_matrix(R).as_euler(seq), atol=2e-14)


def test_axis_and_angle_against_scipy():
    rotations = Rotation.random(2000, rng=np.random.default_rng(6))
    axis, angle = to_axis_angle(rotations.as_matrix())
    assert_close(axis * angle[:, None], rotations.as_rotvec(), atol=2e-14)  # SciPy's near π


def test_about_against_scipy():
    rng = np.random.default_rng(8)
    axis, angle = rng.normal(size=(200, 3)), rng.uniform(-4, 4, 200)
    unit_axis = axis / np.linalg.norm(axis, axis=-1, keepdims=True)
    wanted = Rotation.from_rotvec(unit_axis * angle[:, None]).as_matrix()
    assert_close(from_axis_angle(axis, angle), wanted, atol=16 * EPS)
