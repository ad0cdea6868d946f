"""The source of a function in a chapter: the printed code is the code that runs."""

import ast
import inspect
import textwrap
from collections.abc import Callable
from typing import Any


class Listing:
    """Python source as the value of a notebook cell, coloured in JupyterLab and on the page."""

    def __init__(self, source: str) -> None:
        self.source = source

    def _repr_markdown_(self) -> str:
        return f"```python\n{self.source}\n```"

    def __repr__(self) -> str:
        return self.source


def show_source(function: Callable[..., Any]) -> Listing:
    """Show the source of a function without its docstring and decorators."""
    source = textwrap.dedent(inspect.getsource(inspect.unwrap(function)))
    tree = ast.parse(source).body[0]
    assert isinstance(tree, ast.FunctionDef)
    lines = source.splitlines()
    body = tree.body[1].lineno if ast.get_docstring(tree) else tree.body[0].lineno
    head = lines[tree.lineno - 1 : tree.body[0].lineno - 1]
    return Listing("\n".join([*head, *lines[body - 1 :]]).rstrip())
