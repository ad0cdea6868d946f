"""A prediction on a page: the question, the form for the answer, and a fold that opens then."""

import json
from functools import partial
from html import escape
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from courseware.predictions.prediction import Prediction
from courseware.script import engine

FENCE = "`" * 10
TAG = "after-"  # of cells that a prediction opens: followed by its name


class Tag(nodes.General, nodes.Element):  # type: ignore[misc]
    """An HTML element around other nodes. tag: its name; data: its attributes."""


def visit_tag(translator: Any, node: Tag) -> None:
    """Write the start tag; builders without HTML write the content only."""
    if hasattr(translator, "starttag"):
        translator.body.append(translator.starttag(node, node["tag"], **node["data"]))


def depart_tag(translator: Any, node: Tag) -> None:
    if hasattr(translator, "starttag"):
        translator.body.append(f"</{node['tag']}>\n")


def render_prediction(renderer: Any, prediction: Prediction) -> Tag:
    """Return the page elements of a prediction. renderer: MyST's, for Markdown."""

    def markdown(text: str, **attributes: Any) -> Tag:
        node = Tag("", tag="div", data={}, **attributes)
        with renderer.current_node_context(node):
            renderer.nested_render_text(text, 0)
        return node

    answers, html = prediction.answers, partial(nodes.raw, "", format="html")
    summary = html("<summary>The answer</summary>")
    right = html(f"<p><strong>{escape(answers.format_answer())}</strong></p>")
    assumptions = (f"“{guess}”? {why}" for guess, why in answers.guesses())
    why = (markdown(text, classes=["rk-assumes"]) for text in assumptions)
    key = Tag("", right, *why, tag="div", data={}, classes=["rk-key"])
    explanation = markdown(prediction.explanation)
    fold = Tag("", summary, key, explanation, tag="details", data={}, classes=["rk-opens"])
    form = html(engine.call("courseware.renderForm", answers.serialize()))
    data = {"data-prediction": json.dumps(prediction.serialize(), ensure_ascii=False)}
    box = Tag("", tag="div", data=data, ids=[prediction.name], classes=["rk-prediction"])
    question = markdown(prediction.question)
    box.extend([Tag("", question, form, tag="div", data={}, classes=["rk-card"]), fold])
    return box


def convert_tags(app: Sphinx, page: str, content: list[str]) -> None:
    """Turn the tags of Markdown cells into a directive, because MyST-NB drops them."""
    if not app.env.doc2path(page).endswith(".ipynb"):
        return
    notebook = json.loads(content[0])
    for cell in notebook["cells"]:
        tags = [t for t in cell["metadata"].get("tags", []) if t.startswith(TAG)]
        if tags and cell["cell_type"] == "markdown":
            text = "".join(cell["source"])
            cell["source"] = f"{FENCE}{{after}} {tags[0].removeprefix(TAG)}\n{text}\n{FENCE}"
    content[0] = json.dumps(notebook)


class After(SphinxDirective):
    """Text that a prediction opens."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Return the content with the class that a code cell of the same tag has."""
        node = Tag("", tag="div", data={}, classes=[f"tag_{TAG}{self.arguments[0]}"])
        self.state.nested_parse(self.content, self.content_offset, node)
        return [node]


def fill_folds(app: Sphinx, doctree: nodes.document) -> None:
    """Move the cells that follow a prediction and are tagged with its name into its fold."""
    for fold in list(doctree.findall(lambda n: isinstance(n, Tag) and "rk-opens" in n["classes"])):
        box = cell = fold.parent
        while "cell" not in cell["classes"]:
            cell = cell.parent
        tag, cells = f"tag_{TAG}{box['ids'][0]}", cell.parent
        for follower in cells[cells.index(cell) + 1 :]:
            if tag not in follower.get("classes", []):
                break
            cells.remove(follower)
            fold.append(follower)


def setup(app: Sphinx) -> None:
    app.add_node(Tag, html=(visit_tag, depart_tag))
    app.add_directive("after", After)
    app.connect("source-read", convert_tags)
    app.connect("doctree-read", fill_folds)
