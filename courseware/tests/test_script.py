"""The script: its modules are joined to one, which an engine or the browser runs."""

import sys
from types import SimpleNamespace

import declared  # noqa: F401  (opens the course, whose packages register their parts)
import pytest
from py_mini_racer import MiniRacer

from courseware.run import cells
from courseware.script import engine, widget
from courseware.script.modules import join_modules

PAGE = 'import { add } from "../text.js";\n\nexport const four = () => add(2, 2);\n'
TEXT = "// Sums.\n\nconst sum = (x, y) => x + y;\n\nexport const add = (x, y) => sum(x, y);\n"


def joined(**modules):
    """The script of the module `a/page.js`, and of those that it imports."""
    names = {"page": "a/page.js", "other": "a/other.js", "text": "text.js"}
    texts = {names[name]: text for name, text in modules.items()}
    return join_modules(["a/page.js"], texts.__getitem__)


def test_modules_are_joined_in_order_and_give_what_they_export():
    script = joined(page=PAGE, text=TEXT)
    with MiniRacer() as browser:
        assert browser.eval(f"Object.keys({script}).join()") == "add,four"
        assert browser.eval(f"({script}).four()") == 4
    assert "//" not in script


def test_a_module_that_two_import_is_joined_once():
    other = 'import { add } from "../text.js";\nexport const five = add(2, 3);\n'
    page = 'import {\n  five,\n} from "./other.js";\n' + PAGE
    assert joined(page=page, other=other, text=TEXT).count("const add") == 1


# What runs it


@pytest.fixture
def another(monkeypatch):
    """An engine that is not started yet."""
    monkeypatch.setattr(engine, "_loaded", [])
    engine._evaluate.cache_clear()
    yield monkeypatch
    engine._evaluate.cache_clear()
    monkeypatch.undo()
    engine._loaded.clear()  # the next one must load the parts again


def test_python_in_a_browser_asks_the_browser(another):
    with MiniRacer() as browser:
        another.setattr(sys, "platform", "emscripten")
        another.setitem(sys.modules, "pyodide", SimpleNamespace())
        another.setitem(sys.modules, "pyodide.code", SimpleNamespace(run_js=browser.eval))
        assert engine.run("courseware.parseAnswer('1/4')[0].value") == 0.25


def test_in_a_page_something_stands_in_for_each_kind_of_widget(monkeypatch):
    """Figures and exercises import them by name, also where cells run in the page."""
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.setitem(sys.modules, widget.__name__, widget)
    own = [n for n, x in vars(widget).items() if getattr(x, "__module__", "") == widget.__name__]
    cells.start(print, [])
    assert own
    assert vars(sys.modules[widget.__name__]).keys() >= {*own}
