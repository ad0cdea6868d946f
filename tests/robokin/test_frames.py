"""robokin.frames: poses as matrices, their chains, the graph of known frames."""

import itertools
import sys
import threading
import tracemalloc
from functools import reduce

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
from robokin.frames import (
    FrameGraph,
    check_rotation,
    compose,
    dh,
    inverse,
    pose,
    se2,
    se3,
    transform,
)

BLOCK = 4000
mpmath.mp.dps = 50

# Positions reach 10 m in each coordinate; an entry of a product sums three terms of that size,
# 2 EPS * 10 each, and a law passes through up to four products.
ATOL = 1e-13

positions = vectors(3, -10, 10)
planar = st.builds(se2, reals(-10, 10), reals(-10, 10), angles)
spatial = st.builds(se3, rotations, positions)
pairs = st.one_of(st.tuples(planar, planar), st.tuples(spatial, spatial))


def random_se3(seed, *batch):
    rng = np.random.default_rng(seed)
    count = int(np.prod(batch))
    R = Rotation.random(count, rng=rng).as_matrix().reshape(*batch, 3, 3)
    return se3(R, rng.uniform(-10, 10, (*batch, 3)))


def random_se2(seed, *batch):
    rng = np.random.default_rng(seed)
    x, y, theta = rng.uniform(-10, 10, (3, *batch))
    return se2(x, y, theta)


# Laws


@given(st.one_of(planar, spatial))
def test_a_pose_and_its_inverse_cancel(T):
    assert_close(compose(T, inverse(T)), np.eye(len(T)), ATOL)
    assert_close(compose(inverse(T), T), np.eye(len(T)), ATOL)


@given(pairs, st.data())
def test_a_chain_may_be_bracketed_anywhere(pair, data):
    A, B = pair
    C = data.draw(planar if len(A) == 3 else spatial)
    assert_close(compose(A, B, C), compose(A, compose(B, C)), ATOL)
    assert_close(compose(A, B, C), compose(compose(A, B), C), ATOL)


@given(pairs, positions)
def test_a_chain_moves_points_one_pose_after_the_other(pair, point):
    A, B = pair
    p = point[: len(A) - 1]
    assert_close(transform(compose(A, B), p), transform(A, transform(B, p)), ATOL)


@given(planar, planar, positions)
def test_the_plane_is_the_floor_of_space(A, B, point):
    def lifted(T):
        R = np.eye(3)
        R[:2, :2] = T[:2, :2]
        return se3(R, [*T[:2, 2], 0.0])

    assert_close(lifted(compose(A, B)), compose(lifted(A), lifted(B)), ATOL)
    assert_close(lifted(inverse(A)), inverse(lifted(A)), ATOL)
    assert_close(transform(A, point[:2]), transform(lifted(A), [*point[:2], 0.0])[:2], ATOL)


@given(reals(-10, 10), reals(-10, 10), angles)
def test_se2_puts_the_origin_and_the_axes_where_the_pose_says(x, y, theta):
    T = se2(x, y, theta)
    np.testing.assert_array_equal(transform(T, [0, 0]), [x, y])
    # the sum x + cos(theta) is rounded once, below 16 m
    assert_close(transform(T, [1, 0]), [x + np.cos(theta), y + np.sin(theta)], 8 * EPS)
    assert_close(transform(T, [0, 1]), [x - np.sin(theta), y + np.cos(theta)], 8 * EPS)


@given(rotations, positions)
def test_se3_puts_the_origin_and_the_axes_where_the_pose_says(R, p):
    T = se3(R, p)
    np.testing.assert_array_equal(transform(T, [0, 0, 0]), p)
    assert_close(transform(T, np.eye(3)), np.array(p) + R.T, 8 * EPS)  # rounded below 16 m
    np.testing.assert_array_equal(T[3], [0, 0, 0, 1])


@given(rotations)
def test_a_rotation_passes_and_its_mirrors_do_not(R):
    check_rotation(R)
    for mirror in (-R, R * [1, 1, -1], R * [-1, 1, 1], R[[1, 0, 2]]):
        with pytest.raises(RobokinError, match="mirror"):
            check_rotation(mirror)


