"""robokin.motion: frames of a moving robot, the exact arc, paths, the centre of rotation."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given
from support import (
    EPS,
    METHODS,
    NEAR_ZERO,
    assert_angles,
    assert_close,
    on_circle,
    poses,
    reals,
    twists,
)

from robokin.motion import (
    arc_step,
    icr,
    move,
    path,
    to_body,
    to_world,
    wrap_angle,
)

speeds = reals(-3, 3)
rates = reals(-3, 3)
times = reals(-2, 2)
drives = st.lists(st.tuples(speeds, rates, reals(0, 2)), min_size=1, max_size=8).map(np.transpose)

# Poses reach 10 m and 2π rad, a step 6 m and 6 rad, so a coordinate stays below 32 and one
# rounding of it costs at most 16 EPS = 3.6e-15; a law passes through a dozen roundings.
ATOL = 5e-14


def seen_from(pose, other):
    """The pose `other`, given in the frame of `pose`, in the world: se2(pose) @ se2(other)."""
    c, s = np.cos(pose[2]), np.sin(pose[2])
    x, y, theta = np.moveaxis(np.asarray(other), -1, 0)
    return np.stack([pose[0] + c * x - s * y, pose[1] + s * x + c * y, pose[2] + theta], axis=-1)


# Laws


@given(reals(-1e6, 1e6))
def test_wrap_angle_keeps_the_direction_and_lands_in_range(angle):
    wrapped = wrap_angle(angle)
    assert -np.pi < wrapped <= np.pi
    # 2π is 3.9e-17 of itself off as a float and the product rounds once: an EPS of the angle
    assert_angles(wrapped, angle % (2 * np.pi), atol=EPS * (abs(angle) + 2 * np.pi))


@given(reals(-np.pi, np.pi).filter(lambda a: a > -np.pi))
def test_wrap_angle_leaves_an_angle_in_range_alone(angle):
    assert wrap_angle(angle) == angle  # digit for digit


@given(poses, twists, times, times)
def test_two_moves_with_one_twist_are_one_longer_move(pose, twist, dt1, dt2):
    assert_close(move(move(pose, twist, dt1), twist, dt2), move(pose, twist, dt1 + dt2), atol=ATOL)


@given(poses, twists, times)
def test_a_move_is_the_same_wherever_it_starts(pose, twist, dt):
    assert_close(move(pose, twist, dt), seen_from(pose, move([0, 0, 0], twist, dt)), atol=ATOL)


@given(poses, speeds, rates, times)
def test_an_arc_is_a_move_without_sideways_speed(pose, v, omega, dt):
    assert_close(arc_step(pose, v, omega, dt), move(pose, [v, 0, omega], dt), atol=ATOL)


@given(poses, speeds, rates.filter(lambda w: abs(w) > 1e-3))
def test_the_robot_turns_about_the_centre_of_rotation(pose, v, omega):
    x_dot, y_dot, _ = to_world(pose[2], [v, 0, omega])
    to_centre = icr(pose, v, omega) - pose[:2]
    # velocity = omega × (pose - icr); the centre may be 3000 m away, so relative to v
    assert_close([omega * to_centre[1], -omega * to_centre[0]], [x_dot, y_dot], atol=ATOL)


@given(poses, drives)
def test_an_exact_path_is_one_arc_after_the_other(pose, drive):
    poses_along = path(pose, *drive)
    assert poses_along.shape == (drive.shape[1] + 1, 3)
    np.testing.assert_array_equal(poses_along[0], pose)
    for k, (v, omega, dt) in enumerate(drive.T):
        # up to 8 steps: coordinates up to 64, headings up to 60
        assert_close(poses_along[k + 1], arc_step(poses_along[k], v, omega, dt), atol=4 * ATOL)


@given(poses, drives, st.sampled_from(METHODS))
def test_straight_on_all_methods_agree(pose, drive, method):
    v, _, dt = drive
    assert_close(path(pose, v, 0.0, dt, method), path(pose, v, 0.0, dt), atol=0)


@given(poses, drives)
def test_the_old_heading_forwards_is_the_new_heading_backwards(pose, drive):
    v, omega, dt = drive
    there = path(pose, v, omega, dt, "start")
    back = path(there[-1], v[::-1], omega[::-1], -dt[::-1], "end")
    assert_close(back[::-1], there, atol=4 * ATOL)


# The numbers of the hand solution


def test_exercise_4_in_the_world():
    # Exercise 4: heading 90°, v = 0.075 m/s, omega = 0.5 rad/s: [0, 0.075, 0.5] in the world,
    # the centre of rotation 0.15 m to the left, which at this heading is along -x.
    assert_close(to_world(np.pi / 2, [0.075, 0, 0.5]), [0, 0.075, 0.5], atol=EPS)
    assert_close(to_body(np.pi / 2, [0, 0.075, 0.5]), [0.075, 0, 0.5], atol=EPS)
    assert_close(icr([0, 0, np.pi / 2], 0.075, 0.5), [-0.15, 0], atol=EPS)
    assert_close(icr([2, 1, np.pi / 2], 0.075, -0.5), [2.15, 1], atol=2 * EPS)


def test_a_quarter_circle_of_radius_one():
    # to the left from the origin: [1, 1, 90°]; to the right [1, -1, -90°]; backwards [-1, 1, -90°]
    quarter = np.pi / 2
    assert_close(arc_step([0, 0, 0], quarter, quarter, 1), [1, 1, quarter], atol=2 * EPS)
    assert_close(arc_step([0, 0, 0], quarter, -quarter, 1), [1, -1, -quarter], atol=2 * EPS)
    assert_close(arc_step([0, 0, 0], -quarter, -quarter, 1), [-1, 1, quarter * -1], atol=2 * EPS)
    assert_close(arc_step([0, 0, 0], 1, 1, quarter), [1, 1, quarter], atol=2 * EPS)


def test_exercise_5_the_exact_step_as_written_there():
    # x' = x + R (sin(θ + ω δt) - sin θ), y' = y - R (cos(θ + ω δt) - cos θ), with easy angles:
    # θ = 30°, ω δt = 60°, R = 2: [1 + 2 (1 - 1/2), 3 - 2 (0 - √3/2), 90°]
    step = arc_step([1, 3, np.pi / 6], v=2.0, omega=1.0, dt=np.pi / 3)
    assert_close(step, [2, 3 + np.sqrt(3), np.pi / 2], atol=8 * EPS)


def test_a_quarter_circle_sideways():
    # v_y alone, turning 90° in 1 s about a point 2/π behind: ends at [-2/π, 2/π]
    twist = [0, 1, np.pi / 2]
    assert_close(move([0, 0, 0], twist, 1), [-2 / np.pi, 2 / np.pi, np.pi / 2], atol=2 * EPS)
    # and driving 3 m forward, 4 m to the left without turning, from heading 90°
    assert_close(move([1, 1, np.pi / 2], [3, 4, 0], 1), [-3, 4, np.pi / 2], atol=4 * EPS)


@pytest.mark.parametrize(
    ("method", "end"),
    [
        ("start", [1, 0]),  # the old heading: straight ahead
        ("end", [0, 1]),  # the new one: straight to the left
        ("midpoint", [np.sqrt(0.5), np.sqrt(0.5)]),  # 45°, full length
        ("exact", [2 / np.pi, 2 / np.pi]),  # 45°, the chord
    ],
)
def test_one_step_of_a_quarter_turn_by_each_rule(method, end):
    poses_along = path([0, 0, 0], 1.0, np.pi / 2, 1.0, method)
    assert_close(poses_along, [[0, 0, 0], [*end, np.pi / 2]], atol=2 * EPS)


def test_angles_wrapped_by_hand():
    degrees = [190, -190, 360, 540, -540, 350, 179, -181, 0]
    wanted = [-170, 170, 0, 180, 180, -10, 179, 179, 0]
    # a degree is one rounding of up to 9.4 rad: 4 EPS, and the product with 2π another
    assert_close(wrap_angle(np.radians(degrees)), np.radians(wanted), atol=8 * EPS)


# Singular and boundary cases


@pytest.mark.parametrize("turns", [-3, -2, -1, 1, 2, 3])
def test_odd_multiples_of_pi_become_plus_pi(turns):
    assert_close(wrap_angle(2 * turns * np.pi), 0.0, atol=4 * EPS * abs(turns))
    assert_angles(wrap_angle((2 * turns + 1) * np.pi), np.pi, atol=16 * EPS)
    assert wrap_angle(np.pi) == wrap_angle(-np.pi) == np.pi


@pytest.mark.parametrize("gap", NEAR_ZERO)
def test_wrapping_next_to_a_half_turn(gap):
    for angle in (np.pi + gap, -np.pi + gap, 3 * np.pi + gap):
        wrapped = wrap_angle(angle)
        assert -np.pi < wrapped <= np.pi
        assert_angles(wrapped, angle, atol=8 * EPS)  # of up to 9.5 rad
        assert wrapped == angle or not -np.pi < angle <= np.pi


def test_wrapping_the_floats_next_to_a_half_turn_and_the_largest_ones():
    inside, outside = np.nextafter(np.pi, 0), np.nextafter(np.pi, 4)
    assert wrap_angle(inside) == inside
    assert wrap_angle(-inside) == -inside
    assert_angles(wrap_angle([outside, -outside]), [outside, -outside], atol=4 * EPS)
    huge = wrap_angle([1e15, -1e16, 1e300, -1.7e308])
    assert ((-np.pi < huge) & (huge <= np.pi)).all()


def test_far_round_an_odd_multiple_of_pi_stays_in_range():
    # rounded, 2001π may be some 1e-13 past it, and the remainder as far past ±π
    far = np.arange(-2001, 2002, 2) * np.pi
    wrapped = wrap_angle(far)
    assert ((-np.pi < wrapped) & (wrapped <= np.pi)).all()
    assert_angles(wrapped, np.full_like(far, np.pi), atol=2 * EPS * 2001 * np.pi)


def textbook_arc(pose, v, omega, dt):
    """x + v/ω (sin(θ + ω dt) - sin θ) and so on, with 50 digits, of which ω near 0 costs some."""
    x, y, theta, v, omega, dt = (mpmath.mpf(float(a)) for a in (*pose, v, omega, dt))
    if omega == 0:
        return x + v * dt * mpmath.cos(theta), y + v * dt * mpmath.sin(theta), theta
    end = theta + omega * dt
    return (
        x + v / omega * (mpmath.sin(end) - mpmath.sin(theta)),
        y - v / omega * (mpmath.cos(end) - mpmath.cos(theta)),
        end,
    )


def errors(actual, expected):
    """How far floats are from mpmath's numbers, row by row: the distance, and the angle."""
    d = np.array(
        [
            [float(mpmath.mpf(float(a)) - b) for a, b in zip(*row, strict=True)]
            for row in zip(actual, expected, strict=True)
        ]
    )
    return np.hypot(d[:, 0], d[:, 1]), np.abs(d[:, 2])


