"""The live figures: their numbers, their picture, and the hands of a reader on the built page.

Every figure of the course is held to all of this. A new one needs two entries in
`book/<topic>/expected.py`: what its readouts must say, computed by `robokin`, and its special
settings.
"""

import json
import re
import statistics
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from decimal import ROUND_HALF_UP, Decimal
from functools import cache
from html import unescape
from itertools import product

import nbformat
import numpy as np
import pytest
import sympy as sp
from browser import pages, settled, wait_until_drawn, watched_page
from declared import FIGURES, each
from support import EPS, ROOT, assert_close

from book.motion import formulas as motion_formulas
from courseware.course import course
from courseware.equations import find_kind
from courseware.equations.verification import differences, evaluate
from courseware.errors import CourseError
from courseware.figures import (
    POINTER,
    VIEW,
    Arrow,
    Choice,
    Clock,
    Curve,
    Figure,
    Handle,
    Point,
    QuarterTurns,
    Readout,
    Recurrence,
    Slider,
    Trail,
)
from courseware.figures.compiling import factor, xy
from courseware.figures.figure import MIME, find_figure
from courseware.figures.javascript import run_function
from courseware.predictions import Ghost, Prediction
from courseware.script import engine as script
from courseware.script import runtime
from robokin import euler
from robokin.styles import KINDS

pytest_plugins = ["browser"]

N = 1000
ALLOWED = 1e-12  # what a figure promises; measured differences are some 1e-14
MINUS = "\u2212"


each_figure = each("figure", "figures", Figure)
HOMES = course().homes("figures", Figure)  # figure → its chapter

# What the script does for any figure alike is tried on one that has most of it: sliders, handles, a
# clock, goals; what a hand does, on one in space with a choice, too; in the long run all on all.
TYPICAL = ("wheel-speeds",)
HANDLED = (*TYPICAL, "euler-sequence")
ASKED = {  # figures in which a reader places a guess: what can be moved depends on the prediction
    prediction.answers.figure
    for prediction in course().declared("predictions", Prediction).values()
    if isinstance(prediction.answers, Ghost)
}


def typical(only, names=TYPICAL):
    """The named figures, and in the long run all others, of those that this is asked of."""

    def marks(name):
        return [] if name in names else [pytest.mark.slow]

    return each("figure", "figures", Figure, marks, only)


def own_controls(figure):
    """What a reader can always set but the view."""
    if figure.name in ASKED:
        return []
    return [c for c in figure.controls if getattr(c, "symbol", None) not in figure.view_angles]


typical_figure = typical(lambda figure: True)
typical_moved = typical(own_controls)
typical_handled = typical(own_controls, HANDLED)
typical_held = typical(lambda figure: figure.handles)
typical_linked = typical(lambda figure: figure.size != "step" and own_controls(figure))


# --- By topic -------------------------------------------------------------------------------

TABLES = course().modules("expected").values()
READOUTS = {name: by for table in TABLES for name, by in table.READOUTS.items()}
SPECIALS = {name: special for table in TABLES for name, special in table.SPECIALS.items()}
LOST = {name: lost for table in TABLES for name, lost in getattr(table, "LOST", {}).items()}
WORDS = [row for table in TABLES for row in table.WORDS]  # settings as a slider shows them
TITLES = {
    figure: titles for table in TABLES for figure, titles in getattr(table, "TITLES", {}).items()
}


@each_figure
def test_what_a_figure_must_show_is_expected(figure):
    tables = {"SPECIALS": SPECIALS} | ({"READOUTS": READOUTS} if computes(figure) else {})
    missing = [name for name, table in tables.items() if figure.name not in table]
    place = f"book/{HOMES[figure.name]}/expected.py"
    assert not missing, f"add {figure.name!r} to {' and '.join(missing)} in {place}"


def test_what_is_expected_is_a_figure():
    unknown = {*READOUTS, *SPECIALS} - FIGURES.keys()
    assert not unknown, f"no chapter declares the figures {unknown} of an expected.py"


def readouts(figure, points):
    """The readouts by `robokin`: (n, settings) → (n, readouts)."""
    rows = np.asarray(points, dtype=float)
    if computes(figure):
        return READOUTS[figure.name](*rows.T)
    return rows[:, [figure.settings.index(readout.value) for readout in figure.readouts]]


def computes(figure):
    """Whether its readouts are more than what its controls are set to."""
    return any(readout.value not in figure.settings for readout in figure.readouts)


# --- Settings, and what a reader sees of them -----------------------------------------------


key = Figure.key_of


LETTERS = [sign + letter for sign in ("", "-") for letter in "xyzXYZ"]  # of presses


@cache
def pressed(presses, made=1.0):
    """The numbers that presses give their symbols, as the script computes them."""
    return script.run(f"courseware.figures.turnNumbers({json.dumps([presses, made])})")


def drawn(control, random, size):
    """Random settings of one control over its whole range: (size, its symbols)."""
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
    """The ends of a control's range, and its options one by one."""
    if isinstance(control, Choice):
        return list(control.options)
    if isinstance(control, QuarterTurns):
        return ["", "x", "-Z"]
    return [control.low, control.high]


def point(figure, values):
    """One setting as a row of numbers: the start, but for `values` (by name, in SI)."""
    row, known = [], {key(c) for c in figure.controls}
    assert values.keys() <= known, f"{figure.name} has {known}, not {values.keys() - known}"
    for control in figure.controls:
        value = values.get(key(control), control.start)
        if isinstance(control, QuarterTurns):
            row += pressed(value)
        else:
            row += control.options[value] if isinstance(control, Choice) else [value]
    return row


@cache
def points(figure, n=N):
    """Special settings, ends of ranges, then n random settings: (…, settings)."""
    special = [{}, *SPECIALS[figure.name]]
    special += [{key(c): end} for c in figure.controls for end in ends(c)]
    rows = np.array([point(figure, values) for values in special], dtype=float)
    random = np.random.default_rng(len(figure.name))
    rest = [drawn(c, random, n) for c in figure.controls]
    return np.vstack([rows, np.hstack([np.empty((n, 0)), *rest])])


def rounded(number, digits):
    """A number as text, halves away from zero as in JavaScript, with a true minus sign."""
    text = str(Decimal(number).quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP))
    text = text.removeprefix("-") if not float(text) else text
    return text.replace("-", MINUS)


def by_power(number):
    """Two digits and a power of ten."""
    digits, power = f"{number:.1e}".split("e")
    return f"{digits}·10{str(int(power)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def shown(readout, value):
    """What a readout must say of a number in SI."""
    word = readout.words.get(str(float(value)))
    if word is not None:
        return word
    number = float(value) / factor(readout.unit)
    text = rounded(number, readout.digits) if readout.digits >= 0 else by_power(number)
    return text + "°" if readout.unit == "rad" else f"{text} {readout.unit}".rstrip()


def both_shown(readout, value):
    """As `shown`; half way between two texts the last digit of the number may decide for either."""
    size = abs(value) if readout.digits < 0 else 1
    return {shown(readout, value + d * size) for d in (-ALLOWED, ALLOWED)}


# --- Numbers, in the engine -----------------------------------------------------------------


def loops(figure):
    """The recurrences of a figure."""
    return [shape.recurrence for shape in figure.scene if hasattr(shape, "recurrence")]


@cache
def points_and_last_states(figure, n):
    """The settings, and where the loops end from there in 50 digits: (…, settings + ends)."""
    rows = points(figure, n)
    found = [rows]
    for loop in loops(figure):
        known = [*figure.settings, *loop.state]
        counts = evaluate(loop.count, figure.settings, rows)[:, 0]
        assert max(counts) <= loop.most, (
            f"a recurrence of {figure.name} counts to {max(counts)}, and its `most` is {loop.most}"
        )
        state = evaluate(sp.Matrix(loop.start), figure.settings, rows)
        for k in range(loop.most):
            on = counts > k
            given = np.hstack([rows[on], state[on]])
            state[on] = evaluate(sp.Matrix(loop.step), known, given)
        found.append(state)
    return np.hstack(found)


