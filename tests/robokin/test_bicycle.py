"""robokin.bicycle: steering angles of a car and its bicycle, turning radius, velocities, paths."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from support import EPS, METHODS, NEAR_ZERO, assert_close, poses, reals

from robokin import motion
from robokin.bicycle import (
    ackermann,
    ackermann_error,
    body_twist,
    corner_cut,
    equivalent_steering,
    front_twist,
    lane_width,
    path,
    steering,
    turning_radius,
)

QUARTER = np.pi / 2

speeds = reals(-3, 3)
steerings = reals(-1.5, 1.5)  # tan up to 14
lines = reals(-1.57, 1.57)  # steering angles nearly as far as they go
wheelbases = reals(1, 5)
tracks = reals(0.5, 2)

# An angle below π/2 is the arctangent of sines rounded a few times: a handful of EPS.
ATOL = 1e-14


def assert_axles(actual, expected, atol):
    """Steering angles of the same axles: equal up to half turns."""
    off = np.abs((np.asarray(actual) - expected + QUARTER) % np.pi - QUARTER)
    assert off.max() <= atol, f"axles differ by {off.max():.3g} rad, allowed {atol:.3g}"


# Laws


@given(lines, wheelbases, tracks)
def test_the_bicycle_of_the_cars_two_angles_is_the_bicycle(phi, wheelbase, track):
    left, right = ackermann(phi, wheelbase, track)
    # the wheels are no more than twice as far from the centre as the bicycle: factor 4
    assert_close(equivalent_steering(left, right), phi, atol=4 * ATOL)


@given(lines, wheelbases, tracks)
def test_the_front_axles_pass_through_the_centre_of_rotation(phi, wheelbase, track):
    # A wheel at (L, ±l/2) rolls along (cos α, sin α); its axle passes through [0, R] when the
    # way there is square to that. Multiplied by sin φ, since R = L cos φ/sin φ may be infinite.
    for alpha, y in zip(ackermann(phi, wheelbase, track), [track / 2, -track / 2], strict=True):
        to_centre = [-wheelbase * np.sin(phi), wheelbase * np.cos(phi) - y * np.sin(phi)]
        assert_close(np.dot(to_centre, [np.cos(alpha), np.sin(alpha)]), 0.0, atol=10 * ATOL)


@given(reals(0.1, 1.57), st.sampled_from([1, -1]), wheelbases, tracks)
def test_without_error_the_axles_meet(phi, side, wheelbase, track):
    left, right = ackermann(side * phi, wheelbase, track)
    # the cotangent of an angle of 0.07 multiplies its error by 1/0.07² = 200
    assert_close(ackermann_error(left, right, wheelbase, track), 0.0, atol=200 * ATOL)


@given(lines, lines, st.sampled_from([np.pi, -np.pi]))
def test_a_wheel_turned_by_half_a_turn_has_the_same_axle(left, right, half_turn):
    phi = equivalent_steering(left, right)
    assume(0.1 < abs(phi) < 1.5 and abs(left + right) > 0.1)
    # the angle itself loses an EPS of 3 by the half turn; a tenth of a radian magnifies it
    assert_close(equivalent_steering(left + half_turn, right), phi, atol=100 * ATOL)


@given(speeds.filter(lambda v: v), steerings, wheelbases)
def test_steering_undoes_the_body_twist(v, phi, wheelbase):
    omega = body_twist(v, phi, wheelbase)[2]
    # v of 1e-300 loses digits of ω below the smallest normal number
    assert abs(steering(v, omega, wheelbase) - phi) <= ATOL or abs(omega) < 1e-290


@given(speeds, reals(-3, 3), wheelbases)
def test_driving_backwards_mirrors_the_steering(v, omega, wheelbase):
    phi = steering(v, omega, wheelbase)
    np.testing.assert_array_equal(steering(-v, omega, wheelbase), -phi if phi else phi)


@given(speeds, steerings, wheelbases)
def test_the_front_wheel_rolls_where_it_points(v, phi, wheelbase):
    v_x, v_y, omega = front_twist(v, phi, wheelbase)
    # tan φ and 1/cos φ up to 14, times 3 m/s
    assert_close([v_x, v_y], v / np.cos(phi) * np.array([np.cos(phi), np.sin(phi)]), 100 * ATOL)
    assert omega == body_twist(v, phi, wheelbase)[2]


drives = st.lists(st.tuples(speeds, steerings, reals(0, 0.5)), min_size=1, max_size=6)


@given(poses, drives, wheelbases, st.sampled_from(METHODS))
def test_a_path_turns_as_the_body_twist_says(pose, drive, wheelbase, method):
    v, phi, dt = np.transpose(drive)
    omega = body_twist(v, phi, wheelbase)[:, 2]
    wanted = motion.path(pose, v, omega, dt, method)
    assert_close(path(pose, v, phi, wheelbase, dt, method), wanted, atol=2e-13)


@given(reals(0.01, 1.57), wheelbases, tracks)
def test_left_and_right_turns_need_the_same_room(phi, wheelbase, track):
    assert corner_cut(-phi, wheelbase) == corner_cut(phi, wheelbase)
    assert lane_width(-phi, wheelbase, track) == lane_width(phi, wheelbase, track)
    # half a turn more is the same axle; sines of π + φ differ in the last digit of π
    assert_close(corner_cut(phi + np.pi, wheelbase), corner_cut(phi, wheelbase), atol=ATOL)


@given(reals(0.01, 1.57), wheelbases, tracks)
def test_the_lane_lies_between_the_wheels_circles(phi, wheelbase, track):
    # each wheel is as far from the centre of rotation as the middle of its axle and half the track
    radius = float(turning_radius(phi, wheelbase))
    hubs = [(x, y) for x in (0, wheelbase) for y in (-track / 2, track / 2)]
    circles = [np.hypot(x, y - radius) for x, y in hubs]
    inner = min(circles) if radius > track / 2 else 0.0  # else the centre is under the car
    # radii up to 500 m, their difference
    assert_close(lane_width(phi, wheelbase, track), max(circles) - inner, atol=4 * EPS * 500)
    assert lane_width(phi, wheelbase, track) >= min(track, radius + track / 2)


@given(lines, wheelbases)
def test_the_front_axle_is_faster_by_the_cut_times_the_turning_rate(phi, wheelbase):
    (v, _, omega), front = body_twist(1.0, phi, wheelbase), front_twist(1.0, phi, wheelbase)
    # speeds up to 1/cos 1.57 = 1260 m/s
    faster = np.hypot(front[0], front[1]) - v
    assert_close(corner_cut(phi, wheelbase) * abs(omega), faster, atol=4 * EPS * 1260)


# The numbers of the hand solution


def test_a_right_triangle_for_every_wheel():
    # L = 3, l = 2, centre 4 m to the left: tan α_L = 3/3, tan α_R = 3/5, tan φ = 3/4
    angles = np.arctan2(3, [3, 5, 4])
    assert_close(ackermann(angles[2], wheelbase=3, track=2), angles[:2], atol=2 * EPS)
    assert_close(equivalent_steering(*angles[:2]), angles[2], atol=2 * EPS)
    assert_close(turning_radius(angles[2], wheelbase=3), 4.0, atol=8 * EPS)  # roundings of 4
    assert_close(ackermann_error(*angles[:2], wheelbase=3, track=2), 0.0, atol=4 * EPS)
    # the mean of the two angles is no answer (mistake M18): 37.98° for 36.87°
    assert_close(np.degrees([angles[2], angles[:2].mean()]), [36.8699, 37.9819], atol=1e-4)
    # cot 30° - cot 45° - 2/3, by hand
    error = ackermann_error(np.pi / 4, np.pi / 6, wheelbase=3, track=2)
    assert_close(error, np.sqrt(3) - 1 - 2 / 3, atol=8 * EPS)


def test_exercise_5_velocities():
    # v = 2 m/s, L = 2.5 m, φ = 45°: ω = 0.8 rad/s; the front axle 2√2 m/s at 45°, not 45° faster
    assert_close(body_twist(2.0, np.pi / 4, 2.5), [2, 0, 0.8], atol=4 * EPS)
    assert_close(steering([2.0, -2.0], [0.8, 0.8], 2.5), [np.pi / 4, -np.pi / 4], atol=EPS)
    assert_close(front_twist(2.0, np.pi / 4, 2.5), [2, 2, 0.8], atol=4 * EPS)
    assert_close(body_twist(2.0, -np.pi / 4, 2.5), [2, 0, -0.8], atol=4 * EPS)
    assert_close(front_twist(-2.0, np.pi / 4, 2.5), [-2, -2, -0.8], atol=4 * EPS)


def test_the_vehicle_of_seed_004():
    # chassis 7 m, wheels 1.5 m apart, φ = 30°: R = 7√3 = 12.124 m, the rear wheels on circles of
    # 11.374 m and 12.874 m, the front ones at arctan(7/11.374) = 31.61° and 28.53°
    phi = np.pi / 6
    assert_close(turning_radius(phi, 7.0), 12.1244, atol=5e-5)
    assert_close(np.degrees(ackermann(phi, 7.0, 1.5)), [31.6090, 28.5337], atol=5e-5)


def test_a_lane_change():
    # L = 2, φ = ±45°: radius 2; 30° to the left and 30° back: 2·2 sin 30° ahead, 2·2 (1 - cos 30°)
    along = path([1, 1, QUARTER], 1.0, [np.pi / 4, -np.pi / 4], 2.0, np.pi / 3)
    half = [1 - (2 - np.sqrt(3)), 2, QUARTER + np.pi / 6]
    whole = [1 - 2 * (2 - np.sqrt(3)), 3, QUARTER]
    assert_close(along, [[1, 1, QUARTER], half, whole], atol=8 * EPS)


def test_the_room_of_a_long_car():
    # 7 m, 1.5 m wide, steered so that R = 7/tan 45° = 7 m: circles of 7.75² + 7² and of 6.25 m
    assert_close(lane_width(np.pi / 4, 7.0, 1.5), np.sqrt(7.75**2 + 49) - 6.25, atol=1e-14)
    assert_close(corner_cut(np.pi / 4, 7.0), 7 * (np.sqrt(2) - 1), atol=1e-14)
    # on the spot about its left rear wheel, R = 0.75 m: a disc
    on_the_wheel = np.arctan(7 / 0.75)
    assert_close(lane_width(on_the_wheel, 7.0, 1.5), np.hypot(1.5, 7), atol=1e-14)


# Singular and boundary cases


def test_straight_ahead():
    assert equivalent_steering(0.0, 0.0) == 0
    np.testing.assert_array_equal(ackermann([0.0, -0.0], 2.5, 1.5), np.zeros((2, 2)))
    np.testing.assert_array_equal(turning_radius([0.0, -0.0], 2.5), [np.inf, np.inf])
    np.testing.assert_array_equal(body_twist(2.0, 0.0, 2.5), [2, 0, 0])
    np.testing.assert_array_equal(front_twist(2.0, 0.0, 2.5), [2, 0, 0])
    np.testing.assert_array_equal(path([0, 0, 0], 2.0, 0.0, 2.5, [1, 2])[-1], [6, 0, 0])
    assert ackermann_error(0.0, -0.0, 2.5, 1.5) == 0  # parallel axles
    assert not np.signbit(body_twist(2.0, -0.3, 2.5)[1])  # a plain 0 to print, not -0


@pytest.mark.parametrize("angle", [0.3, -0.3, 1.5, -1.5, QUARTER, -QUARTER, 1e-9, 1e-16, 3.0, -3.0])
def test_one_wheel_straight_ahead_drives_straight_ahead(angle):
    assert equivalent_steering(angle, 0.0) == 0
    assert equivalent_steering(-0.0, angle) == 0
    for zero in (0.0, -0.0):
        assert ackermann_error(angle, zero, 2.5, 1.5) == np.inf
        assert ackermann_error(zero, angle, 2.5, 1.5) == -np.inf


@pytest.mark.parametrize("angle", [1e-150, 1e-16, 1e-9, 0.3, 1.0, 1.5, QUARTER, 2.0])
def test_equal_and_opposite_angles_meet_at_the_rear_axle(angle):
    assert equivalent_steering(angle, -angle) == QUARTER
    assert equivalent_steering(-angle, angle) == QUARTER
    # and a little off, by 1e-3 … 1e-16, or by what is left of that in a sum of floats
    others = np.array(NEAR_ZERO) - angle
    off = others + angle
    phi = equivalent_steering(angle, others)
    wanted = np.arctan2(2 * np.sin(angle) * np.sin(others), np.sin(off))
    assert_axles(phi, wanted, atol=2 * EPS)
    clear = np.abs(np.tan(wanted)) < 1e15
    sign = np.sign(np.sin(angle)) * np.sign(np.sin(others)) * np.sign(np.sin(off))
    np.testing.assert_array_equal(np.sign(phi[clear]), sign[clear])


def test_wheels_at_ninety_degrees():
    assert equivalent_steering(QUARTER, QUARTER) == QUARTER
    assert equivalent_steering(-QUARTER, -QUARTER) == QUARTER  # the same axle as +90°
    # one at 90°: tan φ = 2 tan α of the other
    wanted = np.arctan2(2 * np.tan(0.3), 1)
    assert_close(equivalent_steering(QUARTER, 0.3), wanted, atol=2 * EPS)
    assert_close(equivalent_steering(-0.3, -QUARTER), -wanted, atol=2 * EPS)
    # φ = ±90°: the centre is the middle of the rear axle, tan α = ∓ 2L/l
    alpha = np.arctan2(5.0, 1.5)
    for phi in (QUARTER, -QUARTER):
        assert_close(ackermann(phi, 2.5, 1.5), [-alpha, alpha], atol=2 * EPS)
        assert_close(turning_radius(phi, 2.5), 0.0, atol=EPS)


@pytest.mark.parametrize("gap", [0.0, *NEAR_ZERO])
def test_the_inner_wheel_at_ninety_degrees_and_beyond(gap):
    # a circle of half the track, R = l/2 + gap: tan α_L = L/gap
    phi = np.arctan2(2.5, 0.75 + gap)
    left, right = ackermann(phi, 2.5, 1.5)
    # where phi is rounded (half an EPS), R is off by 2.5 EPS: 2 EPS in α_L
    assert_axles(left, np.arctan2(2.5, gap), atol=4 * EPS)
    assert -QUARTER < left <= QUARTER
    assert np.sign(left) == np.sign(gap) or abs(gap) < 1e-15
    assert_close(right, np.arctan2(2.5, 1.5 + gap), atol=2 * EPS)
    mirrored = ackermann(-phi, 2.5, 1.5)
    assert_axles(mirrored, [-right, -left], atol=EPS)
    assert ((mirrored > -QUARTER) & (mirrored <= QUARTER)).all()


def test_an_axle_across_the_car_is_plus_ninety_degrees():
    # cos φ and sin φ such that L cos φ - l/2 sin φ is zero to the last digit
    for phi in (np.pi / 4, -np.pi / 4, 3 * np.pi / 4):
        wheelbase = np.abs(np.sin(phi) / np.cos(phi))
        inner = ackermann(phi, wheelbase, 2.0)[0 if np.tan(phi) > 0 else 1]
        assert inner == QUARTER


@pytest.mark.parametrize("turn", [-1, 1, -3, 3])
def test_across_the_car_the_rear_axle_cannot_roll(turn):
    phi = turn * QUARTER
    nans = np.full(3, np.nan)
    np.testing.assert_array_equal(body_twist(2.0, phi, 2.5), nans)
    np.testing.assert_array_equal(body_twist(0.0, phi, 2.5), nans)
    np.testing.assert_array_equal(front_twist(2.0, phi, 2.5), nans)
    for method in METHODS:
        along = path([0, 0, 0], 1.0, [0, phi, 0], 2.5, 1.0, method)
        np.testing.assert_array_equal(along, [[0, 0, 0], [1, 0, 0], nans, nans])


def test_steering_at_rest_and_on_the_spot():
    found = steering(
        [0.0, -0.0, 0.0, 0.0, 1.0, -1.0, np.nan, 1.0], [0, 0, 1, -1, 0, 0, 1, np.nan], 2.5
    )
    np.testing.assert_array_equal(found, [0, 0, np.nan, np.nan, 0, 0, np.nan, np.nan])
    assert not np.signbit(found[:2]).any()
    # hardly driving, it steers across, where the turn is as tight as can be
    assert_close(steering([1e-20, -1e-20], 1.0, 2.5), [QUARTER, -QUARTER], atol=EPS)


def test_a_path_of_no_steps():
    np.testing.assert_array_equal(path([1, 2, 3], [], 0.1, 2.5, 0.1), [[1, 2, 3]])


@pytest.mark.parametrize("phi", [0.0, -0.0, *NEAR_ZERO])
def test_next_to_straight_ahead_the_lane_is_the_track(phi):
    # it widens by L²/2R = L φ/2 in all, to first order in a steering of 1e-3 at most
    assert_close(lane_width(phi, 2.5, 1.5), 1.5 + 1.25 * abs(phi), atol=phi**2 + 4 * EPS)
    assert corner_cut(phi, 2.5) == pytest.approx(1.25 * abs(phi), rel=1e-6, abs=0)


@pytest.mark.parametrize("phi", [QUARTER, -QUARTER])
def test_the_front_wheel_across_sweeps_a_disc_about_the_rear_axle(phi):
    assert_close(lane_width(phi, 2.5, 1.5), np.hypot(0.75, 2.5), atol=ATOL)
    assert_close(corner_cut(phi, 2.5), 2.5, atol=ATOL)


# Independent oracles


def precisely(function, *arguments):
    """A function of mpmath's numbers, with 50 digits, over arrays of floats."""
    with mpmath.workdps(50):
        return np.array(
            [
                [float(a) for a in np.atleast_1d(function(*map(mpmath.mpf, map(float, row))))]
                for row in np.broadcast(*arguments)
            ]
        )


