"""A figure of each kind, for tests: a drive, space, a builder, a pen, a cloud, a graph."""

import numpy as np
import sympy as sp

from book import things, things_space
from book.differential_drive import formulas as drive
from book.differential_drive.formulas import b, v_L, v_R
from book.frames.figures import point_of
from book.motion import formulas as motion
from book.motion.formulas import dt, omega, theta, v, x, y
from courseware.equations import quantity
from courseware.figures import (
    POINTER,
    TIME_STEP,
    VIEW,
    Arrow,
    Button,
    Choice,
    Cloud,
    Curve,
    Figure,
    Goal,
    Graph,
    Handle,
    Ink,
    Label,
    Line,
    Point,
    Readout,
    Scene,
    Simulation,
    Slider,
    assign,
    distance,
    when,
)

WIDE = 0.1  # m, between the wheels

# ---- a robot that drives on, and its tracks

here = sp.symbols("here_x here_y heading", real=True)
pose = dict(zip((x, y, theta), here, strict=True))
rolled = sp.symbols("rolled_L rolled_R", real=True)
left, right = (point_of(here, 0, side * WIDE / 2) for side in (1, -1))
ROAD = Scene(
    layers={
        "tracks": (Ink("left", left), Ink("right", right)),
        "robot": (things.robot(here, rolled),),
        "centre": when(
            sp.Abs(omega) > 0.01,
            Line("icr", (here, motion.icr.substitute(pose))),
            Point("icr", motion.icr.substitute(pose), "ICR"),
        ),
    },
    handles={},
    common={
        "view": (-0.4, 0.4, -0.2, 0.3),
        "ground": "tiles",
        "where": ((b, WIDE), *assign(drive.speed, drive.turning_rate)),
        "controls": (
            Simulation(
                "drive",
                (*here, *rolled),
                (-0.2, 0, 0.3, 0, 0),
                (
                    *motion.arc_step.substitute({**pose, dt: TIME_STEP}),
                    rolled[0] + v_L * TIME_STEP,
                    rolled[1] + v_R * TIME_STEP,
                ),
            ),
            Slider(v_L, -0.2, 0.2, 0.05, 0.01),
            Slider(v_R, -0.2, 0.2, 0.08, 0.01),
        ),
    },
)
DRIVES = ROAD.figure(
    "drives",
    "A robot that drives on while you set its wheels",
    "tracks robot centre",
    buttons=(Button("straight on", {v_R: v_L}),),
    readouts=(Readout(v), Readout(omega)),
    follow=here,
)

# ---- an arm in space that grips a ball

q1, q2, q3 = (quantity(f"q{k}", "rad", -3.2, 3.2, f"angle of joint {k}") for k in (1, 2, 3))
HIGH, UPPER, FORE = 0.2, 0.3, 0.25  # m


def _frames():
    """Return the rotations and places of the upper and the lower link, and where the hand is."""
    found, at = [], sp.Matrix([0, 0, HIGH])
    for angle, length in ((q2, UPPER), (q2 + q3, FORE)):
        along = sp.Matrix([sp.cos(q1) * sp.cos(angle), sp.sin(q1) * sp.cos(angle), sp.sin(angle)])
        up = sp.Matrix([-sp.cos(q1) * sp.sin(angle), -sp.sin(q1) * sp.sin(angle), sp.cos(angle)])
        found.append((sp.Matrix.hstack(along, up, along.cross(up)), list(at)))
        at += length * along
    return found, list(at)


(UPPER_AT, FORE_AT), HAND = _frames()
BALL = (0.3, 0.2, 0.25)
MISSED = sp.sqrt(sum((h - c) ** 2 for h, c in zip(HAND, BALL, strict=True)))
GRIPS = Figure(
    "grips",
    "An arm on its column, and a ball on a stand",
    (-0.62, 0.62, -0.24, 0.72),
    (
        things_space.floor(0, 0.6),
        VIEW.solid(things_space.column(HIGH), sp.eye(3), floor=0),
        VIEW.solid(things_space.link(UPPER, 0.06, 0.045), *UPPER_AT, floor=0),
        VIEW.solid(
            (*things_space.link(FORE, 0.045, 0.03, pale=True), *things_space.gripper(FORE - 0.09)),
            *FORE_AT,
            floor=0,
        ),
        VIEW.solid(things_space.stand(BALL[2]), sp.eye(3), (*BALL[:2], 0), floor=0),
        VIEW.solid(things_space.ball(), 0.03 * sp.eye(3), BALL, floor=0),
    ),
    (
        Slider.degrees(q1, -180, 180, -30, step=5),
        Slider.degrees(q2, 0, 180, 70, step=5),
        Slider.degrees(q3, -150, 150, -60, step=5),
    ),
    (Readout("off", "hand to ball", MISSED, "m"),),
    grid=False,
)  # fmt: skip

# ---- robots of one wheel, whose kinds have controls of their own

