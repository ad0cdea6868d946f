"""What a cell becomes on a page: a formula, a figure, an exercise, a mistake, a prediction."""

from collections.abc import Callable
from html import escape
from typing import Any, TypeVar

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.errors import ExtensionError

from courseware.course import course
from courseware.equations.equation import find_equation
from courseware.equations.notebook import (
    AGAIN,
    COMPUTED,
    equation_anchor,
    equation_label,
    equation_of,
)
from courseware.equations.notebook import MIME as EQUATION
from courseware.errors import CourseError
from courseware.figures.figure import MIME as FIGURE
from courseware.figures.figure import find_figure
from courseware.practice import dealing
from courseware.practice import rendering as practice
from courseware.practice.notebook import MISTAKE, mistake
from courseware.predictions.declaration import find_prediction
from courseware.predictions.notebook import MIME as PREDICTION
from courseware.script import engine
from courseware.site.predictions import asked
from courseware.site.sources import depend
from courseware.symbols.numbers import Slots

T = TypeVar("T")
WITH = '<p class="rk-with">With the numbers of the figure:</p>'
NO_SCRIPT = (
    '<p class="rk-noscript">Without JavaScript these exercises can be read, with the numbers of '
    "somebody without a name; answers cannot be checked here. In the notebook of the chapter they "
    "can: a box to answer in stands below each exercise, once its cell has been run.</p>\n"
)


class Outputs:
    """The plugin that MyST-NB asks for each output of a cell."""

    mime_priority_overrides = (
        ("html", EQUATION, 1),
        ("html", AGAIN, 1),
        ("html", FIGURE, 1),
        ("html", practice.MIME, 1),
        ("html", MISTAKE, 1),
        ("html", PREDICTION, 1),
    )

    @staticmethod
    def handle_mime(renderer: Any, data: Any, inline: bool) -> list[nodes.Element] | None:
        """The page elements of a formula or a figure; None leaves the output to MyST-NB."""
        if data.mime_type == EQUATION:
            depend(renderer.renderer.sphinx_env, "formulas")
            return _equation(renderer, data)
        if data.mime_type == AGAIN:
            depend(renderer.renderer.sphinx_env, "formulas")
            return [_again(data.content["labels"], renderer.renderer.sphinx_env.docname)]
        if data.mime_type == FIGURE:
            depend(renderer.renderer.sphinx_env, "figures")
            return [figure_on_page(data.content["name"])]
        if data.mime_type == practice.MIME:
            return [exercise_box(renderer.renderer.sphinx_env, data.content["name"])]
        if data.mime_type == MISTAKE:
            depend(renderer.renderer.sphinx_env, "exercises")
            return [_mistake(data.content["name"])]
        if data.mime_type == PREDICTION:
            depend(renderer.renderer.sphinx_env, "predictions", "formulas", "figures")
            return [asked(renderer.renderer, told(find_prediction, data.content["name"]))]
        return None


def _equation(renderer: Any, data: Any) -> list[nodes.Element]:
    """A display formula, numbered and known to `{eq}` by its name."""
    name, computed = data.content["name"], data.content["computed"]
    label, formula = equation_label(name, computed), told(find_equation, name).latex(computed)
    env = renderer.renderer.sphinx_env
    node = nodes.math_block(formula, formula, label=label, nowrap=False, docname=env.docname)
    domain = env.get_domain("math")
    domain.note_equation(env.docname, label, location=(env.docname, data.line))
    node["number"] = domain.get_equation_number_for(label)
    target = nodes.target("", "", ids=[equation_anchor(label)])
    renderer.renderer.document.note_explicit_target(target)
    followed = data.content.get("figure")
    return [target, node, *(_numbers(name, computed, followed, env) if followed else ())]


def _again(labels: list[str], docname: str) -> nodes.container:
    """Formulas that stand above, each beside the number that leads to it."""
    box = nodes.container("", classes=["rk-again"])
    for label in labels:
        tex = told(equation_of, label).latex(label.endswith(COMPUTED))
        to = {"refdomain": "math", "reftype": "eq", "reftarget": label, "refdoc": docname}
        number = pending_xref("", nodes.inline(), **to, refexplicit=False, refwarn=True)
        box += nodes.paragraph("", "", number)
        box += nodes.math_block(tex, tex, number=None, nowrap=False)
    return box


def _numbers(name: str, computed: bool, figure: str, env: BuildEnvironment) -> list[nodes.Element]:
    """Below a formula the same with the numbers of a figure, which the script keeps up to date."""
    depend(env, "figures")
    slots = Slots(
        told(find_equation, name), told(find_figure, figure), env.docname.partition("/")[0]
    )
    tex = told(lambda _: slots.tex(computed), name)
    node = nodes.math_block(tex, tex, number=None, nowrap=False, seen_only=True, marked=tex)
    start = nodes.raw("", f'<div class="rk-numbers">{WITH}', format="html")
    said = f'<p class="rk-says">{slots.said()}</p></div>'
    return [start, node, nodes.raw("", said, format="html")]


def figure_on_page(name: str) -> nodes.raw:
    """The still picture with its controls, and the data that brings it to life."""
    return nodes.raw("", told(find_figure, name).render_html(), format="html", figure=name)


def refuse_names_of_headings(app: Sphinx, doctree: nodes.document) -> None:
    """A figure's name is its place on the page, which no heading may have."""
    figures = {node["figure"] for node in doctree.findall(nodes.raw) if "figure" in node}
    for section in doctree.findall(nodes.section):
        for name in figures.intersection(section["ids"]):
            raise ExtensionError(
                f"{app.env.docname}: the figure {name!r} and the heading “{section[0].astext()}” "
                "have the same place in the page's address: give the figure another name, or the "
                "heading other words"
            )


def told(find_it: Callable[[str], T], name: str) -> T:
    """What is declared under a name that stands in a notebook; what is not ends the build."""
    try:
        return find_it(name)
    except CourseError as error:
        raise ExtensionError(str(error)) from error


def exercise_box(env: BuildEnvironment, name: str) -> nodes.raw:
    """The box of an exercise; before the first on a page, the desk."""
    depend(env, "exercises")
    html = practice.render_box(name, _salt(env), env.config.course_solutions)
    return nodes.raw("", desk(env) + html, format="html")


def desk(env: BuildEnvironment) -> str:
    """Where a student says a name, as HTML: once a page."""
    if env.temp_data.get("practice_desk"):
        return ""
    env.temp_data["practice_desk"] = True
    inner = engine.call("courseware.renderDesk", _salt(env))
    data = f'data-course="{escape(_salt(env), quote=True)}" data-version="{dealing.version()}"'
    return f'{NO_SCRIPT}<div class="rk-desk" {data}>{inner}</div>\n'


def _salt(env: BuildEnvironment) -> str:
    """The name of the course, which picks the numbers."""
    return str(env.config.course_name or course().name)


def _mistake(name: str) -> nodes.container:
    """A wrong line to judge, what it gives, and the answer folded."""
    shown = mistake(name)
    line = nodes.literal_block(shown.mistake.line, shown.mistake.line, language="python")
    parts = (line, nodes.raw("", shown.answer, format="html"))
    return nodes.container("", *parts, classes=["rk-mistake"], ids=[name])
