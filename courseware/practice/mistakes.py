"""How a mistake is declared: once, for exercises that recognise it and a chapter that shows it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from courseware.practice.wrong_formula import WrongFormula


@dataclass(frozen=True)
class Mistake:
    """A mistake that people make, written once: exercises name it, chapters show it.

    It is a formula with something replaced. The two formulas with what changed marked, its number
    (`M12.formula.evaluate`, or `M12.formula.wrap(f)` in another function) and a figure's ghost
    (`M12.substitute({…})`) come from there. A chapter shows it by `practice.mistake("M12")`.

    Args:
        name: M1, M2, … through the whole course in the order in which they were found; a new one
            gets the next free number, and none changes: students' results hold them.
        feedback: completes "This is what you get …".
        why: why it is wrong, in one to three sentences.
        unnoticed: where it happens to be right.
        formula: the wrong formula.
        line: the wrong line as a student types it, with the names of the numbers that
            `practice.example` gives; several make up the whole answer. It is typed, as SymPy's
            NumPy printer knows no such names and no arrays: a test runs it in the numbers of the
            first exercise with an `example`, and its last new name must hold the answer that this
            exercise has for the mistake in `wrong`.
        title: of its section in the chapter, and its option of the choice "mistake" in a figure
            of the chapter, which shows the consequence, too, to those who made it twice.
        picture: the figure with that option, in words.
        document, place, nth: the source document that has it, where, and which of its errata this
            is, counted from its start; empty, as the next three, for one that is only likely.
        quote, correction: the text there and the right one, with the change in « ».
        explanation: why, in the letters of the document, where those of `why` are others.
    """

    name: str
    feedback: str
    why: str
    unnoticed: str
    formula: WrongFormula
    line: str
    title: str
    picture: str
    document: str = ""
    place: str = ""
    nth: int = 0
    quote: str = ""
    correction: str = ""
    explanation: str = ""

    def substitute(self, values: Mapping[Any, Any]) -> Any:
        """Return the wrong right side with expressions for its symbols, for a figure or a guess."""
        return self.formula.substitute(values)
