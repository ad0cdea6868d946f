"""The course's looks, for the script that draws and for the style sheet."""

from typing import Any

from courseware.course import course


def collect_constants() -> dict[str, Any]:
    """Return the looks as the script needs them."""
    kinds = {
        name: {"light": s.light, "dash": list(s.dash), "width": s.width, "marker": s.marker}
        for name, s in course().looks.items()
    }
    return {"KINDS": kinds}


def render_rules() -> str:
    """Return the style rules: the kinds' colours on light and on dark pages."""
    light, dark = (
        " ".join(f"--rk-{name}: {getattr(s, page)};" for name, s in course().looks.items())
        for page in ("light", "dark")
    )
    on_dark = 'html[data-theme="dark"], [data-jp-theme-light="false"], .vscode-dark'
    return f":root {{ {light} }}\n{on_dark} {{ {dark} }}\n"