def exact(figure, n, expressions, more=()):
    """Expressions of a figure at `points` in 50 digits. more: symbol → its numbers."""
    ends = [symbol for loop in loops(figure) for symbol in loop.ends]
    symbols = [*figure.settings, *ends, *dict(more)]
    columns = [np.asarray(c)[:, None] for c in dict(more).values()]
    given = np.hstack([points_and_last_states(figure, n), *columns])
    return evaluate(sp.Matrix(expressions), symbols, given, figure.where)


def sizes(numbers):
    """What differences are measured by: 1, and beyond 1 the number itself."""
    magnitudes = np.abs(numbers.astype(float))
    return np.where(np.isfinite(magnitudes), np.maximum(1, magnitudes), 1)


# 50 digits are slow: ten random settings beside the special ones, a thousand in the long run
each_number = pytest.mark.parametrize("n", [10, pytest.param(N, marks=pytest.mark.slow)])


def keeps_its_digits(figure, expression):
    """Whether a number is none that the figure shows because it loses its digits."""
    where = {str(symbol): sp.sympify(value) for symbol, value in figure.where}
    used, names = set(), {str(s) for s in sp.sympify(expression).free_symbols}
    while names - used:
        used |= names
        names = {str(s) for name in names & where.keys() for s in where[name].free_symbols}
    return not used & set(LOST.get(figure.name, ()))


@each_number
@each_figure
def test_every_number_in_50_digits(figure, n):
    kept = [keeps_its_digits(figure, e) for e in figure.expressions]
    computed = figure.compute(points(figure, n))[:, kept]
    wanted = exact(
        figure, n, [e for e, keeps in zip(figure.expressions, kept, strict=True) if keeps]
    )
    worst = (differences(computed, wanted) / sizes(wanted)).max()
    print(f"{figure.name}: {computed.shape[1]} numbers, largest difference {worst:.1e}")
    assert worst <= ALLOWED


@each_figure
def test_readouts_against_robokin(figure):
    rows = points(figure)
    computed = figure.compute(rows)[:, : len(figure.readouts)]
    kept = [keeps_its_digits(figure, readout.value) for readout in figure.readouts]
    wanted = readouts(figure, rows)[:, kept]
    columns = [readout.name for readout, keep in zip(figure.readouts, kept, strict=True) if keep]
    for name, ours, library in zip(columns, computed[:, kept].T, wanted.T, strict=True):
        message = f"the readout {name} is not what expected.py says"
        np.testing.assert_allclose(ours, library, ALLOWED, ALLOWED, err_msg=message)
    told = [w for readout in figure.readouts for w in readout.words]
    assert {str(x) for x in computed[~np.isfinite(computed)]} == set(told)  # all words are met


@pytest.mark.parametrize(("name", "values", "readout", "word"), WORDS)
def test_a_word_instead_of_a_number(name, values, readout, word):
    """As the script writes it where the controls stand at a setting."""
    controls = [replace(c, start=values.get(key(c), c.start)) for c in FIGURES[name].controls]
    figure = replace(FIGURES[name], controls=tuple(controls))
    texts = map(unescape, re.findall("<dd>(.*?)</dd>", figure.render_contents()))
    assert dict(zip([r.name for r in figure.readouts], texts, strict=True))[readout] == word


# --- The titles of mistakes, beside a slider -------------------------------------------------


def every_setting(figure, title):
    """All settings with this title that a reader's sliders have; of a clock its middle."""
    parts = []
    for control in figure.controls:
        if isinstance(control, Choice):
            parts.append([control.options[title]])
        elif isinstance(control, Clock):
            parts.append([((control.low + control.high) / 2,)])
        elif control.symbol in figure.view_angles:
            parts.append([(control.start,)])
        else:
            count = round((control.high - control.low) / control.step)
            parts.append([(x,) for x in np.linspace(control.low, control.high, count + 1)])
    return np.array([sum(row, ()) for row in product(*parts)], dtype=float)


def mistakes_beside_a_slider():
    """The figures of mistakes that a reader can set otherwise: name → titles."""
    found = {}
    for name, figure in FIGURES.items():
        choices = [c for c in figure.controls if isinstance(c, Choice) and c.name == "mistake"]
        sliders = [c for c in own_controls(figure) if not isinstance(c, (Choice, Clock))]
        if choices and sliders:
            found[name] = set(choices[0].options)
    return found


def test_every_title_beside_a_slider_says_when_it_is_true():
    assert {name: set(titles) for name, titles in TITLES.items()} == mistakes_beside_a_slider()


@pytest.mark.parametrize(
    ("name", "title"),
    [(name, title) for name, titles in TITLES.items() for title, true in titles.items() if true],
)
def test_a_title_is_true_at_every_setting(name, title):
    """None, if it claims nothing that the picture shows."""
    rows = every_setting(FIGURES[name], title)
    true = np.broadcast_to(TITLES[name][title](*rows.T), len(rows))
    assert true.all(), rows[~true]


def test_almost_straight():
    """However large the turning radius, its first 15 digits are right."""
    figure = FIGURES["wheel-speeds"]
    faster = [np.nextafter(0.1, 1), *(0.1 + 10.0**-k for k in range(3, 16))]
    rows = np.array([point(figure, {"v_L": 0.1, "v_R": v_R, "t": 12.0}) for v_R in faster])
    # three roundings of the radius, twice, each of half a unit in the last place
    wanted = readouts(figure, rows)
    np.testing.assert_allclose(figure.compute(rows)[:, :6], wanted, rtol=6 * EPS, atol=ALLOWED)
    assert wanted[0, 2] > 1e14


def called(figure, function, rows, extra):
    """A function of the compiled figure, at settings and one more array of numbers each."""
    code = f"""((figure) => (f, given) => {{
      const c = courseware.figures.compute(figure, given.slice(0, {rows.shape[1]})).c;
      return figure.{function}(f, c, given.slice({rows.shape[1]}));
    }})({figure.code})"""
    return run_function(code, np.hstack([rows, extra]))


@each_number
@each_figure
def test_curves_in_50_digits(figure, n):
    rows = points(figure, n)
    for place, shape in enumerate(figure.scene):
        loses = figure.name in LOST and shape.kind == "approximation"
        if isinstance(shape, Curve) and not loses:
            low, high = exact(figure, n, [shape.low, shape.high]).T.astype(float)
            s = np.random.default_rng(place).uniform(low, high)
            drawn_at = called(figure, f"scene[{place}].point", rows, s[:, None])
            traced = shape.at[:2] if shape.depth is None else (*shape.at, shape.depth)
            at = exact(figure, n, traced, {shape.parameter: s})
            assert (differences(drawn_at, at) / sizes(at)).max() <= ALLOWED


@each_number
@each_figure
def test_a_handle_sets_what_puts_it_there(figure, n):
    """Where a handle is, its expressions give back the settings that it sets."""
    rows = points(figure, n)
    for place, handle in enumerate(figure.handles):
        at = exact(figure, n, xy(handle.at)).astype(float)
        back = called(figure, f"handles[{place}].to", rows, at)
        columns = [figure.settings.index(symbol) for symbol in handle.sets]
        assert_close(back, rows[:, columns], atol=ALLOWED)


# --- Declarations ---------------------------------------------------------------------------

a = motion_formulas.x  # some quantity in m
loose = sp.Symbol("loose")


LOOP = Recurrence((sp.Symbol("k"),), (0,), (loose,), 3, 3, (sp.Symbol("last"),))


def declared(**parts):
    """A small figure that is right, but for `parts`."""
    right = {
        "name": "small",
        "title": "A point on a line",
        "view": (-1, 1, -1, 1),
        "controls": (Slider(a, 0.0, 1.0, start=0.5, step=0.1),),
        "scene": (Point("target", (a, 0)),),
        "readouts": (Readout("twice", "twice a", 2 * a, "m"),),
        "sentence": "x is {x}, twice that {twice}.",
    }
    return Figure(**{**right, **parts})


