"""The exercises as questions of Moodle, in one XML file.

Each exercise becomes a category with a question for each variant, so that a quiz can draw one at
random. An answer of one number is "numerical", of several "embedded answers", a field for each.
Several right answers of several numbers, which fields cannot judge, are "multiple choice": the
right answer among those of the known mistakes.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from classroom.answer_key import choose_exercises
from courseware.course import course
from courseware.practice import dealing, judging
from courseware.practice.bank import course_name
from courseware.practice.candidates import RIGHT, SLIPS, Candidate, distance, is_apart, outcomes
from courseware.practice.declaration import Exercise, Row, Unknown
from courseware.practice.formatting import render_paragraphs, render_symbols
from courseware.practice.saving import open_file
from courseware.units import ROWS

HOW_TO_WRITE = (
    "Write {what} as a decimal number such as 0.5 or 1.2e-3, with the decimal sign of your "
    "Moodle's language and the minus of the keyboard. Fractions, π and roots cannot be read."
)
MOST_CHOICES, FEWEST_CHOICES = 5, 3  # wrong ones


def write(out: Path, only: Sequence[str], secret: str = "", force: bool = False) -> None:
    """Write the questions; with a secret, of other numbers than the page's."""
    with open_file(out, force) as file:
        mark = f"{course_name()} {dealing.version()}{' secret' if secret else ''}"
        top = "$course$/top/" + mark.replace("/", "//")
        file.write('<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n')
        for exercise in choose_exercises(only).values():
            category = _element("category", f"{top}/{exercise.topic}/{exercise.name}")
            file.write(f'<question type="category">{category}</question>\n')
            for number, variant in enumerate(dealing.variants(exercise.name, secret)):
                file.write(_render_question(exercise, number, variant, mark))
        file.write("</quiz>\n")


def _element(tag: str, text: str, form: str = "") -> str:
    """Return an element of Moodle's; in CDATA blanks are kept."""
    form = f' format="{form}"' if form else ""
    inside = text.replace("]]>", "]]]]><![CDATA[>")
    return f"<{tag}{form}><text><![CDATA[{inside}]]></text></{tag}>"


def _render_question(exercise: Exercise, number: int, variant: dealing.Variant, mark: str) -> str:
    text = render_paragraphs(exercise.fill(exercise.text, variant.numbers))
    solution = render_paragraphs(exercise.fill(exercise.solution_text, variant.numbers))
    if exercise.accept != "one":
        kind, (text, own) = "multichoice", _choices(exercise, variant, text)
    elif len(exercise.unknowns) == 1:
        kind, (text, own) = "numerical", _numerical(exercise, variant, text)
    else:
        kind, (text, own) = "cloze", _fields(exercise, variant, text)
    parts = [
        _element("name", f"{exercise.name} {number:02}: {exercise.title}"),
        _element("questiontext", text, "html"),
        _element("generalfeedback", solution, "html"),
        "<penalty>0.3333333</penalty>",
        f"<idnumber>{exercise.name}-{number:02}</idnumber>",
        own,
        *_hints(exercise, solution, "" if kind == "numerical" else "<shownumcorrect/>"),
        f"<tags>{_element('tag', mark)}</tags>",
    ]
    return f'<question type="{kind}">\n' + "\n".join(parts) + "\n</question>\n"


def _hints(exercise: Exercise, solution: str, options: str) -> list[str]:
    """Return two hints, for three tries: where to look, then how the solution starts."""
    look = (
        f"<p>Look into the chapter “{course().title(exercise.topic)}”. Check the unit, the sign, "
        "and that no digits were lost on the way.</p>"
    )
    start = f"<p>The solution starts like this:</p>{solution.partition('</p>')[0]}</p>"
    hints = (_element("hint", hint, "html") for hint in (look, start))
    return [hint.replace("</hint>", f"{options}</hint>") for hint in hints]


def _numerical(exercise: Exercise, variant: dealing.Variant, text: str) -> tuple[str, str]:
    """Ask for one number: with its unit or without, angles also in degrees."""
    (unknown,) = exercise.unknowns
    label = render_symbols(unknown.label)
    prompt = f"{label} in {unknown.unit}" if unknown.unit else label
    prompt += ", to four decimals" if unknown.decimals > 3 else ""
    words = f"<p>Asked is {prompt}. {HOW_TO_WRITE.format(what='it')}"
    answers = [
        f'<answer fraction="{100 * right}" format="moodle_auto_format"><text>{value}</text>'
        f"{_element('feedback', feedback, 'html')}<tolerance>{tolerance:g}</tolerance></answer>"
        for right, value, tolerance, feedback in _answers(exercise, variant, 0)
    ]
    form = "<showunits>3</showunits>"
    if units := unit_factors(unknown):
        words += f" The unit may stand after it: {', '.join(units)}."
        form = _units(units)
    return f"{text}{words}</p>", "\n".join([*answers, form])


def _units(factors: Mapping[str, float]) -> str:
    units = "".join(
        f"<unit><multiplier>{factor!r}</multiplier><unit_name>{unit}</unit_name></unit>"
        for unit, factor in factors.items()
    )
    form = "<unitgradingtype>0</unitgradingtype><showunits>0</showunits><unitsleft>0</unitsleft>"
    return f"<units>{units}</units>\n{form}"


def unit_factors(unknown: Unknown) -> dict[str, float]:
    """Return the units that may be written, each with the size of one SI unit in it."""
    return {u.name: u.from_si(1.0) for u in ROWS[unknown.unit]} if unknown.unit else {}


