"""The exercises as questions of Moodle, in one XML file.

Each exercise becomes a category with a question for each variant, so that a quiz can draw one at
random. An answer of one number is "numerical", of several "embedded answers", a field for each.
Where several answers are right, one of them is asked.
"""

import re
from collections.abc import Sequence
from pathlib import Path

from courseware.answers import Unknown
from courseware.classroom.answer_key import choose_exercises
from courseware.classroom.moodle_answers import choose_row, find_answers, is_slip
from courseware.course import course
from courseware.practice import variants
from courseware.practice.candidates import outcomes
from courseware.practice.exercises import Exercise, Row
from courseware.practice.saving import open_file
from courseware.units import ROWS, UNITS, Unit
from courseware.units.formatting import render_paragraphs, render_symbols

HOW_TO_WRITE = (
    "Write {what} as a decimal number such as 0.5 or 1.2e-3{unit}, with the digits 0 to 9, the "
    "decimal sign of your Moodle's language and the minus of the keyboard. Moodle cannot read "
    "fractions, π, roots, brackets, other digits or a copied minus."
)
NUMBER_RIGHT = "The number is right. If it gets no marks, its unit is missing or wrong."
FIELD = "_" * 20  # Moodle puts the field of a numerical question here
# what is typed for a sign in a unit
TYPED = {"²": ("²", "^2"), "³": ("³", "^3"), "·": ("·", "*", "")}
STYLE = (  # three columns of a matrix fit on a phone, and a unit stays behind its field
    "<style>.number-fields .form-control{display:inline-block;width:9em!important;"
    "padding:.4em;max-width:calc(100% - 1.5em)}"
    ".number-fields table{table-layout:fixed;width:100%;max-width:42em}</style>"
)


def write(out: Path, only: Sequence[str], secret: str = "", force: bool = False) -> None:
    """Write the questions; with a secret, of other numbers than the page's."""
    with open_file(out, force) as file:
        mark = f"{course().salt} {variants.version()}{' secret' if secret else ''}"
        top = f"$course$/top/{mark.replace('/', '//')}"
        file.write('<?xml version="1.0" encoding="UTF-8"?>\n<quiz>\n')
        for exercise in choose_exercises(only).values():
            category = _element("category", f"{top}/{exercise.topic}/{exercise.name}")
            file.write(f'<question type="category">{category}</question>\n')
            for number, variant in enumerate(variants.all_variants(exercise.name, secret)):
                file.write(_render_question(exercise, number, variant))
        file.write("</quiz>\n")


def _element(tag: str, text: str, form: str = "") -> str:
    """Return an element of Moodle's; in CDATA blanks are kept."""
    form = f' format="{form}"' if form else ""
    inside = text.replace("]]>", "]]]]><![CDATA[>")
    return f"<{tag}{form}><text><![CDATA[{inside}]]></text></{tag}>"


def _render_question(exercise: Exercise, number: int, variant: variants.Variant) -> str:
    text = render_paragraphs(exercise.fill(exercise.text, variant.numbers))
    solution = render_paragraphs(exercise.fill(exercise.solution.text, variant.numbers))
    hints = _hints(exercise, solution)
    if len(exercise.unknowns) == 1:
        kind, (own_text, own) = "numerical", _numerical(exercise, variant)
    else:
        kind, own_text, own = "cloze", _fields(exercise, variant), ""
        solution += _list_mistakes(exercise, variant)
    parts = [
        _element("name", f"{exercise.name} {number:02}: {exercise.title}"),
        _element("questiontext", _from_left(text + own_text), "html"),
        _element("generalfeedback", _from_left(solution), "html"),
        "<penalty>0.3333333</penalty>",
        own,
        *hints,
    ]
    return f'<question type="{kind}">\n' + "\n".join(parts) + "\n</question>\n"


def _from_left(html: str, tag: str = "div") -> str:
    """Keep matrices and lists in order in a Moodle whose language runs from right to left."""
    return f'<{tag} dir="ltr" style="text-align:left">{html}</{tag}>'


def _hints(exercise: Exercise, solution: str) -> list[str]:
    """Return two hints, for three tries: where to look, then how the solution starts."""
    look = (
        f"<p>Look into the chapter “{course().title(exercise.topic)}”. Check the unit, the sign, "
        "and that no digits were lost on the way.</p>"
    )
    start = f"<p>The solution starts like this:</p>{solution.partition('</p>')[0]}</p>"
    return [_element("hint", _from_left(hint), "html") for hint in (look, start)]


