"""Exercises on chains of frames, and the mistakes that are made there."""

import numpy as np

from robokin import frames
from workshop.practice import Ask, Exercise, Mistake, angle, one_of, steps

M9 = Mistake(
    "M9",
    says="when the poses are multiplied as they are given and none is inverted",
    line="T_ce = T_db @ T_bc @ T_de",
    why="c meets d: there the letters break; and the product starts in d, not in c. In "
    "T_ce = T_cb T_bd T_de they meet. So both poses given, T_bc and T_db, must be inverted first.",
    unnoticed="Where T_db T_bc is a half turn: in the plane a half turn is its own inverse.",
)
M10 = Mistake(
    "M10",
    says="when an inverse is made with −p in place of −Rᵀp",
    line="def back(T):\n"
    "    return np.block([[T[:2, :2].T, -T[:2, 2:]], [0, 0, 1]])\n"
    "T_ce = back(T_bc) @ back(T_db) @ T_de",
    why="−p is the way back measured along the axes of the first frame. The inverse is seen from "
    "the second frame, so the way back must be turned as well: −Rᵀp.",
    unnoticed="Where the frames are only shifted, not turned (R is the identity), or only turned, "
    "not shifted.",
)
M11 = Mistake(
    "M11",
    says="when a product is inverted factor by factor and the order stays as it was",
    line="T_ce = np.linalg.inv(T_db) @ np.linalg.inv(T_bc) @ T_de",
    why="You put on socks, then shoes; off come the shoes first. The inverse of a product is the "
    "product of the inverses in the opposite order.",
    unnoticed="Where both poses are pure shifts, or both are turns about the same point.",
)
M30 = Mistake(
    "M30",
    says="when T_bc is left as it is where its inverse belongs",
    line="T_ce = T_bc @ np.linalg.inv(T_db) @ T_de",
    why="The product would start in b and end in e, with c and b side by side in the middle: "
    "T_bc T_bd. From c to b leads T_cb, the inverse of T_bc.",
    unnoticed="Where T_bc is its own inverse: a half turn.",
    document="001 Q3",
    stands="T_bc T_db⁻¹ T_de = T_ce",
    should="T_bc⁻¹ T_db⁻¹ T_de = T_ce",
)

POSE = (Ask("x", "m"), Ask("y", "m"), angle("θ"))
UPPER, FORE = 0.3, 0.4  # the links of the arm


def entries(name):
    """The nine numbers of a planar pose's matrix: only the position has a unit."""
    return tuple(
        Ask(f"{name}[{i}, {j}]", "m" if (i < 2 and j == 2) else "")
        for i in range(3)
        for j in range(3)
    )


def numbers_of(T):
    """The pose [x, y, theta] of a matrix."""
    return [T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])]


def wrist(alpha, beta):
    """Where the hand is, as the platform sees it."""
    return UPPER * np.array([np.cos(alpha), np.sin(alpha)]) + FORE * np.array(
        [np.cos(alpha + beta), np.sin(alpha + beta)]
    )


def hand(alpha, beta, gamma):
    """T_bc: the hand as the platform sees it."""
    return frames.se2(*wrist(alpha, beta), alpha + beta + gamma)


def shifted_back(T):
    """M10: the inverse with −p, in the plane or in space."""
    n = len(T) - 1
    out = np.eye(n + 1)
    out[:n, :n] = T[:n, :n].T
    out[:n, n] = -T[:n, n]
    return out


def planar(**given):
    """The poses of an exercise as matrices: T_db, T_de, and T_bc from the arm's angles."""
    found = {}
    if "x_b" in given:
        found["T_db"] = frames.se2(given["x_b"], given["y_b"], given["theta_b"])
    if "x_e" in given:
        found["T_de"] = frames.se2(given["x_e"], given["y_e"], given["theta_e"])
    if "alpha" in given:
        found["T_bc"] = hand(given["alpha"], given["beta"], given["gamma"])
    return found


def posed(formula):
    """A formula of matrices as one of the numbers given, for the pose [x, y, theta]."""
    return lambda **given: numbers_of(formula(**planar(**given)))


def matrices(formula):
    """A formula of matrices as one of the numbers given."""
    return lambda **given: formula(**planar(**given))


def at_point(formula):
    """A formula of T_bc and a point, as one of the numbers given."""
    return lambda x, y, **arm: formula(hand(**arm), np.array([x, y]))


def by_hand(formula):
    """A formula of T_db and T_bc, where the pose of the hand is given as numbers."""
    return lambda x, y, theta, **given: formula(
        T_bc=frames.se2(x, y, theta), T_db=planar(**given)["T_db"]
    )


