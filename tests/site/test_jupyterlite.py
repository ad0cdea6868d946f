"""JupyterLite beside the book: what it is given. That it runs: `test_in_browser.py`."""

import hashlib
import json
import re
from zipfile import ZipFile

import pytest
from test_run import CHAPTERS, PLACE

import book
from courseware.course import course

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def lite(site):
    return site / "lite"


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_the_button_of_a_chapter_leads_to_its_notebook(chapter, site, lite):
    """With the kernel that is there, so that no dialog asks for another."""
    text = (site / chapter / f"{chapter}.html").read_text("utf-8")
    (name,) = re.findall(r'"\.\./lite/notebooks/index\.html\?path=([^"]+)"', text)
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
    settings = read_settings(lite)
    (kernel,) = (k for n, k in settings["litePluginSettings"].items() if n.endswith(":kernel"))
    assert kernel["disablePyPIFallback"] is True
    assert kernel["pyodideUrl"] == f"{PLACE}pyodide.mjs"


def read_settings(lite):
    """The settings that JupyterLite reads when it starts."""
    return json.loads((lite / "jupyter-lite.json").read_text("utf-8"))["jupyter-config-data"]


def test_an_edited_copy_of_one_version_does_not_hide_the_notebooks_of_the_next(lite):
    """A browser keeps copies of each course and version in a place of its own."""
    place = read_settings(lite)["contentsStorageName"]
    assert book.__version__ in place
    assert course().salt in place
