"""The fonts of formulas made small: each with the signs that stand on pages, and once whole.

A browser fetches the small one; the whole one only for a sign that no page has, such as a cell may
show that is changed and run. The small one says by `unicode-range` which signs it is for.
"""

import hashlib
import html
import logging
import re
from pathlib import Path

from fontTools.subset import Subsetter
from fontTools.ttLib import TTFont

FACE = re.compile(r"@font-face\{[^}]*(?=\})")
SMALL = "pages-"  # how the name of a small font begins


def signs_of(folder):
    """The numbers of all signs that stand on the site's pages."""
    texts = {file.read_text("utf-8") for file in folder.rglob("*.html")}
    return {ord(sign) for text in texts for sign in set(html.unescape(text))}


def ranges(signs):
    """Numbers of signs as a style sheet names them."""
    runs = []
    for sign in sorted(signs):
        if runs and sign == runs[-1][1] + 1:
            runs[-1][1] = sign
        else:
            runs.append([sign, sign])
    return ",".join(f"U+{first:X}-{last:X}" for first, last in runs)


def write_small(file, signs):
    """The font beside it that has these signs only."""
    font = TTFont(file, recalcTimestamp=False)  # the same bytes each time
    subsetter = Subsetter()
    subsetter.populate(unicodes=signs)
    subsetter.subset(font)
    font.flavor = "woff2"
    font.save(file.with_name(SMALL + file.name))


def faces(sheet, signs):
    """The sheet with a small face behind each whole one: the last that is for a sign is taken."""
    here = ranges(signs)
    version = hashlib.sha256(here.encode()).hexdigest()[:8]

    def both(found):
        small = re.sub(r"url\(fonts/([^)]+)", rf"url(fonts/{SMALL}\1?v={version}", found[0])
        return f"{found[0]}}}{small};unicode-range:{here}"

    return FACE.sub(both, sheet)


def make_small(app, error):
    """Write the fonts, and have KaTeX's style sheet name them."""
    if error or app.builder.format != "html":
        return
    folder = Path(app.outdir, "_static", "katex")
    signs = signs_of(Path(app.outdir))
    for file in sorted(folder.glob("fonts/KaTeX_*.woff2")):
        write_small(file, signs)
    sheet = folder / "katex.min.css"  # as KaTeX has it: it was copied anew
    sheet.write_text(faces(sheet.read_text("utf-8"), signs), "utf-8")


def setup(app):
    """Called by Sphinx; before the sheets become one."""
    # a11y_pygments, which the theme brings, turns all logs on; fontTools tells of each table
    logging.getLogger("fontTools").setLevel(logging.WARNING)
    app.connect("build-finished", make_small, priority=940)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
