"""One symbol, one thing: what is printed is declared, and lights up wherever it is."""

import json
import re
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp
from declared import EQUATIONS, FIGURES, course
from sphinx.errors import ExtensionError
from support import on_circle

from courseware.equations.notebook import MIME
from courseware.equations.quantities import declarations
from courseware.errors import CourseError
from courseware.figures import Figure, Readout, Slider
from courseware.script import engine
from courseware.site.notation_page import notation_rows
from courseware.symbols import lexicon, live_numbers
from courseware.symbols.formula_numbers import Slots, split_lines
from courseware.symbols.lexicon import printed_tex, read_cells, read_outputs, scan_tex

_, declare_symbol = declarations(__name__)

CHAPTERS = course().taught
each_chapter = pytest.mark.parametrize("chapter", CHAPTERS)


def keys(chapter, tex):
    """The symbols in TeX, in order."""
    return [symbol.key for _, symbol, _ in scan_tex(chapter, tex) if symbol]


def undeclared(chapter, tex):
    """The letters in TeX that the chapter does not declare."""
    return [text for text, symbol, letter in scan_tex(chapter, tex) if letter and not symbol]


@each_chapter
def test_every_printed_symbol_is_declared(chapter):
    """So it is on the notation page, with its meaning."""
    missing = {letter: tex for tex in printed_tex(chapter) for letter in undeclared(chapter, tex)}
    assert not missing, (
        f"correct the text, or declare in formulas.py of {chapter}, as `quantity` or `symbol`: "
        f"{missing}"
    )


@each_chapter
def test_a_name_in_code_is_given_in_the_code(chapter):
    """What a formula's declaration says of the notebook: the name is set there, not only read."""
    own = [s for s in lexicon.printed_symbols(chapter) if s.chapter == chapter]
    told = {s.code for s in own if s.code != s.name}
    assert told <= lexicon.assigned_names(chapter), (
        f"set them in the notebook, or take off `code=`: {told}"
    )


def test_what_code_only_reads_or_catches_has_no_name(monkeypatch):
    source = "try:\n    here, n = f(there), [k for k in x]\nexcept E as error:\n    print(error)\n"
    monkeypatch.setattr(lexicon, "read_cells", lambda _: [{"cell_type": "code", "source": source}])
    assert lexicon.assigned_names("any") == {"here", "n", "k"}


@each_chapter
def test_every_symbol_of_a_shown_formula_is_found_in_its_tex(chapter):
    for equation, computed in lexicon.shown_equations(chapter):
        parts = (equation.left, equation.shown_side(computed))
        symbols = {s.key for s in lexicon.symbols_in(parts)}
        missing = symbols - set(keys(chapter, equation.latex(computed)))
        assert not missing, f"{equation.name} prints no {missing}: give it another `latex`"


@each_chapter
def test_the_notation_page_has_a_row_for_each(chapter):
    text = "\n".join(notation_rows(chapter))
    for symbol in lexicon.printed_symbols(chapter):
        assert symbol.meaning, f"{symbol.module}: say what {symbol} is, as `meaning`"
        several = symbol.name[-1].isdigit() or "entry" in symbol.meaning
        assert several or f"${symbol.latex}$" in text, f"{symbol.module}: {symbol} has no row"


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
    monkeypatch.setattr(formulas, "other", declare_symbol("other", "a length", "L"), raising=False)
    lexicon.symbols_of.cache_clear()
    with pytest.raises(
        CourseError, match=r"^L stands for two symbols .* bicycle: wheelbase \(.*other"
    ):
        lexicon.symbols_of("bicycle")
    lexicon.symbols_of.cache_clear()


# The formula with its numbers


def followed():
    """The formulas of the notebooks that follow a figure, as they are shown."""
    outputs = [(c, data) for c in CHAPTERS for cell in read_cells(c) for data in read_outputs(cell)]
    found = [(c, data[MIME]) for c, data in outputs if "figure" in data.get(MIME, ())]
    return [
        pytest.param(
            EQUATIONS[d["name"]], d["computed"], FIGURES[d["figure"]], id=f"{c}:{d['name']}"
        )
        for c, d in found
    ]


STATES = """((figure, {numbersBySymbol, settings, compute}, parts) => parts.map((row) => {
  const state = figure.controls.map((control, i) => (control.type === "slider" || control.type ===
    "clock" ? control.low + (control.high - control.low) * row[i] : control.start));
  return numbersBySymbol(figure, state, compute(figure, settings(figure, state)));
}))"""


def numbers_of(figure, count):
    """What a figure shows by symbol, at settings from all over its sliders."""
    rows = np.random.default_rng(1).random((count, len(figure.controls))).tolist()
    return engine.run(f"{STATES}({figure.code}, courseware, {rows})")


def slots(tex):
    """The keys of the slots in TeX, each with its flags."""
    found = re.findall(r"\\htmlData\{([^}]*)\}\{\\mathrm\{", tex)
    return [dict(pair.split("=") for pair in face.split(",")) for face in found]


def as_number(text):
    """What a text such as (−1.5·10⁻³) says, and half of its last digit; degrees as radians."""
    raised = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
    plain = text.strip("()").replace("−", "-").replace("·10", "e").translate(raised)
    digits, _, power = plain.split(" ")[0].rstrip("°").partition("e")
    unit = 10.0 ** int(power or 0) * (np.pi / 180 if "°" in plain else 1)
    return float(digits) * unit, 0.5 * 10.0 ** -len(digits.partition(".")[2]) * unit