def cot(angle):
    return mpmath.cos(angle) / mpmath.sin(angle)


RNG = np.random.default_rng(5)
ANGLES = np.concatenate(
    [RNG.uniform(-1.57, 1.57, 300), NEAR_ZERO, np.subtract(QUARTER, np.abs(NEAR_ZERO))]
)
OTHERS = RNG.permutation(ANGLES)


def test_equivalent_steering_with_fifty_digits():
    exact = precisely(lambda a, b: mpmath.atan(2 / (cot(a) + cot(b))), ANGLES, OTHERS)[:, 0]
    # three sines, two products, the sum of the angles and an arctangent below π/2
    assert_axles(equivalent_steering(ANGLES, OTHERS), exact, atol=4 * EPS)


def test_ackermann_with_fifty_digits():
    def wheels(phi, wheelbase, half):
        radius = wheelbase * cot(phi)
        return [mpmath.atan(wheelbase / (radius - half)), mpmath.atan(wheelbase / (radius + half))]

    for wheelbase, track in [(2.5, 1.5), (7.0, 1.5), (1.0, 2.0)]:
        exact = precisely(wheels, ANGLES, wheelbase, track / 2)
        # L cos φ - l/2 sin φ is off by an EPS of its terms, up to √(L² + l²/4), over L
        assert_axles(ackermann(ANGLES, wheelbase, track), exact, atol=4 * EPS)


