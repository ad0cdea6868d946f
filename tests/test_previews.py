"""The pictures that a message shows which links to a page, and the icon."""

from io import BytesIO
from types import SimpleNamespace

import numpy as np
import previews
import pytest
from PIL import Image

import book  # noqa: F401  (opens the course)

pytest_plugins = ["browser"]

BODY = '<figure class="rk-figure" id="wheel-speeds" data-size="large">'


def told(folder, base, body):
    """What a page's head is told."""
    config = SimpleNamespace(html_baseurl=base)
    context = {
        "body": body,
        "title": "Who &amp; <em>what</em>",
        "pathto": lambda name, resource: f"../{name}",
    }
    app = SimpleNamespace(config=config, outdir=folder)
    previews.add_preview(app, "page", "", context, object())
    return context["metatags"]


def test_a_page_with_a_figure_has_its_picture(tmp_path):
    address = "https://robots.example/course/"
    text = told(tmp_path, address, BODY)
    assert f'property="og:image" content="{address}_static/previews/wheel-speeds.png"' in text
    picture = Image.open(tmp_path / "_static" / "previews" / "wheel-speeds.png").convert("RGB")
    assert picture.size == (1200, 630)
    # the blue and the orange wheel, and a white ground
    colours = dict((colour, count) for count, colour in picture.getcolors(2**24))
    assert colours[0, 114, 178] > 500
    assert colours[192, 74, 0] > 500
    assert colours[255, 255, 255] > 400_000


def test_a_page_without_a_figure_has_its_title_over_another(tmp_path):
    assert "/_static/previews/page.png" in told(tmp_path, "https://robots.example/", "<p>")
    picture = Image.open(tmp_path / "_static" / "previews" / "page.png").convert("L")
    dark = (np.array(picture)[50:120] < 50).any(axis=0)
    assert picture.size == (1200, 630)
    assert np.count_nonzero(dark[300:900]) > 200  # black letters, in the middle
    assert not dark[:200].any()
    assert not dark[1000:].any()
    assert (np.array(picture)[150:] < 250).mean() > 0.02  # the figure


def test_without_an_address_there_is_none(tmp_path):
    assert "og:image" not in told(tmp_path, "", BODY)
    assert not list(tmp_path.iterdir())


@pytest.mark.browser
def test_the_icon_is_there(site):
    assert Image.open(BytesIO((site / "_static" / "icon.png").read_bytes())).size == (180, 180)
    for name, href in (("index.html", "_static/"), ("bicycle/bicycle.html", "../_static/")):
        text = (site / name).read_text("utf-8")
        assert f'<link rel="apple-touch-icon" href="{href}icon.png' in text
