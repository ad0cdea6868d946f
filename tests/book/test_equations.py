"""Every formula: declared well, printed as written, proved equal to its textbook form, checked."""

import re
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from declared import CHECKS, EQUATIONS, each
from mutants import mutants
from verification import (
    SAMPLES,
    call_function,
    differences,
    draw_points,
    evaluate_exactly,
    verify,
)

from courseware import equations
from courseware.course import course, get_members
from courseware.equations.declared_checks import Check, declared_checks
from courseware.equations.equation import Equation, as_written, substitute
from courseware.equations.javascript import compile_javascript
from courseware.equations.latex import render_latex
from courseware.equations.notebook import MIME
from courseware.equations.quantities import NamedSymbol, declarations
from courseware.errors import CourseError
from courseware.figures import Figure, Slider
from courseware.figures.compiler import Compiler
from courseware.site.verification_page import describe_checks, describe_function
from robokin import motion

quantity, _ = declarations(__name__)

each_equation = each("equation", "formulas", Equation)
each_check = each("check", "checks", Check)
SPEED, ARC = EQUATIONS["differential_drive.speed"], EQUATIONS["motion.arc_step"]


def quantities(chapter):
    """The symbols that a chapter's formulas and figures declare, or take from others."""
    modules = filter(None, (course().module(chapter, part) for part in ("formulas", "figures")))
    return [symbol for module in modules for symbol in get_members(module, NamedSymbol)]


def known(name):
    """A quantity of planar motion by its name."""
    return next(symbol for symbol in quantities("motion") if str(symbol) == name)


# It checks


@pytest.mark.parametrize("samples", [SAMPLES, pytest.param(1000, marks=pytest.mark.slow)])
@each_check
def test_a_formula_agrees_with_what_it_is_compared_with(check, samples):
    result = verify(check, samples)
    assert result.samples == len(check.specials) + samples
    assert result.agrees, str(result)


@each_equation
def test_a_formula_has_a_check(equation):
    chapter = equation.name.partition(".")[0]
    assert equation.name in CHECKS, f"add a Check of {equation.name} to book/{chapter}/checks.py"


def test_a_disagreement_is_found_and_described():
    right = CHECKS["differential_drive.speed"]
    wrong = replace(right, equation=replace(SPEED, right=SPEED.right + sp.Float("1e-14")))
    assert verify(right).agrees
    result = verify(wrong)
    assert not result.agrees
    assert re.fullmatch(
        r"differential_drive.speed and its function are 1e-14 apart, allowed 1e-15, "
        r"at b = [\d.]+, r = [\d.]+, v_L = -?[\d.]+, v_R = -?[\d.]+",
        str(result),
    )


def test_a_wrong_special_point_is_found():
    """Only at the special point: the generated points alone would not notice."""
    right = CHECKS["motion.icr"]

    def finite_when_straight(pose, v, omega):
        return np.nan_to_num(motion.icr(pose, v, omega), posinf=1e9)

    wrong = replace(right, function=finite_when_straight)
    assert not verify(wrong).agrees
    assert verify(replace(wrong, specials=())).agrees


# What is no mistake at all, although a sign has changed; half turns are proved to be none.
SAME = {
    "component 0: counter_span/2 of counter_span/2 + (-count_before + count_now) negated": "half a "
    "span more and half a span less are a whole span apart, which the remainder does not see"
}


@pytest.mark.parametrize("most", [5, pytest.param(None, marks=pytest.mark.slow)])
@each_check
def test_a_wrong_sign_is_noticed(check, most):
    """Every formula with a sign turned, or a sine for a cosine, at the special points and 20."""
    changed = mutants(check.equation, most)
    assert changed, f"{check.name} has no sign and no sine to turn"
    unnoticed = [
        what for what, mutant in changed if what not in SAME and not notices(check, mutant)
    ]
    assert not unnoticed, (
        f"the check of {check.name} does not notice {unnoticed}: give it `specials` or `ranges` "
        "where that matters"
    )


def notices(check, mutant):
    """Whether a check fails for a mutant, or the mutant is the same angle."""
    points = draw_points(check, 20)
    try:
        exact = evaluate_exactly(mutant.right, check.symbols, points, mutant.where)
    except (AssertionError, AttributeError, TypeError):  # a pole, or no real number
        return True
    apart = differences(call_function(check, points), exact, mutant.is_angle)
    return apart.max() > check.tolerance or whole_turns(check.equation, mutant)


def whole_turns(equation, mutant):
    """Whether two columns of angles are proved to be the same directions."""
    apart = (sp.Matrix([mutant.right]) - sp.Matrix([equation.right])) / (2 * sp.pi)
    return equation.is_angle and all(sp.simplify(turns).is_integer for turns in apart)


# The page of checks


