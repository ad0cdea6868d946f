"""Outputs of cells on a page: formulas, figures, exercises, mistakes, predictions."""

from collections.abc import Callable
from html import escape
from typing import Any

from docutils import nodes
from sphinx.environment import BuildEnvironment
from sphinx.errors import ExtensionError

from courseware.course import course
from courseware.equations.equation import find_equation
from courseware.equations.notebook import MIME as EQUATION
from courseware.equations.notebook import equation_anchor, equation_label
from courseware.errors import CourseError
from courseware.figures.figure import MIME as FIGURE
from courseware.figures.figure import find_figure
from courseware.practice import rendering as practice
from courseware.practice import variants
from courseware.practice.bank import find_mistake
from courseware.practice.notebook import MISTAKE, render_judgement
from courseware.predictions.notebook import MIME as PREDICTION
from courseware.predictions.page import render_prediction
from courseware.predictions.prediction import find_prediction
from courseware.programs import notebook as programs
from courseware.programs.program import find_program
from courseware.script import engine
from courseware.symbols.formula_numbers import Slots

WITH = '<p class="rk-with">With the numbers of the figure:</p>'
NO_SCRIPT = (
    '<p class="rk-noscript">Without JavaScript these exercises can be read, with the numbers of '
    "somebody without a name; answers cannot be checked here. In the notebook of the chapter they "
    "can: each exercise shows a box to answer in, once its cell has been run.</p>\n"
)


def render_equation(renderer: Any, data: Any) -> list[nodes.Element]:
    """Return a display formula, numbered and known to `{eq}` by its name."""
    env, name, computed = renderer.sphinx_env, data.content["name"], data.content["computed"]
    label, formula = equation_label(name, computed), find_equation(name).latex(computed)
    node = nodes.math_block(formula, formula, label=label, nowrap=False, docname=env.docname)
    domain = env.get_domain("math")
    domain.note_equation(env.docname, label, location=(env.docname, data.line))
    node["number"] = domain.get_equation_number_for(label)
    target = nodes.target("", "", ids=[equation_anchor(label)])
    renderer.document.note_explicit_target(target)
    figure = data.content.get("figure")
    return [target, node, *(_render_numbers(name, computed, figure, env) if figure else ())]


def _render_numbers(
    name: str, computed: bool, figure: str, env: BuildEnvironment
) -> list[nodes.Element]:
    """Return the formula with the numbers of a figure, which the script keeps up to date."""
    chapter = env.docname.partition("/")[0]
    slots = Slots(find_equation(name), find_figure(figure), chapter)
    tex = slots.render_tex(computed)
    node = nodes.math_block(tex, tex, number=None, nowrap=False, seen_only=True, marked=tex)
    start = nodes.raw("", f'<div class="rk-numbers">{WITH}', format="html")
    said = f'<p class="rk-says">{slots.render_sentence()}</p></div>'
    return [start, node, nodes.raw("", said, format="html")]


def render_mistake(renderer: Any, data: Any) -> list[nodes.Element]:
    """Return a wrong line to judge, its result, and the answer folded."""
    mistake = find_mistake(data.content["name"])
    line = nodes.literal_block(mistake.line, mistake.line, language="python")
    parts = (line, nodes.raw("", render_judgement(mistake), format="html"))
    return [nodes.container("", *parts, classes=["rk-mistake"], ids=[data.content["name"]])]


def render_figure(name: str) -> nodes.raw:
    """Return the still picture with its controls; the page's script brings it to life."""
    return nodes.raw("", find_figure(name).render_html(), format="html", figure=name)


def render_program(renderer: Any, data: Any) -> list[nodes.Element]:
    """Return what a program has to do, with hints and, if the site shows them, a solution."""
    solution = renderer.sphinx_env.config.course_solutions
    html = programs.render(find_program(data.content["name"]), solution)
    return [nodes.raw("", html, format="html")]


Renderer = Callable[[Any, Any], list[nodes.Element]]
RENDERERS: dict[str, Renderer] = {
    EQUATION: render_equation,
    FIGURE: lambda _, data: [render_figure(data.content["name"])],
    practice.MIME: lambda renderer, data: [
        render_exercise(renderer.sphinx_env, data.content["name"])
    ],
    MISTAKE: render_mistake,
    programs.MIME: render_program,
    PREDICTION: lambda renderer, data: [
        render_prediction(renderer, find_prediction(data.content["name"]))
    ],
}


class Outputs:
    """The plugin that MyST-NB asks for each output of a cell."""

    mime_priority_overrides = tuple(("html", mime, 1) for mime in RENDERERS)

    @staticmethod
    def handle_mime(renderer: Any, data: Any, inline: bool) -> list[nodes.Element] | None:
        """Return the page elements of one of our outputs; None leaves others to MyST-NB."""
        if data.mime_type not in RENDERERS:
            return None
        try:
            return RENDERERS[data.mime_type](renderer.renderer, data)
        except CourseError as error:  # of a name that is not declared, for example
            raise ExtensionError(str(error)) from error


def render_exercise(env: BuildEnvironment, name: str) -> nodes.raw:
    """Return the box of an exercise, after the desk if it is the first on its page."""
    html = practice.render_box(name, course().salt, env.config.course_solutions)
    return nodes.raw("", render_desk(env) + html, format="html")


def render_desk(env: BuildEnvironment) -> str:
    """Return the field for a student's name as HTML, once a page."""
    if env.temp_data.get("practice_desk"):
        return ""
    env.temp_data["practice_desk"] = True
    inner = engine.call("courseware.renderDesk", course().salt)
    data = f'data-course="{escape(course().salt, quote=True)}" data-version="{variants.version()}"'
    return f'{NO_SCRIPT}<div class="rk-desk" {data}>{inner}</div>\n'
