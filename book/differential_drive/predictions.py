"""Predictions that the chapter on the differential drive asks for."""

import numpy as np
from sympy import Float, pi

from book.differential_drive import formulas
from book.differential_drive.figures import (
    DISTANCE,
    RADIUS,
    SPEEDS,
    TWIST,
    guess_x,
    guess_y,
    pin_x,
    pin_y,
    t,
)
from book.differential_drive.formulas import b, r, v_L, v_R
from book.motion.formulas import arc_step, dt, omega, theta, v, x, y
from courseware.predictions import Buttons, Ghost, Number, Prediction, nearest_option
from robokin import motion

EXERCISE = {**SPEEDS, b: DISTANCE}
AHEAD = {x: 0, y: 0, theta: pi / 2}
THROUGH = "nearer, and through the robot to its other side"
AWAY = "farther away, and it stays on that side"
AROUND = "farther away, then in from the other side"


def after_two_seconds(turning):
    """Return where the robot of the exercise is after 2 s, if it turns so fast."""
    return tuple(arc_step.substitute({**AHEAD, **TWIST, omega: turning, dt: 2})[:2])


def rolling(radius):
    """Return the rate of the exercise's right wheel, if this is taken for its radius."""
    ahead = {v: EXERCISE[v_R], omega: 0, r: radius}
    return formulas.wheel_rates.substitute(ahead)[1].subs({r: RADIUS, b: DISTANCE})


def where_it_goes():
    """Say where the ICR goes when the right wheel slows down from 10 to 6 and to 4 cm/s."""
    radii = [formulas.turning_radius.substitute({**EXERCISE, v_R: u}) for u in (0.1, 0.06, 0.04)]
    signs = [np.sign(float(radii[1] - radii[0])), np.sign(float(radii[2]))]
    return nearest_option({THROUGH: (-1, -1), AWAY: (1, 1), AROUND: (1, -1)}, signs)


def seen_from_robot():
    """Say where a thing ahead along x is for a robot that looks along y."""
    options = {"straight ahead of it": (1, 0), "at its left": (0, 1), "at its right": (0, -1)}
    return nearest_option(options, motion.to_body(np.pi / 2, [1, 0, 0])[:2])


