"""Links to the book as PDF on its first page, if `make paper` has written them.

The directive `{paper}` links the files beside the folder of the site, which are copied into it.
"""

import shutil
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

FILES = {
    "robokin.pdf": "PDF",
    "robokin-without-answers.pdf": "PDF without answers",
}


class Paper(SphinxDirective):
    """A line with links to the whole book."""

    def run(self):
        """Return the line, and have the page read again when a file changes or appears."""
        folder = Path(self.env.app.outdir).parent
        for name in FILES:
            self.env.note_dependency(str(folder / name))
        return [nodes.raw("", render_line(folder), format="html")]


def render_line(folder):
    """Return the line, or "" without files."""
    links = " · ".join(
        f'<a href="{name}" download>{kind}, {(folder / name).stat().st_size / 1e6:.1f} MB</a>'
        for name, kind in FILES.items()
        if (folder / name).is_file()
    )
    words = "The whole book to print"
    return f'<p class="site-paper">{words}: {links}</p>\n' if links else ""


def copy_files(app, error):
    """Copy the files into the site, in place of those of earlier builds."""
    if not error and app.builder.name == "html":
        for name in FILES:
            file, target = Path(app.outdir).parent / name, Path(app.outdir, name)
            target.unlink(missing_ok=True)
            if file.is_file():
                shutil.copy(file, target)


def setup(app):
    """Register the directive with Sphinx."""
    app.add_directive("paper", Paper)
    app.connect("build-finished", copy_files)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
