"""Pictures of every page, to look at, in _build/screenshots; tests/README.md has the command."""

import pytest
from browser import ROOT, TALL, draw_all, listed, watched_page

pytest_plugins = ["browser"]
pytestmark = [pytest.mark.browser, pytest.mark.slow]

# no figure waits
COME = """() => {
  const figure = document.querySelector("figure.rk-figure:not(.rk-live):not(details *)");
  figure?.scrollIntoView();
  return !figure;
}"""

SLICE = 8000  # pixels; Chromium draws no picture higher than 16,384
FOLDER = ROOT / "_build" / "screenshots"


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("name", [*listed(), "search", "genindex"])
def test_screenshots_of_a_page(name, width, server, chromium):
    """The whole page, light and dark, a long one in slices."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for scheme in ("light", "dark"):
        with watched_page(chromium, server, width, scheme) as (page, _):
            page.goto(f"{server}{name}.html")
            draw_all(page)
            page.wait_for_function(COME)
            page.evaluate("() => scrollTo(0, 0)")
            page.evaluate("() => document.fonts.ready")
            height = page.evaluate(TALL)
            for number, top in enumerate(range(0, height, SLICE), start=1):
                part = {"x": 0, "y": top, "width": width, "height": min(SLICE, height - top)}
                file = f"{name.replace('/', '-')}-{width}-{scheme}-{number}.png"
                page.screenshot(path=FOLDER / file, full_page=True, clip=part)