def test_the_small_figure_is_right():
    assert_close(declared().compute([[0.25]])[:, 0], [0.5], atol=0)


@pytest.mark.parametrize(
    ("parts", "message"),
    [
        ({"scene": (Point("target", (loose, 0)),)}, "an expression uses loose, but may use only x"),
        ({"scene": (Curve("path", (loose, loose * a), loose * a, 0, 1),)}, "uses loose"),
        ({"scene": (Point("purple", (a, 0)),)}, "no kind 'purple'; there are left, right"),
        (
            {"controls": (Slider(loose, 0, 1, 0, 0.1),), "sentence": ""},
            "loose is no declared quantity",
        ),
        ({"controls": (Slider(a, 0, 1, 0, 0.1, kind="purple"),)}, "no kind 'purple'"),
        ({"readouts": (Readout("x", "", a, "m"),)}, "two controls or readouts of one name"),
        ({"controls": (Slider(a, 1, 0, 0, 0.1),)}, "slider x goes from 1 to 0 .* must be below"),
        ({"controls": (Slider(a, 0, 1, 2, 0.1),)}, "starts at 2: .* its start between them"),
        ({"controls": (Slider(a, 0, 1, 0, 0),)}, "in steps of 0 .* its step positive"),
        (
            {"controls": (Choice("c", "", (a,), {"one": (1.0,)}, "two"),), "sentence": ""},
            "one, got 'two'",
        ),
        (
            {"controls": (Choice("c", "", (a,), {"one": ()}, "one"),), "sentence": ""},
            "each of x, got 0",
        ),
        (
            {"readouts": (Readout("twice", "", a, "m", words={"big": "far"}),)},
            "twice has a word for big",
        ),
        ({"sentence": "b is {b}"}, "text `sentence` of .* uses b, but there are only x, twice"),
        ({"handles": (Handle("tip", (a, 0), {loose: POINTER[0]}),)}, "'tip' sets loose"),
        ({"handles": (Handle("tip", (a, 0), {a: loose}),)}, "uses loose"),
        ({"scene": (Point("target", (a, 0), depth=loose),)}, "uses loose"),
        (
            {"controls": (Slider(a, 0, 1, 0, 0.1), Slider(motion_formulas.y, 0, 1, 0, 0.1))},
            "in the figure small, the control y moves nothing",
        ),
        ({"where": (LOOP,)}, "`where` of small has a Recurrence: give it to a Trail"),
        (
            {"where": ((loose, a / 2),), "scene": (Trail("path", (a, 0), LOOP),)},
            "in the figure small, in a recurrence, which comes before `where`, .* uses loose",
        ),
    ],
)
def test_a_wrong_declaration_is_refused(parts, message):
    with pytest.raises(CourseError, match=message):
        _ = declared(**parts).code


@pytest.mark.parametrize("part", ["start", "step", "ends"])
def test_a_recurrence_has_as_many_of_each(part):
    with pytest.raises(CourseError, match=rf"state \(k,\) and as `{part}` \(.*must be as many"):
        replace(LOOP, **{part: (a, a)})


def told_numbers(figure):
    """Every number of the start that has a symbol, as a page tells it."""
    return script.run(
        f"((figure, state) => courseware.figures.numbers(figure, state, courseware.figures.compute("
        f"figure, courseware.figures.settings(figure, state))))({figure.code}, {started(figure)})"
    )


def test_numbers_are_told_by_symbol():
    """Sliders, readouts and named steps that are quantities; in SI and as shown."""
    theta, v = motion_formulas.theta, motion_formulas.v
    figure = declared(
        controls=(Slider(theta, 0.0, 2.0, start=np.pi / 6, step=np.pi / 180),),
        where=((a, sp.sin(theta)), (v, 4 * a)),
        scene=(Point("target", (a, 0)),),
        readouts=(Readout(v, digits=1), Readout("twice", "twice", 2 * a, "m")),
        sentence="{v}",
    )
    numbers = told_numbers(figure)
    assert {key: number["text"] for key, number in numbers.items()} == {
        "motion.theta": "30°",
        "motion.x": "0.5 m",
        "motion.v": "2.0 m/s",
    }
    values = [number["value"] for number in numbers.values()]
    np.testing.assert_allclose(values, [0.5, 2.0, np.pi / 6], rtol=4 * EPS)


def test_a_trail_is_a_line_with_dots():
    place, end = sp.symbols("place end")
    loop = Recurrence((place,), (0,), (place + a,), count=3, most=5, ends=(end,))
    drawn = declared(
        scene=(Trail("path", (place, 0), loop),), readouts=(), sentence=""
    ).render_svg()
    assert len(re.findall("<circle", drawn)) == 4
    assert len(re.findall(r"M[\d.]+ [\d.]+L[^\"]*L[^\"]*L", drawn)) == 1


# --- Pictures in space ----------------------------------------------------------------------

turn = sp.Symbol("turn")
ring = (sp.cos(turn), sp.sin(turn), 0)


def space(**parts):
    """A frame, a ring about its z axis and a point, seen from a side that the reader chooses."""
    right = {
        "name": "space",
        "view": (-1.6, 1.6, -1.3, 1.3),
        "controls": (),
        "scene": (
            *VIEW.frame(sp.eye(3), labels=("x", "y", "z")),
            Curve("path", VIEW.project(ring), turn, 0, 6.2831, depth=VIEW.depth(ring)),
            VIEW.point("target", (2, 0, 0)),
        ),
        "readouts": (Readout("near", "how near x is", VIEW.depth((1, 0, 0)), ""),),
        "sentence": "Seen from {azimuth}, {elevation}.",
    }
    return declared(**{**right, **parts})


def painted(figure, **shown):
    """The picture at a setting, in the units shown; its pieces in order of painting."""
    state = [shown.get(key(c), c.start) for c in figure.controls]
    text = script.run(f"courseware.figures.svg({figure.code}, {json.dumps(state)})")
    kinds = re.findall(r"--rk-(\w+),", re.sub(r"<text.*?</text>", "", text))
    return [kind for kind in kinds if kind != "ground"]


def test_a_view_is_a_rotation():
    """Right, up and towards the viewer: the axes of a frame turned about z, then its new x."""
    angles = np.random.default_rng(8).uniform([-np.pi, -np.pi / 2], [np.pi, np.pi / 2], (N, 2))
    seen = [sp.Matrix([*VIEW.project(axis), VIEW.depth(axis)]) for axis in np.eye(3, dtype=int)]
    rows = evaluate(sp.Matrix.hstack(*seen), VIEW.angles, angles).reshape(N, 3, 3)
    turns = np.stack([angles[:, 0] + np.pi / 2, np.pi / 2 - angles[:, 1]], axis=-1)
    expected = np.swapaxes(euler.to_matrix("ZX", turns), 1, 2)
    # two roundings of angles up to 5 rad, of sine and cosine, and one product
    assert_close(rows.astype(float), expected, atol=8 * EPS)


@pytest.mark.parametrize(
    ("azimuth", "elevation", "order"),
    [
        (30, 20, ["z_axis", "y_axis", "x_axis"]),
        (80, 20, ["x_axis", "z_axis", "y_axis"]),
        (30, 80, ["y_axis", "x_axis", "z_axis"]),
        (-150, 20, ["x_axis", "y_axis", "z_axis"]),
    ],
)
def test_nearer_shapes_are_painted_later(azimuth, elevation, order):
    figure = space(scene=VIEW.frame(sp.eye(3)))
    axes = painted(figure, azimuth=azimuth, elevation=elevation)
    assert list(dict.fromkeys(axes)) == order


def test_a_curve_passes_behind_and_in_front():
    axis = VIEW.line("z_axis", [(0, 0, -1), (0, 0, 1)])
    pieces = painted(space(scene=(axis, space().scene[3])), elevation=20)
    middle = pieces.index("z_axis")
    assert pieces == ["path"] * middle + ["z_axis"] + ["path"] * (len(pieces) - middle - 1)
    assert len(pieces) == 96 / 4 + 1
    assert abs(middle - 12) <= 1


