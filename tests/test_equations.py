"""Every formula: declared well, printed as written, proved equal to its textbook form, checked."""

import ast
import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from declared import EQUATIONS, each

from robokin import motion
from workshop import equations
from workshop.course import course
from workshop.equations.checking import check_one, evaluate, sample
from workshop.equations.core import Equation, as_written, quantities, quantity
from workshop.equations.printing import MIME, equation_latex, latex
from workshop.errors import CourseError
from workshop.figures.javascript import function
from workshop.site import checked

ALL = list(EQUATIONS.values())
BOOK = Path(__file__).parents[1] / "book"
each_equation = each("equation", "formulas", Equation)


def named(equation):
    return equation.name


def copy_of(equation, **changes):
    """An equation that differs in a few fields."""
    return replace(equation, name="test.copy", **changes)


# It checks


@each_equation
def test_equation_agrees_with_its_function(equation):
    if equation.function is None:
        file, _, test = equation.checked_by.partition("::")
        tree = ast.parse(next(BOOK.glob(f"*/{Path(file).name}")).read_text(encoding="utf-8"))
        assert test in {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
        return
    result = check_one(equation)
    assert result.samples >= 1000
    assert result.agrees, f"apart by {result.difference:.2g} at {result.worst}"


def test_check_covers_all_that_have_a_function():
    results = equations.check(samples=1)
    assert {r.equation.name for r in results} == {e.name for e in ALL if e.function}


def test_a_wrong_equation_is_found():
    right = EQUATIONS["differential_drive.speed"]
    wrong = copy_of(right, right=right.right + sp.Float("1e-14"))
    assert check_one(right).agrees
    assert not check_one(wrong).agrees


def test_a_wrong_function_is_found():
    right = EQUATIONS["motion.arc_step"]
    wrong = copy_of(right, function=lambda *given: motion.arc_step(*given) * (1 + 1e-14))
    assert not check_one(wrong).agrees


def test_a_wrong_special_point_is_found():
    """Only at the special point: the generated points alone would not notice."""
    right = EQUATIONS["motion.icr"]

    def finite_when_straight(pose, v, omega):
        return np.nan_to_num(motion.icr(pose, v, omega), posinf=1e9)

    wrong = copy_of(right, function=finite_when_straight)
    assert not check_one(wrong).agrees
    assert check_one(copy_of(wrong, specials=())).agrees


def test_a_disagreement_fails_the_page(tmp_path, monkeypatch):
    right = EQUATIONS["differential_drive.speed"]
    wrong = copy_of(right, right=right.right * 2)
    monkeypatch.setattr("workshop.equations.checking.declared", lambda: {"wrong": wrong})
    with pytest.raises(Exception, match=r"disagree:\ntest\.copy by .*, allowed 1e-15, at b = "):
        checked(tmp_path)


def test_the_page_keeps_its_result_until_a_source_changes(tmp_path, monkeypatch):
    first = checked(tmp_path)
    (kept,) = tmp_path.glob("*.json")
    assert json.loads(kept.read_text(encoding="utf-8")) == first
    monkeypatch.setattr("workshop.equations.check", lambda: pytest.fail("checked again"))
    assert checked(tmp_path) == first
    kept.rename(tmp_path / "formula-checks-of-other-sources.json")
    with pytest.raises(pytest.fail.Exception, match="checked again"):
        checked(tmp_path)


def test_a_function_with_too_few_components_is_refused():
    right = EQUATIONS["motion.arc_step"]
    with pytest.raises(CourseError, match="3 components, its function 2"):
        check_one(copy_of(right, function=lambda *a: motion.arc_step(*a)[..., :2]))


def test_samples_lie_in_the_ranges_and_repeat():
    equation = EQUATIONS["motion.icr"]
    points = sample(equation, 50)
    np.testing.assert_array_equal(points, sample(equation, 50))
    generated = points[len(equation.specials) :, list(map(str, equation.symbols)).index("omega")]
    assert (generated > 0.1).all()
    assert (generated < 6).all()


# Its textbook form


@pytest.mark.parametrize("equation", [e for e in ALL if e.textbook is not None], ids=named)
def test_textbook_form_is_proved_equal(equation):
    written_out = sp.Matrix([equation.right]).applyfunc(_first_case).replace(sp.sinc, _sinc)
    textbook = sp.Matrix([equation.textbook.doit()])
    assert sp.simplify(written_out - textbook) == sp.zeros(*textbook.shape)


def test_a_wrong_textbook_form_is_not_proved():
    equation = EQUATIONS["motion.arc_step"]
    wrong = copy_of(equation, textbook=equation.textbook.applyfunc(lambda row: -row))
    with pytest.raises(AssertionError):
        test_textbook_form_is_proved_equal(wrong)


def test_special_points_are_limits():
    """The arc at omega = 0 is the limit of the textbook's form, not a convention."""
    equation = EQUATIONS["motion.arc_step"]
    omega = next(s for s in equation.symbols if str(s) == "omega")
    limit = equation.textbook.limit(omega, 0)
    there = equation.right.subs(omega, 0).doit()
    assert sp.simplify(limit - there) == sp.zeros(3, 1)


def _first_case(entry):
    """The ordinary case of an expression: special points stand in later cases."""
    return entry.replace(lambda e: isinstance(e, sp.Piecewise), lambda e: e.args[0][0])


def _sinc(x):
    return sp.sin(x) / x


# It prints


def test_prints_in_the_order_written():
    assert latex(EQUATIONS["differential_drive.speed"].right) == r"\frac{v_{R} + v_{L}}{2}"
    assert latex(EQUATIONS["differential_drive.turning_rate"].right) == r"\frac{v_{R} - v_{L}}{b}"


def test_sympy_shows_the_same_symbols():
    dt = EQUATIONS["motion.arc_step"].symbols[0]
    assert str(dt) == "dt"
    assert sp.latex(dt**2) == r"\Delta t^{2}"


def test_a_column_prints_one_line_a_component():
    text = equation_latex(EQUATIONS["motion.arc_step"])
    assert text.count("&=") == 3
    assert "sinc" not in text
    assert "sinc" in equation_latex(EQUATIONS["motion.arc_step"], computed=True)


def test_show_gives_notebook_and_page_their_forms():
    data = equations.show("motion.arc_step")._repr_mimebundle_()
    assert data[MIME]["label"] == "motion.arc_step"
    assert data["text/latex"].endswith(r"\tag{motion.arc\_step} $$")
    assert data["text/plain"].startswith("[x', y', ")
    computed = equations.show("motion.arc_step", computed=True)._repr_mimebundle_()
    assert computed[MIME]["label"] == "motion.arc_step-computed"


def test_an_unknown_name_is_refused():
    with pytest.raises(CourseError, match=r"no equation 'motion.arc'; there are .*motion.arc_step"):
        equations.show("motion.arc")


# It is declared well


@each_equation
def test_declaration(equation):
    module, _, _ = equation.name.partition(".")
    assert module in course().chapters, "an equation is named after its chapter"
    assert equation.source
    assert equation.reason
    assert 0 < equation.tolerance < 1e-9
    for special in equation.specials:
        assert set(special) <= set(equation.symbols), "a special point names a symbol not used"


def test_quantities_are_described():
    for symbol in quantities():
        assert symbol.meaning, symbol
        assert symbol.low < symbol.high, symbol


def test_declaring_half_is_refused():
    speed = EQUATIONS["differential_drive.speed"]
    with pytest.raises(CourseError, match="must name a function or a test"):
        replace(speed, name="test.half", function=None)
    with pytest.raises(CourseError, match=r"test.unknown uses unheard_of, which no `quantity"):
        replace(speed, name="test.unknown", right=sp.Symbol("unheard_of"))
    x = next(s for s in quantities() if str(s) == "x")
    with pytest.raises(CourseError, match="x in `right`, but not in its arguments"):
        replace(speed, name="test.unsupplied", right=speed.right + x)
    with pytest.raises(CourseError, match="x in `specials`, but not in its right nor arguments"):
        replace(speed, name="test.special", specials=({x: 0.0},))


def test_two_symbols_of_one_name_are_told_apart():
    """The message says where both stand."""
    x = EQUATIONS["motion.arc_step"].symbols[-1]
    other = quantity(str(x), "m", 0, 1, "another one")
    assert other != x
    with pytest.raises(CourseError, match=r"symbols \w+: .*line \d+ and .*line \d+; use one"):
        replace(EQUATIONS["motion.arc_step"], name="test.namesakes", right=x + other)


def test_a_pole_is_told_with_its_place():
    x = sp.Symbol("x")
    with pytest.raises(CourseError, match=r"1/x divides by zero at x = 0: .*Piecewise"):
        evaluate(1 / x, [x], np.array([[1.0], [0.0]]))


def test_putting_in_leaves_the_form_alone():
    speed = EQUATIONS["differential_drive.speed"]
    left, right = speed.symbols[2:]
    assert latex(speed.at({right: left})) == r"\frac{v_{L} + v_{L}}{2}"


# Named steps


def test_where_names_steps_for_all_faces():
    theta, c, s = next(q for q in quantities() if str(q) == "theta"), sp.Symbol("c"), sp.Symbol("s")
    where = ((c, sp.cos(theta)), (s, 2 * c))
    with as_written():
        equation = Equation(
            name="test.where",
            left=sp.Symbol("z"),
            right=c + s,
            where=where,
            source="test",
            tolerance=1e-15,
            reason="test",
            function=lambda theta: 3 * np.cos(theta),
            arguments=(theta,),
        )
    assert equation.symbols == [theta]
    assert check_one(equation).agrees
    assert evaluate(c + s, [theta], np.array([[0.0]]), where)[0, 0] == 3
    code = function({"x": [theta]}, [c + s], where)
    assert code == "(f, x) => { const w0 = Math.cos(x[0]); const w1 = 2*w0; return [w0 + w1]; }"


# It stays out of the way


def test_the_library_does_not_import_sympy():
    code = "import robokin, sys; print(*(m for m in sys.modules if m in {'sympy', 'matplotlib'}))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == ""
