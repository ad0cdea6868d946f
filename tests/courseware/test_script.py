"""The script: its modules are joined to one, which an engine or the browser runs."""

import re
import sys
from types import SimpleNamespace

import declared  # noqa: F401  (opens the course, whose packages register their parts)
import pytest
from py_mini_racer import MiniRacer

from courseware.errors import CourseError
from courseware.run import cells
from courseware.script import engine, parts, widget
from courseware.script.modules import join_modules

PAGE = 'import { add } from "../text.js";\n\nexport const four = () => add(2, 2);\n'
TEXT = "// Sums.\n\nconst sum = (x, y) => x + y;\n\nexport const add = (x, y) => sum(x, y);\n"


def joined(**modules):
    """The script of the module `a/page.js`, and of those that it imports."""
    names = {"page": "a/page.js", "other": "a/other.js", "text": "text.js"}
    texts = {names[name]: text for name, text in modules.items()}

    def read(path):
        if path not in texts:
            raise FileNotFoundError(path)
        return texts[path]

    return join_modules(["a/page.js"], read)


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


@pytest.mark.parametrize(
    ("modules", "told"),
    [
        ({"page": PAGE}, "a/page.js → text.js: the last is missing"),
        (
            {"page": PAGE.replace("add", "sum"), "text": TEXT},
            "a/page.js imports sum from text.js, which has only add",
        ),
        (
            {"page": PAGE + "const sum = 4;\n", "text": TEXT},
            "sum is declared in text.js and in a/page.js: rename one",
        ),
        (
            {"page": PAGE, "text": 'import { four } from "./a/page.js";\n' + TEXT},
            "modules import each other: a/page.js → text.js → a/page.js",
        ),
        (
            {"page": 'import * as text from "../text.js";\n', "text": TEXT},
            'a/page.js has `import * as text from "../text.js";`, which is not read',
        ),
        ({"page": "export default 4;\n"}, "a/page.js has `export default 4;`, which is not read"),
    ],
)
def test_modules_that_cannot_be_joined_are_refused(modules, told):
    with pytest.raises(CourseError, match=re.escape(told)):
        joined(**modules)


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


def test_an_unknown_part_is_refused():
    with pytest.raises(CourseError, match="no part 'sound' is registered; there are figures, prac"):
        parts.bundle_page(["sound"])


def test_in_a_page_something_stands_in_for_each_kind_of_widget(monkeypatch):
    """Figures and exercises import them by name, also where cells run in the page."""
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.setitem(sys.modules, widget.__name__, widget)
    own = [n for n, x in vars(widget).items() if getattr(x, "__module__", "") == widget.__name__]
    cells.start(print, [])
    assert own
    assert vars(sys.modules[widget.__name__]).keys() >= {*own}
