"""Worked solutions: declared formulas, with the exercise's numbers put in, and their results.

A solution is a text with a placeholder for each step. Nobody types a formula, a number or a result
into it. A step is a formula of the course, or a line of its own where the course has none. The
numbers of the exercise are found by the names of the formula's symbols; what a step gives is known
to the steps after it by the names of its left side::

    Solution(
        "The right wheel circles around the left one at the whole distance:\\n\\n{omega}",
        omega=Step(formulas.turning_rate),
    )

`{omega}` becomes "ω = (v_R − v_L)/b = (0.3 − 0.1)/0.4 = 0.5 rad/s", a column a line for each
component; `{omega.value}` is the result alone, `{omega.value:deg}` in degrees, `{omega.formula}`
the formula alone. What the last step gives, or those that `answer` names, is the answer: a test
holds it to the library's in all variants, and turns a sign in each step. Where a row of the answer
comes from several steps, `answer` holds them together, as a tuple of its own.

A whole matrix is a `MatrixSymbol`, known by its name as a number is. A step that gives one can
name its entries instead, in `values`, row by row.

A formula's named steps on the way (its `where`) are taken from earlier steps where these gave
them, and otherwise put in.
"""

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from courseware.equations.equation import Equation, free_symbols, substitute
from courseware.equations.text import formula_text, numbers_text
from courseware.errors import CourseError
from courseware.practice.wording import number_text, with_unit
from courseware.units import refuse_other_than_si

LONGEST = 110  # letters of a formula with numbers in it; a longer one is left out

Unit = str | tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Line:
    """A formula that belongs to one solution only.

    Args:
        left, right: its two sides.
        unit: of the result, one for each line where they differ; else those of the left symbols.
    """

    left: Any
    right: Any
    unit: Unit = ""

    def __post_init__(self) -> None:
        refuse_wrong_units(self.unit, f"the line with {self.left}")


@dataclass(frozen=True, eq=False)
class Step:
    """One formula of a solution.

    Args:
        formula: an Equation, a Line, or a function from the numbers.
        given: what to put in for symbols that the exercise does not know by their own names, as
            `{v_F: "v"}`: the name of a number, an expression of other symbols, or a number.
        values: names of what it gives, where those of its left side will not do, one for each
            component; symbols are its left side then.
        unit: of the result, where it is not that of the left side; one for each line where they
            differ.
        textbook: whether the textbook's form is shown and used.
        part: places of the components that are shown and given, the first is 0; all, if empty.
        check: for what does not lead to the answer but is said beside it, a function from the
            exercise's numbers, by name, that must give the same.
    """

    formula: Equation | Line | Callable[..., Equation | Line]
    given: Mapping[sp.Symbol, Any] = field(default_factory=dict)
    values: tuple[str | sp.Symbol | sp.MatrixSymbol, ...] = ()
    unit: Unit = ""
    textbook: bool = False
    part: tuple[int, ...] = ()
    check: Callable[..., Any] | None = None

    def __post_init__(self) -> None:
        of = getattr(self.formula, "name", "a solution")
        refuse_wrong_units(self.unit, f"the step of {of}")


def refuse_wrong_units(unit: Unit, who: str) -> None:
    """Refuse a result in another unit than formulas compute it in."""
    for each in unit if isinstance(unit, tuple) else (unit,):
        refuse_other_than_si(each, who)


class Solution:
    """A worked solution: its text, its steps by name, and which of them give the answer."""

    def __init__(self, text: str, answer: tuple[Any, ...] = (), **steps: Step) -> None:
        self.text, self.steps = text, steps
        self.answer = answer or tuple(steps)[-1:]

    def template(self, placeholder: str) -> str:
        """The text, with each `{step}` as its formula and a placeholder for what follows it."""

        def told(match: re.Match[str]) -> str:
            name, _, part = match[1].partition(".")
            if name not in self.steps or part not in ("", "formula"):
                return match[0]
            formulas = fixed_formulas(self.steps[name])
            if part:
                return "\n\n".join(formulas) or match[0]
            lines = (f"{formula} = {{{name}.{k}}}" for k, formula in enumerate(formulas))
            return "\n\n".join(lines) or f"{{{name}.all}}"

        return re.sub(placeholder, told, self.text)

    def worked(
        self, numbers: Mapping[str, Any], shown: Mapping[str, str] | None = None
    ) -> dict[str, "Worked"]:
        """Each step with these numbers in it. shown: the drawn ones as the reader sees them."""
        known, found = dict(numbers), {}
        for name, step in self.steps.items():
            found[name] = worked(name, step, known, shown or {})
            known |= found[name].given
        return found


