"""Still pictures of mistakes: a figure of the chapter, set to what the mistake makes of it."""

import re
from dataclasses import replace

from workshop.figures.declaration import Choice
from workshop.figures.figure import find
from workshop.practice.bank import Picture
from workshop.script import runtime

DARK = re.compile(r'html\[data-theme="dark"\][^{}]*\{((?:\s*--[\w-]+:[^;{}]+;)+)')


def still(picture: Picture) -> str:
    """The picture as an SVG file of its own; its address ends in #dark for a dark page."""
    figure = find(picture.figure)
    controls = tuple(
        replace(control, start=picture.option)
        if isinstance(control, Choice) and control.name == "mistake"
        else control
        for control in figure.controls
    )
    colours = "".join(DARK.findall(runtime.rules("figures")))
    head = rf'<svg id="dark"\1><style>#dark:target {{{colours}}}</style>'
    return re.sub("<svg([^>]*)>", head, replace(figure, controls=controls).picture(), count=1)