def looking_down(x_b, y_b, height, heading):
    """T_fb for a camera that looks straight down, its x axis along the room's."""
    c, s = np.cos(heading), np.sin(heading)
    return frames.se3([[c, -s, 0], [-s, -c, 0], [0, 0, -1]], [x_b, y_b, height])


def from_above(formula):
    """A formula of T_fb in space and a point, as one of the numbers given."""
    return lambda x_b, y_b, height, heading, x_e, y_e, z_e: formula(
        looking_down(x_b, y_b, height, heading), np.array([x_e, y_e, z_e])
    )


PLACE = steps(-2, 2, 0.2, "m")
TURN = one_of(*range(-150, 0, 10), *range(10, 160, 10), unit="°")
ARM = {
    "alpha": steps(-60, 60, 10, "°"),
    "beta": one_of(*range(-120, -20, 10), *range(30, 130, 10), unit="°"),
    "gamma": steps(-60, 60, 10, "°"),
}
PLATFORM = {"x_b": PLACE, "y_b": PLACE, "theta_b": TURN}
OBJECT = {"x_e": PLACE, "y_e": PLACE, "theta_e": TURN}

PLATFORM_SEEN = "the platform b at x = {x_b}, y = {y_b}, turned by {theta_b}"
OBJECT_SEEN = "the object e at x = {x_e}, y = {y_e}, turned by {theta_e}"
ARM_STANDS = (
    "The arm on a platform b has links of 30 cm and 40 cm and the joint angles α = {alpha}, "
    "β = {beta}, γ = {gamma}, each counted from the link before (α from the platform's x axis). "
    "Its hand frame c lies at the third joint, turned by γ against the second link."
)
ARM_FOUND = (
    "The hand as the platform sees it: its position is [0.3 cos α + 0.4 cos(α + β), "
    "0.3 sin α + 0.4 sin(α + β)] = {p_c} m, and it is turned by α + β + γ = {theta_c:deg}."
)


def shown_arm(alpha, beta, gamma, **_):
    """What solutions show of the arm."""
    return {"p_c": wrist(alpha, beta), "theta_c": alpha + beta + gamma}


def both_inverses(T_db, T_bc):
    """M10 for T_cd: both poses inverted in the wrong way, or their product."""
    back = shifted_back(T_bc) @ shifted_back(T_db), shifted_back(T_db @ T_bc)
    return [numbers_of(T) for T in back]


frames_1 = Exercise(
    "frames-1",
    level=1,
    title="Seen from the other end",
    text=f"On the plan of a room, a camera d sees {PLATFORM_SEEN}. How does the platform see the "
    "camera: at what x and y, and turned by what angle?",
    given=PLATFORM,
    asks=POSE,
    right=posed(lambda T_db: frames.inverse(T_db)),
    wrong={M10: posed(lambda T_db: shifted_back(T_db))},
    derive=lambda x_b, y_b, theta_b: {
        "R": frames.se2(x_b, y_b, theta_b)[:2, :2].T,
    },
    also={
        "for the platform as the camera sees it: nothing is turned back": posed(lambda T_db: T_db),
    },
    solution="With T_db = [R, p; 0, 1], the pose seen from the other end is "
    "T_bd = [Rᵀ, −Rᵀp; 0, 1]. It is turned by −θ. Its position is the way back, −p, measured "
    "along the axes of the platform:\n\n"
    "−Rᵀp = −{R} [{x_b:}, {y_b:}]\n\n[x, y, θ] = {right}",
)

frames_2 = Exercise(
    "frames-2",
    level=2,
    title="What the hand sees",
    text=f"{ARM_STANDS} The platform sees an object at x = {{x}}, y = {{y}}. Where does the hand "
    "see it, along the x and y axes of c?",
    given=ARM | {"x": steps(0.2, 1, 0.1, "m"), "y": steps(-0.8, 0.8, 0.1, "m")},
    asks=(Ask("x", "m"), Ask("y", "m")),
    right=at_point(lambda T_bc, p: frames.transform(frames.inverse(T_bc), p)),
    wrong={
        M10: at_point(lambda T_bc, p: frames.transform(shifted_back(T_bc), p)),
        M30: at_point(lambda T_bc, p: frames.transform(T_bc, p)),
    },
    derive=lambda x, y, **arm: {
        **shown_arm(**arm),
        "way": [x, y] - wrist(arm["alpha"], arm["beta"]),
    },
    solution=f"{ARM_FOUND}\n\nFrom the hand to the object leads [{{x:}}, {{y:}}] − {{p_c}} = "
    "{way} m, still along the axes of b. Rᵀ turns this to the axes of c:\n\n"
    "Rᵀ(p − p_c) = {right}",
)

