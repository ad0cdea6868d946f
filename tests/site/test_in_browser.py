"""Chapters run in a real browser by a real Python: *Run* in the page, and JupyterLite beside it.

Where Python's public address is not reached, `pyodide.py` answers for it with what is to be had;
what needs more is left out, and the skip says so.
"""

import ast
import re
import time
from types import SimpleNamespace

import pyodide
import pytest
from browser import UNFOLD, watched_page
from playwright.sync_api import expect
from support import ROOT
from test_run import CHAPTERS, PAGE, code_cells, names, shown_cells, stored

from courseware.run import cells as in_page

pytest_plugins = ["browser"]
pytestmark = [pytest.mark.browser, pytest.mark.install]

START = 120_000  # ms: until Python runs, beside eight busy processes
CHAPTER = 1_200_000  # ms: all cells of the longest
SOON = 20  # s, in which a reader is told that nothing comes
NUMBER = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")
NEAR = 1e-6  # prints are rounded, but another library's sine differs in the last digit
LOST = re.compile(r"\de-\d+")  # a digit and a power: how much was lost in rounding, which differs


LISTEN = """(bar) => {
  const once = { once: true };
  globalThis.ran = new Promise((end) => bar.addEventListener("courseware:ran", end, once));
}"""
RAN = """async (limit) => {
  await Promise.race([ran, new Promise((_, fail) => setTimeout(fail, limit, "it runs on"))]);
}"""


class Cells:
    """The cells of a page that a reader may run."""

    def __init__(self, page):
        self.page = page

    def bar(self, k):
        return self.page.locator(".rk-run").nth(k)

    def code(self, k):
        """The code of a cell, in its editor if the reader has been there."""
        input = self.bar(k).locator("xpath=..")
        return input.locator(".cm-content, pre:not([hidden])").first

    def cell(self, k):
        return self.bar(k).locator("xpath=ancestor::div[starts-with(@class, 'cell ')][1]")

    def output(self, k):
        """The outputs of a cell that has run."""
        return self.cell(k).locator(".rk-fresh").inner_text().strip()

    def open(self):
        """Let the code be changed: what is pressed is stopped while Python loads."""
        self.press(0)
        self.bar(0).get_by_text("Stop", exact=True).wait_for()
        self.press(0)
        self.finish()

    def press(self, k):
        self.bar(k).evaluate(LISTEN)
        self.bar(k).locator("button").first.click()

    def finish(self, timeout=START):
        """Wait until what was pressed has run."""
        self.page.evaluate(RAN, timeout)

    def write(self, k, source):
        self.code(k).click()
        self.bar(k).locator("xpath=..").locator(".cm-content").fill(source)

    def run(self, k, source=None):
        if source is not None:
            self.write(k, source)
        self.press(k)
        self.finish()


@pytest.fixture
def page(server, chromium):
    """A page that can reach Python; nothing else is asked of strangers."""
    with watched_page(chromium, server) as (page, watch):
        pyodide.answer(page.context)
        yield page
        assert not [url for url in watch.strangers if not url.startswith(pyodide.PLACE)]


@pytest.fixture
def cells(page, server):
    """The cells of a chapter, the first of which has been changed and run."""
    page.goto(f"{server}frames/frames.html")
    page.locator("main").evaluate(UNFOLD)
    cells = Cells(page)
    cells.open()
    began = time.monotonic()
    cells.run(0, "a = 1\nprint('first')")
    print(f"first output after {time.monotonic() - began:.1f} s, with everything cached")
    return cells


def test_cells_are_changed_and_run_in_order(cells):
    """A cell runs after those above it, anew after a change above; Reset brings back what was."""
    assert cells.output(0) == "first"
    original = cells.code(2).inner_text().rstrip("\n")  # an editor has none at the end
    cells.run(1, "a += 1")
    cells.run(2, "print(a)")
    assert cells.output(2) == "2"
    cells.write(0, "a = 5")
    cells.run(2)
    assert cells.output(2) == "6"
    stored = cells.cell(2).locator(".cell_output:not(.rk-fresh)").first
    assert stored.is_hidden()
    cells.bar(2).get_by_text("Reset").click()
    assert cells.code(2).inner_text() == original
    assert stored.is_visible()


