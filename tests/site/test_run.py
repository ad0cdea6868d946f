"""*Run* under a page's cells: what it needs, what it loads and when, and what runs them there.

With a real Python in a browser: `test_in_browser.py` (`make test-install`).
"""

import ast
import builtins
import hashlib
import itertools
import json
import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest
from browser import settled, watched_page
from jupyterlite_pyodide_kernel.constants import PYODIDE_CDN_URL
from playwright.sync_api import expect
from pyodide import PLACE, VERSION
from support import ROOT

import book  # noqa: F401 (opens the course)
from courseware.course import _open as open_courses
from courseware.course import course
from courseware.run.cells import Cells, start
from courseware.site import SETTINGS

pytest_plugins = ["browser"]

VENDORED = ROOT / "book" / "_vendor" / "pyodide"
PAGE = "basics/basics.html"
CHAPTERS = course().taught


def code_cells(chapter):
    """The code cells of a chapter, with outputs."""
    cells = json.loads(course().notebook(chapter).read_text("utf-8"))["cells"]
    return [cell for cell in cells if cell["cell_type"] == "code"]


def shown_cells(chapter):
    """Those that its page shows: what can be run there."""
    hidden = {"remove-input", "remove-cell"}
    return [c for c in code_cells(chapter) if hidden.isdisjoint(c["metadata"].get("tags", ()))]