def _numerical(exercise: Exercise, variant: variants.Variant) -> tuple[str, str]:
    """Ask for one number and its unit: where Moodle lets units out, it takes any wrong one."""
    (unknown,), row = exercise.unknowns, choose_row(exercise, variant)[1]
    label = render_symbols(unknown.label)
    prompt = f"{label} in {unknown.unit}" if unknown.unit else label
    prompt += ", to four decimals" if unknown.decimals > 3 else ""
    unit = " with its unit" if unknown.unit else ""
    words = f"<p>Asked is {prompt}. {HOW_TO_WRITE.format(what='it', unit=unit)}"
    if unknown.unit:
        words += f" The unit is {_list_units(unknown)}. Without it there are no marks."
    answers = [
        f'<answer fraction="{100 * right}" format="moodle_auto_format"><text>{value}</text>'
        f"{_element('feedback', _from_left(NUMBER_RIGHT if right else feedback), 'html')}"
        f"<tolerance>{tolerance:g}</tolerance></answer>"
        for right, value, tolerance, feedback in find_answers(exercise, variant, row, 0)
    ]
    return f"{words}</p><p>{label}: {FIELD}</p>", "\n".join([*answers, _units(unknown)])


def _list_units(unknown: Unknown) -> str:
    """Return the units of an answer, and what a keyboard has for them: "rad, ° (deg)"."""
    names = []
    for unit in ROWS[unknown.unit]:
        typed = next(filter(str.isascii, _spellings(unit)), unit.name)
        names.append(unit.name if typed == unit.name else f"{unit.name} ({typed})")
    return ", ".join(names[:-1]) + " or " * (len(names) > 1) + names[-1]


def _units(unknown: Unknown) -> str:
    """Render the units; one that is wrong or missing takes all marks."""
    if not unknown.unit:
        return "<showunits>3</showunits>"
    units = "".join(
        f"<unit><multiplier>{size!r}</multiplier><unit_name>{word}</unit_name></unit>"
        for word, size in unit_sizes(unknown).items()
    )
    form = "<unitgradingtype>1</unitgradingtype><unitpenalty>1</unitpenalty>"
    return f"<units>{units}</units>\n{form}<showunits>0</showunits><unitsleft>0</unitsleft>"


def unit_sizes(unknown: Unknown) -> dict[str, float]:
    """Return all that may be typed for a unit, each with the size of one SI unit in it."""
    return {word: u.from_si(1.0) for u in ROWS[unknown.unit] for word in _spellings(u)}


def _spellings(unit: Unit) -> list[str]:
    """Return what may be typed for a unit, without the blanks, which Moodle takes out."""
    first, sign, rest = re.findall("([^/²³·]*)(.?)(.*)", unit.name)[0]
    words = UNITS[first].words if first in UNITS else [first]
    signs = TYPED.get(sign, (sign,))
    return [f"{word}{sign}{rest}".replace(" ", "") for word in words for sign in signs]


def _fields(exercise: Exercise, variant: variants.Variant) -> str:
    """Return a field for each number; a matrix is a table."""
    which, row = choose_row(exercise, variant)
    fields = [_cloze(exercise, variant, row, place) for place in range(len(row))]
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
    how = HOW_TO_WRITE.format(what="each", unit=" without a unit")
    body = f'{STYLE}<div class="number-fields">{body}</div>'
    return f"{which}{body}<p>{how} Each number earns its part.</p>"


def _cloze(exercise: Exercise, variant: variants.Variant, row: Row, place: int) -> str:
    """Return a field with its answers, in the grammar of the embedded answers."""
    answers = []
    for right, value, tolerance, feedback in find_answers(exercise, variant, row, place):
        feedback = _from_left(feedback, "span")
        for sign in "\\}#~":  # signs of the grammar
            feedback = feedback.replace(sign, f"\\{sign}")
        answers.append(f"{'=' if right else ''}{value}:{tolerance:g}#{feedback}")
    return f"{{1:NUMERICAL:{'~'.join(answers)}}}"


def _list_mistakes(exercise: Exercise, variant: variants.Variant) -> str:
    """Return what mistakes give: the words of a field show only where its mark is pointed at."""
    found: dict[str, list[Row]] = {}
    for candidate in variant.candidates:
        meaning = outcomes(exercise)[candidate.name]
        if meaning.result == "wrong" and not is_slip(candidate.name):
            found.setdefault(meaning.feedback, []).extend(candidate.rows)
    items = (
        f"<li>{exercise.format_rows(rows)}: {render_symbols(words.removeprefix('Not yet. '))}</li>"
        for words, rows in found.items()
    )
    return f"<p>If your answer was one of these:</p><ul>{''.join(items)}</ul>" if found else ""
