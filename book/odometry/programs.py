"""Programs that students write on odometry."""

from dataclasses import replace

import numpy as np
from sympy import Symbol, cos, pi, sin

from book import things
from book.differential_drive.exercises import degrees_taken, half_wheel_distance
from book.differential_drive.formulas import b, r
from book.motion.formulas import theta, x, y
from book.odometry.exercises import (
    arctan_heading,
    counter_jump,
    degrees_step,
    half_seen_heading,
    half_seen_step,
    heading_forgotten,
    jumped,
    lost_heading,
    one_step,
    rolled,
    rolled_per_radian,
    ticks_per_radian,
)
from book.odometry.formulas import (
    N_L,
    N_R,
    C,
    count_before,
    count_now,
    counter_span,
    side,
    x_ccw,
    x_cw,
    y_ccw,
    y_cw,
)
from courseware.answers import Unknown, angle
from courseware.figures import Arrow, Curve
from courseware.programs.program import Program
from robokin import odometry

POSE = (Unknown("x", "m"), Unknown("y", "m"), angle("θ"))


# --- p1 --------------------------------------------------------------------------------------


def calibrate(end_cw, end_ccw, side, b):
    """Return the wheel distance and the ratio of the wheels, from one run each way."""
    return odometry.umbmark([end_cw], [end_ccw], side, b)


def bent(end_cw, end_ccw, side, b, *, corner=1.0, ratio_b=lambda true, _: true):
    """Return the same by formulas, with a mistake: part of the corner, the distance in the ratio.

    Exchanging the parts x and y of the second end exchanges the two angles.
    """
    true, _ = calibrate(corner * end_cw, corner * end_ccw, side, b)
    beta = (end_ccw[0] - end_ccw[1] - end_cw.sum()) / (8 * side)
    bulge = ratio_b(true, b) * np.sin(beta / 2)
    return true, (side + bulge) / (side - bulge)


def draw_wheels(right, answer, end_cw, end_ccw, side, b):
    """Draw the wheels of two robots, one above the other."""

    def wheels(found, y, look=""):
        distance, ratio = found
        sides = ((1, "left2", 1), (-1, "right2", ratio))
        return [
            replace(
                things.wheel((y, way * distance / 2, 0), 0.6, 0.18, stripe),
                look=look,
                size=b * size,
            )
            for way, stripe, size in sides
        ]

    return *wheels(right, 0), *wheels(answer, 1.2 * b, "wrong")


SQUARES_TEXT = (
    "Write the test of Two squares: from the two ends to the true wheel distance and to the "
    "ratio of the wheels. Both squares begin at (0, 0), and their first side lies on the x axis. "
    "Use step 7's formulas: the mean of what x and y tell; a side is a chord. A robot "
    "that comes home exactly must work, too."
)
SQUARES = '''\
def calibrate(end_cw, end_ccw, side, b):
    """Return the true wheel distance [m] and the wheels' ratio, right by left.

    end_cw, end_ccw: arrays of x, y [m], where the squares really end;
    side: of the square [m]; b: the wheel distance that was believed [m].
    """
    ...
'''
SQUARES_HINTS = (
    "Two angles come first: by α each corner turns too little, by β each side swings to the left. "
    "The sum and the difference of the ends separate them.",
    "Both angles have 8 L below. Above, α has y_ccw − x_ccw − x_cw − y_cw, and β has x_ccw − y_ccw "
    "− x_cw − y_cw.",
    "The wheel distance is π b/(π − 2α). With this new one, not with b, the bulge is b_true "
    "sin(β/2), and the ratio is side plus bulge over side minus bulge.",
)
SQUARES_SOLUTION = """\
def calibrate(end_cw, end_ccw, side, b):
    (x_cw, y_cw), (x_ccw, y_ccw) = end_cw, end_ccw
    alpha = (y_ccw - x_ccw - x_cw - y_cw) / (8 * side)  # a corner turns too little
    beta = (x_ccw - y_ccw - x_cw - y_cw) / (8 * side)  # a side swings
    b_true = np.pi * b / (np.pi - 2 * alpha)
    bulge = b_true * np.sin(beta / 2)
    return np.array([b_true, (side + bulge) / (side - bulge)])
"""
SQUARES_SPECIALS = {
    "with no error": {x_cw: 0.0, y_cw: 0.0, x_ccw: 0.0, y_ccw: 0.0},
    "with equal wheels": {x_cw: -0.1, y_cw: -0.1, x_ccw: -0.1, y_ccw: 0.1},
    "with the right wheel distance": {x_cw: -0.1, y_cw: -0.1, x_ccw: 0.1, y_ccw: -0.1},
}
SQUARES_SLIPS = {
    "when the two runs are exchanged": lambda cw, ccw, side, b: calibrate(ccw, cw, side, b),
    "when the two angles are exchanged": lambda cw, ccw, side, b: calibrate(cw, ccw[::-1], side, b),
    "with the ratio of the left wheel by the right one": lambda *given: (
        np.array(calibrate(*given)) ** [1, -1]
    ),
    "with the believed wheel distance in the ratio": lambda *given: bent(
        *given, ratio_b=lambda _, b: b
    ),
    "when a corner loses α once: two wheels make it 2α": lambda *given: bent(*given, corner=0.5),
    "with 4 L below, where 8 L belongs": lambda cw, ccw, side, b: bent(2 * cw, 2 * ccw, side, b),
}

