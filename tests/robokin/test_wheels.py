"""robokin.wheels: constraints of every kind of wheel, forward and inverse motion, mobility."""

from dataclasses import FrozenInstanceError

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import assume, given
from support import EPS, NEAR_ZERO, angles, assert_close, reals, twists, vectors

from robokin import bicycle, differential_drive, motion
from robokin.errors import RobokinError, SingularError, UnreachableError
from robokin.wheels import (
    Mobility,
    Wheel,
    castor,
    fixed,
    forward,
    inverse,
    mobility,
    omni_robot,
    rolling,
    rolling_rates,
    sliding,
    slip,
    spherical,
    steered,
    swedish,
)

NAN = np.nan
QUARTER = np.pi / 2

# The robots of the chapter, x ahead and y to the left. A wheel on the y axis, rolling ahead, has
# its axle along the spoke: left α = 90°, β = 0; the right one is turned round: α = -90°, β = 180°.
DIFFERENTIAL = [fixed(0.1, QUARTER, 0, 0.03), fixed(0.1, -QUARTER, np.pi, 0.03)]
OMNI = omni_robot(0.2, 0.05)


def spoke_to(x, y, ahead=0.0):
    """l, α and β of a wheel at (x, y) that rolls in the direction `ahead` of the robot."""
    return np.hypot(x, y), np.arctan2(y, x), QUARTER + ahead - np.arctan2(y, x)


CAR = [fixed(*spoke_to(0, 0.75), 0.3), fixed(*spoke_to(0, -0.75), 0.3)]
CAR += [steered(*spoke_to(2.5, 0.75), 0.3), steered(*spoke_to(2.5, -0.75), 0.3)]
BICYCLE = [fixed(*spoke_to(0, 0), 0.3), steered(*spoke_to(1.2, 0), 0.3)]
MECANUM = [
    swedish(*spoke_to(x, y), 0.05, gamma)
    for x, y, gamma in [
        (0.2, 0.15, -np.pi / 4),
        (0.2, -0.15, np.pi / 4),
        (-0.2, 0.15, np.pi / 4),
        (-0.2, -0.15, -np.pi / 4),
    ]
]
TWO_STEERED = [
    steered(*spoke_to(0.4, 0), 0.1),
    steered(*spoke_to(-0.4, 0), 0.1),
    castor(*spoke_to(0, 0.3), 0.05, -0.03),
]

lengths = reals(0.05, 2)
gammas = reals(-1.4, 1.4)


@st.composite
def wheels(draw, kinds=("fixed", "steered", "castor", "swedish", "spherical")):
    place = draw(lengths), draw(angles)
    kind, beta, radius = draw(st.sampled_from(kinds)), draw(angles), draw(lengths)
    return {
        "fixed": lambda: fixed(*place, beta, radius),
        "steered": lambda: steered(*place, beta, radius),
        "castor": lambda: castor(*place, beta, radius, draw(lengths)),
        "swedish": lambda: swedish(*place, beta, radius, draw(gammas)),
        "spherical": lambda: spherical(*place, radius),
    }[kind]()


def steered_of(robot):
    return [w for w in robot if w.kind == "steered"]


def turned(robot, steering):
    """The same robot with its steered wheels built at these angles."""
    betas = iter(steering)
    return [
        steered(w.l, w.alpha, next(betas), w.radius) if w.kind == "steered" else w for w in robot
    ]


robots = st.lists(wheels(), max_size=5)
# two wheels that hold and two steered ones, or swedish ones all over: enough for any motion
determined = st.sampled_from([DIFFERENTIAL, CAR, BICYCLE, MECANUM, TWO_STEERED, OMNI])


def driven(robot):
    return [w for w in robot if w.kind != "spherical"]


def held(robot):
    return [w for w in robot if w.kind in ("fixed", "steered")]


# Rows have entries up to 2 m, twists up to 3; sums of three products, each rounded a few times.
ATOL = 1e-13


# Laws


@given(robots, st.data())
def test_steering_is_the_beta_of_the_steered_wheels(robot, data):
    steering = data.draw(vectors(len(steered_of(robot)), -4, 4))
    rebuilt = turned(robot, steering)
    np.testing.assert_array_equal(rolling(robot, steering), rolling(rebuilt))
    np.testing.assert_array_equal(sliding(robot, steering), sliding(rebuilt))
    assert rolling(robot).shape == (len(driven(robot)), 3)
    assert sliding(robot).shape == (len(held(robot)), 3)
    assert rolling_rates(robot).shape == (len(driven(robot)),) * 2


