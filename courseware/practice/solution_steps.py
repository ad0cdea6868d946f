"""The steps of a worked solution: a formula each, prepared once, then computed for any numbers."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from courseware.equations.equation import Equation, free_symbols, substitute
from courseware.equations.text import format_formula, format_with_numbers
from courseware.errors import CourseError
from courseware.units import refuse_other_than_si
from courseware.units.formatting import append_unit, format_number

_lambdify = cache(sp.lambdify)
LONGEST = 110  # letters of a formula with numbers in it; a longer one is left out

Unit = str | tuple[str, ...]
SymbolTexts = dict[sp.Symbol, str]


def _refuse_wrong_units(unit: Unit, who: str) -> None:
    for each in unit if isinstance(unit, tuple) else (unit,):
        refuse_other_than_si(each, who)


@dataclass(frozen=True, eq=False)
class LocalEquation:
    """A formula that belongs to one solution only.

    Args:
        left, right: its two sides.
        unit: of the result, one for each line where they differ; else those of the left symbols.
    """

    left: Any
    right: Any
    unit: Unit = ""

    def __post_init__(self) -> None:
        _refuse_wrong_units(self.unit, f"the equation with {self.left}")


@dataclass(frozen=True, eq=False)
class Step:
    """One formula of a solution.

    Args:
        formula: an Equation, a LocalEquation, or a function from the numbers to one of them.
        given: values of symbols that the exercise does not know by their own names, as
            `{v_F: "v"}`: the name of a number, an expression of other symbols, or a number.
        values: names of the results, where those of the left side will not do, one for each
            component; symbols are its left side then.
        unit: of the result, where it is not that of the left side; one for each line where they
            differ.
        textbook: whether the textbook's form is shown and used.
        part: places of the components that are shown and given, the first is 0; all, if empty.
        expected: for a step that is said beside the way and does not lead to the answer, a
            function from the exercise's numbers, by name, that must give the same.
    """

    formula: Equation | LocalEquation | Callable[..., Equation | LocalEquation]
    given: Mapping[sp.Symbol, Any] = field(default_factory=dict)
    values: tuple[str | sp.Symbol | sp.MatrixSymbol, ...] = ()
    unit: Unit = ""
    textbook: bool = False
    part: tuple[int, ...] = ()
    expected: Callable[..., Any] | None = None

    def __post_init__(self) -> None:
        _refuse_wrong_units(self.unit, f"the step of {getattr(self.formula, 'name', 'a solution')}")

    def formula_for(self, numbers: Mapping[str, Any]) -> Equation | LocalEquation:
        """Return the formula for these numbers."""
        if isinstance(self.formula, Equation | LocalEquation):
            return self.formula
        return self.formula(**numbers)


class SolvedLine(NamedTuple):
    """One line of a step: its formula, the result with its unit; the right side, its numbers."""

    formula: str
    value: Any
    unit: str
    right: Any = ""
    numbers: tuple[SymbolTexts, SymbolTexts] = ({}, {})  # in SI, and those that are in degrees

    def format(self, spec: str = "") -> str:
        text = format_number(self.value, spec) if spec else format_result(self.value)
        return text if spec == "deg" else append_unit(text, self.unit)

    def format_whole(self) -> str:
        """Return the formula, its numbers, unless they are too long, and the result."""
        texts, symbols = "", free_symbols(self.right)
        if symbols and symbols <= self.numbers[0].keys():  # else named steps, or numbers already
            texts = format_with_numbers(self.right, *self.numbers)
        is_shown = texts and len(texts) <= LONGEST and texts != format_result(self.value)
        return " = ".join([self.formula, *[texts] * bool(is_shown), self.format()])


@dataclass(frozen=True)
class SolvedStep:
    """A step with numbers in it: its lines; its results by name, the whole by the step's."""

    lines: tuple[SolvedLine, ...]
    results: dict[str, Any]

    def format(self, part: str, spec: str) -> str:
        """Return the text of a placeholder: the whole step, its `formula` or its `value`."""
        if part == "value":
            values = [line.value for line in self.lines]
            units = {line.unit for line in self.lines}
            unit = units.pop() if len(units) == 1 else ""
            return SolvedLine("", values if len(values) > 1 else values[0], unit).format(spec)
        lines = (line.formula if part else line.format_whole() for line in self.lines)
        return "\n\n".join(lines)


def solve_step(
    name: str, step: Step, known: Mapping[str, Any], given: Mapping[str, str]
) -> SolvedStep:
    """Compute a step from the numbers of the exercise and the results of the steps before it."""
    form = step_form(step, known)
    keys = _find_keys(name, step, form, known)
    values = {s: known[key] for s, key in keys.items()}
    result = np.array(form.function(*values.values()), dtype=float)
    if result.shape[1:] == (1,):
        result = result.ravel()  # a column is a plain vector
    whole = result if result.ndim else float(result)
    plain = {s: format_result(value) for s, value in values.items()}
    degrees = {s: given[k] for s, k in keys.items() if given.get(k, "").endswith("°")}
    results = result.ravel() if _is_column(form.left) else [whole]
    lines = tuple(
        SolvedLine(formula, value, unit, right, (plain, degrees))
        for (formula, right), value, unit in zip(form.lines, results, form.units, strict=True)
    )
    entries = list(form.left) if isinstance(form.left, sp.MatrixBase) else [form.left]
    names = [str(symbol) for symbol in step.values or entries]
    parts = [whole] if len(names) == 1 else result.ravel().tolist()
    return SolvedStep(lines, dict(zip(names, parts, strict=True)) | {name: whole})


