"""Python in the page: runs the cells of a chapter and sends their outputs.

The worker (`worker.js`) gives this file to the Python that it has loaded. An import is postponed
until its name is used, so that a cell that only computes does not wait for Matplotlib or SymPy.
"""

import ast
import base64
import io
import json
import linecache
import os
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from types import ModuleType
from typing import Any

PRINT_LIMIT = 20_000  # characters of text in a run, more than a page can show
OUTPUT_LIMIT = 40  # values and pictures in a run
MORE = "\n… and more, which is not shown\n"
STREAMS = ("stdout", "stderr")
ANSWER = "answer"  # the numbers of a wrong answer's picture, which the page draws
PICTURES = ("image/png", "image/svg+xml")
# of these the first that a value has is shown
SHOWN = (*PICTURES, "text/html", "text/latex", "text/plain")
BRACKETS: dict[type, tuple[str, str]] = {tuple: ("(", ")"), list: ("[", "]")}
METHODS = {
    "image/svg+xml": "_repr_svg_",
    "text/html": "_repr_html_",
    "text/latex": "_repr_latex_",
}


class NoWidget:
    """Stands in for a widget: figures and boxes are on the page itself."""

    def __init__(self, part: str, content: str, state: dict[str, Any]) -> None:
        self.state = state

    def render_output(self, others: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
        return others, {}

    def observe(self, handler: Callable[..., None], names: str) -> None:
        """Do nothing: nobody moves it."""


def start(send: Callable[[str, str], None], packages: list[str]) -> "Cells":
    """Prepare this Python, and return its cells."""
    os.environ["MPLBACKEND"] = "agg"
    warnings.filterwarnings("ignore", "FigureCanvasAgg is non-interactive")  # the cell shows it
    widgets = ModuleType("courseware.script.widget")
    vars(widgets).update(Widget=NoWidget, create_widget=NoWidget)
    sys.modules[widgets.__name__] = widgets
    return Cells(send, frozenset(packages))


class Output:
    """Sends what a run shows to the page, up to a limit: a flood would freeze it."""

    def __init__(self, send: Callable[[str, str], None]) -> None:
        self.send, self.letters, self.outputs = send, PRINT_LIMIT, OUTPUT_LIMIT

    def __call__(self, kind: str, text: str) -> None:
        if not text or min(self.letters, self.outputs) < 0:
            return
        plain = kind in (*STREAMS, "text/plain")
        shown = text[: self.letters] if plain else text
        self.letters -= len(text) if plain else 0
        self.outputs -= kind not in STREAMS
        if self.outputs >= 0:
            self.send(kind, shown)
        if min(self.letters, self.outputs) < 0:
            self.send("stdout", MORE)


class PrintStream(io.TextIOBase):
    """Sends printed text to the page as it comes."""

    def __init__(self, send: Callable[[str, str], None], kind: str) -> None:
        self.send, self.kind = send, kind

    def write(self, text: str) -> int:
        self.send(self.kind, text)
        return len(text)


class Cells:
    """The cells of a page, which share their names.

    Args:
        send: takes the kind of an output (a MIME type, `stdout`, `stderr` or `error`) and its text.
        packages: names of imports whose packages the worker can load.
    """

    def __init__(self, send: Callable[[str, str], None], packages: frozenset[str]) -> None:
        self.send, self.packages = send, packages
        self.output = Output(send)  # of the present run
        self.names: dict[str, Any] = {"__name__": "__main__", "display": self.display}
        self.postponed: dict[str, ast.stmt] = {}  # imports, by the name that each binds

    def needs(self, source: str) -> list[str]:
        """Return the packages to load before a cell runs, by the names of imports."""
        try:
            tree, _ = self._postpone_imports(source)
        except SyntaxError:
            return []  # `run` reports it
        return sorted(set(self._find_packages(tree, set())))

    def run(self, source: str, name: str) -> bool:
        """Run a cell and return whether it succeeded. name: of the cell, for tracebacks."""
        linecache.cache[name] = (len(source), None, source.splitlines(True), name)
        self.output = Output(self.send)
        out, err = (PrintStream(self.output, kind) for kind in STREAMS)
        with redirect_stdout(out), redirect_stderr(err):
            try:
                tree, postponed = self._postpone_imports(source)
                self.postponed.update(postponed)
                self._execute(tree, source, name)
                self._send_pictures()
            except BaseException as error:  # also SystemExit: the page goes on
                self.send("error", _describe_error(error, name))
                return False
        return True

    def check(self, source: str, name: str, stored: str) -> bool:
        """Judge a program, and return whether it ran."""
        import numpy as np

        from courseware import judge

        alone = Cells(self.send, self.packages)
        alone.names["np"] = np
        if not alone.run(source, name):
            return False
        program = json.loads(stored)
        verdict = judge.check(alone.names.get(program["function"]), program)
        alone.display(verdict)
        if verdict.numbers:
            alone.output(ANSWER, json.dumps(verdict.numbers))
        return True

    def display(self, *values: Any) -> None:
        """Show values, as a cell shows its last one."""
        for value in values:
            data = _represent(value)
            kind = next(kind for kind in SHOWN if kind in data)
            self.output(kind, data[kind])

    def _postpone_imports(self, source: str) -> tuple[ast.Module, dict[str, ast.stmt]]:
        """Return a cell with the imports that it uses first, and its unused imports by name."""
        tree = ast.parse(source)
        used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        body: list[ast.stmt] = []
        postponed: dict[str, ast.stmt] = {}
        for statement in tree.body:
            imports = [*_split_import(statement)]
            if not imports:
                body.append(statement)
            for name, single in imports:
                if name in (*used, "*") or not self._is_available(single):
                    body.append(single)
                else:
                    postponed[name] = single
        body[:0] = [self.postponed[name] for name in sorted(used & set(self.postponed))]
        tree.body = body
        return tree, postponed

    def _is_available(self, single: ast.stmt) -> bool:
        """Return whether an import finds something; an error is reported at once."""
        return any(_find_file(m) or m in self.packages for m in _imported_modules(single))

    def _find_packages(self, tree: ast.AST, seen: set[str]) -> Iterator[str]:
        """Yield the packages that code imports, itself or through modules that are files here."""
        for node in ast.walk(tree):
            for module in _imported_modules(node):
                parts = module.split(".")
                for name in (".".join(parts[:k]) for k in range(1, len(parts) + 1)):
                    if name in seen or name in sys.modules:
                        continue
                    seen.add(name)
                    if parts[0] in self.packages:
                        yield parts[0]
                    elif file := _find_file(name):
                        with open(file, encoding="utf-8") as source:
                            yield from self._find_packages(ast.parse(source.read()), seen)

    def _execute(self, tree: ast.Module, source: str, name: str) -> None:
        """Execute all statements and show the last value, unless a semicolon follows."""
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, name, "exec"), self.names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), name, "eval"), self.names)
            if value is not None and not source.rstrip().endswith(";"):
                self.names["_"] = value
                self.display(value)

    def _send_pictures(self) -> None:
        plt = sys.modules.get("matplotlib.pyplot")
        if plt is None:
            return
        for number in plt.get_fignums():
            file = io.BytesIO()
            plt.figure(number).savefig(file, format="png")
            self.output("image/png", base64.b64encode(file.getvalue()).decode())
        plt.close("all")


