"""robokin.odometry: ticks, counters that wrap round, paths, covariance, calibration."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given
from support import EPS, METHODS, assert_close, poses, reals

from robokin import differential_drive, motion
from robokin.errors import RobokinError
from robokin.odometry import (
    covariance,
    ellipse,
    path,
    travel,
    umbmark,
    unwrap_counter,
    velocity,
)

ROBOT = (500, 0.05, 0.3)  # ticks a turn, wheel radius, wheel distance
ENDS = [[-0.1, 0.1]]

ticks = st.integers(-300, 300)
robots = st.tuples(st.integers(50, 5000), reals(0.01, 0.2), reals(0.1, 1))
drives = st.lists(st.tuples(ticks, ticks), min_size=1, max_size=8).map(np.transpose)
noises = reals(0, 0.01)

# 8 steps of at most 300 ticks: a wheel rolls up to 60 m a step (50 ticks a turn, 0.2 m), so the
# robot turns up to 600 rad a step and its heading is rounded by 1e-12 at most: the sum of
# 8 chords of up to 60 m that such a heading directs.
ATOL = 1e-9


def moved(drive, robot):
    """The travel of both wheels, as the exercise writes it."""
    left, right = drive
    per_turn, radius, _ = robot
    return 2 * np.pi * radius * left / per_turn, 2 * np.pi * radius * right / per_turn


# Laws


@given(st.integers(1, 52), st.data(), st.booleans())
def test_a_wrapped_counter_gives_its_steps_back(bits, data, signed):
    half = 2 ** (bits - 1)
    steps = data.draw(st.lists(st.integers(-half, half - 1), max_size=6))
    first = data.draw(st.integers(0, 2 * half - 1))
    totals = [first + sum(steps[:k]) for k in range(len(steps) + 1)]
    counts = [total % (2 * half) for total in totals]
    if signed:
        counts = [count - 2 * half * (count >= half) for count in counts]
    np.testing.assert_array_equal(unwrap_counter(counts, bits), steps)  # whole numbers: exact


@given(st.integers(2, 2**52), st.data())
def test_a_counter_of_any_modulus_gives_its_steps_back(modulus, data):
    steps = data.draw(st.lists(st.integers(-(modulus // 2), (modulus - 1) // 2), max_size=6))
    counts = [sum(steps[:k]) % modulus for k in range(len(steps) + 1)]
    np.testing.assert_array_equal(unwrap_counter(counts, modulus=modulus), steps)  # whole: exact


@given(poses, drives, robots, st.sampled_from(METHODS))
def test_a_path_is_a_drive_at_the_velocities_of_its_steps(pose, drive, robot, method):
    v, omega = velocity(*drive, 0.1, *robot)
    wanted = motion.path(pose, v, omega, 0.1, method)
    assert_close(path(*drive, *robot, pose, method), wanted, atol=ATOL)


@given(drives, robots)
def test_velocity_is_that_of_a_differential_drive(drive, robot):
    per_turn, radius, distance = robot
    v, omega = velocity(*drive, 0.25, *robot)
    rates = 2 * np.pi * drive / per_turn / 0.25
    twist = differential_drive.body_twist(*rates, radius, distance)
    # the same numbers by another order of three or four roundings; v of opposite wheels cancels
    size = np.abs(rates).sum(axis=0) * radius
    assert (np.abs(v - twist[:, 0]) <= 4 * EPS * size).all()
    assert (np.abs(omega - twist[:, 2]) <= 8 * EPS * size / distance).all()


@given(poses, drives, robots, noises, noises)
def test_the_covariance_is_a_covariance_and_grows(pose, drive, robot, noise, more):
    sigma = covariance(*drive, *robot, noise, pose)
    np.testing.assert_array_equal(sigma, np.swapaxes(sigma, -1, -2))
    size = np.abs(sigma).max() + 1e-300
    # the sums are of squares of levers; rounding can push an eigenvalue of 0 below it
    assert np.linalg.eigvalsh(sigma).min() >= -1e-12 * size
    assert (np.diff(sigma[:, 2, 2]) >= 0).all()  # the heading never gets better
    # twice the noise, twice the covariance; and it starts from what it is given
    assert_close(covariance(*drive, *robot, 2 * noise, pose), 2 * sigma, atol=1e-14 * size)
    start = np.diag([1.0, 2.0, 3.0]) * more
    np.testing.assert_array_equal(covariance(*drive, *robot, noise, pose, start)[0], start)


@given(drives, noises, poses, reals(-3, 3))
def test_the_covariance_turns_with_the_robot(drive, noise, pose, turn):
    here = covariance(*drive, *ROBOT, noise, pose)
    there = covariance(*drive, *ROBOT, noise, [5.0, -3.0, pose[2] + turn])
    c, s = np.cos(turn), np.sin(turn)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    assert_close(there, R @ here @ R.T, atol=1e-12 * np.abs(here).max() + 1e-300)


@given(reals(0.01, 2), reals(0, 1), reals(-1.5, 1.5))
def test_the_ellipse_of_a_covariance_is_what_it_was_made_of(large, part, angle):
    c, s = np.cos(angle), np.sin(angle)
    axes = np.array([[c, -s], [s, c]])
    made = axes @ np.diag([large**2, (part * large) ** 2]) @ axes.T
    found, directions = ellipse(made)
    # a variance is rounded to 4 EPS large²; the root of a small one doubles its share
    assert_close(found[0], large, atol=8 * EPS * large)
    assert abs(found[1] ** 2 - (part * large) ** 2) <= 32 * EPS * large**2
    assert_close(directions.T @ directions, np.eye(2), atol=4 * EPS)
    again = directions @ np.diag(found**2) @ directions.T
    assert_close(again, made, atol=64 * EPS * large**2)


# The numbers of the hand solution


def test_one_turn_of_a_wheel():
    # r = 5 cm, C = 500: half a turn is π·0.05 = 0.15708 m; backwards, the same
    assert_close(travel([250, -250], 500, 0.05), [0.05 * np.pi, -0.05 * np.pi], atol=EPS)


def test_exercise_7_the_two_wheels():
    # D_L = 0.2π, D_R = 0.4π, b = 0.4π: V = 0.3π/0.5, ω = 0.5/0.5; v and omega are single numbers
    v, omega = velocity(100, 200, 0.5, 100, 0.1, 0.4 * np.pi)
    assert_close([v, omega], [0.6 * np.pi, 1.0], atol=4 * EPS)
    # standing still, straight on and on the spot, where ρ = D_L/Δθ of the derivation fails
    v, omega = velocity([0, 50, -50], [0, 50, 50], 0.5, 100, 0.1, 0.4 * np.pi)
    assert_close(v, [0, 0.2 * np.pi, 0], atol=2 * EPS)
    assert_close(omega, [0, 0, 1], atol=2 * EPS)


def test_a_square():
    # the same robot: 2 ticks ahead are 1 m, ∓1 tick is a quarter turn on the spot
    left, right = [2, -1] * 4, [2, 1] * 4
    x, y = [1, 1, 1, 1, 0, 0, 0, 0], [0, 0, 1, 1, 1, 1, 0, 0]
    quarters = np.array([0, 1, 1, 2, 2, 3, 3, 4])
    wanted = np.stack([x, y, quarters * np.pi / 2], axis=-1)
    for method in METHODS:  # no step does two things at once, so all rules agree
        along = path(left, right, 2, 0.5 / np.pi, 2 / np.pi, method=method)
        assert_close(along[1:], wanted, atol=8 * EPS)


def test_counters_that_wrap_round():
    # 8 bits: 250 → 4 is 10 ahead, 3 → 250 is 9 back (mistake M25: 247 ahead)
    np.testing.assert_array_equal(unwrap_counter([250, 4, 3, 250, 250], 8), [10, -1, -9, 0])
    np.testing.assert_array_equal(unwrap_counter([120, -120, 120], 8), [16, -16])  # signed
    np.testing.assert_array_equal(unwrap_counter([32767, -32768, 0], 16), [1, -32768])


def test_counters_of_a_modulus_by_hand():
    np.testing.assert_array_equal(unwrap_counter([3990, 10, 3995], modulus=4000), [20, -15])
    np.testing.assert_array_equal(unwrap_counter([0, 4, 8, 0], modulus=9), [4, 4, 1])  # odd
    np.testing.assert_array_equal(unwrap_counter([0, 5], modulus=[9, 10]), [[-4], [-5]])


def test_two_readings_of_one_time_have_no_velocity():
    v, omega = velocity([5, 5, 0], [5, 7, 0], [0.1, 0.0, 0.0], *ROBOT)
    np.testing.assert_array_equal(np.isnan([v, omega]), [[False, True, True]] * 2)
    assert v[0] == velocity(5, 5, 0.1, *ROBOT)[0]


def test_unsigned_ticks_that_cannot_have_wrapped_round_are_taken():
    np.testing.assert_array_equal(path(np.uint8([3, 127]), 1, *ROBOT), path([3, 127], 1, *ROBOT))


def test_the_covariance_of_one_straight_metre():
    # Both wheels 1 m, each with the variance 0.01 m²: x is their mean, 0.005; θ is their
    # difference by b = 0.5: 0.02/0.25 = 0.08; y is half a metre times the mean error of θ: 0.02,
    # because the errors build up along the step, and θ and y together 0.04.
    sigma = covariance(2, 2, 2, 0.5 / np.pi, 0.5, noise=0.01)
    wanted = [[0.005, 0, 0], [0, 0.02, 0.04], [0, 0.04, 0.08]]
    assert_close(sigma, [np.zeros((3, 3)), wanted], atol=EPS)


def test_an_uncertain_heading_spreads_to_the_side():
    # noiseless; 0.1 rad standard deviation in θ, 3 m along y: x has 0.3 m, with the other sign
    sigma = covariance(6, 6, 2, 0.5 / np.pi, 0.5, 0.0, [7, 8, np.pi / 2], np.diag([0, 0, 0.01]))
    assert_close(sigma[1], [[0.09, 0, -0.03], [0, 0, 0], [-0.03, 0, 0.01]], atol=4 * EPS)


def square_run(true_distance, ratio, side, wheel_distance, turns):
    """Where the robot really ends when by its odometry it drives a perfect square.

    Two wheels whose diameters differ by `ratio` (right by left; their mean is right), steered by
    ticks for the wheel distance that the odometry believes in.
    """
    right = 2 * ratio / (1 + ratio)
    left = 2 - right
    corner = turns * np.pi / 2 * wheel_distance / 2  # how far each wheel is told to roll
    wheels = np.array([[side, side], [-corner, corner]] * 4)
    pose = np.zeros(3)
    for told_left, told_right in wheels:
        v = (left * told_left + right * told_right) / 2
        omega = (right * told_right - left * told_left) / true_distance
        pose = motion.arc_step(pose, v, omega, 1.0)
    return pose[:2]


def test_umbmark_signs_by_hand():
    # A robot that turns 1° too little at each corner of a 4 m square (b larger than believed)
    # ends 2·4·(π/180) = 0.14 m short of the start along x either way round, and above (cw) or
    # below it along y by as much; one that swings left, up x on the one, down on the other.
    bigger = 0.3 * 90 / 89
    for turns in (-1, 1):
        x, y = square_run(bigger, 1.0, 4.0, 0.3, turns)
        assert_close([x, turns * y], [-0.1396, 0.1396], atol=0.01)  # second order: 4·4·0.0175²
        x, y = square_run(0.3, 1.001, 4.0, 0.3, turns)  # 4 m·0.001/0.3 m = 0.0133 rad a side
        assert_close([turns * x, y], [0.1067, -0.1067], atol=0.01)
    # Borenstein & Feng: E_b = 90/(90 - α); R = (L/2)/sin(β/2), E_d = (R + b/2)/(R - b/2)
    alpha, beta = np.radians(1.0), np.radians(0.5)
    cw, ccw = -2 * 4 * (alpha + beta), -2 * 4 * (alpha - beta)
    distance, ratio = umbmark([[cw, cw]], [[ccw, -ccw]], 4.0, 0.3)
    assert_close(distance, 0.3 * 90 / 89, atol=4 * EPS)
    radius = 2.0 / np.sin(beta / 2)
    assert_close(ratio, (radius + distance / 2) / (radius - distance / 2), atol=4 * EPS)


def test_the_ellipse_of_a_robot_that_is_unsure_of_its_heading():
    # variances 0.04 and 0.01 m² along the axes: 20 cm and 10 cm; with the third row not looked at
    axes, directions = ellipse(np.diag([0.04, 0.01, 7.0]))
    assert_close(axes, np.array([0.2, 0.1]), atol=EPS)
    np.testing.assert_array_equal(directions, np.eye(2))
    axes, directions = ellipse(np.diag([0.01, 0.04]))  # the longer one first, along y
    assert_close(axes, np.array([0.2, 0.1]), atol=EPS)
    assert_close(directions, np.array([[0, -1], [1, 0]]), atol=EPS)


# Singular and boundary cases


def test_no_error_at_all_needs_no_correction():
    distance, ratio = umbmark([[0.0, 0.0]], [[0.0, 0.0]], 4.0, 0.3)
    assert (distance, ratio) == (0.3, 1.0)
    distance, ratio = umbmark([[0.1, -0.1]] * 2, [[-0.2, -0.2]] * 3, 4.0, 0.3)
    assert_close([distance, ratio], [0.3, 1.0], atol=2 * EPS)  # neither kind of error does this


def test_runs_of_umbmark_are_averaged_and_their_numbers_may_differ():
    one = umbmark([[-0.2, -0.1]], [[-0.15, 0.1]], 4.0, 0.3)
    many = umbmark([[-0.1, -0.3], [-0.3, 0.1]], [[-0.1, 0.0], [-0.3, 0.1], [-0.05, 0.2]], 4.0, 0.3)
    assert_close(many, one, atol=4 * EPS)


def test_a_counter_of_one_bit_and_of_the_most_bits():
    np.testing.assert_array_equal(unwrap_counter([0, 1, 0, 0], 1), [-1, -1, 0])
    top = 2**52
    np.testing.assert_array_equal(unwrap_counter([0, top - 1, 0], 52), [-1, 1])
    np.testing.assert_array_equal(
        unwrap_counter([0, top // 2 - 1, 0], 52), [top // 2 - 1, 1 - top // 2]
    )


@pytest.mark.parametrize("bits", [1, 8, 16, 31, 52])
def test_half_way_round_counts_backwards(bits):
    half = 2.0 ** (bits - 1)
    np.testing.assert_array_equal(unwrap_counter([0, half, 0], bits), [-half, -half])
    np.testing.assert_array_equal(unwrap_counter([0, half - 1], bits), [half - 1])
    # from the least signed count to the largest unsigned one: three halves less one, or so ahead
    steps = unwrap_counter([-half, 2 * half - 1, -half], bits)
    np.testing.assert_array_equal(steps, [half - 1, 1 - half])


def test_straight_on_and_on_the_spot():
    np.testing.assert_array_equal(
        path([5, 5], [5, 5], 10, 0.5 / np.pi, 0.3)[:, 1:], np.zeros((3, 2))
    )
    assert_close(path([5, 5], [5, 5], 10, 0.5 / np.pi, 0.3)[:, 0], [0, 0.5, 1.0], atol=2 * EPS)
    along = path([-5, 9], [5, -9], *ROBOT, [1, 2, 0.3])
    np.testing.assert_array_equal(along[:, :2], [[1, 2]] * 3)
    np.testing.assert_array_equal(path([0, 0], [0, 0], *ROBOT, [1, 2, 3]), [[1, 2, 3]] * 3)


def test_no_steps_and_single_readings():
    np.testing.assert_array_equal(path([], [], *ROBOT, [1, 2, 3]), [[1, 2, 3]])
    start = np.diag([1.0, 2.0, 3.0])
    np.testing.assert_array_equal(covariance([], [], *ROBOT, 0.01, start=start), [start])
    assert path(5, 6, *ROBOT).shape == (2, 3)
    assert covariance(5, 6, *ROBOT, 0.01).shape == (2, 3, 3)
    assert unwrap_counter([5], 8).shape == unwrap_counter([], 8).shape == (0,)


def test_ellipses_that_are_a_circle_a_line_or_a_point():
    np.testing.assert_array_equal(ellipse(4 * np.eye(2))[0], [2, 2])
    np.testing.assert_array_equal(ellipse(np.zeros((2, 2)))[0], [0, 0])
    for angle in np.linspace(-1.5, 1.5, 50):
        c, s = np.cos(angle), np.sin(angle)
        axes, directions = ellipse([[c * c, c * s], [c * s, s * s]])
        assert axes[0] == pytest.approx(1.0, rel=4 * EPS)
        assert axes[1] <= np.sqrt(2 * EPS)  # a determinant of a rounding
        assert_close(directions[:, 0], np.array([c, s]), atol=8 * EPS)
    refused = np.diag([1, -1]), np.diag([-1, -1]), np.diag([0, -1]), [[1, 2], [2, 1]]
    for no_covariance in (*refused, [[0.05, 0.03], [0.9, 0.05]]):
        axes, directions = ellipse(no_covariance)
        assert np.isnan(axes).all()
        assert np.isnan(directions).all()


def test_a_line_much_longer_than_wide_is_no_error():
    """The rounding of its determinant is one of the large variance, not of the small one."""
    for angle in np.geomspace(1e-9, 1e-1, 200):
        c, s = np.cos(angle), np.sin(angle)
        axes, _ = ellipse([[c * c, c * s], [c * s, s * s * (1 - 1e-11)]])
        assert axes[0] == pytest.approx(1.0)
        assert axes[1] < 1e-5


# Errors


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: unwrap_counter([1, 256], 8), r"counts must be from .*, got 256.0 at index 1"),
        (lambda: unwrap_counter([[1], [-129]], 8), r"counts must be .* -129.0 at index 1, 0"),
        (lambda: unwrap_counter([1, 2], [8, 1]), "counts must be .* got 2.0 at index 1, 1"),
        (lambda: unwrap_counter([0, 4000], modulus=4000), "counts must be .* 4000.0 at index 1"),
        (lambda: unwrap_counter([1, 2]), "either bits or modulus"),
        (lambda: unwrap_counter([1, 2], 8, 256), "either bits or modulus"),
        (lambda: travel(np.diff(np.uint16([5, 3])), 500, 0.05), "unsigned differences wrap round"),
        (lambda: travel(list(np.diff(np.uint16([5, 3]))), 500, 0.05), "unsigned differences wrap"),
        (lambda: path(np.uint8([3, 254]), 1, *ROBOT), "ticks_left must be .* 254.0 at index 1"),
        (lambda: umbmark(np.ones((0, 2)), [[1, 2]], 4, 0.3), r"ends_cw .* got \(0, 2\)"),
        # ends in cm; a side in m typed as one in dm; a wheel distance in mm
        (lambda: umbmark([[-12, -13]], [[-12, 13]], 4, 0.3), r"bent by 1\.56 rad, allowed 0\.25"),
        (lambda: umbmark([ENDS, [[9, 9]]], [ENDS] * 2, 4, 0.3), "at index 1 mean that a corner"),
        (lambda: umbmark(ENDS, [[0.2, -0.2]], 0.1, 0.3), "in m, and start from a wheel_distance"),
        (lambda: umbmark([[-0.2, 0.1]], [[0.2, 0.2]], 4, 3000), "in m, and start"),
    ],
)
def test_what_is_refused(call, message):
    with pytest.raises(RobokinError, match=message):
        call()


# Independent oracles


def test_the_heading_after_200000_steps_is_that_of_the_whole_numbers():
    rng = np.random.default_rng(7)
    for _ in range(5):
        per_turn, radius, distance = (
            rng.integers(100, 5000),
            rng.uniform(0.01, 0.2),
            rng.random() + 0.1,
        )
        left, right = rng.integers(-50, 100, (2, 200_000))
        heading = path(left, right, per_turn, radius, distance)[:, 2]
        total = np.cumsum(right - left)
        with mpmath.workdps(50):
            tick = 2 * mpmath.pi * mpmath.mpf(radius) / (int(per_turn) * mpmath.mpf(distance))
            for k in [199_999, *rng.integers(0, 200_000, 200)]:
                ulps = (mpmath.mpf(heading[k + 1]) - tick * int(total[k])) / np.spacing(
                    heading[k + 1]
                )
                assert abs(ulps) <= 4  # issue: 4 ulp of the exact sum


def test_a_path_with_fifty_digits():
    rng = np.random.default_rng(8)
    left, right = rng.integers(-50, 100, (2, 300))
    pose = [0.5, -0.25, 0.75]
    along = path(left, right, 512, 0.0625, 0.375, pose)
    with mpmath.workdps(50):
        x, y, theta = map(mpmath.mpf, pose)
        for k in range(300):
            a, b = (2 * mpmath.pi * int(n) / 512 / 16 for n in (left[k], right[k]))
            turn = (b - a) / mpmath.mpf("0.375")
            chord = (a + b) / 2 * mpmath.sinc(turn / 2)
            x += chord * mpmath.cos(theta + turn / 2)
            y += chord * mpmath.sin(theta + turn / 2)
            theta += turn
            # 7 m in 300 steps, coordinates and headings of a few units: a few EPS each
            assert_close(along[k + 1], [float(x), float(y), float(theta)], atol=30 * EPS)


def wheel_step(pose, left, right, distance):
    return motion.arc_step(pose, (left + right) / 2, (right - left) / distance, 1.0)


def step_jacobians(pose, left, right, distance):
    """Of `wheel_step` in the pose, and in the two wheels' travel, by central differences."""

    def around(function, h=1e-5):
        return (function(h) - function(-h)) / (2 * h)

    F = [around(lambda e, n=n: wheel_step(pose + e * n, left, right, distance)) for n in np.eye(3)]
    G = [
        around(lambda e: wheel_step(pose, left + e, right, distance)),
        around(lambda e: wheel_step(pose, left, right + e, distance)),
    ]
    return np.transpose(F), np.transpose(G)


