"""The kit, the site as a zip, and the list of packages that students install.

In a fresh environment every notebook of the kit runs: `make test-install`.
"""

import json
import re
import subprocess
import sys
from importlib.metadata import distributions, requires
from zipfile import ZipFile

import pytest
from browser import listed, watched_page
from declared import EXERCISES, judge_all
from offline_bundle import list_site
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from support import ROOT, python_of
from test_practice_page import FIRST, RIGHT, answer, sign_in

from courseware.practice import candidates

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

WHEELS = ("robokin", "robokin-courseware", "robokin-book")
DEVELOPERS = {"jupyter-book", "sphinx", "playwright", "pytest", "ruff", "mypy", "uv"}
LOCKS = ("requirements.txt", "requirements-light.txt")
INSTALLS = 900  # seconds at most for pip, on a slow line
RUNS = 300  # seconds at most for a notebook


def chapters():
    """Number and notebook of each chapter, as the table of contents orders them."""
    names = [ROOT / "book" / f"{name}.ipynb" for name in listed()]
    return dict(enumerate(file for file in names if file.exists()))


@pytest.fixture
def kit(site, tmp_path):
    """The kit, unzipped into an empty folder."""
    ZipFile(site / "robokin-kit.zip").extractall(tmp_path)
    return tmp_path / "robokin-kit"


def test_the_kit_holds_what_a_student_needs(kit, site):
    files = {file.relative_to(kit).as_posix(): file for file in kit.rglob("*") if file.is_file()}
    told = {"README.txt", "start.py", "requirements-light.txt"}
    wheels = {name for name in files if re.fullmatch(r"wheels/robokin\w*-[\d.]+-py3.*\.whl", name)}
    books = {f"notebooks/{n:02}-{file.name}" for n, file in chapters().items()}
    assert set(files) == told | wheels | books
    names = {name[len("wheels/") :].partition("-")[0].replace("_", "-") for name in wheels}
    assert names == set(WHEELS), "`classroom` is for teachers"
    lines = (kit / "README.txt").read_text("utf-8").splitlines()
    assert all(word in "\n".join(lines) for word in ("Windows", "macOS", "Linux", "start.py"))
    assert max(map(len, lines)) <= 100
    first = (site / "index.html").read_text("utf-8")
    linked = set(re.findall(r'href="([\w-]+\.zip)" download', first))
    assert linked == {"robokin-kit.zip", "robokin-site.zip"}


@pytest.mark.parametrize(
    ("number", "file"), chapters().items(), ids=[file.stem for file in chapters().values()]
)
def test_a_notebook_of_the_kit_is_the_chapter_s(number, file, site):
    kit = ZipFile(site / "robokin-kit.zip")
    held = kit.read(f"robokin-kit/notebooks/{number:02}-{file.name}")
    assert held == file.read_bytes()