def _fields(exercise: Exercise, variant: dealing.Variant, text: str) -> tuple[str, str]:
    """Put a field for each number into the text; a matrix is a table."""
    fields = [_cloze(exercise, variant, place) for place in range(len(exercise.unknowns))]
    if exercise.shape:
        columns = exercise.shape[1]
        rows = (fields[k : k + columns] for k in range(0, len(fields), columns))
        body = "".join(f"<tr>{''.join(f'<td>{field}</td>' for field in row)}</tr>" for row in rows)
        body = f"<table>{body}</table>"
    else:
        body = "".join(
            f"<p>{render_symbols(unknown.label)}: {field} {unknown.unit}</p>"
            for unknown, field in zip(exercise.unknowns, fields, strict=True)
        )
    how = HOW_TO_WRITE.format(what="each")
    return f"{text}{body}<p>{how} No unit is typed. Each number earns its part.</p>", ""


def _cloze(exercise: Exercise, variant: dealing.Variant, place: int) -> str:
    """Return a field with its answers, in the grammar of the embedded answers."""
    answers = []
    for right, value, tolerance, feedback in _answers(exercise, variant, place):
        for sign in "\\}#~":  # signs of the grammar
            feedback = feedback.replace(sign, f"\\{sign}")
        number = value if value == "*" else f"{value}:{tolerance:g}"
        answers.append(f"{'=' if right else ''}{number}#{feedback}")
    return f"{{1:NUMERICAL:{'~'.join(answers)}}}"


def _answers(
    exercise: Exercise, variant: dealing.Variant, place: int
) -> Iterator[tuple[bool, str, float, str]]:
    """Yield the answers for one number: whether it is right, value, tolerance, feedback.

    Moodle takes the first that fits. Where several mistakes give one number, all are named.
    """
    unknown, right = exercise.unknowns[place], variant.candidates[0].rows[0][place]
    allowed = unknown.allowed(right)
    for turn in (0, -2 * math.pi, 2 * math.pi) if unknown.circle else (0,):
        yield True, _number(right + turn), allowed, RIGHT
    wrong = [*_wrong_values(exercise, variant, place), *_values_in_other_units(unknown, right)]
    known = set[float]()
    for value, tolerance, _ in wrong:
        if value not in known and distance(unknown, value, right) > allowed + tolerance:
            known.add(value)
            alike = [f for x, t, f in wrong if distance(unknown, value, x) <= tolerance + t]
            yield False, _number(value), tolerance, _join_feedback(alike)
    near = judging.find_constant("NEAR") * allowed
    yield False, _number(right), near, judging.format_feedback("near", digits="")
    yield False, "*", 0, judging.format_feedback("wrong")


def _wrong_values(
    exercise: Exercise, variant: dealing.Variant, place: int
) -> Iterator[tuple[float, float, str]]:
    """Yield the results of mistakes for one number, with tolerance and feedback."""
    unknown, meanings = exercise.unknowns[place], outcomes(exercise)
    # of one number among several a slip says too little
    skipped = {f"slip:{name}" for name in SLIPS} if len(exercise.unknowns) > 1 else set()
    for candidate in variant.candidates:
        meaning, value = meanings[candidate.name], candidate.rows[0][place]
        if meaning.result == "wrong" and candidate.name not in skipped:
            yield value, unknown.allowed(value), meaning.feedback


def _values_in_other_units(unknown: Unknown, right: float) -> Iterator[tuple[float, float, str]]:
    for unit, factor in unit_factors(unknown).items():
        if factor != 1:
            feedback = f"The right value in {unit}. Asked is {unknown.unit}."
            yield right * factor, unknown.allowed(right) * factor, feedback


def _join_feedback(alike: Sequence[str]) -> str:
    """Return the feedback for an answer that one or several mistakes give."""
    return render_symbols(" Or: ".join(dict.fromkeys(alike))).replace("&#x27;", "'")


def _number(value: float) -> str:
    return f"{value:.9f}"


def _choices(exercise: Exercise, variant: dealing.Variant, text: str) -> tuple[str, str]:
    """Offer the right answer, one of them or all, among the results of the mistakes."""
    choices: dict[str, list[str]] = {}
    for name, rows in _choose(exercise, variant)[: MOST_CHOICES + 1]:
        feedback = outcomes(exercise)[name].feedback
        choices.setdefault(exercise.format_rows(rows), []).append(feedback)
    answers = [
        f'<answer fraction="{100 * (RIGHT in alike)}" format="html">'
        f"<text><![CDATA[{answer}]]></text>"
        f"{_element('feedback', _join_feedback(alike), 'html')}</answer>"
        for answer, alike in choices.items()
    ]
    prompt = "Which are all the answers" if exercise.accept == "all" else "Which is a right answer"
    labels = ", ".join(render_symbols(unknown.label) for unknown in exercise.unknowns)
    form = "<single>true</single><shuffleanswers>true</shuffleanswers>"
    return f"{text}<p>{prompt}, as [{labels}]?</p>", "\n".join([*answers, form])


def _choose(exercise: Exercise, variant: dealing.Variant) -> list[tuple[str, tuple[Row, ...]]]:
    """Return the right answer and wrong ones, by name; slips where mistakes are too few."""
    meanings, right = outcomes(exercise), variant.candidates[0]
    found: dict[str, tuple[Row, ...]] = {}
    for candidate in variant.candidates:
        if meanings[candidate.name].result != "partly":
            found.setdefault(candidate.name, candidate.rows)
    for name, factor in (("slip:sign", -1), ("slip:half", 0.5), ("slip:twice", 2)):
        rows = tuple(tuple(factor * x for x in row) for row in right.rows)
        if len(found) <= FEWEST_CHOICES and is_apart(exercise, Candidate(name, rows), right):
            found.setdefault(name, rows)
    return list(found.items())