def test_the_page_names_what_computes():
    """A function as it is, or the library's functions in the few lines that adapt them."""
    named = {
        "motion.icr": "`robokin.motion.icr`",
        "basics.direction": "`numpy.arctan2`",
        "euler.turn_x": "`robokin.euler.to_matrix`",
        "bicycle.world": "`robokin.motion.to_world` and `robokin.bicycle.body_twist` "
        "(*The velocity of the rear axle's middle in the world*)",
        "planar_arm.command": "*The wanted twist, and what is missing of the pose times the gain, "
        "by NumPy*",
    }
    assert {name: describe_function(CHECKS[name]) for name in named} == named


def test_the_page_has_every_formula_with_its_tolerance():
    text = "\n".join(describe_checks(declared_checks()))
    assert re.findall(r"^`(.*)` is compared", text, re.MULTILINE) == list(EQUATIONS)
    reason = CHECKS["motion.icr"].reason
    assert re.search(rf"`motion.icr` is .*: at most \d.·.10{{sup}}`−\d+` apart \({reason}", text)


# Its textbook form


@each_equation
def test_textbook_form_is_proved_equal(equation):
    if equation.textbook is None:
        return
    written_out = sp.Matrix([equation.right]).applyfunc(_first_case).replace(sp.sinc, _sinc)
    textbook = sp.Matrix([equation.textbook.doit()])
    assert sp.simplify(written_out - textbook) == sp.zeros(*textbook.shape)


def test_special_points_are_limits():
    """The arc at omega = 0 is the limit of the textbook's form, not a convention."""
    omega = known("omega")
    limit = ARC.textbook.limit(omega, 0)
    there = ARC.right.subs(omega, 0).doit()
    assert sp.simplify(limit - there) == sp.zeros(3, 1)


def _first_case(entry):
    """The ordinary case of an expression: special points are in later cases."""
    return entry.replace(lambda e: isinstance(e, sp.Piecewise), lambda e: e.args[0][0])


def _sinc(x):
    return sp.sin(x) / x


# It prints


def test_prints_in_the_order_written():
    assert render_latex(SPEED.right) == r"\frac{v_{R} + v_{L}}{2}"
    assert (
        render_latex(EQUATIONS["differential_drive.turning_rate"].right)
        == r"\frac{v_{R} - v_{L}}{b}"
    )


def test_a_sum_has_the_parentheses_that_are_typed():
    a, b, c = sp.symbols("a b c")
    with as_written():
        assert render_latex(c - a + b) == "c - a + b"
        assert render_latex(c + (a - b)) == r"c + \left(a - b\right)"
        assert "[c[2] - c[0] + c[1]]" in compile_javascript({"c": (a, b, c)}, [c - a + b])
        assert "[c[2] + (c[0] - c[1])]" in compile_javascript({"c": (a, b, c)}, [c + (a - b)])


def test_a_column_prints_one_line_a_component():
    text = ARC.latex()
    assert text.count("&=") == 3
    assert "sinc" not in text
    assert "sinc" in ARC.latex(computed=True)


def test_show_gives_notebook_and_page_their_forms():
    data = equations.show("motion.arc_step")._repr_mimebundle_()
    assert data[MIME] == {"name": "motion.arc_step", "computed": False}
    assert data["text/latex"].endswith(r"\tag{motion.arc\_step} $$")
    assert data["text/plain"].startswith("[x_next, y_next, ")
    computed = equations.show("motion.arc_step", computed=True)._repr_mimebundle_()
    assert computed[MIME] == {"name": "motion.arc_step", "computed": True}


# It is declared well


@each_equation
def test_declaration(equation):
    module, _, _ = equation.name.partition(".")
    assert module in course().chapters, (
        f"name {equation.name} after its chapter's folder, as in bicycle.speed: {module} is none"
    )


@each_check
def test_a_tolerance_is_small_and_has_its_reason(check):
    assert check.reason
    assert 0 < check.tolerance < 1e-9, (
        f"{check.name} has the tolerance {check.tolerance:.1g}, allowed below 1e-9: roundings are "
        "some 1e-15, more is a mistake or another formula"
    )


each_chapter = pytest.mark.parametrize("chapter", course().chapters)


@each_chapter
def test_quantities_are_described(chapter):
    for symbol in quantities(chapter):
        assert symbol.meaning, f"{symbol.module}: say what {symbol} is, as `meaning`"
        assert not symbol.has_range or symbol.low < symbol.high, (
            f"{symbol.module}: {symbol} ranges from {symbol.low} to {symbol.high}: swap them"
        )


@each_chapter
def test_a_module_declares_a_symbol_once(chapter):
    found = {}
    for symbol in quantities(chapter):
        first = found.setdefault(symbol, symbol)
        assert first is symbol, f"{symbol} is declared twice: {first.module} and {symbol.module}"


