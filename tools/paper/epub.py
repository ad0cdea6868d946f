"""The book as an EPUB 3, a page for each page of the site; formulas are MathML.

It needs no script: numbers under a formula and readouts of a figure are text.
"""

import re
import uuid
from datetime import UTC, datetime
from html import escape, unescape
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile

from courseware.figures.figure import inline_colors
from paper.pages import HERE, SITE, read_pages

KINDS = {".png": "image/png", ".svg": "image/svg+xml", ".jpg": "image/jpeg"}
IMAGE = re.compile(r'<img [^>]*?src="([^"]+)"')
LIGHT = re.compile(r'^html\[data-theme="light"\] (\.highlight .*)$', re.M)

CONTAINER = """<?xml version="1.0" encoding="UTF-8"?>
<container version="1.0" xmlns="urn:oasis:names:tc:opendocument:xmlns:container">
<rootfiles><rootfile full-path="book/package.opf" media-type="application/oebps-package+xml"/>
</rootfiles></container>
"""
PACKAGE = """<?xml version="1.0" encoding="UTF-8"?>
<package xmlns="http://www.idpf.org/2007/opf" version="3.0" unique-identifier="id" xml:lang="en">
<metadata xmlns:dc="http://purl.org/dc/elements/1.1/">
<dc:identifier id="id">urn:uuid:{identifier}</dc:identifier>
<dc:title>{title}</dc:title>
<dc:creator>{author}</dc:creator>
<dc:language>en</dc:language>
<dc:description>{claim}</dc:description>
<dc:rights>{rights}</dc:rights>
<meta property="dcterms:modified">{modified}</meta>
<meta property="schema:accessMode">textual</meta>
<meta property="schema:accessMode">visual</meta>
<meta property="schema:accessibilityFeature">MathML</meta>
<meta property="schema:accessibilityFeature">tableOfContents</meta>
<meta property="schema:accessibilityHazard">none</meta>
</metadata>
<manifest>
<item id="nav" href="nav.xhtml" media-type="application/xhtml+xml" properties="nav"/>
<item id="style" href="style.css" media-type="text/css"/>
<item id="cover" href="cover.png" media-type="image/png" properties="cover-image"/>
{items}
</manifest>
<spine>
<itemref idref="nav"/>
{spine}
</spine>
</package>
"""
DOCUMENT = """<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE html>
<html xmlns="http://www.w3.org/1999/xhtml" xmlns:epub="http://www.idpf.org/2007/ops" lang="en" xml:lang="en">
<head><title>{title}</title><link rel="stylesheet" href="style.css"/></head>
<body>
{body}
</body></html>
"""  # noqa: E501
COVER = """<body style="margin: 0; height: 100vh; display: grid; place-content: center; gap: 40px;
font: 30px sans-serif; text-align: center; background: #fff; color: #16202c">
<div style="font-size: 100px; font-weight: 700">{title}</div>
<div style="width: 560px; margin: auto">{claim}</div></body>"""


def render_contents(given):
    """Return the list of parts, pages and their sections."""
    lines, part = [], ""
    for page in given:
        if page.part != part:
            lines.append(("</ol></li>\n" if part else "") + f"<li><span>{page.part}</span><ol>")
            part = page.part
        first, *others = (
            f'<a href="{page.name}.xhtml#{each["id"]}">{escape(each["title"])}</a>'
            for each in page.titles
        )
        below = "".join(f"<li>{each}</li>" for each in others)
        lines.append(f"<li>{first}{f'<ol>{below}</ol>' if below else ''}</li>")
    inner = "\n".join(lines) + ("</ol></li>" if part else "")
    return f'<nav epub:type="toc" id="toc"><h1>Contents</h1><ol>\n{inner}\n</ol></nav>'


def render_package(book, given, pictures):
    """Return the list of all files and the order of the pages."""
    items, spine = [], []
    for page in given:
        has = [name for name in ("svg", "mathml") if f"<{name.removesuffix('ml')}" in page.body]
        properties = f' properties="{" ".join(has)}"' if has else ""
        kind = "application/xhtml+xml"
        items.append((page.name, f"{page.name}.xhtml", kind, properties))
        spine.append(f'<itemref idref="page-{page.name}"/>')
    for count, name in enumerate(pictures):
        items.append((f"picture-{count}", name, KINDS[name[name.rindex(".") :]], ""))
    return PACKAGE.format(
        identifier=uuid.uuid5(uuid.NAMESPACE_URL, f"{book.title} {book.version}"),
        title=escape(book.title),
        author=escape(book.author),
        claim=escape(book.claim),
        rights=escape(unescape(re.sub(r"<[^>]+>", "", book.rights))),
        modified=datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ"),
        items="\n".join(
            f'<item id="page-{i}" href="{name}" media-type="{kind}"{properties}/>'
            for i, name, kind, properties in items
        ),
        spine="\n".join(spine),
    )


def render_cover(browser, book):
    """Return the picture for a shelf: title and claim."""
    tab = browser.new_page(viewport={"width": 1000, "height": 1500})
    tab.set_content(COVER.format(title=escape(book.title), claim=escape(book.claim)))
    picture = tab.screenshot()
    tab.close()
    return picture


def read_style():
    """Return our own rules, and the colours of code as on a light page of the site."""
    colours = LIGHT.findall((SITE / "_static" / "pygments.css").read_text("utf-8"))
    return "\n".join([(HERE / "epub.css").read_text("utf-8"), *colours])


def write(browser, book, file):
    """Write the EPUB and return the number of its pages."""
    options = {"link": "PAGE.xhtml#ID", "folder": "", "mathml": True, "folds": "kept"}
    given = read_pages(browser, book.solutions, **options)
    pictures = sorted({name for page in given for name in IMAGE.findall(page.body)})
    with ZipFile(file, "w", ZIP_DEFLATED) as archive:
        archive.writestr("mimetype", "application/epub+zip", ZIP_STORED)  # first, as it is
        archive.writestr("META-INF/container.xml", CONTAINER)
        archive.writestr("book/package.opf", render_package(book, given, pictures))
        archive.writestr(
            "book/nav.xhtml", DOCUMENT.format(title="Contents", body=render_contents(given))
        )
        archive.writestr("book/style.css", read_style())
        archive.writestr("book/cover.png", render_cover(browser, book))
        for page in given:
            text = DOCUMENT.format(title=escape(page.title), body=inline_colors(page.body))
            archive.writestr(f"book/{page.name}.xhtml", text)
        for name in pictures:
            archive.write(SITE / name, f"book/{name}")
    return len(given)
