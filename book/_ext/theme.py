"""What this site changes in its theme: fewer bytes, a description, a build that stays honest."""

import hashlib
import html
import re
import shutil
from pathlib import Path

from docutils import nodes

from workshop.site.run import allowed

BOOK = Path(__file__).parents[1]
ASSETS = BOOK / "_assets"
# what a page may load and run: the site's own files, nothing that is written in the page; a page
# with code also the Python that *Run* loads
POLICY = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:"
DESCRIPTION_LENGTH = 160  # what search engines show

# what the theme puts in the site and no page of it uses
UNUSED = [
    "vendor/fontawesome",
    "scripts/fontawesome.js",
    "scripts/fontawesome.js.LICENSE.txt",
    "searchtools.js",  # the search is our own
    "language_data.js",
    "sphinx_highlight.js",
]
ICON_RULE = re.compile(r"(?<=[{}/])(?:\.fa-[a-z0-9-]+(?:::?before|::?after)?,?)+\{[^{}]*\}")
FONT_FACE = re.compile(r"@font-face\{[^{}]*\}")


# --- description ----------------------------------------------------------------------------


def shortened(text, length):
    """The text in one line, cut at a word."""
    text = " ".join(text.split())
    if len(text) <= length:
        return text
    return text[: length - 1].rsplit(" ", 1)[0].rstrip(",;:.- ") + "…"


def first_paragraph(doctree):
    """The first paragraph of the text that holds no formula, or nothing."""
    for paragraph in doctree.findall(nodes.paragraph):
        in_text = isinstance(paragraph.parent, nodes.section)
        if in_text and next(paragraph.findall(nodes.math), None) is None:
            return paragraph.astext()
    return ""


def add_description(app, pagename, templatename, context, doctree):
    """A description: the page's own (front matter), its first paragraph, or the book's; and what
    a message shows that links the page."""
    own = app.env.metadata.get(pagename, {}).get("description", "")
    text = own or (first_paragraph(doctree) if doctree else "") or app.config.site_description
    title = html.escape(html.unescape(re.sub(r"<[^>]+>", "", context.get("title", ""))))
    told = html.escape(shortened(text, DESCRIPTION_LENGTH))
    policy = POLICY + allowed(app, context.get("body", ""))
    tags = [
        f'<meta http-equiv="Content-Security-Policy" content="{policy}" />',
        f'<meta name="description" content="{told}" />',
        f'<meta property="og:title" content="{title or app.config.html_title}" />',
        f'<meta property="og:description" content="{told}" />',
        f'<meta property="og:site_name" content="{app.config.html_title}" />',
        '<meta property="og:type" content="article" />',
    ]
    if pagename == app.config.root_doc and app.config.html_baseurl:
        context["pageurl"] = app.config.html_baseurl  # it is `index.html`, too
    if context.get("pageurl"):
        tags.append(f'<meta property="og:url" content="{context["pageurl"]}" />')
    context["metatags"] = "\n".join([context.get("metatags", ""), *tags])


# --- roles ----------------------------------------------------------------------------------


def renew_roles(app, pagename, templatename, context, doctree):
    """What a screen reader is told: docutils gives entries of a bibliography a role that has gone
    out of use, and myst-nb a folded cell another name than the one that can be read."""
    if "body" in context:
        body = context["body"].replace('role="doc-biblioentry"', 'role="listitem"')
        context["body"] = body.replace('<summary aria-label="Toggle hidden content">', "<summary>")


def name_folds(app, pagename, templatename, context, doctree):
    """The arrows that unfold the menu have no text: give them a name."""
    menu = context.get("generate_toctree_html")

    def named_menu(*arguments, **options):
        return str(menu(*arguments, **options)).replace(
            "<summary>", '<summary aria-label="Pages below this one">'
        )

    if menu:
        context["generate_toctree_html"] = named_menu


# --- scripts --------------------------------------------------------------------------------

INLINE = re.compile(r"[ \n]*<script(?: data-cfasync=\"false\")?>(.*?)</script>", re.DOTALL)


def scripts_in_files(app, exception):
    """What the theme writes into its pages as scripts moves to one file, which all pages share."""
    if exception or app.builder.format != "html":
        return
    for page in Path(app.outdir).rglob("*.html"):
        text = page.read_text("utf-8")
        scripts = [s for s in INLINE.findall(text) if "DOCUMENTATION_OPTIONS.pagename" not in s]
        if scripts and "data-content_root" in text:
            page.write_text(with_file(app, text, "\n".join(scripts)), "utf-8")