@given(rotations, st.integers(0, 8), st.sampled_from([1e-3, -1e-3, 1e-5, -1e-5]))
def test_a_rotation_with_one_wrong_entry_does_not_pass(R, entry, error):
    # An error e in one entry shows in x·x, y·y, x·y or x × y by no less than e/√3 (a unit vector
    # has a component that large), less the second order: above the tolerance, 1e-6.
    wrong = R.copy()
    wrong.flat[entry] += error
    with pytest.raises(RobokinError, match="not a rotation"):
        check_rotation(wrong)
    check_rotation(wrong, tol=3 * abs(error))


branches = st.lists(st.tuples(spatial, st.integers(0, 100), st.booleans()), min_size=2, max_size=8)


@given(branches)
def test_the_graph_finds_the_pose_between_any_two_frames_of_a_tree(tree):
    world, parents, downwards = zip(*tree, strict=True)
    graph = FrameGraph()
    for child in range(1, len(world)):
        parent = parents[child] % child
        a, b = (parent, child) if downwards[child] else (child, parent)
        graph.add(f"f{a}", f"f{b}", compose(inverse(world[a]), world[b]))
    for a, b in itertools.product(range(len(world)), repeat=2):
        expected = compose(inverse(world[a]), world[b])
        # a path has up to seven poses of 20 m and more, each with its roundings
        assert_close(graph.get(f"f{a}", f"f{b}"), expected, atol=10 * ATOL)
        path = graph.path(f"f{a}", f"f{b}")
        assert (path[0], path[-1]) == (f"f{a}", f"f{b}")
        assert path == graph.path(f"f{b}", f"f{a}")[::-1]


@given(reals(-10, 10), reals(-10, 10), angles)
def test_the_pose_of_a_matrix_is_what_it_was_made_of(x, y, theta):
    there = pose(se2(x, y, theta))
    assert (there[0], there[1]) == (x, y)
    assert_angles(there[2], theta, atol=4 * EPS)
    assert -np.pi < there[2] <= np.pi


@given(angles, reals(-3, 3), reals(-3, 3), angles)
def test_a_joint_s_frame_is_two_screws_one_after_the_other(theta, d, a, alpha):
    along_z = se3(Rotation.from_rotvec([0, 0, theta]).as_matrix(), [0, 0, d])
    along_x = se3(Rotation.from_rotvec([alpha, 0, 0]).as_matrix(), [a, 0, 0])
    assert_close(dh(theta, d, a, alpha), compose(along_z, along_x), atol=8 * EPS * 3)
    check_rotation(dh(theta, d, a, alpha)[:3, :3], tol=8 * EPS)


# The numbers of the hand solution


def arm(alpha, beta, gamma):
    """Exercise 3: T_bc of the arm, links 0.3 m and 0.4 m, hand frame at the third joint."""
    x = 0.3 * np.cos(alpha) + 0.4 * np.cos(alpha + beta)
    y = 0.3 * np.sin(alpha) + 0.4 * np.sin(alpha + beta)
    return se2(x, y, alpha + beta + gamma)


# Exercise 3 with numbers to do on paper: the arm up and forward again, hand at 0.4, 0.3, turned
# by 90°; the platform at 1, 2 in the camera's frame, turned by 90°. So the hand is at
# 1 − 0.3, 2 + 0.4, turned by 180°; the object at 0.2, 2.0 is 0.5 behind and 0.4 below it, as the
# turned hand sees it at 0.5, 0.4, turned by 270° − 180°.
T_bc = arm(np.pi / 2, -np.pi / 2, np.pi / 2)
T_db = se2(1.0, 2.0, np.pi / 2)
T_de = se2(0.2, 2.0, 3 * np.pi / 2)
T_ce = np.array([[0, -1, 0.5], [1, 0, 0.4], [0, 0, 1]])


