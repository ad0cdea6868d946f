"""Pictures that matplotlib drew for a light page, on a dark one."""

import io

import numpy as np
import pytest
from browser import watched_page
from PIL import Image

from robokin.styles import KINDS

pytest_plugins = ["browser"]
pytestmark = pytest.mark.browser

COME = "(img) => { img.loading = 'eager'; return img.decode(); }"
GROUND = "() => getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)"
NEAR = 45  # of 255: the hue is the live figures', some are a little lighter or darker than there


def test_a_picture_takes_the_ground_of_a_dark_page_and_the_colours_of_its_figures(server, chromium):
    with watched_page(chromium, server, scheme="dark") as (page, _):
        page.goto(f"{server}frames/frames.html")
        page.wait_for_function("() => document.documentElement.dataset.theme === 'dark'")
        picture = page.locator(".cell_output img").first
        picture.evaluate(COME)
        image = Image.open(io.BytesIO(picture.screenshot())).convert("RGB")
        colours = np.array([(count, *colour) for count, colour in image.getcolors(1 << 24)])
        ground = page.evaluate(GROUND)
    assert list(colours[colours[:, 0].argmax(), 1:]) == ground
    for kind in ("body", "x_axis", "y_axis", "text"):
        dark = [int(KINDS[kind].dark[k : k + 2], 16) for k in (1, 3, 5)]
        apart = np.abs(colours[:, 1:] - dark).max(axis=1)
        assert colours[apart < NEAR, 0].sum() > 50, kind  # pixels