@pytest.mark.parametrize("omega", [0.0, *NEAR_ZERO, 1e-150, -2e-300, 5e-324])
def test_hardly_turning_keeps_all_digits(omega):
    thetas = np.linspace(-np.pi, np.pi, 17)
    pose = np.stack([0 * thetas, 0 * thetas, thetas], axis=-1)
    with mpmath.workdps(400):  # 1e-300 costs 300 digits
        expected = [textbook_arc(p, 1.0, omega, 1.0) for p in pose]
        distance, angle = errors(arc_step(pose, 1.0, omega, 1.0), expected)
    assert distance.max() <= 4e-16  # issue: 4e-16 m for each metre driven
    assert angle.max() <= 2 * EPS  # one rounding of a heading up to π


@pytest.mark.parametrize("omega", [0.0, 1e-16, -1e-9, 1e-4])
def test_hardly_turning_sideways_keeps_all_digits(omega):
    # 3 m ahead and 4 m to the left: a 3-4-5 triangle bent by less than omega/2 at its end
    x, y, theta = move([0, 0, 0], [3, 4, omega], 1.0)
    assert_close([x, y, theta], [3 - 2 * omega, 4 + 1.5 * omega, omega], atol=omega**2 + 8 * EPS)


@pytest.mark.parametrize("turns", [1, -1, 2, 3])
def test_whole_circles_end_where_they_began(turns):
    end = arc_step([1, 2, 0.3], 5.0, 2 * np.pi * turns, 1.0)
    # sin(π turns) is 1.2e-16 turns as a float, times the radius; positions up to 2 round by EPS
    assert_close(end, [1, 2, 0.3 + 2 * np.pi * turns], atol=4 * EPS * abs(turns) + 4 * EPS)


