"""Predictions that the chapter on frame chains asks for."""

import numpy as np
from sympy import Float

from book.frames.figures import (
    LAMP,
    PLATFORM,
    SHIFT,
    SLANT,
    guess_ahead,
    guess_right,
    guess_x,
    guess_y,
    lifted,
    made,
)
from courseware.predictions import Buttons, Ghost, Prediction
from robokin import euler, frames
from robokin.errors import RobokinError

T_DB = frames.se2(1.0, 0.5, np.pi / 2)  # of the exercise
T_DE = frames.se2(1.5, 1.1, 3 * np.pi / 4)
T_BC = frames.se2(0.4, 0.3, -np.pi / 4)
T_CE = frames.compose(frames.inverse(T_BC), frames.inverse(T_DB), T_DE)
DOWN = np.array([[0, -1, 0], [-1, 0, 0], [0, 0, -1]])  # the platform's turn, from a camera above


def where_it_goes() -> str:
    """Return to which side the object goes for a hand that turns to the left."""
    bearings = []
    for turn in (0, np.radians(20)):
        x, y = frames.compose(frames.inverse(frames.se2(0, 0, turn)), T_CE)[:2, 2]
        bearings.append(np.arctan2(y, x))
    return "round to the left" if bearings[1] > bearings[0] else "round to the right"


def seen(by: np.ndarray) -> np.ndarray:
    """Return the object as the hand sees it, told by a camera that is moved."""
    moved: np.ndarray = frames.compose(
        frames.inverse(T_BC), frames.inverse(frames.compose(by, T_DB)), frames.compose(by, T_DE)
    )
    return moved


def mirrored() -> str:
    """Return which paper has a letter the wrong way round: where the axes run the other way."""
    turns = {
        FROM_ABOVE: 1.0,
        Y_DOWN: -np.linalg.det(DOWN[:2, :2]),
        Y_UP: np.linalg.det(DOWN[:2, :2]),
    }
    return next(paper for paper, turn in turns.items() if turn < 0)


def lamp(turn: float) -> tuple[float, ...]:
    """Return where the camera sees the lamp of a platform that is turned so."""
    return tuple(frames.transform(frames.se2(*PLATFORM[:2], turn), LAMP))


def right_and_ahead(x: float, y: float) -> tuple[float, float]:
    """Return a place of a heading-up map from its x ahead and y to the left."""
    return -y, x


def camera_behind() -> tuple[float, float]:
    """Return where the camera is in the map of the slanted platform."""
    return right_and_ahead(*frames.inverse(frames.se2(*SLANT))[:2, 2])


def changed() -> str:
    """Return which of the hand's numbers change when the camera is turned."""
    same = np.isclose(seen(frames.se2(0, 0, 1.0)), T_CE, atol=1e-12)
    return "none" if same.all() else "the turn" if same[:2, 2].all() else "all three"


def refused() -> str:
    """Return which of four more things the graph refuses."""
    graph = frames.FrameGraph()
    for a, b, T_ab in (("d", "b", T_DB), ("d", "e", T_DE), ("b", "c", T_BC)):
        graph.add(a, b, T_ab)
    news = (
        ("c", "e", frames.compose(T_CE, frames.se2(0.01, 0, 0))),
        ("f", "b", frames.se3(DOWN, [-0.2, 0.3, 1.2])),
        ("g", "h", frames.se2(1, 0, 0)),
        ("c", "b", frames.inverse(T_BC)),
    )
    found = []
    for number, (a, b, T_ab) in enumerate(news, start=1):
        try:
            graph.add(a, b, T_ab)
        except RobokinError:
            found.append(str(number))
    return " and ".join(found)


def left_over() -> str:
    """Return the gap of the loop with the camera tilted by 2° and the rest as it is."""
    tilt = frames.se3(euler.to_matrix("X", [np.radians(2)]), [0, 0, 0])
    loop = frames.inverse(tilt)  # all else drops out
    shift, angle = np.linalg.norm(loop[:3, 3]), np.degrees(euler.to_axis_angle(loop[:3, :3])[1])
    return f"a turn by {angle:.0f}°" if shift < 1e-9 < angle else "a shift by 5 cm"


FROM_ABOVE, Y_DOWN, Y_UP = (
    "the floor, drawn from above",
    "the camera's picture, with y down",
    "the camera's numbers, with y up",
)

