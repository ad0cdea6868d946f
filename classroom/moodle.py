"""The exercises as questions of Moodle, in one XML file.

Each exercise becomes a category with a question for each variant, so that a quiz can draw one at
random. One number is asked as "numerical", several as "embedded answers", a field for each. Where
there are several right answers of several numbers, which fields cannot judge, it is "multiple
choice": the right answer among those of the known mistakes.
"""

import math
from collections.abc import Iterator, Sequence
from pathlib import Path

from classroom.answer_key import choose_exercises
from courseware.course import course
from courseware.practice import dealing, judging
from courseware.practice.bank import Ask, Exercise, default_salt
from courseware.practice.judging import Candidate, Row
from courseware.practice.saving import open_file
from courseware.practice.wording import paragraphs, symbols
from courseware.units import ROWS

WRITE = (
    "Write {what} as a decimal number such as 0.5 or 1.2e-3, with the decimal sign of your "
    "Moodle's language and the minus of the keyboard. Fractions, π and roots cannot be read."
)
CHOICES = 5  # wrong ones, at most
FEW = 3  # at least


def write(out: str | Path, only: Sequence[str] = (), secret: str = "", force: bool = False) -> None:
    """Write the questions; with a secret, of other numbers than the page's."""
    with open_file(out, force) as file:
        mark = f"{default_salt()} {dealing.version()}{' secret' if secret else ''}"
        top = "$course$/top/" + mark.replace("/", "//")
        file.write('<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n')
        for exercise in choose_exercises(only).values():
            category = _text("category", f"{top}/{exercise.topic}/{exercise.name}")
            file.write(f'<question type="category">{category}</question>\n')
            for number, variant in enumerate(dealing.variants(exercise.name, secret)):
                file.write(_question(exercise, number, variant, mark))
        file.write("</quiz>\n")


def _text(tag: str, text: str, form: str = "") -> str:
    """An element of Moodle's; in CDATA blanks are kept."""
    form = f' format="{form}"' if form else ""
    inside = text.replace("]]>", "]]]]><![CDATA[>")
    return f"<{tag}{form}><text><![CDATA[{inside}]]></text></{tag}>"


def _question(exercise: Exercise, number: int, variant: dealing.Variant, mark: str) -> str:
    text = paragraphs(exercise.filled(exercise.text, variant.numbers, variant.shown))
    solution = paragraphs(exercise.filled(exercise.solution_text, variant.numbers, variant.shown))
    if exercise.accept != "one":
        kind, (text, own) = "multichoice", _choices(exercise, variant, text)
    elif len(exercise.asks) == 1:
        kind, (text, own) = "numerical", _numerical(exercise, variant, text)
    else:
        kind, (text, own) = "cloze", _fields(exercise, variant, text)
    counted = "" if kind == "numerical" else "<shownumcorrect/>"
    first, second = _hints(exercise, solution)
    parts = [
        _text("name", f"{exercise.name} {number:02}: {exercise.title}"),
        _text("questiontext", text, "html"),
        _text("generalfeedback", solution, "html"),
        "<penalty>0.3333333</penalty>",
        f"<idnumber>{exercise.name}-{number:02}</idnumber>",
        own,
        *(
            _text("hint", hint, "html").replace("</hint>", f"{counted}</hint>")
            for hint in (first, second)
        ),
        f"<tags>{_text('tag', mark)}</tags>",
    ]
    return f'<question type="{kind}">\n' + "\n".join(parts) + "\n</question>\n"


def _hints(exercise: Exercise, solution: str) -> tuple[str, str]:
    """Where to look, then how the solution starts: with two hints there are three tries."""
    look = (
        f"<p>Look into the chapter “{course().title(exercise.topic)}”. Check the unit, the sign, "
        "and that no digits were lost on the way.</p>"
    )
    return look, f"<p>The solution starts like this:</p>{solution.partition('</p>')[0]}</p>"


def _numerical(exercise: Exercise, variant: dealing.Variant, text: str) -> tuple[str, str]:
    """One number: with its unit or without, in degrees too if the degree sign is there."""
    (ask,) = exercise.asks
    asked = f"{symbols(ask.label)} in {ask.unit}" if ask.unit else symbols(ask.label)
    asked += ", to four decimals" if ask.decimals > 3 else ""
    units = "".join(
        f"<unit><multiplier>{factor!r}</multiplier><unit_name>{unit}</unit_name></unit>"
        for unit, factor in units_of(ask).items()
    )
    answers = [
        f'<answer fraction="{100 * right}" format="moodle_auto_format"><text>{value}</text>'
        f"{_text('feedback', says, 'html')}<tolerance>{tolerance:g}</tolerance></answer>"
        for right, value, tolerance, says in _answers(exercise, variant, 0)
    ]
    form = "<unitgradingtype>0</unitgradingtype><showunits>0</showunits><unitsleft>0</unitsleft>"
    if not units:
        form = "<showunits>3</showunits>"
    words = f"<p>Asked is {asked}. {WRITE.format(what='it')}"
    words += f" The unit may stand after it: {', '.join(units_of(ask))}.</p>" if units else "</p>"
    return text + words, "\n".join([*answers, f"<units>{units}</units>" if units else "", form])