@given(determined, twists, angles)
def test_forward_undoes_inverse_where_no_wheel_slips(robot, twist, theta):
    # a motion that the wheels allow: the nearest one to the twist, out of the sliding rows
    allowed = np.eye(3) - np.linalg.pinv(sliding(robot), rcond=1e-9) @ sliding(robot)
    body = allowed @ twist
    body[np.abs(body) < 1e-12] = 0  # what is left of a motion that is not allowed at all
    world = motion.to_world(theta, body)
    rates = inverse(robot, world, theta=theta)
    # the rates are speeds by a radius of 0.03 m or more; back again times the radius
    assert_close(forward(robot, rates, theta=theta), world, atol=10 * ATOL)
    assert_close(slip(robot, rates), np.zeros(len(rates) + len(held(robot))), atol=10 * ATOL)


@given(determined, st.data(), angles)
def test_the_heading_only_turns_the_answer(robot, data, theta):
    rates = data.draw(vectors(len(driven(robot)), -5, 5))
    wanted = motion.to_world(theta, forward(robot, rates))
    assert_close(forward(robot, rates, theta=theta), wanted, atol=0)


@given(robots, reals(-3, 3))
def test_turning_the_robots_frame_changes_no_mobility(robot, turn):
    other = [Wheel(w.kind, w.l, w.alpha + turn, w.beta, w.radius, w.d, w.gamma) for w in robot]
    assert mobility(other) == mobility(robot)


@given(robots, reals(0.01, 100))
def test_neither_size_nor_order_nor_free_wheels_change_the_mobility(robot, scale):
    other = [Wheel(w.kind, w.l * scale, w.alpha, w.beta, w.radius, w.d, w.gamma) for w in robot]
    assert mobility(other[::-1]) == mobility(robot)
    free = [
        castor(0.3, 1.0, 0.2, 0.05, 0.02),
        swedish(0.3, 1, 0.2, 0.05, 0.7),
        spherical(0.1, 0, 0.02),
    ]
    assert mobility(robot + free) == mobility(robot)


@given(robots)
def test_mobility_is_what_the_ranks_say(robot):
    fixed_rows = sliding([w for w in robot if w.kind == "fixed"])
    rank = np.linalg.matrix_rank(fixed_rows, tol=1e-9)
    count = len(steered_of(robot))
    # generic steered wheels, no two at one place: each axle adds a rank, up to 3
    assert mobility(robot).delta_s == max(0, min(count, 3, 2 - rank))
    assert mobility(robot).delta_m == 3 - rank - mobility(robot).delta_s
    assert mobility(robot).delta_M == 3 - rank
    assert all(type(delta) is int for delta in mobility(robot))


# The numbers of the hand solution


def test_exercise_6_the_omni_robot():
    s3 = np.sqrt(3)
    J1 = [[0, -1, -0.2], [s3 / 2, 1 / 2, -0.2], [-s3 / 2, 1 / 2, -0.2]]
    assert_close(rolling(OMNI), J1, atol=4 * EPS)  # 4π/3 is off by 4 EPS
    np.testing.assert_array_equal(rolling_rates(OMNI), np.diag([0.05] * 3))
    assert sliding(OMNI).shape == (0, 3)
    inverted = [[0, s3 / 3, -s3 / 3], [-2 / 3, 1 / 3, 1 / 3], [-1 / 3 / 0.2] * 3]
    columns = [forward(OMNI, rates) for rates in np.eye(3) / 0.05]
    assert_close(np.transpose(columns), inverted, atol=16 * EPS)
    # all rates positive: clockwise, 1 rad/s · 0.05/0.2; heading 90° turns the rest of the answer
    assert_close(forward(OMNI, [1, 1, 1]), [0, 0, -0.25], atol=EPS)
    assert_close(forward(OMNI, [0, 20, -20]), [2 / s3, 0, 0], atol=8 * EPS)
    assert_close(forward(OMNI, [0, 20, -20], theta=QUARTER), [0, 2 / s3, 0], atol=8 * EPS)
    assert_close(inverse(OMNI, [0, 1, 0]), [-20, 10, 10], atol=64 * EPS)
    assert_close(inverse(OMNI, [1, 0, 0], theta=-QUARTER), [-20, 10, 10], atol=64 * EPS)
    other = omni_robot(0.2, 0.05, angles=[0.0, 1.0])
    assert other == [swedish(0.2, 0, 0, 0.05, 0), swedish(0.2, 1, 0, 0.05, 0)]


