"""The one script and the one style sheet that every live figure shares."""

import json
from functools import cache
from importlib.resources import files

from robokin.styles import KINDS

EXPORTS = (
    "f compute vector startState svg html says onPage inNotebook toValues fromAddress toAddress"
)


@cache
def runtime() -> str:
    """The script that a page loads once: functions, renderer, and the table of kinds."""
    here = files("robokin.live")
    kinds = {
        name: {"light": s.light, "dash": list(s.dash), "width": s.width, "marker": s.marker}
        for name, s in KINDS.items()
    }
    parts = [
        '"use strict";\nconst robokin = (() => {',
        f"const KINDS = {json.dumps(kinds)};",
        here.joinpath("functions.js").read_text(encoding="utf-8"),
        here.joinpath("figure.js").read_text(encoding="utf-8"),
        f"return {{ {', '.join(EXPORTS.split())} }};",
        "})();",
    ]
    return "\n".join(parts)


def stylesheet() -> str:
    """The look of the figures, and the kinds' colours on light and dark pages."""
    look = files("robokin.live").joinpath("live.css").read_text(encoding="utf-8")
    dark = 'html[data-theme="dark"] .rk-figure, [data-jp-theme-light="false"] .rk-figure'
    light_colors = " ".join(f"--rk-{name}: {s.light};" for name, s in KINDS.items())
    dark_colors = " ".join(f"--rk-{name}: {s.dark};" for name, s in KINDS.items())
    return (
        f"{look}.rk-figure {{ {light_colors} }}\n"
        f"{dark}, .vscode-dark .rk-figure {{ {dark_colors} }}\n"
    )
