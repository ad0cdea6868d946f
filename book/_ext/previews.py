"""A picture for each page that a message shows which links to it: the page's first figure, or its
title over that of the first page.

Only where the site's address is known (`html_baseurl`), because such pictures need whole addresses;
and, always, the icon for the home screens of phones.
"""

import html
import re
from functools import cache
from pathlib import Path

import matplotlib
from resvg_py import svg_to_bytes

from workshop.figures.figure import find, plain
from workshop.site.files import FIGURE

WIDE, HIGH = 1200, 630  # pixels, as networks ask for
OPENING = "park"  # the figure of the first page
FONTS = Path(matplotlib.get_data_path(), "fonts", "ttf")
ICON, ICON_SIZE = "icon.png", 180


def drawn(svg, width):
    """A picture as PNG, the same on every machine."""
    fonts = [str(file) for file in FONTS.glob("DejaVuS*.ttf")]
    return svg_to_bytes(
        svg_string=svg,
        width=width,
        font_files=fonts,
        skip_system_fonts=True,
        sans_serif_family="DejaVu Sans",
        serif_family="DejaVu Serif",
    )


@cache
def preview(name, title=""):
    """A figure in the middle of a wide picture, below a title if there is one."""
    top = 150 if title else 0
    place = f'y="{top}" width="{WIDE}" height="{HIGH - top}"'
    figure = plain(find(name).picture(HIGH))
    svg = f"""<svg xmlns="http://www.w3.org/2000/svg" width="{WIDE}" height="{HIGH}">
<rect width="100%" height="100%" fill="#fff"/>
<text x="50%" y="100" font-family="DejaVu Sans" text-anchor="middle"
    font-size="{min(56, WIDE / (0.7 * len(title) + 1)):.0f}">{html.escape(title)}</text>
{re.sub(r'width="[^"]*" height="[^"]*"', place, figure, count=1)}</svg>"""
    return drawn(svg, WIDE)


def add_preview(app, pagename, templatename, context, doctree):
    """The picture of a page, and its address in the page's head."""
    icon = context["pathto"](f"_static/{ICON}", resource=True)
    tags = [f'<link rel="apple-touch-icon" href="{icon}" />']
    if doctree and app.config.html_baseurl:
        found = FIGURE.search(context.get("body", ""))
        title = html.unescape(re.sub(r"<[^>]+>", "", context["title"]))
        named = [found[1]] if found else [OPENING, title]
        name = f"_static/previews/{found[1] if found else pagename.replace('/', '-')}.png"
        file = Path(app.outdir, name)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(preview(*named))
        tags += [
            f'<meta property="og:image" content="{app.config.html_baseurl}{name}" />',
            f'<meta property="og:image:width" content="{WIDE}" />',
            f'<meta property="og:image:height" content="{HIGH}" />',
            '<meta name="twitter:card" content="summary_large_image" />',
        ]
    context["metatags"] = "\n".join([context.get("metatags", ""), *tags])


def write_icon(app, error):
    """The site's icon for those who cannot show SVG."""
    if not error and app.builder.format == "html":
        svg = Path(__file__).parents[1].joinpath("_assets", "favicon.svg").read_text("utf-8")
        Path(app.outdir, "_static", ICON).write_bytes(drawn(svg, ICON_SIZE))


def setup(app):
    """Called by Sphinx."""
    app.connect("html-page-context", add_preview, priority=950)
    app.connect("build-finished", write_icon)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