@pytest.mark.parametrize(("equation", "computed", "figure"), followed())
def test_the_numbers_of_a_formula_are_those_of_its_figure(equation, computed, figure):
    """Every slot says its number to its last digit, and each right side gives the left one."""
    tex = Slots(equation, figure, CHAPTERS[0]).render_tex(computed)
    rows = numbers_of(figure, 200)
    told = [[(numbers[flags["symbol"]], flags) for flags in slots(tex)] for numbers in rows]
    write = "(row) => row.map((pair) => courseware.formatSlot(...pair))"
    for numbers, texts in zip(told, engine.run(f"{json.dumps(told)}.map({write})"), strict=True):
        for (number, flags), text in zip(numbers, texts, strict=True):
            if "result" in flags:
                assert text == number["text"]
            if re.match(r"\(?[−\d]", text):
                shown, half = as_number(text)
                assert abs(shown - number["value"]) <= half * (1 + 1e-9), text
    columns = {key: np.array([row[key]["value"] for row in rows], dtype=float) for key in rows[0]}
    for left, right in split_lines(equation, computed):
        symbols = sorted(right.free_symbols, key=str)
        with np.errstate(invalid="ignore"):  # out of reach
            values = sp.lambdify(symbols, right)(*(columns[s.key] for s in symbols))
        expected = columns[left.key]
        apart = on_circle(values - expected) if left.unit == "rad" else abs(values - expected)
        near = apart <= 1e-9 * np.maximum(1, abs(expected))  # rounding, many times over
        assert near.any(), left
        assert (near | np.isnan(apart)).all(), left


DRIVE, MOTION = (course().module(c, "formulas") for c in ("differential_drive", "motion"))


def small_figure(**changes):
    """A robot that turns, backwards at first; its numbers alone."""
    v_L, v_R, theta, dt = DRIVE.v_L, DRIVE.v_R, MOTION.theta, MOTION.dt
    ends = zip(
        (MOTION.x_next, MOTION.y_next, MOTION.theta_next), MOTION.euler_step.right, strict=True
    )
    parts = {
        "name": "small",
        "title": "",
        "view": (-1, 1, -1, 1),
        "controls": (
            Slider(v_L, -0.5, 0.5, start=-0.25, step=0.01),
            Slider(v_R, -0.5, 0.5, start=-0.1, step=0.01),
            Slider(theta, -3, 3, start=np.pi / 6, step=np.pi / 180),
            Slider(dt, 0, 2, start=0.5, step=0.1),
        ),
        "shapes": (),
        "sentence": "",
        "readouts": (
            Readout(MOTION.v),
            Readout(MOTION.omega, digits=1),
            *(Readout(symbol, value=end) for symbol, end in ends),
        ),
        "where": (
            (DRIVE.b, 0.1),
            (MOTION.v, DRIVE.speed.right),
            (MOTION.omega, DRIVE.turning_rate.right),
            (MOTION.x, 0.0),
            (MOTION.y, 0.0),
        ),
    }
    return Figure(**parts | changes)


def written(name, figure):
    """The formula with its starting numbers, as TeX without marks."""
    tex = Slots(EQUATIONS[name], figure, "differential_drive").render_tex(False)
    tex = re.sub(r"\{\\htmlData\{[^{}]*\}\{((?:[^{}]|\{[^{}]*\})*)\}\}", r"\1", tex)
    return re.sub(r"\\mathrm\{([^{}]*[\d°][^{}]*)\}", r"\1", tex).replace("~", " ")


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("differential_drive.speed", r"v = \frac{−0.10 + (−0.25)}{2} = −0.175 m/s"),
        ("differential_drive.turning_rate", r"\omega = \frac{−0.10 - (−0.25)}{0.1} = 1.5 rad/s"),
        (
            "motion.euler_step",
            r"x' &= 0 + (−0.175) \cdot \cos{\left(30° \right)} \cdot 0.5 = −0.076 m",
        ),
        ("motion.euler_step", r"\theta' &= 0.524 + 1.5 \cdot 0.5 = 1.274\,\mathrm{rad} = 73.0°"),
    ],
)
def test_signs_and_units_of_the_numbers(name, expected):
    assert expected in written(name, small_figure())


def test_a_number_that_a_figure_lacks_is_told():
    other = Readout("other", "", MOTION.theta * MOTION.dt, "")
    silent, speed = small_figure(readouts=(other,)), EQUATIONS["motion.euler_step"]
    with pytest.raises(
        CourseError, match=r"the figure small, which shows none for x_next .* readout"
    ):
        Slots(speed, silent, "differential_drive").render_tex(False)
    with pytest.raises(CourseError, match=r"left side .* is no symbol"):
        Slots(EQUATIONS["bicycle.equivalent_steering"], silent, "bicycle").render_tex(False)


def placed(text):
    """The text of a cell with a live number, as its page gets it."""
    app = SimpleNamespace(env=SimpleNamespace(doc2path=lambda page: f"{page}.ipynb"))
    metadata = {"numbers": {"live": {"tips": ["drives at {v}."]}}}
    content = [json.dumps({"cells": [{"source": [text], "metadata": metadata}]})]
    live_numbers.place_slots(app, "differential_drive/differential_drive", content)
    return json.loads(content[0])["cells"][0]["source"]


def test_a_live_number_becomes_a_slot():
    text = placed("It drives at 0.075 m/s.")
    assert re.sub("<[^>]*>", "", text) == "It drives at 0.075 m/s."
    assert 'data-of="tips"' in text
    assert 'data-symbol="motion.v"' in text


def test_a_live_number_that_is_stale_is_refused():
    with pytest.raises(ExtensionError, match="make notebooks"):
        placed("It drives at 0.090 m/s.")