def test_an_error_is_told_where_it_is_and_stops_what_is_below(cells):
    cells.run(0, "a = 1\na / 0")
    assert cells.output(0).split("\n") == ["Line 2, a / 0", "ZeroDivisionError: division by zero"]
    cells.run(1, "print(a)")
    assert "Cell 1, above, stops with an error." in cells.bar(1).inner_text()


def test_an_endless_loop_is_stopped_and_python_starts_anew(cells):
    cells.write(0, "print('on')\nwhile True:\n    pass")
    cells.press(0)
    cells.page.locator(".rk-fresh", has_text="on").wait_for()
    cells.press(0)
    cells.bar(0).get_by_text("Stopped. Python has forgotten all names").wait_for()
    cells.run(0, "print('a' in globals())")
    assert cells.output(0) == "False"


def test_what_is_derived_is_shown_as_a_formula(cells):
    cells.run(0, "import sympy as sp\nsp.sqrt(sp.Symbol('x')) / 2")
    formula = cells.page.locator(".rk-fresh .katex")
    assert formula.locator("annotation").text_content() == r"\displaystyle \frac{\sqrt{x}}{2}"


def test_a_host_that_never_answers_is_told_soon(server, chromium):
    with watched_page(chromium, server) as (page, _):
        page.context.route(f"{pyodide.PLACE}**", lambda route: None)
        page.goto(server + PAGE)
        cells = Cells(page)
        cells.press(0)
        said = cells.bar(0).get_by_text("The network here may block it.")
        said.wait_for(timeout=SOON * 1000)


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_a_chapter_gives_in_the_page_what_is_stored(chapter, page, server, monkeypatch):
    """All its cells; without the lines, and what comes of them, that need what is not to be had."""
    shown = shown_cells(chapter)
    kept, lacking = what_can_run(shown, monkeypatch)
    whole = [k for k, cell in enumerate(shown) if cell["outputs"] and k not in kept]
    said = f"{chapter}: {len(whole)} outputs are compared, the others need {', '.join(lacking)}"
    if not whole:
        pytest.skip(said)
    page.goto(f"{server}{chapter}/{chapter}.html")
    page.locator("main").evaluate(UNFOLD)
    cells = Cells(page)
    cells.open()
    for k, source in kept.items():
        cells.write(k, source)
    cells.press(len(shown) - 1)
    cells.finish(CHAPTER)
    assert page.locator(".rk-failed").all_inner_texts() == []
    for k in whole:
        text, formulas, pictures = stored(shown[k])
        fresh = cells.cell(k).locator(".rk-fresh")
        assert fresh.locator("img").count() == pictures
        assert fresh.locator(".katex-display").count() == len(formulas)
        if not formulas:
            assert_alike(fresh.inner_text(), text)
    if lacking:
        pytest.skip(said)


def what_can_run(shown, monkeypatch):
    """What is left of the cells that need what is not to be had, by number; and what that is."""
    packages, missing = pyodide.packages(), set(pyodide.missing())
    provided = {each: name for name in packages for each in packages[name]["imports"]}
    fresh = SimpleNamespace(modules={"courseware.script.widget"}, path=[str(ROOT)])
    monkeypatch.setattr(in_page, "sys", fresh)  # a Python that has imported nothing yet
    cells = in_page.Cells(print, frozenset(provided))
    imports, unmade, kept, lacking = "", set(), {}, set()
    for k, cell in enumerate(shown):
        statements = ast.parse("".join(cell["source"])).body
        imports += "".join(f"{ast.unparse(each)}\n" for each in statements if imported(each))
        body = []
        for each in statements:
            needs = cells.needs(imports + ast.unparse(each))
            lacks = missing.intersection(
                pyodide.with_dependencies(packages, [provided[name] for name in needs])
            )
            if imported(each) or not (lacks or names(each, ast.Load) & unmade):
                body.append(ast.unparse(each))
                unmade -= names(each, ast.Store)
            else:
                unmade |= changed(each) - names(ast.parse(imports), ast.Store)
                lacking |= lacks
        if len(body) < len(statements):
            kept[k] = "\n".join(body)
    return kept, sorted(lacking)


