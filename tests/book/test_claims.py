"""Numbers that sentences of the book state and no cell computes."""

import numpy as np
import pytest
import sympy as sp
from declared import EQUATIONS
from support import EPS, assert_close

from book.prose import read_figure
from robokin import elbow_arm, motion, odometry, planar_arm


def test_numpy_inverts_a_singular_matrix_without_an_error():
    """The glossary says so: rounding hides the zero from the elimination."""
    singular = np.array([[-1, 0, 5], [9, -9, -7], [8, -9, -2]])
    assert (singular[0] + singular[1] == singular[2]).all()
    assert np.abs(np.linalg.inv(singular)).max() > 1e15
    with pytest.raises(np.linalg.LinAlgError):
        np.linalg.inv([[1.0, 2.0], [2.0, 4.0]])


@pytest.mark.parametrize("u", [1e-3, 0.1, 0.7, 1.5])
def test_the_error_of_a_step_is_that_of_its_fold(u):
    """Chapter 04, step 8: the middle heading goes u/sin u times as far; the old one, turned by u,
    too."""
    steps = {
        method: complex(*motion.path([0, 0, 0], [1.0], [2 * u], 1.0, method)[-1][:2])
        for method in ("exact", "midpoint", "start")
    }
    far = u / np.sin(u)
    assert steps["midpoint"] == pytest.approx(far * steps["exact"], rel=1e-14)  # some roundings
    assert steps["start"] == pytest.approx(far * np.exp(-1j * u) * steps["exact"], rel=1e-14)


def test_robots_that_turn_more_end_nearer_up_to_a_full_turn():
    """The page before the chapters asks it for half a turn; beyond a full one it is false."""
    ends = motion.arc_step([0, 0, 0], v=1.0, omega=np.array([np.pi / 2, np.pi, 4.0]), dt=2.0)
    half, full, more = np.hypot(ends[:, 0], ends[:, 1])
    assert half == pytest.approx(4 / np.pi)
    assert full < 1e-15 < more  # a full turn ends where it began
    assert more == pytest.approx(0.378, abs=5e-4)


def test_each_of_a_thousand_targets_has_one_answer_in_each_region():
    """Chapter 01, step 7: the regions of the map are told by where the wrist is, not by angles."""
    joints = np.random.default_rng(7).uniform(-np.pi, np.pi, (1000, 3))
    links = np.random.default_rng(8).uniform(0.2, 0.6, (2, 1000))
    targets = elbow_arm.forward(joints, *links)
    answers = elbow_arm.inverse(targets, *links)
    back = elbow_arm.forward(answers * [0, 1, 1], *links[..., None])  # in the plane of the arm
    regions = 2 * (back[..., 0] > 0) + (np.sin(answers[..., 2]) > 0)
    assert (np.sort(regions, axis=1) == np.arange(4)).all()


@pytest.mark.parametrize("gap", [1e-3, 1e-5, 1e-7])
def test_near_full_stretch_the_elbow_goes_with_the_root_of_the_gap(gap):
    """Chapter 01, a fold: √(2 · gap · (a2 + a3)/(a2 a3)), but for a part as small as the gap."""
    a2, a3 = 0.4, 0.3
    bent = elbow_arm.inverse([a2 + a3 - gap, 0, 0], a2, a3)[1, 2]
    assert bent == pytest.approx(np.sqrt(2 * gap * (a2 + a3) / (a2 * a3)), rel=3 * gap)
    off = 1e-3 * gap  # of the distance
    rate = (elbow_arm.inverse([a2 + a3 - gap + off, 0, 0], a2, a3)[1, 2] - bent) / off
    d = a2 + a3 - gap
    assert rate == pytest.approx(-d / (a2 * a3 * np.sin(bent)), rel=1e-3)


def test_a_stretched_or_folded_arm_has_two_ways_left():
    """Chapter 01, step 8: beside the base axis, one facing and one away."""
    for d in (0.7, 0.1):
        on_circle = np.exp(1j * elbow_arm.inverse([d, 0, 0], 0.4, 0.3))  # 180° is −180°
        assert len(np.unique(on_circle.round(9), axis=0)) == 2


def drive_by_levers(D_L, D_R, k=1e-4, b=0.2, pieces=4096):
    """The covariance of a drive's end, by the library, and by both tracks' levers to the end."""
    ticks = [np.full(pieces, round(D * 2**40 / pieces)) for D in (D_L, D_R)]
    robot = 2.0**40, 0.5 / np.pi, b
    drive = odometry.path(*ticks, *robot)
    middle = odometry.path(*ticks, *robot, pose=motion.arc_step(
        [0, 0, 0], (D_L + D_R) / 2, (D_R - D_L) / b, 0.5 / pieces))[:-1]  # fmt: skip
    half = b / 2 * np.array([-np.sin(middle[:, 2]), np.cos(middle[:, 2])])
    total = 0
    for hinge, other in ((half, D_R), (-half, D_L)):
        x, y = drive[-1, :2, None] - middle[:, :2].T - hinge
        turned = np.array([-y, x])
        total = total + k / b**2 * abs(other) / pieces * turned @ turned.T
    return odometry.covariance(*ticks, *robot, k)[-1, :2, :2], total


