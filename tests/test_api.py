"""The public face of the package: its names, its docstrings, and what importing it loads."""

import doctest
import importlib
import inspect
import re
import subprocess
import sys

import pytest

import robokin

# The names that chapters and other people's code rely on, and the arguments of each function, in
# order, a default as it prints (None: a class). A change here is a change for them.
SIGNATURES = {
    "errors.RobokinError": None,
    "errors.SingularError": None,
    "errors.UnreachableError": None,
    "motion.wrap_angle": "angle",
    "motion.to_world": "theta, twist",
    "motion.to_body": "theta, twist",
    "motion.arc_step": "pose, v, omega, dt",
    "motion.move": "pose, twist, dt",
    "motion.path": "pose, v, omega, dt, method='exact'",
    "motion.icr": "pose, v, omega",
    "frames.FrameGraph": None,
    "frames.se2": "x, y, theta",
    "frames.se3": "rotation, position",
    "frames.pose": "T",
    "frames.dh": "theta, d, a, alpha",
    "frames.inverse": "T",
    "frames.compose": "*transforms",
    "frames.transform": "T, points",
    "frames.check_rotation": "R, tol=…",
    "euler.to_matrix": "seq, angles",
    "euler.from_matrix": "seq, R",
    "euler.solutions": "seq, R",
    "euler.is_locked": "seq, R, tol=1e-09",
    "euler.steps": "seq, angles",
    "euler.about": "axis, angle",
    "euler.axis_angle": "R",
    "elbow_arm.forward": "theta, a2, a3, d1=0.0",
    "elbow_arm.inverse": "p, a2, a3, d1=0.0, unreachable='raise'",
    "elbow_arm.joint_positions": "theta, a2, a3, d1=0.0",
    "elbow_arm.reach": "a2, a3",
    "elbow_arm.nearest_reachable": "p, a2, a3, d1=0.0",
    "elbow_arm.on_base_axis": "p, tol=…",
    "differential_drive.body_twist": "rate_left, rate_right, wheel_radius, wheel_distance",
    "differential_drive.turning_radius": "rate_left, rate_right, wheel_distance",
    "differential_drive.wheel_rates": "v, omega, wheel_radius, wheel_distance",
    "bicycle.equivalent_steering": "alpha_left, alpha_right",
    "bicycle.ackermann": "phi, wheelbase, track",
    "bicycle.turning_radius": "phi, wheelbase",
    "bicycle.corner_cut": "phi, wheelbase",
    "bicycle.lane_width": "phi, wheelbase, track",
    "bicycle.ackermann_error": "alpha_left, alpha_right, wheelbase, track",
    "bicycle.body_twist": "v, phi, wheelbase",
    "bicycle.front_twist": "v, phi, wheelbase",
    "bicycle.path": "pose, v, phi, wheelbase, dt, method='exact'",
    "wheels.Mobility": None,
    "wheels.Wheel": None,
    "wheels.fixed": "l, alpha, beta, radius",
    "wheels.steered": "l, alpha, beta, radius",
    "wheels.castor": "l, alpha, beta, radius, d",
    "wheels.swedish": "l, alpha, beta, radius, gamma",
    "wheels.spherical": "l, alpha, radius",
    "wheels.omni_robot": "l, radius, angles=(0, 2.0943951023931953, 4.1887902047863905)",
    "wheels.rolling": "wheels, steering=None",
    "wheels.rolling_rates": "wheels",
    "wheels.sliding": "wheels, steering=None",
    "wheels.forward": "wheels, rates, steering=None, theta=0.0",
    "wheels.slip": "wheels, rates, steering=None",
    "wheels.inverse": "wheels, twist, steering=None, theta=0.0, slipping='raise'",
    "wheels.mobility": "wheels",
    "odometry.travel": "ticks, ticks_per_turn, wheel_radius",
    "odometry.unwrap_counter": "counts, bits",
    "odometry.path": "ticks_left, ticks_right, ticks_per_turn, wheel_radius, wheel_distance, "
    "pose=(0, 0, 0), method='exact'",
    "odometry.velocity": "ticks_left, ticks_right, dt, ticks_per_turn, wheel_radius, "
    "wheel_distance",
    "odometry.covariance": "ticks_left, ticks_right, ticks_per_turn, wheel_radius, "
    "wheel_distance, noise, pose=(0, 0, 0), start=None",
    "odometry.ellipse": "covariance",
    "odometry.umbmark": "ends_cw, ends_ccw, side, wheel_distance",
    "planar_arm.forward": "theta, lengths",
    "planar_arm.joint_positions": "theta, lengths",
    "planar_arm.jacobian": "theta, lengths",
    "planar_arm.velocity": "theta, rates, lengths",
    "planar_arm.joint_rates": "theta, twist, lengths, damping=0.0, singular='raise'",
    "planar_arm.inverse": "pose, lengths, unreachable='raise'",
    "planar_arm.manipulability": "theta, lengths",
    "planar_arm.ellipse": "theta, lengths",
}

