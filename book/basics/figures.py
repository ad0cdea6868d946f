"""The live figure of the page before the chapters: the direction of a point, twice computed."""

from sympy import Ne, Piecewise, atan, nan

from book.basics import formulas as basics
from book.basics.formulas import p_x, p_y
from courseware.figures import AngleArc, Arrow, Figure, Handle, Line, Point, Readout, Slider

ORIGIN = (0, 0)


def direction_figure() -> Figure:
    """Draw a point under the hand: its direction by atan2 and by the arctangent of y/x."""
    bearing = basics.direction.right
    quotient = Piecewise((atan(p_y / p_x), Ne(p_x, 0)), (nan, True))
    return Figure(
        name="direction",
        title="A point, and its direction seen from the origin",
        view=(-1.2, 1.2, -0.8, 0.8),
        size="laboratory",
        controls=(
            Slider(p_x, -1.0, 1.0, start=-0.6, step=0.05, label="point p_x"),
            Slider(p_y, -0.7, 0.7, start=0.45, step=0.05, label="point p_y"),
        ),
        scene=(
            Line("ghost", (ORIGIN, (0.9, 0))),
            AngleArc("icr", ORIGIN, 0, bearing, 0.25, label="φ"),
            Arrow("path", ORIGIN, (p_x, p_y)),
            Point("target", (p_x, p_y), label="p"),
        ),
        handles=(Handle("the point", (p_x, p_y)),),
        readouts=(
            Readout("right", "atan2 of p_y and p_x", bearing, "rad"),
            Readout(
                "wrong",
                "arctan of p_y / p_x",
                quotient,
                "rad",
                words={"nan": "no answer: division by zero"},
            ),
        ),
        sentence=(
            "The point at {p_x}, {p_y}: its direction is {right}; the arctangent says {wrong}."
        ),
    )


FIGURES = (direction_figure(),)