PREDICTIONS = (
    Prediction(
        "seen-from-the-robot",
        "From chapter 3: a robot looks along the world's $y$ axis. A box stands 1 m from it, "
        "along the world's $x$ axis. Where does the robot see it?",
        Buttons(
            ("straight ahead of it", "at its left", "at its right"),
            right=seen_from_robot,
            assumptions={
                "straight ahead of it": "Ahead is $y$: the robot looks that way.",
                "at its left": "If you look along $y$, your left hand points along $-x$.",
            },
        ),
        explanation="Turn robot and box together by −90°: then the robot looks along $x$, and the "
        "box is at its right.",
        spoilers=("robot and box together",),
    ),
    Prediction(
        "behind-on-the-left",
        "From *Before you start*: a point lies at $x$ = −1 m, $y$ = 1 m. Which direction does "
        "`arctan2(1, -1)` give?",
        Buttons(
            ("−45°", "45°", "135°"),
            right=lambda: f"{np.degrees(np.arctan2(1, -1)):.0f}°",
            assumptions={
                "−45°": "That is the arctangent of the quotient: it loses the signs.",
                "45°": "Both signs count, and $x$ is negative.",
            },
        ),
        explanation="`arctan2` keeps both signs: the point lies to the left of the $y$ axis.",
        spoilers=("keeps both signs",),
    ),
    Prediction(
        "how-fast",
        "The left wheel moves at 5 cm/s, the right one at 10 cm/s. How fast does P move, the "
        "middle of the axle?",
        Number(
            "cm/s",
            right=formulas.speed.substitute(EXERCISE),
            assumptions={
                "The sum of both would make the middle faster than each end.": (v_L + v_R).subs(
                    SPEEDS
                ),
                "That is the difference: the robot *turns* by it.": (v_R - v_L).subs(SPEEDS),
            },
        ),
        explanation="The axle is stiff, so the tips of all arrows along it lie on one line. In the "
        "middle the arrow is as long as the *mean* of the two at the ends.",
        spoilers=("the mean of", "half the sum"),
    ),
    Prediction(
        "where-still",
        "Think of a large sheet of paper under the robot, that turns with it. While the robot "
        "drives, one point of the sheet stays where it is. Drag *your pin* there; *Play* shows how "
        "it moves.",
        Ghost(
            "still",
            places=(pin_x, pin_y),
            right=(-formulas.turning_radius.substitute(EXERCISE), Float(0)),
            then={t: Float(1.5)},
            free=(t,),
            tolerance=0.015,
            assumptions={
                "That is P: it drives along.": (Float(0), Float(0)),
                "That is the left wheel: it rolls, only more slowly.": (
                    Float(-DISTANCE / 2),
                    Float(0),
                ),
            },
        ),
        explanation="The pin stays, and the robot runs round it.",
        spoilers=("runs round it",),
    ),
    Prediction(
        "where-next",
        "Where does the ICR go meanwhile?",
        Buttons(
            (THROUGH, AWAY, AROUND),
            right=where_it_goes,
            assumptions={
                THROUGH: "Then a point between the wheels would have to stand still. But both "
                "wheels drive forward, and so does all between them.",
                AWAY: "So it is until both are equally fast. But then the right wheel is the "
                "slower one, and the robot turns to the right.",
            },
        ),
        explanation="It runs away to the left, faster and faster, and comes back from the right: "
        "at 4 cm/s it is 45 cm to the right of P.",
        spoilers=("comes back from", "45 cm"),
    ),
    Prediction(
        "wheel-rate",
        "The right wheel, of radius 3 cm, rolls at 10 cm/s. How fast does it turn on its axle?",
        Number(
            "rad/s",
            right=rolling(r),
            assumptions={
                "That divides by the wheel's diameter.": rolling(2 * r),
                "That multiplies by the radius, in metres.": rolling(1 / r),
                "That multiplies by the radius, in centimetres.": rolling(1 / r) * 100**2,
                "That multiplies by the radius; besides, one length is in metres, the other in "
                "centimetres.": rolling(1 / r) * 100,
            },
        ),
        explanation="In one radian a wheel rolls one radius. So its rate is its speed divided by "
        "$r$.",
        spoilers=("one radius", "speed divided by"),
        covers="rates",
    ),
    Prediction(
        "where-after",
        "The robot of the exercise drives for 2 s. Drag *your guess* to where P will be.",
        Ghost(
            "guess",
            places=(guess_x, guess_y),
            right=after_two_seconds(TWIST[omega]),
            then={t: Float(2)},
            tolerance=0.015,
            assumptions={
                "That is straight on, as if it did not turn.": after_two_seconds(0),
                "That is the right way, to the other side.": after_two_seconds(-TWIST[omega]),
            },
        ),
        explanation="P runs along a circle around the ICR.",
        spoilers=("along a circle",),
    ),
    Prediction(
        "ever-straighter",
        "The textbook's step divides by ω. The heading is 1 rad. Let ω become smaller and smaller, "
        "but not zero. What happens to the computed place?",
        Buttons(
            ("it gets better", "it stays right", "it gets worse"),
            right="it gets worse",
            assumptions={
                "it gets better": "The *path* gets simpler, but not the computation.",
                "it stays right": "In exact numbers yes; a computer keeps 16 digits.",
            },
        ),
        explanation="The two sines are almost equal. Their difference keeps few correct digits, "
        "and the huge $v/\\omega$ blows the error up.",
        spoilers=("gets worse as", "blows"),
    ),
    Prediction(
        "at-rest",
        "Both wheels stand still. Where is the ICR?",
        Buttons(
            ("at P", "infinitely far away", "nowhere: no answer"),
            right="nowhere: no answer",
            assumptions={
                "at P": "P stands still, and so does every other point.",
                "infinitely far away": "So it is while it drives straight on. Here all points "
                "rest, near and far.",
            },
        ),
        explanation="Every point is at rest, so none is *the* centre. The library answers `nan`: "
        "not a number.",
        spoilers=("every point is at rest", "`nan`"),
    ),
    Prediction(
        "at-its-side",
        "A place lies 20 cm to the left of the robot. No wheel rolls that way. Can the robot get "
        "there, with the same heading at the end?",
        Buttons(
            ("no, never", "only nearly", "yes, exactly"),
            right="yes, exactly",
            assumptions={
                "no, never": "It cannot have that velocity. But it can have others, one by one.",
                "only nearly": "A single arc even ends there exactly: half a circle of 10 cm. But "
                "then the robot looks backwards. Several motions add up to both.",
            },
        ),
        explanation="It can, only not straight.",
        spoilers=("only not straight", "reaches are not"),
    ),
)
