"""Numbers that sentences of the book state and no cell computes."""

import numpy as np
import pytest

from robokin import motion


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
