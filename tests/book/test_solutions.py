"""Worked solutions: they lead to what the library says, and every formula in them counts."""

import re
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from declared import each, typed

from courseware.equations import Equation, declarations
from courseware.equations.text import split_sign
from courseware.errors import CourseError
from courseware.practice import (
    Exercise,
    LocalEquation,
    Solution,
    Step,
    candidates,
    judging,
    variants,
)
from courseware.practice.solution_steps import format_result, solve_step, step_form
from courseware.units.formatting import format_number

quantity, _ = declarations(__name__)

each_exercise = each("exercise", "exercises", Exercise)
EXACT = 1e-9  # of the value or of 1: two ways to compute the same, a few dozen roundings apart


def rows_of(exercise, solution, variant):
    """What the steps that give the answer say: rows of the numbers asked for."""
    numbers = {**variant.numbers, **exercise.derive(**variant.numbers)}
    steps = solution.solve(numbers)
    return np.array([row_of(steps, names) for names in solution.answer])


def row_of(steps, names):
    """One row of the answer: what a step gives, or several together; numbers stay as they are."""
    names = (names,) if isinstance(names, str) else names
    parts = [np.ravel(steps[n].results[n]) if isinstance(n, str) else [float(n)] for n in names]
    return np.concatenate(parts)


def off(exercise, row, other):
    """How far two rows are apart, angles on the circle, in parts of the value."""
    apart = [
        candidates.distance(ask, x, y) / max(1.0, abs(y))
        for ask, x, y in zip(exercise.unknowns, row, other, strict=True)
    ]
    return np.max(apart)  # NaN if one is, which `max` may leave out


def leads_to_the_answer(exercise, solution, variant):
    """Whether each row is a right one; all of them, where all are asked."""
    found = rows_of(exercise, solution, variant)
    right = exercise.evaluate(exercise.right, variant.numbers)
    near = np.array([[off(exercise, row, other) <= EXACT for other in right] for row in found])
    return near.any(axis=1).all() and (exercise.accept != "all" or near.any(axis=0).all())


@each_exercise
def test_a_solution_leads_to_the_library_s_answer(exercise):
    for variant in variants.all_variants(exercise.name):
        assert leads_to_the_answer(exercise, exercise.solution, variant), (
            f"the solution of {exercise.name} ends elsewhere than `right`, with {variant.numbers}"
        )


def as_printed(value):
    """A number, vector or matrix as a solution prints it."""
    if isinstance(value, str):
        return value
    texts = (
        [format_number(x) for x in np.ravel(value)] if np.ndim(value) else [format_result(value)]
    )
    return np.reshape([float(text.replace("\u2212", "-")) for text in texts], np.shape(value))[()]


def reckoned(exercise, variant):
    """Rows of the answer for somebody who goes on with each number as it is printed."""
    found = {}
    known = {k: as_printed(v) for k, v in exercise.derive(**variant.numbers).items()}
    known |= variant.numbers
    for name, step in exercise.solution.steps.items():
        found[name] = solve_step(name, step, known, {})
        known |= {key: as_printed(value) for key, value in found[name].results.items()}
    rows = [list(map(as_printed, row_of(found, names))) for names in exercise.solution.answer]
    return rows if exercise.accept == "all" else rows[:1]


@each_exercise
def test_reckoning_with_the_printed_numbers_is_right(exercise):
    dealt = variants.all_variants(exercise.name)
    answers = [(k, typed(reckoned(exercise, v), exercise)) for k, v in enumerate(dealt)]
    verdicts = judging.judge_all(exercise, [v.candidates for v in dealt], answers)
    off = [
        v.numbers for v, verdict in zip(dealt, verdicts, strict=True) if verdict.result != "right"
    ]
    assert not off, (
        f"who goes on with the printed numbers of {exercise.name} is further off than its "
        f"tolerance: print fewer steps, or allow more in its Unknown; with {off[:3]}"
    )


@each_exercise
def test_what_is_said_beside_the_way_is_right(exercise):
    for variant in variants.all_variants(exercise.name):
        wrong = wrong_beside(exercise, exercise.solution, variant)
        assert not wrong, (
            f"the steps {wrong} do not give what their `expected` says: {variant.numbers}"
        )


def wrong_beside(exercise, solution, variant):
    """The steps that do not give what their check says."""
    numbers = {**variant.numbers, **exercise.derive(**variant.numbers)}
    steps = solution.solve(numbers)
    checks = {name: step.expected for name, step in solution.steps.items() if step.expected}
    wanted = {name: np.ravel(check(**variant.numbers)) for name, check in checks.items()}
    return [
        name
        for name in checks
        if not np.allclose(np.ravel(steps[name].results[name]), wanted[name], EXACT, EXACT)
    ]