def test_one_wheel_by_hand():
    # on the left of the robot, rolling ahead: v_x - l ω; sliding along y; radius 0.3
    np.testing.assert_allclose(rolling(CAR)[0], [1, 0, -0.75], atol=EPS)
    np.testing.assert_allclose(sliding(CAR)[0], [0, 1, 0], atol=EPS)
    # at 45° ahead left, l = √2, axle along the spoke: rolls to the right, along -45°
    wheel = fixed(np.sqrt(2), np.pi / 4, 0, 0.1)
    half = np.sqrt(0.5)
    assert_close(rolling([wheel]), [[half, -half, -np.sqrt(2)]], atol=2 * EPS)
    assert_close(sliding([wheel]), [[half, half, 0]], atol=2 * EPS)
    # its axle turned by +90°: rolls outwards, slides to its left, with the turning
    wheel = fixed(np.sqrt(2), np.pi / 4, QUARTER, 0.1)
    assert_close(rolling([wheel]), [[half, half, 0]], atol=4 * EPS)
    assert_close(sliding([wheel]), [[-half, half, np.sqrt(2)]], atol=4 * EPS)


def test_a_mecanum_robot():
    # rollers at 45°: r φ̇ = v_x ∓ v_y ∓ (0.2 + 0.15) ω, the textbook's rates of the four wheels
    v_x, v_y, omega = 0.5, 0.2, -0.4
    turn = 0.35 * omega
    speeds = [v_x - v_y - turn, v_x + v_y + turn, v_x + v_y - turn, v_x - v_y + turn]
    assert_close(inverse(MECANUM, [v_x, v_y, omega]), np.divide(speeds, 0.05), atol=64 * EPS)
    assert_close(forward(MECANUM, np.divide(speeds, 0.05)), [v_x, v_y, omega], atol=8 * EPS)
    assert_close(np.diag(rolling_rates(MECANUM)), np.full(4, 0.05 * np.sqrt(0.5)), atol=EPS)


def test_the_differential_drive_of_exercise_4():
    # 5/3 and 10/3 rad/s: 0.075 m/s ahead, 0.5 rad/s; b = 2·0.1 halves the turning rate to 0.25.
    # The right wheel is turned round (β = 180°), but rolls the same way: α + β - 90° = 0.
    assert_close(forward(DIFFERENTIAL, [5 / 3, 10 / 3]), [0.075, 0, 0.25], atol=4 * EPS)
    assert_close(inverse(DIFFERENTIAL, [0, 0.075, 0.25], theta=QUARTER), [5 / 3, 10 / 3], 32 * EPS)


ROUND = [fixed(0.3, a, 0, 0.1) for a in (0, 2, 4)]
STUCK = [fixed(0.3, a, 0.5 * a, 0.1) for a in (0, 2, 4)]
STANDARD = {
    "differential drive": (DIFFERENTIAL, (2, 0, 2)),
    "differential drive and castor": (
        [*DIFFERENTIAL, castor(*spoke_to(0.2, 0), 0.02, -0.02)],
        (2, 0, 2),
    ),
    "one fixed wheel": ([fixed(*spoke_to(0, 0), 0.1), spherical(0.1, 0, 0.02)], (2, 0, 2)),
    "bicycle": (BICYCLE, (1, 1, 2)),
    "car": (CAR, (1, 1, 2)),
    "two bicycles abreast": (CAR[:3], (1, 1, 2)),
    "omni robot": (OMNI, (3, 0, 3)),
    "mecanum": (MECANUM, (3, 0, 3)),
    "castors only": ([castor(*spoke_to(x, 0.1), 0.02, 0.02) for x in (-1, 0, 1)], (3, 0, 3)),
    "spherical wheels only": ([spherical(0.1, a, 0.02) for a in (0, 2, 4)], (3, 0, 3)),
    "one steered wheel and castors": (
        [steered(*spoke_to(0.3, 0), 0.1), castor(*spoke_to(-0.2, 0.2), 0.02, 0.02)],
        (2, 1, 3),
    ),
    "two steered wheels": (TWO_STEERED, (1, 2, 3)),
    "three steered wheels": ([*TWO_STEERED, steered(*spoke_to(0, 0.4), 0.1)], (1, 2, 3)),
    "four steered wheels": ([steered(0.4, a, 0, 0.1) for a in (0.7, 2.4, -0.7, -2.4)], (1, 2, 3)),
    "fixed wheels round a centre": (ROUND, (1, 0, 1)),
    "the same and a steered one": ([*ROUND, steered(0.5, 1, 0, 0.1)], (1, 0, 1)),
    "fixed wheels in each other's way": (STUCK, (0, 0, 0)),
    "the same and a steered one, stuck": ([*STUCK, steered(0.5, 1, 0, 0.1)], (0, 0, 0)),
    "two fixed axles, parallel": (
        [fixed(*spoke_to(0, 0), 0.1), fixed(*spoke_to(1, 0), 0.1)],
        (1, 0, 1),
    ),
    "tandem with a steered wheel": (
        [fixed(*spoke_to(0, 0), 0.1), fixed(*spoke_to(1, 0), 0.1), steered(*spoke_to(2, 0), 0.1)],
        (1, 0, 1),
    ),
    "a wheel at the centre of everything": (
        [fixed(0, 0, 0, 0.1), steered(0, 1, 0, 0.1)],
        (1, 1, 2),
    ),
    "no wheels": ([], (3, 0, 3)),
}


