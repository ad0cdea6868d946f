"""The Sphinx extension of the course: how formulas, live figures and exercises get onto a page.

A cell's formula becomes a numbered equation, a cell's figure its still picture that the script
takes over, a cell's exercise a box to answer in. Directives: `{formula-checks}` (every formula
against its function), `{notation}`, `{practice} topic` (all exercises of a topic),
`{errata}` (what is wrong in the source documents), `{chapters}` (a table of them), `{library}`
(its functions), `{downloads}` (what notebooks need).
Settings: `course_package` (what is imported to open the course), `course_name` (the salt that
picks each student's numbers; without one the course's own name), `course_solutions`.
"""

import hashlib
import json
import shutil
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any

from docutils import nodes
from hatchling.builders.wheel import WheelBuilder
from myst_nb.core.render import load_mime_renders
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from workshop import equations
from workshop.course import course
from workshop.equations.checking import library_functions
from workshop.equations.checks import Check, declared_checks
from workshop.equations.printing import MIME as EQUATION
from workshop.errors import CourseError
from workshop.figures.figure import MIME as FIGURE
from workshop.figures.figure import find
from workshop.practice import page as practice
from workshop.practice.bank import exercises, mistakes, topics
from workshop.practice.notebook import MISTAKE, mistake
from workshop.practice.wording import symbols
from workshop.script import engine, runtime

MACHINE = Path(__file__).parent


class Outputs:
    """The plugin that MyST-NB asks for each output of a cell."""

    mime_priority_overrides = (
        ("html", EQUATION, 1),
        ("html", FIGURE, 1),
        ("html", practice.MIME, 1),
        ("html", MISTAKE, 1),
    )

    @staticmethod
    def handle_mime(renderer: Any, data: Any, inline: bool) -> list[nodes.Element] | None:
        """The page elements of a formula or a figure; None leaves the output to MyST-NB."""
        if data.mime_type == EQUATION:
            return _equation(renderer, data)
        if data.mime_type == FIGURE:
            _depend(renderer.renderer.sphinx_env, "figures")
            return [_figure(data.content["name"])]
        if data.mime_type == practice.MIME:
            return [_exercise(renderer.renderer.sphinx_env, data.content["name"])]
        if data.mime_type == MISTAKE:
            _depend(renderer.renderer.sphinx_env, "exercises")
            return [_mistake(data.content["name"])]
        return None


def _equation(renderer: Any, data: Any) -> list[nodes.Element]:
    """A display formula, numbered and known to `{eq}` by its name."""
    label, formula = data.content["label"], data.content["latex"]
    env = renderer.renderer.sphinx_env
    node = nodes.math_block(formula, formula, label=label, nowrap=False, docname=env.docname)
    domain = env.get_domain("math")
    domain.note_equation(env.docname, label, location=(env.docname, data.line))
    node["number"] = domain.get_equation_number_for(label)
    target = nodes.target("", "", ids=[nodes.make_id(f"equation-{label}")])
    renderer.renderer.document.note_explicit_target(target)
    return [target, node]


def _figure(name: str) -> nodes.raw:
    """The still picture with its controls, and the data that brings it to life."""
    try:
        return nodes.raw("", find(name).on_page(), format="html")
    except CourseError as error:
        raise ExtensionError(str(error)) from error


def _exercise(env: BuildEnvironment, name: str) -> nodes.raw:
    """The box of an exercise; before the first on a page, the desk with the student's name."""
    _depend(env, "exercises")
    salt, solutions = env.config.course_name or course().name, env.config.course_solutions
    html = practice.box(name, salt, solutions)
    if not env.temp_data.get("practice_desk"):
        env.temp_data["practice_desk"] = True
        desk = engine.call("workshop.practice.deskHtml")
        start = f'<div class="rk-desk" data-course="{escape(salt, quote=True)}">{desk}</div>'
        html = f"{start}\n{html}"
    return nodes.raw("", html, format="html")


def _mistake(name: str) -> nodes.container:
    """A wrong line to judge, what it gives, and the answer folded."""
    shown = mistake(name)
    title = f'<p class="rk-mistake-title">{escape(shown.exercise.title)}</p>'
    line = nodes.literal_block(shown.mistake.line, shown.mistake.line, language="python")
    parts = [nodes.raw("", title, format="html"), line, nodes.raw("", shown.answer, format="html")]
    return nodes.container("", *parts, classes=["rk-mistake"], ids=[name])


def _depend(env: BuildEnvironment, *parts: str) -> None:
    """Read the present page again when the machine, the library or such a module changes."""
    for path in _sources(*parts):
        env.note_dependency(str(path))


def _sources(*parts: str) -> list[Path]:
    """The files that what is shown depends on: modules of these names, and all below them."""
    modules = [path for part in parts for path in course().folder.glob(f"*/{part}.py")]
    machine = [path for suffix in ("py", "js", "css") for path in MACHINE.rglob(f"*.{suffix}")]
    return sorted([*modules, *machine, *course().library_folder.rglob("*.py")])


