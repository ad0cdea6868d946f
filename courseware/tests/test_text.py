"""Formulas as one line of text."""

import sympy as sp

from courseware.equations.text import format_formula, format_with_numbers

a, b = sp.symbols("a b")


def test_the_largest_and_the_smallest_are_named_in_small_letters():
    with sp.evaluate(False):
        assert format_formula(sp.Max(a, sp.Abs(b)) - sp.Min(a, b)) == "max(a, |b|) − min(a, b)"


def test_a_minus_before_a_sum_or_a_negative_number_has_parentheses():
    with sp.evaluate(False):
        assert format_formula(-(a + b)) == "−(a + b)"
        assert format_formula(-(a + b) / 2) == "−(a + b)/2"
        assert format_formula(-a) == "−a"
        assert format_formula(a * (-b) / 2) == "−a b/2"
        assert format_with_numbers(-a / b, {a: "−3", b: "2"}, {}) == "−(−3)/2"
        assert format_with_numbers(a / b, {a: "−3", b: "2"}, {}) == "−3/2"
        assert format_with_numbers(-a / b - a / b, {a: "−3", b: "2"}, {}) == "−(−3/2) − (−3/2)"
        assert format_with_numbers(-a, {a: "−3"}, {}) == "−(−3)"


def test_a_sum_at_the_start_of_a_sum_has_no_parentheses():
    c = sp.Symbol("c")
    with sp.evaluate(False):
        assert format_formula((a - b) + c) == "a − b + c"
        assert format_formula(c - (a - b)) == "c − (a − b)"


def test_a_rest_and_the_rank_of_a_matrix_have_their_names():
    with sp.evaluate(False):
        assert format_formula(sp.Mod(a - b, 4)) == "mod(a − b, 4)"
    assert format_formula(sp.Symbol(r"\operatorname{rank}C_{1f}")) == "rank C_1f"


def test_a_product_of_matrices_is_one_of_letters():
    P, Q = (sp.MatrixSymbol(name, 2, 2) for name in ("R_1", "R_AB"))
    assert format_formula(P.T * Q) == "R_1ᵀ R_AB"
    assert format_formula(-P.inv() * sp.Matrix([a, 2])) == "−R_1⁻¹ [a, 2]"
    assert format_with_numbers(P * Q, {P: "[[1]]", Q: "[[2]]"}, {}) == "[[1]] [[2]]"
