"""What the figures' script and style need of the course: how its kinds of things look."""

from typing import Any

from courseware.course import course


def constants() -> dict[str, Any]:
    """The looks, for the script that draws."""
    kinds = {
        name: {"light": s.light, "dash": list(s.dash), "width": s.width, "marker": s.marker}
        for name, s in course().looks.items()
    }
    return {"KINDS": kinds}


def rules() -> str:
    """The kinds' colours on light and on dark pages."""
    light = " ".join(f"--rk-{name}: {s.light};" for name, s in course().looks.items())
    dark = " ".join(f"--rk-{name}: {s.dark};" for name, s in course().looks.items())
    on_dark = 'html[data-theme="dark"], [data-jp-theme-light="false"], .vscode-dark'
    return f":root {{ {light} }}\n{on_dark} {{ {dark} }}\n"