@pytest.mark.parametrize("robot", STANDARD)
def test_the_table_of_standard_robots(robot):
    wheel_list, wanted = STANDARD[robot]
    assert mobility(wheel_list) == wanted
    assert mobility(tuple(wheel_list)) == Mobility(*wanted)
    # far off its centre, and a thousand times smaller, it is the same robot
    tiny = [Wheel(w.kind, w.l / 1000, w.alpha, w.beta, w.radius, w.d, w.gamma) for w in wheel_list]
    assert mobility(tiny) == wanted


def test_front_wheels_steered_by_themselves_leave_no_motion():
    # the car at 30° both: three axles that do not meet; steered by Ackermann, one way is left
    def motions(left, right):
        rows = sliding(CAR, CAR_STRAIGHT + np.array([left, right]))
        return 3 - np.linalg.matrix_rank(rows, tol=1e-9)

    assert motions(0.5, 0.5) == 0
    assert motions(0.0, 0.0) == 1
    assert motions(*bicycle.ackermann(0.5, 2.5, 1.5)) == 1


CAR_STRAIGHT = np.array([w.beta for w in steered_of(CAR)])


# Singular and boundary cases


def test_robots_without_wheels_of_a_kind():
    assert rolling([]).shape == sliding([]).shape == (0, 3)
    assert rolling_rates([]).shape == (0, 0)
    assert forward(OMNI, [1, 1, 1], np.empty((5, 0))).shape == (5, 3)
    assert inverse([spherical(1, 1, 1)], [1, 2, 3]).shape == (0,)


@pytest.mark.parametrize(
    ("robot", "rank"),
    [
        ([], 0),
        ([spherical(0.1, 0, 0.1)] * 4, 0),
        ([fixed(*spoke_to(0.2, 0.1), 0.1)], 2),
        ([fixed(*spoke_to(0.2, 0.1), 0.1)] * 2, 2),
        ([fixed(0, 1, 2, 0.1), steered(0, 2, 3, 0.1)], 2),  # both at the centre
        (OMNI[:2], 2),
        ([swedish(0.2, a, QUARTER, 0.05, 0) for a in (0, 2, 4)], 2),  # rolling along the spokes
        ([castor(0.2, a, 0, 0.05, 0.02) for a in (0, np.pi)], 2),
        ([swedish(0.2, a, 0, 0.05, 0) for a in (1.0, 1.0, 1.0)], 1),
    ],
)
def test_wheels_that_do_not_determine_the_motion(robot, rank):
    rates = np.ones(len(driven(robot)))
    for call in (forward, slip):
        with pytest.raises(SingularError, match=f"determine {rank} of the 3 parts"):
            call(robot, rates)
        with pytest.raises(SingularError):  # at once, whatever is in the batch
            call(robot, np.full((3, len(rates)), NAN))


@pytest.mark.parametrize("gap", [g for g in NEAR_ZERO if abs(g) >= 1e-11])
def test_wheels_that_hardly_determine_the_motion(gap):
    # three wheels rolling all but along their spokes: turning shows as sin(gap) only
    robot = [swedish(0.2, a, QUARTER + gap, 0.05, 0) for a in (0, 2, 4)]
    twist = [0.3, -0.2, 0.1]
    rates = rolling(robot) @ twist / 0.05
    # cos(90° + gap) itself has lost EPS/gap of its digits
    assert_close(forward(robot, rates), twist, atol=8 * EPS / abs(gap))