def with_file(app, text, script):
    """The page with its inline scripts in a file, which comes first; they may not wait."""
    name = f"start-{hashlib.sha256(script.encode()).hexdigest()[:8]}.js"
    Path(app.outdir, "_static", name).write_text(script, "utf-8")
    root = re.search(r'data-content_root="([^"]*)"', text)[1]
    link = f'\n    <script src="{root}_static/{name}"></script>'
    without = INLINE.sub("", INLINE.sub("\0", text, count=1))
    return without.replace("\0", link).replace('onclick="window.print()"', 'data-print="open"')


# --- weight ---------------------------------------------------------------------------------


def slim(css):
    """The theme's style sheet without its icon font: a third of it, compressed."""
    return ICON_RULE.sub("", FONT_FACE.sub("", css))


def drop_unused(app, exception):
    """Take out of the built site what no page uses."""
    if exception or app.builder.format != "html":
        return
    static = Path(app.outdir) / "_static"
    for name in UNUSED:
        target = static / name
        shutil.rmtree(target) if target.is_dir() else target.unlink(missing_ok=True)
    for source_map in static.rglob("*.map"):
        source_map.unlink()
    sheet = static / "styles" / "pydata-sphinx-theme.css"
    sheet.write_text(slim(sheet.read_text("utf-8")), "utf-8")
    for file in [*static.glob("styles/*.css"), *static.glob("scripts/*.js")]:
        drop_map_link(file)


def drop_map_link(file):
    """Browsers with open developer tools ask for the map that is named here."""
    text = file.read_text("utf-8")
    file.write_text(re.sub(r"\n?(//|/\*)# sourceMappingURL=\S+?(\s*\*/|$)", "", text), "utf-8")


# --- first page -----------------------------------------------------------------------------


def first_page(app, exception):
    """`index.html` is the first page itself, not a redirect to it."""
    index = Path(app.outdir) / "index.html"
    if not exception and app.builder.name == "html" and app.config.root_doc != "index":
        shutil.copy(index.with_name(f"{app.config.root_doc}.html"), index)


# --- for those who look for pages --------------------------------------------------------------


def write_sitemap(app, exception):
    """Where the site's address is known (`html_baseurl`), its pages for search engines."""
    base = app.config.html_baseurl
    if exception or app.builder.name != "html" or not base:
        return
    names = [base, *(base + app.builder.get_target_uri(doc) for doc in sorted(app.env.found_docs))]
    urls = "".join(f"<url><loc>{html.escape(name)}</loc></url>" for name in names)
    schema = "http://www.sitemaps.org/schemas/sitemap/0.9"
    head = '<?xml version="1.0" encoding="UTF-8"?>\n'
    Path(app.outdir, "sitemap.xml").write_text(f'{head}<urlset xmlns="{schema}">{urls}</urlset>\n')
    Path(app.outdir, "robots.txt").write_text(f"User-agent: *\nSitemap: {base}sitemap.xml\n")


# --- honest builds --------------------------------------------------------------------------


def forget_failed_build(app, exception):
    """After a warning the next build reads everything again; else it would not warn again."""
    if exception or app._warncount:
        (Path(app.doctreedir) / "environment.pickle").unlink(missing_ok=True)


def sources_digest():
    """Changes with an asset, a template or one of these extensions: pages are then made anew."""
    folders = (ASSETS, BOOK / "_templates", BOOK / "_ext")
    files = sorted(file for each in folders for file in each.rglob("*.*") if file.is_file())
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def setup(app):
    """Register the site's changes."""
    app.add_config_value("site_description", "", "html", str)
    app.add_config_value("site_sources", sources_digest(), "html", str)
    app.add_css_file("site.css", priority=900)
    app.add_js_file("site.js", loading_method="defer")
    app.connect("html-page-context", add_description, priority=900)
    app.connect("html-page-context", renew_roles)
    app.connect("html-page-context", name_folds, priority=900)
    app.connect("build-finished", drop_unused)
    app.connect("build-finished", scripts_in_files)
    app.connect("build-finished", first_page, priority=900)
    app.connect("build-finished", write_sitemap)
    app.connect("build-finished", forget_failed_build)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
