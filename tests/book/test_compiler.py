"""From a declaration to JavaScript: every number of every figure, in the engine."""

import re
from itertools import compress

import numpy as np
import sympy as sp
from figure_numbers import (
    ALLOWED,
    LOST,
    each_figure,
    each_number,
    exact,
    expressions,
    keeps_its_digits,
    points,
    sizes,
)
from small_figures import a, small_figure
from support import EPS
from verification import differences

from book.motion import formulas as motion_formulas
from courseware.equations.javascript import run_javascript
from courseware.figures import Curve, Point, Readout, Recurrence, Slider, Trail
from courseware.figures.compiler import coordinates
from courseware.symbols.formula_numbers import start_numbers


@each_number
@each_figure
def test_every_number_in_50_digits(figure, n):
    kept = [keeps_its_digits(figure, e) for e in expressions(figure)]
    computed = figure.compute(points(figure, n))[:, kept]
    wanted = exact(figure, n, list(compress(expressions(figure), kept)))
    worst = (differences(computed, wanted) / sizes(wanted)).max()
    print(f"{figure.name}: {computed.shape[1]} numbers, largest difference {worst:.1e}")
    assert worst <= ALLOWED


def call_compiled(figure, function, rows, extra):
    """A function of the compiled figure, at settings and one more array of numbers each."""
    code = f"""((figure) => (f, given) => {{
      const c = courseware.compute(figure, given.slice(0, {rows.shape[1]})).c;
      return figure.{function}(f, c, given.slice({rows.shape[1]}));
    }})({figure.code})"""
    return run_javascript(code, np.hstack([rows, extra]))


@each_number
@each_figure
def test_curves_in_50_digits(figure, n):
    rows = points(figure, n)
    for place, shape in enumerate(figure.shapes):
        loses = figure.name in LOST and getattr(shape, "kind", "") == "approximation"
        if isinstance(shape, Curve) and not loses:
            low, high = exact(figure, n, [shape.low, shape.high]).T.astype(float)
            s = np.random.default_rng(place).uniform(low, high)
            drawn_at = call_compiled(figure, f"shapes[{place}].point", rows, s[:, None])
            traced = shape.at[:2] if shape.depth is None else (*shape.at, shape.depth)
            at = exact(figure, n, traced, {shape.parameter: s})
            assert (differences(drawn_at, at) / sizes(at)).max() <= ALLOWED


@each_number
@each_figure
def test_a_handle_sets_what_puts_it_there(figure, n):
    """Where it is, it gives back its settings; at a thin circle's end to 1e-10, once in 1,000."""
    rows = points(figure, n)
    for place, handle in enumerate(figure.handles):
        at = exact(figure, n, coordinates(handle.at)).astype(float)
        there = np.isfinite(at).all(axis=1)  # elsewhere it cannot be taken
        back = call_compiled(figure, f"handles[{place}].to", rows[there], at[there])
        given = rows[there][:, [figure.control_symbols.index(symbol) for symbol in handle.sets]]
        assert (abs(back - given) <= 100 * ALLOWED * np.maximum(1, abs(given))).all()


def test_numbers_are_told_by_symbol():
    """Sliders, readouts and named steps that are quantities; in SI and as shown."""
    theta, v = motion_formulas.theta, motion_formulas.v
    figure = small_figure(
        controls=(Slider(theta, 0.0, 2.0, start=np.pi / 6, step=np.pi / 180),),
        where=((a, sp.sin(theta)), (v, 4 * a)),
        shapes=(Point("target", (a, 0)),),
        readouts=(Readout(v, digits=1), Readout("twice", "twice", 2 * a, "m")),
        sentence="{v}",
    )
    numbers = start_numbers(figure)
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
    drawn = small_figure(
        shapes=(Trail("path", (place, 0), loop),), readouts=(), sentence=""
    ).render_svg()
    assert len(re.findall("<circle", drawn)) == 4
    [points] = re.findall(r'<polyline points="([^"]*)"', drawn)
    assert len(points.split()) == 2 * 4
