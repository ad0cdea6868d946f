"""Formulas as one line of text."""

import sympy as sp

from workshop.equations.text import formula_text

a, b = sp.symbols("a b")


def test_the_largest_and_the_smallest_are_named_in_small_letters():
    with sp.evaluate(False):
        assert formula_text(sp.Max(a, sp.Abs(b)) - sp.Min(a, b)) == "max(a, |b|) − min(a, b)"
