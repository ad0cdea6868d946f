"""One call of every public function on one item, as a figure or a control loop makes it."""

from collections.abc import Callable
from typing import Any

from robokin import (
    bicycle,
    differential_drive,
    elbow_arm,
    euler,
    frames,
    motion,
    odometry,
    planar_arm,
    wheels,
)

MODULES = (
    motion,
    frames,
    euler,
    elbow_arm,
    differential_drive,
    bicycle,
    wheels,
    odometry,
    planar_arm,
)
CLASSES = {"Wheel", "Mobility"}  # made by the functions beside them

POSE, TWIST = [1.0, 2.0, 0.5], [0.3, 0.1, 0.2]
ANGLES, LINKS, P = [0.1, 0.2, 0.3], [0.4, 0.3, 0.1], [0.3, 0.2, 0.4]
R = euler.to_matrix("ZYX", ANGLES)
T = frames.se3(R, POSE)
GRAPH = frames.FrameGraph()
GRAPH.add("d", "b", T)
GRAPH.add("b", "c", T)
GRAPH.add("d", "e", T)
OMNI = wheels.omni_robot(0.2, 0.05)
ENCODER = (1000, 0.05, 0.3)
SQUARES = [[0.1, 0.2], [0.1, 0.1]]

CALLS: dict[str, Callable[[], Any]] = {
    "motion.wrap_angle": lambda: motion.wrap_angle(7.0),
    "motion.to_world": lambda: motion.to_world(0.5, TWIST),
    "motion.to_body": lambda: motion.to_body(0.5, TWIST),
    "motion.arc_step": lambda: motion.arc_step(POSE, 1.0, 0.2, 0.1),
    "motion.move": lambda: motion.move(POSE, TWIST, 0.1),
    "motion.path": lambda: motion.path(POSE, [1.0], [0.2], 0.1),
    "motion.icr": lambda: motion.icr(POSE, 1.0, 0.2),
    "frames.se2": lambda: frames.se2(1.0, 2.0, 0.5),
    "frames.se3": lambda: frames.se3(R, POSE),
    "frames.inverse": lambda: frames.inverse(T),
    "frames.compose": lambda: frames.compose(T, T),
    "frames.transform": lambda: frames.transform(T, P),
    "frames.check_rotation": lambda: frames.check_rotation(R),
    "frames.FrameGraph": frames.FrameGraph,
    "frames.FrameGraph.add": lambda: frames.FrameGraph().add("a", "b", T),
    "frames.FrameGraph.get": lambda: GRAPH.get("c", "e"),
    "frames.FrameGraph.path": lambda: GRAPH.path("c", "e"),
    "euler.to_matrix": lambda: euler.to_matrix("ZYX", ANGLES),
    "euler.from_matrix": lambda: euler.from_matrix("ZYX", R),
    "euler.solutions": lambda: euler.solutions("ZYX", R),
    "euler.is_locked": lambda: euler.is_locked("ZYX", R),
    "euler.steps": lambda: euler.steps("ZYX", ANGLES),
    "euler.axis_angle": lambda: euler.axis_angle(R),
    "elbow_arm.forward": lambda: elbow_arm.forward(ANGLES, 0.4, 0.3, 0.1),
    "elbow_arm.inverse": lambda: elbow_arm.inverse(P, 0.4, 0.3, 0.1),
    "elbow_arm.joint_positions": lambda: elbow_arm.joint_positions(ANGLES, 0.4, 0.3, 0.1),
    "elbow_arm.nearest_reachable": lambda: elbow_arm.nearest_reachable(P, 0.4, 0.3, 0.1),
    "elbow_arm.on_base_axis": lambda: elbow_arm.on_base_axis(P),
    "elbow_arm.reach": lambda: elbow_arm.reach(0.4, 0.3),
    "differential_drive.body_twist": lambda: differential_drive.body_twist(1.0, 2.0, 0.05, 0.3),
    "differential_drive.wheel_rates": lambda: differential_drive.wheel_rates(0.1, 0.5, 0.05, 0.3),
    "bicycle.ackermann": lambda: bicycle.ackermann(0.5, 2.5, 1.5),
    "bicycle.ackermann_error": lambda: bicycle.ackermann_error(0.5, 0.4, 2.5, 1.5),
    "bicycle.body_twist": lambda: bicycle.body_twist(1.0, 0.3, 2.5),
    "bicycle.equivalent_steering": lambda: bicycle.equivalent_steering(0.5, 0.4),
    "bicycle.front_twist": lambda: bicycle.front_twist(1.0, 0.3, 2.5),
    "bicycle.path": lambda: bicycle.path(POSE, [1.0], [0.3], 2.5, 0.1),
    "bicycle.turning_radius": lambda: bicycle.turning_radius(0.3, 2.5),
    "wheels.fixed": lambda: wheels.fixed(0.2, 0.0, 0.0, 0.05),
    "wheels.steered": lambda: wheels.steered(0.2, 0.0, 0.0, 0.05),
    "wheels.castor": lambda: wheels.castor(0.2, 0.0, 0.0, 0.05, -0.1),
    "wheels.swedish": lambda: wheels.swedish(0.2, 0.0, 0.0, 0.05, 0.7),
    "wheels.spherical": lambda: wheels.spherical(0.2, 0.0, 0.05),
    "wheels.omni_robot": lambda: wheels.omni_robot(0.2, 0.05),
    "wheels.rolling": lambda: wheels.rolling(OMNI),
    "wheels.rolling_rates": lambda: wheels.rolling_rates(OMNI),
    "wheels.sliding": lambda: wheels.sliding(OMNI),
    "wheels.forward": lambda: wheels.forward(OMNI, [1.0, 2.0, 3.0]),
    "wheels.slip": lambda: wheels.slip(OMNI, [1.0, 2.0, 3.0]),
    "wheels.inverse": lambda: wheels.inverse(OMNI, TWIST),
    "wheels.mobility": lambda: wheels.mobility(OMNI),
    "odometry.travel": lambda: odometry.travel(500, 1000, 0.05),
    "odometry.unwrap_counter": lambda: odometry.unwrap_counter([65530, 4], 16),
    "odometry.path": lambda: odometry.path([9], [12], *ENCODER),
    "odometry.velocity": lambda: odometry.velocity(9, 12, 0.1, *ENCODER),
    "odometry.covariance": lambda: odometry.covariance([9], [12], *ENCODER, 1e-4),
    "odometry.umbmark": lambda: odometry.umbmark(SQUARES, SQUARES, 4.0, 0.3),
    "planar_arm.forward": lambda: planar_arm.forward(ANGLES, LINKS),
    "planar_arm.inverse": lambda: planar_arm.inverse([0.4, 0.4, 0.0], LINKS),
    "planar_arm.joint_positions": lambda: planar_arm.joint_positions(ANGLES, LINKS),
    "planar_arm.jacobian": lambda: planar_arm.jacobian(ANGLES, LINKS),
    "planar_arm.velocity": lambda: planar_arm.velocity(ANGLES, TWIST, LINKS),
    "planar_arm.joint_rates": lambda: planar_arm.joint_rates(ANGLES, TWIST, LINKS),
    "planar_arm.manipulability": lambda: planar_arm.manipulability(ANGLES, LINKS),
    "planar_arm.ellipse": lambda: planar_arm.ellipse(ANGLES, LINKS),
}


def public_functions() -> set[str]:
    """What the modules say is public, as `module.function`."""
    return {
        f"{module.__name__.removeprefix('robokin.')}.{name}"
        for module in MODULES
        for name in set(module.__all__) - CLASSES
    }
