"""Files of the built site."""

from pathlib import Path

from sphinx.application import Sphinx


def write_static(app: Sphinx, name: str, text: str) -> None:
    """Write a file in the site's `_static`."""
    file = Path(app.outdir) / "_static" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