odometry_p1 = Program(
    "odometry-p1",
    title="The test of two squares",
    text=SQUARES_TEXT,
    starter=SQUARES,
    symbols=(x_cw, y_cw, x_ccw, y_ccw, side, b),
    arguments=lambda x_cw, y_cw, x_ccw, y_ccw, *sizes: ([x_cw, y_cw], [x_ccw, y_ccw], *sizes),
    ranges={side: (1, 5)},
    specials=SQUARES_SPECIALS,
    answer=(Unknown("wheel distance", "m"), Unknown("ratio")),
    right=calibrate,
    picture=draw_wheels,
    extent=0.4,
    likely_slips=SQUARES_SLIPS,
    hints=SQUARES_HINTS,
    solution=SQUARES_SOLUTION,
)


# --- p2 --------------------------------------------------------------------------------------


def between(before, after, span):
    """Return the ticks between two readings."""
    return odometry.unwrap_counter([before, after], modulus=span)[0]


def often_round(before, after, span):
    """Return whether a counter has these readings, of which nearly half pass its end or 0."""
    before, after, span = int(before), int(after), int(span)
    apart = abs(after - before) / span
    return max(before, after) < span and apart > 0.25 and abs(apart - 0.5) > 0.0005


def draw_counter(right, answer, before, after, span):
    """Draw the numbers of the counter on a circle, 0 at the right, and the way on it."""
    part = Symbol("part", real=True)

    def at(ticks, radius):
        way = 2 * pi * ticks / span
        return radius * cos(way), radius * sin(way)

    ways = (
        Curve(kind, at(before + part * ticks, radius + 0.1 * part), part, 0, 1, 200)
        for kind, ticks, radius in (("path", right, 0.8), ("error", answer, 1.05))
    )
    readings = (("text", before), ("target", after))
    return (
        Curve("ghost", at(part, 0.7), part, 0, span),
        *(Arrow(kind, (0, 0), at(ticks, 0.65)) for kind, ticks in readings),
        *ways,
    )


COUNTER_TEXT = (
    "Write the counter that wraps round: how many ticks are between two readings? It counts up "
    "when the wheel rolls forward, down when it rolls backward. After its last number it shows 0, "
    "and below 0 its last number again. The shorter way round is meant. (Two ways that are equally "
    "long are not asked.)"
)
COUNTER = '''\
def ticks_between(before, after, span):
    """Return the ticks between two readings, forward positive.

    before, after: readings of the counter; span: how many numbers it can show:
    0, 1, … up to span − 1. Whole numbers.
    """
    ...
'''
COUNTER_HINTS = (
    "The difference of the readings is right, as long as the counter has not passed its end. How "
    "large can it be then?",
    "A difference of more than half the span is the longer way round. Then a whole span has to be "
    "added or taken away: there are two cases.",
    "All in one line: add half the span to the difference, take the rest of the division by the "
    "span (%), and take the half away again.",
)
COUNTER_SOLUTION = """\
def ticks_between(before, after, span):
    return (after - before + span / 2) % span - span / 2
"""
COUNTER_SPECIALS = {
    "past the last number": {count_before: 990, count_now: 20, counter_span: 1000},
    "below 0": {count_before: 20, count_now: 990, counter_span: 1000},
    "almost half round": {count_before: 0, count_now: 499, counter_span: 1000},
    "a little more than half round": {count_before: 0, count_now: 501, counter_span: 1000},
    "the same reading": {count_before: 70, count_now: 70},
}
COUNTER_SLIPS = {
    "when the counter is taken to have one number less: with 0 it has span numbers": (
        lambda before, after, span: (
            jumped(before, after) - (span - 1) * np.rint((after - before) / span)
        )
    ),
    "when a wheel never rolls backward": lambda before, after, span: (after - before) % span,
    "when a wheel never rolls forward": lambda before, after, span: -((before - after) % span),
    "without the sign": lambda *readings: abs(between(*readings)),
    "when only the end of the numbers is seen, not 0": lambda before, after, span: (
        jumped(before, after) if after > before else between(before, after, span)
    ),
    "when only 0 is seen, not the end of the numbers": lambda before, after, span: (
        jumped(before, after) if after < before else between(before, after, span)
    ),
}

odometry_p2 = Program(
    "odometry-p2",
    title="A counter that wraps round",
    text=COUNTER_TEXT,
    starter=COUNTER,
    symbols=(count_before, count_now, counter_span),
    arguments=lambda *readings: [int(n) for n in readings],
    ranges={count_before: (0, 5000), count_now: (0, 5000), counter_span: (1000, 8000)},
    when=often_round,
    specials=COUNTER_SPECIALS,
    answer=(Unknown("ticks", "ticks"),),
    right=between,
    picture=draw_counter,
    extent=0,
    wrong={counter_jump: lambda before, after, span: jumped(before, after)},
    likely_slips=COUNTER_SLIPS,
    hints=COUNTER_HINTS,
    solution=COUNTER_SOLUTION,
)