@pytest.mark.parametrize("omega", [np.pi, -np.pi])
def test_half_a_circle_is_one_diameter_sideways(omega):
    end = arc_step([0, 0, 0], 1.0, omega, 1.0)
    assert_close(end, [0, 2 / omega, omega], atol=EPS)


def test_turning_on_the_spot_and_standing_still_move_nothing():
    pose = [0.1, 0.2, 0.3]
    np.testing.assert_array_equal(arc_step(pose, 0.0, 2.0, 1.0), [0.1, 0.2, 2.3])
    np.testing.assert_array_equal(arc_step(pose, 3.0, 2.0, 0.0), pose)
    np.testing.assert_array_equal(arc_step(pose, 0.0, 0.0, 1.0), pose)
    np.testing.assert_array_equal(move(pose, [0, 0, 2.0], 1.0), [0.1, 0.2, 2.3])
    np.testing.assert_array_equal(path(pose, 0.0, [0.5, 0.5], 1.0)[-1], [0.1, 0.2, 1.3])


def test_a_large_heading_loses_nothing_more_than_the_heading_itself_has():
    # the sum of heading and half turn is rounded to 1e-10 here; the step must not feel it
    with mpmath.workdps(50):
        pose = [0.0, 0.0, 1e6 + 0.1]
        distance, _ = errors([arc_step(pose, 1.0, 0.7, 1.0)], [textbook_arc(pose, 1.0, 0.7, 1.0)])
        assert distance[0] <= 4e-16
        for a, b in zip(
            move(pose, [1.0, 0, 0.7], 1.0)[:2], textbook_arc(pose, 1.0, 0.7, 1.0), strict=False
        ):
            assert abs(a - b) <= 4e-16