def test_the_error_of_two_angles_with_fifty_digits():
    exact = precisely(lambda a, b: cot(b) - cot(a) - mpmath.mpf("0.5"), ANGLES, OTHERS)[:, 0]
    error = ackermann_error(ANGLES, OTHERS, 3.0, 1.5)
    # one rounding of α_L - α_R and the quotients: relative to the larger cotangent, not to the
    # difference of the two, which may be near zero
    scale = np.abs(precisely(lambda a, b: abs(cot(b)) + abs(cot(a)), ANGLES, OTHERS)[:, 0]) + 1
    assert np.max(np.abs(error - exact) / scale) <= 4 * EPS


def test_radius_and_velocities_with_fifty_digits():
    radius = precisely(lambda phi: mpmath.mpf("2.5") * cot(phi), ANGLES)[:, 0]
    np.testing.assert_allclose(turning_radius(ANGLES, 2.5), radius, rtol=4 * EPS)
    phi = ANGLES[np.abs(np.tan(ANGLES)) < 1e15]
    sideways = precisely(lambda phi: 3 * mpmath.tan(phi), phi)[:, 0]
    np.testing.assert_allclose(front_twist(3.0, phi, 2.5)[:, 1], sideways, rtol=4 * EPS)
    np.testing.assert_allclose(body_twist(3.0, phi, 2.5)[:, 2], sideways / 2.5, rtol=4 * EPS)