def test_hand_numbers_of_the_chain_in_the_plane():
    assert_close(T_bc, [[0, -1, 0.4], [1, 0, 0.3], [0, 0, 1]], atol=EPS)
    assert_close(compose(T_db, T_bc), [[-1, 0, 0.7], [0, -1, 2.4], [0, 0, 1]], atol=4 * EPS)
    # cos(3π/2) and its kin are off by 2e-16 and multiplied by positions up to 2.4
    assert_close(compose(inverse(T_bc), inverse(T_db), T_de), T_ce, atol=8 * EPS)


def test_hand_numbers_of_the_graph():
    graph = FrameGraph()
    graph.add("d", "b", T_db)
    graph.add("d", "e", T_de)
    graph.add("b", "c", T_bc)
    assert graph.frames == ["d", "b", "e", "c"]
    assert graph.path("c", "e") == ["c", "b", "d", "e"]
    assert_close(graph.get("c", "e"), T_ce, atol=8 * EPS)
    assert_close(graph.get("e", "c"), inverse(T_ce), atol=8 * EPS)


def test_hand_numbers_with_a_camera_that_looks_down():
    # The camera hangs 3 m above the room's origin, x as the room's, z down. The platform stands
    # at (1, 1, 0), the object, turned by 90°, at (2, 3, 0.5); y and z count backwards from above.
    down = np.diag([1, -1, -1])
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    T_db = se3(down, [1, -1, 3])
    T_de = se3(down @ quarter, [2, -3, 2.5])
    np.testing.assert_array_equal(
        compose(inverse(T_db), T_de), [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 0.5], [0, 0, 0, 1]]
    )


def test_hand_numbers_of_points():
    # turned by 90° and moved by (1, 2): the point one metre ahead is one metre to the left
    T = se2(1, 2, np.pi / 2)
    assert_close(transform(T, [[0, 0], [1, 0], [0, 1]]), [[1, 2], [1, 3], [0, 2]], atol=2 * EPS)


# Singular and boundary cases


@pytest.mark.parametrize("quarters", range(-4, 5))
def test_round_angles(quarters):
    c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarters % 4]
    # the angle itself is rounded by up to 4.4e-16 at 2π
    assert_close(se2(3, -4, quarters * np.pi / 2), [[c, -s, 3], [s, c, -4], [0, 0, 1]], 4.5e-16)


def test_no_minus_zero_in_the_matrices_of_no_turn():
    for T in (se2(-1.0, -2.0, 0.0), inverse(se2(0, 0, 0)), se3(np.eye(3), [-1, -2, -3])):
        assert not np.signbit(T[T == 0]).any()


@pytest.mark.parametrize("theta", NEAR_ZERO)
def test_small_turns_keep_their_digits(theta):
    T = se2(0, 0, theta)
    assert T[1, 0] == -T[0, 1] == np.sin(theta)
    assert compose(T, T)[1, 0] == pytest.approx(np.sin(2 * theta), rel=4 * EPS)  # two products


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6, 1e12])
def test_positions_of_any_size(size):
    A, B = random_se3(1), random_se3(2)
    A[:3, 3] *= size
    B[:3, 3] *= size
    exact = mp(A) * mp(B)
    # three products and three sums of numbers up to 10 size
    assert_close(compose(A, B)[:3, 3], floats(exact)[:3, 3], atol=60 * EPS * size)
    assert_close(transform(A, transform(inverse(A), B[:3, 3])), B[:3, 3], atol=200 * EPS * size)


def test_products_of_accepted_poses_are_accepted():
    """In single precision, step by step; typed with seven digits, in a chain."""
    step = se2(0.1, 0, 0.3).astype(np.float32)
    turn = np.arctan2(float(step[1, 0]), float(step[0, 0]))
    T = np.eye(3)
    for n in range(1, 1000):
        T = compose(T, step)
        assert_angles(pose(T)[2], n * turn, atol=n * 8 * EPS)
    typed = random_se3(1, 50).round(7)
    chain = compose(*typed)
    assert_close(chain[:3, :3] @ chain[:3, :3].T, np.eye(3), atol=1e-9)  # 50 times 1e-12 and more
    wanted = Rotation.concatenate([Rotation.from_matrix(T[:3, :3]) for T in typed])
    product = wanted[0]
    for rotation in wanted[1:]:
        product = product * rotation
    assert_close(compose(inverse(chain), chain), np.eye(4), atol=1e-9)
    assert_close(chain[:3, :3], product.as_matrix(), atol=1e-9)  # SciPy takes the nearest, too