class Told(NamedTuple):
    """One line of a step: its formula in letters, and the result with its unit.

    right, put: its right side, and the numbers that are put into it, once it is shown.
    """

    formula: str
    value: Any
    unit: str
    right: Any = ""
    put: tuple[dict[sp.Symbol, str], dict[sp.Symbol, str]] = ({}, {})

    def shown(self, spec: str = "") -> str:
        """The result."""
        text = number_text(self.value, spec) if spec else figures(self.value)
        return text if spec == "deg" else with_unit(text, self.unit)

    @property
    def rest(self) -> str:
        """What stands behind the formula: the numbers, unless they are too long, and the result."""
        numbers = in_numbers(self.right, *self.put)
        known = numbers in ("", figures(self.value))
        return self.shown() if known else f"{numbers} = {self.shown()}"


@dataclass(frozen=True)
class Worked:
    """A step with numbers in it: its lines, and what it gives under which names."""

    lines: tuple[Told, ...]
    given: dict[str, Any]
    result: NDArray[np.float64]

    def shown(self, part: str, spec: str) -> str:
        """What stands for a placeholder: `all`, the rest of line `0`, `formula` or `value`."""
        if part == "all":
            return "\n\n".join(f"{line.formula} = {line.rest}" for line in self.lines)
        if part == "formula":
            return "\n\n".join(line.formula for line in self.lines)
        if part == "value":
            values = [line.value for line in self.lines]
            units = {line.unit for line in self.lines}
            unit = units.pop() if len(units) == 1 else ""
            return Told("", values if len(values) > 1 else values[0], unit).shown(spec)
        return self.lines[int(part)].rest


@dataclass(frozen=True, eq=False)
class Form:
    """A step's formula, made ready once for all numbers.

    left: its left side; full: its right side as computed; lines: each as printed, in letters, with
    its right side; units: one for each line.
    """

    left: Any
    full: Any
    lines: tuple[tuple[str, Any], ...]
    units: tuple[str, ...]

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """What the right side needs."""
        return tuple(sorted(free_symbols(self.full), key=str))

    @cached_property
    def function(self) -> Callable[..., Any]:
        """The right side as a function of `symbols`."""
        return compiled(self.full, self.symbols)


def worked(name: str, step: Step, known: Mapping[str, Any], shown: Mapping[str, str]) -> Worked:
    """One step, from what the exercise and the steps before it gave."""
    ready = form(step, known)
    keys = {s: key if isinstance(key := step.given.get(s), str) else s.name for s in ready.symbols}
    missing = [f"{s} (the number {k!r})" for s, k in keys.items() if k not in known]
    if missing:
        raise CourseError(
            f"the step {name!r} of a solution uses {', '.join(missing)}, but known are only "
            f"{', '.join(known)}: name it in `given`"
        )
    values = {s: known[key] for s, key in keys.items()}
    result = np.array(ready.function(*values.values()), dtype=float)
    if result.shape[1:] == (1,):
        result = result.ravel()  # a column is a plain vector
    whole = result if result.ndim else float(result)
    put = letters(values, keys, shown)
    results = result.ravel() if is_column(ready.left) else [whole]
    lines = tuple(
        Told(formula, value, unit, right, put)
        for (formula, right), value, unit in zip(ready.lines, results, ready.units, strict=True)
    )
    names = tuple(str(symbol) for symbol in step.values or flat(ready.left))
    parts = [whole] if len(names) == 1 else result.ravel().tolist()
    return Worked(lines, dict(zip(names, parts, strict=True)) | {name: whole}, result)


def in_numbers(e: Any, numbers: dict[sp.Symbol, str], in_degrees: dict[sp.Symbol, str]) -> str:
    """A right side with numbers, or nothing where that would be too long to read."""
    symbols = set(free_symbols(e))
    if not symbols or not symbols <= set(numbers):
        return ""  # it has numbers already, or a named step on the way
    text = numbers_text(e, numbers, in_degrees)
    return text if len(text) <= LONGEST else ""


def is_column(left: Any) -> bool:
    """Whether a left side is a column: a line for each of its components."""
    return isinstance(left, sp.MatrixBase) and left.cols == 1


def components(left: Any, right: Any) -> tuple[list[Any], list[Any]]:
    """The lines of a formula: left and right sides."""
    if not is_column(left):
        return [left], [right]
    right = right if isinstance(right, sp.MatrixBase) else right.doit()
    return list(left), list(right)


def form(step: Step, known: Mapping[str, Any]) -> Form:
    """A step's formula, from the names of what is known."""
    formula = formula_of(step, known)
    named = {str(symbol) for symbol, _ in getattr(formula, "where", ())}
    return form_of(step, formula, frozenset(named & known.keys()))


def formula_of(step: Step, known: Mapping[str, Any]) -> Equation | Line:
    """A step's formula for these numbers."""
    if isinstance(step.formula, Equation | Line):
        return step.formula
    return step.formula(**known)


