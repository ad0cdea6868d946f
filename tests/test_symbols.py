"""One symbol, one thing: what is printed is declared, and lights up wherever it stands."""

import pytest
from declared import course

from workshop.course import held
from workshop.equations.core import NamedSymbol, quantity, sign
from workshop.errors import CourseError
from workshop.site.directives import notation
from workshop.symbols import lexicon
from workshop.symbols.lexicon import printed, scan, unknown

CHAPTERS = [chapter for chapter in course().chapters if course().notebook(chapter).exists()]
each_chapter = pytest.mark.parametrize("chapter", CHAPTERS)


def keys(chapter, tex):
    """The symbols in TeX, in order."""
    return [symbol.key for _, symbol, _ in scan(chapter, tex) if symbol]


@each_chapter
def test_every_printed_symbol_is_declared(chapter):
    """So it stands on the notation page, with its meaning."""
    missing = {letter: tex for tex in printed(chapter) for letter in unknown(chapter, tex)}
    assert not missing, f"declare in formulas.py of {chapter}, as `quantity` or `sign`: {missing}"


@each_chapter
def test_every_symbol_of_a_shown_formula_is_found_in_its_tex(chapter):
    for equation, computed in lexicon.shown(chapter):
        parts = (equation.left, equation.printed(computed))
        symbols = {s.key for s in lexicon.in_expressions(parts)}
        assert symbols <= set(keys(chapter, equation.latex(computed)))


def test_the_notation_page_has_a_row_for_each():
    for chapter, rows in notation().items():
        text = "\n".join(rows)
        for symbol in lexicon.printed_symbols(chapter):
            assert symbol.meaning
            several = symbol.name[-1].isdigit() or "entry" in symbol.meaning
            assert several or f"${symbol.latex}$" in text


@pytest.mark.parametrize(
    ("tex", "found"),
    [
        (r"\dot\varphi_L - \dot{\varphi}_{R}", ["rate_L", "rate_R"]),
        (r"\frac{v_{R} + v_L}{b}", ["v_R", "v_L", "b"]),
        (r"v\cos\theta\,\Delta t", ["v", "theta", "dt"]),
        (r"b^{2} + b_1 + \mathrm{b} + \dot{b}", ["b"]),  # an index or an accent: another letter
        (r"x' + x", ["x_next", "x"]),
    ],
)
def test_letters_are_found_whole(tex, found):
    assert [key.split(".")[1] for key in keys("differential_drive", tex)] == found


def test_a_letter_of_two_symbols_is_refused(monkeypatch):
    formulas = course().module("bicycle", "formulas")
    monkeypatch.setattr(formulas, "other", sign("other", "a length", "L"), raising=False)
    lexicon.symbols_of.cache_clear()
    with pytest.raises(
        CourseError, match=r"^L stands for two symbols .* bicycle: wheelbase \(.*other"
    ):
        lexicon.symbols_of("bicycle")
    lexicon.symbols_of.cache_clear()


def test_a_letter_that_is_not_declared_is_told():
    assert unknown("bicycle", r"\Xi_k + L + \sin\kappa + R^T") == [r"\Xi_k", r"\kappa", "T"]


def test_signs_have_no_range():
    declared = [s for c in CHAPTERS for s in held(course().module(c, "formulas"), NamedSymbol)]
    assert {s.is_sign for s in declared} == {True, False}
    assert not quantity("q", "m", 0, 1, "a length").is_sign