# --- p3 --------------------------------------------------------------------------------------


def sampled(step, roll=rolled):
    """Return a step of the exercises as a function of ticks."""

    def of_ticks(pose, N_L, N_R, C, r, b):
        x, y, theta = pose
        return step(theta=theta, D_L=roll(N_L, C, r), D_R=roll(N_R, C, r), b=b, x=x, y=y)

    return of_ticks


def new_heading(**step):
    """Return the pose by the rule of the new heading."""
    return one_step("end", **step)


def draw_sample(right, answer, pose, N_L, N_R, C, r, b):
    def robot(at, look=""):
        return replace(things.vacuum(at, look=look), size=b / 0.244)

    return robot(pose, "ghost"), robot(right), robot(answer, "wrong")


SAMPLE_TEXT = (
    "This program adds a sample to the pose, by the rule of the new heading: the robot first "
    "turns, and then drives straight on. The heading is to stay between −180° and 180°. On many "
    "drives the program is right, on others it is wrong. Find the mistake, and mend it. Every "
    "heading must work, a turn on the spot, and a sample without ticks. (A heading that is more "
    "by whole turns counts as the same.)"
)
SAMPLE = '''\
def add_sample(pose, N_L, N_R, C, r, b):
    """Return the pose [x, y, theta] after a sample, by the new heading.

    pose: array of x, y [m], theta [rad]; N_L, N_R: ticks; C: ticks of a turn;
    r: wheel radius [m]; b: wheel distance [m].
    """
    x, y, theta = pose
    D_L, D_R = 2 * np.pi * r * N_L / C, 2 * np.pi * r * N_R / C
    D = (D_L + D_R) / 2
    theta = theta + (D_R - D_L) / b
    theta = np.arctan(np.sin(theta) / np.cos(theta))
    return np.array([x + D * np.cos(theta), y + D * np.sin(theta), theta])
'''
SAMPLE_HINTS = (
    "Into which directions does the robot look where the program is wrong?",
    "Try a robot that looks along −x, with the heading π, and drives straight on. Which heading "
    "does the program give?",
    "sin/cos is the same for opposite directions, so np.arctan never looks backward. np.arctan2 "
    "takes the sine and the cosine one by one, in this order.",
)
SAMPLE_SPECIALS = {
    "without ticks": {N_L: 0.0, N_R: 0.0},
    "straight ahead": {N_L: 200.0, N_R: 200.0},
    "on the spot": {N_L: -100.0, N_R: 100.0},
    "looking backward": {theta: 3.0, N_L: 200.0, N_R: 200.0},
    "across 180°": {theta: 3.1, N_L: 100.0, N_R: 200.0, C: 700.0, r: 0.05, b: 0.5},
    "across −180°": {theta: -3.1, N_L: 200.0, N_R: 100.0, C: 700.0, r: 0.05, b: 0.5},
}
SAMPLE_MISTAKES = {
    half_wheel_distance: sampled(half_wheel_distance.formula.wrap(new_heading)),
    degrees_taken: sampled(degrees_step),
    lost_heading: sampled(heading_forgotten),
    arctan_heading: sampled(half_seen_step),
    ticks_per_radian: sampled(new_heading, roll=rolled_per_radian),
}
SAMPLE_SLIPS = {
    "by the rule of the old heading": sampled(lambda **step: one_step("start", **step)),
    "by the rule of the middle heading": sampled(lambda **step: one_step("midpoint", **step)),
    "along the exact arc": sampled(lambda **step: one_step("exact", **step)),
    "when only the heading that is answered is taken as tan⁻¹(sin/cos)": sampled(half_seen_heading),
    "when left and right are exchanged": lambda pose, N_L, N_R, *robot: sampled(new_heading)(
        pose, N_R, N_L, *robot
    ),
}

odometry_p3 = Program(
    "odometry-p3",
    title="Mend the sample",
    text=SAMPLE_TEXT,
    starter=SAMPLE,
    symbols=(x, y, theta, N_L, N_R, C, r, b),
    arguments=lambda x, y, theta, N_L, N_R, *robot: ([x, y, theta], int(N_L), int(N_R), *robot),
    ranges={N_L: (-400, 400), N_R: (-400, 400), C: (200, 2000), r: (0.02, 0.1), b: (0.1, 0.6)},
    specials=SAMPLE_SPECIALS,
    answer=POSE,
    right=sampled(new_heading),
    picture=draw_sample,
    extent=0.18,
    wrong=SAMPLE_MISTAKES,
    likely_slips=SAMPLE_SLIPS,
    hints=SAMPLE_HINTS,
    solution=SAMPLE.replace(
        "np.arctan(np.sin(theta) / np.cos(theta))", "np.arctan2(np.sin(theta), np.cos(theta))"
    ),
)