frames_3 = Exercise(
    "frames-3",
    level=2,
    title="What the platform sees",
    text=f"On the plan of a room, a camera d sees {PLATFORM_SEEN}, and {OBJECT_SEEN}. How does "
    "the platform see the object: at what x and y, and turned by what angle?",
    given=PLATFORM | OBJECT,
    asks=POSE,
    right=posed(lambda T_db, T_de: frames.compose(frames.inverse(T_db), T_de)),
    wrong={
        M9: posed(lambda T_db, T_de: T_db @ T_de),
        M10: posed(lambda T_db, T_de: shifted_back(T_db) @ T_de),
    },
    derive=lambda x_b, y_b, x_e, y_e, **_: {"way": np.array([x_e - x_b, y_e - y_b])},
    also={
        "along the camera's axes; asked are the platform's": lambda x_b, y_b, x_e, y_e, **turns: [
            x_e - x_b,
            y_e - y_b,
            turns["theta_e"] - turns["theta_b"],
        ],
        "for the platform as the object sees it": posed(
            lambda T_db, T_de: frames.compose(frames.inverse(T_de), T_db)
        ),
    },
    solution="From b to e the way leads over d: T_be = T_bd T_de, with T_bd = T_db⁻¹.\n\n"
    "In numbers: from the platform to the object leads {way} m along the camera's axes. Rᵀ with "
    "{theta_b} turns this to the axes of the platform. The object is turned by {theta_e} − "
    "({theta_b}) against the platform.\n\n[x, y, θ] = {right}",
)

frames_4 = Exercise(
    "frames-4",
    level=2,
    title="The camera as the hand sees it",
    text=f"On the plan of a room, a camera d sees {PLATFORM_SEEN}. The platform sees the hand c of "
    "its arm at x = {x}, y = {y}, turned by {theta}. How does the hand see the camera: at what x "
    "and y, and turned by what angle?",
    given=PLATFORM
    | {"x": steps(0.1, 0.7, 0.1, "m"), "y": steps(-0.5, 0.5, 0.1, "m"), "theta": TURN},
    asks=POSE,
    right=by_hand(lambda T_db, T_bc: numbers_of(frames.inverse(frames.compose(T_db, T_bc)))),
    wrong={
        M9: by_hand(lambda T_db, T_bc: numbers_of(T_db @ T_bc)),
        M10: by_hand(both_inverses),
        M11: by_hand(lambda T_db, T_bc: numbers_of(frames.inverse(T_db) @ frames.inverse(T_bc))),
        M30: by_hand(lambda T_db, T_bc: numbers_of(T_bc @ frames.inverse(T_db))),
    },
    derive=by_hand(
        lambda T_db, T_bc: {
            "p_c": (T_db @ T_bc)[:2, 2],
            "theta_c": sum(numbers_of(T)[2] for T in (T_db, T_bc)),
        }
    ),
    solution="First from camera to hand: T_dc = T_db T_bc has the position {p_c} m and is turned "
    "by {theta_b} + ({theta}) = {theta_c:deg}. Then from the other end, [Rᵀ, −Rᵀp; 0, 1]:\n\n"
    "T_cd = (T_db T_bc)⁻¹ = T_bc⁻¹ T_db⁻¹\n\n[x, y, θ] = {right}",
)

frames_5 = Exercise(
    "frames-5",
    level=3,
    title="All the way to the object",
    text=f"{ARM_STANDS}\n\nOn the plan of the room, a camera d sees {PLATFORM_SEEN}, and "
    f"{OBJECT_SEEN}. What is T_ce, the pose of the object as the hand sees it, as a 3×3 matrix?",
    given=ARM | PLATFORM | OBJECT,
    asks=entries("T_ce"),
    shape=(3, 3),
    right=matrices(
        lambda T_db, T_bc, T_de: frames.compose(frames.inverse(T_bc), frames.inverse(T_db), T_de)
    ),
    wrong={
        M9: matrices(lambda T_db, T_bc, T_de: T_db @ T_bc @ T_de),
        M10: matrices(lambda T_db, T_bc, T_de: shifted_back(T_bc) @ shifted_back(T_db) @ T_de),
        M11: matrices(lambda T_db, T_bc, T_de: frames.inverse(T_db) @ frames.inverse(T_bc) @ T_de),
        M30: matrices(lambda T_db, T_bc, T_de: T_bc @ frames.inverse(T_db) @ T_de),
    },
    derive=lambda **given: {
        **planar(**given),
        **shown_arm(**given),
        "T_be": frames.inverse(planar(**given)["T_db"]) @ planar(**given)["T_de"],
    },
    also={
        "for the object as the platform sees it": matrices(
            lambda T_db, T_bc, T_de: frames.compose(frames.inverse(T_db), T_de)
        ),
        "for the hand as the object sees it": matrices(
            lambda T_db, T_bc, T_de: frames.compose(frames.inverse(T_de), T_db, T_bc)
        ),
    },
    solution=f"{ARM_FOUND}\n\nFrom c to e the way leads over b and d: "
    "T_ce = T_cb T_bd T_de = T_bc⁻¹ T_db⁻¹ T_de. Each inverse is [Rᵀ, −Rᵀp; 0, 1].\n\n"
    "T_be = T_db⁻¹ T_de = {T_be}\n\nT_ce = T_bc⁻¹ T_be = {right}",
    example={
        **{"alpha": np.pi / 6, "beta": np.pi / 3, "gamma": -np.pi / 6},
        **{"x_b": 2.0, "y_b": 1.0, "theta_b": np.pi / 2},
        **{"x_e": 1.0, "y_e": 2.0, "theta_e": np.pi / 4},
    },
)

