"""The programs of a chapter as an assignment for nbgrader, otter-grader or GitHub Classroom.

An assignment needs NumPy alone: the judge and its numbers are in it as files.
"""

import inspect
from collections.abc import Iterator
from pathlib import Path
from textwrap import fill, indent

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell as code
from nbformat.v4 import new_markdown_cell as markdown
from nbformat.v4 import new_notebook
from nbformat.v4 import new_raw_cell as raw

from courseware import explaining, judge
from courseware.course import course
from courseware.errors import CourseError
from courseware.practice.saving import refuse_existing
from courseware.programs.notebook import render_hints, serialize
from courseware.programs.program import Program, all_programs

CHECK = """\
from judge import read_and_check

verdict = read_and_check("{name}", {function})
assert verdict.right, verdict
print(verdict)"""
ANSWER = """\
# BEGIN SOLUTION NO PROMPT
{solution}
# END SOLUTION
''' # BEGIN PROMPT
{starter}
''' # END PROMPT"""


def write_assignment(chapter: str, grader: str, folder: Path, force: bool) -> list[Path]:
    """Write an assignment and return its files."""
    programs = [p for p in all_programs().values() if p.topic == chapter]
    if not programs:
        chapters = ", ".join(dict.fromkeys(p.topic for p in all_programs().values()))
        raise CourseError(f"{chapter} has no programs; there are those of {chapters}")
    judges = {"judge.py": judge, "explaining.py": explaining}
    files = {k: inspect.getsource(each).replace("courseware.", "") for k, each in judges.items()}
    files |= {f"{p.name}.json": serialize(p) for p in programs}
    cells = {"nbgrader": write_nbgrader, "otter": write_otter}.get(grader)
    if cells:
        files[f"{chapter}.ipynb"] = write_notebook([*cells(chapter, programs)])
    else:
        files |= {f"{variable(p)}.py": write_file(p) for p in programs}
        files["check.sh"] = write_script(programs)
    folder.mkdir(parents=True, exist_ok=True)
    for name in files:
        refuse_existing(folder / name, force)
    for name, text in files.items():
        (folder / name).write_text(text, "utf-8")
    return [folder / name for name in files]


def write_nbgrader(chapter: str, programs: list[Program]) -> Iterator[NotebookNode]:
    """Yield the cells of nbgrader's source version: a locked one tests each function."""
    yield from write_opening(chapter)
    for p in programs:
        yield markdown(write_question(p))
        yield code(p.starter.rstrip())
        nbgrader = {"grade": True, "grade_id": p.name, "locked": True, "points": 1}
        nbgrader |= {"schema_version": 3, "solution": False, "task": False, "cell_type": "code"}
        yield code(check_lines(p), metadata={"nbgrader": nbgrader})


def write_otter(chapter: str, programs: list[Program]) -> Iterator[NotebookNode]:
    """Yield the cells of otter's master version, from which `otter assign` makes both others."""
    files = ["judge.py", "explaining.py", *(f"{p.name}.json" for p in programs)]
    listed = "\n".join(f"  - {name}" for name in files)
    yield raw(
        f"# ASSIGNMENT CONFIG\nname: {chapter}\nfiles:\n{listed}\ngenerate: true\n"
        "requirements:\n  - numpy\ntests:\n  ok_format: false"
    )
    yield from write_opening(chapter)
    for p in programs:
        name = variable(p)
        yield raw(f"# BEGIN QUESTION\nname: {name}\npoints: 1")
        yield markdown(write_question(p))
        yield raw("# BEGIN SOLUTION")
        yield code(ANSWER.format(solution=p.solution.rstrip(), starter=p.starter.rstrip()))
        yield raw("# END SOLUTION")
        yield raw("# BEGIN TESTS")
        yield code(f"def test_{name}({p.definition.name}):\n{indent(check_lines(p), '    ')}")
        yield raw("# END TESTS")
        yield raw("# END QUESTION")


def write_opening(chapter: str) -> Iterator[NotebookNode]:
    """Yield the cells above the programs."""
    yield markdown(f"# {course().title(chapter)}")
    yield code("import numpy as np")


def write_question(program: Program) -> str:
    """Return what is asked, as on the page; its hints open one another."""
    return f"## {program.title}\n\n{program.text}\n\n{render_hints(program, solution=False)}"


def variable(program: Program) -> str:
    """Return the program's name as Python takes it: "bicycle_p1"."""
    return program.name.replace("-", "_")


def check_lines(program: Program) -> str:
    return CHECK.format(name=program.name, function=program.definition.name)


def write_file(program: Program) -> str:
    """Return the file that a student completes."""
    hints = (f"Hint {k}: {hint}" for k, hint in enumerate(program.hints, 1))
    below = "\n\n".join(comment(hint) for hint in hints)
    head = f"{comment(program.title)}\n#\n{comment(program.text)}"
    return f"{head}\n\nimport numpy as np\n\n\n{program.starter}\n\n{below}\n"


def comment(text: str) -> str:
    return fill(text, 88, initial_indent="# ", subsequent_indent="# ")


def write_script(programs: list[Program]) -> str:
    """Return the command of GitHub Classroom's test: it fails where a program is wrong."""
    lines = [f"python3 judge.py {p.name} {variable(p)}.py || wrong=1" for p in programs]
    return "\n".join(["wrong=0", *lines, "exit $wrong", ""])


def write_notebook(cells: list[NotebookNode]) -> str:
    """Return a notebook as a text."""
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    for k, cell in enumerate(cells):
        cell.id = f"cell-{k}"
    notebook = new_notebook(cells=cells, metadata={"kernelspec": kernel})
    return str(nbformat.writes(notebook))
