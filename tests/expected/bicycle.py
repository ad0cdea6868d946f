"""Expected values for the chapter on the bicycle model: figures, feedback, predictions."""

import numpy as np

from book.bicycle.figures import DURATION, LENGTH, RADIUS
from robokin import bicycle, motion


def ackermann_readouts(phi, wheelbase, track):
    left, right = bicycle.ackermann(phi, wheelbase, track).T
    tangent = np.tan(bicycle.equivalent_steering(left, right))
    return {"mean": (left + right) / 2, "tangent": tangent}


def followed(paths, theta, ahead):
    """Return a point of the car along paths of the rear axle that start behind it: (n, k, 2)."""
    forward = ahead[:, None] * LENGTH
    at = paths[..., :2] + forward[..., None] * directions(paths[..., 2])
    return at - forward[..., None] * directions(theta[:, None])


def directions(heading):
    """Return unit vectors: (…) → (…, 2)."""
    return np.stack([np.cos(heading), np.sin(heading)], axis=-1)


def steps_readouts(count, phi, rate, psi, ahead):
    """Step the followed point along its own velocity."""
    theta, v = np.pi / 2 - psi, RADIUS * rate
    start = np.stack([0 * theta, 0 * theta, theta], axis=-1)
    whole = bicycle.path(start, v[:, None], phi[:, None], LENGTH, DURATION)
    exact = followed(whole, theta, ahead)[:, -1]
    ends, pace = np.empty_like(exact), np.empty_like(theta)
    for k in set(count):
        one = count == k
        dt = DURATION / k
        drive = v[one, None], phi[one, None], LENGTH, np.full(int(k), dt)
        headings = bicycle.path(start[one], *drive, method="start")[:, :-1, 2]
        rear = bicycle.body_twist(v[one], phi[one], LENGTH)
        front = bicycle.front_twist(v[one], phi[one], LENGTH)
        body = rear + ahead[one, None] * (front - rear)
        pace[one] = dt * np.hypot(body[:, 0], body[:, 1])
        ends[one] = dt * motion.to_world(headings, body[:, None])[..., :2].sum(axis=1)
    apart = np.hypot(*(ends - exact).T)
    return dict(apart=apart, pace=pace, ratio=apart / pace, x=exact[:, 0], y=exact[:, 1])


def lane_readouts(phi, wheelbase, track, t):
    """Return by how much the lane is wider than the car; nan where the ICR lies under that."""
    under = np.abs(bicycle.turning_radius(phi, wheelbase)) < track / 2
    return {"more": np.where(under, np.nan, bicycle.lane_width(phi, wheelbase, track) - track)}


def moved(*columns):
    """Return the real and the believed way of an axle: the rear one, or the front one where the
    mistake is made in its way."""
    *made, phi, t = columns
    L, b, v = 2.5, 2.0, 2.0
    start = np.broadcast_to([0, 0, np.pi / 2], (len(t), 3))
    rate = bicycle.body_twist(v, phi, L)[:, 2]
    alone = bicycle.body_twist(v, bicycle.ackermann(phi, L, b).mean(axis=-1), L)[:, 2]
    rates = rate, rate / np.cos(phi), alone, -rate
    rear, fast, mean, right = (motion.arc_step(start, v, each, t) for each in rates)
    x, turned = rear[:, 0], rear[:, 2]
    front = rear + np.column_stack([L * (directions(turned) - [0, 1]), 0 * t])  # from its start
    straight, diagonal = np.stack([x, -x, turned], axis=-1), front[:, [1, 1, 2]]
    nose = rear / np.stack([np.cos(phi), np.cos(phi), 1 + 0 * t], axis=-1)
    ends = straight, fast, nose, diagonal, mean, right
    pairs = zip(made, ends, (rear, rear, front, front, rear, rear), strict=True)
    chosen = [(one[:, None] * true, one[:, None] * end) for one, end, true in pairs]
    return [sum(each) for each in zip(*chosen, strict=True)]


def mistakes_readouts(*columns):
    real, believed = moved(*columns)
    off = believed - real
    return {"apart": np.hypot(*off[:, :2].T), "off": motion.wrap_angle(off[:, 2])}


def goes_straight(*columns):
    way = moved(*columns)[1]
    return np.abs(way[:, 0] + way[:, 1]) < 1e-9


def turns_too_fast(*columns):
    """Whether the program believes in a sharper turn, to the left."""
    real, believed = moved(*columns)
    return believed[:, 2] > real[:, 2] + 0.01


