"""What a page waits for before it shows, made little: one style sheet without the rules of the
theme that no page uses, and scripts that wait for the page; what all pages need is one script.
"""

import hashlib
import re
from itertools import pairwise
from pathlib import Path

from theme import UNUSED
from tinycss2 import parse_stylesheet, serialize

# in the order in which pages ask for them
THEME = (
    "basic.css",
    "styles/pydata-sphinx-theme.css",
    "pygments.css",
    "styles/sphinx-book-theme.css",
    "katex/katex.min.css",
    "copybutton.css",
    "mystnb.*.css",
)
OWN = ("workshop.css", "site.css")  # whose classes are put together in scripts: kept whole
SHEET = "all.css"

# in the order in which pages ask for them
SCRIPTS = (
    "documentation_options.js",
    "doctools.js",
    "clipboard.min.js",
    "copybutton.js",
    "scripts/sphinx-book-theme.js",
    "site.js",
    "search.js",
    "scripts/bootstrap.js",
    "scripts/pydata-sphinx-theme.js",
)
SCRIPT = "all.js"

LINKS = re.compile(r'(\s*<link [^>]*href="([^"]*)_static/[^"]*\.css[^>]*>)+')
TAGS = re.compile(r'\s*<script [^>]*?(src="([^"]*)_static/(?!start-)([^"?]+)[^"]*")></script>')
NOW = re.compile("<img (?!loading=)")
SIZED = re.compile(r'<img (?=[^>]*style="width: (\d+)px; height: (\d+)px;")(?![^>]* width=)')
ADDRESS = re.compile(r"url\((?![\"']?(?:data:|[./]*/|#))([\"']?)")
GROUPS = ("media", "supports", "layer", "container")


def used_rules(css, names):
    """The rules that an element with classes among these names may need; without names, all."""
    kept = []
    for rule in parse_stylesheet(css, skip_comments=True, skip_whitespace=True):
        if rule.content is None:  # an @import or @charset
            continue
        if at := rule.type == "at-rule":
            head = f"@{rule.at_keyword}{serialize(rule.prelude).rstrip()}"
        else:
            needed = [s for s in selectors(rule) if not names or names.issuperset(classes(s))]
            head = ",".join(map(written, needed))
        group = at and rule.at_keyword in GROUPS
        body = used_rules(rule.content, names) if group else written(rule.content)
        if head and body:
            kept.append(f"{head}{{{body}}}")
    return "\n".join(kept)


def written(tokens):
    """A part of a style sheet as text, without comments."""
    return serialize(token for token in tokens if token.type != "comment").strip()


def selectors(rule):
    """The selectors of a rule, which commas part."""
    parts = [[]]
    for token in rule.prelude:
        if token == ",":
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def classes(selector):
    """The classes that an element must have, or one around it; what stands in brackets is more
    than that."""
    return [name.value for dot, name in pairwise(selector) if dot == "." and name.type == "ident"]


def names_in(pages, scripts):
    """Every class of the pages, and every word of the scripts, which may set it."""
    found = {name for page in pages for each in re.findall(r'class="([^"]*)"', page)
             for name in each.split()}  # fmt: skip
    return found.union(*(re.findall(r"[\w-]+", script) for script in scripts))


def sheet(static, names):
    """All style sheets as one; addresses in them are from its place."""
    parts = []
    for pattern in (*THEME, *OWN):
        for file in sorted(static.glob(pattern)):
            css = file.read_text("utf-8")
            folder = file.parent.relative_to(static).as_posix()
            if folder != ".":
                css = ADDRESS.sub(rf"url(\1{folder}/", css)
            parts.append(used_rules(css, () if pattern in OWN else names))
    return "\n".join(parts)


def make_light(app, error):
    """Write the sheet, and have every page ask for it alone."""
    if error or app.builder.format != "html":
        return
    folder, static = Path(app.outdir), Path(app.outdir, "_static")
    files = [file for file in folder.rglob("*.html") if static not in file.parents]
    pages = {file: file.read_text("utf-8") for file in files}
    scripts = [*static.glob("*.js"), *static.glob("scripts/*.js"), *static.glob("workshop/*.js")]
    texts = [file.read_text("utf-8") for file in scripts if file.name != "search-data.js"]
    sheet_version = version_of(static / SHEET, sheet(static, names_in(pages.values(), texts)))
    script_version = version_of(static / SCRIPT, script(static))
    link = rf'\n  <link rel="stylesheet" href="\g<2>_static/{SHEET}?v={sheet_version}" />'
    for file, text in pages.items():
        text = SIZED.sub(r'<img width="\1" height="\2" ', text)  # its place is kept until it comes
        text = NOW.sub('<img loading="lazy" ', text)
        file.write_text(scripts_last(one_link(text, link), script_version), "utf-8")


def script(static):
    """The scripts of all pages as one. Between two stands what would end the first."""
    files = [static / name for name in SCRIPTS]
    return "\n;".join(file.read_text("utf-8") for file in files if file.exists())


def version_of(file, text):
    """A few letters that say which version of a file is written here."""
    file.write_text(text, "utf-8")
    return hashlib.sha256(text.encode()).hexdigest()[:8]


def one_link(text, link):
    """A page with one link to a sheet where the first one was."""
    first = LINKS.search(text)
    if not first:
        return text
    return text[: first.start()] + first.expand(link) + LINKS.sub("", text[first.end() :])


def scripts_last(text, version):
    """A page that asks for its scripts at its end, so that its text and its sheet come before them;
    first for the one that all pages share."""
    found = TAGS.findall(text)
    if not found:
        return text
    own = [source for source, _, name in found if name not in (*SCRIPTS, *UNUSED, SCRIPT)]
    sources = [f'src="{found[0][1]}_static/{SCRIPT}?v={version}"', *own]
    tags = "".join(f"  <script defer {source}></script>\n" for source in sources)
    return TAGS.sub("", text).replace("</body>", f"{tags}</body>")


def setup(app):
    """Called by Sphinx; after all pages and scripts are as they will be."""
    app.connect("build-finished", make_light, priority=950)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
