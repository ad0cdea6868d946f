"""The looks of the course: colours that are seen, and told apart."""

import re

import numpy as np
import pytest
import sympy as sp
from figure_numbers import each_figure, kind_of
from support import contrast

from book.things.materials import MATERIALS
from courseware.course import course
from courseware.script import parts
from robokin.styles import KINDS


def grounds():
    """The ground behind the figures on light and on dark pages, from the style sheet."""
    light, dark = re.findall(r"--rk-ground: (#\w+)", parts.join_styles())
    return light, dark


SEEN = {  # linear RGB as seen without red or green cones: Machado, Oliveira, Fernandes (2009)
    "protan": [(0.152, 1.053, -0.205), (0.115, 0.786, 0.099), (-0.004, -0.048, 1.052)],
    "deutan": [(0.367, 0.861, -0.228), (0.280, 0.673, 0.047), (-0.012, 0.043, 0.969)],
}


def lab(color, seen):
    """CIELAB of a colour as such a reader sees it."""
    channels = np.array([int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    linear = np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)
    xyz = np.array([(0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505)])
    white = xyz.sum(axis=1)
    x, y, z = np.cbrt(np.clip(xyz @ np.clip(np.array(seen) @ linear, 0, 1) / white, 0.009, 1))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


@pytest.mark.parametrize("page", ["light", "dark"])
@pytest.mark.parametrize("seen", SEEN.values(), ids=SEEN)
def test_the_axes_of_a_frame_are_told_apart(seen, page):
    """By dashes, and z from the others by its colour, too."""
    axes = [KINDS[kind] for kind in ("x_axis", "y_axis", "z_axis")]
    assert len({style.dash for style in axes}) == 3
    x, y, z = (lab(getattr(style, page), seen) for style in axes)
    assert min(np.linalg.norm(z - x), np.linalg.norm(z - y)) >= 40  # 2 is just visible


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "grid"])  # grid: decoration
def test_every_kind_stands_out(kind):
    light, dark = grounds()
    style = KINDS[kind]
    assert style.light != style.dark
    assert min(contrast(style.light, light), contrast(style.dark, dark)) >= 3  # WCAG 1.4.11


@each_figure
def test_labels_are_legible(figure):
    light, dark = grounds()
    if figure.ground:
        light, dark = MATERIALS.tones[MATERIALS.grounds[figure.ground].tone]
    for shape in figure.shapes:
        if getattr(shape, "label", "") or isinstance(getattr(shape, "kind", ""), sp.Symbol):
            style = KINDS[kind_of(figure, shape)]
            readable = min(contrast(style.light, light), contrast(style.dark, dark))
            assert readable >= 4.5, shape  # WCAG 1.4.3, for text


@pytest.mark.parametrize("chapter", course().modules("formulas"))
def test_letters_can_be_read_where_they_are_lit(chapter):
    light, dark = re.findall(r"--rk-lit: (#\w+)", parts.join_styles())
    for kind in getattr(course().module(chapter, "formulas"), "LOOKS", {}).values():
        readable = min(contrast(KINDS[kind].light, light), contrast(KINDS[kind].dark, dark))
        assert readable >= 4.5, kind  # WCAG 1.4.3, for text


@each_figure
def test_an_index_is_written_the_same_way_everywhere(figure):
    """As in θ_1, which is set like the formula's; the sign ₁ would be another letter."""
    parts = (*figure.controls, *figure.readouts, *figure.shapes)
    labels = "".join(str(getattr(part, "label", "")) for part in parts)
    assert not set("₀₁₂₃₄₅₆₇₈₉") & set(labels)


def test_the_ring_stands_out():
    light, dark = re.findall(r"--rk-accent: (#\w+)", parts.join_styles())
    assert min(contrast(c, g) for c, g in zip((light, dark), grounds(), strict=True)) >= 3
