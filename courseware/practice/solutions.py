"""Worked solutions: declared formulas, with the exercise's numbers in them, and their results.

A solution is a text with a placeholder for each step. Nobody types a formula, a number or a result
into it. A step is a formula of the course, or an equation of its own where the course has none. The
numbers of the exercise are found by the names of the formula's symbols; the result of a step is
known to the steps after it by the names of its left side::

    Solution(
        "The right wheel circles around the left one at the whole distance:\\n\\n{omega}",
        omega=Step(formulas.turning_rate),
    )

`{omega}` becomes "ω = (v_R − v_L)/b = (0.3 − 0.1)/0.4 = 0.5 rad/s", a column a line for each
component; `{omega.value}` is the result alone, `{omega.value:deg}` in degrees, `{omega.formula}`
the formula alone. The result of the last step, or of those that `answer` names, is the answer: a
test holds it to the library's in all variants, and turns a sign in each step. Where a row of the
answer comes from several steps, `answer` holds them together, as a tuple of its own.

A whole matrix is a `MatrixSymbol`, known by its name as a number is. A step that results in one can
name its entries instead, in `values`, row by row.

A formula's named steps on the way (its `where`) are taken from earlier steps if these have them as
results, and otherwise substituted.
"""

from collections.abc import Mapping
from typing import Any

from courseware.practice.solution_steps import SolvedStep, Step, solve_step


class Solution:
    """A worked solution: its text, its steps by name, and the names of those with the answer."""

    def __init__(self, text: str, answer: tuple[Any, ...] = (), **steps: Step) -> None:
        self.text, self.steps = text, steps
        self.answer = answer or tuple(steps)[-1:]

    def solve(
        self, numbers: Mapping[str, Any], given: Mapping[str, str] = {}
    ) -> dict[str, SolvedStep]:
        """Return each step with these numbers in it; `given` has the drawn ones as texts."""
        known, found = dict(numbers), {}
        for name, step in self.steps.items():
            found[name] = solve_step(name, step, known, given)
            known |= found[name].results
        return found
