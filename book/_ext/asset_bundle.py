"""One style sheet and one script for all pages; rules and letters that no page uses are left out.

Pages name the version of both before the sheet is reduced: it changes with the parts.
"""

import re
from functools import cache
from html.parser import HTMLParser
from itertools import pairwise
from operator import attrgetter
from pathlib import Path

from fontTools import subset
from tinycss2 import parse_stylesheet, serialize

from courseware.script.modules import SPARE

SHEET, SCRIPT = "all.css", "all.js"
# loaded by the theme's templates, so that Sphinx does not list them
FIRST_SHEETS = ("_static/basic.css", "_static/styles/pydata-sphinx-theme.css")
LAST_SCRIPTS = ("_static/scripts/bootstrap.js", "_static/scripts/pydata-sphinx-theme.js")
PAGE_SCRIPTS = ("_static/pages/", "_static/courseware/")
PRIORITY = attrgetter("priority")  # Sphinx sorts by it, but later than this
# Where the theme has a page laid out while it loads, and what stands there instead.
MEASURED = "e.tabIndex=e.scrollWidth>e.clientWidth||e.scrollHeight>e.clientHeight?0:-1"
LAYOUTS = {
    # it measures every box of a page: not those that are far away
    MEASURED: f"e.checkVisibility({{contentVisibilityAuto:true}})&&({MEASURED})",
    # and where its second header bar ends, which `layout.html` leaves out
    'document.getElementsByClassName("bd-header")[0].getBoundingClientRect()': "{bottom:0}",
}
# the fonts of formulas that most pages need, and their paths
FONT = re.compile(
    r"@font-face\{[^}]*url\((katex/fonts/KaTeX_(?:AMS|Main|Math)-(?:Regular|Bold|Italic))\.woff2\)[^}]*"
)
GROUPS = ("media", "supports", "layer", "container")


def link_bundles(app, pagename, templatename, context, doctree):
    """Have a page load the bundles, and the scripts of its own."""
    files = (sorted(context[kind], key=PRIORITY) for kind in ("css_files", "script_files"))
    sheets, scripts = ({file.filename: file for file in each if file.filename} for each in files)
    sheet, script = sheets.pop(f"_static/{SHEET}"), scripts.pop(f"_static/{SCRIPT}")
    scripts.pop("_static/sphinx_highlight.js", None)  # of Sphinx's own search
    own = [name for name in scripts if name.startswith(PAGE_SCRIPTS)]
    context["css_files"] = [sheet]
    context["script_files"] = [script, *(scripts.pop(name) for name in own)]
    app.builder.sheets = (*FIRST_SHEETS, *sheets)
    write_bundles(Path(app.outdir), app.builder.sheets, (*scripts, *LAST_SCRIPTS))


@cache
def write_bundles(folder, sheets, scripts):
    """Write both, once in a build, so that pages can name their versions."""
    (folder / "_static" / SHEET).write_text(join_files(folder, sheets), "utf-8")
    script = SPARE.sub("", join_files(folder, scripts, ";"))
    for code, instead in LAYOUTS.items():
        assert code in script, f"the theme's scripts do not hold this any more: {code}"
        script = script.replace(code, instead)
    (folder / "_static" / SCRIPT).write_text(script, "utf-8")


def join_files(folder, names, end=""):
    """Return the files as one; those of MyST-NB exist when all pages are written."""
    files = [folder / name for name in names if (folder / name).exists()]
    return f"{end}\n".join(file.read_text("utf-8") for file in files)