def flips(expression):
    """The expression with one sign flipped: of the second term of each sum, else of the whole.

    And a product of matrices in another order, or without one of its transposes and inverses.
    """
    if isinstance(expression, sp.MatrixExpr):
        yield from misread(expression)
    sums = [e for e in sp.preorder_traversal(expression) if isinstance(e, sp.Add)]
    for one in dict.fromkeys(sums):
        first, *rest = one.args
        with sp.evaluate(False):
            wrong = expression.xreplace({one: sp.Add(first, negated(rest[0]), *rest[1:])})
        yield wrong  # not above, where the caller would run without evaluation, too
    if not sums:
        yield negated(expression)


def misread(expression):
    """What becomes of products of matrices that are read wrongly, where the shapes still fit."""
    for part in dict.fromkeys(sp.preorder_traversal(expression)):
        wrong = []
        if isinstance(part, sp.Transpose | sp.Inverse):
            wrong = [part.arg]
        if isinstance(part, sp.MatMul):
            pairs = enumerate(pairwise(part.args))
            wrong = [(*part.args[:k], b, a, *part.args[k + 2 :]) for k, (a, b) in pairs]
        for other in wrong:
            with suppress(sp.matrices.exceptions.ShapeError):
                with sp.evaluate(False):
                    whole = sp.MatMul(*other) if isinstance(other, tuple) else other
                    misreading = expression.xreplace({part: whole})
                yield misreading


def negated(e):
    """An expression with the other sign, otherwise as written."""
    sign, rest = split_sign(e)
    if sign < 0:
        return rest
    if isinstance(e, sp.MatrixExpr):
        return sp.MatMul(-1, *sp.MatMul.make_args(e))
    return sp.Mul(-1, rest, evaluate=bool(rest.is_Number))


def flipped(step, known):
    """The same step with a sign wrong: one for each place."""
    ready = step_form(step, known)
    left, full, unit = ready.left, ready.full, ready.units
    columns = list(full) if isinstance(full, sp.MatrixBase) else [full]
    for place, component in enumerate(columns):
        for wrong in flips(component):
            if wrong == component:
                continue  # zero has no sign
            if isinstance(full, sp.MatrixBase):
                changed = sp.Matrix(*full.shape, [*columns[:place], wrong, *columns[place + 1 :]])
            else:
                changed = wrong
            named = {s: v for s, v in step.given.items() if isinstance(v, str)}
            yield replace(step, formula=LocalEquation(left, changed, unit), given=named, part=())


@each_exercise
def test_a_wrong_sign_in_any_step_is_found(exercise):
    """The answer is another one then, or a step beside the way differs from its check.

    What gives the same for all variants is not wrong if it is another order of matrices, or if the
    formula is a declared one: its own test finds the sign of a cosine that is zero here. And an
    angle may be off by whole turns.
    """
    for name, step in exercise.solution.steps.items():
        for group in of_one_formula(exercise, name):
            known = known_at(exercise, name, group[0])
            is_declared = isinstance(step.formula_for(known), Equation)
            for wrong in flipped(step, known):
                steps = {**exercise.solution.steps, name: wrong}
                solution = Solution(exercise.solution.text, exercise.solution.answer, **steps)
                may_agree = is_declared or isinstance(wrong.formula.right, sp.MatrixExpr)
                harmless = agrees if may_agree else only_turns
                noticed = any(notices(exercise, solution, variant) for variant in group)
                assert noticed or all(harmless(exercise, solution, name, v) for v in group), (
                    f"{name}: nothing notices that {wrong.formula.left} = {wrong.formula.right}; "
                    "let the answer depend on it, or give the step what is `expected`"
                )


def agrees(exercise, other, name, variant):
    """Whether a step gives the same in another solution, up to whole turns of angles."""
    numbers = {**variant.numbers, **exercise.derive(**variant.numbers)}
    both = [s.solve(numbers)[name].results[name] for s in (other, exercise.solution)]
    return np.allclose(*both, EXACT, EXACT) or only_turns(exercise, other, name, variant)


def of_one_formula(exercise, name):
    """The variants, in a group for each formula that a step has."""
    every, step = variants.all_variants(exercise.name), exercise.solution.steps[name]
    if isinstance(step.formula, Equation | LocalEquation):
        return [every]
    kinds = {}
    for variant in every:
        formula = step.formula_for(known_at(exercise, name, variant))
        kinds.setdefault(f"{formula.left} = {formula.right}", []).append(variant)
    return list(kinds.values())


