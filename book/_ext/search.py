"""Data for the search by section, which MiniSearch does in the page.

Titles, text and code are separate fields: titles count more than prose, and prose more than code.
Exercises, mistakes, functions and terms of the glossary are entries of their own. What readers
type and a section does not say is in `search_words.toml`. `search.js` loads the data when a reader
starts to search, from disk too.
"""

import json
import posixpath
import re
import tomllib
from pathlib import Path

from bs4 import BeautifulSoup
from docutils import nodes
from myst_nb.sphinx_ import SelectMimeType
from sphinx import addnodes

from courseware.equations.text import GREEK
from courseware.practice import all_mistakes

NAMES = {"sin", "cos", "tan", "cot", "arctan", "det"}
WORDS = Path(__file__).with_name("search_words.toml")
UNREAD = ["checks"]  # formulas of the chapters once more
UNSEEN = "style, script, svg, button, label, [hidden]"


def simplify_tex(tex):
    """Return TeX as a reader would type it: θ for a Greek letter, a/b for a fraction."""
    tex = re.sub(r"\\(begin|end)\{\w+\}|\\htmlData\{[^{}]*\}|\[\d+pt\]", " ", tex)
    text = re.sub(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", r"\1/\2", tex)
    text = re.sub(r"\\([A-Za-z]+)", lambda m: GREEK.get(m[1], m[1] if m[1] in NAMES else " "), text)
    return re.sub(r"\\.|[{}&^]", " ", text)


def extract_text(raw):
    """Return the visible text of HTML, as a string or parsed."""
    soup = BeautifulSoup(raw, "html.parser") if isinstance(raw, str) else raw
    for unseen in soup.select(UNSEEN):
        unseen.decompose()
    return soup.get_text(" ")


def join_words(parts):
    """Join texts in one line."""
    return re.sub(r" (?=[.,:;)])", "", " ".join(" ".join(parts).split()))


class Reader:
    """Collects the entries of one page."""

    def __init__(self, page, titles):
        self.page, self.title, self.titles = page, titles[page].astext(), titles
        self.entries = []

    def add(self, anchor, title, **fields):
        """Add an entry without its empty fields."""
        entry = {"page": self.page, "at": anchor, "title": title, "of": self.title, **fields}
        self.entries.append({key: value for key, value in entry.items() if value})

    def read_section(self, section, top):
        """Add a section without those inside it, which are entries of their own."""
        words = {"terms": [], "text": [], "code": []}
        for child in section.children[1:]:
            self.read(child, words)
        title = section.next_node(nodes.title).astext()
        anchor = "" if top else section["ids"][0]
        self.add(anchor, title, **{field: join_words(parts) for field, parts in words.items()})

    def read(self, node, words):
        """Sort the words of a node; terms that a chapter explains are in italics."""
        if isinstance(node, nodes.section):
            self.read_section(node, top=False)
        elif isinstance(node, addnodes.pending_xref) and not node["refexplicit"]:
            words["text"].append(self.resolve_link(node))
        elif isinstance(node, nodes.Text):
            words["text"].append(node.astext())
        elif isinstance(node, nodes.literal_block):
            words["code"].append(node.astext())
        elif isinstance(node, nodes.math | nodes.math_block):
            words["text"].append(simplify_tex(node.astext()))
        elif isinstance(node, nodes.raw):
            self.read_html(node.astext(), words["text"])
        elif isinstance(node, addnodes.desc):
            self.read_function(node)
        elif isinstance(node, nodes.definition_list_item) and node.next_node(nodes.term)["ids"]:
            self.read_term(node)
        elif isinstance(node, nodes.container) and "rk-mistake" in node["classes"]:
            words_of = [extract_text(part.astext()) for part in node.children]  # HTML and code
            name = node["ids"][0]
            feedback = all_mistakes()[name].feedback
            self.add(name, f"Mistake {name}", feedback=feedback, code=join_words(words_of))
        elif not isinstance(node, nodes.Invisible | addnodes.only):
            words["terms"] += [node.astext()] if isinstance(node, nodes.emphasis) else []
            for child in node.children:
                self.read(child, words)

    def resolve_link(self, node):
        """Return the text of a link without one: a page's title, or author and year of a book."""
        if node["reftype"] == "doc":
            page = posixpath.normpath(
                posixpath.join(posixpath.dirname(self.page), node["reftarget"])
            )
            return self.titles[page].astext()
        if node["refdomain"] == "cite":
            return re.sub(r"([a-z]+)(\d+)", lambda m: f"{m[1].title()} {m[2]}", node.astext())
        return node.astext()

    def read_html(self, source, text):
        """Add an exercise as an entry, with text in its chapter; of a figure, what it shows."""
        soup = BeautifulSoup(source, "html.parser")
        exercise = soup.select_one(":is(.rk-exercise, .rk-program)[id]")
        figure = soup.find("figure")
        if exercise:
            name, kind = exercise["id"], exercise["class"][0].removeprefix("rk-").title()
            for hint in soup.select(".rk-program > details"):
                hint.decompose()
            text = "" if self.page == "practice" else join_words([extract_text(exercise)])
            self.add(name, f"{kind} {name}", text=text)
        elif figure:
            shown = figure.select_one("[role=img][aria-label], [role=group][aria-label]")
            text.append(shown["aria-label"] if shown else "")
        else:
            text.append(extract_text(soup))

    def read_function(self, desc):
        """Add a function or a class; of those for authors what it does, without its arguments."""
        signature = desc.next_node(addnodes.desc_signature)
        content = desc.next_node(addnodes.desc_content)
        if self.page == "declarations":
            content = content.next_node(nodes.paragraph) or content
        if signature["ids"]:
            name = signature["ids"][0].removeprefix("robokin.")
            self.add(signature["ids"][0], name, text=join_words([content.astext()]))

    def read_term(self, item):
        """Add a term of the glossary."""
        names = [term.astext() for term in item.findall(nodes.term)]
        words = {"terms": [], "text": [], "code": []}
        self.read(item.next_node(nodes.definition), words)
        text = join_words(words["text"])
        self.add(item.next_node(nodes.term)["ids"][0], ", ".join(names), text=text)


def collect_entries(env):
    """Return the entries of all pages."""
    found = []
    for page in sorted(env.found_docs):
        document = env.get_doctree(page)
        SelectMimeType(document).run()  # one form of each output
        reader = Reader(page, env.titles)
        if page in UNREAD:
            reader.add("", reader.title)
        else:
            reader.read_section(document.next_node(nodes.section), top=True)
        found += reader.entries
    return add_words(found, tomllib.loads(WORDS.read_text("utf-8")))


def add_words(entries, words):
    """Return the entries, with what they are also found by: {page: {anchor: words}}."""
    missing = {(page, at) for page, sections in words.items() for at in sections}
    for entry in entries:
        place = entry["page"], entry.get("at", "")
        if place in missing:
            entry["also"] = words[place[0]][place[1]]
            missing.remove(place)
    if missing:
        places = ", ".join(f"{page}#{at}" for page, at in sorted(missing))
        raise ValueError(f"{WORDS.name} has words for what is no section: {places}")
    return entries


def write_data(app, env):
    """Write the data, before the pages name their version."""
    if app.builder.format != "html":
        return
    data = json.dumps(collect_entries(env), ensure_ascii=False, separators=(",", ":"))
    file = Path(app.outdir, "_static", "search-data.js")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"siteSearch.buildIndex({data});\n", "utf-8")


def disable_own(app):
    """Disable the search of Sphinx, which would write an index and a page of results."""
    app.builder.search = False


def setup(app):
    """Register the search with Sphinx."""
    app.connect("builder-inited", disable_own)
    app.connect("env-updated", write_data)
    for file in ("minisearch/minisearch.js", "search-data.js"):
        app.add_js_file(file, type="text/search")  # no type of a script: a browser leaves it
    app.add_js_file("search.js", loading_method="defer")
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
