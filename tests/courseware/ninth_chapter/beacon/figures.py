"""The live figure of the chapter on the beacon."""

from book.beacon import formulas
from book.beacon.exercises import M99
from book.beacon.formulas import b_x, b_y
from sympy import cos, sin

from book.motion.formulas import theta, x, y
from courseware.equations import quantity
from courseware.figures import Arrow, Body, Choice, Figure, Handle, Line, Point, Readout, Slider

guess_x = quantity("guess_x", "m", -1, 1, "where the reader puts the beacon, along x")
believed = quantity("believed", "rad", -3.14, 3.14, "the bearing that a program computes")
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
            Readout("distance", "distance d", formulas.distance.substitute(here), "m"),
            Readout("bearing", "bearing", formulas.direction.substitute(here), "rad"),
        ),
        sentence="The beacon is {distance} away, at {bearing} from the heading {theta}.",
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
        sentence=seen.sentence,
    )


def mistake_figure() -> Figure:
    """The robot, and where it looks for the beacon when its program has the mistake."""
    place = {x: 0, y: 0, b_x: 0.6, b_y: 0.4}
    right, wrong = formulas.direction.substitute(place), M99.substitute(place)
    looks = theta + believed
    return Figure(
        name="wrong-beacon",
        title="A robot and a beacon, and in red where a mistake makes it look",
        view=(-1.2, 1.2, -0.8, 0.8),
        controls=(
            Choice(
                "mistake", "mistake", (believed,), {"It forgets how it stands": (float(wrong),)}
            ),
            Slider.degrees(theta, start=40, step=5, label="heading"),
        ),
        scene=(
            Body((0, 0), theta, 0.1),
            Line("error", ((0, 0), (0.7 * cos(looks), 0.7 * sin(looks)))),
            Point("target", (0.6, 0.4), label="beacon"),
        ),
        readouts=(Readout("apart", "looks beside it by", believed - right, "rad"),),
        sentence="The robot looks {apart} beside the beacon.",
    )


FIGURES = (beacon_figure(), guess_figure(), mistake_figure())