@pytest.mark.parametrize("scale", [1, 10, 100, 1000])
def test_the_covariance_step_by_step_with_finite_differences(scale):
    # the textbook's recursion, its two Jacobians by central differences of the arc; the last
    # scale turns the robot by many radians a step
    rng = np.random.default_rng(scale)
    left, right = scale * rng.integers(-5, 10, (2, 12))
    left[3], right[3] = 2 * scale, 2 * scale  # a straight step
    left[4], right[4] = 3 * scale, -3 * scale  # on the spot
    left[5] = 0
    pose, sigma = np.array([1.0, 2.0, 0.7]), np.diag([0.01, 0.02, 0.03]) + 0.005
    result = covariance(left, right, *ROBOT, 0.02, pose, sigma)
    for k, (a, b) in enumerate(np.transpose(moved((left, right), ROBOT))):
        F, G = step_jacobians(pose, a, b, ROBOT[2])
        sigma = F @ sigma @ F.T + G @ np.diag([0.02 * abs(a), 0.02 * abs(b)]) @ G.T
        pose = wheel_step(pose, a, b, ROBOT[2])
        # differences: rounding of 1e-15/h and h² times third derivatives, (1/b)³ = 40 at most
        assert_close(result[k + 1], sigma, atol=1e-7 * np.abs(sigma).max())


