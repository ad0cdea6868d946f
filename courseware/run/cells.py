"""Python in the page: runs the cells of a chapter, and says what they show.

The worker (`worker.js`) gives this file to the Python that it has loaded. Packages come late: an
import is done when its name is first used, so that a cell that only computes does not wait for
what draws and derives.
"""

import ast
import base64
import io
import linecache
import os
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from types import CodeType, ModuleType
from typing import Any

MOST = 20_000  # characters that a cell may print: more than a page can show
PICTURES = ("image/png", "image/svg+xml")
# the first of these that a value has is shown
SHOWN = (*PICTURES, "text/html", "text/latex", "text/plain")
BRACKETS: dict[type, tuple[str, str]] = {tuple: ("(", ")"), list: ("[", "]")}
METHODS = {
    "image/svg+xml": "_repr_svg_",
    "text/html": "_repr_html_",
    "text/latex": "_repr_latex_",
}


class Still:
    """In place of a widget: figures and boxes that move stand on the page itself."""

    def __init__(self, part: str, content: str, state: dict[str, Any]) -> None:
        self.state = state

    def output(self, others: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
        """What an output holds: all but the widget."""
        return others, {}

    def observe(self, handler: Callable[..., None], names: str) -> None:
        """Nobody moves it."""


def start(say: Callable[[str, str], None], packages: list[str]) -> "Cells":
    """Get this Python ready, and the cells; what these take is said there."""
    os.environ["MPLBACKEND"] = "agg"
    warnings.filterwarnings("ignore", "FigureCanvasAgg is non-interactive")  # the cell shows it
    widgets = ModuleType("courseware.script.widget")
    vars(widgets).update(Widget=Still, widget=Still)
    sys.modules[widgets.__name__] = widgets
    return Cells(say, frozenset(packages))


class Printed(io.TextIOBase):
    """What a cell prints goes to the page as it comes, up to a limit."""

    def __init__(self, say: Callable[[str, str], None], kind: str) -> None:
        self.say, self.kind, self.left = say, kind, MOST

    def write(self, text: str) -> int:
        """Some of a line, or several."""
        if self.left > 0 and text:
            self.say(self.kind, text[: self.left])
            self.left -= len(text)
            if self.left <= 0:
                self.say(self.kind, "\n… and more, which is not shown\n")
        return len(text)


class Cells:
    """The cells of a page, which share their names.

    say: takes the kind of an output (its MIME type, `stdout`, `stderr` or `error`) and its text.
    packages: what can be imported once it is loaded, by the names of imports.
    """

    def __init__(self, say: Callable[[str, str], None], packages: frozenset[str]) -> None:
        self.say, self.packages = say, packages
        self.names: dict[str, Any] = {"__name__": "__main__", "display": self.display}
        self.later: dict[str, ast.stmt] = {}  # imports that wait for their names to be used

    def needs(self, source: str) -> list[str]:
        """The packages that must be there before a cell runs, by the names of imports."""
        try:
            tree, _ = self._without_later(source)
        except SyntaxError:
            return []  # the run will say it
        return sorted(set(self._imported(tree, set())))

    def run(self, source: str, name: str) -> bool:
        """Run a cell; whether it came to its end. name: how errors call it."""
        linecache.cache[name] = (len(source), None, source.splitlines(True), name)
        out, err = Printed(self.say, "stdout"), Printed(self.say, "stderr")
        with redirect_stdout(out), redirect_stderr(err):
            try:
                tree, waiting = self._without_later(source)
                self.later.update(waiting)
                self._evaluate(tree, source, name)
                self._pictures()
            except BaseException as error:  # also SystemExit: the page goes on
                self.say("error", _in_words(error, name))
                return False
        return True

    def display(self, *values: Any) -> None:
        """Show values, as a cell shows its last one."""
        for value in values:
            data = _data(value)
            kind = next(kind for kind in SHOWN if kind in data)
            self.say(kind, data[kind])

    def _without_later(self, source: str) -> tuple[ast.Module, dict[str, ast.stmt]]:
        """A cell after the imports that it uses, and those of its own that can wait."""
        tree = ast.parse(source)
        used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        body: list[ast.stmt] = []
        waiting: dict[str, ast.stmt] = {}
        for statement in tree.body:
            imports = [*_single(statement)]
            if not imports:
                body.append(statement)
            for name, single in imports:
                if name in used or not self._can_wait(single):
                    body.append(single)
                else:
                    waiting[name] = single
        body[:0] = [self.later[name] for name in sorted(used & set(self.later))]
        tree.body = body
        return tree, waiting

    def _can_wait(self, single: ast.stmt) -> bool:
        """Whether an import is of what is known: else its error is said at once."""
        modules = [*_modules(single)]
        return any(_file(module) or module in self.packages for module in modules)

    def _imported(self, tree: ast.AST, seen: set[str]) -> Iterator[str]:
        """The packages that are imported, also by modules that lie here as a file."""
        for node in ast.walk(tree):
            for module in _modules(node):
                parts = module.split(".")
                for name in (".".join(parts[:k]) for k in range(1, len(parts) + 1)):
                    if name in seen or name in sys.modules:
                        continue
                    seen.add(name)
                    if parts[0] in self.packages:
                        yield parts[0]
                    elif file := _file(name):
                        with open(file, encoding="utf-8") as source:
                            yield from self._imported(ast.parse(source.read()), seen)

    def _evaluate(self, tree: ast.Module, source: str, name: str) -> None:
        """All statements; what the last one gives is shown, unless a semicolon follows."""
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(_compiled(tree, name, "exec"), self.names)
        if isinstance(last, ast.Expr):
            value = eval(_compiled(ast.Expression(last.value), name, "eval"), self.names)
            if value is not None and not source.rstrip().endswith(";"):
                self.names["_"] = value
                self.display(value)

    def _pictures(self) -> None:
        """What the cell has drawn and not closed."""
        plt = sys.modules.get("matplotlib.pyplot")
        if plt is None:
            return
        for number in plt.get_fignums():
            file = io.BytesIO()
            plt.figure(number).savefig(file, format="png")
            self.say("image/png", base64.b64encode(file.getvalue()).decode())
        plt.close("all")


def _compiled(tree: ast.Module | ast.Expression, name: str, mode: str) -> CodeType:
    code = compile(tree, name, mode)
    assert isinstance(code, CodeType)
    return code


def _data(value: Any) -> dict[str, str]:
    """What a value can be shown as, by MIME type."""
    bundle = getattr(value, "_repr_mimebundle_", None)
    if bundle and not isinstance(value, type):
        found = bundle()
        return {"text/plain": repr(value), **(found[0] if isinstance(found, tuple) else found)}
    data = {"text/plain": _plain(value)}
    for kind, method in METHODS.items():
        if not isinstance(value, type) and hasattr(value, method):
            shown = getattr(value, method)()
            data |= {kind: shown} if shown else {}
    return data


def _plain(value: Any) -> str:
    """As a notebook prints it: the parts of a list on lines of their own where one is long."""
    text = repr(value)
    if type(value) not in BRACKETS or "\n" not in text:
        return text
    before, after = BRACKETS[type(value)]
    parts = (_plain(part).replace("\n", "\n ") for part in value)
    return before + ",\n ".join(parts) + after


# --- imports --------------------------------------------------------------------------------


def _single(statement: ast.stmt) -> Iterator[tuple[str, ast.stmt]]:
    """Each name that an import gives, with a statement that gives only that."""
    if not isinstance(statement, ast.Import | ast.ImportFrom):
        return
    for alias in statement.names:
        name = alias.asname or alias.name.partition(".")[0]
        if isinstance(statement, ast.Import):
            single: ast.stmt = ast.Import([alias])
        else:
            single = ast.ImportFrom(statement.module, [alias], statement.level)
        yield name, ast.copy_location(single, statement)


def _modules(statement: ast.AST) -> Iterator[str]:
    """The modules that an import may name."""
    if isinstance(statement, ast.Import):
        yield from (alias.name for alias in statement.names)
    if isinstance(statement, ast.ImportFrom) and statement.module:
        yield statement.module
        yield from (f"{statement.module}.{alias.name}" for alias in statement.names)


def _file(module: str) -> str:
    """Where the source of a module lies, or nothing."""
    path = module.replace(".", "/")
    ends = (f"{path}.py", f"{path}/__init__.py")
    places = (os.path.join(folder, end) for folder in sys.path for end in ends)
    return next(filter(os.path.exists, places), "")


# --- errors ---------------------------------------------------------------------------------


def _in_words(error: BaseException, name: str) -> str:
    """What went wrong, in which line; then all of it, as Python says it."""
    kind, line = type(error).__name__, None
    if isinstance(error, SyntaxError):
        line, words = error.lineno, error.msg
    else:
        words = str(error)
        steps = traceback.extract_tb(error.__traceback__)
        line = next((step.lineno for step in reversed(steps) if step.filename == name), None)
    code = linecache.getline(name, line).strip() if line else ""
    where = f"Line {line}, {code}\n" if code else ""
    return f"{where}{kind}: {words}" if words else f"{where}{kind}"
