"""What the chapters' `expected.py` say of their figures: readouts by `robokin`, words, titles."""

import re
from dataclasses import replace
from html import unescape
from itertools import product

import numpy as np
import pytest
from declared import FIGURES
from figure_numbers import (
    ALLOWED,
    HOMES,
    READOUTS,
    SPECIALS,
    TITLES,
    WORDS,
    computes,
    each_figure,
    keeps_its_digits,
    own_controls,
    point,
    points,
    readouts,
)
from support import EPS

from courseware.figures import Choice, Clock


@each_figure
def test_what_a_figure_must_show_is_expected(figure):
    tables = {"SPECIALS": SPECIALS} | ({"READOUTS": READOUTS} if computes(figure) else {})
    missing = [name for name, table in tables.items() if figure.name not in table]
    place = f"book/{HOMES[figure.name]}/expected.py"
    assert not missing, f"add {figure.name!r} to {' and '.join(missing)} in {place}"


def test_what_is_expected_is_a_figure():
    unknown = {*READOUTS, *SPECIALS} - FIGURES.keys()
    assert not unknown, f"no chapter declares the figures {unknown} of an expected.py"


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
    controls = [replace(c, start=values.get(c.key, c.start)) for c in FIGURES[name].controls]
    figure = replace(FIGURES[name], controls=tuple(controls))
    texts = map(unescape, re.findall("<dd.*?>(.*?)</dd>", figure.render_contents()))
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
        choices = [c for c in figure.controls if isinstance(c, Choice) and c.key == "mistake"]
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