def test_shapes_without_depth_keep_their_place():
    first, last = Point("left", (0, 0)), Point("right", (0, 0))
    near, far = Point("icr", (0, 0), depth=1), Point("ghost", (0, 0), depth=-1)
    assert painted(space(scene=(first, near, far, last))) == ["left", "ghost", "icr", "right"]
    same = (Point("icr", (0, 0), depth=1), Point("ghost", (0, 0), depth=1))
    assert painted(space(scene=same)) == ["icr", "ghost"]


@pytest.mark.parametrize("depth", [sp.nan, sp.oo])
def test_a_shape_at_no_depth_is_not_painted(depth):
    shapes = (Point("icr", (0, 0), depth=depth), Point("left", (0, 0), depth=0))
    assert painted(space(scene=shapes)) == ["left"]


def test_what_is_in_front_leaves_a_gap():
    """A line in space is drawn on a wider one in the colour of the ground; a flat one is not."""
    gaps = r"fill:none;stroke:var\(--rk-ground"
    assert len(re.findall(gaps, space(scene=VIEW.frame(sp.eye(3))).render_svg())) == 3
    assert len(re.findall(gaps, space(scene=(space().scene[3],)).render_svg())) == 96 / 4
    assert re.findall(gaps, FIGURES["wheel-speeds"].render_svg()) == []


def test_no_grid_where_none_is_wanted():
    assert "grid" in painted(declared())
    assert "grid" not in painted(declared(grid=False))
    assert "grid" not in painted(space())
    assert "x, y in m" not in space().render_svg()


def test_a_frame_in_space_is_three_arrows():
    arrows = VIEW.frame(sp.eye(3), at=(0, 0, 1), size=2, labels=("x", "y", "z"))
    assert [arrow.kind for arrow in arrows] == ["x_axis", "y_axis", "z_axis"]
    assert [arrow.label for arrow in arrows] == ["x", "y", "z"]
    assert arrows[2] == Arrow(
        "z_axis", VIEW.project((0, 0, 1)), VIEW.project((0, 0, 3)), "z", VIEW.depth((0, 0, 2))
    )


# --- What a notebook keeps ------------------------------------------------------------------

SIZE = 30_000  # bytes for one figure: nearly all of it is the still picture


def kept_figures():
    """The stored outputs that hold a figure, by the figure's name."""
    found = {}
    for path in sorted((ROOT / "book").glob("*/*.ipynb")):
        notebook = nbformat.read(path, as_version=4)
        assert "widgets" not in notebook.metadata
        for cell in notebook.cells:
            for output in cell.get("outputs", []):
                if MIME in output.get("data", {}):
                    found[output.data[MIME]["name"]] = output.data
    return found


@each_figure
def test_a_notebook_keeps_the_name_and_the_still_picture(figure):
    """What is compiled is made when the page is: the figure that the chapter declares."""
    data = kept_figures()[figure.name]
    new, _ = figure._repr_mimebundle_()
    assert data == {key: new[key] for key in (MIME, "text/plain", "image/svg+xml")}, (
        "the stored figure is old: run `make notebooks`"
    )
    assert data[MIME] == {"name": figure.name}
    assert len(json.dumps(data)) < SIZE
    assert "var(" not in data["image/svg+xml"]  # it stands without the page's style


def test_a_figure_that_no_chapter_declares_is_refused():
    assert find_figure("wheel-speeds") is FIGURES["wheel-speeds"]
    with pytest.raises(CourseError, match=r"no figure 'small'; there are .* chapters' figures\.py"):
        find_figure("small")


def test_a_widget_carries_its_figure_and_its_part():
    figure = next(iter(FIGURES.values()))
    module = figure.widget.get_state()["_esm"]
    assert module.startswith("export default")
    assert figure.code in module


# --- Colours --------------------------------------------------------------------------------


def luminance(color):
    """Relative luminance of `#rrggbb` or `#rgb`, as WCAG 2.2 defines it."""
    digits = color.lstrip("#")
    digits = digits if len(digits) == 6 else "".join(2 * d for d in digits)
    channels = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))


