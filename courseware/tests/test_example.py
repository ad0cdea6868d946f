"""The example course (`booklet`) is built and works: the framework knows no subject.

It runs in processes of its own, because a process has one course open.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from browser import serving, watched_page
from playwright.sync_api import expect
from support import ROOT

pytest_plugins = ["browser"]

BOOKLET = Path(__file__).parent / "booklet"
SHARED = [ROOT, ROOT / "tests", ROOT / "tools", BOOKLET.parent]
RUN = "import notebooks; from pathlib import Path; p = Path('optics/optics.ipynb'); "
RUN += "p.write_text(notebooks.run_notebook(p), 'utf-8')"


def run(*command, **options):
    """Run Python beside the example; a failure shows what it says."""
    places = os.pathsep.join(map(str, [*options.pop("first", ()), *SHARED]))
    env = {**os.environ, "PYTHONPATH": places}
    done = subprocess.run(
        [sys.executable, *map(str, command)], env=env, capture_output=True, text=True, **options
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """The pages, built without a warning from a copy whose notebook has been run."""
    folder = tmp_path_factory.mktemp("example")
    copy = shutil.copytree(BOOKLET, folder / "booklet")
    run("-c", RUN, cwd=copy, first=[folder])
    run("-m", "sphinx", "-W", "-q", "--keep-going", copy, folder / "site", cwd=copy, first=[folder])
    return folder / "site"


@pytest.fixture
def chapter(pages, chromium):
    """The chapter's page; the script for its formulas, which is elsewhere, does not come."""
    with serving(pages) as address, watched_page(chromium, address) as (page, watch):
        page.route(lambda url: not url.startswith(address), lambda route: route.abort())
        page.goto(f"{address}optics/optics.html")
        yield page
        assert not [e for e in watch.errors if "mathjax" not in e and "ERR_FAILED" not in e]


@pytest.mark.browser
def test_its_figure_moves_and_knows_its_goal(chapter):
    figure = chapter.locator("#optics-screen")
    figure.scroll_into_view_if_needed()
    distance = chapter.locator("#optics-screen.rk-live input").first
    for _ in range(10):
        distance.press("ArrowLeft")  # from 30 cm to twice the focal length
    expect(figure.locator(".rk-goal output")).to_have_text("reached")
    expect(figure).to_contain_text("0.200 m")


@pytest.mark.browser
def test_its_exercise_judges(chapter):
    box = chapter.locator("[data-exercise='optics-1']")
    chapter.fill("#rk-student", "Ada")
    chapter.keyboard.press("Tab")
    box.scroll_into_view_if_needed()
    chapter.locator("#optics-1[data-variant]").wait_for()
    h_o, d_o, f = map(float, re.findall(r"\d+", box.locator(".rk-text").inner_text())[:3])
    for divisor, words in ((d_o + f, "added, not subtracted"), (d_o - f, "This check passed")):
        box.locator("input").first.fill(f"{-h_o * f / divisor:.4f} cm")
        box.locator("input").first.press("Enter")
        expect(box).to_contain_text(words)


def test_its_reference_lists_what_it_declares(pages):
    text = (pages / "reference.html").read_text("utf-8")
    for part in ('id="optics-1"', "height of the object", "optics.focal_length"):
        assert part in text
    assert ":::" not in text
