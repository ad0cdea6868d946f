"""Sprites: outlines that are in a picture once, places that a frame sets, materials, grounds."""

import math
import re
from xml.etree import ElementTree

import numpy as np
import pytest
import sympy as sp
from small_figures import a, small_figure

from courseware.errors import CourseError
from courseware.figures import Outline, Rim, Sprite
from courseware.figures.figure import compact_svg

SQUARE = Outline("M-.1 -.1h.2v.2h-.2z", "shell", "edge")
SPOT = Outline("M.02 0h.01v.01h-.01z", "lamp")
SVG = "{http://www.w3.org/2000/svg}"


def cart(place, **more):
    """A square with two wheels that turn by x."""
    wheels = (Sprite((0, side, a), (SPOT,)) for side in (0.1, -0.1))
    return Sprite(place, (SQUARE, *wheels), **more)


def picture(*sprites, **parts):
    figure = small_figure(shapes=sprites, ground="tiles", **parts)
    return ElementTree.fromstring(figure.render_svg())


def transforms(svg):
    return [g.get("transform") for g in svg.iter(f"{SVG}g") if g.get("transform")]


def drawn(svg):
    """What is used, from below to above, without definitions."""
    return [use.get("href").removeprefix("#") for use in svg.iter(f"{SVG}use")]


def test_an_outline_stands_once_however_often_its_thing_is_placed():
    svg = picture(*(cart((x, 0, a)) for x in (-0.5, 0, 0.5)), cart((0, 0.5, 0), look="ghost"))
    paths = [path.get("d") for path in svg.find(f"{SVG}defs").iter(f"{SVG}path")]
    assert paths.count(SPOT.path) == paths.count(SQUARE.path) == 2  # one as a ghost's silhouette
    assert len(drawn(svg)) == 3 * 3 + 3 + 3  # and the silhouettes of the ghost's three sprites


def test_a_thing_stands_at_its_place_turned_as_angles_count():
    """In the picture y points down; the sprites in it keep the sprite's own metres."""
    svg = picture(cart((0.25, -0.5, sp.pi / 2), size=2))
    width = float(svg.get("width"))
    outer, *inner = (t for t in transforms(svg) if "rotate" in t)
    x, y, angle, right, up = map(float, re.findall(r"-?[\d.]+", outer))
    assert (x, y) == pytest.approx((0.625 * width, 0.75 * width), abs=0.01)
    assert (angle, right, up) == (-90, width, -width)  # 2 m of view, twice as large
    assert inner[0].startswith("translate(0 0.1) rotate(28.65)")  # 0.5 rad


def test_a_place_that_is_no_number_hides_a_thing():
    hidden = sp.Piecewise((0, a > 2), (sp.nan, True))
    assert drawn(picture(cart((hidden, 0, 0)))) == []
    inside = Sprite((0, 0, 0), (SQUARE, Sprite((hidden, 0, 0), (SPOT,))))
    assert len(drawn(picture(inside))) == 1


def rim_places(rolled):
    roll = sp.Float(rolled) * a / a
    wheel = Sprite((0, 0, 0), (SQUARE, Rim(0.1, 12, (SPOT,), roll)))
    texts = (use.get("transform") for use in picture(wheel).iter(f"{SVG}use"))
    rows = [[float(x) for x in re.findall(r"-?[\d.]+(?:e-?\d+)?", t)] for t in texts if t]
    return sorted(math.atan2(x / 0.1, cos) for cos, _, _, _, x, _ in rows if cos > 0.05)


def test_what_is_on_a_rim_runs_as_the_wheel_rolls():
    """By the rolled way over the radius; what has run off below comes back above."""
    apart = 2 * math.pi / 12
    for rolled in (0.0, 0.02, 0.03, 0.1 * apart, -0.02):
        angles = np.array(rim_places(rolled))
        off = (angles - rolled / 0.1 + apart / 2) % apart - apart / 2
        np.testing.assert_allclose(off, 0, atol=1e-3)  # five digits in the picture
        np.testing.assert_allclose(np.diff(angles), apart, atol=2e-3)
        assert len(angles) >= 5  # those on top, of twelve


def test_a_shadow_falls_to_the_right_and_down_however_its_thing_turns():
    for turn in (0, 1, 3):
        svg = picture(cart((0, 0, turn), height=0.05))
        shadow, sprite = (t for t in transforms(svg) if "scale" in t)
        (x, y), (x0, y0) = (map(float, re.findall(r"-?[\d.]+", t)[:2]) for t in (shadow, sprite))
        assert x > x0
        assert y > y0


def test_a_ghost_and_a_wrong_thing_throw_no_shadow_and_have_a_line_round_them():
    for look, paint in (("ghost", "fill:none"), ("wrong", "fill:url(#rk-hatch)")):
        svg = picture(cart((0, 0, 0), height=0.05, look=look))
        styles = [g.get("style", "") for g in svg.iter(f"{SVG}g")]
        assert sum(style.startswith(paint) for style in styles) == 1
        assert not any("--rk-soft" in style for style in styles)


def test_a_picture_defines_what_it_uses_and_nothing_else():
    """The gradients are found by the figure's name: a page has many pictures."""
    svg = picture(Sprite((0, 0, 0), (Outline("M0 0h1", "tyre", "edge"),)))
    text = ElementTree.tostring(svg, "unicode")
    used = set(re.findall(r"url\(#([\w-]+)\)", text))
    defined = {e.get("id") for e in svg.find(f"{SVG}defs") if e.tag.endswith("Gradient")}
    assert used == defined == {"rk-tyre", "rk-pool"}


def test_a_notebook_keeps_the_outlines_digits():
    """Lines in pixels are rounded there; outlines are in metres."""
    svg = compact_svg(small_figure(shapes=(cart((0, 0, 0)),)).render_svg())
    assert SQUARE.path in svg
    assert "var(" not in svg


def test_an_unknown_material_is_refused():
    jelly = Sprite((0, 0, 0), (Outline("M0 0", "jelly"),))
    with pytest.raises(CourseError, match=r"no material 'jelly'; .*tyre"):
        _ = small_figure(shapes=(jelly,)).code


def test_an_unknown_look_is_refused():
    with pytest.raises(CourseError, match="looks 'pale'; it can look ghost, wrong"):
        cart((0, 0, 0), look="pale")


def test_a_scale_bar_is_as_long_as_a_tile():
    svg = picture(cart((0, 0, 0)), view=(-1, 1, -1, 1))
    (words,) = [text.text for text in svg.iter(f"{SVG}text")]
    number, unit = words.split()
    long = float(number) * {"cm": 0.01, "m": 1}[unit] * float(svg.get("width")) / 2
    bars = [p.get("d") for p in svg.iter(f"{SVG}path") if p.get("d", "").startswith("M14 ")]
    assert float(re.search(r"h([\d.]+)", bars[0])[1]) == pytest.approx(long, abs=0.01)
