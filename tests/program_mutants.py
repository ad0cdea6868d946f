"""Programs with one token changed: an operator, a function, a number, a name."""

import ast
from copy import deepcopy
from itertools import pairwise

OPERATORS = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
    ast.USub: ast.UAdd, ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.GtE, ast.GtE: ast.LtE,
    ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
}  # fmt: skip
FUNCTIONS = {"sin": "cos", "cos": "sin", "arcsin": "arccos", "arccos": "arcsin"}


def mutants(source):
    """Yield the programs as texts."""
    tree = ast.parse(source)
    for place, node in enumerate(ast.walk(tree)):
        for change in changes(node):
            other = deepcopy(tree)
            change([*ast.walk(other)][place])
            yield ast.unparse(other)


def changes(node):
    """Yield functions that change such a node."""
    if isinstance(node, ast.BinOp | ast.UnaryOp) and type(node.op) in OPERATORS:
        yield lambda n: setattr(n, "op", OPERATORS[type(n.op)]())
    if isinstance(node, ast.Compare) and type(node.ops[0]) in OPERATORS:
        yield lambda n: n.ops.__setitem__(0, OPERATORS[type(n.ops[0])]())
    if isinstance(node, ast.Attribute) and node.attr in FUNCTIONS:
        yield lambda n: setattr(n, "attr", FUNCTIONS[n.attr])
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        yield lambda n: setattr(n, "value", n.value + 1)
    if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "arctan2":
        yield lambda n: n.args.reverse()
    if isinstance(node, ast.FunctionDef):
        names = [a.arg for a in node.args.args]
        for one, other in pairwise(names):
            yield lambda n, pair={one: other, other: one}: exchange(n, pair)


def exchange(function, pair):
    """Exchange two arguments in the body of a function."""
    for node in ast.walk(function):
        if isinstance(node, ast.Name):
            node.id = pair.get(node.id, node.id)