class FormulaChecks(SphinxDirective):
    """How many formulas agree with what; then each, its function, and how closely."""

    def run(self) -> list[nodes.Node]:
        """A formula and a sentence for each; a difference over its tolerance fails the build."""
        _depend(self.env, "formulas", "checks")
        entries = checked(Path(self.env.app.outdir).parent)
        return self.parse_text_to_nodes("\n\n".join(entries))


class Practice(SphinxDirective):
    """All exercises, chapter by chapter; with a topic's name, those of the topic."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """A box for each exercise, under the titles of the chapters unless one is named."""
        if not self.arguments:
            parts = (f"## {course().title(t)}\n\n```{{practice}} {t}\n```\n" for t in topics())
            return self.parse_text_to_nodes("\n".join(parts), allow_section_headings=True)
        topic = self.arguments[0]
        names = [name for name, exercise in exercises().items() if exercise.topic == topic]
        if not names:
            raise self.error(f"no exercises on {topic!r}; there are {', '.join(topics())}")
        return [_exercise(self.env, name) for name in names]


class Library(SphinxDirective):
    """The functions of the library and those that chapters declare, module by module."""

    def run(self) -> list[nodes.Node]:
        """A section for each module, from its docstrings."""
        _depend(self.env, "functions")
        text = "\n".join(
            f"## {name}\n\n```{{eval-rst}}\n.. automodule:: {name}\n   :members:\n```\n"
            for name in course().library_modules
        )
        return self.parse_text_to_nodes(text, allow_section_headings=True)


class Chapters(SphinxDirective):
    """A table of the chapters: each with the question that its package's docstring asks."""

    def run(self) -> list[nodes.Node]:
        """A row for each chapter that has a notebook."""
        _depend(self.env, "__init__")
        rows = [
            f"| [{course().title(chapter)}](/{chapter}/{chapter}) | {course().question(chapter)} |"
            for chapter in course().chapters
            if course().notebook(chapter).exists()
        ]
        return self.parse_text_to_nodes(
            "\n".join(["| chapter | the question |", "|---|---|", *rows])
        )


class Errata(SphinxDirective):
    """What stands wrong in the source documents."""

    def run(self) -> list[nodes.Node]:
        """What stands, what should and why, for each mistake that stands in a document."""
        _depend(self.env, "exercises")
        found = sorted(
            (m for m in mistakes().values() if m.document), key=lambda m: int(m.name[1:])
        )
        entries = [
            f"**{m.document}** ({m.name})\n\n- There stands: {symbols(m.stands)}\n"
            f"- It should be: {symbols(m.should)}\n\n{symbols(m.why)}"
            for m in found
        ]
        return self.parse_text_to_nodes("\n\n".join(entries))


class Notation(SphinxDirective):
    """A table of every symbol: unit, range, meaning."""

    def run(self) -> list[nodes.Node]:
        """One row a symbol that formulas use."""
        _depend(self.env, "formulas", "figures")
        lines = ["| symbol | in code | unit | range | meaning |", "|---|---|---|---|---|"]
        for known in equations.quantities():
            span = f"{known.low:g} … {known.high:g}".replace("-", "\u2212")
            lines.append(
                f"| ${known.latex}$ | `{known}` | {known.unit} | {span} | {known.meaning} |"
            )
        return self.parse_text_to_nodes("\n".join(lines))


def checked(folder: Path) -> list[str]:
    """The entries of the page, kept in `folder` under a hash of the sources they depend on."""
    sources = _sources("formulas", "checks")
    key = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()[:16]
    kept = folder / f"formula-checks-{key}.json"
    if not kept.exists():
        for old in folder.glob("formula-checks-*.json"):
            old.unlink()
        kept.write_text(json.dumps(_check_all()), encoding="utf-8")
    entries: list[str] = json.loads(kept.read_text(encoding="utf-8"))
    return entries


def _check_all() -> list[str]:
    checks, results = declared_checks(), {r.check.name: r for r in equations.check()}
    wrong = [r for r in results.values() if not r.agrees]
    if wrong:
        apart = "\n".join(map(_disagreement, wrong))
        raise ExtensionError(f"formulas and functions disagree:\n{apart}")
    return [
        _summary(list(checks.values())),
        *(_entry(check, results.get(name)) for name, check in checks.items()),
    ]


def _disagreement(result: equations.Result) -> str:
    place = ", ".join(f"{name} = {value:.6g}" for name, value in result.worst.items())
    return (
        f"{result.check.name} by {result.difference:.1g}, "
        f"allowed {result.check.tolerance:.1g}, at {place}"
    )


def _summary(checks: list[Check]) -> str:
    """How many formulas are held to what."""
    computed = [c for c in checks if c.function and not c.compared_with]
    other = [f"`{c.name}`" for c in checks if c.compared_with]
    tested = [f"`{c.name}`" for c in checks if c.checked_by]
    directly = sum(not c.between for c in computed)
    return (
        f"There are {len(checks)} formulas. {directly} are compared with a function of the library "
        f"as it is, {len(computed) - directly} with functions of the library by way of a few lines "
        "that put arguments and answers in order (in italics: how). Compared with something else, "
        f"which is named: {', '.join(other) or 'none'}. Held by a test of its own, because no "
        f"function computes it: {', '.join(tested) or 'none'}."
    )


