"""Formulas with one small mistake each: a sign turned, a sine for a cosine.

A mutant is an equation that differs in one place of its right side or of its named steps.
"""

from collections.abc import Iterator
from dataclasses import replace
from random import Random

import sympy as sp
from sympy.logic.boolalg import Boolean

from courseware.equations.equation import as_written, free_symbols

SWAPPED = {sp.sin: sp.cos, sp.cos: sp.sin}


def mutants(equation, most=None):
    """Pairs (what was done, mutant): all of them, or at most so many, always the same ones."""
    found = [*_of_right(equation), *_of_steps(equation)]
    if most is not None and len(found) > most:
        found = Random(equation.name).sample(found, most)
    return found


def _of_right(equation):
    entries = list(sp.Matrix([equation.right]))
    for place, entry in enumerate(entries):
        negated = [("negated", -1 * entry)] if entry != 0 else []
        for what, changed in [*_changed(entry), *negated]:
            column = [*entries[:place], changed, *entries[place + 1 :]]
            yield f"component {place}: {what}", replace(equation, right=sp.Matrix(column))


def _of_steps(equation):
    steps, used = list(equation.where), _used(equation)
    for place, (symbol, step) in enumerate(steps):
        if symbol not in used:
            continue  # a table of steps that several formulas share, each of them uses some
        for what, changed in _changed(step):
            where = (*steps[:place], (symbol, changed), *steps[place + 1 :])
            yield f"step {symbol}: {what}", replace(equation, where=where)


def _used(equation):
    """The symbols that the right side is written in, and what their steps are written in."""
    used = free_symbols(equation.right)
    for symbol, step in reversed(list(equation.where)):
        if symbol in used:
            used = used | free_symbols(step)
    return used


def _changed(node) -> Iterator:
    """The expression with one of its terms negated, or one sine and cosine exchanged."""
    if isinstance(node, Boolean) or not node.args:
        return
    if node.func in SWAPPED:
        yield f"{node} becomes a {SWAPPED[node.func]}", SWAPPED[node.func](*node.args)
    for place, argument in enumerate(node.args):
        inner = [(f"{argument} of {node} negated", -1 * argument)] if node.is_Add else []
        for what, changed in [*inner, *_changed(argument)]:
            with as_written():
                args = [*node.args[:place], changed, *node.args[place + 1 :]]
                yield what, node.func(*args)
