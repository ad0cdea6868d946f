"""The book as a PDF, printed by Chromium in two documents: the contents and the text.

The contents need the page numbers of the text, which its outline holds once it is printed. Lines of
the contents link to addresses until both are joined.
"""

import logging
import re
from html import escape
from io import BytesIO

from pypdf import PdfReader, PdfWriter
from pypdf.constants import PageLabelStyle
from pypdf.generic import ArrayObject, FloatObject, NameObject, TextStringObject

from paper.pages import BUILD, HERE, SITE, read_pages

WORK = BUILD / "paper"
HOME = "https://book/"  # of links of the contents, until they lead into the text
DOCUMENT = """<!DOCTYPE html>
<html lang="en" data-theme="light"><head><meta charset="utf-8"/><title>{title}</title>
{links}
<style>{style}</style></head>
<body>
{body}
</body></html>
"""
FRONT = """<section class="bd-article" id="front"><h1>{title}</h1>
<p>This is the book on paper: the figures are shown as they start. On the site they move.</p>
<footer>{rights}</footer></section>
<section class="bd-article" id="contents"><h1>Contents</h1><div>
{lines}
</div></section>"""


# the title of a page runs at its heads: a page of paper has its name
HEAD = (
    '#{name} {{ page: {name}; }} @page {name} {{ @top-right {{ content: "{title}"; }} }}\n'
    "@page {name}:first {{ @top-right {{ content: none; }} }}"
)


def print_document(browser, name, **parts):
    """Print a document."""
    WORK.mkdir(parents=True, exist_ok=True)
    file = WORK / f"{name}.html"
    file.write_text(DOCUMENT.format(**parts), "utf-8")
    tab = browser.new_page()
    tab.goto(file.as_uri())
    tab.evaluate("() => document.fonts.ready")
    data = tab.pdf(outline=True, tagged=True, prefer_css_page_size=True)
    tab.close()
    return PdfReader(BytesIO(data))


def read_outline(reader, entries=None, level=1):
    """Yield (level, title, page from 0, height on it) of the entries of the first two levels."""
    for entry in reader.outline if entries is None else entries:
        if isinstance(entry, list):
            if level < 2:
                yield from read_outline(reader, entry, level + 1)
        else:
            yield level, undouble(entry.title), reader.get_destination_page_number(entry), entry.top


def undouble(title):
    """Return a title once: Chromium writes one twice that a page break has moved."""
    half = title[: len(title) // 2]
    return half if title == half * 2 else title


def repair_outline(item):
    """Have the titles below an item of the outline once."""
    below = item.get("/First")
    while below:
        entry = below.get_object()
        entry[NameObject("/Title")] = TextStringObject(undouble(entry["/Title"]))
        repair_outline(entry)
        below = entry.get("/Next")


def render_contents(entries, parts):
    """Return the lines of the contents with their page numbers."""
    lines, part = [], ""
    chapters = iter(parts)
    for place, (level, title, page, _) in enumerate(entries):
        if level == 1 and (new := next(chapters)) != part:
            part = new
            lines.append(f'<p class="paper-part">{escape(part)}</p>')
        lines.append(
            f'<p class="paper-line paper-{level}"><a href="{HOME}{place}"><span>{escape(title)}'
            f"</span><i></i><span>{page + 1}</span></a></p>"
        )
    return "\n".join(lines)


def join_documents(front, text, entries, title):
    """Join contents and text, and link them."""
    logging.getLogger("pypdf").setLevel(logging.ERROR)  # it warns of objects that it adds itself
    writer = PdfWriter(clone_from=text)
    repair_outline(writer.root_object.get("/Outlines", {}))
    before = len(front.pages)
    writer.merge(0, front, import_outline=False)
    for page in writer.pages[:before]:
        for link in page.get("/Annots", []):
            link = link.get_object()
            place = int(link.pop("/A")["/URI"].removeprefix(HOME))
            _, _, number, top = entries[place]
            target = writer.pages[before + number].indirect_reference
            height = [FloatObject(x) for x in (0, top, 0)]
            link[NameObject("/Dest")] = ArrayObject([target, NameObject("/XYZ"), *height])
    writer.set_page_label(0, before - 1, PageLabelStyle.LOWERCASE_ROMAN)
    writer.set_page_label(before, len(writer.pages) - 1, PageLabelStyle.DECIMAL)
    writer.add_metadata({"/Title": title})
    return writer


def write(browser, front, file, solutions, folds_open):
    """Write a PDF and return the number of its pages. front: title and rights."""
    given = read_pages(browser, solutions, folds_open)
    links = max((page.styles for page in given), key=len)
    links = "\n".join(f'<link rel="stylesheet" href="{escape(each)}"/>' for each in links)
    own = (HERE / "pdf.css").read_text("utf-8")
    heads = "\n".join(HEAD.format(name=p.name, title=re.sub(r'["\\]', "", p.title)) for p in given)
    body = "\n".join(page.body for page in given)
    title = front["title"]
    text = print_document(browser, "text", title=title, links=links, style=own + heads, body=body)
    entries = list(read_outline(text))
    lines = render_contents(entries, [page.part for page in given])
    body = FRONT.format(**front, lines=lines)
    contents = print_document(browser, "front", title=title, links=links, style=own, body=body)
    writer = join_documents(contents, text, entries, title)
    writer.write(file)
    return len(writer.pages)


def print_poster(browser, file, size):
    """Print the site's poster on a sheet of some size."""
    tab = browser.new_page()
    poster = (SITE / "poster.svg").read_text("utf-8")
    tab.set_content(f"<style>body {{ margin: 0 }} body > svg {{ width: 100vw }}</style>{poster}")
    tab.pdf(path=file, format=size, print_background=True)
    tab.close()
