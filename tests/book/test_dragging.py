"""What a hand that drags a point says of its angle."""

import numpy as np
import pytest
import sympy as sp

from book.dragging import turn_handle
from courseware.figures import POINTER, VIEW

angle = sp.Symbol("angle", real=True)
POINT = (  # on a circle in space that lies askew, its middle beside the origin
    0.3 + 0.5 * sp.cos(angle),
    0.3 * sp.sin(angle) - 0.2,
    0.4 * sp.sin(angle) + 0.1,
)
HANDLE = turn_handle("the point", angle, POINT)
CLOSE = 1e-4  # m, far less than a pixel: so little holds a circle of a millimetre back
VIEWS = {
    "wide": (0.5, 0.0),
    "narrower": (-2.1, 0.2),
    "from the side": (np.pi / 2, np.arctan2(4, 3)),
}


def as_functions(view):
    """Return where the point is seen at an angle, and to which angle a hand there leads."""
    given = dict(zip((VIEW.azimuth, VIEW.elevation), view, strict=True))
    seen, (to,) = sp.Matrix(HANDLE.at).subs(given), HANDLE.sets.values()
    return sp.lambdify(angle, list(seen)), sp.lambdify((angle, *POINTER), to.subs(given))


@pytest.mark.parametrize("view", VIEWS.values(), ids=[*VIEWS])
def test_a_point_comes_under_the_hand(view):
    """From any angle to any other, within ten moves of the hand."""
    seen, to = as_functions(view)
    random = np.random.default_rng(3)
    for before, wished in random.uniform(-np.pi, np.pi, (200, 2)):
        hand = seen(wished)
        found = before
        for _ in range(10):
            found = to(found, *hand)
        assert seen(found) == pytest.approx(hand, abs=CLOSE)


@pytest.mark.parametrize("start", [0.0, np.pi, -np.pi / 2, 1.0])
def test_a_point_seen_from_the_side_goes_along_its_line(start):
    """It is not stuck at an end of the line, and does not jump to the other end."""
    seen, to = as_functions(VIEWS["from the side"])
    first, last = np.array(seen(start)), np.array(seen(start + 1.2))
    now = start
    for share in np.linspace(0, 1, 11):
        hand = first + share * (last - first)
        now = to(now, *hand)
        assert seen(now) == pytest.approx(hand, abs=CLOSE)
