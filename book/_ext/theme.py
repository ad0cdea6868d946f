"""Repairs of the pinned theme and its helpers, each for one defect; see the README."""

import functools
import shutil
import subprocess
import textwrap
from importlib.metadata import version
from pathlib import Path

from docutils import nodes

DESCRIPTION_LENGTH = 160  # characters that search engines show
# files of the theme that no page uses: 5.7 MB
UNUSED = (
    "vendor/fontawesome",
    "scripts/fontawesome.js",
    "scripts/fontawesome.js.LICENSE.txt",
    "**/*.map",
)


def add_description(app, pagename, templatename, context, doctree):
    """Add addresses and a description: the page's own, its first paragraph, or the book's."""
    paragraphs = (
        paragraph.astext()
        for paragraph in (doctree.findall(nodes.paragraph) if doctree else ())
        if isinstance(paragraph.parent, nodes.section) and not any(paragraph.findall(nodes.math))
    )
    own = app.env.metadata.get(pagename, {}).get("description")
    text = own or next(paragraphs, app.config.site_description)
    context["description"] = textwrap.shorten(text, DESCRIPTION_LENGTH, placeholder=" …")
    address = context["site_address"] = app.config.html_baseurl.rstrip("/") + "/"
    if pagename == app.config.root_doc and app.config.html_baseurl:
        context["pageurl"] = address  # the page is `index.html`, too


def add_version(app, pagename, templatename, context, doctree):
    """Add what the foot of a page says."""
    context |= {"author": app.config.author, "course_version": version("robokin")}
    context["course_date"] = find_date(app.srcdir)


@functools.cache
def find_date(folder):
    """Return the day of the last commit, or "" where there is no repository."""
    command = ["git", "-C", folder, "log", "-1", "--format=%cs"]
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.strip()
    except OSError:  # no Git
        return ""


def repair_names(app, pagename, templatename, context, doctree):
    """Add the names and roles for screen readers that axe asks for."""
    if "body" in context:  # of a bibliography (docutils) and of a folded cell (myst-nb)
        body = context["body"].replace('role="doc-biblioentry"', 'role="listitem"')
        context["body"] = body.replace('<summary aria-label="Toggle hidden content">', "<summary>")
    if menu := context.get("generate_toctree_html"):  # its arrows have no text
        named = '<summary aria-label="Pages below this one">'
        context["generate_toctree_html"] = lambda *arguments, **options: str(
            menu(*arguments, **options)
        ).replace("<summary>", named)


def visit_image(writer, node):
    """Write an image that loads when it is near; its size keeps its place until then."""
    node["loading"] = "lazy"
    type(writer).visit_image(writer, node)
    if "width" in node and "height" in node:
        size = (f'{name}="{node[name].removesuffix("px")}"' for name in ("width", "height"))
        writer.body[-1] = writer.body[-1].replace("<img ", f"<img {' '.join(size)} ", 1)


def remove_unused(app, error):
    """Remove files that no page uses from the built site."""
    static = Path(app.outdir, "_static")
    for target in [each for name in UNUSED for each in static.glob(name)]:
        shutil.rmtree(target) if target.is_dir() else target.unlink()


def copy_first_page(app, error):
    """Make `index.html` the first page itself; Jupyter Book's own only redirects."""
    if not error and app.builder.name == "html":
        shutil.copy(Path(app.outdir, f"{app.config.root_doc}.html"), Path(app.outdir, "index.html"))


def forget_failed_build(app, error):
    """Have everything read again after a warning, or the next build would not warn."""
    if error or app._warncount:
        Path(app.doctreedir, "environment.pickle").unlink(missing_ok=True)


def setup(app):
    """Register the repairs with Sphinx."""
    app.add_config_value("site_description", "", "html", str)
    app.add_css_file("site.css", priority=900)
    # first: it removes what other scripts had made in a page that was saved
    app.add_js_file("site.js", priority=200, loading_method="defer")
    app.add_node(nodes.image, override=True, html=(visit_image, None))
    app.connect("html-page-context", add_description, priority=900)
    app.connect("html-page-context", add_version)
    app.connect("html-page-context", repair_names, priority=900)
    app.connect("build-finished", remove_unused)
    app.connect("build-finished", copy_first_page, priority=900)
    app.connect("build-finished", forget_failed_build)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
