"""Search by section, for a reader who types: the sections of the book as data for MiniSearch.

A section's title, text and code stand apart, so that titles count more than prose, and prose more
than code. Exercises, mistakes, functions and terms of the glossary are entries of their own.
Nothing is asked of a server: `search.js` loads the data when a reader starts to search, from disk
too.
"""

import json
import posixpath
import re
from pathlib import Path

from bs4 import BeautifulSoup
from docutils import nodes
from myst_nb.sphinx_ import SelectMimeType
from sphinx import addnodes

from courseware.equations.text import GREEK

NAMES = {"sin", "cos", "tan", "cot", "arctan", "det"}
UNREAD = ["checks"]  # formulas of the chapters once more
# what no reader sees, or nobody looks for
UNSEEN = "style, script, svg, button, label, [hidden]"


def plain(tex):
    """TeX as a reader would type it: θ for a Greek letter, a/b for a fraction."""
    tex = re.sub(r"\\(begin|end)\{\w+\}|\[\d+pt\]", " ", tex)
    text = re.sub(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", r"\1/\2", tex)
    text = re.sub(r"\\([A-Za-z]+)", lambda m: GREEK.get(m[1], m[1] if m[1] in NAMES else " "), text)
    return re.sub(r"\\.|[{}&^]", " ", text)


def plain_words(raw):
    """The text of HTML, which is parsed already or not yet."""
    soup = BeautifulSoup(raw, "html.parser") if isinstance(raw, str) else raw
    for unseen in soup.select(UNSEEN):
        unseen.decompose()
    return soup.get_text(" ")


def squeezed(parts):
    """In one line."""
    return re.sub(r" (?=[.,:;)])", "", " ".join(" ".join(parts).split()))


class Reader:
    """Collects the entries of one page."""

    def __init__(self, page, titles):
        self.page, self.title, self.titles = page, titles[page].astext(), titles
        self.entries = []

    def add(self, anchor, title, **fields):
        """An entry; what is empty is left out."""
        entry = {"page": self.page, "at": anchor, "title": title, "of": self.title, **fields}
        self.entries.append({key: value for key, value in entry.items() if value})

    def section(self, section, top):
        """A section without those inside it, which are entries of their own."""
        words = {"terms": [], "text": [], "code": []}
        for child in section.children[1:]:
            self.read(child, words)
        title = section.next_node(nodes.title).astext()
        anchor = "" if top else section["ids"][0]
        self.add(anchor, title, **{field: squeezed(parts) for field, parts in words.items()})

    def read(self, node, words):
        """Sort a node's words: what a chapter explains stands in italics."""
        if isinstance(node, nodes.section):
            self.section(node, top=False)
        elif isinstance(node, addnodes.pending_xref) and not node["refexplicit"]:
            words["text"].append(self.link(node))
        elif isinstance(node, nodes.Text):
            words["text"].append(node.astext())
        elif isinstance(node, nodes.literal_block):
            words["code"].append(node.astext())
        elif isinstance(node, nodes.math | nodes.math_block):
            words["text"].append(plain(node.astext()))
        elif isinstance(node, nodes.raw):
            self.raw(node.astext(), words["text"])
        elif isinstance(node, addnodes.desc):
            self.function(node)
        elif isinstance(node, nodes.definition_list_item) and node.next_node(nodes.term)["ids"]:
            self.term(node)
        elif isinstance(node, nodes.container) and "rk-mistake" in node["classes"]:
            words_of = [plain_words(part.astext()) for part in node.children]  # HTML and code
            self.add(node["ids"][0], f"Mistake {node['ids'][0]}", text=squeezed(words_of))
        elif not isinstance(node, nodes.Invisible):
            words["terms"] += [node.astext()] if isinstance(node, nodes.emphasis) else []
            for child in node.children:
                self.read(child, words)

    def link(self, node):
        """What a link without own words says: a page's title, or author and year of a book."""
        if node["reftype"] == "doc":
            page = posixpath.normpath(
                posixpath.join(posixpath.dirname(self.page), node["reftarget"])
            )
            return self.titles[page].astext()
        if node["refdomain"] == "cite":
            return re.sub(r"([a-z]+)(\d+)", lambda m: f"{m[1].title()} {m[2]}", node.astext())
        return node.astext()

    def raw(self, source, text):
        """An exercise is an entry; a figure says what it shows."""
        soup = BeautifulSoup(source, "html.parser")
        exercise, figure = soup.select_one(".rk-exercise[id]"), soup.find("figure")
        if exercise:
            name = exercise["id"]
            self.add(name, f"Exercise {name}", text=squeezed([plain_words(exercise)]))
        elif figure:
            shown = figure.select_one("[role=img][aria-label], [role=group][aria-label]")
            text.append(shown["aria-label"] if shown else "")
        else:
            text.append(plain_words(soup))

    def function(self, desc):
        """A function, or a class, of the library."""
        signature = desc.next_node(addnodes.desc_signature)
        content = desc.next_node(addnodes.desc_content)
        if signature["ids"]:
            name = signature["ids"][0].removeprefix("robokin.")
            self.add(signature["ids"][0], name, text=squeezed([content.astext()]))

    def term(self, item):
        """A term of the glossary."""
        names = [term.astext() for term in item.findall(nodes.term)]
        words = {"terms": [], "text": [], "code": []}
        self.read(item.next_node(nodes.definition), words)
        text = squeezed(words["text"])
        self.add(item.next_node(nodes.term)["ids"][0], ", ".join(names), text=text)


def entries(env):
    """All of the book."""
    found = []
    for page in sorted(env.found_docs - set(UNREAD)):
        document = env.get_doctree(page)
        SelectMimeType(document).run()  # of an output that is stored in several forms, one
        reader = Reader(page, env.titles)
        reader.section(document.next_node(nodes.section), top=True)
        found += reader.entries
    return found


def write(app, error):
    """The data, beside `search.js`."""
    if error or app.builder.format != "html":
        return
    data = json.dumps(entries(app.env), ensure_ascii=False, separators=(",", ":"))
    file = Path(app.outdir, "_static", "search-data.js")
    file.write_text(f"siteSearch.buildIndex({data});\n", "utf-8")


def replace_own(app):
    """Sphinx's own search stays out: no index, and the page of results is this book's."""
    app.builder.search = False


def setup(app):
    """Called by Sphinx."""
    app.connect("builder-inited", replace_own)
    app.connect("build-finished", write)
    app.add_js_file("search.js", loading_method="defer")
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
