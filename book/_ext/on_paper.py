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


class Links(nodes.General, nodes.Element):
    """Where the links stand: which there are is known when the page is written."""


class Paper(SphinxDirective):
    """A line with links to the whole book."""

    def run(self):
        """The place of the line."""
        return [Links()]


def made(app):
    """The files that there are."""
    files = (Path(app.outdir).parent / name for name in FILES)
    return [file for file in files if file.is_file()]


def visit_links(writer, node):
    """The line, if there is anything to link."""
    links = " · ".join(
        f'<a href="{file.name}" download>{FILES[file.name]}, {file.stat().st_size / 1e6:.1f} MB</a>'
        for file in made(writer.builder.app)
    )
    if links:
        words = "The whole book to print, or for an e-reader"
        writer.body.append(f'<p class="site-paper">{words}: {links}</p>\n')
    raise nodes.SkipNode


def copy_files(app, exception):
    """Put what is linked into the site, and nothing that was made earlier."""
    if not exception and app.builder.name == "html":
        for name in FILES:
            Path(app.outdir, name).unlink(missing_ok=True)
        for file in made(app):
            shutil.copy(file, app.outdir)


def setup(app):
    """Pages are written again when the files change."""
    app.add_node(Links, html=(visit_links, None))
    app.add_directive("paper", Paper)
    changed = [[file.name, file.stat().st_mtime] for file in made(app)]
    app.add_config_value("paper_made", changed, "html", list)
    app.connect("build-finished", copy_files)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
