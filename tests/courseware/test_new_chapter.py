"""A ninth chapter is one folder and one line of `_toc.yml`; nothing else is touched.

The folder `ninth_chapter/beacon` is put into a copy of the tree, which gets a public address, too;
so is a tenth chapter, as `python -m courseware.new_chapter` writes it. In the long run the site is
built there, and the tests of all chapters are run.
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
from browser import make_book, once
from launch_buttons import list_places
from support import ROOT

import book  # noqa: F401  (opens the course)

BEACON = Path(__file__).parent / "ninth_chapter" / "beacon"
NOT_SOURCE = (".*", "_build", "__pycache__")
ADDRESS = "https://example.org/course/"
REPOSITORY = "https://github.com/someone/course"
ADDRESSES = {" url": REPOSITORY, " baseurl": ADDRESS, " site_hub": "https://hub.example.org"}
NEW = ("beacon", "gear_train")
LINE = "      - file: planar_arm/planar_arm\n"


def run(tree, *command):
    """A command in the copy, with the copy's packages."""
    env = {**os.environ, "PYTHONPATH": str(tree)}
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
    """Copy the tree and add two chapters; what failed."""
    shutil.copytree(ROOT, place, ignore=shutil.ignore_patterns(*NOT_SOURCE))
    shutil.copytree(BEACON, place / "book" / "beacon")
    toc = place / "_toc.yml"
    text = toc.read_text("utf-8")
    assert LINE in text
    lines = "".join(f"      - file: {name}/{name}\n" for name in NEW)
    toc.write_text(text.replace(LINE, LINE + lines), "utf-8")
    config = place / "_config.yml"
    settings = config.read_text("utf-8")
    for name, address in ADDRESSES.items():
        assert f'{name}: ""' in settings
        settings = settings.replace(f'{name}: ""', f'{name}: "{address}"')
    config.write_text(settings, "utf-8")
    return failure(place, [(sys.executable, "-m", "courseware.new_chapter", "gear_train")])


def built(tree):
    """Store the outputs of both notebooks and build the site; what failed."""
    notebooks = [(sys.executable, "tools/notebooks.py", name) for name in NEW]
    return failure(tree, [*notebooks, make_book()])


@pytest.fixture(scope="module")
def shared(tmp_path_factory):
    """A folder that all workers share."""
    base = tmp_path_factory.getbasetemp()
    return base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base


@pytest.fixture(scope="module")
def tree(shared):
    """The copy, made by the first worker that comes."""
    place = shared / "ninth" / "course"
    complaint = once(shared, "ninth", lambda: copied(place))
    assert not complaint, complaint
    return place


@pytest.fixture(scope="module")
def site(tree, shared):
    """The site of the copy, built by the first worker that comes."""
    complaint = once(shared, "ninth_site", lambda: built(tree))
    assert not complaint, complaint
    return tree / "_build" / "html"


DECLARED_RIGHT = f"""
import book
from courseware.course import course
from courseware.equations import Check, verify
from courseware.figures import Figure
from courseware.practice import Exercise, dealing
for new in {NEW}:
    def own(part, kind):
        return [each for name, each in course().find_all(part, kind).items()
                if course().chapters_of(part, kind)[name] == new]
    assert all(verify(check, samples=20).agrees for check in own("checks", Check))
    assert [figure.code for figure in own("figures", Figure)]
    assert all(dealing.variants(exercise.name) for exercise in own("exercises", Exercise))
"""


def test_both_are_declared_right(tree):
    done = python(tree, "-c", DECLARED_RIGHT)
    assert done.returncode == 0, done.stderr[-3000:]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("page", "holds"),
    [
        ("beacon/beacon", ['class="rk-figure" id="beacon"', 'id="M99"', 'id="beacon-1"']),
        ("practice", ["A beacon", 'id="beacon-1"']),
        ("notation", ["distance of the beacon", "direction in which the robot sees it"]),
        ("checks", ["beacon.distance", "beacon.direction"]),
        ("api", ["book.beacon.functions.range_and_bearing"]),
        ("intro", ["How far is a beacon, and in which direction does the robot see it?"]),
    ],
)
def test_it_stands_on_every_page(site, page, holds):
    text = (site / f"{page}.html").read_text("utf-8")
    for part in holds:
        assert part in text


@pytest.mark.slow
def test_it_comes_in_the_order_of_the_table_of_contents(site):
    text = (site / "intro.html").read_text("utf-8")
    chapters = re.findall(r'href="(\w+)/\1\.html"', text)
    assert chapters.index("planar_arm") < chapters.index("beacon")