def reduce_sheet(app, error):
    """Write the sheet without rules for classes that no page or file of ours names, and fonts."""
    if error or not hasattr(app.builder, "sheets"):  # no page was written
        return
    folder = Path(app.outdir)
    found, letters, pages = ClassCollector(), set(), folder.rglob("*.html")
    for page in (page for page in pages if not page.is_relative_to(folder / "lite")):
        text = page.read_text("utf-8")
        found.feed(text)
        letters.update(text)
    own = (SCRIPT, "courseware/*.js", "courseware.css", "site.css")  # scripts join some names
    for file in (file for name in own for file in folder.glob(f"_static/{name}")):
        found.names.update(re.findall(r"[\w-]+", file.read_text("utf-8")))
    for file in folder.glob("_static/pages/*.js"):
        letters.update(file.read_text("utf-8"))
    css = filter_rules(join_files(folder, app.builder.sheets), found.names)
    css = css.replace("url(fonts/", "url(katex/fonts/")
    css = FONT.sub(lambda rule: split_font(folder / "_static", rule, letters), css)
    (folder / "_static" / SHEET).write_text(css, "utf-8")


def split_font(static, rule, letters):
    """Write a font with these letters only, half as heavy; return the rules for it and the whole.

    The whole one comes for another letter, which only a reader's own program shows.
    """
    name = rule[1]
    options = subset.Options(flavor="woff2", layout_features=["*"], name_IDs=["*"])
    font = subset.load_font(static / f"{name}.woff2", options)
    known = font.getBestCmap().keys()
    used = known & set(map(ord, letters))
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=used)
    subsetter.subset(font)
    subset.save_font(font, static / f"{name}-used.woff2", options)
    return (
        f"{rule[0]};unicode-range:{write_ranges(known - used)}}}\n"
        f"{rule[0].replace(name, f'{name}-used')};unicode-range:{write_ranges(used)}"
    )


def write_ranges(codes):
    """Return codes of letters as a style sheet names them."""
    starts = sorted(code for code in codes if code - 1 not in codes)
    ends = sorted(code for code in codes if code + 1 not in codes)
    return ",".join(f"U+{start:X}-{end:X}" for start, end in zip(starts, ends, strict=True))


class ClassCollector(HTMLParser):
    """Collects the classes of pages."""

    def __init__(self):
        super().__init__()
        self.names = set()

    def handle_starttag(self, tag, attributes):
        """Add the classes of an element."""
        self.names.update((dict(attributes).get("class") or "").split())


def filter_rules(css, names):
    """Return the rules for elements with these classes, without the icon font.

    `site.css` replaces that. Left out are also corners of cells that depend on what is beside them:
    whatever a figure changes, a browser would look for such cells around it.
    """
    kept = []
    for rule in parse_stylesheet(css, skip_comments=True, skip_whitespace=True):
        if rule.type == "qualified-rule":
            needed = [
                each for each in split_selectors(rule) if names.issuperset(find_classes(each))
            ]
            head = ",".join(serialize(each).strip() for each in needed)
        else:
            head = f"@{rule.at_keyword}{serialize(rule.prelude).rstrip()}"
        group = rule.type == "at-rule" and rule.at_keyword in GROUPS
        body = filter_rules(rule.content, names) if group else serialize(rule.content or ()).strip()
        icon = head.startswith(".fa-") and ".fas" not in head and "--icon" not in body  # ours
        slow = head.startswith("div.cell:has(> *")
        font = head == "@font-face" and "Awesome" in body
        if head and body and not (icon or slow or font):
            kept.append(f"{head}{{{body}}}")
    return "\n".join(kept)


def split_selectors(rule):
    """Yield the selectors of a rule, which commas separate."""
    selector = []
    for token in rule.prelude:
        if token == ",":
            yield selector
            selector = []
        elif token.type != "comment":
            selector.append(token)
    yield selector


def find_classes(selector):
    """Return the classes that a selector needs, without those in parentheses."""
    return [name.value for dot, name in pairwise(selector) if dot == "." and name.type == "ident"]


def setup(app):
    """Register the bundles with Sphinx."""
    app.add_css_file(SHEET)
    app.add_js_file(SCRIPT, priority=100, loading_method="defer")
    app.connect("html-page-context", link_bundles, priority=960)  # after all that adds some
    app.connect("build-finished", reduce_sheet, priority=950)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