def test_what_is_mended_touches_no_other_matrix():
    R = Rotation.random(1000, rng=1).as_matrix()
    mixed = R.copy()
    mixed[3] = R[3].astype(np.float32)
    T = se3(mixed, [0, 0, 0])
    np.testing.assert_array_equal(np.delete(T, 3, 0), np.delete(se3(R, [0, 0, 0]), 3, 0))
    assert_close(T[3, :3, :3] @ T[3, :3, :3].T, np.eye(3), atol=1e-12)
    assert_close(T[3, :3, :3], R[3], atol=1e-7)
    check_rotation(R.astype(np.float32))


def test_a_graph_neither_hands_out_nor_keeps_the_callers_array():
    T = se2(1, 2, 3)
    kept = T.copy()
    graph = FrameGraph()
    graph.add("a", "b", T)
    graph.get("a", "b")[0, 2] = 7
    T[0, 2] = 7
    np.testing.assert_array_equal(graph.get("a", "b"), kept)


# x, y the first two columns, z the third: how an error e in one place shows, at the tolerance
@pytest.mark.parametrize("e", [0.9e-6, -0.9e-6])
@pytest.mark.parametrize(
    "error",
    [
        lambda e: np.diag([1 + e / 2, 1, 1 + e / 2]),  # x·x = 1 + e
        lambda e: np.diag([1, 1 + e / 2, 1 + e / 2]),  # y·y = 1 + e
        lambda e: np.array([[1, e, 0], [0, 1, 0], [0, 0, 1]]),  # x·y = e
        lambda e: np.array([[1, 0, e], [0, 1, 0], [0, 0, 1]]),  # z off x × y by e
        lambda e: np.array([[1, 0, 0], [0, 1, e], [0, 0, 1]]),
        lambda e: np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1 + e]]),
        lambda e: np.array([[1 + e / 2, 0], [0, 1 + e / 2]]),  # in the plane: x·x = 1 + e
        lambda e: np.array([[1, e], [0, 1]]),  # y off x turned left by e
        lambda e: np.array([[1, 0], [0, 1 + e]]),
    ],
)
def test_the_tolerance(e, error):
    check_rotation(error(e))
    with pytest.raises(RobokinError, match=r"off by 1\.1\de-06 .* allowed 1e-06"):
        check_rotation(error(e * 1.25))
    check_rotation(error(e * 1.25), tol=2e-6)
    with pytest.raises(RobokinError, match="allowed 1e-07"):
        check_rotation(error(e), tol=1e-7)


@pytest.mark.parametrize("column", range(4))
@pytest.mark.parametrize("sign", [1, -1])
def test_the_tolerance_of_the_last_row(column, sign):
    T = random_se3(3)
    T[3, column] += sign * 0.9e-6
    inverse(T)
    T[3, column] += sign * 0.3e-6
    with pytest.raises(RobokinError, match=r"0, …, 0, 1 as its last row, got \["):
        inverse(T)


@pytest.mark.parametrize(
    "matrix",
    [
        np.zeros((3, 3)),
        np.ones((3, 3)),
        2 * np.eye(3),
        np.diag([1, 1, 0]),
        np.diag([1, 2, 0.5]),
        np.diag([1e200, 1, 1]),
        np.diag([1, 1e200, 1]),
        np.diag([1, 1, 1e200]),
        np.full((3, 3), 1e300),
    ],
)
def test_what_is_far_from_a_rotation(matrix):
    for refuses in (check_rotation, lambda R: se3(R, [0, 0, 0])):
        with pytest.raises(RobokinError, match="is not a rotation"):
            refuses(matrix)
    with pytest.raises(RobokinError, match="is not a rotation"):
        check_rotation(matrix[:2, :2] + np.array([[0, 0], [0, 1]]))


