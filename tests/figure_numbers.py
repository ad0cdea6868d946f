"""The settings that every figure of the course is tried at, and what it must show there."""

import json
from decimal import ROUND_HALF_UP, Decimal
from functools import cache
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from declared import each
from verification import evaluate_exactly

from courseware.course import course
from courseware.equations import Equation, find_kind
from courseware.figures import Choice, Figure, QuarterTurns, Sprite
from courseware.figures.compiler import Compiler
from courseware.figures.solids import Solid
from courseware.predictions import Ghost, Prediction
from courseware.script import engine as script
from courseware.units import figure_unit

N = 1000
ALLOWED = 1e-12  # what a figure promises; measured differences are some 1e-14
MINUS = "\u2212"


each_figure = each("figure", "figures", Figure)
HOMES = course().chapters_of("figures", Figure)  # figure → its chapter

# What the script does for any figure alike is tried on one that has most of it: sliders, handles, a
# clock, goals; what a hand does, on one in space with a choice, too; in the long run all on all.
TYPICAL = ("wheel-speeds",)
HANDLED = (*TYPICAL, "euler-sequence")
ASKED = {  # figures in which a reader places a guess: what can be moved depends on the prediction
    prediction.answers.figure
    for prediction in course().find_all("predictions", Prediction).values()
    if isinstance(prediction.answers, Ghost)
}


def typical(only, names=TYPICAL):
    """Return the mark for the named figures, and in the long run all others that fit."""

    def marks(name):
        return [] if name in names else [pytest.mark.slow]

    return each("figure", "figures", Figure, marks, only)


def own_controls(figure):
    """Return the controls that a reader can always set, but for the view."""
    if figure.name in ASKED:
        return []
    return [c for c in figure.controls if getattr(c, "symbol", None) not in figure.view_angles]


typical_figure = typical(lambda figure: True)
typical_moved = typical(own_controls)
typical_handled = typical(own_controls, HANDLED)
typical_held = typical(lambda figure: figure.handles)


# chapter → its module of tests/expected
TABLES = {
    path.stem: import_module(f"expected.{path.stem}")
    for path in sorted(Path(__file__).parent.glob("expected/*.py"))
}
WORDS = [row for table in TABLES.values() for row in getattr(table, "WORDS", ())]


def expected(table):
    """Return a table of all chapters, by figure."""
    return {name: x for module in TABLES.values() for name, x in getattr(module, table, {}).items()}


READOUTS, SPECIALS, LOST, TITLES = map(expected, ("READOUTS", "SPECIALS", "LOST", "TITLES"))


def readouts(figure, points):
    """Return the readouts as the engine computes them: (n, settings) → (n, readouts)."""
    return figure.compute(np.asarray(points, dtype=float))[:, : len(figure.readouts)]


COMPARED = {  # with functions of the library, and with 50 digits in the script
    part
    for equation in course().find_all("formulas", Equation).values()
    for part in (*sp.Matrix([equation.right]), *dict(equation.where).values())
}


def is_formula(figure, value):
    """Return whether a number is a setting, or comes from settings by formulas as declared."""
    step = sp.sympify(dict(figure.where).get(value, value))
    if step in figure.control_symbols or step.is_number:
        return True
    return step in COMPARED and all(is_formula(figure, symbol) for symbol in step.free_symbols)


LETTERS = [sign + letter for sign in ("", "-") for letter in "xyzXYZ"]  # of presses


@cache
def pressed(presses, made=1.0):
    """Return the numbers of presses' symbols, as the script computes them."""
    return script.run(f"courseware.computeTurns({json.dumps([presses, made])})")


def random_values(control, random, size):
    """Return random settings of a control over its whole range: (size, its symbols)."""
    if isinstance(control, Choice):
        return random.choice(list(control.options.values()), size)
    if isinstance(control, QuarterTurns):
        texts = ["".join(random.choice(LETTERS, random.integers(6))) for _ in range(20)]
        rows = [pressed(text, float(part)) for text in texts for part in (0, 0.3, 1) if text]
        return random.choice(rows, size)
    if isinstance(control.step, int):
        return random.integers(control.low, control.high + 1, (size, 1)).astype(float)
    return random.uniform(control.low, control.high, (size, 1))


def ends(control):
    """Return the ends of a control's range, or its options."""
    if isinstance(control, Choice):
        return list(control.options)
    if isinstance(control, QuarterTurns):
        return ["", "x", "-Z"]
    return [control.low, control.high]


def point(figure, values):
    """Return a setting as a row of numbers: the start, but for `values` (by name, in SI)."""
    row, known = [], {c.key for c in figure.controls}
    assert values.keys() <= known, f"{figure.name} has {known}, not {values.keys() - known}"
    for control in figure.controls:
        value = values.get(control.key, control.start)
        if isinstance(control, QuarterTurns):
            row += pressed(value)
        elif isinstance(control, Choice):
            row += control.options[value]
        else:
            row.append(value)
    return row


@cache
def expressions(figure):
    """Return what a figure computes: the readouts, then all coordinates of the scene."""
    compiler = Compiler(figure, HOMES.get(figure.name, ""))
    compiler.compile_figure()
    return compiler.expressions