@pytest.mark.parametrize(
    ("D_L", "D_R"),
    [(2.5 - 0.4 * np.pi / 3, 2.5 + 0.4 * np.pi / 3), (2.0, 2.0), (0.0, 0.3), (-0.4, 0.4)],
    ids=["240°", "straight", "one wheel held", "on the spot"],
)
def test_the_covariance_is_the_inertia_of_both_tracks(D_L, D_R):
    """Chapter 07, step 5: each track as heavy as the other wheel's way, turned by a quarter."""
    carried, levers = drive_by_levers(D_L, D_R)
    # what pieces lack is about 1/4096², 6e-8, of the largest entry
    np.testing.assert_allclose(levers, carried, atol=2e-7 * carried.max())


def test_the_ellipse_of_a_long_bend():
    """Chapter 07: 2.5 m and 240° with wheels that err by 1 cm over a metre."""
    carried, _ = drive_by_levers(2.5 - 0.4 * np.pi / 3, 2.5 + 0.4 * np.pi / 3)
    assert odometry.ellipse(carried)[0] == pytest.approx([0.0939, 0.0418], abs=5e-5)


def test_with_one_wheel_held_the_ellipse_is_a_line():
    """All slips have one hinge then, and one lever; the way itself is a part of the circle."""
    carried, _ = drive_by_levers(0.0, 0.3)
    long, short = odometry.ellipse(carried)[0]
    assert short < 1e-6 * long  # rounding, under a root


def test_m9_goes_unnoticed_in_the_figure_at_one_heading():
    """Nobody, says M9, notices it in the figure with a heading of 120°."""

    def apart(degrees):
        heading = {"mistake": "No inverse", "db_turn": np.radians(degrees)}
        return float(read_figure("wrong-object", "apart", **heading))

    assert apart(120) < 10 * EPS
    assert apart(119) > 0.01
    assert apart(121) > 0.01


@pytest.mark.parametrize("metres", [1.0, 0.01])
def test_the_nearest_motion_is_that_of_a_length_of_one_metre(metres):
    """The laboratory's bicycle, asked for all three speeds; in centimetres it is another motion."""
    asked = np.array([0.15, 0.15, 0.5])
    wished = dict(zip(("wish_v", "wish_vy", "wish_omega"), asked, strict=True), robot="bicycle")
    shown = [read_figure("wheel-laboratory", name, **wished) for name in ("v", "v_y", "omega")]
    ahead = 0.3  # m: there the front wheel is, steered as the wish moves it; it puts the ICR aside
    allowed = np.array([ahead * asked[0] / (asked[1] + ahead * asked[2]), 0.0, 1.0])
    weights = np.array([1, 1, metres])
    size = (weights * allowed) @ (weights * asked) / np.sum((weights * allowed) ** 2)
    assert np.allclose(shown, size * allowed, rtol=0, atol=1e-12) == (metres == 1)


def test_the_command_takes_the_error_back():
    """The chapter's command, carried out by the library: 1 - K dt of an error is left."""
    formula = EQUATIONS["planar_arm.command"]
    command = sp.lambdify(formula.symbols, list(formula.right), "numpy")
    gain, dt, wanted = 2.0, 1e-6, np.array([0.5, 0.45, 0.1])
    theta, lengths = np.array([0.5, 1.0, -1.5]), [0.4, 0.3, 0.1]
    error = wanted - planar_arm.forward(theta, lengths)
    values = {"gain": gain, "vx_d": 0.0, "vy_d": 0.0, "omega_d": 0.0}
    values |= dict(zip(["x_d", "y_d", "phi_d"], wanted, strict=True))
    values |= dict(zip(["x", "y", "phi_hand"], planar_arm.forward(theta, lengths), strict=True))
    twist = command(*(values[str(symbol)] for symbol in formula.symbols))
    after = wanted - planar_arm.forward(
        theta + planar_arm.joint_rates(theta, twist, lengths) * dt, lengths
    )
    # second order in dt: up to 5 rad/s, squared, times 1 m and dt²; and EPS of a metre
    assert_close(after, (1 - gain * dt) * error, atol=25 * dt**2 + 4 * EPS)
    # in the wanted pose the wanted velocity is all that is commanded
    values |= {"x": 0.5, "y": 0.45, "phi_hand": 0.1, "vx_d": 0.3, "vy_d": 0.2, "omega_d": -1}
    assert command(*(values[str(symbol)] for symbol in formula.symbols)) == [0.3, 0.2, -1]
