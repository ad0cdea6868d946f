"""robokin.differential_drive: wheel rates and body velocity."""

import mpmath
import numpy as np
import pytest
from hypothesis import given
from support import EPS, NEAR_ZERO, assert_close, reals

from robokin.differential_drive import body_twist, turning_radius, wheel_rates
from robokin.motion import icr, to_world

rates = reals(-50, 50)
speeds = reals(-3, 3)
radii = reals(0.01, 1)
distances = reals(0.05, 2)

# Exercise 4: wheel radius 3 cm, wheels 10 cm apart
RADIUS, DISTANCE = 0.03, 0.1

# Laws


@given(rates, rates, radii, distances)
def test_wheel_rates_undoes_body_twist(left, right, radius, distance):
    v, _, omega = body_twist(left, right, radius, distance)
    # sums of rates up to 50 rad/s, four roundings of them
    assert_close(wheel_rates(v, omega, radius, distance), [left, right], atol=4 * EPS * 50)


@given(rates, rates, radii, distances)
def test_the_other_wheel_mirrors_the_turn(left, right, radius, distance):
    v, sideways, omega = body_twist(left, right, radius, distance)
    np.testing.assert_array_equal(body_twist(right, left, radius, distance), [v, sideways, -omega])
    np.testing.assert_array_equal(
        body_twist(-left, -right, radius, distance), [-v, sideways, -omega]
    )


@given(rates, rates, radii, distances)
def test_each_wheel_s_hub_moves_with_its_own_speed(left, right, radius, distance):
    # the hub at (0, ±b/2) of a rigid body moves with v ∓ omega b/2
    v, sideways, omega = body_twist(left, right, radius, distance)
    hubs = [v - omega * distance / 2, v + omega * distance / 2]
    assert_close(hubs, [left * radius, right * radius], atol=8 * EPS * 50)  # up to 50 m/s
    assert sideways == 0


@given(rates, rates, distances)
def test_the_turning_radius_is_how_far_to_the_left_the_icr_is(left, right, distance):
    twist = body_twist(left, right, 1.0, distance)
    radius = turning_radius(left, right, distance)
    np.testing.assert_allclose(radius, icr([0, 0, 0], twist[0], twist[2])[1], rtol=8 * EPS)


# The numbers of the hand solution


def test_exercise_4():
    # left wheel 5 cm/s, right wheel 10 cm/s, heading 90°: v = 0.075 m/s, omega = 0.5 rad/s
    twist = body_twist(0.05 / RADIUS, 0.10 / RADIUS, RADIUS, DISTANCE)
    assert_close(twist, [0.075, 0, 0.5], atol=4 * EPS)
    assert_close(to_world(np.pi / 2, twist), [0, 0.075, 0.5], atol=4 * EPS)
    # 5/3 and 10/3 rad/s; the turn has a radius of 0.15 m, to the left, which is -x
    assert_close(wheel_rates(0.075, 0.5, RADIUS, DISTANCE), [5 / 3, 10 / 3], atol=4 * EPS)
    assert_close(icr([0, 0, np.pi / 2], twist[0], twist[2]), [-0.15, 0], atol=4 * EPS)


def test_which_wheel_is_which():
    # the right wheel alone turns the robot to the left about the left wheel: v = b/2 · omega
    assert_close(body_twist(0, 2, 0.5, 2.0), [0.5, 0, 0.5], atol=0)
    assert_close(body_twist(2, 0, 0.5, 2.0), [0.5, 0, -0.5], atol=0)
    assert_close(wheel_rates(1, 0.5, 0.5, 2.0), [1, 3], atol=0)


def test_a_turn_on_the_spot_by_hand():
    # seed 003: omega_R = (v + omega b/2)/r with v = 0: 1 rad/s, b = 0.1, r = 0.03: ±5/3 rad/s
    assert_close(wheel_rates(0, 1, RADIUS, DISTANCE), [-5 / 3, 5 / 3], atol=2 * EPS)


