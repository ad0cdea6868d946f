"""Programs that students write, judged by the simplest input on which they are wrong.

In a notebook: `programs.show("bicycle-p1")`, and `.check(step)` judges a function.

`program` declares one in a chapter's `programs.py`; `storing` draws its inputs and computes
what is right and what known mistakes give; `notebook` shows it; `courseware/judge.py` runs a
student's function on these numbers.
"""

from courseware.programs.notebook import ProgramBox as show
from courseware.programs.program import Program, all_programs