def contrast(first, second):
    """Contrast of two colours, 1 to 21."""
    high, low = sorted((luminance(first), luminance(second)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def grounds():
    """The ground behind the figures on light and on dark pages, from the style sheet."""
    light, dark = re.findall(r"--rk-ground: (#\w+)", runtime.stylesheet())
    return light, dark


def test_contrast_is_computed_right():
    assert contrast("#fff", "#000000") == pytest.approx(21)
    assert contrast("#767676", "#fff") == pytest.approx(4.54, abs=0.005)  # WCAG's known example


SEEN = {  # linear RGB as seen without red or green cones: Machado, Oliveira, Fernandes (2009)
    "protan": [(0.152, 1.053, -0.205), (0.115, 0.786, 0.099), (-0.004, -0.048, 1.052)],
    "deutan": [(0.367, 0.861, -0.228), (0.280, 0.673, 0.047), (-0.012, 0.043, 0.969)],
}


def lab(color, seen):
    """CIELAB of a colour as such a reader sees it."""
    channels = np.array([int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    linear = np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)
    xyz = np.array([(0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505)])
    white = xyz.sum(axis=1)
    x, y, z = np.cbrt(np.clip(xyz @ np.clip(np.array(seen) @ linear, 0, 1) / white, 0.009, 1))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


@pytest.mark.parametrize("page", ["light", "dark"])
@pytest.mark.parametrize("seen", SEEN.values(), ids=SEEN)
def test_the_axes_of_a_frame_are_told_apart(seen, page):
    """By dashes, and z from the others by its colour, too."""
    axes = [KINDS[kind] for kind in ("x_axis", "y_axis", "z_axis")]
    assert len({style.dash for style in axes}) == 3
    x, y, z = (lab(getattr(style, page), seen) for style in axes)
    assert min(np.linalg.norm(z - x), np.linalg.norm(z - y)) >= 40  # 2 is just visible


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "grid"])  # grid: decoration
def test_every_kind_stands_out(kind):
    light, dark = grounds()
    style = KINDS[kind]
    assert style.light != style.dark
    assert min(contrast(style.light, light), contrast(style.dark, dark)) >= 3  # WCAG 1.4.11


def kind_of(figure, shape):
    """The name of a shape's look."""
    symbolic = isinstance(shape.kind, sp.Symbol)
    home = HOMES[figure.name]
    return find_kind(shape.kind, home) if symbolic else shape.kind


@each_figure
def test_labels_are_legible(figure):
    light, dark = grounds()
    for shape in figure.scene:
        if getattr(shape, "label", "") or isinstance(shape.kind, sp.Symbol):
            style = KINDS[kind_of(figure, shape)]
            readable = min(contrast(style.light, light), contrast(style.dark, dark))
            assert readable >= 4.5, shape  # WCAG 1.4.3, for text


@each_figure
def test_an_index_is_written_the_same_way_everywhere(figure):
    """As in θ_1, which is set like the formula's; the sign ₁ would be another letter."""
    parts = (*figure.controls, *figure.readouts, *figure.scene)
    labels = "".join(str(getattr(part, "label", "")) for part in parts)
    assert not set("₀₁₂₃₄₅₆₇₈₉") & set(labels)


# --- The page -------------------------------------------------------------------------------

in_browser = pytest.mark.browser


@pytest.fixture(scope="session")
def page_of(site):
    """The chapter that each figure stands in; the first page may show it, too."""
    texts = {name: (site / name).read_text("utf-8") for name in pages(site)}
    found = {}
    for figure in FIGURES:
        found[figure] = [
            n for n, t in texts.items() if "/" in n and f'class="rk-figure" id="{figure}"' in t
        ]
        assert len(found[figure]) == 1, f"{figure} stands on {found[figure]}"
    return {figure: names[0] for figure, names in found.items()}


SHOW = """(svg) => new Promise((standing) => {
  let before = NaN, still = 0;
  const look = () => {
    const {top} = svg.getBoundingClientRect();
    still = top === before ? still + 1 : 0;
    if (still === 3) return standing();
    before = top;
    requestAnimationFrame(look);
  };
  svg.scrollIntoView({block: "center", behavior: "instant"});
  look();
})"""


UNFOLD = """(figure) => {
  for (let at = figure; at; at = at.parentElement) {
    if (at.matches("details")) at.open = true;
    if (at.matches(".rk-prediction")) at.classList.add("rk-answered");
  }
}"""
FITS = """(name) => {
  const svg = document.getElementById(name).querySelector(".rk-picture svg");
  return svg.clientWidth >= 240 && svg.clientWidth === svg.parentElement.clientWidth;
}"""
MADE = "(name) => document.getElementById(name).courseware.state[0][1] === 1"
OPENED = "(input) => { const fold = input.closest('details'); if (fold) fold.open = true; }"


class OnPage:
    """One figure on a page in the browser."""

    def __init__(self, page, figure):
        self.page, self.figure = page, figure
        self.root = page.locator(f"#{figure.name}")
        self.handles = self.root.locator(".rk-handles circle")
        self.picture = self.root.locator(".rk-picture svg")

    def come_alive(self):
        """Wait until the script has taken over: it does when the figure comes near."""
        self.unfold()
        self.root.scroll_into_view_if_needed()
        self.page.wait_for_selector(f"#{self.figure.name}.rk-live")
        self.page.wait_for_function(FITS, arg=self.figure.name)
        return self

    def unfold(self):
        """Open the folds around it: what a prediction shows."""
        self.root.evaluate(UNFOLD)

    def state(self):
        """What the controls stand at, in the units they show; drawn to the end first."""
        return self.root.evaluate(
            "({courseware}) => { courseware.settled(); return courseware.state; }"
        )

    def point(self):
        """The same as a row of numbers in SI, computed here as the page must compute it."""
        row = []
        for control, shown in zip(self.figure.controls, self.state(), strict=True):
            if isinstance(control, Choice):
                row += list(control.options.values())[shown]
            elif isinstance(control, QuarterTurns):
                row += pressed(*shown)
            else:
                row.append(shown * factor(control.symbol.unit))
        return row

    def readouts(self):
        """The text of each readout, by name."""
        self.state()
        texts = self.root.locator("dd").all_text_contents()
        return dict(zip((r.name for r in self.figure.readouts), texts, strict=True))

    def input(self, control):
        """The slider or the list of a control."""
        place = self.figure.controls.index(control)
        return self.root.locator(f"[data-i='{place}']:not(button)")

    def press(self, control, *keys):
        """Keys on a slider that has the focus, in an open fold; for turns, buttons to their end."""
        if isinstance(control, QuarterTurns):
            for one in keys:
                self.root.locator(f"[data-press='{one if one in LETTERS else 'Z'}']").click()
                self.page.wait_for_function(MADE, arg=self.figure.name)
            return
        self.input(control).evaluate(OPENED)
        self.input(control).focus()
        for one in keys:
            self.page.keyboard.press(one)

    def spot(self, place, values):
        """Where on the screen a handle is at a setting (by name, in SI); the picture in view."""
        self.picture.evaluate(SHOW)
        box, (left, right, low, high) = self.picture.bounding_box(), self.figure.view
        at = sp.Matrix(xy(self.figure.handles[place].at))
        given = np.array([point(self.figure, values)], dtype=float)
        x, y = evaluate(at, self.figure.settings, given, self.figure.where)[0].astype(float)
        across, down = (x - left) / (right - left), (high - y) / (high - low)
        return box["x"] + across * box["width"], box["y"] + down * box["height"]

    def way(self, place, wished):
        """From where a handle is drawn, which may be beside its place, to a setting."""
        here, there = self.spot(place, self.values()), self.spot(place, wished)
        box = self.handles.nth(place).bounding_box()
        start = np.array([box["x"] + box["width"] / 2, box["y"] + box["height"] / 2])
        return start.tolist(), (start + there - here).tolist()

    def values(self):
        """The present setting as `Figure.move` takes it."""
        row = iter(self.point())
        found = {}
        for control, shown in zip(self.figure.controls, self.state(), strict=True):
            several = isinstance(control, Choice | QuarterTurns)
            numbers = [next(row) for _ in (control.symbols if several else [0])]
            if isinstance(control, Choice):
                numbers = [list(control.options)[shown]]
            found[key(control)] = shown[0] if isinstance(control, QuarterTurns) else numbers[0]
        return found

    def alternative(self):
        """What the picture says to those who do not see it."""
        return self.picture.locator("[role=img]").get_attribute("aria-label")


# a figure and its page as they were at first
AS_AT_FIRST = """() => {
  for (const { courseware } of document.querySelectorAll(".rk-figure.rk-live")) {
    courseware.element.querySelector(".rk-reset")?.click();
    courseware.last = null;
    courseware.settled();
  }
  history.replaceState(null, "", location.pathname);
  document.activeElement.blur();
  scrollTo({ top: 0, behavior: "instant" });
}"""


@pytest.fixture(scope="session")
def visit(chromium, server, page_of):
    """Opens the page of a figure; afterwards the console must be empty.

    A page that nothing asks to be fresh is opened once, and as at first for each test.
    """
    kept = {}

    @contextmanager
    def opened(figure, address="", before=None, fresh=False, reduced_motion="reduce", **options):
        home = server + page_of[figure.name]
        fresh = fresh or address or before or reduced_motion != "reduce"
        key = (home, *options.items())
        with ExitStack() as stack:
            if fresh or key not in kept:
                way = watched_page(chromium, server, reduced_motion=reduced_motion, **options)
                page, watch = stack.enter_context(way)
                if before:
                    before(page)
                settled(page, home + address)  # else the page still moves
                page.add_style_tag(content="html { scroll-behavior: auto !important; }")
            else:
                page, watch, others = kept.pop(key)
                stack.push(others)
                page.mouse.move(0, 0)
                page.evaluate(AS_AT_FIRST)
            yield OnPage(page, figure).come_alive()
            assert not watch.errors + watch.strangers
            if not fresh:
                kept[key] = page, watch, stack.pop_all()  # a test that fails closes its page

    yield opened
    for *_, stack in kept.values():
        stack.close()


CHAPTERS = sorted(set(HOMES.values()))


@in_browser
@typical_figure
def test_the_browser_computes_as_the_engine_does(figure, visit):
    rows = points(figure)
    with visit(figure) as live:
        found = live.page.evaluate(
            """([name, rows]) => {
              const figure = coursewareFigures.find((figure) => figure.name === name);
              return rows.map((row) => courseware.figures.compute(figure, row).values);
            }""",
            [figure.name, rows.tolist()],
        )
    kept = [keeps_its_digits(figure, e) for e in figure.expressions]
    there, here = np.array(found, dtype=float)[:, kept], figure.compute(rows)[:, kept]
    assert_close(there, here, atol=ALLOWED)
    finite = np.isfinite(here)
    apart = np.abs(there[finite] - here[finite]).max()
    print(f"{figure.name}: Chromium and engine differ by at most {apart:.1e}")


# --- Hands ----------------------------------------------------------------------------------


def assert_told(live):
    """The readouts and the controls say what `robokin` computes for the state read back."""
    wanted = readouts(live.figure, [live.point()])[0]
    texts = live.readouts()
    for readout, value in zip(live.figure.readouts, wanted, strict=True):
        if keeps_its_digits(live.figure, readout.value):
            assert texts[readout.name] in both_shown(readout, value), (live.state(), readout.name)
    for control, shown in zip(live.figure.controls, live.state(), strict=True):
        if not isinstance(control, Choice | QuarterTurns):
            assert_slider_told(live, control, shown)


def assert_slider_told(live, control, shown):
    """The number beside a slider, with its unit, also for a screen reader."""
    text = live.input(control).get_attribute("aria-valuetext")
    assert live.input(control).locator("xpath=../*[@data-o]").text_content() == text
    number, unit = re.fullmatch(r"(\S*?\d)(°| .*|)", text.replace(MINUS, "-")).groups()
    known = control.symbol.unit
    assert unit.strip() == ("°" if known == "rad" else known)
    digits = len(number.partition(".")[2])
    assert number.replace("-", MINUS) == rounded(shown, digits)
    assert float(number) == pytest.approx(shown, abs=control.step / factor(known))


def slide(live, random):
    """Keys on a slider, or another entry of a list."""
    control = random.choice(np.array(live.figure.controls, dtype=object))
    if isinstance(control, Choice):
        return live.input(control).select_option(index=int(random.integers(len(control.options))))
    keys = [["Home"], ["End"], ["ArrowRight"] * 3, ["ArrowLeft"] * 2, ["PageUp"]]
    return live.press(control, *keys[random.integers(len(keys))])


def wish(live, place, random):
    """A setting for a handle to be dragged to: what it sets at random, on the sliders' steps."""
    wished = live.values()
    for control in live.figure.controls:
        if getattr(control, "symbol", None) in live.figure.handles[place].sets:
            steps = round((control.high - control.low) / control.step)
            wished[key(control)] = control.low + int(random.integers(steps + 1)) * control.step
    return wished


def assert_arrived(live, wished):
    """The controls are where the handle was dragged to, to one step (a pixel is less), or to what
    a magnet in reach draws to: 1.5 % of the range."""
    found = live.values()
    for control in live.figure.controls:
        if not isinstance(control, Choice | QuarterTurns):
            # a hundredth more for the rounding of numbers in between
            allowed = 1.01 * max(control.step, 0.015 * (control.high - control.low))
            assert abs(found[key(control)] - wished[key(control)]) <= allowed


def drag(live, random):
    """A handle, pulled by the mouse to where it belongs at another setting."""
    if not live.figure.handles:
        return slide(live, random)
    place = int(random.integers(len(live.figure.handles)))
    wished = wish(live, place, random)
    start, end = live.way(place, wished)
    live.page.mouse.move(*start)
    live.page.mouse.down()
    live.page.mouse.move(*end, steps=4)
    live.page.mouse.up()
    return assert_arrived(live, wished)


def nudge(live, random):
    """A handle, moved by arrow keys."""
    if not live.figure.handles:
        return slide(live, random)
    live.handles.nth(int(random.integers(len(live.figure.handles)))).focus()
    arrow = random.choice(["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "Shift+ArrowUp"])
    for _ in range(3):
        live.page.keyboard.press(arrow)
        live.state()
    return None


@in_browser
@typical_handled
def test_twenty_settings_by_mouse_and_keys(figure, visit):
    random = np.random.default_rng(20)
    seen = set()
    with visit(figure) as live:
        for turn in range(20):
            (slide, drag, nudge)[turn % 3](live, random)
            assert_told(live)
            seen.add(json.dumps(live.state()))
    assert len(seen) >= 10  # some keys, as Home at the lower end, change nothing


@in_browser
@typical_held
def test_a_handle_taken_at_its_edge_does_not_jump(figure, visit):
    with visit(figure) as live:
        start = live.state()
        x, y = live.spot(len(figure.handles) - 1, live.values())
        live.page.mouse.move(x + 6, y + 6)
        live.page.mouse.down()
        live.page.mouse.move(x + 6, y + 6)
        live.page.mouse.up()
        assert live.state() == pytest.approx(start, abs=1e-9)


def swipe(page, start, end):
    """One finger from start to end."""
    finger = page.context.new_cdp_session(page)
    for step in range(6):
        x, y = np.add(start, np.subtract(end, start) * min(step, 4) / 4).tolist()
        kind = ["touchStart", *["touchMove"] * 4, "touchEnd"][step]
        touches = [] if kind == "touchEnd" else [{"x": x, "y": y}]
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})


@pytest.fixture
def turned(chromium):
    """Opens a page of its own that holds the picture in space, with a page to scroll below."""

    @contextmanager
    def opened(**options):
        figure = space(
            controls=(Slider(QUANTITY, 0.0, 1.0, start=0.5, step=0.01),),
            handles=(Handle("tip", (1, 1), {QUANTITY: POINTER[0]}),),
            readouts=(Readout("set", "where the handle is", QUANTITY, "m"),),
            seen_from=(0.5, 0.25),
        )
        body = f'<figure class="rk-figure" id="space">{figure.render_contents()}</figure>'
        with watched_page(chromium, "about:blank", **options) as (page, watch):
            page.set_content(
                f"<style>{runtime.stylesheet()}</style>{body}<p style='height: 3000px'>"
            )
            start = f"courseware.figures.bringToPage({figure.code});"
            page.add_script_tag(content="".join([*map(runtime.script, runtime.parts()), start]))
            yield OnPage(page, figure).come_alive()
            assert not watch.errors

    return opened


QUANTITY = motion_formulas.x


def degrees(live):
    """Azimuth and elevation as shown."""
    return live.state()[1:]


@in_browser
def test_dragging_the_ground_turns_the_view(turned):
    """Half a turn across the picture: what is near goes with the hand, and the rest stays."""
    with turned() as live:
        box = live.picture.bounding_box()
        before = live.state()
        live.page.mouse.move(box["x"] + 100, box["y"] + 100)
        live.page.mouse.down()
        live.page.mouse.move(box["x"] + 100 + box["width"] / 6, box["y"] + 140, steps=3)
        live.page.mouse.up()
        across, down = 30, 180 * 40 / box["width"]
        # a magnet reaches 6 px: straight from the front is near
        assert degrees(live) == pytest.approx([before[1] - across, before[2] + down], abs=2)
        assert live.state()[0] == before[0]
        rest = live.state()
        live.page.mouse.move(box["x"] + 10, box["y"] + 10)  # let go: nothing follows any more
        assert live.state() == rest


@in_browser
def test_the_view_goes_all_round_and_stops_above(turned):
    with turned() as live:
        box = live.picture.bounding_box()
        start = [box["x"] + 0.9 * box["width"], box["y"] + 20]
        for _ in range(3):  # to the left by 0.8 of half a turn each time: 432°, and up
            live.page.mouse.move(*start)
            live.page.mouse.down()
            live.page.mouse.move(box["x"] + 0.1 * box["width"], start[1] + box["height"] / 2)
            live.page.mouse.up()
        azimuth, elevation = degrees(live)
        # each of three drags rounds to a degree
        assert azimuth == pytest.approx(np.degrees(0.5) + 432 - 360, abs=2)
        assert elevation == 90
        live.press(live.figure.controls[1], "ArrowRight", "ArrowRight")
        assert degrees(live)[0] == pytest.approx(azimuth + 2, abs=0.5)  # keys go in steps


@in_browser
def test_a_handle_does_not_turn_the_view(turned):
    with turned() as live:
        before = degrees(live)
        x, y = live.spot(0, {})
        live.page.mouse.move(x, y)
        live.page.mouse.down()
        live.page.mouse.move(x - 80, y + 40, steps=3)
        live.page.mouse.up()
        assert degrees(live) == before
        assert live.state()[0] != 0.5


@in_browser
def test_a_finger_across_turns_and_up_scrolls(turned):
    with turned(width=390, has_touch=True, is_mobile=True) as live:
        live.page.evaluate("() => scrollTo(0, 0)")
        before, box = degrees(live), live.picture.bounding_box()
        middle = np.array([box["x"] + box["width"] / 2, box["y"] + 40])
        swipe(live.page, middle.tolist(), np.add(middle, [-90, 4]).tolist())
        after = degrees(live)
        assert after[0] == pytest.approx(before[0] + 180 * 90 / box["width"], abs=1)
        assert live.page.evaluate("scrollY") == 0
        swipe(live.page, np.add(middle, [0, 160]).tolist(), middle.tolist())
        live.page.wait_for_function("() => scrollY > 100")
        assert degrees(live)[0] == after[0]


@in_browser
@pytest.mark.parametrize(
    ("name", "values", "readout", "word"),
    [pytest.param(*row, marks=[pytest.mark.slow] * (row[0] not in TYPICAL)) for row in WORDS],
)
def test_keys_reach_a_word_instead_of_a_number(visit, name, values, readout, word):
    """From the nearer end of the slider step by step."""
    figure = FIGURES[name]
    with visit(figure) as live:
        for control in figure.controls:
            if key(control) in values:
                up = round((values[key(control)] - control.low) / control.step)
                down = round((control.high - values[key(control)]) / control.step)
                ways = ["Home", *["ArrowRight"] * up], ["End", *["ArrowLeft"] * down]
                live.press(control, *min(ways, key=len))
        assert live.readouts()[readout] == word
        assert_told(live)


@in_browser
@typical_moved
def test_reset_restores_the_start(figure, visit):
    with visit(figure) as live:
        start = live.state()
        for control in figure.controls:
            live.press(control, "End")
        assert live.state() != start
        live.root.locator(".rk-reset").click()
        assert live.state() == start
        assert_told(live)


def neighbours(live):
    """The other figures on the page."""
    ids = live.page.locator(".rk-figure").evaluate_all("(all) => all.map(({id}) => id)")
    return [OnPage(live.page, FIGURES[i]).come_alive() for i in ids if i != live.figure.name]


@in_browser
@typical_moved
def test_figures_do_not_disturb_each_other(figure, visit):
    with visit(figure) as live:
        others = neighbours(live)
        before = [(o.state(), o.readouts(), o.picture.inner_html()) for o in others]
        for turn in range(3):
            (slide, drag, nudge)[turn](live, np.random.default_rng(3))
        assert before == [(o.state(), o.readouts(), o.picture.inner_html()) for o in others]


# --- Time -----------------------------------------------------------------------------------

each_clock = pytest.mark.parametrize(
    ("figure", "clock"),
    [
        pytest.param(f, c, marks=[pytest.mark.slow] * (f.name not in TYPICAL), id=f.name)
        for f in FIGURES.values()
        for c in f.controls
        if isinstance(c, Clock) and not c.loops and f.name not in ASKED
    ],
)


def time_of(live, clock):
    """Where the clock stands, in SI."""
    return live.values()[key(clock)]


def on_its_own_clock(page):
    """Seconds pass when the test says so."""
    page.clock.install(time=0)


@in_browser
@each_clock
def test_play_pause_and_the_end(figure, clock, visit):
    """On a clock of the test's own: seconds pass when it says so."""
    with visit(figure, before=on_its_own_clock, reduced_motion="no-preference") as live:
        live.page.clock.pause_at(60_000)
        live.press(clock, "Home")
        button = live.root.locator(".rk-play")
        button.click()
        assert button.text_content() == "Pause"
        live.page.clock.run_for(2000)
        # two frames of 16 ms may be missing at the start and at the end
        assert time_of(live, clock) == pytest.approx(clock.low + 2 * clock.rate, abs=0.035)
        button.click()
        stopped = time_of(live, clock)
        live.page.clock.run_for(1000)
        assert time_of(live, clock) == stopped
        assert button.text_content() == "Play"
        assert_told(live)
        button.click()
        live.page.clock.run_for(1000 * (clock.high - clock.low) / clock.rate)
        assert time_of(live, clock) == clock.high
        assert button.text_content() == "Play"
        assert_told(live)
        button.click()  # from the end it starts again
        live.page.clock.run_for(1000)
        assert time_of(live, clock) == pytest.approx(clock.low + clock.rate, abs=0.035)


@in_browser
@each_clock
def test_scrubbing_takes_over_from_playing(figure, clock, visit):
    """In real time."""
    with visit(figure, reduced_motion="no-preference") as live:
        live.root.locator(".rk-play").click()
        live.page.wait_for_function(
            "([name, i, low]) => document.getElementById(name).courseware.state[i] > low",
            arg=[figure.name, figure.controls.index(clock), clock.low],
        )
        live.press(clock, "End", "ArrowLeft")
        assert live.root.locator(".rk-play").text_content() == "Play"
        assert time_of(live, clock) == pytest.approx(clock.high - clock.step)
        assert_told(live)


@in_browser
@each_clock
def test_reduced_motion_steps(figure, clock, visit):
    """Nothing runs: each press of the button is a tenth of the time."""
    with visit(figure, reduced_motion="reduce") as live:
        live.press(clock, "Home")
        for turn in range(1, 12):
            live.root.locator(".rk-play").click()
            tenths = turn if turn <= 10 else 0  # and from the end back to the start
            wanted = clock.low + tenths * (clock.high - clock.low) / 10
            assert time_of(live, clock) == pytest.approx(wanted)
            assert live.root.locator(".rk-play").text_content() == "Play"


# --- The address ----------------------------------------------------------------------------


IN_VIEW = """(name) => {
  const {top, bottom} = document.querySelector(`#${name} svg`).getBoundingClientRect();
  return top >= 0 && bottom <= innerHeight;
}"""


@in_browser
@typical_linked
def test_a_link_brings_the_setting_back(figure, visit):
    with visit(figure) as live:
        for turn in range(4):
            (slide, drag, nudge)[turn % 3](live, np.random.default_rng(turn))
        state = live.state()
        live.root.locator(".rk-link").click()
        address = live.page.evaluate("location.hash")
    with visit(figure, address) as live:
        for found, wanted in zip(live.state(), state, strict=True):
            # the address keeps six decimals
            assert found == wanted or found == pytest.approx(wanted, abs=1e-6)
        assert state != started(figure)
        assert_told(live)
        live.page.wait_for_function(IN_VIEW, arg=figure.name)
        for other in neighbours(live):
            assert other.state() == started(other.figure)


def started(figure):
    """The state in which a figure starts."""
    return script.run(f"courseware.figures.startState({figure.code})")


JUNK = ["1e99", "-1e99", "NaN", "Infinity", "", "<script>alert(1)</script>", "%", "2.5", "null"]


@in_browser
@typical_linked
def test_junk_in_the_address_does_no_harm(figure, visit):
    """Too large or small is the end of the range, no number is the start."""
    with visit(figure, "#?") as live:
        live.page.on("dialog", lambda dialog: pytest.fail(dialog.message))
        for junk in JUNK:
            pairs = "&".join(
                f"{name}={junk}" for name in ["x", "__proto__", *map(key, figure.controls)]
            )
            live.page.evaluate("(hash) => { location.hash = hash; }", f"#{figure.name}?{pairs}")
            live.page.wait_for_function("(name) => location.hash.includes(name)", arg=figure.name)
            assert_told(live)
            for control, found in zip(figure.controls, live.values().values(), strict=True):
                assert found in allowed(control, junk), (junk, key(control))


def allowed(control, junk):
    """What a control may make of junk."""
    if isinstance(control, Choice | QuarterTurns):
        return [control.start]
    scale = factor(control.symbol.unit)
    number = {"1e99": control.high, "-1e99": control.low, "2.5": 2.5 * scale}.get(
        junk, control.start
    )
    if isinstance(control.step, int):
        number = np.floor(number + 0.5)
    return [pytest.approx(np.clip(number, control.low, control.high), rel=1e-9)]


# --- The still picture, and the script that takes it over -----------------------------------


@in_browser
@each_figure
def test_the_page_holds_the_still_picture(figure, site, page_of):
    """The very text that the engine draws."""
    text = (site / page_of[figure.name]).read_text("utf-8")
    assert f'<div class="rk-picture">{figure.render_svg()}</div>' in text
    assert len(re.findall(f'id="{figure.name}"', text)) == 1


@in_browser
@typical_figure
def test_without_javascript_the_picture_is_there_and_why_it_stands_still(
    figure, server, chromium, page_of
):
    with watched_page(chromium, server, java_script_enabled=False) as (page, _):
        page.goto(server + page_of[figure.name])
        live = OnPage(page, figure)
        live.unfold()
        picture, whole = live.picture.bounding_box(), live.root.bounding_box()
        assert picture["height"] > 200
        # below it one to four lines, of 26 px each, which say why
        assert 18 < whole["height"] - picture["height"] < 115
        why = "(figure) => getComputedStyle(figure, '::after').content"
        assert "JavaScript is off" in live.root.evaluate(why)
        assert live.root.locator("button, input, select, dd").filter(visible=True).count() == 0


def broken(figure, told):
    """What a page's figures are told, but one's computation throws."""
    found = f'coursewareFigures.find(({{ name }}) => name === "{figure.name}")'
    return f'{told}\n{found}.compute = () => {{ throw new Error("on purpose"); }};'


@in_browser
@typical_figure
def test_a_broken_figure_stays_still_and_alone(figure, server, chromium, page_of):
    """Its picture is as the engine drew it, without controls; the others live."""
    with watched_page(chromium, server) as (page, watch):
        page.route(
            "**/_static/pages/*.js*",
            lambda route: route.fulfill(body=broken(figure, route.fetch().text())),
        )
        page.goto(server + page_of[figure.name])
        dead = OnPage(page, figure)
        dead.unfold()
        dead.root.scroll_into_view_if_needed()
        assert None not in [other.state() for other in neighbours(dead)]
        assert "rk-live" not in dead.root.get_attribute("class")
        assert dead.picture.is_visible()
        same = "([e, text]) => { const d = document.createElement('div'); d.innerHTML = text;"
        same += " return d.innerHTML === e.outerHTML; }"
        assert page.evaluate(same, [dead.picture.element_handle(), figure.render_svg()])
        assert dead.root.locator("button, input, select").count() == 0
    assert len(watch.errors) == 1
    assert f"The figure {figure.name} cannot be moved: Error: on purpose" in watch.errors[0]


SHIFTS = """
window.shifts = [];
new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) shifts.push(entry.value);
}).observe({type: "layout-shift"});
"""
BELOW = "(element) => element.getBoundingClientRect().bottom"


@in_browser
@pytest.mark.parametrize("width", [1280, 390])
@typical_figure
def test_the_page_does_not_jump_when_the_script_takes_over(
    figure, server, chromium, page_of, width
):
    """The script comes late: the page is complete and the reader looks at the still picture."""
    start = "courseware.figures.onPage()"

    def held(route):
        response = route.fetch()
        assert start in response.text()
        route.fulfill(response=response, body=response.text().replace(start, "0"))

    with watched_page(chromium, server, width) as (page, watch):
        page.route("**/courseware/*.js*", held)
        settled(page, server + page_of[figure.name])
        live = OnPage(page, figure)
        live.unfold()
        wait_until_drawn(page)
        live.picture.evaluate(SHOW)
        below = live.root.evaluate(BELOW)
        page.evaluate(SHIFTS)
        page.evaluate(start)
        live.come_alive()
        live.picture.evaluate(SHOW)  # two frames: shifts have been reported
        shift = sum(page.evaluate("shifts"))
        print(f"{figure.name} at {width} px: layout shift {shift}")
        assert shift == 0
        assert live.root.evaluate(BELOW) == pytest.approx(below, abs=1)  # px: as a page scrolls
        assert not watch.errors


# --- Speed ----------------------------------------------------------------------------------

ANSWERS = """([name, i, count]) => {
  const element = document.getElementById(name), times = [];
  const slider = element.querySelector(`input[data-i="${i}"]`);
  const { min, max } = slider;
  for (let k = 0; k < count; k++) {
    const before = performance.now();
    slider.value = Number(min) + (k * 0.618 % 1) * (max - min);
    slider.dispatchEvent(new Event("input", {bubbles: true}));
    element.courseware.settled();  // draws now, not with the next picture of the screen
    element.getBoundingClientRect();  // and lays out
    times.push(performance.now() - before);
  }
  return times;
}"""


@in_browser
@pytest.mark.slow
@each_figure
def test_how_long_an_answer_takes(figure, visit):
    """The median of 200 answers to the slowest slider; printed, not held to a time.

    Below 16 ms a figure follows the hand at 60 pictures a second.
    """
    with visit(figure) as live:
        sliders = [i for i, c in enumerate(figure.controls) if isinstance(c, Slider)]
        times = [
            statistics.median(live.page.evaluate(ANSWERS, [figure.name, i, 200])) for i in sliders
        ]
    print(f"{figure.name}: {max(times, default=0):.1f} ms for an answer")


# --- For every reader -----------------------------------------------------------------------


@in_browser
@typical_moved
def test_the_text_alternative_follows(figure, visit):
    """The picture's label and the sentence that is read aloud, after a key press."""
    with visit(figure, fresh=True) as live:
        before = live.alternative()
        assert before.startswith(figure.title)
        assert live.root.locator(".rk-says").text_content() == ""  # silent until touched
        first = own_controls(figure)[0]
        last = [*first.options][-1] if isinstance(first, Choice) else None
        live.press(first, "Home" if last == first.start else "End")
        changed = "([picture, before]) => picture.getAttribute('aria-label') !== before"
        label = live.picture.locator("[role=img]").element_handle()
        live.page.wait_for_function(changed, arg=[label, before])
        said = live.root.locator(".rk-says").text_content()
        assert live.root.locator(".rk-says").get_attribute("aria-live") == "polite"
        assert live.alternative() == f"{figure.title}. {said}" != before
        assert "{" not in said
        for name, text in live.readouts().items():
            assert text in said or f"{{{name}}}" not in figure.sentence


@in_browser
@typical_moved
def test_everything_is_reached_by_tab_and_seen(figure, visit):
    """Each control in turn, with a ring of 3 px round it that stands out."""
    rings = []
    with visit(figure) as live:
        live.root.evaluate("(e) => { e.tabIndex = -1; e.focus(); e.removeAttribute('tabindex'); }")
        live.root.evaluate(
            "(e) => e.querySelectorAll('details').forEach((d) => { d.open = true; })"
        )
        reached = live.root.locator("button, input, select, summary, [tabindex]")
        parts = reached.filter(visible=True).count()
        assert parts >= len(figure.handles) + len(figure.controls)
        for _ in range(parts):
            live.page.keyboard.press("Tab")
            rings.append(live.page.evaluate(RING))
    assert len({ring.pop("which") for ring in rings}) == parts
    for ring in rings:
        assert ring == {"inside": figure.name, "style": "solid", "width": "3px", "named": True}


RING = """() => {
  const element = document.activeElement, style = getComputedStyle(element);
  const figure = element.closest(".rk-figure");
  return {
    which: [...figure.querySelectorAll("*")].indexOf(element),
    inside: figure.id,
    style: style.outlineStyle,
    width: style.outlineWidth,
    named: Boolean(element.ariaLabel || element.textContent || element.labels?.[0].textContent),
  };
}"""


def test_the_ring_stands_out():
    light, dark = re.findall(r"--rk-accent: (#\w+)", runtime.stylesheet())
    assert min(contrast(c, g) for c, g in zip((light, dark), grounds(), strict=True)) >= 3


PAINT = """(svg) => [...svg.querySelectorAll("*")].flatMap((element) => {
  const { stroke, fill } = getComputedStyle(element);
  return [stroke, fill];
})"""


def rgb(color):
    """As a browser tells a colour."""
    return f"rgb({', '.join(str(int(color[i : i + 2], 16)) for i in (1, 3, 5))})"


@in_browser
@pytest.mark.parametrize("scheme", ["light", "dark"])
@typical_figure
def test_every_kind_has_its_colour(figure, visit, scheme):
    """On light and dark pages."""
    other = {"light": "dark", "dark": "light"}[scheme]
    with visit(figure, scheme=scheme) as live:
        painted = set(live.picture.evaluate(PAINT))
        for kind in {kind_of(figure, shape) for shape in figure.scene}:
            assert rgb(getattr(KINDS[kind], scheme)) in painted, kind
            assert rgb(getattr(KINDS[kind], other)) not in painted, kind
