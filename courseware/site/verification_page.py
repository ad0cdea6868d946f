"""The page of checks: every formula, and the function that a test compares it with."""

import ast
import inspect
from collections.abc import Iterator
from itertools import groupby
from typing import Any

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from courseware.course import course
from courseware.equations.declared_checks import Check, declared_checks


class FormulaChecks(SphinxDirective):
    """A section for each chapter with its formulas and the functions that they agree with."""

    def run(self) -> list[nodes.Node]:
        text = "\n\n".join(describe_checks(declared_checks()))
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def describe_checks(checks: dict[str, Check]) -> list[str]:
    """Return the page as Markdown: each chapter's title and formulas."""
    entries = list[str]()
    for chapter, group in groupby(checks.values(), lambda check: check.name.partition(".")[0]):
        shared = chapter not in course().taught  # by several chapters, without a notebook
        title = chapter.replace("_", " ").capitalize() if shared else course().title(chapter)
        entries += [f"## {title}", *map(_describe, group)]
    return entries


def _describe(check: Check) -> str:
    display = f"$$\n{check.equation.latex(computed=True)}\n$$"
    return (
        f":::{{container}} rk-check\n{display}\n\n"
        f"`{check.name}` is compared with {describe_function(check)}: at most "
        f"{format_power(check.tolerance)} apart ({check.reason}).\n:::"
    )


def describe_function(check: Check) -> str:
    """Return what computes: a function, or the library's functions in one that adapts them."""
    called = getattr(check.function, "func", check.function)  # of a partial
    is_adapter = _is_adapter(called)
    computing = _library_functions(called) if is_adapter else [called]
    names = " and ".join(dict.fromkeys(f"`{f.__module__}.{f.__name__}`" for f in computing))
    how = "*" + (called.__doc__ or "").partition("\n")[0].rstrip(".") + "*"
    return f"{names} ({how})" if names and is_adapter else names or how


def _is_adapter(function: Any) -> bool:
    home = function.__module__
    return home.startswith(f"{course().package}.") and home not in course().library_modules


def _library_functions(adapter: Any) -> Iterator[Any]:
    """Yield the library's functions that the code of a function names."""
    known = adapter.__globals__
    for node in ast.walk(ast.parse(inspect.getsource(adapter))):
        named = known.get(node.id) if isinstance(node, ast.Name) else None
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            named = getattr(known.get(node.value.id), node.attr, None)
        if inspect.isfunction(named) and named.__module__ in course().library_modules:
            yield named
        elif inspect.isfunction(named) and _is_adapter(named):
            yield from _library_functions(named)


def format_power(number: float) -> str:
    """Return a number with one digit and a power of ten."""
    digit, exponent = f"{number:.0e}".split("e")
    power = f"{int(exponent)}".replace("-", "\u2212")
    return f"{digit}\u00a0·\u00a010{{sup}}`{power}`"