def names(tree, kind):
    """The names that code stores or loads."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    found = {node.id for node in nodes if isinstance(node.ctx, kind)}
    if kind is ast.Store:
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                found.add(node.name)
            if isinstance(node, ast.arg):
                found.add(node.arg)
            if isinstance(node, ast.Import | ast.ImportFrom):
                found |= {alias.asname or alias.name.partition(".")[0] for alias in node.names}
            if isinstance(node, ast.ExceptHandler) and node.name:
                found.add(node.name)
    return found


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_the_cells_on_a_page_need_no_cell_that_is_not_there(chapter):
    """A page runs what it shows; a cell that is not shown may not make a name for one that is."""
    known = {*dir(builtins), "display"}
    for cell in shown_cells(chapter):
        source = "".join(cell["source"])
        tree = ast.parse(source)
        known |= names(tree, ast.Store)
        unknown = names(tree, ast.Load) - known
        assert not unknown, f"{source}\nuses {unknown}: import or compute it in a shown cell"


OWN_PROCESS = "import sys, test_run; test_run.assert_as_stored(sys.argv[1])"


@pytest.mark.install
@pytest.mark.parametrize("chapter", CHAPTERS)
def test_the_cells_on_a_page_give_what_is_stored(chapter):
    """All of them, in order, by what runs them in a page, but in this Python."""
    command = [sys.executable, "-W", "error", "-c", OWN_PROCESS, chapter]
    env = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    here = Path(__file__).parent
    run = subprocess.run(command, cwd=here, env=env, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def assert_as_stored(chapter):
    """In a process of its own: what gets a Python ready for a page changes it."""
    shown, said = shown_cells(chapter), []
    for name in [name for name in sys.modules if name.partition(".")[0] == "book"]:
        del sys.modules[name]  # a page opens the course only if one of its cells does
    open_courses.clear()
    cells = start(lambda kind, text: said.append((kind, text)), ["numpy", "sympy", "matplotlib"])
    for number, cell in enumerate(shown, 1):
        if "skip-execution" in cell["metadata"].get("tags", ()):
            continue  # nothing is stored: it is for the reader
        said.clear()
        source = "".join(cell["source"])
        cells.needs(source)
        assert cells.run(source, f"cell {number}"), (source, said)
        assert read_run(said) == stored(cell), source


def read_run(said):
    """What a run has said: its text, its formulas, how many pictures."""
    text = "".join(text for kind, text in said if kind in ("stdout", "stderr", "text/plain"))
    kinds = [kind for kind, _ in said]
    tex = [text for kind, text in said if kind == "text/latex"]
    return text.strip(), tex, kinds.count("image/png")


def stored(cell):
    """The same of the outputs in a notebook."""
    said = []
    for output in cell["outputs"]:
        data = output.get("data", {"stdout": output.get("text")})
        kind = next(k for k in ("image/png", "text/latex", "text/plain", "stdout") if k in data)
        said.append((kind, "".join(data[kind])))
    return read_run(said)


# --- cells ----------------------------------------------------------------------------------


@pytest.fixture
def page():
    """Cells without a page, and what they say: `page(source)` → [(kind, text)]."""
    said, numbers = [], itertools.count(1)
    cells = Cells(lambda kind, text: said.append((kind, text)), frozenset(["numpy", "sympy"]))

    def run(source):
        said.clear()
        cells.run(source, f"cell {next(numbers)}")
        return said

    run.cells = cells
    return run


def test_cells_share_their_names_and_show_their_last_value(page):
    assert page("a = 6\na * 7") == [("text/plain", "42")]
    assert page("a;") == []
    assert page("print(a)\n_") == [("stdout", "6"), ("stdout", "\n"), ("text/plain", "42")]
    assert page("import numpy as np\n(np.eye(2), 1)") == [
        ("text/plain", "(array([[1., 0.],\n        [0., 1.]]),\n 1)")
    ]


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("a = 1\na + b", "Line 2, a + b\nNameError: name 'b' is not defined"),
        ("a = = 1", "Line 1, a = = 1\nSyntaxError: invalid syntax"),
        ("import nunpy", "Line 1, import nunpy\nModuleNotFoundError: No module named 'nunpy'"),
        ("raise SystemExit", "Line 1, raise SystemExit\nSystemExit"),
        (
            "from robokin import differential_drive\ndifferential_drive.body_twist(1, 1, 0.1, 0)",
            "Line 2, differential_drive.body_twist(1, 1, 0.1, 0)\n"
            "RobokinError: wheel_distance must be positive and finite, got 0.0",
        ),
    ],
)
def test_an_error_is_said_in_words_with_its_line(page, source, words):
    assert page(source) == [("error", words)]
    assert page("1 + 1") == [("text/plain", "2")]  # and the page goes on


def test_an_import_waits_until_its_name_is_used(page):
    """So that a first cell that imports all that a chapter needs waits for none of it."""
    page("import sympy as sp\nfrom robokin import draw\nx = 1")
    assert "sp" not in page.cells.names
    page("sp.Integer(4)")
    assert page.cells.names["sp"].Integer(4) == 4
    assert page("from math import *\ny = 2")[:] == []
    assert page("round(pi, 2)") == [("text/plain", "3.14")]


def test_a_function_defined_in_a_cell_can_be_listed(page):
    page("from courseware.source_listing import show_source\ndef double(x):\n    return 2 * x")
    assert page("show_source(double)") == [("text/plain", "def double(x):\n    return 2 * x")]


@pytest.mark.parametrize(
    ("source", "most"),
    [
        ("for k in range(100_000):\n    print(k)", 20_000),
        ("for k in range(100_000):\n    display(k)", 40),
    ],
)
def test_a_flood_is_cut_whatever_it_is_made_of(page, source, most):
    said = page(source)
    shown = len("".join(text for _, text in said))
    assert shown < 21_000, f"{shown} characters are shown, at most 20,000 and a sentence"
    assert 1 < len(said) <= most + 1
    assert said[-1] == ("stdout", "\n… and more, which is not shown\n")
    assert page("1 + 1") == [("text/plain", "2")]  # the next run has room again


# --- the page -------------------------------------------------------------------------------


@pytest.mark.browser
def test_nothing_is_loaded_until_it_is_asked_for(server, chromium):
    with watched_page(chromium, server) as (page, watch):
        settled(page, server + PAGE)
        assert not [url for url in watch.kinds if "/run/" in url]
        assert not watch.errors + watch.strangers


@pytest.fixture(scope="module")
def blocked(server, chromium):
    """A page that asked for its Python, and does not get it."""
    with watched_page(chromium, server) as (page, watch):
        page.context.route(f"{PLACE}**", lambda route: route.abort())
        page.goto(server + PAGE)
        bar = page.locator(".rk-run").first
        bar.get_by_text("Run", exact=True).click()
        yield page, watch


@pytest.mark.browser
def test_where_the_download_is_blocked_the_page_says_so(blocked):
    page, watch = blocked
    bar = page.locator(".rk-run").first
    for again in (False, True):
        if again:
            bar.get_by_text("Run", exact=True).click()
        said = bar.get_by_text("Python cannot be loaded from cdn.jsdelivr.net")
        said.wait_for()
        assert "The stored results stand" in said.inner_text()
    assert {url.startswith(PLACE) for url in watch.strangers} == {True}


@pytest.mark.browser
def test_a_slash_is_typed_into_a_cell_and_ctrl_k_opens_the_search(blocked):
    """Sphinx takes "/" for its search, and spares form fields only."""
    page, _ = blocked
    page.locator(".cell_input pre").first.click()
    code = page.locator(".cell_input .cm-content").first
    expect(code).to_be_focused()
    page.keyboard.press("ControlOrMeta+a")
    page.keyboard.type("print(7/2)  # 7 // 2 is 3")
    assert code.inner_text().strip() == "print(7/2)  # 7 // 2 is 3"
    page.keyboard.press("Control+k")
    page.keyboard.type("m/s")
    assert page.locator("#pst-search-dialog input").input_value() == "m/s"


# a worker that has its Python at once, and what it says of a cell
WORKER = """onmessage = ({ data }) => {
  if (data.settings) return postMessage({ ready: true });
  const say = (kind, text) => postMessage({ cell: data.cell, kind, text });
  SAYS;
  postMessage({ cell: data.cell, ended: true });
};"""


FLOOD = "for (let k = 0; k < 20_000; k += 1) say('stdout', 'x')"


@contextmanager
def with_worker(server, chromium, says):
    """A page whose Python says this of every cell."""
    with watched_page(chromium, server) as (page, watch):
        page.context.route(
            "**/run/worker.js*",
            lambda route: route.fulfill(
                body=WORKER.replace("SAYS", says), content_type="text/javascript"
            ),
        )
        yield page, watch
        assert not watch.errors + watch.strangers


@pytest.fixture
def flooded(server, chromium):
    with with_worker(server, chromium, FLOOD) as (page, _):
        page.goto(server + PAGE)
        yield page


@pytest.mark.browser
def test_a_wrong_answer_is_drawn_below_its_verdict(server, chromium):
    """By the page's own script, in its colours; the picture is no wider than the page."""
    numbers = [2, 1, 0.5, 2, -1, 0.5, 0, 0, 0, 1, 0.2, 2.5, 1]  # right, came; pose, v, phi, L, dt
    with with_worker(server, chromium, f"say('answer', '{numbers}')") as (page, _):
        page.set_viewport_size({"width": 390, "height": 800})
        page.goto(f"{server}bicycle/bicycle.html")
        page.locator(".rk-run").get_by_text("Check", exact=True).first.click()
        answer = page.locator(".rk-fresh .rk-answer")
        words = answer.get_by_text("In full colour: what is right. Red: what your function gives.")
        words.wait_for(state="attached")
        answer.scroll_into_view_if_needed()
        words.wait_for()
        box = answer.locator("svg").bounding_box()
        assert 0 < box["x"] < box["x"] + box["width"] < 390
        assert answer.locator("[style*='#rk-hatch']").count() == 1