def imported(statement):
    return isinstance(statement, ast.Import | ast.ImportFrom)


def changed(statement):
    """The names that a statement makes, and those of lists to which it adds."""
    added = [n.value for n in ast.walk(statement) if getattr(n, "attr", "") == "append"]
    return names(statement, ast.Store) | {n.id for n in added if isinstance(n, ast.Name)}


def assert_alike(text, expected):
    """The same words, and numbers that are the same but for rounding."""
    assert NUMBER.sub("#", text).split() == NUMBER.sub("#", expected).split()
    for one, other in zip(NUMBER.findall(text), NUMBER.findall(expected), strict=True):
        if LOST.fullmatch(one) and LOST.fullmatch(other):
            assert 0.1 <= float(one) / float(other) <= 10
        else:
            assert abs(float(one) - float(other)) <= NEAR * max(1, abs(float(other)))


# --- JupyterLite ----------------------------------------------------------------------------

MOVING = [f"application/vnd.courseware.{thing}+json" for thing in ("figure", "exercise")]
WIDGETS = """import anywidget, ipywidgets
class Tiny(anywidget.AnyWidget):
    _esm = "export default {render: ({el}) => { el.textContent = 'tiny ' + 6 * 7; }}"
Tiny()"""


def wait_for_notebook(page):
    """Its cells come before its kernel, and what is run without one is forgotten."""
    page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=START)
    page.locator(".jp-Toolbar-kernelName", has_text="Python (Pyodide)").wait_for(timeout=START)


def write_and_run(page, source):
    """Change the first code cell of a notebook, and run it."""
    code = page.locator(".jp-CodeCell .cm-content").first
    code.click()
    page.keyboard.press("ControlOrMeta+A")
    page.keyboard.insert_text(source)
    expect(code).to_contain_text(source.partition("\n")[0])
    page.keyboard.press("Shift+Enter")


def test_a_chapter_opens_in_jupyterlite_ready_to_run(page, server):
    """By the button of its page: no dialog, no cell that installs; widgets live."""
    page.goto(server + PAGE)
    page.get_by_label("Run this chapter").click()
    with page.expect_popup() as opened:
        page.get_by_role("link", name="In the browser").click()
    page = opened.value
    began = time.monotonic()
    wait_for_notebook(page)
    write_and_run(page, "print(6 * 7)")
    page.locator(".jp-OutputArea-output", has_text="42").wait_for(timeout=START)
    print(f"first output after {time.monotonic() - began:.1f} s")
    assert not page.locator(".jp-Dialog").count()
    write_and_run(page, WIDGETS)
    page.get_by_text("tiny 42").wait_for(timeout=START)


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_a_chapter_runs_in_jupyterlite(chapter, page, server, monkeypatch):
    _, lacking = what_can_run(code_cells(chapter), monkeypatch)
    if lacking:
        pytest.skip(f"{chapter} needs {', '.join(lacking)}")
    page.goto(f"{server}lite/notebooks/index.html?path={chapter}.ipynb")
    wait_for_notebook(page)
    page.get_by_text("Run", exact=True).click()
    page.get_by_text("Run All Cells", exact=True).click()
    waiting = page.locator(".jp-InputPrompt", has_text="[*]")
    waiting.first.wait_for()
    expect(waiting).to_have_count(0, timeout=CHAPTER)
    assert page.locator(".jp-OutputArea-output [data-mime-type*=error]").all_inner_texts() == []
    kinds = [kind for c in code_cells(chapter) for o in c["outputs"] for kind in o.get("data", ())]
    widgets = [kind for kind in kinds if kind in MOVING]
    expect(page.locator(".rk-live")).to_have_count(len(widgets))