frames_6 = Exercise(
    "frames-6",
    level=3,
    title="A camera that looks down",
    text="A camera f hangs {height} above the floor and looks straight down. Its x axis is that of "
    "the room, its z axis points to the floor, so its y axis is opposite to the room's y axis. It "
    "sees a platform b on the floor at x = {x_b}, y = {y_b}, z = {height}, and an object on a "
    "table at x = {x_e}, y = {y_e}, z = {z_e}. The platform's z axis points up, and its heading in "
    "the room is {heading} (counter-clockwise, seen from above). Where does the platform see the "
    "object?",
    given={
        "height": steps(2.4, 3.2, 0.1, "m"),
        "x_b": PLACE,
        "y_b": PLACE,
        "heading": TURN,
        "x_e": PLACE,
        "y_e": PLACE,
        "z_e": steps(1.4, 2, 0.1, "m"),
    },
    asks=(Ask("x", "m"), Ask("y", "m"), Ask("z", "m")),
    right=from_above(lambda T_fb, p: frames.transform(frames.inverse(T_fb), p)),
    wrong={
        M9: from_above(lambda T_fb, p: frames.transform(T_fb, p)),
        M10: from_above(lambda T_fb, p: frames.transform(shifted_back(T_fb), p)),
    },
    derive=lambda x_b, y_b, height, heading, x_e, y_e, z_e: {
        "R": looking_down(x_b, y_b, height, heading)[:3, :3],
        "way": np.array([x_e - x_b, y_e - y_b, z_e - height]),
    },
    also={
        "along the camera's axes; asked are the platform's": from_above(
            lambda T_fb, p: p - T_fb[:3, 3]
        ),
    },
    solution="The columns of R_fb are the platform's axes as the camera sees them. Forward is "
    "[cos φ, −sin φ, 0] with the heading φ, because the camera's y axis is turned round; left is "
    "[−sin φ, −cos φ, 0]; up is [0, 0, −1]:\n\nR_fb = {R}\n\n"
    "From the platform to the object leads p_fe − p_fb = {way} m. The transpose turns this to the "
    "platform's axes:\n\nR_fbᵀ (p_fe − p_fb) = {right}",
)

frames_7 = Exercise(
    "frames-7",
    level=3,
    title="Where must the platform stand?",
    text=f"{ARM_STANDS} A camera d sees {OBJECT_SEEN}. The platform must drive to a place from "
    "where the hand lies exactly on the object, turned as the object is, with the arm kept as it "
    "stands. At what x and y, and turned by what angle, must the camera then see the platform?",
    given=ARM | OBJECT,
    asks=POSE,
    right=posed(lambda T_de, T_bc: frames.compose(T_de, frames.inverse(T_bc))),
    wrong={
        M10: posed(lambda T_de, T_bc: T_de @ shifted_back(T_bc)),
        M30: posed(lambda T_de, T_bc: T_de @ T_bc),
    },
    derive=lambda alpha, beta, gamma, theta_e, **_: {
        **shown_arm(alpha, beta, gamma),
        "theta": theta_e - alpha - beta - gamma,
    },
    also={
        "for the camera as the platform sees it": posed(
            lambda T_de, T_bc: frames.compose(T_bc, frames.inverse(T_de))
        ),
    },
    solution=f"{ARM_FOUND}\n\nThe hand lies on the object when T_db T_bc = T_de. Multiply by "
    "T_bc⁻¹ from the right:\n\nT_db = T_de T_bc⁻¹\n\n"
    "The platform is turned by {theta_e} − ({theta_c:deg}) = {theta:deg}. Along the "
    "camera's axes the hand is R_db p_c away from the platform, so the platform must be at "
    "p_de − R_db p_c.\n\n"
    "[x, y, θ] = {right}",
)
