"""Still pictures of mistakes: a figure of the chapter with the mistake chosen."""

import re

from courseware.figures.figure import find_figure
from courseware.practice.mistakes import Picture
from courseware.script import parts

DARK = re.compile(r'html\[data-theme="dark"\][^{}]*\{\s*(--[^}]*)\}')


def dark_colours() -> str:
    """Return the custom properties of figures on a dark page."""
    return " ".join(map(str.strip, DARK.findall(parts.join_styles("figures"))))


def draw_picture(picture: Picture) -> str:
    """Return the picture as an SVG file; its address ends in #dark for a dark page."""
    svg = find_figure(picture.figure).render_svg(mistake=picture.option)
    tag, _, content = svg.partition(">")
    style = f"<style>#dark:target {{ {dark_colours()} }}</style>"
    return tag.replace("<svg", '<svg id="dark"', 1) + f">{style}{content}"
