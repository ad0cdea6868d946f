"""A new chapter is one folder and one line of `_toc.yml`; nothing else is touched.

`python -m courseware.new_chapter` writes one in a copy of the tree, which gets a public address,
too. In the long run the site is built there, and the tests of all chapters are run.
"""

import os
import re
import shutil
import subprocess
import sys
from html import unescape
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import quote

import pytest
import yaml
from browser import make_book, once, shared_folder
from launch_buttons import list_places
from support import ROOT

import book  # noqa: F401  (opens the course)

NOT_SOURCE = (".*", "_build", "__pycache__")
ADDRESS = "https://example.org/course/"
REPOSITORY = "https://github.com/someone/course"
ADDRESSES = {" url": REPOSITORY, " baseurl": ADDRESS, " site_hub": "https://hub.example.org"}
NEW = "gear_train"
LINE = "      - file: planar_arm/planar_arm\n"


def run(tree, *command):
    """A command in the copy, with the copy's packages."""
    env = {**os.environ, "PYTHONPATH": f"{tree}{os.pathsep}{tree / 'tests'}"}
    env.pop("ROBOKIN_UNDER_TEST", None)
    return subprocess.run(command, cwd=tree, env=env, capture_output=True, text=True)


def python(tree, *arguments):
    """The copy's Python."""
    return run(tree, sys.executable, *arguments)


def failure(tree, commands):
    """What the first command that fails says, or ""."""
    for command in commands:
        done = run(tree, *command)
        if done.returncode:
            return done.stdout[-3000:] + done.stderr[-3000:]
    return ""


def copied(place):
    """Copy the tree and add a chapter; what failed."""
    shutil.copytree(ROOT, place, ignore=shutil.ignore_patterns(*NOT_SOURCE))
    toc = place / "_toc.yml"
    text = toc.read_text("utf-8")
    assert LINE in text
    toc.write_text(text.replace(LINE, f"{LINE}      - file: {NEW}/{NEW}\n"), "utf-8")
    config = place / "_config.yml"
    settings = config.read_text("utf-8")
    for name, address in ADDRESSES.items():
        assert f'{name}: ""' in settings
        settings = settings.replace(f'{name}: ""', f'{name}: "{address}"')
    config.write_text(settings, "utf-8")
    return failure(place, [(sys.executable, "-m", "courseware.new_chapter", NEW)])


def built(tree):
    """Store the outputs of the notebook and build the site; what failed."""
    return failure(tree, [(sys.executable, "tools/notebooks.py", NEW), make_book()])


@pytest.fixture(scope="module")
def tree(tmp_path_factory):
    """The copy, made by the first worker that comes."""
    shared = shared_folder(tmp_path_factory)
    place = shared / "new" / "course"
    complaint = once(shared, "new", lambda: copied(place))
    assert not complaint, complaint
    return place


@pytest.fixture(scope="module")
def site(tree):
    """The site of the copy, built by the first worker that comes."""
    complaint = once(tree.parents[1], "new_site", lambda: built(tree))
    assert not complaint, complaint
    return tree / "_build" / "html"


def test_it_is_declared_right(tree):
    done = python(tree, "courseware/tests/declared_right.py", "book", NEW)
    assert done.returncode == 0, done.stderr[-3000:]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("page", "holds"),
    [
        (f"{NEW}/{NEW}", ['class="rk-figure" id="gear-train-image"', 'id="gear-train-1"']),
        ("practice", ["Lenses", 'id="gear-train-1"']),
        ("notation", ["height of the object"]),
        ("checks", ["gear_train.image_distance"]),
        ("api", ["book.gear_train.functions.image_distance"]),
        ("index", ["Where does a lens put the image of a candle?"]),
    ],
)
def test_it_stands_on_every_page(site, page, holds):
    text = (site / f"{page}.html").read_text("utf-8")
    for part in holds:
        assert part in text


@pytest.mark.slow
def test_it_comes_in_the_order_of_the_table_of_contents(site):
    text = (site / "index.html").read_text("utf-8")
    chapters = re.findall(r'href="(\w+)/\1\.html"', text)
    assert chapters.index("planar_arm") < chapters.index(NEW)


@pytest.mark.slow
def test_a_page_that_is_not_there_has_links_from_the_site_s_own_address(site):
    """A server shows it at any address."""
    assert f'<base href="{ADDRESS}" />' in (site / "404.html").read_text("utf-8")


def run_at(chapter):
    """The addresses at which a chapter can be run, but that in the browser."""
    asked = "repo=https%3A%2F%2Fgithub.com%2Fsomeone%2Fcourse&branch=main"
    place = f"lab%2Ftree%2Fbook%2F{chapter}%2F{chapter}.ipynb"
    return [
        "https://hub.example.org/hub/user-redirect/git-pull?"
        f"{asked}&targetPath=course&urlpath={place.replace('book', 'course%2Fbook')}",
        f"https://mybinder.org/v2/gh/someone/course/main?urlpath={place}",
    ]


