"""The live figure of the chapter on the beacon."""

from book.beacon import formulas
from book.beacon.formulas import b_x, b_y

from book.motion.formulas import theta, x, y
from workshop.equations import quantity
from workshop.figures import Arrow, Body, Figure, Handle, Line, Point, Readout, Slider

guess_x = quantity("guess_x", "m", -1, 1, "where the reader puts the beacon, along x")
guess_y = quantity("guess_y", "m", -0.7, 0.7, "where the reader puts the beacon, along y")


def beacon_figure() -> Figure:
    """A beacon under the hand, seen from a robot that turns."""
    here = {x: 0, y: 0}
    return Figure(
        name="beacon",
        title="A robot and a beacon, seen from above",
        view=(-1.2, 1.2, -0.8, 0.8),
        size="laboratory",
        controls=(
            Slider(b_x, -1.0, 1.0, start=0.6, step=0.05, label="beacon b_x"),
            Slider(b_y, -0.7, 0.7, start=0.4, step=0.05, label="beacon b_y"),
            Slider.degrees(theta, step=5, label="heading"),
        ),
        scene=(
            Line("ghost", ((0, 0), (b_x, b_y))),
            Body((0, 0), theta, 0.1),
            Arrow("velocity", (0, 0), (b_x / 2, b_y / 2), label="d"),
            Point("target", (b_x, b_y), label="beacon"),
        ),
        handles=(Handle("the beacon", (b_x, b_y)),),
        readouts=(
            Readout("distance", "distance d", formulas.distance.at(here), "m"),
            Readout("bearing", "bearing", formulas.direction.at(here), "rad"),
        ),
        says="The beacon is {distance} away, at {bearing} from the heading {theta}.",
    )


def guess_figure() -> Figure:
    """The same with a ghost to place."""
    seen = beacon_figure()
    return Figure(
        name="beacon-guess",
        title="A robot, and a ghost of the beacon to place",
        view=seen.view,
        size="",
        controls=(
            *seen.controls,
            Slider(guess_x, -1.0, 1.0, start=0.3, step=0.05, label="x"),
            Slider(guess_y, -0.7, 0.7, start=-0.3, step=0.05, label="y"),
        ),
        scene=(*seen.scene, Point("approximation", (guess_x, guess_y), label="your guess")),
        handles=(Handle("your guess", (guess_x, guess_y)),),
        readouts=seen.readouts,
        says=seen.says,
    )


FIGURES = (beacon_figure(), guess_figure())
