"""The course's looks and materials, for the script that draws and for the style sheet."""

from collections.abc import Iterator
from typing import Any

from courseware.course import course
from courseware.figures.sprites import Gradient

DARK = 'html[data-theme="dark"], [data-jp-theme-light="false"], .vscode-dark'


def collect_constants() -> dict[str, Any]:
    """Return looks and materials as the script needs them."""
    kinds = {
        name: {"light": s.light, "dash": list(s.dash), "width": s.width, "marker": s.marker}
        for name, s in course().looks.items()
    }
    materials = course().materials
    return {
        "KINDS": kinds,
        "TONES": {name: light for name, (light, _) in materials.tones.items()},
        "GRADIENTS": {name: _render_gradient(name, g) for name, g in materials.gradients.items()},
        "GROUNDS": {name: vars(ground) for name, ground in materials.grounds.items()},
    }


TAGS = {"x": ("linear", ""), "y": ("linear", ' x2="0" y2="1"'), "r": ("radial", "")}


def _render_gradient(name: str, gradient: Gradient) -> str:
    tag, way = TAGS[gradient.way]
    stops = ((*stop, 1)[:3] for stop in gradient.stops)
    inside = "".join(
        f'<stop offset="{part}" style="stop-color:{_tone(tone)};stop-opacity:{opacity}"/>'
        for part, tone, opacity in stops
    )
    return f'<{tag}Gradient id="rk-{name}"{way}>{inside}</{tag}Gradient>'


def _tone(name: str) -> str:
    return f"var(--m-{name},{course().materials.tones[name][0]})"


def render_rules() -> str:
    """Return the style rules: all colours on light and on dark pages."""
    light, dark = (" ".join(_list_colors(page)) for page in (0, 1))
    return f":root {{ {light} }}\n{DARK} {{ {dark} }}\n"


def _list_colors(page: int) -> Iterator[str]:
    for name, look in course().looks.items():
        yield f"--rk-{name}: {(look.light, look.dark)[page]};"
    for name, tones in course().materials.tones.items():
        yield f"--m-{name}: {tones[page]};"