def known_at(exercise, name, variant):
    """The numbers that a step can use."""
    known = {**variant.numbers, **exercise.derive(**variant.numbers)}
    for other, done in exercise.solution.solve(known).items():
        if other == name:
            return known
        known |= done.results
    raise AssertionError(name)


def notices(exercise, solution, variant):
    """Whether a wrong step shows with these numbers."""
    with np.errstate(all="ignore"):
        right = leads_to_the_answer(exercise, solution, variant)
        return not right or bool(wrong_beside(exercise, solution, variant))


def only_turns(exercise, other, name, variant):
    """Whether a step gives angles, and they are off by whole turns: θ − π is as right as θ + π."""
    numbers = {**variant.numbers, **exercise.derive(**variant.numbers)}
    both = [s.solve(numbers)[name] for s in (other, exercise.solution)]
    turns = np.subtract(*(step.results[name] for step in both)) / (2 * np.pi)
    angles = {line.unit for line in both[1].lines} == {"rad"}
    return angles and np.abs(turns - np.round(turns)).max() <= EXACT


# Nothing is typed


@each_exercise
def test_no_formula_or_number_is_typed_in_a_solution(exercise):
    """An equals sign followed by what is no placeholder, or a number with a decimal point."""
    text = exercise.solution.text
    typed_in = re.findall(r"=\s*[^\s{]+|\d+\.\d+", text)
    assert not typed_in, f"{typed_in} is typed: put a step's `{{name}}` there, in: {text}"


@each_exercise
def test_every_step_is_shown(exercise):
    text = exercise.solution.text
    for name in exercise.solution.steps:
        shown = re.search(rf"{{{name}[.}}]", text)
        assert shown, f"put {{{name}}} into the text of the solution of {exercise.name}: {text}"


# The language itself

a, b = sp.symbols("a b")
GIVEN = {"a": 3.0, "b": -0.5}


def print_solution(solution, shown=None):
    """A solution's text with `GIVEN` in it."""
    steps = solution.solve(GIVEN, shown or {})

    def put(match):
        name, _, spec = match[1].partition(":")
        step, _, part = name.partition(".")
        return steps[step].format(part, spec)

    return re.sub(r"{([\w.:]+)}", put, solution.text)


def test_a_step_is_told_with_letters_numbers_and_result():
    with sp.evaluate(False):
        solution = Solution("So {c}.", c=Step(LocalEquation(sp.Symbol("c"), (a - b) / 2, "m")))
    assert print_solution(solution) == "So c = (a − b)/2 = (3 − (−0.5))/2 = 1.75 m."


def test_degrees_stand_only_inside_functions_of_an_angle():
    with sp.evaluate(False):
        solution = Solution("{c}", c=Step(LocalEquation(sp.Symbol("c"), a * sp.cos(b) + b)))
    assert (
        print_solution(solution, {"b": "−28.6°"})
        == "c = a cos b + b = 3 cos(−28.6°) + (−0.5) = 2.1327"
    )


def test_a_column_is_told_line_by_line_and_named():
    pair = LocalEquation(sp.Matrix(sp.symbols("x y")), sp.Matrix([a + b, a]))
    double = LocalEquation(sp.Symbol("q"), sp.Symbol("x") * 2)
    solution = Solution("{p}\n\n{q}", p=Step(pair), q=Step(double))
    assert (
        print_solution(solution)
        == "x = a + b = 3 + (−0.5) = 2.5\n\ny = a = 3\n\nq = 2 x = 2 · 2.5 = 5"
    )


def test_a_named_step_on_the_way_is_taken_from_an_earlier_step():
    """Else its expression is put in, and no numbers are shown."""
    length, C = quantity("a", "m", 0, 1, "a length"), sp.Symbol("C")
    declared = Equation("test.e", sp.Symbol("E"), 2 * C, "here", where=((C, 3 * length),))
    e, c = Step(declared), Step(LocalEquation(C, a - b))
    assert print_solution(Solution("{e}", e=e)) == "E = 2 C = 18"
    assert print_solution(Solution("{c}\n\n{e}", c=c, e=e)).endswith("\n\nE = 2 C = 2 · 3.5 = 7")
    assert print_solution(Solution("{e}", e=Step(declared, {C: b}))) == "E = 2 b = 2 · (−0.5) = −1"


def test_a_step_can_give_its_result_other_letters():
    c = Step(LocalEquation(sp.Symbol("c"), a + b), values=(sp.Symbol("c'"),))
    assert print_solution(Solution("{c}", c=c)) == "c′ = a + b = 3 + (−0.5) = 2.5"
    pair = LocalEquation(sp.Matrix(sp.symbols("x y")), sp.Matrix([a + b, a]))
    p = Step(pair, values=sp.symbols("u v"))
    assert print_solution(Solution("{p}", p=p)) == "u = a + b = 3 + (−0.5) = 2.5\n\nv = a = 3"


