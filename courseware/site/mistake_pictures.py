"""Still pictures of mistakes: a figure of the chapter with the mistake chosen."""

import re

from courseware.course import course, get_members
from courseware.errors import CourseError
from courseware.figures import Figure
from courseware.practice.mistakes import Mistake
from courseware.script import parts

DARK = re.compile(r'html\[data-theme="dark"\][^{}]*\{\s*(--[^}]*)\}')


def dark_colours() -> str:
    """Return the custom properties of figures on a dark page."""
    return " ".join(map(str.strip, DARK.findall(parts.join_styles("figures"))))


def find_mistake_figure(mistake: Mistake) -> Figure:
    """Return the figure of the mistake's chapter that has the mistake as an option."""
    home = course().find_chapter("exercises", mistake)
    module = course().module(home, "figures")
    for figure in get_members(module, Figure) if module else ():
        if any(mistake.title in getattr(c, "options", ()) for c in figure.controls):
            return figure
    raise CourseError(
        f"{course().find_place(home, 'exercises', mistake.name)}: {mistake.name} has no picture: "
        f"declare a figure of {home} with a Choice named mistake and the option {mistake.title!r}"
    )


def draw_picture(mistake: Mistake) -> str:
    """Return the picture as an SVG file; its address ends in #dark for a dark page."""
    svg = find_mistake_figure(mistake).render_svg(mistake=mistake.title)
    tag, _, content = svg.partition(">")
    style = f"<style>#dark:target {{ {dark_colours()} }}</style>"
    return tag.replace("<svg", '<svg id="dark"', 1) + f">{style}{content}"