def _represent(value: Any) -> dict[str, str]:
    data = {"text/plain": _format_plain(value)}
    if isinstance(value, type):
        return data
    if bundle := getattr(value, "_repr_mimebundle_", None):
        found = bundle()
        data |= found[0] if isinstance(found, tuple) else found
        return data
    texts = {kind: getattr(value, method, str)() for kind, method in METHODS.items()}
    return data | {kind: text for kind, text in texts.items() if text}


def _format_plain(value: Any) -> str:
    """Format a value as a notebook does: parts of several lines start on lines of their own."""
    text = repr(value)
    if type(value) not in BRACKETS or "\n" not in text:
        return text
    before, after = BRACKETS[type(value)]
    parts = (_format_plain(part).replace("\n", "\n ") for part in value)
    return before + ",\n ".join(parts) + after


def _split_import(statement: ast.stmt) -> Iterator[tuple[str, ast.stmt]]:
    """Yield each name that an import binds, with a statement that binds only this name."""
    if not isinstance(statement, ast.Import | ast.ImportFrom):
        return
    for alias in statement.names:
        name = alias.asname or alias.name.partition(".")[0]
        if isinstance(statement, ast.Import):
            single: ast.stmt = ast.Import([alias])
        else:
            single = ast.ImportFrom(statement.module, [alias], statement.level)
        yield name, ast.copy_location(single, statement)


def _imported_modules(statement: ast.AST) -> Iterator[str]:
    if isinstance(statement, ast.Import):
        yield from (alias.name for alias in statement.names)
    if isinstance(statement, ast.ImportFrom) and statement.module:
        yield statement.module
        yield from (f"{statement.module}.{alias.name}" for alias in statement.names)


def _find_file(module: str) -> str:
    """Return the source file of a module, or ""."""
    path = module.replace(".", "/")
    ends = (f"{path}.py", f"{path}/__init__.py")
    places = (os.path.join(folder, end) for folder in sys.path for end in ends)
    return next(filter(os.path.exists, places), "")


def _describe_error(error: BaseException, name: str) -> str:
    """Return the line of the cell in which an error was raised, and Python's message."""
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