@pytest.mark.parametrize("end", ["", ".git", "/"])
def test_a_chapter_can_be_run_where_the_addresses_lead(end):
    """On the hub in a folder of the repository's name, however its address ends."""
    theme, hub = {"repository_url": REPOSITORY + end}, ADDRESSES[" site_hub"]
    app = SimpleNamespace(config=SimpleNamespace(html_theme_options=theme, site_hub=hub))
    _, *others, _ = list_places(app, "bicycle/bicycle").values()  # between browser and slides
    ended = quote(end, safe="") + "&"
    assert [url.replace(ended, "&", 1) for url, _ in others] == run_at("bicycle")


@pytest.mark.slow
def test_it_can_be_run_where_the_addresses_lead(site):
    text = unescape((site / NEW / f"{NEW}.html").read_text("utf-8"))
    menu = re.findall(r'href="(https?://[^"]+)" target="_blank"\s+class="[^"]*dropdown-item', text)
    assert menu == run_at(NEW)
    assert "Run this chapter" not in (site / "practice.html").read_text("utf-8")


@pytest.mark.slow
def test_its_text_is_changed_and_its_mistakes_are_told_where_the_address_leads(site):
    text = (site / NEW / f"{NEW}.html").read_text("utf-8")
    assert f'href="{REPOSITORY}/edit/main/book/{NEW}/{NEW}.ipynb"' in text
    told = f"template=mistake.yml&page={NEW}/{NEW}&title=Mistake%20on%20{NEW}/{NEW}"
    assert f'href="{REPOSITORY}/issues/new?{told}"' in unescape(text)
    form = yaml.safe_load((ROOT / ".github/ISSUE_TEMPLATE/mistake.yml").read_text("utf-8"))
    assert "page" in [field.get("id") for field in form["body"]]


@pytest.mark.slow
def test_the_machine_s_tests_hold_it(tree, site):
    """Formulas, figure, exercise, page and notebook: all that is tried of any chapter."""
    options = ("-q", "-p", "no:cacheprovider", "-k", NEW)
    own = f"--ignore={Path(__file__).relative_to(ROOT)}"
    tests = python(tree, "-P", "-m", "pytest", *options, own, "tests", "book")
    assert tests.returncode == 0, tests.stdout[-4000:]
    passed = int(re.search(r"(\d+) passed", tests.stdout)[1])
    # formulas, figures, an exercise with mistakes, a prediction and programs
    assert passed >= 50, f"{passed} tests ran, at least 50 hold it: have ids lost their chapter?"
    notebook = python(tree, "-P", "-m", "pytest", "--nbval", "-q", f"book/{NEW}/{NEW}.ipynb")
    assert notebook.returncode == 0, notebook.stdout[-3000:]


COLLECT = "import book; from courseware import course, equations; "


def replace(tree, part, old, new):
    """Change a module of the chapter."""
    file = tree / "book" / NEW / part
    text = file.read_text("utf-8")
    assert old in text
    file.write_text(text.replace(old, new), "utf-8")


FORGOTTEN = {
    "the line of the table of contents": (
        lambda tree: (tree / "_toc.yml").write_text((ROOT / "_toc.yml").read_text("utf-8")),
        COLLECT + "course.course().chapters",
        rf"{NEW}.ipynb is not in _toc.yml: add the line `- file: {NEW}/{NEW}`",
    ),
    "a formula's check": (
        lambda tree: (tree / f"book/{NEW}/checks.py").unlink(),
        COLLECT + "equations.declared_checks.declared_checks()",
        rf"{NEW}.image_distance has no check: add one of it to CHECKS in .*{NEW}.checks.py",
    ),
    "an SI unit": (
        lambda tree: replace(tree, "formulas.py", '"d_o", "m"', '"d_o", "cm"'),
        COLLECT + "course.course().modules('formulas')",
        rf"{NEW}.formulas.py, line 7: the symbol d_o has the unit 'cm'",
    ),
    "the name of a look": (
        lambda tree: replace(tree, "figures.py", 'Line("path"', 'Line("way"'),
        "import pytest, sys; sys.exit(pytest.main())",
        rf"^ERROR: .*{NEW}.figures.py, line \d+: in the figure gear-train-screen, .*way",
    ),
}

# the quickest; the others in the long run
FORGOTTEN_FIRST = ("the line of the table of contents", "a formula's check", "an SI unit")


@pytest.mark.parametrize(
    ("forget", "code", "message"),
    [
        pytest.param(*row, marks=[pytest.mark.slow] * (name not in FORGOTTEN_FIRST), id=name)
        for name, row in FORGOTTEN.items()
    ],
)
def test_what_is_forgotten_is_told(tree, tmp_path, forget, code, message):
    """What to do is said where the course is read."""
    copy = tmp_path / "course"
    shutil.copytree(tree, copy, ignore=shutil.ignore_patterns(*NOT_SOURCE))
    forget(copy)
    found = python(copy, "-c", code)
    assert found.returncode != 0
    assert re.search(message, found.stderr), found.stderr[-1000:]