def _entry(check: Check, result: equations.Result | None) -> str:
    formula = f"$$\n{check.equation.latex(computed=True)}\n$$\n\n`{check.name}`"
    if result is None:
        test = check.checked_by.rpartition("::")[2]
        return f"{formula} is held by the test `{test}`: {check.reason}."
    return (
        f"{formula} at {result.samples:,} points, compared with {_other_side(check)}: "
        f"at most {_power(result.difference)} apart, "
        f"allowed {_power(check.tolerance)} ({check.reason})."
    )


def _other_side(check: Check) -> str:
    """What the formula is compared with, and how its arguments and answers are put in order."""
    called = " and ".join(f"`{name}`" for name in library_functions(check))
    if check.compared_with:
        return check.compared_with
    if not called:
        raise ExtensionError(
            f"the check of {check.name} calls no function of {course().library}: say in its "
            "`compared_with` what computes instead"
        )
    if not check.between:
        return called
    return f"{called} (*{check.between.rstrip('.')}*)"


def _power(number: float) -> str:
    digit, exponent = f"{number:.0e}".split("e")
    return f"${digit} \\cdot 10^{{{int(exponent)}}}$" if number else "0"


def _add_assets(app: Sphinx, page: str, template: str, context: Any, doctree: Any) -> None:
    """The runtime and its style on pages that have a figure or an exercise, and only there."""
    body = context.get("body", "") if doctree else ""
    if 'class="rk-' in body:
        app.add_js_file("workshop.js", loading_method="defer")
        app.add_css_file("workshop.css")


def _write_assets(app: Sphinx, error: Exception | None) -> None:
    if error or app.builder.format != "html":
        return
    static = Path(app.outdir) / "_static"
    (static / "practice").mkdir(exist_ok=True)
    solutions = app.config.course_solutions
    for name, text in {
        "workshop.js": runtime.page(),
        "workshop.css": runtime.stylesheet(),
        **{f"practice/{t}.js": practice.script(t, solutions) for t in topics()},
    }.items():
        (static / name).write_text(text, encoding="utf-8")


class Downloads(SphinxDirective):
    """Links to what a downloaded notebook needs."""

    def run(self) -> list[nodes.Node]:
        """The wheel and the locked requirements, which stand beside the notebooks."""
        projects = map(_project, self.config.course_wheels)
        names = [Path(self.config.course_lock).name, *(wheel_name(project) for project in projects)]
        root = "../" * self.env.docname.count("/")
        links = (f'<a href="{root}_sources/{name}" download>{name}</a>' for name in names)
        return [nodes.raw("", f"<p>{' · '.join(links)}</p>", format="html")]


def _write_downloads(app: Sphinx, error: Exception | None) -> None:
    """The wheels and the locked requirements, beside the notebooks."""
    if error or app.builder.format != "html":
        return
    beside = Path(app.outdir) / "_sources"
    for project in app.config.course_wheels:
        next(WheelBuilder(str(_project(project))).build(directory=str(beside)))
    shutil.copy(_project(app.config.course_lock), beside)


def _project(name: str) -> Path:
    """A file or folder that a setting names: beside the folder of the course's package."""
    return course().folder.parent / name


def wheel_name(project: Path) -> str:
    """What the wheel of a project will be called."""
    metadata = WheelBuilder(str(project)).metadata
    name = metadata.core.name.replace("-", "_")
    return f"{name}-{metadata.version}-py3-none-any.whl"


def _open_course(app: Sphinx, config: Any) -> None:
    """Import the course's package, which opens it."""
    if not config.course_package:
        raise ExtensionError(
            "set course_package in _config.yml: the package to import, such as book"
        )
    import_module(config.course_package)


def setup(app: Sphinx) -> dict[str, Any]:
    """Called by Sphinx."""
    app.add_directive("formula-checks", FormulaChecks)
    app.add_directive("notation", Notation)
    app.add_directive("practice", Practice)
    app.add_directive("chapters", Chapters)
    app.add_directive("library", Library)
    app.add_directive("errata", Errata)
    app.add_config_value("course_package", "", "env", str)
    app.add_config_value("course_name", "", "env", str)
    app.add_config_value("course_solutions", True, "env", bool)
    app.add_config_value("course_wheels", [], "env", list)
    app.add_config_value("course_lock", "requirements.txt", "env", str)
    load_mime_renders().append(Outputs)  # for this build alone: nothing is registered in MyST-NB
    app.connect("config-inited", _open_course)
    app.connect("html-page-context", _add_assets)
    app.add_directive("downloads", Downloads)
    app.connect("build-finished", _write_assets)
    app.connect("build-finished", _write_downloads)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