@pytest.mark.parametrize("index", [0, 1, BLOCK - 1, BLOCK, 2 * BLOCK + 7])
def test_the_first_bad_one_in_a_long_batch_is_found(index):
    R = np.broadcast_to(np.eye(3), (3 * BLOCK, 3, 3)).copy()
    R[index, 0, 1] = 0.25
    R[index + 1 :, 0, 1] = 0.5
    with pytest.raises(RobokinError, match=rf"R at index {index} is not .* off by 0\.25 "):
        check_rotation(R)


def test_the_first_bad_one_in_a_batch_of_two_dimensions_is_found():
    T = random_se3(5, BLOCK + 3, 4)
    T[BLOCK + 1, 2] = np.diag([1, 1, -1, 1])
    T[BLOCK + 2, 0] = np.diag([2, 1, 1, 1])
    message = rf"T at index {BLOCK + 1}, 2 is not a rotation \(a mirror"
    with pytest.raises(RobokinError, match=message):
        inverse(T)


def test_a_frame_seen_from_itself():
    graph = FrameGraph()
    graph.add("a", "b", se3(np.eye(3), [1, 2, 3]))
    np.testing.assert_array_equal(graph.get("b", "b"), np.eye(4))
    assert graph.path("b", "b") == ["b"]


@pytest.mark.skipif(sys.platform == "emscripten", reason="a browser's Python has no threads")
def test_one_thread_adds_while_others_ask():
    """A star that grows, and a chain: what is known of a frame is right at once."""
    graph = FrameGraph()
    graph.add("f0", "c0", se2(0, 1, 0))

    def add():
        for n in range(1, 400):
            graph.add("f0", f"f{n}", se2(n, 0, 0))
            graph.add(f"c{n - 1}", f"c{n}", se2(0, 1, 0))

    thread, interval = threading.Thread(target=add), sys.getswitchinterval()
    sys.setswitchinterval(1e-6)  # or the threads hardly ever meet
    try:
        thread.start()
        while thread.is_alive():
            for name in graph.frames[-3:]:
                x, y, _ = pose(graph.get("f0", name))
                n = int(name[1:])
                assert (x, y) == ((n, 0) if name[0] == "f" else (0, n + 1))
    finally:
        sys.setswitchinterval(interval)
        thread.join()


def test_the_shortest_path_is_taken_and_a_closing_pair_shortens_it():
    graph = FrameGraph()
    world = random_se2(7, 5)
    for a in range(4):
        graph.add(str(a), str(a + 1), compose(inverse(world[a]), world[a + 1]))
    assert graph.path("0", "4") == ["0", "1", "2", "3", "4"]
    graph.add("4", "0", compose(inverse(world[4]), world[0]))
    assert graph.path("0", "4") == ["0", "4"]
    assert graph.path("0", "3") == ["0", "4", "3"]
    assert_close(graph.get("0", "3"), compose(inverse(world[0]), world[3]), ATOL)


def test_the_first_of_two_equal_pairs_stays():
    graph = FrameGraph()
    graph.add("a", "b", se2(1, 2, 0.0))
    graph.add("a", "b", se2(1 + 1e-7, 2, 0.0))
    graph.add("b", "a", se2(-1, -2 + 1e-7, 0.0))
    np.testing.assert_array_equal(graph.get("a", "b"), se2(1, 2, 0.0))
    np.testing.assert_array_equal(graph.get("b", "a"), se2(-1, -2, 0.0))


# What a graph that knows a–b–c (1 m, then 2 m along x) says to a–c off by e in x: compared
# directly, backwards, and far away, where the limit is 1e-9 of the largest coordinate
@pytest.mark.parametrize(("far", "limit"), [(1.0, 1e-6), (1e3, 3e-6), (250e3, 750e-6)])
@pytest.mark.parametrize("sign", [1, -1])
def test_the_tolerance_of_a_contradiction(far, limit, sign):
    def graph():
        graph = FrameGraph()
        graph.add("a", "b", se2(far, 0, 0))
        graph.add("b", "c", se2(2 * far, 0, 0))
        return graph

    agrees, contradicts = sign * 0.9 * limit, sign * 1.1 * limit
    graph().add("a", "c", se2(3 * far + agrees, 0, 0))
    graph().add("c", "a", se2(-3 * far + agrees, 0, 0))
    graph().add("a", "b", se2(far + agrees / 3, 0, 0))
    for a, b, x in (("a", "c", 3 * far), ("c", "a", -3 * far), ("a", "b", far)):
        with pytest.raises(RobokinError, match=r"off by [1-3]\.\d+e-06, allowed 1e-06"):
            graph().add(a, b, se2(x + contradicts, 0, 0))