steered, swivel, kind_s, kind_c, kind_m = (
    quantity(name, "rad" if k < 2 else "", -3.2, 3.2, text)
    for k, (name, text) in enumerate(
        [
            ("steered", "how the wheel is steered"),
            ("swivel", "how the castor hangs"),
            ("kind_s", "whether it is steered"),
            ("kind_c", "whether it is a castor"),
            ("kind_m", "whether it is a Mecanum wheel"),
        ]
    )
)
turn = 0.2  # rad/s
BUILDS = Figure(
    "builds",
    "A platform with one wheel of a kind to choose",
    (-0.3, 0.3, -0.2, 0.2),
    (
        *when(kind_s > 0, things.steered_wheel((0.1, 0, 0), steered, "left2")),
        *when(kind_c > 0, things.castor((0.1, 0, 0), swivel)),
        *when(kind_m > 0, things.mecanum_wheel((0.1, 0, 0), "right2")),
        *when(kind_s > 0, Line("icr", ((0.1 + 0.3 * sp.sin(steered), -0.3 * sp.cos(steered)),
                                       (0.1 - 0.3 * sp.sin(steered), 0.3 * sp.cos(steered))))),
        Point("body", (0, 0), "P"),
    ),
    (
        Choice.one_hot("kind", (kind_s, kind_c, kind_m), ("steered", "castor", "Mecanum")),
        Slider.degrees(steered, -90, 90, 20, when=kind_s > 0),
        Slider.degrees(swivel, -180, 180, 60, when=kind_c > 0),
    ),
    ground="tiles",
)  # fmt: skip

# ---- an arm that draws

L1, L2 = 0.3, 0.25
tip = (L1 * sp.cos(q1) + L2 * sp.cos(q1 + q2), L1 * sp.sin(q1) + L2 * sp.sin(q1 + q2))
r = sp.sqrt(POINTER[0] ** 2 + POINTER[1] ** 2)
elbow = sp.acos(sp.Max(-1, sp.Min(1, (r**2 - L1**2 - L2**2) / (2 * L1 * L2))))
DOT = (0.1, 0.35)
DRAWS = Figure(
    "draws",
    "An arm with a pen, and a dot to draw to",
    (-0.3, 0.62, -0.1, 0.5),
    (
        Ink("path", tip),
        Point("target", DOT, "here"),
        things.arm((0, 0, 0), (q1, q2), (L1, L2), tool="pen"),
    ),
    (Slider.degrees(q1, -90, 180, 20), Slider.degrees(q2, 0, 150, 40)),
    (Readout("gap", "pen to dot", distance(tip, DOT), "m"),),
    handles=(
        Handle(
            "the pen",
            tip,
            {
                q1: sp.atan2(POINTER[1], POINTER[0])
                - sp.atan2(L2 * sp.sin(elbow), L1 + L2 * sp.cos(elbow)),
                q2: elbow,
            },
        ),
    ),
    ground="paper",
    goal=Goal(distance(tip, DOT) < 0.015, "Draw a line to the dot: within 15 mm."),
)

# ---- 200 robots that slip

far, spread = sp.symbols("far spread", real=True)
ROWS = tuple(map(tuple, np.random.default_rng(3).normal(0, 1, (200, 2)).round(3)))
length = quantity("length", "m", 0, 2, "how far they drive")
noise = quantity("noise", "", 0, 0.3, "how much they slip")
CLOUD = Figure(
    "strays",
    "200 robots that drive and slip",
    (-0.2, 2.4, -0.8, 0.8),
    (
        things.vacuum((0, 0, 0)),
        Cloud(
            "error",
            (length * sp.cos(noise * spread) + 0.1 * noise * far, length * sp.sin(noise * spread)),
            (far, spread),
            ROWS,
        ),
        things.vacuum((length, 0, 0), look="ghost"),
    ),
    (Slider(length, 0.2, 2.0, 1.5, 0.1), Slider(noise, 0.0, 0.3, 0.1, 0.02)),
    ground="tiles",
)

# ---- a graph whose dot is dragged

step = quantity("step", "s", 0.01, 10, "the step")
s = sp.Symbol("s", positive=True)
AXES = Graph((-0.12, 0.34, -0.1, 0.2), (0.01, 10), (1e-4, 1), ("step in s", "error in m"))
error = 0.1 * step**2 / (1 + step**2)
GRAPH = Figure(
    "error-of-a-step",
    "How the error of a step grows with the step",
    (-0.26, 0.4, -0.22, 0.28),
    (
        *AXES.shapes(),
        Curve("middle_heading", AXES.place((s, error.subs(step, s))), s, 0.01, 10),
        Point("error", AXES.place((step, error))),
        Arrow("velocity", (-0.2, 0), (-0.2, 0.1 * step / (1 + step))),
        Label("text", (-0.2, -0.06), "step"),
    ),
    (Slider(step, 0.01, 10.0, 1.0, 0.01),),
    (Readout("error", "error", error, "m", -2),),
    handles=(
        Handle("the dot", AXES.place((step, error)), {step: AXES.x_at(POINTER)}),
    ),
    ground="paper",
    grid=False,
)  # fmt: skip

SIX = (DRIVES, GRIPS, BUILDS, DRAWS, CLOUD, GRAPH)