@pytest.mark.parametrize("gap", [g for g in NEAR_ZERO if abs(g) < 1e-13])
def test_wheels_that_determine_the_motion_by_rounding_only(gap):
    robot = [swedish(0.2, a, QUARTER + gap, 0.05, 0) for a in (0, 2, 4)]
    with pytest.raises(SingularError):
        forward(robot, [1, 1, 1])


def test_the_size_of_the_robot_does_not_matter():
    for scale in (1e-6, 1.0, 1e6):
        robot = omni_robot(0.2 * scale, 0.05)
        assert_close(forward(robot, [1, 1, 1])[2] * scale, -0.25, atol=4 * EPS)


@pytest.mark.parametrize("scale", [1e-15, 1.0, 1e15])
def test_the_size_of_the_robot_does_not_matter_to_its_mobility(scale):
    skid = [fixed(*spoke_to(x * scale, y * scale), 0.3) for x in (0, 2.5) for y in (0.75, -0.75)]
    assert mobility([*skid, spherical(0, 0, 0.1)]) == (1, 0, 1)
    for alpha in (-2.4, -1, 0.5, 2):  # by 2.4 rad from one to the next `mobility` turns the wheels
        assert mobility([steered(scale, a, 0, 0.3) for a in (0, alpha)]) == (1, 2, 3)


@pytest.mark.parametrize("gap", NEAR_ZERO)
def test_a_little_slip(gap):
    # a car that also moves sideways, by `gap` of its speed
    twist = [2.0, 2.0 * gap, 0.0]
    if abs(gap) > 2e-6:
        with pytest.raises(UnreachableError, match=r"wheel 0 \(fixed\) would slip sideways at"):
            inverse(CAR, twist)
        assert np.isnan(inverse(CAR, twist, slipping="nan")).all()
    elif abs(gap) < 5e-7:
        assert_close(inverse(CAR, twist), np.full(4, 2.0 / 0.3), atol=16 * EPS)


def test_slip_is_relative_to_all_that_makes_up_a_wheels_speed():
    # steered so that the wheel at (1, 0) stands still in a turn about it: any speed there is slip,
    # but 1e-12 is what rounding may leave of 1 m/s and 1 rad/s · 1 m
    robot = [steered(*spoke_to(1, 0), 0.1), castor(*spoke_to(0, 0.5), 0.1, 0.1)]
    for twist in ([0.0, -1 + 1e-12, 1.0], [0.0, -1e-9 + 1e-21, 1e-9], [1.0, 1e-12, 0.0]):
        assert np.isfinite(inverse(robot, twist)).all()
    with pytest.raises(UnreachableError):
        inverse(robot, [0.0, -1 + 1e-5, 1.0])
    # only its own distance counts, 1e-6 of 1 + 1 m/s, not that of a wheel that rolls round, 5 m off
    robot.append(fixed(*spoke_to(5, 0, ahead=QUARTER), 0.1))
    assert np.isfinite(inverse(robot, [0.0, -1 + 1e-6, 1.0])).all()
    with pytest.raises(UnreachableError, match="wheel 0"):
        inverse(robot, [0.0, -1 + 4e-6, 1.0])
    np.testing.assert_array_equal(inverse(CAR, [0, 0, 0]), np.zeros(4))


def test_wheels_that_fight_each_other():
    # the two wheels of a differential drive on one side: rates 1 and 3 for the same place
    robot = [*DIFFERENTIAL, fixed(0.1, QUARTER, 0, 0.03)]
    rates = [1.0, 2.0, 3.0]
    # the two on the left agree on 2; each is 0.03 m/s from it; nothing slides
    assert_close(forward(robot, rates), [0.06, 0, 0], atol=4 * EPS)
    assert_close(slip(robot, rates), [0.03, 0, -0.03, 0, 0, 0], atol=4 * EPS)


def test_a_car_with_parallel_front_wheels_slips_sideways():
    # straight ahead at rate 1, but the front wheels steered by 0.2 both: they slide
    left_over = slip(CAR, [1, 1, 1, 1], CAR_STRAIGHT + 0.2)
    assert np.abs(left_over[4:]).max() > 0.005
    steering = CAR_STRAIGHT + bicycle.ackermann(0.2, 2.5, 1.5)
    rates = inverse(CAR, bicycle.body_twist(0.3, 0.2, 2.5), steering)
    assert_close(slip(CAR, rates, steering), np.zeros(8), atol=16 * EPS)


