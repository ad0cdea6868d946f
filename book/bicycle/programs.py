"""Programs that students write on the bicycle model."""

import numpy as np

from book.bicycle.exercises import M15, M16
from book.bicycle.formulas import alpha_L, alpha_R, steering, track, wheelbase
from book.motion.formulas import dt, theta, v, x, y
from courseware.practice import Unknown, angle
from courseware.programs.declaration import Program
from robokin import bicycle, motion

POSE = (Unknown("x", "m"), Unknown("y", "m"), angle("θ"))
AHEAD = {steering: 0.0}


def on_circle(pose, v, phi, L, dt):
    """M15 in a step: the sines' difference in y too."""
    x, y, theta = pose
    R, turned = bicycle.turning_radius(phi, L), theta + v / L * np.tan(phi) * dt
    along = R * (np.sin(turned) - np.sin(theta))
    return [x + along, y - along, turned]


STEP = '''\
def car_step(pose, v, phi, L, dt):
    """Return the pose [x, y, theta] after a drive of dt seconds.

    pose: array of x, y [m] and heading [rad]; v [m/s], phi [rad], L [m], dt [s].
    """
    ...
'''

bicycle_p1 = Program(
    "bicycle-p1",
    title="The exact step",
    text="Write the exact step of Hold the steering: where is the middle of the rear axle after "
    "dt seconds, at constant speed v and steering angle phi? Straight ahead must work, too.",
    starter=STEP,
    symbols=(x, y, theta, v, steering, wheelbase, dt),
    arguments=lambda x, y, theta, v, phi, L, dt: ([x, y, theta], v, phi, L, dt),
    specials={
        "straight ahead": AHEAD,
        "almost straight ahead": {steering: 1e-9},
        "at rest": {v: 0.0},
        "at rest, straight ahead": {v: 0.0, **AHEAD},
        "no time": {dt: 0.0},
        "past half a turn": {theta: 3.1},
    },
    answer=POSE,
    right=lambda pose, v, phi, L, dt: bicycle.path(pose, v, phi, L, dt)[-1],
    wrong={
        M15: on_circle,
        M16: lambda pose, v, phi, L, dt: motion.arc_step(
            pose, v, bicycle.body_twist(v, phi, L)[2] / np.cos(phi), dt
        ),
    },
    also={
        "with straight steps along the old heading": lambda pose, v, phi, L, dt: bicycle.path(
            pose, v, phi, L, dt, method="start"
        )[-1],
    },
    hints=("ok", "two"),
    solution='''\
def car_step(pose, v, phi, L, dt):
    x, y, theta = pose
    turn = v * dt / L * np.tan(phi)
    if turn == 0:
        return np.array([x + v * dt * np.cos(theta), y + v * dt * np.sin(theta), theta])
    R = v * dt / turn
    half = turn / 2
    chord = 2 * R * np.sin(half)
    return np.array([x + chord * np.cos(theta + half), y + chord * np.sin(theta + half), theta + turn])
''',
)
