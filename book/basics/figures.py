"""The live figures of the page before the chapters: a robot, a ball, and what turns."""

from typing import Any

from sympy import Abs, And, Ne, Piecewise, atan, atan2, cos, nan, pi, sin, symbols

from book import things
from book.basics import formulas as basics
from book.basics.formulas import bearing, fastest, p_x, p_y, t, theta
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, v, x, y
from courseware.figures import (
    POINTER,
    AngleArc,
    Arrow,
    Bracket,
    Clock,
    Cloud,
    Curve,
    Figure,
    Goal,
    Handle,
    Label,
    Line,
    Readout,
    Slider,
    assign,
    distance,
)

ORIGIN, HERE = (0, 0), (0, 0, 0)
VIEW = (-1.25, 1.25, -0.8, 0.8)
WISHED = (-0.8, 0.5)  # m, where the first ball shall be
BEHIND = -pi / 2  # where the robot shall look
NEAR, TURNED = 5, 2  # cm, degrees: how far off still counts
SPEED, TIME = 1.0, 2.0  # m/s, s, of each of the thousand
THOUSAND = tuple((round(k / 499.5 - 1, 4),) for k in range(1000))
share, driven = symbols("share driven")


def ball_sliders(across: float, up: float) -> tuple[Slider, Slider]:
    """Return sliders for the place of the ball."""
    return (
        Slider(p_x, -1.0, 1.0, start=across, step=0.05, label="p_x, ahead"),
        Slider(p_y, -0.6, 0.6, start=up, step=0.05, label="p_y, to the left"),
    )


def robot_and_ball() -> tuple[Any, ...]:
    """Return the robot at the origin, its line of sight, and the ball."""
    return (
        Line("ghost", (ORIGIN, (1.2, 0))),
        things.vacuum(HERE),
        things.ball((p_x, p_y, 0), 0.06),
    )


BALL = (Handle("the ball", (p_x, p_y)),)


def arrow_figure() -> Figure:
    """Draw the arrow from the robot to the ball, and its parts along the axes."""
    above = Piecewise((1, p_y >= 0), (-1, True))
    wished = f"{-WISHED[0]:.1f} m behind the robot and {WISHED[1]:.1f} m to its left"
    return Figure(
        name="arrow",
        title="A robot that looks to the right, an arrow from it to a ball, and the two parts",
        view=VIEW,
        ground="tiles",
        controls=ball_sliders(0.75, 0.3),
        shapes=(
            *robot_and_ball(),
            Arrow(p_x, ORIGIN, (p_x, 0), ""),
            Arrow(p_y, (p_x, 0), (p_x, p_y), ""),
            Label(p_x, (p_x / 2, -0.27 * above), "p_x = {p_x}"),
            Label(p_y, (p_x, p_y + 0.13 * above), "p_y = {p_y}"),
            Arrow("path", ORIGIN, (p_x, p_y)),
        ),
        handles=BALL,
        sentence="The ball is {p_x} ahead of the robot and {p_y} to its left.",
        goal=Goal(
            distance((p_x, p_y), WISHED) < NEAR / 100,
            f"Put the ball {wished}: within {NEAR} cm.",
        ),
    )


def direction_figure() -> Figure:
    """Draw the ball under the hand: its direction by atan2 and by the arctangent of y/x."""
    quotient = Piecewise((atan(p_y / p_x), Ne(p_x, 0)), (nan, True))
    return Figure(
        name="direction",
        title="A robot, a ball, and two directions that shall lead to it",
        view=VIEW,
        ground="tiles",
        controls=ball_sliders(0.6, 0.45),
        where=assign(basics.direction),
        shapes=(
            *robot_and_ball(),
            AngleArc(bearing, ORIGIN, 0, bearing, 0.3),
            Arrow("error", ORIGIN, (0.7 * cos(quotient), 0.7 * sin(quotient)), "arctan"),
            Arrow(bearing, ORIGIN, (0.9 * cos(bearing), 0.9 * sin(bearing)), "atan2"),
        ),
        handles=BALL,
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
        sentence="The ball at {p_x}, {p_y}: atan2 says {right}, the arctangent {wrong}.",
    )


def turn_figure() -> Figure:
    """Draw a robot that turns, its two axes, and the matrix whose columns they are."""
    c, s = cos(theta), sin(theta)
    return Figure(
        name="turn",
        title="A robot that turns on the spot, its two axes, and the matrix of the turn",
        view=(-1.25, 2.4, -1.2, 1.2),
        ground="tiles",
        controls=(Slider.degrees(theta, label="turned by θ"),),
        shapes=(
            Line("ghost", ((1.15, 0), ORIGIN, (0, 1.1))),
            things.vacuum((*ORIGIN, theta)),
            AngleArc(theta, ORIGIN, 0, theta, 0.32),
            Arrow("y_axis", ORIGIN, (-s, c), "y"),
            Arrow("x_axis", ORIGIN, (c, s), "x"),
            Bracket(basics.rotation, (1.8, 0), columns=("x_axis", "y_axis"), digits=2),
        ),
        handles=(Handle("tip of the x axis", (c, s), {theta: atan2(POINTER[1], POINTER[0])}),),
        sentence="The robot has turned by {theta}.",
        goal=Goal(
            Abs(theta - BEHIND) < TURNED * pi / 180,
            "Turn the robot until its y axis points where its x axis pointed first: "
            f"within {TURNED}°.",
        ),
    )


def thousand_figure() -> Figure:
    """Draw a thousand robots that drive equally far, each at a turning rate of its own."""

    def end(rate: Any, time: Any) -> Any:
        """Return the pose of the robot with a turning rate after a time."""
        driven = {x: 0, y: 0, motion.theta: 0, v: SPEED, dt: time, omega: rate * fastest}
        return motion.arc_step.substitute(driven)

    outer = end(1, t)
    return Figure(
        name="thousand",
        title="A robot, and a thousand dots: where robots are that turn at a thousand rates",
        view=(-1.3, 2.75, -1.55, 1.55),
        ground="tiles",
        controls=(
            Slider(fastest, 0.5, 4.0, start=1.0, step=0.1, label="fastest turn"),
            Clock(t, 0.0, TIME, loops=True, label="time"),
        ),
        shapes=(
            things.vacuum(HERE, look="ghost"),
            *(Curve("ghost", end(rate, driven), driven, 0, t) for rate in (-1, 0, 1)),
            Cloud("path", end(share, t), (share,), THOUSAND),
            *(things.vacuum(end(rate, t)) for rate in (-1, -0.5, 0, 0.5, 1)),
        ),
        readouts=(
            Readout("straight", "the straight one is away", SPEED * t, "m"),
            Readout("outer", "the fastest turn is away", distance(outer, ORIGIN), "m"),
        ),
        sentence=(
            "Turning rates up to {fastest}, after {t}: the straight one is {straight} from the "
            "start, the fastest-turning one {outer}."
        ),
        goal=Goal(
            And(distance(outer, ORIGIN) < NEAR / 100, fastest * t > 1),
            f"Let the robot that turns fastest end where it started: within {NEAR} cm.",
        ),
    )


FIGURES = (arrow_figure(), direction_figure(), turn_figure(), thousand_figure())