def test_headings_along_a_path_are_not_wrapped():
    headings = path([0, 0, 3.0], 1.0, np.full(10, 1.0), 1.0)[:, 2]
    assert_close(headings, 3.0 + np.arange(11), atol=0)  # whole numbers: exact


def test_a_path_of_no_steps_is_its_start():
    np.testing.assert_array_equal(path([1, 2, 3], [], [], 0.1), [[1, 2, 3]])
    np.testing.assert_array_equal(path([1, 2, 3], [], 1.0, 0.1, "end"), [[1, 2, 3]])
    assert path(np.zeros((4, 3)), np.empty((4, 0)), 1.0, 0.1).shape == (4, 1, 3)
    assert path(np.zeros((0, 3)), np.ones(5), 1.0, 0.1).shape == (0, 6, 3)


def test_single_numbers_are_a_path_of_one_step():
    assert path([0, 0, 0], 1, 0, 1).shape == (2, 3)
    assert path(np.zeros((4, 3)), 1, 0, 1).shape == (4, 2, 3)
    assert path([0, 0, 0], 1, 0, [1, 1, 1]).shape == (4, 3)


@pytest.mark.parametrize("v", [1.0, -1.0])
@pytest.mark.parametrize("omega", [0.0, -0.0])
def test_a_straight_line_has_its_centre_at_infinity(v, omega):
    np.testing.assert_array_equal(icr([1, 2, 0.3], v, omega), [np.inf, np.inf])


def test_standing_still_every_point_is_a_centre():
    np.testing.assert_array_equal(icr([1, 2, 0.3], 0.0, 0.0), [np.nan, np.nan])


def test_on_the_spot_the_robot_is_its_own_centre():
    np.testing.assert_array_equal(icr([1, 2, 0.3], 0.0, [1e-16, -3.0]), [[1, 2], [1, 2]])


@pytest.mark.parametrize("omega", NEAR_ZERO)
def test_near_a_straight_line_the_centre_is_far_to_the_side(omega):
    x, y = icr([0, 0, np.pi / 4], 1.0, omega)
    # rounding of π/4, its sine and cosine and the quotient: four times half an EPS
    np.testing.assert_allclose([-x, y], np.sqrt(0.5) / omega, rtol=2 * EPS)


def test_one_straight_line_in_a_batch_leaves_the_others_alone():
    centres = icr([0, 0, 0], [1, 1, 0, 1], [2, 0, 0, 4])
    np.testing.assert_array_equal(centres, [[0, 0.5], [np.inf, np.inf], [np.nan] * 2, [0, 0.25]])


@pytest.mark.parametrize("quarter", range(-8, 9))
def test_round_headings(quarter):
    theta = quarter * np.pi / 2
    ahead = [[1, 0], [0, 1], [-1, 0], [0, -1]][quarter % 4]
    # the float nearest to a multiple of π/2 up to 4π is off by up to 5e-16
    assert_close(to_world(theta, [1, 0, 0])[:2], ahead, atol=4 * EPS)
    assert_close(arc_step([0, 0, theta], 1, 0, 1)[:2], ahead, atol=4 * EPS)


# Independent oracles


