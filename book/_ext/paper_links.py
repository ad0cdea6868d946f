"""The book as PDF and EPUB on its first page, where `make paper` has made them before.

The directive `{paper}` links what stands beside the folder of the site, and is nothing where
nothing stands there; the files are copied into the site.
"""

import shutil
from pathlib import Path

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

FILES = {
    "robokin.pdf": "PDF",
    "robokin-without-answers.pdf": "PDF without answers",
    "robokin.epub": "EPUB",
}


class Paper(SphinxDirective):
    """A line with links to the whole book; the page is read again when that changes."""

    def run(self):
        """Link what there is; a file that is not there is looked for in each build."""
        folder = Path(self.env.app.outdir).parent
        for name in FILES:
            self.env.note_dependency(str(folder / name))
        return [nodes.raw("", line(folder), format="html")]


def line(folder):
    """Return the line, or nothing where there is nothing to link."""
    links = " · ".join(
        f'<a href="{name}" download>{kind}, {(folder / name).stat().st_size / 1e6:.1f} MB</a>'
        for name, kind in FILES.items()
        if (folder / name).is_file()
    )
    words = "The whole book to print, or for an e-reader"
    return f'<p class="site-paper">{words}: {links}</p>\n' if links else ""


def copy_files(app, error):
    """Put what is linked into the site, and nothing that was made earlier."""
    if not error and app.builder.name == "html":
        for name in FILES:
            file, target = Path(app.outdir).parent / name, Path(app.outdir, name)
            target.unlink(missing_ok=True)
            if file.is_file():
                shutil.copy(file, target)


def setup(app):
    """Called by Sphinx."""
    app.add_directive("paper", Paper)
    app.connect("build-finished", copy_files)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