@pytest.mark.slow
def test_it_stands_in_the_list_for_search_engines(site):
    page = f"{ADDRESS}beacon/beacon.html"
    assert f"<loc>{page}</loc>" in (site / "sitemap.xml").read_text("utf-8")
    text = (site / "beacon" / "beacon.html").read_text("utf-8")
    assert f'<link rel="canonical" href="{page}" />' in text
    assert f'<meta property="og:url" content="{page}" />' in text
    same = f'<link rel="canonical" href="{ADDRESS}" />'
    assert all(same in (site / name).read_text("utf-8") for name in ("index.html", "intro.html"))


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
    _, *others = list_places(app, "bicycle/bicycle").values()
    ended = quote(end, safe="") + "&"
    assert [url.replace(ended, "&", 1) for url, _ in others] == run_at("bicycle")


@pytest.mark.slow
def test_it_can_be_run_where_the_addresses_lead(site):
    text = unescape((site / "beacon" / "beacon.html").read_text("utf-8"))
    menu = re.findall(r'href="(https?://[^"]+)" target="_blank"\s+class="[^"]*dropdown-item', text)
    assert menu == run_at("beacon")
    assert "Run this chapter" not in (site / "practice.html").read_text("utf-8")


@pytest.mark.slow
def test_its_text_is_changed_and_its_mistakes_are_told_where_the_address_leads(site):
    text = (site / "beacon" / "beacon.html").read_text("utf-8")
    assert f'href="{REPOSITORY}/edit/main/book/beacon/beacon.ipynb"' in text
    told = "template=mistake.yml&page=beacon/beacon&title=Mistake%20on%20beacon/beacon"
    assert f'href="{REPOSITORY}/issues/new?{told}"' in unescape(text)
    form = yaml.safe_load((ROOT / ".github/ISSUE_TEMPLATE/mistake.yml").read_text("utf-8"))
    assert "page" in [field.get("id") for field in form["body"]]


@pytest.mark.slow
def test_the_machine_s_tests_hold_it(tree, site):
    """Formulas, figure, exercise, page and notebook: all that is tried of any chapter."""
    options = (
        "-q",
        "-p",
        "no:cacheprovider",
        "-k",
        "gear_train or (beacon and not test_chapters)",
    )
    own = f"--ignore={Path(__file__).relative_to(ROOT)}"
    tests = python(tree, "-P", "-m", "pytest", *options, own, "tests", "book")
    assert tests.returncode == 0, tests.stdout[-4000:]
    passed = int(re.search(r"(\d+) passed", tests.stdout)[1])
    # two chapters with one or two formulas, a figure and an exercise
    assert passed >= 80, f"{passed} tests ran, at least 80 hold them: have ids lost their chapter?"
    paths = [f"book/{name}/{name}.ipynb" for name in NEW]
    notebook = python(tree, "-P", "-m", "pytest", "--nbval", "-q", *paths)
    assert notebook.returncode == 0, notebook.stdout[-3000:]


COLLECT = "import book; from courseware import course, equations; "
IN_TESTS = "import sys; sys.path += ['tests', 'tests/book', 'tests/courseware', 'tools']; "
FORGOTTEN = {
    "the line of the table of contents": (
        lambda tree: (tree / "_toc.yml").write_text((ROOT / "_toc.yml").read_text("utf-8")),
        COLLECT + "course.course().chapters",
        r"beacon.ipynb is not in _toc.yml: add the line `- file: beacon/beacon`",
    ),
    "a formula's check": (
        lambda tree: (tree / "book/beacon/checks.py").unlink(),
        COLLECT + "equations.declared_checks.declared_checks()",
        r"beacon.distance has no check: add `Check\(formulas.distance, .*checks.py",
    ),
    "the folder's package": (
        lambda tree: (tree / "book/beacon/__init__.py").unlink(),
        COLLECT + "course.course().chapters",
        r"beacon.* has no __init__.py: .* the question that the chapter answers",
    ),
    "what a figure must tell": (
        lambda tree: (tree / "book/beacon/expected.py").unlink(),
        IN_TESTS + "import test_expected as t; "
        "t.test_readouts_that_are_no_formula_against_robokin(t.FIGURES['beacon'])",
        r"in READOUTS of book/beacon/expected.py the function of 'beacon' must return ",
    ),
    "what a mistake gives": (
        lambda tree: (tree / "book/beacon/expected.py").unlink(),
        IN_TESTS + "import test_feedback as t; "
        "t.test_each_mistake_in_an_exercise_is_told(t.EXERCISES['beacon-1'])",
        r'add to FEEDBACK\["beacon-1"\] in book/beacon/expected.py .*M99',
    ),
}

# the quickest; the others in the long run
FORGOTTEN_FIRST = ("the line of the table of contents", "a formula's check")


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