def follows_its_nose(*columns):
    """Whether it is an arc along the heading at the start, whose chord has the middle heading."""
    way = moved(*columns)[1]
    along = directions((np.pi / 2 + way[:, 2]) / 2)
    return np.abs(way[:, 0] * along[:, 1] - way[:, 1] * along[:, 0]) < 1e-9


def only_diagonal(*columns):
    way = moved(*columns)[1]
    return np.abs(way[:, 0] - way[:, 1]) < 1e-9


def other_side(*columns):
    real, believed = moved(*columns)
    return real[:, 0] * believed[:, 0] < 0


DEGREE = np.pi / 180
AHEAD = {"steering": 0.0}
UNDER = {"steering": 60 * DEGREE, "wheelbase": 2.0, "track": 2.5}  # the ICR under the car
TIGHT = [{"steering": sign * 75 * DEGREE} for sign in (-1, 1)]  # the inner wheel beyond 90°

READOUTS = {
    "ackermann-steering": ackermann_readouts,
    "bicycle-steps": steps_readouts,
    "swept-lane": lane_readouts,
    "wrong-car": mistakes_readouts,
}
SPECIALS = {
    "ackermann-steering": [AHEAD, *TIGHT],
    "bicycle-steps": [AHEAD, {"n": 1}, {"point": "front axle"}],
    "swept-lane": [AHEAD, {**AHEAD, "t": 8.0}, {"t": 8.0}, UNDER],
    "wrong-car": [{"t": 0.0}, {"mistake": "Only along a diagonal", "t": 1.0}],
}
TITLES = {
    "wrong-car": {
        "Off its circle": goes_straight,
        "It turns too fast": turns_too_fast,
        "It follows its nose": follows_its_nose,
        "Only along a diagonal": only_diagonal,
        "One wheel for two": None,
        "To the other side": other_side,
    }
}
WORDS = [  # figure, slider → what it shows, readout → its word
    ("ackermann-steering", AHEAD, "radius", "none: straight ahead"),
    ("swept-lane", UNDER, "lane", "no lane: the car turns about a point under itself"),
    ("swept-lane", UNDER, "more", "no lane"),
]
FEEDBACK = {  # exercise → numbers as its text shows them, mistake → what it gives then
    "bicycle-1": (
        {"L": 1, "phi": 15, "v_front": 3},
        {"M16": 0.8038, "cosine where the sine": 2.8978},
    ),
    "bicycle-2": ({"alpha_L": 37, "alpha_R": 28}, {"M18": 0.5672, "mean of the tangents": 0.5712}),
    "bicycle-3": (
        {"theta": 130, "v": 3.5, "phi": 40},
        {
            "M17": [-2.9368, 3.5],
            "M33": [0.7934, 0.7934],
            "speed of the rear axle": [-3.4468, 0.6078],
            "as the car sees it": [3.5, 2.9368],
        },
    ),
    "bicycle-4": ({"alpha_L": 35, "phi": 30}, {"M18": 0.4363, "mean of the tangents": 0.4266}),
    "bicycle-5": (
        {"psi": 60, "diameter": 75, "wheel_rate": 5.5, "L": 5, "phi": 25, "time": 4.5},
        {
            "M32": 1.9128,
            "M16": 0.0921,
            "diameter where the radius": -0.684,
            "φ where tan φ": 0.2373,
        },
    ),
    "bicycle-6": (
        {"L": 2.5, "theta": -60, "time": 2, "v": 2, "phi": -25},
        {
            "M15": [0.5861, -0.5861, -1.7933],
            "M16": [0.4345, -3.8636, -1.8704],
            "M33": [-3.8637, -3.8637, -1.7933],
            "φ where tan φ": [0.6806, -3.8597, -1.7453],
            "on the circle of the right R": [0.4794, -4.2631, -1.8704],
            "heading at the start": [3.6391, -1.4242, -0.7461],
            "only then turns": [2, -3.4641, -1.7933],
        },
    ),
    "bicycle-7": (
        {"psi": 130, "L": 2.5, "v": 1.5, "phi": 35, "n": 3, "dt": 0.4},
        {
            "M16": [2.1516, 0.2548],
            "M17": [1.878, -1.1006],
            "M32": [2.1062, -0.5497],
            "M33": [2.1697, 2.1697],
            "real place of O": [2.1447, 0.3567],
            "first changes ψ": [2.1097, 0.5361],
        },
    ),
}
PREDICTED = {  # prediction → what is right; where numbers are typed, the wrong guesses, too
    "which-mean": "a little less",
    "turned-alike": "nowhere",
    "how-far": ("73.3°", "90°", "59°"),
    "twice-the-steps": "a half",
    "how-wide": ("3.28 m", "1.5 m"),
}