@pytest.mark.parametrize("far", [1.0, 250e3])
def test_rotations_are_compared_wherever_they_are(far):
    graph = FrameGraph()
    graph.add("map", "car", se2(far, 0, 0))
    graph.add("car", "lidar", se2(0, 0, 0))
    graph.add("map", "lidar", se2(far, 0, 0.9e-6))
    for theta in (2e-6, np.pi / 4):
        with pytest.raises(RobokinError, match="contradicts"):
            graph.add("map", "lidar", se2(far, 0, theta))


def test_small_poses_are_compared_by_the_metre():
    graph = FrameGraph()
    graph.add("a", "b", se2(0, 0, 0))
    graph.add("a", "b", se2(0.9e-6, 0, 0))
    with pytest.raises(RobokinError, match="contradicts"):
        graph.add("a", "b", se2(1.1e-6, 0, 0))


def test_batches_in_a_graph():
    T, U = random_se3(1, 6), random_se3(2)
    graph = FrameGraph()
    graph.add("a", "b", T)
    graph.add("b", "c", U)
    np.testing.assert_array_equal(graph.get("a", "c"), compose(T, U))
    assert graph.get("b", "c").shape == (4, 4)
    graph.add("a", "c", compose(T, U))
    wrong = compose(T, U)
    wrong[4, 0, 3] += 1
    with pytest.raises(RobokinError, match=r"T_ac contradicts .* a → c: off by 1 at index 4,"):
        graph.add("a", "c", wrong)
    with pytest.raises(
        RobokinError, match=r"T_cd has shape \(5, 4, 4\).* \(a, b, c\) have \(6, 4, 4\)"
    ):
        graph.add("c", "d", random_se3(3, 5))
    assert graph.frames == ["a", "b", "c"]


def test_a_heading_of_half_a_turn_is_pi():
    np.testing.assert_array_equal(pose([[-1, -0.0, 1], [-0.0, -1, 2], [0, 0, 1]]), [1, 2, np.pi])
    np.testing.assert_array_equal(pose([[-1, 1e-20, 0], [-1e-20, -1, 0], [0, 0, 1]])[2], np.pi)
    with pytest.raises(RobokinError, match="T is not a rotation"):
        pose(np.diag([1, 2, 1]))


# Errors


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: compose(np.eye(3), np.eye(4)), r"\(4, 4\)\]: SE\(2\) and SE\(3\) do not mix"),
        (lambda: compose(np.zeros((2, 3, 3)) + np.eye(3), np.zeros((4, 3, 3)) + np.eye(3)),
         r"\(2, 3, 3\), \(4, 3, 3\)\]: .* batches must"),
        (lambda: compose(np.eye(3), np.eye(3), np.diag([1, -1, 1])), r"transforms\[2\] is not a "
         "rotation .a mirror: determinant < 0.: off by 2 "),
        (lambda: transform(np.eye(4), [1, 2]), r"points must have shape \(…, 3\), got \(2,\)"),
        (lambda: inverse(2 * np.eye(3)), r"T must have 0, …, 0, 1 as its last row, got \[0"),
        (lambda: check_rotation(np.eye(3), tol=[1e-6]), "tol must be one number, got array"),
        (lambda: check_rotation(np.diag([1.0, -1.0])), r"R is not a rotation \(a mirror.* by 2 "),
        (lambda: check_rotation([[0.8253, -0.5646], [0.5646, 0.8253]]), "rotation nearest to R"),
    ],
)  # fmt: skip
def test_what_is_refused(call, message):
    with pytest.raises(RobokinError, match=message):
        call()