MODULES = robokin.__all__
FUNCTIONS = [label for label, arguments in SIGNATURES.items() if arguments is not None]
# they take single numbers and wheels, and return wheels or whole numbers
WITHOUT_ARRAYS = ("fixed", "steered", "castor", "swedish", "spherical", "omni_robot", "mobility")


def load(module):
    return importlib.import_module(f"robokin.{module}")


def find(label):
    module, name = label.split(".")
    return getattr(load(module), name)


def test_the_package_has_all_its_modules():
    assert sorted(MODULES) == sorted({label.split(".")[0] for label in SIGNATURES})


@pytest.mark.parametrize("module", MODULES)
def test_the_public_names_of_a_module(module):
    namespace = load(module)
    public = sorted(label.split(".")[1] for label in SIGNATURES if label.split(".")[0] == module)
    assert sorted(namespace.__all__) == public
    for name in namespace.__all__:  # defined here, not passed on from elsewhere
        assert getattr(namespace, name).__module__ == f"robokin.{module}"
        assert inspect.isclass(getattr(namespace, name)) == (SIGNATURES[f"{module}.{name}"] is None)


@pytest.mark.parametrize("label", FUNCTIONS)
def test_the_arguments_of_a_function(label):
    pattern = re.escape(SIGNATURES[label]).replace("…", "[^,]+")
    parameters = inspect.signature(find(label)).parameters.values()
    plain = [str(p.replace(annotation=inspect.Parameter.empty)) for p in parameters]
    assert re.fullmatch(pattern, ", ".join(plain))


@pytest.mark.parametrize("label", FUNCTIONS)
def test_a_docstring_says_what_goes_in_and_comes_out(label):
    text = inspect.getdoc(find(label))
    assert text.split("\n\n")[0].endswith(".")  # begins with a sentence
    if label.removeprefix("wheels.") not in WITHOUT_ARRAYS:
        assert re.search(r"\(…|\(k, k\)", text), "no shapes"
        assert label == "frames.check_rotation" or "→" in text, "no result"


@pytest.mark.parametrize("module", MODULES)
def test_the_examples_in_the_docstrings(module):
    outcome = doctest.testmod(load(module))
    assert outcome.failed == 0
    assert outcome.attempted > 0 or module == "errors"


def test_every_error_is_one_family():
    errors = load("errors")
    for name in errors.__all__:
        assert issubclass(getattr(errors, name), errors.RobokinError)
    assert issubclass(errors.RobokinError, ValueError)


def test_importing_the_package_loads_numpy_alone():
    heavy = [
        "sympy",
        "mpmath",
        "matplotlib",
        "scipy",
        "anywidget",
        "ipywidgets",
        "IPython",
        "traitlets",
    ]
    code = f"import sys, robokin; print([name for name in {heavy} if name in sys.modules])"
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "[]"


def test_importing_the_package_imports_its_modules():
    code = "import robokin; print([hasattr(robokin, name) for name in robokin.__all__])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == str([True] * len(robokin.__all__))
