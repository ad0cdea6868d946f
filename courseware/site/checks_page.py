"""The page of checks: every formula, what it is compared with, and how closely they agree."""

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
from courseware.equations.check import Check, declared_checks
from courseware.equations.verification import library_functions
from courseware.site.sources import depend, sources


class FormulaChecks(SphinxDirective):
    """How many formulas agree with what; then each, its function, and how closely."""

    def run(self) -> list[nodes.Node]:
        """Under each chapter's title a formula and a sentence for each; a difference over its
        tolerance fails the build.
        """
        depend(self.env, "formulas", "checks")
        found = checked(Path(self.env.app.outdir).parent)
        text = "\n\n".join(["## In numbers", *found.entries])  # what has no heading comes last
        return self.parse_text_to_nodes(text, allow_section_headings=True)


@dataclass(frozen=True)
class Checked:
    """What the checks found: the page's entries, how many formulas, at how many points at least,
    and the largest difference."""

    entries: list[str]
    formulas: int
    samples: int
    largest: float


def checked(folder: Path) -> Checked:
    """All checks, kept in `folder` under a hash of the sources they depend on."""
    files = sources("formulas", "checks")
    key = hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()[:16]
    kept = folder / f"formula-checks-{key}.json"
    if not kept.exists():
        for old in folder.glob("formula-checks-*.json"):
            old.unlink()
        kept.write_text(json.dumps(asdict(_check_all())), encoding="utf-8")
    return Checked(**json.loads(kept.read_text(encoding="utf-8")))


def _check_all() -> Checked:
    checks, results = declared_checks(), {r.check.name: r for r in equations.verify_all()}
    wrong = [r for r in results.values() if not r.agrees]
    if wrong:
        apart = "\n".join(map(_disagreement, wrong))
        raise ExtensionError(f"formulas and functions disagree:\n{apart}")
    entries = [_summary(list(checks.values()))]
    for topic, of_topic in groupby(checks.items(), lambda item: item[0].partition(".")[0]):
        entries.append(f"## {_title(topic)}")
        for name, check in of_topic:
            entry = _entry(check, results.get(name))
            entries.append(f":::{{container}} rk-check\n{entry}\n:::")
    return Checked(
        entries,
        len(results),
        min(result.samples for result in results.values()),
        max(result.difference for result in results.values()),
    )


def _title(topic: str) -> str:
    """A chapter's title, or the name of what several chapters share."""
    taught = topic in course().taught
    return course().title(topic) if taught else topic.replace("_", " ").capitalize()


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
    directly = sum(not c.adapter for c in computed)
    return (
        f"There are {len(checks)} formulas. {directly} are compared with a function of the library "
        f"or a chapter as it is, {len(computed) - directly} with functions by way of a few lines "
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
        f"at most {power(result.difference)} apart, "
        f"allowed {power(check.tolerance)} ({check.reason})."
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
    if not check.adapter:
        return called
    return f"{called} (*{check.adapter.rstrip('.')}*)"


def power(number: float) -> str:
    digit, exponent = f"{number:.0e}".split("e")
    return f"${digit} \\cdot 10^{{{int(exponent)}}}$" if number else "0"
