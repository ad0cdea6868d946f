"""The wheels: what each holds, and that the library needs NumPy alone."""

import os
import re
import subprocess
import sys
import venv
from email import message_from_string
from pathlib import Path
from zipfile import ZipFile

import numpy
import pytest
from hatchling.builders.wheel import WheelBuilder
from support import ROOT, python_of

PROGRAM = """
import sys, robokin
from robokin import differential_drive, motion
print(*(differential_drive.body_twist(5 / 3, 10 / 3, 0.03, 0.1) + 0.0).round(6))
print(*motion.arc_step([0, 0, 0], 1.0, 0.0, 2.0))
print(robokin.__file__)
"""
PROJECTS = {"robokin": ROOT} | {name: ROOT / name for name in ("courseware", "book")}


@pytest.fixture(scope="module")
def wheels(tmp_path_factory):
    """The wheels by package, built offline with the locked backend."""
    folder = str(tmp_path_factory.mktemp("wheels"))
    builders = {name: WheelBuilder(str(project)) for name, project in PROJECTS.items()}
    return {name: Path(next(b.build(directory=folder))) for name, b in builders.items()}


def test_a_release_has_one_version():
    """CHANGELOG.md says where it is written, and has it in its first heading."""
    texts = [ROOT / name / "__init__.py" for name in PROJECTS]
    texts += [ROOT / name for name in ("_config.yml", "CITATION.cff", "README.md", "CHANGELOG.md")]
    number = re.compile(
        r"(?<!cff-)(?:version|__version__ =|^##)[: ]+\"?(\d+\.\d+\.\d+)", re.MULTILINE
    )
    assert len({number.search(path.read_text("utf-8"))[1] for path in texts}) == 1


def sources(package, suffixes, left_out=()):
    """The files of a package that its wheel must hold, by their names in the wheel."""
    return {
        path.relative_to(ROOT).as_posix()
        for suffix in suffixes
        for path in (ROOT / package).rglob(f"*{suffix}")
        if not any(path.match(pattern) for pattern in left_out)
    }


@pytest.mark.parametrize(
    ("package", "suffixes", "left_out"),
    [
        ("robokin", [".py"], []),
        ("courseware", [".py", ".js", ".css"], ["tests/*", "tests/*/*", "tests/*/*/*"]),
        ("book", [".py", ".ipynb"], ["book/_*/*"]),
    ],
)
def test_a_wheel_holds_its_package_and_nothing_else(wheels, package, suffixes, left_out):
    names = set(ZipFile(wheels[package]).namelist())
    held = {name for name in names if ".dist-info/" not in name}
    settings = {"book/_toc.yml", "book/_config.yml"} if package == "book" else set()
    assert held == sources(package, suffixes, left_out) | settings
    if package == "robokin":
        assert any(name.endswith("LICENSE") for name in names)


def test_the_library_asks_for_numpy_alone(wheels):
    archive = ZipFile(wheels["robokin"])
    (name,) = [name for name in archive.namelist() if name.endswith("METADATA")]
    needed = message_from_string(archive.read(name).decode()).get_all("Requires-Dist")
    assert [line.split(">=")[0] for line in needed if "extra ==" not in line] == ["numpy"]


def test_no_wheel_registers_in_other_people_s_tools(wheels):
    groups = set()
    for archive in map(ZipFile, wheels.values()):
        for name in archive.namelist():
            if name.endswith("entry_points.txt"):
                groups |= set(re.findall(r"^\[(.+)\]$", archive.read(name).decode(), re.MULTILINE))
    assert groups == {"courseware.course"}


def test_the_library_computes_with_numpy_only(wheels, tmp_path):
    """A fresh environment that sees this one's NumPy and nothing else."""
    venv.create(tmp_path / "fresh", with_pip=False)
    packages = tmp_path / "packages"
    ZipFile(wheels["robokin"]).extractall(packages)
    site = os.path.dirname(os.path.dirname(numpy.__file__))
    for name in os.listdir(site):
        if name.split("-")[0].split(".")[0] in ("numpy", "numpy_libs"):
            os.symlink(os.path.join(site, name), packages / name)
    run = subprocess.run(
        [python_of(tmp_path / "fresh"), "-W", "error", "-c", PROGRAM],
        env={**os.environ, "PYTHONPATH": str(packages)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    twist, pose, file = run.stdout.splitlines()
    assert twist == "0.075 0.0 0.5"
    assert pose == "2.0 0.0 0.0"
    assert file == str(packages / "robokin" / "__init__.py")


def test_a_notebook_needs_nothing_of_what_builds_the_site():
    """Where a notebook runs elsewhere there is no Sphinx; nor does it wait for other chapters."""
    code = """import sys
sys.modules.update(docutils=None, sphinx=None, myst_nb=None)
from book.odometry import figures
from book import prose
from courseware import equations, practice, predictions
figures.dark_figure()._repr_mimebundle_()
predictions.ask("held-wheel")
practice.exercise("odometry-1").check("1")
assert "book.euler.figures" not in sys.modules
"""
    run = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_these_tests_ran_against_what_was_installed():
    """`make test` installs the library's wheel first; its tests then run once, against that."""
    import robokin

    wanted = os.environ.get("ROBOKIN_UNDER_TEST")
    if wanted is None:
        pytest.skip("not run by make test: the checkout itself is tested")
    assert Path(robokin.__file__).is_relative_to(wanted)