def _find_keys(
    name: str, step: Step, form: "StepForm", known: Mapping[str, Any]
) -> dict[sp.Symbol, str]:
    """Return the name of the known number for each symbol of a formula."""
    keys = {s: key if isinstance(key := step.given.get(s), str) else s.name for s in form.symbols}
    missing = [f"{s} (the number {k!r})" for s, k in keys.items() if k not in known]
    if missing:
        raise CourseError(
            f"the step {name!r} of a solution uses {', '.join(missing)}, but known are only "
            f"{', '.join(known)}: name it in `given`"
        )
    return keys


@dataclass(frozen=True, eq=False)
class StepForm:
    """A step's formula, prepared once for all numbers.

    left: its left side; full: its right side as computed; lines: each as printed, in letters, with
    its right side; units: one for each line.
    """

    left: Any
    full: Any
    lines: tuple[tuple[str, Any], ...]
    units: tuple[str, ...]

    @cached_property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        return tuple(sorted(free_symbols(self.full), key=str))

    @cached_property
    def function(self) -> Callable[..., Any]:
        """The right side as a function of `symbols`."""
        return compile_function(self.full, self.symbols)


def step_form(step: Step, known: Mapping[str, Any]) -> StepForm:
    """Prepare a step's formula, from the names of the known numbers."""
    formula = step.formula_for(known)
    named = {str(symbol) for symbol, _ in getattr(formula, "where", ())}
    return _prepare(step, formula, frozenset(named & known.keys()))


@lru_cache(maxsize=1024)  # a function may return another formula each time
def _prepare(step: Step, formula: Any, known: frozenset[str]) -> StepForm:
    """Prepare a formula, of whose named steps some are known already."""
    left, right = formula.left, sp.sympify(formula.right)
    full = right
    if isinstance(formula, Equation):
        right = full = formula.textbook if step.textbook else right
        for symbol, expression in () if step.textbook else reversed(formula.where):
            if symbol not in step.given and str(symbol) not in known:
                full = full.xreplace({symbol: expression})
    if step.part:
        left, right, full = (_pick(side, step.part) for side in (left, right, full))
    other = {s: sp.sympify(v) for s, v in step.given.items() if not isinstance(v, str)}
    right, full = (_drop_zeros_and_ones(substitute(side, other)) for side in (right, full))
    if step.values and not any(isinstance(name, str) for name in step.values):
        left = sp.Matrix(step.values) if _is_column(left) else step.values[0]
    sides = [(left, right)]
    if _is_column(left):
        rows = right if isinstance(right, sp.MatrixBase) else right.doit()
        sides = list(zip(left, rows, strict=True))
    own = tuple(getattr(a, "unit", "") for a, _ in sides)
    unit = step.unit or getattr(formula, "unit", "") or own
    units = (unit,) * len(sides) if isinstance(unit, str) else unit
    lines = tuple((f"{format_formula(a)} = {format_formula(b)}", b) for a, b in sides)
    return StepForm(left, full, lines, units)


def _is_column(left: Any) -> bool:
    """Return whether a left side has a line for each of its components."""
    return isinstance(left, sp.MatrixBase) and left.cols == 1


def _pick(side: Any, part: tuple[int, ...]) -> Any:
    """Return some components of a column; one alone is no column any more."""
    return side[part[0]] if len(part) == 1 else sp.Matrix([side[i] for i in part])


def _drop_zeros_and_ones(e: Any) -> Any:
    """Return an expression as written, but for zeros and ones that were substituted."""
    if isinstance(e, sp.MatrixBase):
        return e.applyfunc(_drop_zeros_and_ones)
    if not isinstance(e, sp.Basic) or not e.args or isinstance(e, sp.MatrixSymbol):
        return e
    parts = [_drop_zeros_and_ones(part) for part in e.args]
    if isinstance(e, sp.sin | sp.cos | sp.tan) and parts[0] == 0:
        return e.func(0)
    if isinstance(e, sp.Mul) and 0 in parts:
        return sp.S.Zero
    if isinstance(e, sp.Mul | sp.Add):
        parts = [part for part in parts if part != e.identity] or [e.identity]
        if len(parts) == 1:
            return parts[0]
    with sp.evaluate(False):
        return e.func(*parts)


def compile_function(expression: Any, symbols: tuple[sp.Symbol, ...]) -> Callable[..., Any]:
    if isinstance(expression, sp.MatrixExpr):
        expression = expression.doit()
    if isinstance(expression, sp.MatrixBase):
        expression = expression.as_immutable()
    function: Callable[..., Any] = _lambdify(symbols, expression, "numpy")
    return function


def format_result(value: Any) -> str:
    """Return a number on the way with five digits, so that it can be computed with."""
    size = abs(value) if isinstance(value, int | float) else 1.0
    if not 1e-6 < size < 1:
        return format_number(value)
    return format_number(value, f".{4 - math.floor(math.log10(size))}f").rstrip("0").rstrip(".")
