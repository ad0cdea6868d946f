"""What stays on one line: a number with its unit."""

import re

import pytest
from browser import watched_page

from courseware import practice  # noqa: F401 (the script has its part)
from courseware.script import engine as script
from courseware.units.line_breaks import UNBROKEN, prevent_breaks

pytest_plugins = ["browser"]

# texts of the page, goals among them, but not what else is code or made by a script
TEXTS = """(html) => [...new DOMParser().parseFromString(html, "text/html")
  .querySelectorAll(".bd-article :is(p, li, td)")]
  .filter((each) => each.matches(".rk-goal")
    || !each.closest(".rk-exercise, .rk-mistake, .rk-figure, .rk-prediction"))
  .flatMap((each) => [...each.childNodes].filter((n) => n.nodeType === 3).map((n) => n.data))
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("at 0.3 m and 30° in 2 s", "at 0.3~m and 30° in 2~s"),
        ("10 cm/s, 1.5 rad/s.", "10~cm/s, 1.5~rad/s."),
        ("4 mistakes, 2 motors, 5 steps", "4 mistakes, 2 motors, 5 steps"),
        ("Move 2 m/s² or m s", "Move 2~m/s² or m s"),
        ("16 bits in m², 5 °/s, 10 %", "16~bits in~m², 5~°/s, 10~%"),
        ("so a = 3 cm, b = (a longer one)", "so a~=~3~cm, b~=~(a longer one)"),
    ],
)
def test_a_number_is_tied_to_its_unit(text, expected):
    kept = expected.replace("~", "\N{NO-BREAK SPACE}")
    assert prevent_breaks(text) == kept
    assert script.call("courseware.renderParagraphs", text) == f"<p>{kept}</p>"


@pytest.mark.browser
def test_no_number_leaves_its_unit(site, chromium):
    with watched_page(chromium, "about:blank") as (page, _):
        texts = page.evaluate(TEXTS, (site / "elbow_arm/elbow_arm.html").read_text("utf-8"))
    assert not [text for text in texts if re.search(UNBROKEN, text)]
    tied = sum("\N{NO-BREAK SPACE}" in text for text in texts)
    assert tied > 20  # there are more