def test_the_site_for_a_stick_holds_all_that_its_pages_link_and_no_server_needs(site, tmp_path):
    held = {name.partition("/")[2] for name in ZipFile(site / "robokin-site.zip").namelist()}
    linked = re.findall(r'href="([^":#?]+)" download', (site / "index.html").read_text("utf-8"))
    assert set(linked) - held == {"robokin-site.zip"}  # it cannot hold itself
    kept = {"robokin.pdf", "a/a.html", ".nojekyll"}
    for name in (*kept, "lite/a.html", ".built"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    assert set(list_site(tmp_path)) == kept


def test_github_pages_is_told_to_serve_folders_that_begin_with_an_underscore(site):
    """From a branch, too, where the site or what its zip holds was copied to."""
    assert (site / ".nojekyll").is_file()
    assert "robokin-site/.nojekyll" in ZipFile(site / "robokin-site.zip").namelist()


def versions(lock):
    """Name → versions in a lock; some systems have others."""
    found = {}
    for pin in pins(lock):
        found.setdefault(canonicalize_name(pin.name), set()).add(str(pin.specifier).strip("="))
    return found


def pins(lock):
    """The entries of a lock, a line each."""
    text = lock.read_text("utf-8")
    return [Requirement(line) for line in re.findall(r"^[\w.-].*?==[^ \\]+", text, re.M)]


def is_asked(requirement, extra=""):
    """Whether a package needs it on this machine, installed with an extra."""
    return not requirement.marker or requirement.marker.evaluate({"extra": extra})


@pytest.mark.parametrize("lock", LOCKS[1:])
def test_students_install_what_the_wheels_ask_for_as_it_was_tested(lock):
    light, full = versions(ROOT / lock), versions(ROOT / "requirements.txt")
    assert not [name for name in light.keys() & full if light[name] != full[name]]
    assert not DEVELOPERS & set(light)
    for wheel in WHEELS:
        for asked in map(Requirement, requires(wheel)):
            if asked.name not in WHEELS and is_asked(asked, "draw"):
                assert all(
                    asked.specifier.contains(v) for v in light[canonicalize_name(asked.name)]
                )


@pytest.mark.parametrize("lock", LOCKS)
def test_a_lock_has_what_its_packages_ask_for_with_the_extras(lock):
    """Else pip refuses a lock with hashes: for the extras, once there is a newer version."""
    extras = {canonicalize_name(pin.name): pin.extras for pin in pins(ROOT / lock)}
    asked = [
        (canonicalize_name(each.name), each.extras)
        for package in distributions()
        if canonicalize_name(package.name) in extras
        for each in map(Requirement, package.requires or ())
        if is_asked(each)
    ]
    assert any(own for _, own in asked)
    assert not [each for each in asked if each[0] not in extras or each[1] - extras[each[0]]]


def test_an_old_python_is_told(kit):
    """The first lines of `start.py` are read by any Python 3."""
    program = (
        "import runpy, sys; sys.version_info = (3, 9); runpy.run_path('start.py', None, '__main__')"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=kit, capture_output=True, text=True)
    assert run.returncode == 1
    assert "Python 3.11 or newer is needed" in run.stderr
    assert not (kit / ".venv").exists()


def test_the_site_works_from_a_stick(site, chromium, tmp_path):
    """Unzipped: a figure is moved, an exercise answered, something looked for."""
    ZipFile(site / "robokin-site.zip").extractall(tmp_path)
    home = (tmp_path / "robokin-site").as_uri() + "/"
    with watched_page(chromium, home) as (page, watch):
        page.goto(home + "basics/basics.html")
        assert not page.locator(".dropdown-run-buttons a[href^='../lite/']").count()
        figure = page.locator("figure.rk-figure").first
        figure.scroll_into_view_if_needed()
        page.locator("figure.rk-live").first.wait_for()
        before = figure.locator(".rk-value").all_inner_texts()
        figure.locator("input[type=range]").first.press("ArrowRight")
        page.wait_for_function(
            "([figure, before]) => [...figure.querySelectorAll('.rk-value')]"
            ".some((shown, k) => shown.innerText !== before[k])",
            arg=[figure.element_handle(), before],
        )
        page.goto(home + "practice.html")
        sign_in(page, "Ada")
        assert answer(page, FIRST, RIGHT) == candidates.RIGHT
        page.goto(home + "index.html")
        page.locator(".search-button__button:visible").first.click()
        page.keyboard.type("rolling constr")
        page.locator("dialog .site-results li", has_text="The rolling row").first.wait_for()
        assert not watch.errors + watch.strangers


# --- in fresh environments ------------------------------------------------------------------


def run(*command, cwd, **options):
    """The output of a command, which must succeed."""
    done = subprocess.run(
        list(map(str, command)), cwd=cwd, capture_output=True, text=True, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.install
def test_every_notebook_of_the_kit_runs_and_every_exercise_judges(kit):
    """Started as the README says; what JupyterLab is asked here is its version."""
    assert re.search(
        r"^4\.", run(sys.executable, "start.py", "--version", cwd=kit, timeout=INSTALLS), re.M
    )
    python = python_of(kit / ".venv")
    books = sorted((kit / "notebooks").glob("*.ipynb"))
    assert len(books) == len(chapters())
    for book in books:
        command = ("-m", "nbconvert", "--to", "notebook", "--execute", "--inplace", book.name)
        run(python, *command, cwd=book.parent, timeout=RUNS)
        cells = json.loads(book.read_text("utf-8"))["cells"]
        code = [cell for cell in cells if cell["cell_type"] == "code"]
        skipped = [cell for cell in code if "skip-execution" in cell["metadata"].get("tags", ())]
        assert [cell for cell in code if not cell["execution_count"]] == skipped
    verdicts = json.loads(run(python, "-c", judge_all(), cwd=kit))
    assert verdicts == dict.fromkeys(EXERCISES, "right")
