"""Numbers in sentences that follow a figure: "drives at 0.080 m/s".

The text of a cell is plain, with the numbers of an untouched figure. Its metadata names the phrases
that follow a figure, whose quantities (of its controls, readouts and named steps) are in braces:

    "numbers": {"live": {"tips": ["drives at {v}"]}}

`make notebooks` writes the numbers, with their units; on the page each becomes a slot, which is as
wide as the widest number that it has shown, so that its sentence rests.
"""

import json
import re
from html import escape

from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

from courseware.equations.quantities import find_kind
from courseware.errors import CourseError
from courseware.figures.figure import find_figure
from courseware.symbols import lexicon
from courseware.symbols.formula_numbers import find_key, start_text

FIELD = re.compile(r"{(\w+)}")


def render_slot(figure: str, name: str, chapter: str) -> str:
    """Return the number as HTML, which the script keeps up to date."""
    found = find_figure(figure)
    key = find_key(found, name)
    kinds = (find_kind(s, chapter) for s in lexicon.symbols_of(chapter).values() if s.key == key)
    face = f'data-of="{figure}" data-result="1" data-symbol="{key}" data-look="{next(kinds, "")}"'
    return f'<span class="rk-slot"><span {face}>{escape(start_text(figure, name))}</span></span>'


def place_slots(app: Sphinx, page: str, content: list[str]) -> None:
    """Put slots in place of the live numbers of a page that is a notebook."""
    if not app.env.doc2path(page).endswith(".ipynb"):
        return
    notebook = json.loads(content[0])
    try:
        for cell in notebook["cells"]:
            for figure, phrases in cell["metadata"].get("numbers", {}).get("live", {}).items():
                for phrase in phrases:
                    cell["source"] = _place(figure, phrase, "".join(cell["source"]), page)
    except CourseError as error:
        raise ExtensionError(f"{page}: {error}") from error
    content[0] = json.dumps(notebook)


def _place(figure: str, phrase: str, text: str, page: str) -> str:
    """Replace the numbers of one phrase in a text."""
    plain = FIELD.sub(lambda field: start_text(figure, field[1]), phrase)
    if text.count(plain) != 1:
        raise CourseError(f"“{plain}” does not occur there once: run `make notebooks`")
    chapter = page.partition("/")[0]
    slots = FIELD.sub(lambda field: render_slot(figure, field[1], chapter), phrase)
    # what follows a number without a space moves with it
    return re.sub(r"</span></span>([^\w\s<]+)", r"</span>\1</span>", text.replace(plain, slots))