@lru_cache(maxsize=1024)  # a formula that a function gives may be another one each time
def form_of(step: Step, formula: Any, known: frozenset[str]) -> Form:
    """A formula in a step. known: which of the named steps on its way are known already."""
    left, right = formula.left, sp.sympify(formula.right)
    full = right
    if isinstance(formula, Equation):
        right = formula.textbook if step.textbook else right
        open_ = [(s, e) for s, e in formula.where if s not in step.given and str(s) not in known]
        full = right if step.textbook else full_form(right, open_)
    if step.part:
        left, right, full = (picked(side, step.part) for side in (left, right, full))
    other = {s: sp.sympify(v) for s, v in step.given.items() if not isinstance(v, str)}
    right, full = (tidied(substitute(side, other)) for side in (right, full))
    if step.values and not any(isinstance(name, str) for name in step.values):
        left = sp.Matrix(step.values) if is_column(left) else step.values[0]
    lines = tuple(
        (f"{formula_text(a)} = {formula_text(b)}", b)
        for a, b in zip(*components(left, right), strict=True)
    )
    units = units_of(left, step.unit or getattr(formula, "unit", ""))
    return Form(left, full, lines, units)


def units_of(left: Any, unit: Unit) -> tuple[str, ...]:
    """The unit of each line: as told, or that of its symbol."""
    lines = flat(left) if is_column(left) else [left]
    if not unit:
        return tuple(getattr(symbol, "unit", "") for symbol in lines)
    return (unit,) * len(lines) if isinstance(unit, str) else unit


def tidied(e: Any) -> Any:
    """An expression without the zeros and ones that numbers put in have left, else as written."""
    if isinstance(e, sp.MatrixBase):
        return e.applyfunc(tidied)
    if not isinstance(e, sp.Basic) or not e.args or isinstance(e, sp.MatrixSymbol):
        return e
    if isinstance(e, sp.sin | sp.cos | sp.tan) and tidied(e.args[0]) == 0:
        return e.func(0)
    parts = [tidied(part) for part in e.args]
    if isinstance(e, sp.Mul):
        if 0 in parts:
            return sp.S.Zero
        parts = [part for part in parts if part != 1] or [sp.S.One]
    if isinstance(e, sp.Add):
        parts = [part for part in parts if part != 0] or [sp.S.Zero]
    if isinstance(e, sp.Mul | sp.Add) and len(parts) == 1:
        return parts[0]
    with sp.evaluate(False):
        return e.func(*parts)


def picked(side: Any, part: tuple[int, ...]) -> Any:
    """Some components of a column; one alone is no column any more."""
    return side[part[0]] if len(part) == 1 else sp.Matrix([side[i] for i in part])


def fixed_formulas(step: Step) -> list[str]:
    """A step's formulas in letters, where they are the same for all numbers; else none."""
    if not isinstance(step.formula, Equation | Line):
        return []
    return [formula for formula, _ in form(step, {}).lines]


def flat(left: Any) -> list[Any]:
    """The symbols of a left side, one for each number."""
    return list(left) if isinstance(left, sp.MatrixBase) else [left]


def full_form(right: Any, where: Any) -> Any:
    """A right side with its named steps put in."""
    for symbol, expression in reversed(list(where)):
        right = right.xreplace({symbol: expression})
    return right


def compiled(expression: Any, symbols: tuple[sp.Symbol, ...]) -> Callable[..., Any]:
    """A fast function of an expression, made once."""
    if isinstance(expression, sp.MatrixExpr):
        expression = expression.doit()
    if isinstance(expression, sp.MatrixBase):
        expression = expression.as_immutable()
    return _compiled(expression, symbols)


@cache
def _compiled(expression: Any, symbols: tuple[sp.Symbol, ...]) -> Callable[..., Any]:
    function: Callable[..., Any] = sp.lambdify(symbols, expression, modules="numpy")
    return function


def letters(
    values: Mapping[sp.Symbol, Any], keys: Mapping[sp.Symbol, str], shown: Mapping[str, str]
) -> tuple[dict[sp.Symbol, str], dict[sp.Symbol, str]]:
    """What is put in for symbols: SI numbers, and degrees where the reader was given degrees."""
    plain = {s: figures(value) for s, value in values.items()}
    degrees = {s: shown[k] for s, k in keys.items() if shown.get(k, "").endswith("°")}
    return plain, degrees


def figures(value: Any) -> str:
    """A number on the way as text: five digits, so that it can be computed with; four decimals."""
    size = abs(value) if isinstance(value, int | float) else 1.0
    if not 1e-6 < size < 1:
        return number_text(value, "")
    return number_text(value, f".{4 - math.floor(math.log10(size))}f").rstrip("0").rstrip(".")
