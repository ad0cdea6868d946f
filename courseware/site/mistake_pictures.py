"""Still pictures of mistakes: a figure of the chapter with the mistake chosen."""

from tinycss2 import parse_stylesheet, serialize

from courseware.figures.figure import find_figure
from courseware.practice.mistakes import Picture
from courseware.script import parts

DARK = 'html[data-theme="dark"]'


def dark_colours() -> str:
    """Return the custom properties of figures on a dark page."""
    rules = parse_stylesheet(parts.join_styles("figures"), skip_comments=True, skip_whitespace=True)
    dark = (serialize(r.content).strip() for r in rules if serialize(r.prelude).startswith(DARK))
    return " ".join(text for text in dark if text.startswith("--"))


def draw_picture(picture: Picture) -> str:
    """Return the picture as an SVG file; its address ends in #dark for a dark page."""
    svg = find_figure(picture.figure).render_svg(mistake=picture.option)
    tag, _, content = svg.partition(">")
    style = f"<style>#dark:target {{ {dark_colours()} }}</style>"
    return tag.replace("<svg", '<svg id="dark"', 1) + f">{style}{content}"
