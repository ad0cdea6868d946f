"""robokin.elbow_arm: the three-joint arm, its four branches and its workspace."""

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from support import EPS, NEAR_ZERO, assert_angles, assert_close, reals, vectors

from robokin.elbow_arm import (
    forward,
    inverse,
    joint_positions,
    nearest_reachable,
    on_base_axis,
    reach,
)
from robokin.errors import UnreachableError
from robokin.frames import dh

links = reals(0.05, 2)
heights = reals(-1, 1)
joints = vectors(3, -np.pi, np.pi).map(np.array)
points = vectors(3, -5, 5).map(np.array)
powers = reals(-8, 8).map(lambda k: 2.0 ** round(k))

A2, A3, D1 = 0.4, 0.3, 0.2

# the signs of theta3 in the four rows: facing up, facing down, away up, away down
SIGNS = np.array([-1, 1, 1, -1])


def sample(rng, size, distance=None):
    """Random links (ratios up to 100) and a point within reach of each, at `distance` if given."""
    a2, a3 = 10 ** rng.uniform(-1, 1, (2, size))
    low, high = reach(a2, a3)
    d = rng.uniform(low, high) if distance is None else distance(low, high)
    direction = rng.normal(size=(size, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    return direction * d[:, None], a2, a3


# Laws


@given(joints, links, links, heights)
def test_every_branch_leads_back_to_the_point(theta, a2, a3, d1):
    p = forward(theta, a2, a3, d1)
    # 2e-14 a metre of reach; lengths of 4 m and a base 1 m off round p itself by 5 m * EPS
    atol = 2e-14 * (a2 + a3) + 4 * EPS * (a2 + a3 + abs(d1))
    branches = inverse(p, a2, a3, d1)
    assert_close(forward(branches, a2, a3, d1), np.tile(p, (4, 1)), atol=atol)


@given(joints, links, links, heights)
def test_the_angles_that_were_put_in_are_one_branch(theta, a2, a3, d1):
    r = a2 * np.cos(theta[1]) + a3 * np.cos(theta[1] + theta[2])
    assume(abs(np.sin(theta[2])) > 0.05)
    assume(abs(r) > 0.05 * (a2 + a3))
    branches = inverse(forward(theta, a2, a3, d1), a2, a3, d1)
    # which one follows from the signs of r and theta3
    row = next(k for k in range(4) if (k < 2) == (r > 0) and SIGNS[k] == np.sign(theta[2]))
    # p is rounded at 5 m * EPS; dividing by sin > 0.05, r > 0.05 (a2 + a3) and, where the wrist
    # is close to the shoulder, once more by d > r, gives 1e-12 at the worst links
    assert_angles(branches[row], theta, atol=1e-11)


@given(joints, links, links, heights)
def test_the_order_of_the_branches(theta, a2, a3, d1):
    p = forward(theta, a2, a3, d1)
    branches = inverse(p, a2, a3, d1)
    assert np.all(branches[:, 2] * SIGNS >= 0)
    assert np.all((branches[:, :2] > -np.pi) & (branches[:, :2] <= np.pi))
    assert np.all(np.abs(branches[:, 2]) <= np.pi)
    assert not np.any(np.signbit(branches) & (branches == 0))  # 0, not -0, which prints badly
    r = a2 * np.cos(branches[:, 1]) + a3 * np.cos(branches[:, 1] + branches[:, 2])
    slack = 1e-13 * (a2 + a3)  # r is 0 but for rounding where the point is on the axis
    assert np.all(r[:2] >= -slack)
    assert np.all(r[2:] <= slack)


@given(joints, links, links)
def test_up_is_above_the_line_from_shoulder_to_wrist(theta, a2, a3):
    p = forward(theta, a2, a3)
    assume(np.hypot(p[0], p[1]) > 1e-6)
    _, shoulder, elbow, wrist = np.moveaxis(
        joint_positions(inverse(p, a2, a3), a2, a3), -2, 0
    )  # each (4, 3)
    outward = p[:2] / np.hypot(p[0], p[1])
    along, over = (wrist - shoulder)[:, :2] @ outward, (elbow - shoulder)[:, :2] @ outward
    above = along * elbow[:, 2] - over * wrist[:, 2]  # twice the signed area of the triangle
    slack = 1e-13 * (a2 + a3) ** 2  # on one line the area is rounding
    assert np.all(above * [1, -1, 1, -1] >= -slack)


@given(joints, links, links, heights)
def test_away_is_the_same_arm_seen_from_behind(theta, a2, a3, d1):
    p = forward(theta, a2, a3, d1)
    facing, away = np.split(inverse(p, a2, a3, d1), 2)
    # π - θ2 and θ1 + π round once, π itself is 1.2e-16 off
    assert_angles(away[:, 0], facing[:, 0] + np.pi, atol=4 * EPS)
    if np.linalg.norm(p - [0, 0, d1]) > 0:
        assert_angles(away[:, 1], np.pi - facing[:, 1], atol=4 * EPS)
    np.testing.assert_array_equal(away[:, 2], -facing[:, 2])


@given(joints, links, links, heights, powers)
def test_only_proportions_matter(theta, a2, a3, d1, scale):
    p = forward(theta, a2, a3, d1)
    # a power of two scales without rounding, so that every digit stays
    np.testing.assert_array_equal(
        inverse(scale * p, scale * a2, scale * a3, scale * d1), inverse(p, a2, a3, d1)
    )
    # but for numbers below 1e-307, which lose digits: a subnormal height is as good as none
    larger = forward(theta, scale * a2, scale * a3, scale * d1)
    assert_close(larger, scale * p, atol=1e-300)


@given(joints, links, links, heights)
def test_the_links_keep_their_lengths(theta, a2, a3, d1):
    base, shoulder, elbow, wrist = joint_positions(theta, a2, a3, d1)
    np.testing.assert_array_equal(base, [0, 0, 0])
    np.testing.assert_array_equal(shoulder, [0, 0, d1])
    # coordinates up to 5 m, a few roundings
    assert_close(np.linalg.norm(elbow - shoulder), a2, atol=32 * EPS)
    assert_close(np.linalg.norm(wrist - elbow), a3, atol=32 * EPS)
    assert_close(wrist, forward(theta, a2, a3, d1), atol=16 * EPS)
    # the arm stays in one vertical plane, that of theta1
    normal = [-np.sin(theta[0]), np.cos(theta[0]), 0]
    assert_close([elbow @ normal, wrist @ normal], [0, 0], atol=16 * EPS)


@given(points, links, links, heights, joints)
def test_no_point_within_reach_is_nearer(p, a2, a3, d1, theta):
    nearest = nearest_reachable(p, a2, a3, d1)
    branches = inverse(nearest, a2, a3, d1)  # does not raise
    # the nearest point is on the boundary, where 1e-12 of the reach is let through
    assert_close(forward(branches, a2, a3, d1)[0], nearest, atol=2e-12 * (a2 + a3))
    other = forward(theta, a2, a3, d1)
    assert np.linalg.norm(p - nearest) <= np.linalg.norm(p - other) + 64 * EPS  # 9 m of rounding


@given(joints, links, links, heights)
def test_a_point_well_within_reach_is_its_own_nearest(theta, a2, a3, d1):
    p = forward(theta, a2, a3, d1)
    low, high = reach(a2, a3)
    d = np.linalg.norm(p - [0, 0, d1])
    assume(low + 1e-9 < d < high - 1e-9)
    np.testing.assert_array_equal(nearest_reachable(p, a2, a3, d1), p)


# The numbers of the hand solution


def test_a_right_angle_at_the_elbow():
    # links 4 and 3, target at distance 5 (3-4-5 triangle), 0.2 m above the base, over x = y
    q = 0.3 / np.sqrt(2)
    branches = inverse([q, q, 0.2 + 0.4], 0.4, 0.3, d1=0.2)
    low = 2 * np.arctan2(0.4, 0.3) - np.pi / 2  # the elbow mirrored in the line to the wrist
    expected = np.array(
        [
            [np.pi / 4, np.pi / 2, -np.pi / 2],  # upper link upright, forearm level
            [np.pi / 4, low, np.pi / 2],
            [-3 * np.pi / 4, np.pi / 2, np.pi / 2],
            [-3 * np.pi / 4, np.pi - low, -np.pi / 2],
        ]
    )
    assert_close(branches, expected, atol=8 * EPS)


def test_an_equilateral_triangle():
    # a2 = a3 = distance: the elbow turns by 120°, the upper link 60° off the line to the wrist
    degrees = np.degrees(inverse([0, -1, 0], 1, 1))
    expected = [[-90, 60, -120], [-90, -60, 120], [90, 120, 120], [90, -120, -120]]
    assert_close(degrees, expected, atol=180 * 4 * EPS)


def test_forward_by_hand():
    # exercise 1: r = a2 cos θ2 + a3 cos(θ2 + θ3) = 0.4 · √3/2 + 0.3 · 1, θ1 = 90°: y = r
    p = forward(np.radians([90, 30, -30]), 0.4, 0.3, 0.1)
    assert_close(p, [0, 0.2 * np.sqrt(3) + 0.3, 0.1 + 0.2], atol=4 * EPS)


def test_joint_positions_by_hand():
    # turned to y, upper link upright, forearm level
    arm = joint_positions([np.pi / 2, np.pi / 2, -np.pi / 2], 0.4, 0.3, 0.1)
    expected = [[0, 0, 0], [0, 0, 0.1], [0, 0, 0.5], [0, 0.3, 0.5]]
    assert_close(arm, expected, atol=2 * EPS)


def test_reach_by_hand():
    low, high = reach([0.4, 0.3], [0.3, 0.4])
    assert_close(low, [0.1, 0.1], atol=EPS)
    assert_close(high, [0.7, 0.7], atol=EPS)


def test_nearest_by_hand():
    # 3-4-5 again: from 5 m away down to 0.7, from 0.05 up to 0.1, the shoulder 0.2 m up
    far = nearest_reachable([3, 0, 4 + 0.2], 0.4, 0.3, 0.2)
    assert_close(far, [0.42, 0, 0.56 + 0.2], atol=4 * EPS)
    near = nearest_reachable([0, -0.03, 0.04 + 0.2], 0.4, 0.3, 0.2)
    assert_close(near, [0, -0.06, 0.08 + 0.2], atol=4 * EPS)


# Singular and boundary cases


@pytest.mark.parametrize("zero", [[0.0, 0.0], [-0.0, 0.0], [0.0, -0.0], [-0.0, -0.0]])
def test_on_the_base_axis_theta1_is_0_and_pi(zero):
    p = [*zero, 0.6]
    branches = inverse(p, A2, A3, D1)
    np.testing.assert_array_equal(branches[:, 0], [0, 0, np.pi, np.pi])
    assert not np.any(np.signbit(branches[:, 0]))
    assert_close(forward(branches, A2, A3, D1), np.tile(p, (4, 1)), atol=4 * EPS)


@pytest.mark.parametrize("gap", NEAR_ZERO)
def test_next_to_the_base_axis_theta1_keeps_its_digits(gap):
    branches = inverse([0.6 * gap, 0.8 * gap, 0.6], A2, A3, D1)
    facing = np.arctan2(0.8, 0.6) - np.pi * (gap < 0)
    assert_angles(branches[:, 0], facing + np.pi * np.array([0, 0, 1, 1]), atol=4 * EPS)


@pytest.mark.parametrize("y", [0.0, -0.0, -5e-324, -1e-300, -1e-20])
def test_straight_behind_theta1_is_pi_and_not_minus_pi(y):
    branches = inverse([-0.5, y, 0.2], A2, A3)
    np.testing.assert_allclose(branches[:, 0], [np.pi, np.pi, 0, 0], rtol=0, atol=2e-20)
    assert branches[0, 0] == np.pi
    away = inverse([0.5, -y, 0.2], A2, A3)[:, 0]
    np.testing.assert_allclose(away, [0, 0, np.pi, np.pi], rtol=0, atol=2e-20)
    assert away[2] == np.pi


@pytest.mark.parametrize("side", [1, -1])
def test_theta2_is_wrapped_on_both_sides(side):
    # almost folded under a long forearm, the wrist over or under the shoulder: the upper link
    # points back beyond ±π and comes out on the other side
    branches = inverse([0.01, 0, 0.31 * side], 0.3, 0.6)
    elevation, d = np.arctan2(0.31 * side, 0.01), np.hypot(0.01, 0.31)
    lift = np.arccos((0.3**2 + d**2 - 0.6**2) / (2 * 0.3 * d))  # law of cosines, 158°
    up, down = elevation + lift, elevation - lift
    assert max(up, -down) > np.pi
    # arccos at 158° passes its rounding on 2.7 times
    assert_angles(branches[:, 1], np.array([up, down, np.pi - up, np.pi - down]), atol=8 * EPS)
    assert np.all(np.abs(branches[:, 1]) <= np.pi)


def test_theta2_is_pi_and_not_minus_pi():
    # folded, wrist straight ahead: with a3 > a2 the upper link points back, θ2 = π in all rows
    # that face it and 0 in the others; and the other way round where a2 > a3
    np.testing.assert_array_equal(
        inverse([0.25, 0, 0], 0.25, 0.5),
        [[0, np.pi, -np.pi], [0, np.pi, np.pi], [np.pi, 0, np.pi], [np.pi, 0, -np.pi]],
    )
    np.testing.assert_array_equal(
        inverse([0.25, 0, 0], 0.5, 0.25),
        [[0, 0, -np.pi], [0, 0, np.pi], [np.pi, np.pi, np.pi], [np.pi, np.pi, -np.pi]],
    )
    np.testing.assert_array_equal(
        inverse([0.75, 0, -0.0], 0.5, 0.25),
        [[0, 0, 0], [0, 0, 0], [np.pi, np.pi, 0], [np.pi] * 2 + [0]],
    )


@pytest.mark.parametrize("gap", [0.0, *(10.0**-k for k in range(3, 17))])
@pytest.mark.parametrize("direction", [[1, 0, 0], [0, 0, 1], [0, 0, -1], [-0.48, 0.6, 0.64]])
def test_stretched_and_next_to_it(gap, direction):
    p = np.array(direction) * 0.7 * (1 - gap)
    branches = inverse(p, A2, A3)
    # 2e-15 a metre within 1e-6 of full stretch, everywhere along this ray
    assert_close(forward(branches, A2, A3), np.tile(p, (4, 1)), atol=2e-15 * 0.7)
    # near θ3 = 0 the distance falls by a2 a3 θ3² / (2 (a2 + a3)), which is 0.7 gap
    square = gap * 0.7**2 * 2 / (A2 * A3)
    # the next term of the curve; and the rounding of p and of its distance by 4 EPS in all
    rounding = 4 * EPS * 0.7**2 * 2 / (A2 * A3)
    assert_close(branches[:, 2] ** 2, np.full(4, square), atol=square**2 + rounding)


@pytest.mark.parametrize("gap", [0.0, *(10.0**-k for k in range(3, 17))])
@pytest.mark.parametrize(("a2", "a3"), [(0.4, 0.3), (0.3, 0.4)])
def test_folded_and_next_to_it(gap, a2, a3):
    p = np.array([0.36, -0.48, 0.8]) * 0.1 * (1 + gap) + [0, 0, D1]
    branches = inverse(p, a2, a3, D1)
    # 2e-14 a metre, and p is within 1e-16 of the shell, 1e-12 of the reach being let through
    assert_close(forward(branches, a2, a3, D1), np.tile(p, (4, 1)), atol=2e-14)
    assert np.all(np.pi - np.abs(branches[:, 2]) < 0.1)
    np.testing.assert_array_equal(np.sign(branches[:, 2]), SIGNS)  # ±π, not wrapped


def test_equal_links_with_the_wrist_at_the_shoulder():
    branches = inverse([0, 0, 0.2], 0.5, 0.5, 0.2)
    expected = [[0, 0, -np.pi], [0, 0, np.pi], [np.pi, 0, np.pi], [np.pi, 0, -np.pi]]
    np.testing.assert_array_equal(branches, expected)
    assert not np.any(np.signbit(branches[:, 1]))
    # in a batch the rows beside it keep their own angles
    batch = inverse([[0.3, 0, 0.6], [-0.0, -0.0, 0.2], [0, 0.3, 0.6]], 0.5, 0.5, 0.2)
    np.testing.assert_array_equal(batch[1], expected)
    assert np.all(batch[[0, 2], :, 1] != 0)


@pytest.mark.parametrize("gap", NEAR_ZERO)
def test_equal_links_with_the_wrist_next_to_the_shoulder(gap):
    p = np.array([0.36, -0.48, 0.8]) * gap
    branches = inverse(p, 0.5, 0.5)
    assert_close(forward(branches, 0.5, 0.5), np.tile(p, (4, 1)), atol=2e-15)
    # the links lie side by side, square to the line to the wrist
    elevation = np.arctan2(0.8 * np.sign(gap), 0.6)
    lift = np.pi / 2 - abs(gap)  # arccos(d / (2 a2)); the next term is d³/6
    assert_angles(branches[:2, 1], elevation + np.array([lift, -lift]), abs(gap) ** 3 + 4 * EPS)


@pytest.mark.parametrize(("a2", "a3"), [(0.4, 0.3), (0.3, 0.4), (5.0, 0.01), (0.5, 0.5)])
def test_the_boundaries_let_1e_12_of_the_reach_through(a2, a3):
    low, high = reach(a2, a3)
    direction = np.array([0.36, -0.48, 0.8])
    for d in (high * (1 + 0.9e-12), low - 0.9e-12 * high):
        p = direction * d
        branches = inverse(p, a2, a3)
        # taken to the boundary, which is 0.9e-12 of the reach away
        assert_close(forward(branches, a2, a3), np.tile(p, (4, 1)), atol=1e-12 * high)
    outside = [high * (1 + 1.1e-12)] + [low - 1.1e-12 * high] * (a2 != a3)
    for d in outside:
        with pytest.raises(UnreachableError):
            inverse(direction * d, a2, a3)
        assert np.all(np.isnan(inverse(direction * d, a2, a3, unreachable="nan")))


def test_the_tolerance_itself_is_let_through():
    # along one axis the distance is exact, so that this is the very last float that is
    low, high = reach(0.5, 0.25)
    last = high * (1 + 1e-12), low - high * 1e-12
    assert np.all(np.isfinite(inverse([last[0], 0, 0], 0.5, 0.25)))
    assert np.all(np.isfinite(inverse([0, 0, last[1]], 0.5, 0.25)))
    for beyond in (np.nextafter(last[0], 9), np.nextafter(last[1], 0)):
        with pytest.raises(UnreachableError):
            inverse([0, beyond, 0], 0.5, 0.25)


def test_round_angles():
    steps = np.radians(np.arange(-180, 181, 15))
    theta = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1)
    for a2, a3 in [(0.5, 0.5), (0.5, 0.25), (0.25, 0.5)]:
        p = forward(theta, a2, a3, D1)
        branches = inverse(p, a2, a3, D1)
        back = forward(branches, a2, a3, D1)
        assert_close(back, np.broadcast_to(p[..., None, :], back.shape), atol=4e-15)
        assert np.all(branches[..., :2] > -np.pi)
        assert np.all(branches[..., :2] <= np.pi)
        assert np.all(branches[..., 2] * SIGNS >= 0)


def test_nearest_at_the_shoulder_is_along_x():
    np.testing.assert_array_equal(nearest_reachable([0, 0, 0.5], 0.5, 0.25, 0.5), [0.25, 0, 0.5])
    np.testing.assert_array_equal(nearest_reachable([0, 0, 0.5], 0.5, 0.5, 0.5), [0, 0, 0.5])


def test_a_point_on_the_boundary_is_its_own_nearest():
    # at |a2 - a3| and at a2 + a3; moved along its ray each would change in the last digit
    for p in ([0.15, 0.2, 0], [0.45, 0, 0.6]):
        np.testing.assert_array_equal(nearest_reachable(p, 0.5, 0.25), p)


@pytest.mark.parametrize("size", [5e-324, 1e-310, 1e-200, 1e-16, 1e16, 1e200, 1e307])
def test_nearest_of_very_near_and_very_far_points(size):
    low, high = reach(A2, A3)
    p = nearest_reachable(size * np.array([2, -2, 1]), A2, A3)
    expected = np.array([2, -2, 1]) / 3 * (high if size > 1 else low)
    assert_close(p, expected, atol=4 * EPS)


@pytest.mark.parametrize("k", range(3, 17))
def test_on_base_axis(k):
    near = 1.5 * 10.0**-k  # from the axis; the default tolerance is 1e-9
    p = np.array([[0.6, -0.8, 5.0], [-0.6, 0.8, -5.0]]) * [near, near, 1]
    np.testing.assert_array_equal(on_base_axis(p), [k > 9] * 2)
    np.testing.assert_array_equal(on_base_axis(p, tol=1.01 * near), [True, True])
    np.testing.assert_array_equal(on_base_axis(p, tol=0.99 * near), [False, False])


def test_on_base_axis_at_the_tolerance_itself():
    assert on_base_axis([0, 0.25, 7], tol=0.25)
    assert on_base_axis([0, 0, 7])
    assert not on_base_axis([0, np.nextafter(0.25, 1), 7], tol=0.25)
    assert isinstance(on_base_axis([0, 0, 7]), np.bool_)
    np.testing.assert_array_equal(on_base_axis([3, 4, 0], tol=[4, 6]), [False, True])


def test_the_shoulder_case_in_a_batch_of_arms():
    # the point is at the shoulder of the second arm only, which has equal links
    out = inverse([0, 0, 0.5], [0.4, 0.5], [0.2, 0.5], [0, 0.5])
    np.testing.assert_array_equal(out[1, :, 1], 0)
    out = inverse([0, 0, 0], [[0.5], [0.6]], [0.5, 0.6], unreachable="nan")
    np.testing.assert_array_equal(np.isnan(out).all(axis=(-2, -1)), [[False, True], [True, False]])
    np.testing.assert_array_equal(out[[0, 1], [0, 1], :, 1], 0)


# Errors


@pytest.mark.parametrize(
    ("p", "message"),
    [
        ([1.0, 0, 0.2], r"p is out of reach by 0\.3 m: .* 1 m from .*, allowed 0\.1 to 0\.7 m"),
        ([0.0, 0, 0.23], r"p is out of reach by 0\.07 m: .* 0\.03 m from .*"),
        ([0.7 + 2e-7, 0, 0.2], r"by 2e-07 m: .* 0\.7000002 m from .* to 0\.7 m"),
        ([[0.5, 0, 0.2], [0, 0.9, 0.2], [2, 0, 0]], r"p at index 1 is out of reach by 0\.2 m"),
        (
            [[[0.5, 0, 0.2], [0.2, 0, 0.2]], [[0.3, 0, 0.2], [0, 0, 0.2]]],
            r"p at index 1, 1 is .* by 0\.1 m",
        ),
    ],
)
def test_out_of_reach(p, message):
    with pytest.raises(UnreachableError, match=message):
        inverse(p, 0.4, 0.3, 0.2)
    out = inverse(p, 0.4, 0.3, 0.2, unreachable="nan")
    d = np.linalg.norm(np.array(p) - [0, 0, 0.2], axis=-1)
    bad = (d > 0.7) | (d < 0.1 - EPS)
    np.testing.assert_array_equal(np.isnan(out), np.broadcast_to(bad[..., None, None], out.shape))


def test_the_message_names_the_arm_of_a_batch():
    with pytest.raises(UnreachableError, match=r"p at index 2 is .* by 0\.1 m.*0\.2 to 0\.4 m"):
        inverse([0.5, 0, 0], [0.4, 0.3, 0.3], [0.2, 0.2, 0.1])


# Independent oracles


def mp_forward(theta, a2, a3):
    t1, t2, t3 = map(mpmath.mpf, theta)
    r = a2 * mpmath.cos(t2) + a3 * mpmath.cos(t2 + t3)
    z = a2 * mpmath.sin(t2) + a3 * mpmath.sin(t2 + t3)
    return [r * mpmath.cos(t1), r * mpmath.sin(t1), z]


def worst_round_trip(p, a2, a3):
    """The largest distance of IK → FK, a metre of reach, over all branches; FK with 50 digits."""
    worst = mpmath.mpf(0)
    with mpmath.workdps(50):
        for point, b2, b3, branches in zip(p, a2, a3, inverse(p, a2, a3), strict=True):
            b2, b3 = mpmath.mpf(b2), mpmath.mpf(b3)
            for theta in branches:
                back = mp_forward(theta, b2, b3)
                gap = mpmath.norm([u - mpmath.mpf(v) for u, v in zip(back, point, strict=True)])
                worst = max(worst, gap / (b2 + b3))
    return float(worst)


def test_the_round_trip_with_50_digits():
    rng = np.random.default_rng(1)
    assert worst_round_trip(*sample(rng, 400)) <= 2e-14
    # down to the fold, too
    fold = sample(rng, 400, lambda low, high: low + (high - low) * 10 ** rng.uniform(-17, 0, 400))
    assert worst_round_trip(*fold) <= 2e-14


def test_the_round_trip_within_1e_6_of_full_stretch_with_50_digits():
    rng = np.random.default_rng(2)
    stretch = sample(rng, 500, lambda low, high: high * (1 - 10 ** rng.uniform(-16, -6, 500)))
    assert worst_round_trip(*stretch) <= 2e-15
    # in the directions where products vanish, the distance itself is exact
    high = np.full(45, 0.75)
    d = np.repeat(high * (1 - 10.0 ** -np.linspace(6, 16, 45)), 3)
    p = d[:, None] * np.tile(np.eye(3), (45, 1))
    assert worst_round_trip(p, np.full(135, 0.5), np.full(135, 0.25)) <= 2e-15


@given(links, links, reals(-15.5, -0.1), st.booleans(), st.booleans())
def test_any_links_keep_the_digits_of_the_distance(a2, a3, power, stretched, up):
    """Next to both edges of the workspace, with 60 digits; on an axis d is exact."""
    low, high = reach(a2, a3)
    d = float(high - 10**power * min(a2, a3) if stretched else low + 10**power * min(a2, a3))
    assume(low < d < high)
    p = [0, 0, d] if up else [d, 0, 0]
    with mpmath.workdps(60):
        b2, b3, apart = map(mpmath.mpf, (a2, a3, d))
        bend = mpmath.acos((apart**2 - b2**2 - b3**2) / (2 * b2 * b3))
        lift = mpmath.acos((b2**2 + apart**2 - b3**2) / (2 * b2 * apart))
    theta2, theta3 = inverse(p, a2, a3)[1, 1:]
    assert theta3 == pytest.approx(float(bend), rel=2 * EPS, abs=0)
    if not up:  # else it is a right angle less, and rounded as that is
        assert theta2 == pytest.approx(-float(lift), rel=2 * EPS, abs=0)


def test_the_angles_against_the_law_of_cosines_with_50_digits():
    rng = np.random.default_rng(3)
    p, a2, a3 = sample(
        rng, 200, lambda low, high: low + (high - low) * rng.uniform(0.02, 0.98, 200)
    )
    out = inverse(p, a2, a3)
    with mpmath.workdps(50):
        for point, b2, b3, branches in zip(p, a2, a3, out, strict=True):
            x, y, z = map(mpmath.mpf, point)
            b2, b3 = mpmath.mpf(b2), mpmath.mpf(b3)
            r, d = mpmath.sqrt(x * x + y * y), mpmath.sqrt(x * x + y * y + z * z)
            phi1 = mpmath.acos((b2**2 + d**2 - b3**2) / (2 * b2 * d))
            phi2 = mpmath.atan2(z, r)
            bend = mpmath.pi - mpmath.acos((b2**2 + b3**2 - d**2) / (2 * b2 * b3))
            t1 = mpmath.atan2(y, x)
            expected = [
                [t1, phi2 + phi1, -bend],
                [t1, phi2 - phi1, bend],
                [t1 + mpmath.pi, mpmath.pi - phi2 - phi1, bend],
                [t1 + mpmath.pi, mpmath.pi - phi2 + phi1, -bend],
            ]
            # d is rounded by EPS; the angles turn with d/sin of the angles of a triangle that is
            # at least 2 % of its width from flat: 100 EPS, more for links of unequal length
            assert_angles(branches, np.array(expected, dtype=float), atol=1e-12)


@given(joints, links, links, heights)
def test_the_dh_table_agrees_with_the_geometry(theta, a2, a3, d1):
    # theta, d, a, alpha of the three joints
    table = [(theta[0], d1, 0, np.pi / 2), (theta[1], 0, a2, 0), (theta[2], 0, a3, 0)]
    T, origins = np.eye(4), [np.zeros(3)]
    for row in table:
        T = T @ dh(*row)  # Rot z, Trans z, Trans x, Rot x
        origins.append(T[:3, 3])
    # products of cosines in place of cosines of sums, coordinates up to 5 m
    assert_close(joint_positions(theta, a2, a3, d1), np.array(origins), atol=32 * EPS)
    assert_close(forward(theta, a2, a3, d1), T[:3, 3], atol=32 * EPS)


def test_forward_with_50_digits():
    rng = np.random.default_rng(4)
    theta = rng.uniform(-np.pi, np.pi, (200, 3))
    a2, a3 = 10 ** rng.uniform(-1, 1, (2, 200))
    p = forward(theta, a2, a3)
    with mpmath.workdps(50):
        expected = [
            mp_forward(t, mpmath.mpf(b), mpmath.mpf(c))
            for t, b, c in zip(theta, a2, a3, strict=True)
        ]
    error = np.abs(p - np.array(expected, dtype=float)).max(axis=1)
    assert np.all(error <= 4 * EPS * (a2 + a3))  # θ2 + θ3 up to 2π rounds by 2 EPS