def test_declaring_half_is_refused():
    with pytest.raises(CourseError, match=r"test.unknown uses unheard_of, which no `quantity"):
        replace(SPEED, name="test.unknown", right=sp.Symbol("unheard_of"))


# A symbol belongs to the module that declares it


def test_two_symbols_of_one_name_are_told_apart():
    """The message says where both are."""
    x = known("x")
    other = quantity(str(x), "m", 0, 1, "another one")
    assert other != x
    assert len({x, other}) == 2
    with pytest.raises(CourseError, match=r"x: book.* and tests.*; use"):
        replace(ARC, name="test.namesakes", right=x + other)
    drive = CHECKS["differential_drive.speed"]
    left = quantity("v_L", "m/s", 0, 1, "another one")
    with pytest.raises(CourseError, match=r"check of .* symbols v_L: book.* and tests.*; use"):
        replace(drive, arguments=(*drive.arguments, left))


def test_a_figure_tells_its_slider_from_a_namesake():
    x, other = known("x"), quantity("x", "m", 0, 1, "another one")
    figure = Compiler(Figure("f", "", (0, 1, 0, 1), (), (Slider(x, 0, 1, 0, 0.1),)), "")
    figure.add(2 * other)
    with pytest.raises(CourseError, match=r"uses x \(tests.*\), .* only x \(book"):
        figure.compile_figure()
    with pytest.raises(ValueError, match="x is not in list"):
        figure.find_sliders([other])


def test_sympy_keeps_symbols_of_one_name_apart():
    """Also where it makes symbols of its own on the way, or keeps answers for equal questions."""
    x, other = known("x"), quantity("x", "m", 0, 1, "another one", latex="z")
    both = sp.sin(x) * other / x
    assert both.xreplace({x: other}) == sp.sin(other)
    assert both.subs(x, 0.5).free_symbols == {other}
    assert both.limit(x, 0) == other
    assert sp.simplify(sp.sin(x) ** 2 + sp.cos(x) ** 2) == 1
    assert sp.simplify(sp.sin(x) ** 2 + sp.cos(other) ** 2) != 1
    assert sp.latex(both) == r"\frac{z \sin{\left(x \right)}}{x}"
    assert sp.lambdify([x], x**2)(3) == 9
    np.testing.assert_array_equal(sp.lambdify([other], sp.Matrix([other, 1]))(2), [[2], [1]])


def test_a_pole_is_told_with_its_place():
    x = sp.Symbol("x")
    with pytest.raises(AssertionError, match=r"1/x divides by zero at x = 0: .*Piecewise"):
        evaluate_exactly(1 / x, [x], np.array([[1.0], [0.0]]))


def test_a_symbol_has_a_key_and_a_look(monkeypatch):
    """The look that its user gives it goes before that of its own chapter."""
    dt = known("dt")
    assert dt.key == "motion.dt"
    assert equations.find_kind(dt) == ""
    formulas = course().modules("formulas")
    monkeypatch.setattr(formulas["motion"], "LOOKS", {dt: "path"}, raising=False)
    monkeypatch.setattr(formulas["odometry"], "LOOKS", {dt: "left"}, raising=False)
    assert [equations.find_kind(dt, c) for c in ("", "bicycle", "odometry")] == [
        "path",
        "path",
        "left",
    ]
    formulas["motion"].LOOKS[dt] = "purple"
    with pytest.raises(CourseError, match="no kind 'purple'; there are left,"):
        equations.find_kind(dt)


def test_putting_in_leaves_the_form_alone():
    left, right = SPEED.symbols
    assert render_latex(SPEED.substitute({right: left})) == r"\frac{v_{L} + v_{L}}{2}"
    difference = substitute(left - right, {right: 0})
    assert not difference.atoms(sp.Mul)  # SymPy contradicts itself about −1·0


# Named steps


def test_where_names_steps_for_all_faces():
    theta, c, s = known("theta"), sp.Symbol("c"), sp.Symbol("s")
    where = ((c, sp.cos(theta)), (s, 2 * c))
    with as_written():
        equation = Equation("test.where", sp.Symbol("z"), c + s, where=where)
    assert equation.symbols == [theta]
    check = Check(
        equation,
        function=lambda theta: 3 * np.cos(theta),
        arguments=(theta,),
        tolerance=1e-15,
        reason="test",
    )
    assert verify(check).agrees
    assert evaluate_exactly(c + s, [theta], np.array([[0.0]]), where)[0, 0] == 3
    code = compile_javascript({"x": [theta]}, [c + s], where)
    assert code == "(f, x) => { const t0 = Math.cos(x[0]); const t1 = 2*t0; return [t0 + t1]; }"
