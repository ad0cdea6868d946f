"""The one script and the one style sheet that all live figures and exercises share."""

import json
from functools import cache
from importlib.resources import files

from workshop.course import course
from workshop.practice import page

EXPORTS = (
    "f compute vector startState svg html says onPage inNotebook toValues fromAddress toAddress "
    "readAnswer dealtVariant checkAnswer exerciseHtml deskHtml exercisesOnPage exerciseInNotebook"
)


PARTS = (
    ("workshop.figures", "functions.js"),
    ("workshop.figures", "figure.js"),
    ("workshop.practice", "reading.js"),
    ("workshop.practice", "practice.js"),
)


@cache
def runtime() -> str:
    """The script that a page loads once: functions, figures, exercises, and what they share."""
    kinds = {
        name: {"light": s.light, "dash": list(s.dash), "width": s.width, "marker": s.marker}
        for name, s in course().looks.items()
    }
    shared = {"KINDS": kinds, **page.constants()}
    constants = (f"const {k} = {json.dumps(v, ensure_ascii=False)};" for k, v in shared.items())
    sources = (files(where).joinpath(name).read_text(encoding="utf-8") for where, name in PARTS)
    parts = ['"use strict";\nconst robokin = (() => {', *constants, *sources]
    return "\n".join([*parts, f"return {{ {', '.join(EXPORTS.split())} }};", "})();"])


def stylesheet() -> str:
    """The look of the figures, and the kinds' colours on light and dark pages."""
    look = "".join(
        files(where).joinpath(name).read_text(encoding="utf-8")
        for where, name in (("workshop.figures", "live.css"), ("workshop.practice", "practice.css"))
    )
    dark = 'html[data-theme="dark"] .rk-figure, [data-jp-theme-light="false"] .rk-figure'
    light_colors = " ".join(f"--rk-{name}: {s.light};" for name, s in course().looks.items())
    dark_colors = " ".join(f"--rk-{name}: {s.dark};" for name, s in course().looks.items())
    return (
        f"{look}.rk-figure {{ {light_colors} }}\n"
        f"{dark}, .vscode-dark .rk-figure {{ {dark_colors} }}\n"
    )