def test_wheels_are_values():
    assert fixed(1, 2, 3, 4) == Wheel("fixed", 1.0, 2.0, 3.0, 4.0)
    assert len({fixed(1, 2, 3, 4), fixed(1.0, 2.0, 3.0, 4.0), steered(1, 2, 3, 4)}) == 2
    assert castor(1, 2, 3, 4, -5) == Wheel("castor", 1, 2, 3, 4, d=-5)
    assert swedish(1, 2, 3, 4, 5) == Wheel("swedish", 1, 2, 3, 4, gamma=5)
    assert spherical(1, 2, 3) == Wheel("spherical", 1, 2, 0, 3)
    assert type(fixed(np.float32(1), np.array(2), 3, 4).alpha) is float
    assert fixed(1, 1e200, 1e200, 1).beta == 1e200  # any angle, if only their sum is finite
    with pytest.raises(FrozenInstanceError):
        fixed(1, 2, 3, 4).beta = 0.0


# Errors


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: fixed(1, 0, [0, 1], 1), r"beta must be one number, got array\(\[0., 1.\]\)"),
        (lambda: fixed(1, 1.5e308, 1.5e308, 1), "alpha [+] beta [+] gamma must be finite"),
        (lambda: castor(1, 0, 0, 1, 0), "d must not be 0 for a castor, .* got 0.0"),
        (lambda: Wheel("fixed", 1, 0, 0, 1, d=0.1), "d must not be 0 for a castor, and 0 for"),
        (lambda: swedish(1, 0, 0, 1, QUARTER), "gamma must be 0, .* not ±π/2, got 1.57"),
        (lambda: Wheel("castor", 1, 0, 0, 1, 0.1, 0.2), "gamma must be 0, of a swedish wheel"),
        (lambda: Wheel("round", 1, 0, 0, 1), "kind must be one of fixed, .* got 'round'"),
        (lambda: omni_robot(0.2, 0.05, [[1.0]]), r"angles must have shape \(n,\), got \(1, 1\)"),
        (lambda: rolling(CAR[0]), "wheels must be a list of Wheel, got Wheel"),
        (lambda: sliding([*CAR, "wheel"]), "wheels must be Wheel, got 'wheel' at index 4"),
        (lambda: rolling(CAR, [1, 2, 3]), r"steering must have shape \(…, 2\), got \(3,\)"),
        (lambda: sliding(OMNI, 1.0), r"steering must have shape \(…, 0\), got \(\)"),
        (lambda: forward(CAR, [1, 2, 3]), r"rates must have shape \(…, 4\), got \(3,\)"),
        (lambda: forward(OMNI, np.ones((2, 3)), theta=[1, 2, 3]), r"rates \(2, 3\), theta \(3,\)"),
    ],
)
def test_what_is_refused(call, message):
    with pytest.raises(RobokinError, match=message):
        call()


def test_the_first_slip_is_named():
    twists_wanted = [[[1, 0, 0], [0, 0, 0]], [[1, 0, 0], [1, 0.5, 0]], [[0, 1, 0], [0, 0, 0]]]
    message = r"^wheel 0 \(fixed\) would slip sideways at 0.5 m/s at index 1, 1; slipping="
    with pytest.raises(UnreachableError, match=message):
        inverse(CAR, twists_wanted)
    # the wheel's number counts all wheels, its speed has no sign, and one item has no index
    robot = [spherical(1, 0, 0.1), *OMNI, CAR[0], steered(*spoke_to(0, -2), 0.1)]
    with pytest.raises(UnreachableError, match=r"^wheel 5 \(steered\) .* at 0.841 m/s;"):
        inverse(robot, [-1, 0, 0], [robot[5].beta + 1])
    rates = inverse(CAR, twists_wanted, slipping="nan")
    wanted = np.full((3, 2), False)
    wanted[1, 1] = wanted[2, 0] = True
    np.testing.assert_array_equal(np.isnan(rates), np.repeat(wanted[..., None], 4, axis=-1))
    assert_close(rates[0, 0], np.full(4, 1 / 0.3), atol=16 * EPS)


