"""The wheel: installed alone, with NumPy only, it computes."""

import os
import shutil
import subprocess
import sys
import venv
from zipfile import ZipFile

import numpy
import pytest
from support import ROOT

PROGRAM = """
import sys, robokin
from robokin import differential_drive, motion
print(*(differential_drive.body_twist(5 / 3, 10 / 3, 0.03, 0.1) + 0.0).round(6))
print(*motion.arc_step([0, 0, 0], 1.0, 0.0, 2.0))
print(robokin.__file__)
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built offline with the locked backend."""
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "pip", "wheel", "--no-deps", "--no-build-isolation"]
    quiet = ["--disable-pip-version-check", "-q", "-w", str(folder), str(ROOT)]
    subprocess.run([*command, *quiet], check=True)
    (path,) = folder.glob("*.whl")
    return path


def test_wheel_holds_the_package_and_nothing_else(wheel):
    names = ZipFile(wheel).namelist()
    assert all(name.startswith(("robokin/", "robokin-")) for name in names)
    for needed in ("robokin/motion.py", "robokin/live/figure.js", "robokin/live/live.css"):
        assert needed in names
    assert any(name.endswith("LICENSE") for name in names)


LIBRARY = ("motion", "frames", "euler", "elbow_arm", "differential_drive", "bicycle", "wheels")
LIBRARY += ("odometry", "planar_arm", "bad_input")
EXTRAS = ("matplotlib", "anywidget", "ipywidgets", "py_mini_racer")  # SymPy is a tests' oracle


def test_wheel_passes_the_tests_of_the_library(wheel, tmp_path):
    """The tests, copied away from the checkout, against the wheel; without the extras."""
    packages, tests = tmp_path / "packages", tmp_path / "tests"
    ZipFile(wheel).extractall(packages)
    tests.mkdir()
    for name in (*(f"test_{topic}.py" for topic in LIBRARY), "support.py"):
        shutil.copy(ROOT / "tests" / name, tests)
    (tests / "conftest.py").write_text(
        (ROOT / "tests" / "conftest.py").read_text(encoding="utf-8")
        + f"\nimport sys\nsys.modules.update(dict.fromkeys({EXTRAS!r}))\n"
        "import robokin\nassert 'packages' in robokin.__file__, robokin.__file__\n",
        encoding="utf-8",
    )
    marks = ["-o", "markers=long: a longer sweep", "-W", "error", "-m", "not long"]
    run = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *marks, str(tests)],
        env={**os.environ, "PYTHONPATH": str(packages)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stdout[-3000:]


def test_wheel_computes_with_numpy_only(wheel, tmp_path):
    """A fresh environment that sees this one's NumPy and nothing else."""
    venv.create(tmp_path / "fresh", with_pip=False)
    place = "Scripts/python.exe" if os.name == "nt" else "bin/python"
    packages = tmp_path / "packages"
    ZipFile(wheel).extractall(packages)
    site = os.path.dirname(os.path.dirname(numpy.__file__))
    for name in os.listdir(site):
        if name.split("-")[0].split(".")[0] in ("numpy", "numpy_libs"):
            os.symlink(os.path.join(site, name), packages / name)
    run = subprocess.run(
        [tmp_path / "fresh" / place, "-W", "error", "-c", PROGRAM],
        env={**os.environ, "PYTHONPATH": str(packages)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    twist, pose, file = run.stdout.splitlines()
    assert twist == "0.075 0.0 0.5"
    assert pose == "2.0 0.0 0.0"
    assert file.startswith(str(packages))