@cache
def points(figure, n=N):
    """Return special settings, ends of ranges, then n random settings: (…, settings)."""
    special = [{}, *SPECIALS.get(figure.name, ())]
    special += [{c.key: end} for c in figure.controls for end in ends(c)]
    rows = np.array([point(figure, values) for values in special], dtype=float)
    random = np.random.default_rng(len(figure.name))
    rest = [random_values(c, random, n) for c in figure.controls]
    return np.vstack([rows, np.hstack([np.empty((n, 0)), *rest])])


def rounded(number, digits):
    """Return a number as text, halves away from zero as in JavaScript, with a true minus."""
    text = str(Decimal(number).quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP))
    text = text.removeprefix("-") if not float(text) else text
    return text.replace("-", MINUS)


def by_power(number):
    """Return a number as two digits and a power of ten."""
    digits, power = f"{number:.1e}".split("e")
    return f"{digits}·10{str(int(power)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def readout_text(readout, value):
    """Return the text of a readout for a number in SI."""
    word = readout.words.get(str(float(value)))
    if word is not None:
        return word
    number = float(value) / figure_unit(readout.unit).factor
    text = rounded(number, readout.digits) if readout.digits >= 0 else by_power(number)
    glued = {"rad": "°", "%": "%"}  # these stand at the number, without a space
    return text + glued.get(readout.unit, f" {readout.unit}".rstrip())


def readout_texts(readout, value):
    """Return all texts that it may have: half way between two the last digit decides, and of 16
    digits the last bit."""
    size, bit = abs(value) if readout.digits < 0 else 1, np.spacing(float(value))
    off = (-ALLOWED * size, -bit, 0, bit, ALLOWED * size)
    return {readout_text(readout, value + d) for d in off}


def loops(figure):
    """Return the recurrences of a figure, each once: two trails may show one."""
    found = [shape.recurrence for shape in figure.shapes if hasattr(shape, "recurrence")]
    return list({id(loop): loop for loop in found}.values())


@cache
def points_and_last_states(figure, n):
    """Return the settings, and the loops' ends from there in 50 digits: (…, settings + ends)."""
    rows = points(figure, n)
    found = [rows]
    for loop in loops(figure):
        known = [*figure.control_symbols, *loop.state]
        counts = evaluate_exactly(loop.count, figure.control_symbols, rows)[:, 0]
        assert max(counts) <= loop.most, (
            f"a recurrence of {figure.name} counts to {max(counts)}, and its `most` is {loop.most}"
        )
        state = evaluate_exactly(sp.Matrix(loop.start), figure.control_symbols, rows)
        for k in range(loop.most):
            on = counts > k
            given = np.hstack([rows[on], state[on]])
            state[on] = evaluate_exactly(sp.Matrix(loop.step), known, given, cse=True)
        found.append(state)
    return np.hstack(found)


def exact(figure, n, expressions, more=()):
    """Return expressions of a figure at `points` in 50 digits. more: symbol → its numbers."""
    ends = [symbol for loop in loops(figure) for symbol in loop.ends]
    symbols = [*figure.control_symbols, *ends, *dict(more)]
    columns = [np.asarray(c)[:, None] for c in dict(more).values()]
    given = np.hstack([points_and_last_states(figure, n), *columns])
    return evaluate_exactly(sp.Matrix(expressions), symbols, given, figure.where)


def sizes(numbers):
    """Return the measures of differences: 1, and beyond 1 the number itself."""
    magnitudes = np.abs(numbers.astype(float))
    return np.where(np.isfinite(magnitudes), np.maximum(1, magnitudes), 1)


# 50 digits are slow: ten random settings beside the special ones, a thousand in the long run
each_number = pytest.mark.parametrize("n", [10, pytest.param(N, marks=pytest.mark.slow)])


def keeps_its_digits(figure, expression):
    """Return whether a number is none that the figure shows because it loses its digits."""
    where = {str(symbol): sp.sympify(value) for symbol, value in figure.where}
    used, names = set(), {str(s) for s in sp.sympify(expression).free_symbols}
    while names - used:
        used |= names
        names = {str(s) for name in names & where.keys() for s in where[name].free_symbols}
    return not used & set(LOST.get(figure.name, ()))


def started(figure):
    """Return the state in which a figure starts."""
    return script.run(f"courseware.startState({figure.code})")


def random_state(figure, random):
    """Return a random state, in the units shown."""
    state = []
    for control in figure.controls:
        if isinstance(control, Choice):
            state.append(int(random.integers(len(control.options))))
        elif isinstance(control, QuarterTurns):
            state.append([str(random.choice(["", "x", "Zx-Y"])), 1])
        elif isinstance(control.step, int):
            state.append(int(random.integers(control.low, control.high + 1)))
        else:
            number = float(random.uniform(control.low, control.high))
            state.append(number / figure_unit(control.symbol.unit).factor)
    return state


def random_states(figure, count, seed):
    """Return random states, as JSON knows them."""
    random = np.random.default_rng(seed)
    return json.loads(json.dumps([random_state(figure, random) for _ in range(count)]))


def kind_of(figure, shape):
    """Return the name of a shape's look; what has materials instead has none."""
    if isinstance(shape, Sprite):
        return None
    if isinstance(shape, Solid):
        kind = shape.meshes[0].kind
        return kind if kind in course().looks else None
    symbolic = isinstance(shape.kind, sp.Symbol)
    home = HOMES[figure.name]
    return find_kind(shape.kind, home) if symbolic else shape.kind
