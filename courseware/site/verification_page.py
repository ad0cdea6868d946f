"""The page of checks: every formula, the function it is compared with, and their difference."""

import hashlib
import json
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path

from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from courseware import equations
from courseware.course import course
from courseware.equations.declared_checks import Check, declared_checks
from courseware.equations.verification import library_functions
from courseware.site.sources import find_sources, note_sources

# a formula is made by the page's script when it comes near: all at once are 40,000 elements
LATER = ('<div class="site-later"><noscript>', "</noscript></div>")


class FormulaChecks(SphinxDirective):
    """A section for each chapter with its formulas and their differences from functions."""

    def run(self) -> list[nodes.Node]:
        """Verify all formulas; a difference over its tolerance fails the build."""
        note_sources(self.env, "formulas", "checks")
        entries = verify_course(Path(self.env.app.outdir).parent).entries
        text = "\n\n".join(["## In numbers", *entries])  # what has no heading comes last
        return self.parse_text_to_nodes(text, allow_section_headings=True)


@dataclass(frozen=True)
class Verification:
    """The entries of the page, the count of formulas, the least number of points, the largest
    difference, and the share of its tolerance that each formula takes."""

    entries: list[str]
    formulas: int
    samples: int
    largest: float
    shares: list[float]


def verify_course(folder: Path) -> Verification:
    """Verify all formulas, or read the result of the same sources from `folder`."""
    sources = find_sources("formulas", "checks")
    key = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()[:16]
    file = folder / f"formula-checks-{key}.json"
    if not file.exists():
        for old in folder.glob("formula-checks-*.json"):
            old.unlink()
        file.write_text(json.dumps(asdict(_verify())), encoding="utf-8")
    return Verification(**json.loads(file.read_text(encoding="utf-8")))


def _verify() -> Verification:
    checks, results = declared_checks(), {r.check.name: r for r in equations.verify_all()}
    wrong = [r for r in results.values() if not r.agrees]
    if wrong:
        lines = "\n".join(map(_describe_disagreement, wrong))
        raise ExtensionError(f"formulas and functions disagree:\n{lines}")
    entries = [_summarize(list(checks.values()))]
    for chapter, group in groupby(checks.items(), lambda item: item[0].partition(".")[0]):
        entries.append(f"## {_title(chapter)}")
        for name, check in group:
            entry = _describe(check, results.get(name))
            entries.append(f":::{{container}} rk-check\n{entry}\n:::")
    return Verification(
        entries,
        len(results),
        min(result.samples for result in results.values()),
        max(result.difference for result in results.values()),
        [result.difference / result.check.tolerance for result in results.values()],
    )


def _title(chapter: str) -> str:
    """Return a chapter's title, or the name of one that several chapters share."""
    is_taught = chapter in course().taught
    return course().title(chapter) if is_taught else chapter.replace("_", " ").capitalize()


def _describe_disagreement(result: equations.Result) -> str:
    point = ", ".join(f"{name} = {value:.6g}" for name, value in result.worst.items())
    return (
        f"{result.check.name} by {result.difference:.1g}, "
        f"allowed {result.check.tolerance:.1g}, at {point}"
    )


def _summarize(checks: list[Check]) -> str:
    computed = [c for c in checks if c.function and not c.compared_with]
    other = [f"`{c.name}`" for c in checks if c.compared_with]
    tested = [f"`{c.name}`" for c in checks if c.checked_by]
    directly = sum(not c.adapter for c in computed)
    return (
        f"There are {len(checks)} formulas. {directly} are compared with a function of the library "
        f"or a chapter as it is, {len(computed) - directly} with functions by way of a few lines "
        "that put arguments and answers in order (in italics: how). Compared with something else, "
        f"which is named: {', '.join(other) or 'none'}. Held by a test of its own, because no "
        f"function computes it: {', '.join(tested) or 'none'}."
    )


def _describe(check: Check, result: equations.Result | None) -> str:
    display = f"$$\n{check.equation.latex(computed=True)}\n$$"
    formula = f"{LATER[0]}\n\n{display}\n\n{LATER[1]}\n\n`{check.name}`"
    if result is None:
        test = check.checked_by.rpartition("::")[2]
        return f"{formula} is held by the test `{test}`: {check.reason}."
    return (
        f"{formula} at {result.samples:,} points, compared with {_describe_function(check)}: "
        f"at most {format_power(result.difference)} apart, "
        f"allowed {format_power(check.tolerance)} ({check.reason})."
    )


def _describe_function(check: Check) -> str:
    names = " and ".join(f"`{name}`" for name in library_functions(check))
    if check.compared_with:
        return check.compared_with
    if not names:
        raise ExtensionError(
            f"the check of {check.name} calls no function of {course().library}: say in its "
            "`compared_with` what computes instead"
        )
    return f"{names} (*{check.adapter.rstrip('.')}*)" if check.adapter else names


def format_power(number: float) -> str:
    """Return a number with one digit and a power of ten."""
    digit, exponent = f"{number:.0e}".split("e")
    power = f"{int(exponent)}".replace("-", "\u2212")
    return f"{digit}\u00a0·\u00a010{{sup}}`{power}`" if number else "0"