def test_a_graph_refuses_unknown_poses():
    lost = random_se3(1, 3)
    for index, value in (((1, 0, 0), np.nan), ((2, 1, 3), np.inf)):
        graph, poses = FrameGraph(), lost.copy()
        poses[index] = value
        with pytest.raises(
            RobokinError, match=f"T_ab must be finite, got nan at index {index[0]}, "
        ):
            graph.add("a", "b", poses)
        assert graph.frames == []


def known_graph():
    graph = FrameGraph()
    graph.add("d", "b", T_db)
    graph.add("b", "c", T_bc)
    graph.add("p", "q", se2(1, 1, 1))
    return graph


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda g: g.get("c", "x"), "unknown frame 'x'; known frames: d, b, c, p, q"),
        (lambda g: g.path("x", "c"), "unknown frame 'x'; known frames: d, b, c, p, q"),
        (lambda g: g.get("c", None), "unknown frame None"),
        (lambda _: FrameGraph().get("a", "a"), "unknown frame 'a'; known frames: none yet"),
        (lambda g: g.get("c", "q"), "no path from 'c' to 'q': 'c' is connected with c, b, d; "
         "'q' with q, p"),
        (lambda g: g.add("d", "c", T_ce), "T_dc contradicts what is known along d → b → c: off by "
         "2, allowed 1e-06"),
        (lambda g: g.add("b", "d", T_db), "T_bd contradicts what is known along b → d: "),
        (lambda g: g.add("b", "e", np.eye(4)), r"T_be has shape \(4, 4\), the poses of the "
         r"known frames \(d, b, c, p, q\) have \(3, 3\): SE\(2\) and SE\(3\) do not mix"),
        (lambda g: g.add("b", "e", np.diag([1, -1, 1])), r"T_be is not a rotation \(a mirror"),
        (lambda g: g.add("b", "b", np.eye(3)), "two different names .strings., got 'b' and 'b'"),
        (lambda g: g.add("", "b", np.eye(3)), "two different names .strings., got '' and 'b'"),
        (lambda g: g.add(1, "b", np.eye(3)), "two different names .strings., got 1 and 'b'"),
    ],
)  # fmt: skip
def test_a_graph_refuses_and_stays_as_it_was(call, message):
    graph = known_graph()
    with pytest.raises(RobokinError, match=message):
        call(graph)
    assert graph.frames == ["d", "b", "c", "p", "q"]
    assert graph.path("d", "c") == ["d", "b", "c"]
    graph.add("c", "p", np.eye(3))
    assert graph.path("q", "d") == ["q", "p", "c", "b", "d"]


# Independent oracles


def mp(T):
    return mpmath.matrix(np.asarray(T).tolist())


@pytest.mark.parametrize("random_pose", [random_se2, random_se3])
def test_against_50_digits(random_pose):
    chains = np.stack([random_pose(seed, 20) for seed in (1, 2, 3)])
    points = np.random.default_rng(4).uniform(-10, 10, (20, chains.shape[-1] - 1))
    composed = compose(*chains)
    inverted = inverse(chains[0])
    moved = transform(chains[0], points)
    for n in range(20):
        exact = [mp(T[n]) for T in chains]
        # sums of up to four products of 1 and 30 m, and through two of them
        assert_close(composed[n], floats(reduce(lambda A, B: A * B, exact)), atol=16 * EPS * 30)
        # 50 digits invert the matrix as it was rounded: an EPS in R, times 20 m
        assert_close(inverted[n], floats(exact[0] ** -1), atol=8 * EPS * 20)
        there = exact[0] * mpmath.matrix([*points[n], 1.0])
        assert_close(moved[n], floats(there)[:-1, 0], atol=4 * EPS * 30)


def test_what_a_path_needs_grows_with_its_length():
    graph = FrameGraph()
    for n in range(1000):
        graph.add(f"f{n}", f"f{n + 1}", np.eye(3))
    tracemalloc.start()
    path = graph.path("f0", "f1000")
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert path == [f"f{n}" for n in range(1001)]
    assert most < 500 * len(path)  # bytes: a few names and entries for each; half a million in all
