"""One style sheet for all pages, without the rules that none of them uses, and one script.

Pages name the version of both before the sheet is made smaller: it changes with the parts.
"""

import re
from functools import cache
from html.parser import HTMLParser
from itertools import pairwise
from operator import attrgetter
from pathlib import Path

from tinycss2 import parse_stylesheet, serialize

SHEET, SCRIPT = "all.css", "all.js"
# what the theme's templates ask for, besides what Sphinx lists
FIRST_SHEETS = ("_static/basic.css", "_static/styles/pydata-sphinx-theme.css")
LAST_SCRIPTS = ("_static/scripts/bootstrap.js", "_static/scripts/pydata-sphinx-theme.js")
OF_A_PAGE = ("_static/pages/", "_static/courseware/")
PRIORITY = attrgetter("priority")  # the order in which Sphinx lists them, later than this
GROUPS = ("media", "supports", "layer", "container")


def link_bundles(app, pagename, templatename, context, doctree):
    """Have the page ask for the bundles, and for the scripts that it alone has."""
    files = (sorted(context[kind], key=PRIORITY) for kind in ("css_files", "script_files"))
    sheets, scripts = ({file.filename: file for file in each if file.filename} for each in files)
    sheet, script = sheets.pop(f"_static/{SHEET}"), scripts.pop(f"_static/{SCRIPT}")
    scripts.pop("_static/sphinx_highlight.js", None)  # of Sphinx's own search
    own = [name for name in scripts if name.startswith(OF_A_PAGE)]
    context["css_files"] = [sheet]
    context["script_files"] = [script, *(scripts.pop(name) for name in own)]
    app.builder.sheets = (*FIRST_SHEETS, *sheets)
    write_bundles(Path(app.outdir), app.builder.sheets, (*scripts, *LAST_SCRIPTS))


@cache
def write_bundles(folder, sheets, scripts):
    """Write both, once a build, so that pages can name their versions."""
    (folder / "_static" / SHEET).write_text(joined(folder, sheets), "utf-8")
    (folder / "_static" / SCRIPT).write_text(joined(folder, scripts, ";"), "utf-8")


def joined(folder, names, end=""):
    """Return the files as one; those of MyST-NB come when all pages are written."""
    files = [folder / name for name in names if (folder / name).exists()]
    return f"{end}\n".join(file.read_text("utf-8") for file in files)


def write_used(app, error):
    """Write the sheet without rules for classes that no page and nothing of our own names."""
    if error or not hasattr(app.builder, "sheets"):  # no page was written
        return
    folder = Path(app.outdir)
    found, pages = Classes(), folder.rglob("*.html")
    for page in (page for page in pages if not page.is_relative_to(folder / "lite")):
        found.feed(page.read_text("utf-8"))
    own = (SCRIPT, "courseware/*.js", "courseware.css", "site.css")  # scripts join some names
    for file in (file for name in own for file in folder.glob(f"_static/{name}")):
        found.names.update(re.findall(r"[\w-]+", file.read_text("utf-8")))
    css = used_rules(joined(folder, app.builder.sheets), found.names)
    css = css.replace("url(fonts/", "url(katex/fonts/")
    (folder / "_static" / SHEET).write_text(css, "utf-8")


class Classes(HTMLParser):
    """Collects the classes of pages."""

    def __init__(self):
        super().__init__()
        self.names = set()

    def handle_starttag(self, tag, attributes):
        """Take those of an element."""
        self.names.update((dict(attributes).get("class") or "").split())


def used_rules(css, names):
    """Return the rules that an element with classes among these may need.

    Without the icon font, which `site.css` replaces.
    """
    kept = []
    for rule in parse_stylesheet(css, skip_comments=True, skip_whitespace=True):
        if rule.type == "qualified-rule":
            needed = [each for each in selectors(rule) if names.issuperset(classes(each))]
            head = ",".join(serialize(each).strip() for each in needed)
        else:
            head = f"@{rule.at_keyword}{serialize(rule.prelude).rstrip()}"
        group = rule.type == "at-rule" and rule.at_keyword in GROUPS
        body = used_rules(rule.content, names) if group else serialize(rule.content or ()).strip()
        icon = head.startswith(".fa-") and ".fas" not in head and "--icon" not in body  # ours
        if head and body and not icon and not (head == "@font-face" and "Awesome" in body):
            kept.append(f"{head}{{{body}}}")
    return "\n".join(kept)


def selectors(rule):
    """Yield the selectors of a rule, which commas part."""
    selector = []
    for token in rule.prelude:
        if token == ",":
            yield selector
            selector = []
        elif token.type != "comment":
            selector.append(token)
    yield selector


def classes(selector):
    """Return the classes that a selector needs; those in brackets are more than that."""
    return [name.value for dot, name in pairwise(selector) if dot == "." and name.type == "ident"]


def setup(app):
    """Called by Sphinx."""
    app.add_css_file(SHEET)
    app.add_js_file(SCRIPT, priority=100, loading_method="defer")
    app.connect("html-page-context", link_bundles, priority=960)  # after all that adds some
    app.connect("build-finished", write_used, priority=950)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
