"""Predictions that the chapter on frame chains asks for."""

import numpy as np

from courseware.predictions import Buttons, Prediction
from robokin import euler, frames
from robokin.errors import RobokinError

T_DB = frames.se2(1.0, 0.5, np.pi / 2)  # of the exercise
T_DE = frames.se2(1.5, 1.1, 3 * np.pi / 4)
T_BC = frames.se2(0.4, 0.3, -np.pi / 4)
T_CE = frames.compose(frames.inverse(T_BC), frames.inverse(T_DB), T_DE)
DOWN = np.array([[0, -1, 0], [-1, 0, 0], [0, 0, -1]])  # the platform's turn, from a camera above


def where() -> str:
    """Return where the object lies for the hand."""
    x, y = T_CE[:2, 2]
    return f"{'in front' if x > 0 else 'behind'}, on the {'left' if y > 0 else 'right'}"


def turned() -> float:
    """Return by how many degrees the object is turned, seen from the hand."""
    return float(np.degrees(np.arctan2(T_CE[1, 0], T_CE[0, 0])))


def seen(by: np.ndarray) -> np.ndarray:
    """Return the object as the hand sees it, told by a camera that is moved."""
    moved: np.ndarray = frames.compose(
        frames.inverse(T_BC), frames.inverse(frames.compose(by, T_DB)), frames.compose(by, T_DE)
    )
    return moved


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


PREDICTIONS = (
    Prediction(
        "from-the-hand",
        "Stand in the hand c and look along its red x axis. Where is the object?",
        Buttons(
            ("in front, on the left", "in front, on the right", "behind, on the right"),
            right=where,
            assumptions={
                "in front, on the left": "The red axis points up and to the right. The object is "
                "below its line.",
                "behind, on the right": "So it is if you look along the first link, from the "
                "platform to the elbow. Look along the hand's own red axis.",
            },
        ),
        explanation=f"And it is turned to the left by {turned():.0f}°, seen from you.",
        spoilers=("turned to the left",),
    ),
    Prediction(
        "of-a-plan",
        "The determinant of the 3×3 turn is 1. What is that of its 2×2 part?",
        Buttons(
            ("1", "0", "−1"),
            right=lambda: f"{np.linalg.det(DOWN[:2, :2]):.0f}".replace("-", "−"),
            assumptions={
                "1": "So it is for a camera that looks up. For this one the turn from x to y is "
                "clockwise, seen from above; for the platform it is counter-clockwise.",
                "0": "Then x and y would lie on one line.",
            },
        ),
        explanation="In space it is a rotation, but its 2×2 part is none: the platform's z axis "
        "points up, the camera's down. The camera's picture is right all the same, because in a "
        "picture y points down. Only a graph of its numbers with y *up* is a mirror image. Turn y "
        "round, or let the z axes of the bodies point down, too: then a plan of SE(2) will do "
        "again.",
        spoilers=("a mirror image", "of the bodies"),
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
        explanation="How the camera hangs does not matter to the hand. Try it; drag beside the "
        "frames to turn your view.",
        spoilers=("does not matter to the hand",),
    ),
    Prediction(
        "four-more",
        "We tell the graph four more things: (1) $T_{ce}$, but 1 cm off; (2) $T_{fb}$, the pose in "
        "space; (3) $T_{gh}$ of two frames that nobody knows; (4) the inverse of $T_{bc}$. Which "
        "does it refuse?",
        Buttons(
            ("1", "1 and 2", "1, 2 and 3", "all"),
            right=refused,
            assumptions={
                "1": "A pose in space and poses in the plane do not mix.",
                "1, 2 and 3": "What nobody knows contradicts nothing.",
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
        "What is left over at the end?",
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
