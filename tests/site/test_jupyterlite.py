"""JupyterLite beside the book: what it is given. That it runs: `test_in_browser.py`."""

import hashlib
import json
import re
from zipfile import ZipFile

import pytest
from browser import watched_page
from test_run import CHAPTERS, PLACE

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def lite(site):
    return site / "lite"


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_the_button_of_a_chapter_leads_to_its_notebook(chapter, site, lite):
    """With the kernel that is there, so that no dialog asks for another."""
    text = (site / chapter / f"{chapter}.html").read_text("utf-8")
    names = re.findall(r'"\.\./lite/notebooks/index\.html\?path=([^"]+)"', text)
    (address,) = set(names)  # in the menu, and below the cell with sliders
    assert address == f"{chapter}.ipynb"  # that lasts
    (name,) = (file.name for file in (lite / "files").glob(f"{chapter}-*.ipynb"))
    notebook = json.loads((lite / "files" / name).read_text("utf-8"))
    assert notebook["metadata"]["kernelspec"]["name"] == "python"
    listed = json.loads((lite / "api" / "contents" / "all.json").read_text("utf-8"))
    assert name in {entry["name"] for entry in listed["content"]}


def test_packages_come_from_the_site_or_from_the_address_of_python(lite):
    """The course's with their hashes; and nothing that is missing is looked for elsewhere."""
    lock = json.loads((lite / "packages" / "pyodide-lock.json").read_text("utf-8"))["packages"]
    own = {name: entry for name, entry in lock.items() if "/" not in entry["file_name"]}
    assert {"robokin", "robokin-courseware", "robokin-book", "anywidget", "ipywidgets"} <= set(own)
    for entry in own.values():
        wheel = lite / "packages" / entry["file_name"]
        assert hashlib.sha256(wheel.read_bytes()).hexdigest() == entry["sha256"]
        dates = {file.date_time[:3] for file in ZipFile(wheel).infolist()}
        assert dates <= {(1980, 1, 1), (2020, 2, 2)}  # of every build: else each gives other hashes
        assert set(entry["depends"]) <= set(lock)
    others = [entry["file_name"] for name, entry in lock.items() if name not in own]
    assert all(name.startswith(PLACE) for name in others)
    settings = json.loads((lite / "jupyter-lite.json").read_text("utf-8"))["jupyter-config-data"]
    (kernel,) = (k for n, k in settings["litePluginSettings"].items() if n.endswith(":kernel"))
    assert kernel["disablePyPIFallback"] is True
    assert kernel["pyodideUrl"] == f"{PLACE}pyodide.mjs"


@pytest.mark.parametrize("letters", ["", "-000000"])
def test_an_address_of_a_notebook_lasts(letters, lite, server, chromium):
    """Without the letters of a digest, or with those of an earlier release."""
    (now,) = (file.name for file in (lite / "files").glob("bicycle-*.ipynb"))
    with watched_page(chromium, server) as (page, _):
        page.context.route(f"{PLACE}**", lambda route: route.abort())
        page.goto(f"{server}lite/notebooks/index.html?path=bicycle{letters}.ipynb")
        page.wait_for_url(f"**/index.html?path={now}")
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for()


def test_it_says_what_it_waits_for_and_that_nothing_comes(server, chromium):
    with watched_page(chromium, server) as (page, _):
        held, blocked = [], []
        page.context.route(
            f"{PLACE}**", lambda route: route.abort() if blocked else held.append(route)
        )
        page.goto(f"{server}lite/notebooks/index.html?path=bicycle.ipynb")
        words = "Loading Python from cdn.jsdelivr.net, a large download the first time …"
        page.get_by_text(words).wait_for()
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for()
        blocked.append(True)
        for route in held:
            route.abort()
        page.get_by_text("Python cannot be loaded from cdn.jsdelivr.net").wait_for()
        assert page.get_by_text("Loading Python").count() == 0