def arc_end(left, right, distance):
    """Where a robot comes to in one step from the origin, with mpmath."""
    turn = (right - left) / distance
    chord = (left + right) / 2 * mpmath.sinc(turn / 2)
    return [chord * mpmath.cos(turn / 2), chord * mpmath.sin(turn / 2), turn]


# 326 ticks of difference are a radian. The slope of the chord has two formulas, which meet at 65
# of them; a long and hardly bent step is where digits would be lost.
BENT = [(0, n) for n in (1, -1, 9, 60, 64, 65, 66, 67, -65, -66, 100, 300, -3000)]
BENT += [
    (-5, 5),
    (10**6, 10**6 + 1),
    (10**6, 10**6),
    (-(10**6), -(10**6) + 30),
    (10**5, 10**5 - 66),
]


@pytest.mark.parametrize(("left", "right"), BENT)
def test_the_covariance_of_one_step_with_fifty_digits(left, right):
    sigma = covariance(left, right, 1024, 0.0625, 0.125, 1.0)[1]
    with mpmath.workdps(50):
        a, b = (2 * mpmath.pi / 16 * n / 1024 for n in (left, right))
        by_left = [mpmath.diff(lambda d, i=i: arc_end(d, b, 0.125)[i], a) for i in range(3)]
        by_right = [mpmath.diff(lambda d, i=i: arc_end(a, d, 0.125)[i], b) for i in range(3)]
        wanted = [
            [float(abs(a) * p * q + abs(b) * r * s) for p, r in zip(by_left, by_right, strict=True)]
            for q, s in zip(by_left, by_right, strict=True)
        ]
    # a dozen roundings, and the lever to the step's end taken off and put on again
    size = np.sqrt(np.outer(np.diag(wanted), np.diag(wanted)))
    assert (np.abs(sigma - wanted) <= 100 * EPS * size).all()


@pytest.mark.parametrize("base_error", [-0.02, -0.005, 0.0, 0.01, 0.03])
@pytest.mark.parametrize("ratio", [0.998, 1.0, 1.0005, 1.003])
def test_umbmark_recovers_planted_errors(base_error, ratio):
    side, believed = 4.0, 0.34
    true = believed * (1 + base_error)

    def calibrate(side_distance):
        cw = square_run(true, ratio, side, side_distance, -1)
        ccw = square_run(true, ratio, side, side_distance, 1)
        return umbmark([cw], [ccw], side, side_distance)

    distance, found = calibrate(believed)
    # first order: the errors α and β (rad a corner, a side) come out to within a few products
    alpha, beta = np.pi / 2 * base_error, side * (ratio - 1) / true
    second = 8 * (abs(alpha) + abs(beta)) ** 2
    assert_close(distance, true, atol=second * true + 4 * EPS)
    assert_close(found, ratio, atol=second * true / side + 4 * EPS)
