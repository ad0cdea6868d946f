"""The Sphinx extension of the course: how formulas and live figures get onto a page.

A cell's formula becomes a numbered equation, a cell's figure its still picture that the script
takes over. Directives: `{formula-checks}` (every formula against its function), `{notation}`.
"""

import hashlib
import json
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from robokin import equations
from robokin.equations.printing import MIME as EQUATION
from robokin.equations.printing import equation_latex
from robokin.live import engine
from robokin.live.figure import MIME as FIGURE
from robokin.live.runtime import runtime, stylesheet

PACKAGE = Path(__file__).parent


class Outputs:
    """The plugin that MyST-NB asks for each output of a cell."""

    mime_priority_overrides = (("html", EQUATION, 1), ("html", FIGURE, 1))

    @staticmethod
    def handle_mime(renderer: Any, data: Any, inline: bool) -> list[nodes.Element] | None:
        """The page elements of a formula or a figure; None leaves the output to MyST-NB."""
        if data.mime_type == EQUATION:
            return _equation(renderer, data)
        if data.mime_type == FIGURE:
            _depend(renderer.renderer.sphinx_env, "live/*", "styles.py")
            return [_figure(data.content)]
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


def _figure(content: dict[str, str]) -> nodes.raw:
    """The still picture with its controls, and the data that brings it to life."""
    name, code = content["name"], content["code"]
    body = engine.run(f"robokin.html({code})")
    safe = code.replace("</", "<\\/")
    html = (
        f'<figure class="rk-figure" id="{name}">{body}</figure>\n'
        f"<script>(window.robokinFigures ??= []).push({safe});</script>\n"
    )
    return nodes.raw("", html, format="html")


def _depend(env: BuildEnvironment, *patterns: str) -> None:
    """Read the present page again when one of these files of the package changes."""
    for pattern in patterns:
        for path in PACKAGE.glob(pattern):
            env.note_dependency(str(path))


class FormulaChecks(SphinxDirective):
    """Every formula, the function that agrees with it, and how closely."""

    def run(self) -> list[nodes.Node]:
        """A formula and a sentence for each; a difference over its tolerance fails the build."""
        _depend(self.env, "*.py", "equations/*.py")
        entries = checked(Path(self.env.app.outdir).parent)
        return self.parse_text_to_nodes("\n\n".join(entries))


class Notation(SphinxDirective):
    """A table of every symbol: unit, range, meaning."""

    def run(self) -> list[nodes.Node]:
        """One row a symbol that formulas use."""
        _depend(self.env, "equations/*.py", "figures/*.py")
        lines = ["| symbol | in code | unit | range | meaning |", "|---|---|---|---|---|"]
        for symbol, known in equations.QUANTITIES.items():
            span = f"{known.low:g} … {known.high:g}".replace("-", "\u2212")
            lines.append(
                f"| ${known.latex}$ | `{symbol}` | {known.unit} | {span} | {known.meaning} |"
            )
        return self.parse_text_to_nodes("\n".join(lines))


def checked(folder: Path) -> list[str]:
    """The entries of the page, kept in `folder` under a hash of the sources they depend on."""
    sources = sorted([*PACKAGE.glob("*.py"), *PACKAGE.glob("equations/*.py")])
    key = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()[:16]
    kept = folder / f"formula-checks-{key}.json"
    if not kept.exists():
        for old in folder.glob("formula-checks-*.json"):
            old.unlink()
        kept.write_text(json.dumps(_check_all()), encoding="utf-8")
    entries: list[str] = json.loads(kept.read_text(encoding="utf-8"))
    return entries


def _check_all() -> list[str]:
    results = equations.check()
    wrong = [r for r in results if not r.agrees]
    if wrong:
        apart = "; ".join(f"{r.equation.name} by {r.difference:.1g} at {r.worst}" for r in wrong)
        raise ExtensionError(f"formulas and functions disagree: {apart}")
    return [_entry(result) for result in results]


def _entry(result: equations.Result) -> str:
    equation = result.equation
    return (
        f"$$\n{equation_latex(equation, computed=True)}\n$$\n\n"
        f"`{equation.name}` at {result.samples:,} points: at most {_power(result.difference)} "
        f"apart, allowed {_power(equation.tolerance)} ({equation.reason})."
    )


def _power(number: float) -> str:
    digit, exponent = f"{number:.0e}".split("e")
    return f"${digit} \\cdot 10^{{{int(exponent)}}}$" if number else "0"


def _add_assets(app: Sphinx, page: str, template: str, context: Any, doctree: Any) -> None:
    """The runtime and its style on pages that have a figure, and only there."""
    if doctree and "rk-figure" in context.get("body", ""):
        app.add_js_file("robokin-live.js", loading_method="defer")
        app.add_css_file("robokin-live.css")


def _write_assets(app: Sphinx, error: Exception | None) -> None:
    if error or app.builder.format != "html":
        return
    static = Path(app.outdir) / "_static"
    start = "(window.robokinFigures || []).forEach((figure) => robokin.onPage(figure));"
    for name, text in {
        "robokin-live.js": f"{runtime()}\n{start}\n",
        "robokin-live.css": stylesheet(),
    }.items():
        (static / name).write_text(text, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Called by Sphinx."""
    app.add_directive("formula-checks", FormulaChecks)
    app.add_directive("notation", Notation)
    app.connect("html-page-context", _add_assets)
    app.connect("build-finished", _write_assets)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