def test_measured_motions_have_rates():
    """With six digits, in single precision and, if slip is ignored, with steering of 12 bits."""
    robot = [fixed(0.2, QUARTER, 0, 0.05), fixed(0.2, -QUARTER, np.pi, 0.05)]
    rates = inverse(robot, [0.764842, 0.644218, 0.5], theta=0.7)
    assert_close(rates, [18.0, 22.0], atol=2e-5)  # 5e-7 m/s, twice, by the radius
    steering = CAR_STRAIGHT + bicycle.ackermann(0.4, 2.5, 1.5)
    twist = bicycle.body_twist(1.0, 0.4, 2.5)
    wanted = inverse(CAR, twist, steering)
    assert_close(inverse(CAR, np.float32(twist), np.float32(steering)), wanted, atol=2e-6)
    step = 2 * np.pi / 2**12
    coarse = np.round(steering / step) * step
    with pytest.raises(UnreachableError, match="slipping='ignore' gives rates"):
        inverse(CAR, twist, coarse)
    # half a step of the angle moves a speed of 1.2 m/s along the wheel by its square
    found = inverse(CAR, twist, coarse, slipping="ignore")
    assert_close(found, wanted, atol=(step / 2) ** 2 * 1.2 / 0.3)


def test_one_wheel_that_slips_is_enough():
    # straight ahead, one front wheel turned a little: the other three would roll
    steering = [CAR[2].beta + 0.2, CAR[3].beta]
    assert np.isnan(inverse(CAR, [1, 0, 0], steering, slipping="nan")).all()


# Independent oracles


def moving_point(wheel, pose, twist, steering_rate=0.0):
    """Where a wheel's contact point, its rolling direction and its axle are at the time t.

    Written from the figure: the robot moves as a rigid body, the wheel hangs on it at the end of
    its spoke, a castor with its offset along the rolling direction.
    """

    def at_time(t):
        x, y, theta = motion.move(pose, twist, t)
        axle = theta + wheel.alpha + wheel.beta + steering_rate * t
        ahead = np.array([np.cos(axle - QUARTER), np.sin(axle - QUARTER)])
        spoke = np.array([np.cos(theta + wheel.alpha), np.sin(theta + wheel.alpha)])
        point = np.array([x, y]) + wheel.l * spoke + wheel.d * ahead
        return point, ahead, np.array([np.cos(axle), np.sin(axle)])

    return at_time


H = 1e-5  # seconds; central differences: rounding 4e-15/H = 4e-10, and H² · (3 rad/s)³ · 4 m


def velocity_of(at_time):
    (after, *_), (before, *_) = at_time(H), at_time(-H)
    return (after - before) / (2 * H)


@given(wheels(("fixed", "steered", "castor")), twists, angles, reals(-2, 2))
def test_rolling_and_sliding_are_the_contact_points_velocity(wheel, twist, theta, beta_rate):
    at_time = moving_point(wheel, [0.3, -0.4, theta], twist, beta_rate * (wheel.kind != "fixed"))
    _, ahead, axle = at_time(0.0)
    v = velocity_of(at_time)
    assert_close(rolling([wheel])[0] @ twist, v @ ahead, atol=3e-8)
    if wheel.kind == "castor":
        # [cos(α+β), sin(α+β), d + l sin β] ξ̇_R + d β̇: any motion can be met by some β̇
        row = sliding([fixed(wheel.l, wheel.alpha, wheel.beta, 1)])[0] + [0, 0, wheel.d]
        assert_close(row @ twist + wheel.d * beta_rate, v @ axle, atol=3e-8)
        assert sliding([wheel]).shape == (0, 3)
    else:
        assert_close(sliding([wheel])[0] @ twist, v @ axle, atol=3e-8)


@given(wheels(("swedish",)), twists, angles)
def test_a_swedish_wheel_is_free_across_its_rollers_axis(wheel, twist, theta):
    at_time = moving_point(wheel, [0.3, -0.4, theta], twist)
    _, ahead, axle = at_time(0.0)
    v = velocity_of(at_time)
    # v = r φ̇ · ahead + free speed across the roller's axis, which stands γ from `ahead`
    c, s = np.cos(wheel.gamma), np.sin(wheel.gamma)
    across = c * axle - s * ahead
    rate, _ = np.linalg.solve(np.transpose([wheel.radius * ahead, across]), v)
    # divided by r cos γ, at least 0.05 · 0.17
    assert_close(inverse([wheel], twist), [rate], atol=3e-8 / (wheel.radius * c))
    row, per_radian = rolling([wheel])[0], rolling_rates([wheel])[0, 0]
    assert_close(row @ twist, per_radian * rate, atol=3e-8)


