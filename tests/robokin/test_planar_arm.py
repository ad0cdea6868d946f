"""robokin.planar_arm: chains of links in the plane, their velocities and singular poses."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from support import EPS, NEAR_ZERO, angles, assert_angles, assert_close, reals, twists, vectors

from robokin.errors import RobokinError, SingularError, UnreachableError
from robokin.planar_arm import (
    ellipse,
    forward,
    inverse,
    jacobian,
    joint_positions,
    joint_rates,
    manipulability,
    velocity,
)

LENGTHS = [0.4, 0.3, 0.1]

joints = vectors(3, -np.pi, np.pi).map(np.array)
rates = vectors(3, -3, 3).map(np.array)
links = vectors(3, 0.1, 2).map(np.array)
# one to six links: joint angles, joint rates and lengths
arms = st.integers(1, 6).flatmap(
    lambda n: st.tuples(vectors(n, -np.pi, np.pi), vectors(n, -3, 3), vectors(n, 0.1, 2)).map(
        lambda arm: tuple(map(np.array, arm))
    )
)


def turn(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


# Laws


@given(arms)
def test_the_links_keep_their_lengths_and_headings(arm):
    theta, _, lengths = arm
    points = joint_positions(theta, lengths)
    assert points.shape == (len(theta) + 1, 2)
    np.testing.assert_array_equal(points[0], [0, 0])
    steps = np.diff(points, axis=0)
    # coordinates up to 12 m, links from 0.1 m: 12 EPS / 0.1 in the heading
    assert_close(np.linalg.norm(steps, axis=1), lengths, atol=32 * EPS)
    assert_angles(np.arctan2(steps[:, 1], steps[:, 0]), np.cumsum(theta), atol=200 * EPS)
    x, y, phi = forward(theta, lengths)
    assert_close([x, y], points[-1], atol=16 * EPS)
    assert_close(phi, np.sum(theta), atol=16 * EPS)  # not wrapped


@given(arms)
def test_velocity_is_the_jacobian_times_the_rates(arm):
    theta, q, lengths = arm
    # up to 12 m times 18 rad/s, a few roundings
    expected = jacobian(theta, lengths) @ q
    assert_close(velocity(theta, q, lengths), expected, atol=4 * EPS * 12 * 18)


@given(arms)
def test_a_column_is_the_lever_from_its_joint_to_the_hand(arm):
    theta, _, lengths = arm
    points = joint_positions(theta, lengths)
    x, y = (points[-1] - points[:-1]).T
    expected = np.array([-y, x, np.ones(len(theta))])
    assert_close(jacobian(theta, lengths), expected, atol=32 * EPS)  # 12 m, summed either way


@given(joints, links)
def test_the_determinant_is_l1_l2_sin_theta2(theta, lengths):
    expected = lengths[0] * lengths[1] * np.sin(theta[1])
    # products of two coordinates of up to 6 m
    assert_close(np.linalg.det(jacobian(theta, lengths)), expected, atol=8 * EPS * 36)


@given(joints, twists, links)
def test_the_rates_give_the_twist(theta, twist, lengths):
    assume(abs(np.sin(theta[1])) > 1e-3)
    q = joint_rates(theta, twist, lengths)
    # rates of up to 3 m/s · 6 m/(0.1 m)² · 1e3; each EPS of them moves the hand by 6 m
    atol = 16 * EPS * np.abs(q).max() * 6 + 16 * EPS
    assert_close(velocity(theta, q, lengths), twist, atol=atol)


@given(joints, twists, links, reals(0.01, 10))
def test_damped_rates_are_the_least_squares(theta, twist, lengths, damping):
    # where |J q - twist|² + λ² |q|² is least its gradient vanishes: Jᵀ (J q - twist) + λ² q = 0
    J, q = jacobian(theta, lengths), joint_rates(theta, twist, lengths, damping)
    gradient = J.T @ (J @ q - twist) + damping**2 * q
    # |J|² up to 150 m², |q| up to 3 m/s / 2λ: a few EPS of both
    assert_close(gradient, np.zeros(3), atol=64 * EPS * (150 + damping**2) * (9 / damping + 1))


@given(joints, links)
def test_the_inverse_leads_back_to_the_pose(theta, lengths):
    pose = forward(theta, lengths)
    both = inverse(pose, lengths)
    back = forward(both, lengths)
    # the wrist comes from a difference of up to 6 m, where an EPS may push it over the boundary
    assert_close(back[:, :2], np.tile(pose[:2], (2, 1)), atol=32 * EPS * lengths.sum())
    assert_angles(back[:, 2], np.tile(pose[2], 2), atol=16 * EPS)
    assert both[0, 1] >= 0
    assert_angles(both[1, 1], -both[0, 1], atol=0)
    assert np.all((both > -np.pi) & (both <= np.pi))


@given(joints, links)
def test_the_angles_that_were_put_in_are_one_of_the_two(theta, lengths):
    wrist = np.linalg.norm(joint_positions(theta, lengths)[2])
    assume(abs(np.sin(theta[1])) > 0.05)
    assume(wrist > 0.05)
    both = inverse(forward(theta, lengths), lengths)
    # the wrist is rounded by 6 m · EPS; over 0.05 m and the sine of 0.05
    assert_angles(both[0 if theta[1] > 0 else 1], theta, atol=16 * EPS * 6 / 0.05**2)


@given(joints, links, angles)
def test_turning_the_base_turns_everything(theta, lengths, angle):
    turned = theta + np.array([angle, 0, 0])
    # coordinates up to 6 m, angles up to 12 rad
    atol = 64 * EPS * 6
    expected = joint_positions(theta, lengths) @ turn(angle).T
    assert_close(joint_positions(turned, lengths), expected, atol=atol)
    expected = turn(angle) @ jacobian(theta, lengths)[:2]
    assert_close(jacobian(turned, lengths)[:2], expected, atol=atol)
    # the ellipse turns too, its axes do not change: theta1 does not enter them at all
    axes, directions = ellipse(theta, lengths)
    turned_axes, turned_directions = ellipse(turned, lengths)
    np.testing.assert_array_equal(turned_axes, axes)
    assert_close(turned_directions, turn(angle) @ directions, atol=32 * EPS)
    assert manipulability(turned, lengths) == manipulability(theta, lengths)


@given(joints, twists, links, st.integers(-8, 8))
def test_only_proportions_matter(theta, twist, lengths, k):
    # a power of two scales without rounding; damping is no length, so it is left out here
    scale = np.array([2.0**k, 2.0**k, 1])
    np.testing.assert_array_equal(forward(theta, 2.0**k * lengths), scale * forward(theta, lengths))
    if abs(np.sin(theta[1])) > 1e-14:
        np.testing.assert_array_equal(
            joint_rates(theta, scale * twist, 2.0**k * lengths),
            joint_rates(theta, twist, lengths),
        )
    axes, directions = ellipse(theta, lengths)
    scaled, same = ellipse(theta, 2.0**k * lengths)
    np.testing.assert_array_equal(scaled, 2.0**k * axes)
    np.testing.assert_array_equal(same, directions)


@given(arms)
def test_the_ellipse_and_its_area(arm):
    theta, _, lengths = arm
    axes, directions = ellipse(theta, lengths)
    assert axes[0] >= axes[1] * (1 - 4 * EPS)
    assert axes[1] >= 0
    assert_close(directions.T @ directions, np.eye(2), atol=4 * EPS)
    assert_close(np.linalg.det(directions), 1.0, atol=4 * EPS)
    # up to 30 m · 30 m
    assert_close(axes[0] * axes[1], manipulability(theta, lengths), atol=4 * EPS * 900)


# The numbers of the hand solution


def test_an_arm_bent_square():
    # exercise 8 with θ = (0, 90°, 0): link 1 along x, the others along y
    theta = [0, np.pi / 2, 0]
    assert_close(forward(theta, LENGTHS), [0.4, 0.4, np.pi / 2], atol=2 * EPS)
    assert_close(
        joint_positions(theta, LENGTHS), [[0, 0], [0.4, 0], [0.4, 0.3], [0.4, 0.4]], atol=2 * EPS
    )
    J = jacobian(theta, LENGTHS)
    assert_close(J, [[-0.4, -0.4, -0.1], [0.4, 0, 0], [1, 1, 1]], atol=2 * EPS)
    assert_close(np.linalg.det(J), 0.4 * 0.3, atol=2 * EPS)
    # rates 1, 2, 3: ẋ = −0.4 − 0.8 − 0.3, ẏ = 0.4, φ̇ = 6
    assert_close(velocity(theta, [1, 2, 3], LENGTHS), [-1.5, 0.4, 6], atol=8 * EPS)
    assert_close(joint_rates(theta, [-1.5, 0.4, 6], LENGTHS), [1, 2, 3], atol=32 * EPS)


def test_lifting_the_hand_by_hand():
    # ẏ = 0.4 θ̇1 = 0.1: θ̇1 = 0.25; ẋ = 0 and φ̇ = 0: −0.4 (θ̇1 + θ̇2) − 0.1 θ̇3 = 0, so θ̇3 = 0
    q = joint_rates([0, np.pi / 2, 0], [0, 0.1, 0], LENGTHS)
    assert_close(q, [0.25, -0.25, 0], atol=4 * EPS)


def test_inverse_by_hand():
    # the square arm, and its elbow mirrored in the line to the wrist (0.4, 0.3)
    both = inverse([0.4, 0.4, np.pi / 2], LENGTHS)
    theta1 = 2 * np.arctan2(0.3, 0.4)
    expected = [[0, np.pi / 2, 0], [theta1, -np.pi / 2, np.pi - theta1]]
    assert_close(both, np.array(expected), atol=8 * EPS)


def test_two_equal_links_bent_square_by_hand():
    # J = a [[−1, −1], [1, 0]]: its singular values are a times the golden ratio and its inverse
    golden = (1 + np.sqrt(5)) / 2
    axes, directions = ellipse([0, np.pi / 2], [0.4, 0.4])
    assert_close(axes, [0.4 * golden, 0.4 / golden], atol=2 * EPS)
    # J Jᵀ = a² [[2, −1], [−1, 1]]: the larger axis along (golden, −1)
    along = np.array([golden, -1]) / np.hypot(golden, 1)
    assert_close(abs(directions[:, 0] @ along), 1.0, atol=4 * EPS)
    assert_close(manipulability([0, np.pi / 2], [0.4, 0.4]), 0.16, atol=2 * EPS)


def test_damped_rates_by_hand():
    # stretched along x, one metre a link: only θ̇ with ẏ = 3 θ̇1 + 2 θ̇2 + θ̇3; ẋ is lost, whatever λ
    np.testing.assert_array_equal(joint_rates([0, 0, 0], [1, 0, 0], [1, 1, 1], damping=0.5), 0)
    # a twist (ẏ, φ̇) = (2, 1) · c is what all joints alike give: J Jᵀ = [[14, 6], [6, 3]],
    # with λ² = 1: [[15, 6], [6, 4]]⁻¹ (1, 0) = (4, −6)/24, Jᵀ of it: (6, 2, −2)/24
    q = joint_rates([0, 0, 0], [0, 1, 0], [1, 1, 1], damping=1.0)
    assert_close(q, np.array([6, 2, -2]) / 24, atol=4 * EPS)


# Singular and boundary cases


def exact_rates(theta, twist, lengths, damping=0.0):
    """Jᵀ (J Jᵀ + λ² I)⁻¹ times the twist with 60 digits, straight from its definition."""
    with mpmath.workdps(60):
        total = [mpmath.fsum(map(mpmath.mpf, theta[: i + 1])) for i in range(3)]
        x = [mpmath.mpf(a) * mpmath.cos(h) for a, h in zip(lengths, total, strict=True)]
        y = [mpmath.mpf(a) * mpmath.sin(h) for a, h in zip(lengths, total, strict=True)]
        J = mpmath.matrix(
            [[-sum(y[i:]) for i in range(3)], [sum(x[i:]) for i in range(3)], [1, 1, 1]]
        )
        t = mpmath.matrix([mpmath.mpf(v) for v in twist])
        if damping == 0:
            return np.array(list(mpmath.lu_solve(J, t)), dtype=float)
        A = J * J.T + mpmath.mpf(damping) ** 2 * mpmath.eye(3)
        return np.array(list(J.T * mpmath.lu_solve(A, t)), dtype=float)


NEAR_SINGULAR = [gap for gap in NEAR_ZERO if abs(gap) > 2e-14]


@pytest.mark.parametrize("gap", NEAR_SINGULAR)
@pytest.mark.parametrize("centre", [0.0, np.pi, -np.pi])
def test_rates_keep_their_digits_next_to_the_singular_points(gap, centre):
    rng = np.random.default_rng(6)
    for _ in range(5):
        theta, twist = rng.uniform(-3, 3, (2, 3))
        theta[1] = centre + gap
        lengths = rng.uniform(0.1, 1, 3)
        exact = exact_rates(theta, twist, lengths)
        q = joint_rates(theta, twist, lengths)
        # wanted: 1e-10 of the rates at 1e-12; dividing by the sine itself leaves a few EPS, more
        # where the twist lies along the arm by chance
        np.testing.assert_allclose(q, exact, rtol=0, atol=1e-13 * np.abs(exact).max())


@pytest.mark.parametrize("theta2", [0.0, -0.0, np.pi, -np.pi, 1e-14, -1e-14, 1e-16, 2 * np.pi])
def test_singular_poses(theta2):
    theta = [0.3, theta2, -0.4]
    with pytest.raises(SingularError, match=r"theta is singular: \|sin\(theta2\)\| is .*damping"):
        joint_rates(theta, [0.1, 0.2, 0.3], LENGTHS)
    assert np.all(np.isnan(joint_rates(theta, [0.1, 0.2, 0.3], LENGTHS, singular="nan")))


@pytest.mark.parametrize("theta2", [np.nextafter(1e-14, 1), -np.nextafter(1e-14, 1), np.pi - 2e-14])
def test_just_not_singular(theta2):
    q = joint_rates([0.3, theta2, -0.4], [0.1, 0.2, 0.3], LENGTHS)
    assert np.all(np.isfinite(q))
    np.testing.assert_allclose(q, exact_rates([0.3, theta2, -0.4], [0.1, 0.2, 0.3], LENGTHS), 1e-13)


def test_one_singular_item_does_not_spoil_its_batch():
    theta = np.array([[0.3, 1.0, -0.4], [0.3, 0.0, -0.4], [0.3, np.pi, 0.2], [0.1, -1.0, 2.0]])
    twist = np.array([0.1, 0.2, 0.3])
    q = joint_rates(theta, twist, LENGTHS, singular="nan")
    np.testing.assert_array_equal(np.isnan(q), [[False] * 3, [True] * 3, [True] * 3, [False] * 3])
    good = joint_rates(theta[[0, 3]], twist, LENGTHS)
    np.testing.assert_array_equal(q[[0, 3]], good)
    with pytest.raises(SingularError, match=r"theta at index 1 is singular.* is 0, must be above"):
        joint_rates(theta, twist, LENGTHS)
    with pytest.raises(SingularError, match=r"theta at index 0, 1 is singular.* is 1\.22e-16"):
        joint_rates(theta[[[0, 2]]], twist, LENGTHS)
    # the pose and the damping may have fewer dimensions than the twists
    with pytest.raises(SingularError, match="theta is singular"):
        joint_rates(theta[1], np.ones((2, 4, 3)), LENGTHS)
    nothing = joint_rates(theta[1], np.ones((2, 4, 3)), LENGTHS, singular="nan")
    assert np.all(np.isnan(nothing))


def test_damping_of_some_items_only():
    theta = np.array([[0.3, 1.0, -0.4], [0.3, 0.0, -0.4], [0.3, 0.0, -0.4]])
    twist = np.array([0.1, 0.2, 0.3])
    q = joint_rates(theta, twist, LENGTHS, damping=[0.0, 0.0, 0.1], singular="nan")
    assert_close(q[0], joint_rates(theta[0], twist, LENGTHS), atol=16 * EPS)
    assert np.all(np.isnan(q[1]))
    assert_close(q[2], joint_rates(theta[2], twist, LENGTHS, damping=0.1), atol=16 * EPS)
    with pytest.raises(SingularError, match="index 1"):
        joint_rates(theta, twist, LENGTHS, damping=[0.0, 0.0, 0.1])
    # a damping whose square is zero is none
    with pytest.raises(SingularError, match="index 1"):
        joint_rates(theta, twist, LENGTHS, damping=1e-200)


@pytest.mark.parametrize("damping", [1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 1e3])
@pytest.mark.parametrize("theta2", [0.0, 1e-12, -1e-6, 1.0, np.pi, np.pi - 1e-9])
def test_damped_rates_with_60_digits(damping, theta2):
    rng = np.random.default_rng(7)
    for _ in range(3):
        theta, twist = rng.uniform(-3, 3, (2, 3))
        theta[1] = theta2
        lengths = rng.uniform(0.1, 1, 3)
        exact = exact_rates(theta, twist, lengths, damping)
        q = joint_rates(theta, twist, lengths, damping)
        # measured 2e-14 (SVD: more than 1 for small λ); short links lose up to (1/0.1)²
        np.testing.assert_allclose(q, exact, rtol=0, atol=2e-13 * np.abs(exact).max())


def test_damping_fades_into_the_smallest_rates():
    # at a singular pose, for a twist that it can do, λ → 0 leads to the pseudo-inverse
    theta = [0.7, 0.0, 1.1]
    twist = velocity(theta, [0.3, -0.8, 0.5], LENGTHS)
    best = np.linalg.pinv(jacobian(theta, LENGTHS), rcond=1e-10) @ twist
    q = joint_rates(theta, twist, LENGTHS, damping=1e-5)
    # λ²/s² with the smaller singular value s = 0.2: 3e-9; what rounding adds across: EPS / 2λ
    assert_close(q, best, atol=1e-8)


def test_inverse_stretched_and_folded():
    for sign in (1, -1):
        both = inverse([sign * 0.8, 0, 0 if sign > 0 else np.pi], LENGTHS)
        assert_angles(both, np.tile([0 if sign > 0 else np.pi, 0, 0], (2, 1)), atol=1e-7)
    # exact in binary, so exactly on the boundary: stretched, then folded
    lengths = [0.5, 0.25, 0.125]
    np.testing.assert_array_equal(inverse([0.875, 0, 0], lengths), np.zeros((2, 3)))
    assert not np.any(np.signbit(inverse([0.875, 0, 0], lengths)))
    np.testing.assert_array_equal(
        inverse([0.375, 0, 0], lengths), [[0, np.pi, np.pi], [0, np.pi, np.pi]]
    )
    np.testing.assert_array_equal(
        inverse([0.375, 0, 0], [0.25, 0.5, 0.125]), [[np.pi, np.pi, 0], [np.pi, np.pi, 0]]
    )


@pytest.mark.parametrize("gap", [0.0, *(10.0**-k for k in range(3, 17))])
@pytest.mark.parametrize("lengths", [[0.5, 0.25, 0.125], [0.25, 0.5, 0.125]])
def test_inverse_next_to_its_boundaries(gap, lengths):
    for wrist in (0.75 * (1 - gap), 0.25 * (1 + gap)):
        for angle in (0.0, 0.3, -2.0):
            pose = [wrist * np.cos(angle) + 0.125, wrist * np.sin(angle), 0.0]
            both = inverse(pose, lengths)
            # half-angles keep their digits: a few EPS of a metre, with the wrist's rounding
            assert_close(forward(both, lengths)[:, :2], np.tile(pose[:2], (2, 1)), atol=2e-15)
            assert_angles(forward(both, lengths)[:, 2], np.zeros(2), atol=4 * EPS)


def test_inverse_lets_1e_12_of_the_wrist_s_reach_through():
    lengths = [0.5, 0.25, 0.125]
    for wrist in (0.75 * (1 + 0.9e-12), 0.25 - 0.9e-12 * 0.75):
        both = inverse([wrist + 0.125, 0, 0], lengths)
        assert_close(forward(both, lengths)[:, 0], [wrist + 0.125] * 2, atol=1e-12)
    for wrist in (0.75 * (1 + 1.1e-12), 0.25 - 1.1e-12 * 0.75):
        with pytest.raises(UnreachableError):
            inverse([wrist + 0.125, 0, 0], lengths)


def test_inverse_with_the_wrist_at_the_base():
    # l1 = l2, and the hand just l3 away: folded, θ1 is free and 0, θ3 = φ − π
    both = inverse([[0.125, 0, 0], [-0.125, 0, np.pi]], [0.5, 0.5, 0.125])
    np.testing.assert_array_equal(both[0], [[0, np.pi, np.pi], [0, np.pi, np.pi]])
    # sin π is 1.2e-16, so that the second wrist is not quite there; the hand is all the same
    back = forward(both[1], [0.5, 0.5, 0.125])
    assert_close(back[:, :2], [[-0.125, 0], [-0.125, 0]], atol=4 * EPS)


def test_inverse_wraps_a_heading_of_many_turns():
    plain = inverse([0.4, 0.3, 0.5], LENGTHS)
    wound = inverse([0.4, 0.3, 0.5 + 20 * np.pi], LENGTHS)
    assert_angles(wound, plain, atol=1e-13)  # 0.5 + 20 π is rounded by 7e-15
    assert np.all(np.abs(wound) <= np.pi)


@pytest.mark.parametrize("gap", NEAR_ZERO)
@pytest.mark.parametrize("theta1", [0.0, 0.7, 3.0])
def test_manipulability_keeps_its_digits_next_to_singular(gap, theta1):
    # two links: l1 l2 |sin θ2|, however small
    found = manipulability([theta1, gap], [0.4, 0.3])
    np.testing.assert_allclose(found, 0.12 * np.sin(abs(gap)), rtol=16 * EPS)
    axes, _ = ellipse([theta1, gap], [0.4, 0.3])
    np.testing.assert_allclose(axes[0] * axes[1], 0.12 * np.sin(abs(gap)), rtol=16 * EPS)
    # the larger half-axis of a stretched arm: √(0.7² + 0.3²); it changes with θ2²
    assert_close(axes[0], np.sqrt(0.7**2 + 0.3**2), atol=gap**2 + 2 * EPS)


def test_manipulability_of_arms_on_one_line_is_0():
    assert manipulability([0.7], [0.4]) == 0
    assert manipulability([0.7, 0], [0.4, 0.3]) == 0
    assert manipulability([0.7, 0, 0, 0], [0.4, 0.3, 0.2, 0.1]) == 0
    assert manipulability([0.7, np.pi], [0.4, 0.3]) < EPS  # sin π is 1.2e-16


def test_the_ellipse_of_one_link_is_a_stroke_across_it():
    axes, directions = ellipse([0.7], [0.4])
    assert_close(axes, [0.4, 0], atol=0)
    assert_close(abs(directions[:, 0] @ [-np.sin(0.7), np.cos(0.7)]), 1.0, atol=2 * EPS)


def test_the_ellipse_that_is_a_circle():
    # the well-known isotropic pose: l1 = √2 l2, cos θ2 = −1/√2
    axes, directions = ellipse([0.2, 3 * np.pi / 4], [np.sqrt(2), 1])
    assert_close(axes, [1, 1], atol=4e-8)  # EPS under the square root of a difference
    assert_close(axes[0] * axes[1], 1.0, atol=4 * EPS)
    assert_close(directions.T @ directions, np.eye(2), atol=4 * EPS)


def test_round_angles():
    steps = np.radians(np.arange(-180, 181, 30))
    theta = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1)
    for lengths in ([0.5, 0.5, 0.25], [0.5, 0.25, 0.25], [0.25, 0.5, 1.0]):
        pose = forward(theta, lengths)
        both = inverse(pose, lengths)
        back = forward(both, lengths)
        # near the shell the wrist's rounding shows up once: 8 EPS of 1.75 m
        assert_close(
            back[..., :2], np.broadcast_to(pose[..., None, :2], back[..., :2].shape), 4e-15
        )
        assert_angles(back[..., 2], np.broadcast_to(pose[..., None, 2], back[..., 2].shape), 4e-15)
        assert np.all((both > -np.pi) & (both <= np.pi))
        assert np.all(both[..., 0, 1] >= 0)


# Errors


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        ([0.9, 0, 0], r"pose is out of reach by 0\.1 m: .* 0\.8 m .*, allowed 0\.1 to 0\.7 m"),
        ([0.15, 0, 0], r"pose is out of reach by 0\.05 m"),
        ([[0.8, 0, 0], [0.5, 0, 0], [0, -0.9, -np.pi / 2]], r"pose at index 2 is .* by 0\.1 m"),
    ],
)
def test_out_of_reach(pose, message):
    with pytest.raises(UnreachableError, match=message):
        inverse(pose, LENGTHS)
    both = inverse(pose, LENGTHS, unreachable="nan")
    assert np.all(np.isnan(both[-1] if np.ndim(pose) > 1 else both))
    if np.ndim(pose) > 1:
        np.testing.assert_array_equal(both[:2], inverse(pose[:2], LENGTHS))


def test_an_arm_has_a_link_at_least():
    for lengths in (0.4, []):
        with pytest.raises(RobokinError, match=r"lengths must have shape \(…, n ≥ 1\), got"):
            forward([], lengths)


# Independent oracles


def test_forward_with_50_digits():
    rng = np.random.default_rng(9)
    for n in (1, 2, 3, 5):
        theta, lengths = rng.uniform(-np.pi, np.pi, (60, n)), rng.uniform(0.1, 2, (60, n))
        pose = forward(theta, lengths)
        with mpmath.workdps(50):
            for t, a, found in zip(theta, lengths, pose, strict=True):
                heading, hand = mpmath.mpf(0), mpmath.mpc(0)
                for angle, length in zip(t, a, strict=True):
                    heading += mpmath.mpf(angle)
                    hand += mpmath.mpf(length) * mpmath.expj(heading)
                expected = [float(hand.real), float(hand.imag), float(heading)]
                # headings of up to 5 π round by 8 EPS; 10 m
                assert_close(found, expected, atol=8 * EPS * 10)


@given(arms)
def test_the_ellipse_is_the_svd(arm):
    theta, _, lengths = arm
    U, s, _ = np.linalg.svd(jacobian(theta, lengths)[:2], full_matrices=False)
    s = np.append(s, 0)[:2]  # one link has one singular value
    axes, directions = ellipse(theta, lengths)
    # the SVD is good to a few EPS of the larger value, up to 30 m
    assert_close(axes, s, atol=64 * EPS * s[0] * (1 + s[0] / (s[0] - s[1] + 1e-6)))
    # directions are as sharp as the values are apart
    assume(s[0] - s[1] > 1e-3 * s[0])
    aligned = np.abs(np.sum(directions[:, 0] * U[:, 0]))
    assert_close(aligned, 1.0, atol=16 * EPS)
    across = abs(directions[0, 0] * U[1, 0] - directions[1, 0] * U[0, 0])
    assert across <= 64 * EPS * s[0] / (s[0] - s[1])


@given(arms)
def test_the_manipulability_is_the_determinant(arm):
    theta, _, lengths = arm
    J = jacobian(theta, lengths)[:2]
    # by Cauchy and Binet det(J Jᵀ) is the sum of all 2×2 minors of J, squared
    minors = J[0, :, None] * J[1] - J[0] * J[1, :, None]
    expected = np.sqrt(0.5 * np.sum(minors**2))
    assert_close(manipulability(theta, lengths), expected, atol=16 * EPS * 900)  # 30 m · 30 m


def test_the_round_trip_of_the_inverse_with_50_digits():
    rng = np.random.default_rng(12)
    theta, lengths = rng.uniform(-np.pi, np.pi, (300, 3)), rng.uniform(0.1, 2, (300, 3))
    pose = forward(theta, lengths)
    both = inverse(pose, lengths)
    worst = 0
    with mpmath.workdps(50):
        for p, a, solutions in zip(pose, lengths, both, strict=True):
            for t in solutions:
                heading, hand = mpmath.mpf(0), mpmath.mpc(0)
                for angle, length in zip(t, a, strict=True):
                    heading += mpmath.mpf(angle)
                    hand += mpmath.mpf(length) * mpmath.expj(heading)
                gap = abs(hand - mpmath.mpc(p[0], p[1])) / sum(a)
                turned = abs(mpmath.sin((heading - mpmath.mpf(p[2])) / 2)) * 2
                worst = max(worst, gap, turned)
    assert worst <= 1e-14  # as for the elbow arm, in general; φ itself is up to 9.4 rad