def units_of(ask: Ask) -> dict[str, float]:
    """How the unit may be written, and the size of one of the unit asked in it."""
    return {unit.name: unit.from_si(1.0) for unit in ROWS[ask.unit]} if ask.unit else {}


def _fields(exercise: Exercise, variant: dealing.Variant, text: str) -> tuple[str, str]:
    """A field for each number, in the text; a matrix as a table."""
    fields = ["{1:NUMERICAL:" + "~".join(_cloze(exercise, variant, place)) + "}"
              for place in range(len(exercise.asks))]  # fmt: skip
    if exercise.shape:
        columns = exercise.shape[1]
        rows = (fields[k : k + columns] for k in range(0, len(fields), columns))
        body = "".join(f"<tr>{''.join(f'<td>{field}</td>' for field in row)}</tr>" for row in rows)
        body = f"<table>{body}</table>"
    else:
        asked = zip(exercise.asks, fields, strict=True)
        body = "".join(f"<p>{symbols(ask.label)}: {field} {ask.unit}</p>" for ask, field in asked)
    note = f"<p>{WRITE.format(what='each')} No unit is typed. Each number earns its part.</p>"
    return text + body + note, ""


def _cloze(exercise: Exercise, variant: dealing.Variant, place: int) -> Iterator[str]:
    """The answers of a field, in the grammar of the embedded answers."""
    for right, value, tolerance, says in _answers(exercise, variant, place):
        for sign in "\\}#~":  # signs of the grammar
            says = says.replace(sign, f"\\{sign}")
        number = value if value == "*" else f"{value}:{tolerance:g}"
        yield f"{'=' if right else ''}{number}#{says}"


def _answers(
    exercise: Exercise, variant: dealing.Variant, place: int
) -> Iterator[tuple[bool, str, float, str]]:
    """What may be answered for one number: whether it is right, value, tolerance, what is said.

    Moodle takes the first that fits. Where several mistakes give one number, all are said.
    """
    ask, meant = exercise.asks[place], judging.outcomes(exercise)
    right = variant.candidates[0].rows[0][place]
    for turn in (0, -2 * math.pi, 2 * math.pi) if ask.circle else (0,):
        yield True, _number(right + turn), ask.allowed(right), judging.RIGHT
    general = {f"slip:{name}" for name in judging.SLIPS} if len(exercise.asks) > 1 else set()
    wrong = [  # value, tolerance, what is said
        (c.rows[0][place], ask.allowed(c.rows[0][place]), meant[c.name].says)
        for c in variant.candidates
        if meant[c.name].result == "wrong" and c.name not in general
    ] + [
        (
            right * factor,
            ask.allowed(right) * factor,
            f"The right value in {unit}. Asked is {ask.unit}.",
        )
        for unit, factor in units_of(ask).items()
        if factor != 1
    ]
    told = set[float]()
    for value, tolerance, _ in wrong:
        if value not in told and judging.off(ask, value, right) > ask.allowed(right) + tolerance:
            told.add(value)
            alike = [says for x, t, says in wrong if judging.off(ask, value, x) <= tolerance + t]
            yield False, _number(value), tolerance, _said(alike)
    near = judging.near()
    yield False, _number(right), near * ask.allowed(right), judging.says("near", digits="")
    yield False, "*", 0, judging.says("wrong")


def _said(alike: Sequence[str]) -> str:
    """What is said where one or several mistakes give an answer."""
    return symbols(" Or: ".join(dict.fromkeys(alike))).replace("&#x27;", "'")


def _number(value: float) -> str:
    return f"{value:.9f}"


def _choices(exercise: Exercise, variant: dealing.Variant, text: str) -> tuple[str, str]:
    """The right answer, one of them or all, among what the mistakes give."""
    meant = judging.outcomes(exercise)
    given: dict[str, tuple[Row, ...]] = {}
    for candidate in variant.candidates:
        if meant[candidate.name].result != "partly":
            given.setdefault(candidate.name, candidate.rows)
    right = variant.candidates[0]
    for name, factor in (("slip:sign", -1), ("slip:half", 0.5), ("slip:twice", 2)):
        rows = tuple(tuple(factor * x for x in row) for row in right.rows)
        if len(given) <= FEW and judging.apart(exercise, Candidate(name, rows), right):
            given.setdefault(name, rows)
    choices: dict[str, list[str]] = {}
    for name, rows in list(given.items())[: CHOICES + 1]:
        choices.setdefault(exercise.rows_text(rows), []).append(meant[name].says)
    answers = [
        f'<answer fraction="{100 * (judging.RIGHT in says)}" format="html">'
        f"<text><![CDATA[{shown}]]></text>{_text('feedback', _said(says), 'html')}</answer>"
        for shown, says in choices.items()
    ]
    asked = "Which are all the answers" if exercise.accept == "all" else "Which is a right answer"
    labels = ", ".join(symbols(ask.label) for ask in exercise.asks)
    form = "<single>true</single><shuffleanswers>true</shuffleanswers>"
    return f"{text}<p>{asked}, as [{labels}]?</p>", "\n".join([*answers, form])