PREDICTIONS = (
    Prediction(
        "columns-of-a-turn",
        "From chapter 2: the second column of a rotation matrix is (0, 0, 1). What does it say?",
        Buttons(
            ("the turned y axis points along z", "the turned z axis points along y", "y is 1"),
            right="the turned y axis points along z",
            assumptions={
                "the turned z axis points along y": "That would be the third column: (0, 1, 0).",
                "y is 1": "A column of a rotation is a direction, not a place.",
            },
        ),
        explanation="Each column of a rotation matrix is a turned axis, seen from the frame that "
        "stays.",
        spoilers=("is a turned axis",),
    ),
    Prediction(
        "two-elbows",
        "From chapter 1: a hand shall be at a place that both links reach easily. How many ways "
        "can the arm's elbow bend in the plane?",
        Buttons(
            ("one", "two", "infinitely many"),
            right="two",
            assumptions={
                "one": "So it is at full stretch only.",
                "infinitely many": "Two links in the plane: the elbow is where two circles meet.",
            },
        ),
        explanation="The two circles about shoulder and hand meet in two points.",
        spoilers=("meet in two points",),
    ),
    Prediction(
        "which-turns",
        "The hand turns on the spot, to the left. Where does the box go in the hand's own picture?",
        Buttons(
            ("round to the left", "nowhere", "round to the right"),
            right=where_it_goes,
            assumptions={
                "round to the left": "That would be so if the box were fixed to the hand and you "
                "stood in the room.",
                "nowhere": "In the room it goes nowhere. But the hand's picture turns with the "
                "hand.",
            },
        ),
        explanation="The box rests in the room. The hand's picture is pinned to the hand and turns "
        "to the left; so what rests goes to the right in it. Turn your head to the left, and see.",
        spoilers=("what rests goes",),
        covers="tracing",
    ),
    Prediction(
        "seen-lamp",
        "The platform's lamp is at its left front corner: 0.2 m ahead of b and 0.15 m to the left. "
        "Drag *your guess* to where the lamp is in the camera's picture.",
        Ghost(
            "lamp",
            places=(guess_x, guess_y),
            right=lambda: lamp(PLATFORM[2]),
            then={made: Float(2)},
            tolerance=0.04,
            assumptions={
                "That is 0.2 m along the camera's x and 0.15 m along its y. But ahead is along "
                "$x_b$.": lambda: lamp(0.0),
                "That is to the right of the platform: $y_b$ points to its left.": (
                    lambda: frames.transform(frames.se2(*PLATFORM), [LAMP[0], -LAMP[1]])
                ),
            },
        ),
        explanation="Go 0.2 m along $x_b$ and 0.15 m along $y_b$, from the origin of b.",
        spoilers=("from the origin of b.",),
    ),
    Prediction(
        "shift-then-turn",
        "The platform stands at the camera's origin. It is first shifted by 0.8 m along the "
        "camera's x axis; then all of it is turned by 90° about the camera's *origin*. Drag *your "
        "guess* to where it ends.",
        Ghost(
            "two-orders",
            places=(guess_x, guess_y),
            right=(Float(0), Float(SHIFT)),
            then={made: Float(2)},
            tolerance=0.06,
            assumptions={
                "So it is if it turns on the spot, about itself, or first turns and then shifts.": (
                    Float(SHIFT),
                    Float(0),
                ),
            },
        ),
        explanation="The turn is about the camera's origin, so it carries the shift along. In the "
        "other order, the pale platform, the turn happens on the spot.",
        spoilers=("carries the shift",),
    ),
    Prediction(
        "camera-behind",
        "The platform stands at x = 1 m, y = 0.5 m, turned by 30°. In its own map it rests, and "
        "its front is up. Drag *your guess* to where the camera is in that map.",
        Ghost(
            "way-back",
            places=(guess_right, guess_ahead),
            right=camera_behind,
            then={lifted: Float(1)},
            tolerance=0.08,
            assumptions={
                "That is −p, measured along the platform's axes: long enough, but not turned.": (
                    lambda: right_and_ahead(-SLANT[0], -SLANT[1])
                ),
                "That is how the camera's picture shows it: 1 m to the left, 0.5 m down. The map "
                "is turned.": (-SLANT[0], -SLANT[1]),
            },
        ),
        explanation="Nearly straight behind: look back along the platform in the left picture.",
        spoilers=("straight behind",),
    ),
    Prediction(
        "of-a-plan",
        "A sheet with the letter R lies on the floor. Three papers show it: the floor, drawn from "
        "above; the camera's picture, as pictures are, x to the right and y *down*; and the same "
        "numbers on squared paper, with y *up*. On which of them is the R mirrored?",
        Buttons(
            (FROM_ABOVE, Y_DOWN, Y_UP),
            right=mirrored,
            assumptions={
                FROM_ABOVE: "That is how you read it when you stand on the floor.",
                Y_DOWN: "You can read what a camera shows. It may be turned, but not mirrored.",
            },
        ),
        explanation="For the camera x to y is clockwise, seen from above. Plotted with y up it is "
        "counter-clockwise, so the plot is a mirror image.",
        spoilers=("a mirror image",),
    ),
    Prediction(
        "a-turned-camera",
        "The hand sees the object at x and y, turned by an angle. The camera turns about the "
        "vertical. Which of these three numbers change?",
        Buttons(
            ("all three", "the turn", "none"),
            right=changed,
            assumptions={
                "all three": "So do those that the camera tells, of the platform and the object.",
                "the turn": "The camera sees the platform turned, too, and by as much.",
            },
        ),
        explanation="While the camera sees both, it does not matter how it hangs. Try it; drag "
        "beside the frames to turn your view.",
        spoilers=("not matter how it hangs",),
        covers="camera-above",
    ),
    Prediction(
        "four-more",
        "We tell the graph four more things: (1) $T_{ce}$, but 1 cm off; (2) $T_{fb}$, the pose in "
        "space; (3) $T_{kl}$ of two frames that nobody knows; (4) the inverse of $T_{bc}$. Which "
        "does it refuse?",
        Buttons(
            ("1", "1 and 2", "1, 2 and 3", "all"),
            right=refused,
            assumptions={
                "1": "A pose in space and poses in the plane do not mix.",
                "1, 2 and 3": "Nothing joins k and l to the others: no pose can contradict theirs.",
                "all": "The last one says what is known already, the other way round.",
            },
        ),
        explanation="The first is 1 cm off what follows from the three poses known. The second "
        "mixes plane and space. The fourth agrees with $T_{bc}$: accepted. So is the third, as an "
        "island.",
        spoilers=("as an island",),
    ),
    Prediction(
        "round-the-loop",
        "What is left over at the end, seen from f, where you started?",
        Buttons(
            ("nothing", "a shift by 5 cm", "a turn by 2°"),
            right=left_over,
            assumptions={
                "nothing": "So it is when all poses are right.",
                "a shift by 5 cm": "So far does the object seem to move. But you came back to f, "
                "where the error sits.",
            },
        ),
        explanation="The loop does not close. Seen from f, nothing is shifted, and what is left is "
        "exactly the error, turned back: 2° about the negative x axis.",
        spoilers=("does not close",),
    ),
)