def test_room_against_fifty_digits():
    rng = np.random.default_rng(5)
    phi = np.r_[rng.uniform(-1.57, 1.57, 50), 10.0 ** rng.uniform(-15, -1, 50)]

    def width(phi):
        R, half = abs(L / mpmath.tan(phi)), track / 2
        return mpmath.hypot(R + half, L) - max(R - half, 0)

    L, track = mpmath.mpf(2.5), mpmath.mpf(1.5)
    # the lane of 1.5 to 4 m and the cut of 2.5 m, each from a few roundings
    wanted = precisely(width, phi)[:, 0]
    assert_close(lane_width(phi, 2.5, 1.5), wanted, atol=8 * EPS * 4)
    cut = precisely(lambda phi: abs(L * mpmath.tan(phi / 2)), phi)[:, 0]
    np.testing.assert_allclose(corner_cut(phi, 2.5), cut, rtol=8 * EPS)


def test_the_error_of_axles_keeps_its_digits_near_straight_ahead():
    """As differences of cotangents of 1e8 it would be off by 1e-8."""
    left, right = 1.0000001e-8, 1e-8
    with mpmath.workdps(50):
        exact = mpmath.cot(mpmath.mpf(right)) - mpmath.cot(mpmath.mpf(left)) - mpmath.mpf(1.5) / 2.5
    found = ackermann_error(left, right, wheelbase=2.5, track=1.5)
    assert found == pytest.approx(float(exact), rel=8 * EPS)  # a few roundings
