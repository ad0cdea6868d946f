"""Figures on a page of their own, without building the book: _build/figures.html.

.venv/bin/python tools/show_figures.py tips arc
"""

import sys
from pathlib import Path

from courseware.figures.figure import find_figure, render_outlines
from courseware.script import parts

PAGE = Path("_build/figures.html")


def main(names):
    figures = [find_figure(name) for name in names]
    body = render_outlines(figures) + "".join(figure.render_html() for figure in figures)
    codes = ", ".join(figure.code for figure in figures)
    script = f"window.coursewareFigures = [{codes}]; {parts.bundle_page(parts.list_parts())}"
    theme = "document.documentElement.dataset.theme = this.checked ? 'dark' : 'light'"
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(
        f"<!doctype html><meta charset='utf-8'><meta name='viewport' content='width=device-width'>"
        f"<title>{', '.join(names)}</title><style>{parts.join_styles()} body {{ max-width: 50rem; "
        f"margin: 1rem auto; background: var(--rk-ground, #fff); color: var(--rk-text) }}</style>"
        f'<label><input type="checkbox" onchange="{theme}"> dark</label>{body}'
        f"<script>{script}</script>",
        "utf-8",
    )
    print(f"open {PAGE}")


if __name__ == "__main__":
    import book  # noqa: F401 (opens the course)

    main(sys.argv[1:])
