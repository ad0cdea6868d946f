"""What a declaration of a figure must be, and what is said of a wrong one."""

import pytest
from small_figures import LOOP, a, loose, small_figure

from courseware.errors import CourseError
from courseware.figures import Curve, Handle, Point, Slider, Trail


@pytest.mark.parametrize(
    ("parts", "message"),
    [
        (
            {"shapes": (Point("target", (loose, 0)),)},
            "uses loose, but may use only x",
        ),
        ({"shapes": (Curve("path", (loose, loose * a), loose * a, 0, 1),)}, "uses loose"),
        ({"shapes": (Point("purple", (a, 0)),)}, "no kind 'purple'; there are left, right"),
        ({"controls": (Slider(a, 0, 1, 0, 0.1, kind="purple"),)}, "no kind 'purple'"),
        ({"sentence": "b is {b}"}, "text `sentence` of .* uses b, but there are only x, twice"),
        ({"handles": (Handle("tip", (a, 0), {a: loose}),)}, "uses loose"),
        ({"shapes": (Point("target", (a, 0), depth=loose),)}, "uses loose"),
        (
            {"where": ((loose, a / 2),), "shapes": (Trail("path", (a, 0), LOOP),)},
            "in the figure small, an expression uses loose",
        ),
    ],
)
def test_a_wrong_declaration_is_refused(parts, message):
    with pytest.raises(CourseError, match=message):
        _ = small_figure(**parts).code