def test_an_answer_can_come_from_several_steps():
    c, d = Step(LocalEquation(sp.Symbol("c"), a + b)), Step(LocalEquation(sp.Symbol("d"), a - b))
    solution = Solution("{c}{d}", answer=(("c", "d"), (0, "c"), "d"), c=c, d=d)
    steps = solution.solve(GIVEN)
    rows = [row_of(steps, names).tolist() for names in solution.answer]
    assert rows == [[2.5, 3.5], [0.0, 2.5], [3.5]]


def test_each_line_of_a_column_has_its_unit():
    speed, rate = quantity("v", "m/s", -1, 1, "speed"), quantity("w", "rad/s", -1, 1, "rate")
    with sp.evaluate(False):
        both = LocalEquation(sp.Matrix([speed, rate]), sp.Matrix([2 * a, b + a]))
    assert print_solution(Solution("{p}", p=Step(both))) == (
        "v = 2 a = 2 · 3 = 6 m/s\n\nw = b + a = −0.5 + 3 = 2.5 rad/s"
    )
    solution = Solution("{p}; {p.value}", p=Step(both, unit=("m", "rad")))
    assert print_solution(solution) == (
        "v = 2 a = 2 · 3 = 6 m\n\nw = b + a = −0.5 + 3 = 2.5 rad; [6, 2.5]"
    )


def test_numbers_that_stand_in_a_formula_are_not_said_twice():
    solution = Solution("{c}", c=Step(LocalEquation(sp.Symbol("c"), sp.Pow(2, 4, evaluate=False))))
    assert print_solution(solution) == "c = 2^4 = 16"
    c, d = (Step(LocalEquation(sp.Symbol("c"), -number, "m")) for number in (a, b))
    assert (
        print_solution(Solution("{c}; {d}", c=c, d=d)) == "c = −a = −3 m; c = −b = −(−0.5) = 0.5 m"
    )


def test_small_numbers_keep_five_digits():
    with sp.evaluate(False):
        c = Step(LocalEquation(sp.Symbol("c"), a / 700, "m"))
        d = Step(LocalEquation(sp.Symbol("d"), 100 * sp.Symbol("c")))
    solution = Solution("{c}, {c.value:deg}, {d}", c=c, d=d)
    assert (
        print_solution(solution)
        == "c = a/700 = 3/700 = 0.0042857 m, 0.2°, d = 100 c = 100 · 0.0042857 = 0.42857"
    )
    assert [format_result(x) for x in (0.002, -0.00012345, 1e-17, -0.25)] == [
        "0.002",
        "−0.00012345",
        "0",
        "−0.25",
    ]


P, Q, R = (sp.MatrixSymbol(name, 2, 2) for name in "PQR")
GIVEN |= {"P": np.array([[0.0, -1.0], [1.0, 0.0]]), "Q": np.array([[1.0, 2.0], [0.0, 1.0]])}


def test_a_matrix_is_one_letter_and_can_name_its_entries():
    product = Step(LocalEquation(R, P.T * Q), values=("r_11", "r_12", "r_21", "r_22"))
    entry = Step(LocalEquation(sp.Symbol("c"), sp.Symbol("r_12") * 3))
    column = Step(LocalEquation(sp.MatrixSymbol("p", 2, 1), -R.inv() * sp.Matrix([3, b])))
    solution = Solution("{R}\n\n{c}\n\n{p}", R=product, c=entry, p=column)
    assert print_solution(solution).split("\n\n") == [
        "R = Pᵀ Q = [[0, −1], [1, 0]]ᵀ [[1, 2], [0, 1]] = [[0, 1], [−1, −2]]",
        "c = 3 r_12 = 3 · 1 = 3",
        "p = −R⁻¹ [3, b] = −[[0, 1], [−1, −2]]⁻¹ [3, −0.5] = [5.5, −3]",
    ]


def test_a_step_can_be_told_by_its_formula_alone():
    solution = Solution("{c.formula}: {c.value}", c=Step(LocalEquation(sp.Symbol("c"), a + b)))
    assert print_solution(solution) == "c = a + b: 2.5"


def test_what_is_not_known_is_named():
    solution = Solution("{c}", c=Step(LocalEquation(sp.Symbol("c"), sp.Symbol("d"))))
    with pytest.raises(CourseError, match=r"step 'c' .* uses d \(the number 'd'\), .* a, b"):
        print_solution(solution)