def test_a_wheel_that_stands_is_what_the_robot_turns_about():
    assert turning_radius(0, 3, DISTANCE) == DISTANCE / 2
    assert turning_radius(3, 0, DISTANCE) == -DISTANCE / 2
    assert turning_radius(-2, 2, DISTANCE) == 0


# Singular and boundary cases


@pytest.mark.parametrize("rate", [-7.3, -1e-16, 0.0, 1e-300, 0.1, 1e10])
def test_equal_rates_drive_exactly_straight(rate):
    v, sideways, omega = body_twist(rate, rate, RADIUS, DISTANCE)
    assert v == RADIUS * rate
    assert omega == 0
    assert sideways == 0
    assert not np.signbit(sideways)  # 0, not -0, which prints badly


@pytest.mark.parametrize("rate", [-7.3, -1e-16, 1e-300, 0.1, 1e10])
def test_opposite_rates_turn_exactly_on_the_spot(rate):
    v, _, omega = body_twist(-rate, rate, RADIUS, DISTANCE)
    assert v == 0
    np.testing.assert_allclose(omega, 2 * RADIUS * rate / DISTANCE, rtol=2 * EPS)


@pytest.mark.parametrize("gap", NEAR_ZERO)
def test_next_to_straight_on_the_turning_rate_keeps_its_digits(gap):
    right = 1.0 + gap  # the float next to it; its difference from 1 is exact
    omega = body_twist(1.0, right, RADIUS, DISTANCE)[2]
    np.testing.assert_allclose(omega, (right - 1.0) * RADIUS / DISTANCE, rtol=2 * EPS)


def test_standing_still():
    np.testing.assert_array_equal(body_twist(0, 0, RADIUS, DISTANCE), [0, 0, 0])
    np.testing.assert_array_equal(wheel_rates(0, 0, RADIUS, DISTANCE), [0, 0])


@pytest.mark.parametrize("rate", [2.0, -2.0, 5e-324])
def test_straight_ahead_and_straight_back_the_radius_is_plus_infinity(rate):
    assert turning_radius(rate, rate, DISTANCE) == np.inf
    assert np.isnan(turning_radius(0, 0, DISTANCE))
    np.testing.assert_array_equal(turning_radius([1, rate], [3, rate], 1.0), [1, np.inf])


# Independent oracles


def test_against_fifty_digits():
    rng = np.random.default_rng(0)
    n = 300
    left, right = rng.uniform(-50, 50, (2, n))
    radius, distance = rng.uniform(0.01, 1, n), rng.uniform(0.05, 2, n)
    twist = body_twist(left, right, radius, distance)
    wheels = wheel_rates(left, right, radius, distance)
    with mpmath.workdps(50):
        for k in range(n):
            a, b, r, d = (mpmath.mpf(float(x[k])) for x in (left, right, radius, distance))
            # each a sum and two products or quotients: three roundings of half an EPS at most
            for got, wanted in [(twist[k, 0], r * (a + b) / 2), (twist[k, 2], r * (b - a) / d)]:
                assert abs(got - wanted) <= 1.5 * EPS * abs(wanted)
            # here the sum may cancel, so relative to its larger term
            for got, wanted in [
                (wheels[k, 0], (a - b * d / 2) / r),
                (wheels[k, 1], (a + b * d / 2) / r),
            ]:
                assert abs(got - wanted) <= 2 * EPS * (abs(a) + abs(b * d / 2)) / r


def test_turning_radius_against_fifty_digits():
    left, right = np.random.default_rng(1).uniform(-50, 50, (2, 100))
    with mpmath.workdps(50):
        pairs = [(mpmath.mpf(a), mpmath.mpf(b)) for a, b in zip(left, right, strict=True)]
        wanted = [float(mpmath.mpf(0.3) / 2 * (b + a) / (b - a)) for a, b in pairs]
    np.testing.assert_allclose(turning_radius(left, right, 0.3), wanted, rtol=4 * EPS)
