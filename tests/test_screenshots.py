"""Pictures of every page, to look at: `make screenshots`. They are in _build/screenshots."""

import pytest

pytest_plugins = ["browser"]
pytestmark = [pytest.mark.browser, pytest.mark.screenshots]

from browser import ROOT, listed, watched_page  # noqa: E402

FOLDER = ROOT / "_build" / "screenshots"


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("name", [*listed(), "search", "genindex"])
def test_screenshots_of_a_page(name, width, server, chromium):
    """The whole page, light and dark."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for scheme in ("light", "dark"):
        with watched_page(chromium, server, width, scheme) as (page, _):
            page.goto(f"{server}{name}.html", wait_until="networkidle")
            page.evaluate("() => document.fonts.ready")
            file = f"{name.replace('/', '-')}-{width}-{scheme}.png"
            page.screenshot(path=FOLDER / file, full_page=True)