def test_the_arc_against_fifty_digits():
    rng = np.random.default_rng(0)
    n = 3000
    theta = rng.uniform(-np.pi, np.pi, n)
    omega = np.concatenate(
        [10 ** rng.uniform(-16, np.log10(2 * np.pi), n // 3), rng.uniform(0, 2 * np.pi, 2 * n // 3)]
    )
    # on purpose: the heading close to ±π and turning further out, where the sum rounds most
    theta[-n // 3 :] = rng.uniform(np.pi - 0.6, np.pi, n // 3)
    omega[-n // 3 :] = rng.uniform(1.7, 2.4, n // 3)
    sign = rng.choice([-1, 1], n)
    theta, omega = sign * theta, np.where(rng.random(n) < 0.3, -1, 1) * sign * omega
    v = rng.uniform(-2, 2, n)
    pose = np.stack([0 * theta, 0 * theta, theta], axis=-1)
    with mpmath.workdps(50):
        expected = [textbook_arc(*arguments, 1.0) for arguments in zip(pose, v, omega, strict=True)]
        distance, angle = errors(arc_step(pose, v, omega, 1.0), expected)
        sideways, _ = errors(move(pose, np.stack([v, 0 * v, omega], -1), 1.0), expected)
    # The bound that the library promises, per metre driven: three roundings in the chord and two
    # in each of its components. 12 million samples against 80-bit arithmetic reached 3.9e-16.
    assert (distance / np.abs(v)).max() <= 4e-16
    assert (sideways / np.abs(v)).max() <= 5e-16  # two more products
    assert angle.max() <= 4 * EPS  # one rounding of a heading up to 3π


def test_move_against_scipy_s_matrix_exponential():
    rng = np.random.default_rng(1)
    pose, twist = rng.uniform(-3, 3, (50, 3)), rng.uniform(-3, 3, (50, 3))
    dt = rng.uniform(-2, 2, 50)
    end = move(pose, twist, dt)
    for k in range(50):
        v_x, v_y, omega = twist[k] * dt[k]
        step = scipy.linalg.expm(np.array([[0, -omega, v_x], [omega, 0, v_y], [0, 0, 0]]))
        c, s = np.cos(pose[k, 2]), np.sin(pose[k, 2])
        start = np.array([[c, -s, pose[k, 0]], [s, c, pose[k, 1]], [0, 0, 1]])
        wanted = start @ step
        # expm squares and multiplies matrices with entries up to 9: about 1e-14
        assert_close(end[k, :2], wanted[:2, 2], atol=1e-13)
        assert_angles(end[k, 2], np.arctan2(wanted[1, 0], wanted[0, 0]), atol=1e-13)


def test_twists_against_complex_numbers():
    rng = np.random.default_rng(2)
    theta, twist = rng.uniform(-9, 9, 200), rng.uniform(-3, 3, (200, 3))
    velocity = twist[:, 0] + 1j * twist[:, 1]
    for function, turn in [(to_world, np.exp(1j * theta)), (to_body, np.exp(-1j * theta))]:
        seen = function(theta, twist)
        assert_close(seen[:, 0] + 1j * seen[:, 1], turn * velocity, atol=8 * EPS)  # speeds below 5


def test_wrapped_angles_against_fifty_digits():
    rng = np.random.default_rng(3)
    angle = np.concatenate([rng.uniform(-20, 20, 500), -(10 ** rng.uniform(1, 12, 500))])
    with mpmath.workdps(50):
        wanted = [float(mpmath.arg(mpmath.expj(mpmath.mpf(a)))) for a in angle.tolist()]
    # an EPS of the angle that came in, one of the angle that goes out
    assert (on_circle(wrap_angle(angle) - wanted) <= EPS * (np.abs(angle) + 2 * np.pi)).all()


def test_every_rule_of_a_path_against_a_loop():
    rng = np.random.default_rng(5)
    v, omega, dt = rng.normal(size=40), rng.normal(size=40), rng.uniform(0.05, 0.2, 40)
    for method in METHODS:
        z, theta = 1 + 2j, 0.3
        wanted = [[1, 2, 0.3]]
        for k in range(40):
            turn, length = omega[k] * dt[k], v[k] * dt[k]
            rule = {
                "start": np.exp(1j * theta),
                "end": np.exp(1j * (theta + turn)),
                "midpoint": np.exp(1j * (theta + turn / 2)),
                "exact": np.exp(1j * theta) * (np.exp(1j * turn) - 1) / (1j * turn),
            }
            z, theta = z + length * rule[method], theta + turn
            wanted.append([z.real, z.imag, theta])
        # 40 roundings of numbers below 8, and the loop's own quotient at small turns
        assert_close(path([1, 2, 0.3], v, omega, dt, method), wanted, atol=1e-13)