@pytest.mark.browser
def test_all_that_a_run_may_show_leaves_the_page_alive(flooded):
    bar = flooded.locator(".rk-run").first
    bar.get_by_text("Run", exact=True).click()
    fresh = flooded.locator(".rk-fresh pre").first
    flooded.wait_for_function(
        "(pre) => pre.innerText.length === 20_000", arg=fresh.element_handle()
    )
    bar.get_by_text("Reset", exact=True).click()
    fresh.wait_for(state="detached")


@pytest.mark.browser
def test_a_program_is_written_where_it_is_first_clicked(flooded):
    flooded.goto(flooded.url.replace(PAGE, "bicycle/bicycle.html"))
    code = flooded.locator("[class*=tag_program-] pre").first
    code.get_by_text("...").click()
    line = flooded.locator(".cm-activeLine, .cm-line", has_text="...").first
    line.wait_for()
    expect(flooded.locator(".cm-content").first).to_be_focused()
    flooded.keyboard.press("Home")
    flooded.keyboard.type("# here ")
    expect(flooded.locator(".cm-line", has_text="# here ...")).to_have_count(1)


def change(page, source):
    """Write something else into the first cell of a page."""
    code = page.locator(".cell_input pre").first
    expect(code).to_have_attribute("tabindex", "0")  # once what Run loads is there
    code.click()
    page.locator(".cell_input .cm-content").first.fill(source)


@pytest.mark.browser
def test_a_changed_cell_comes_back_after_the_page_was_loaded_anew(flooded):
    """As long as the cell is the same; Reset forgets it."""
    page, mine = flooded, "print('mine')"
    bar, code = page.locator(".rk-run").first, page.locator(".cell_input pre").first
    back = page.get_by_text("Bring back my change")
    bar.get_by_text("Run", exact=True).click()
    change(page, mine)
    page.reload()
    assert code.inner_text().strip() != mine
    assert back.count() == 1
    back.click()
    expect(page.locator(".cell_input .cm-content").first).to_have_text(mine)
    page.evaluate(  # a new release has another cell in its place
        "() => { for (const key in localStorage) if (key.startsWith('courseware-cells'))"
        ' localStorage[key] = localStorage[key].replace(\'"first":"\', \'"first":"x\'); }'
    )
    page.reload()
    bar.get_by_text("Run", exact=True).wait_for()
    assert back.count() == 0
    bar.get_by_text("Run", exact=True).click()
    change(page, mine)
    bar.get_by_text("Reset", exact=True).click()
    page.reload()
    bar.get_by_text("Run", exact=True).wait_for()
    assert back.count() == 0


def test_one_version_of_python_is_named_everywhere():
    """By the pages, by the list of packages, and by JupyterLite's kernel."""
    assert SETTINGS["course_python"] == PLACE
    assert f"# Pyodide {VERSION}:" in (VENDORED / "README.md").read_text("utf-8")
    listed = hashlib.sha256((VENDORED / "pyodide-lock.json").read_bytes()).hexdigest()
    assert listed in (VENDORED / "README.md").read_text("utf-8")
    assert f"{PYODIDE_CDN_URL}/" == PLACE
