"""Files beside the pages: scripts and style, exercises, wheels for a downloaded notebook."""

import shutil
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from hatchling.builders.wheel import WheelBuilder
from sphinx.application import Sphinx

from courseware.course import course
from courseware.equations.javascript import Code
from courseware.figures.compiler import serialize
from courseware.figures.figure import Figure, find_figure, render_outlines
from courseware.practice import rendering as practice
from courseware.practice.bank import all_mistakes, all_topics
from courseware.run.page import project_path
from courseware.script import parts as scripts
from courseware.script.page import write_static
from courseware.site.home_page import find_picture
from courseware.site.mistake_pictures import draw_picture
from courseware.symbols.page import symbol_facts


def add_assets(app: Sphinx, page: str, template: str, context: Any, doctree: Any) -> None:
    """Add the scripts that a page needs, and the name of the course."""
    body = context.get("body", "") if doctree else ""
    raws = list(doctree.findall(nodes.raw)) if doctree else []
    names = dict.fromkeys(node["figure"] for node in raws if "figure" in node)
    still = [find_picture(name) for node in raws for name in node.get("still", ())]
    figures = list(map(find_figure, names))
    globals_ = {**_figure_data(figures), "coursewareSymbols": symbol_facts(page)}
    if figures or still:
        context["body"] = render_outlines([*figures, *still]) + body
    if any(globals_.values()):
        file = f"pages/{page.replace('/', '-')}.js"
        lines = (f"window.{name} = {serialize(value)};\n" for name, value in globals_.items())
        write_static(app, file, "".join(lines))
        app.add_js_file(file, loading_method="defer")
    app.add_css_file("courseware.css")
    app.add_js_file("courseware/all.js", loading_method="defer")
    name = escape(course().salt, quote=True)
    tag = f'<meta name="course" content="{name}" />'
    context["metatags"] = f"{context.get('metatags', '')}\n{tag}"


def _figure_data(figures: Iterable[Figure]) -> dict[str, list[Any]]:
    """Return the figures of a page, and the meshes of their solids, each of them once."""
    meshes: dict[str, Code] = {}

    def share(shape: dict[str, Any]) -> dict[str, Any]:
        own = map(serialize, shape.get("data", ()))
        names = [meshes.setdefault(m, Code(f"coursewareMeshes[{len(meshes)}]")) for m in own]
        return shape | {"data": names} if names else shape

    shared = [f.page_data | {"shapes": list(map(share, f.compiled["shapes"]))} for f in figures]
    return {"coursewareMeshes": list(map(Code, meshes)), "coursewareFigures": shared}


def write_assets(app: Sphinx, env: Any) -> None:
    """Write files before the pages, which name their versions."""
    if app.builder.format != "html":
        return
    solutions = app.config.course_solutions
    write_static(app, "courseware.css", scripts.join_styles())
    write_static(app, "courseware/all.js", scripts.bundle_pages())
    for topic in all_topics():
        write_static(app, f"practice/{topic}.js", practice.render_script(topic, solutions))
    for mistake in all_mistakes().values():
        write_static(app, f"practice/{mistake.name}.svg", draw_picture(mistake))


def write_downloads(app: Sphinx, error: Exception | None) -> None:
    """Write the wheels and the locked requirements beside the notebooks."""
    if error or app.builder.format != "html" or not app.config.course_wheels:
        return
    beside = Path(app.outdir) / "_sources"
    for project in app.config.course_wheels:
        next(WheelBuilder(str(project_path(project))).build(directory=str(beside)))
    shutil.copy(project_path(app.config.course_lock), beside)