@given(determined, st.data())
def test_forward_is_numpys_least_squares(robot, data):
    k, s = len(driven(robot)), len(steered_of(robot))
    rates, steering = data.draw(vectors(k, -5, 5)), data.draw(vectors(s, -4, 4))
    rows = np.concatenate([rolling(robot, steering), sliding(robot, steering)])
    wanted = np.concatenate([rolling_rates(robot) @ rates, np.zeros(len(rows) - k)])
    solution, _, rank, _ = np.linalg.lstsq(rows, wanted, rcond=None)
    assert rank == 3
    assert_close(forward(robot, rates, steering), solution, atol=50 * ATOL)
    assert_close(slip(robot, rates, steering), rows @ solution - wanted, atol=50 * ATOL)


@given(st.lists(wheels(("swedish", "fixed", "castor")), min_size=3, max_size=5), st.data())
def test_forward_is_numpys_least_squares_for_any_wheels(robot, data):
    rows = np.concatenate([rolling(robot), sliding(robot)])
    size = max(w.l for w in robot)
    condition = np.linalg.cond(rows / [1, 1, size])
    assume(condition < 1e6)
    rates = data.draw(vectors(len(robot), -5, 5))
    wanted = np.concatenate([rolling_rates(robot) @ rates, np.zeros(len(rows) - len(robot))])
    solution = np.linalg.lstsq(rows / [1, 1, size], wanted, rcond=None)[0] / [1, 1, size]
    # speeds up to 10 m/s, and an angle rate by a length of 0.05 m
    assert_close(forward(robot, rates), solution, atol=1e-13 * condition**2)


@given(reals(-3, 3), reals(-3, 3), lengths, reals(0.05, 1))
def test_a_differential_drive_made_of_two_fixed_wheels(left, right, radius, half):
    robot = [fixed(half, QUARTER, 0, radius), fixed(half, -QUARTER, np.pi, radius)]
    wanted = differential_drive.body_twist(left, right, radius, 2 * half)
    # a turning rate up to 2·3/0.1 rad/s
    assert_close(forward(robot, [left, right]), wanted, atol=10 * ATOL * 12)
    assert_close(slip(robot, [left, right]), np.zeros(4), atol=10 * ATOL)
    assert_close(inverse(robot, wanted), [left, right], atol=10 * ATOL / radius)


@given(reals(-3, 3), reals(-1.2, 1.2), angles)
def test_a_car_steered_by_ackermann_is_the_bicycle(v, phi, theta):
    steering = CAR_STRAIGHT + bicycle.ackermann(phi, 2.5, 1.5)
    body = bicycle.body_twist(v, phi, 2.5)
    world = motion.to_world(theta, body)
    rates = inverse(CAR, world, steering, theta)
    # rear wheels: v ∓ ω l/2, by the radius; front wheels: the distance to the centre, or backwards
    # where the inner one has turned past 90°
    assert_close(rates[:2], (v + body[2] * np.array([-0.75, 0.75])) / 0.3, atol=100 * ATOL)
    front = np.hypot(v + body[2] * np.array([-0.75, 0.75]), 2.5 * body[2]) / 0.3
    assert_close(np.abs(rates[2:]), front, atol=100 * ATOL)
    assert_close(forward(CAR, rates, steering, theta), world, atol=100 * ATOL)
    one = [BICYCLE[0], steered(*spoke_to(2.5, 0), 0.3)]
    rear, fork = inverse(one, world, [QUARTER + phi], theta)
    assert_close([rear, fork * np.cos(phi)], [v / 0.3, v / 0.3], atol=100 * ATOL)


# What the chapter says


def test_a_mecanum_wheels_slip_is_seen_along_its_rollers_axis_only():
    rates = np.array([2.0, 1.0, 1.0, 1.0])
    v, v_y, omega = forward(MECANUM, rates)
    x, y = 0.2, 0.15  # wheel 1, which rolls ahead; its radius is 5 cm
    ground = np.array([v - omega * y, v_y + omega * x])
    rim = np.array([0.05 * rates[0], 0])
    axis = np.array([np.cos(np.pi / 4), -np.sin(np.pi / 4)])
    found = slip(MECANUM, rates)[0]
    assert_close(axis @ (ground - rim), found, atol=4 * EPS)
    assert abs(found + 0.0088) < 1e-4  # as the chapter prints it
    assert (ground - rim)[0] < 3 * found  # along the rolling direction it is another number
