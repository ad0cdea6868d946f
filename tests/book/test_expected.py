"""What `tests/expected` says of figures: readouts by `robokin`, titles."""

from itertools import product

import numpy as np
import pytest
from declared import FIGURES, each
from figure_numbers import (
    ALLOWED,
    HOMES,
    READOUTS,
    TITLES,
    each_figure,
    is_formula,
    keeps_its_digits,
    own_controls,
    points,
    readouts,
)

from courseware.figures import Choice, Clock, Figure


@each_figure
def test_readouts_that_are_no_formula_against_robokin(figure):
    rows = points(figure)
    computed = dict(zip((r.name for r in figure.readouts), readouts(figure, rows).T, strict=True))
    needed = {
        readout.name
        for readout in figure.readouts
        if not is_formula(figure, readout.value) and keeps_its_digits(figure, readout.value)
    }
    given = READOUTS.get(figure.name, lambda *_: {})(*rows.T)
    assert given.keys() == needed, (
        f"in READOUTS of tests/expected/{HOMES[figure.name]}.py the function of {figure.name!r} "
        f"must return {', '.join(needed) or 'nothing'}: a readout that is no formula of the chapter"
    )
    for name, library in given.items():
        message = f"the readout {name} is not as expected"
        np.testing.assert_allclose(computed[name], library, ALLOWED, ALLOWED, err_msg=message)
    told = {word for readout in figure.readouts for word in readout.words}
    assert {str(x) for x in np.ravel([*computed.values()]) if not np.isfinite(x)} == told  # all met


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


def has_mistake_beside_slider(figure):
    """Whether a reader can set a figure of mistakes otherwise, too."""
    controls = own_controls(figure)
    has_mistake = any(isinstance(c, Choice) and c.key == "mistake" for c in controls)
    return has_mistake and any(not isinstance(c, (Choice, Clock)) for c in controls)


@each("figure", "figures", Figure, only=has_mistake_beside_slider)
def test_every_title_beside_a_slider_says_when_it_is_true(figure):
    (choice,) = (c for c in figure.controls if isinstance(c, Choice) and c.key == "mistake")
    assert TITLES.get(figure.name, {}).keys() == set(choice.options), (
        f"TITLES of {figure.name} in tests/expected/{HOMES[figure.name]}.py has other titles"
    )


@pytest.mark.parametrize(
    ("name", "title"),
    [(name, title) for name, titles in TITLES.items() for title, true in titles.items() if true],
)
def test_a_title_is_true_at_every_setting(name, title):
    """None, if it claims nothing that the picture shows."""
    rows = every_setting(FIGURES[name], title)
    true = np.broadcast_to(TITLES[name][title](*rows.T), len(rows))
    assert true.all(), rows[~true]
