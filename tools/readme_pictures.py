"""The pictures of README.md: a figure in its start position, light and dark.

python tools/readme_pictures.py       into .github, after a change of the figure
"""

from pathlib import Path

import book  # noqa: F401 - opens the course
from courseware.figures.figure import find_figure
from courseware.site.mistake_pictures import dark_colours

FIGURE = "tips"
WIDTH = 736  # pixels, as wide as a page shows it
FOLDER = Path(__file__).parents[1] / ".github"


def render_pictures():
    """Return the pictures as SVG, by the names of their files."""
    light = find_figure(FIGURE).render_svg(WIDTH)
    dark = light.replace(">", f"><style>:root {{ {dark_colours()} }}</style>", 1)
    return {"figure-light.svg": f"{light}\n", "figure-dark.svg": f"{dark}\n"}


if __name__ == "__main__":
    for name, svg in render_pictures().items():
        (FOLDER / name).write_text(svg, "utf-8")
