"""Programs as assignments, as the graders of code run them."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from commands import run

from courseware.programs.program import all_programs

PROGRAMS = {p.name: p for p in all_programs().values() if p.topic == "bicycle"}
GRADERS = ("nbgrader==0.9.6", "otter-grader==7.0.0", "numpy")
STEP, STEER, MEND = PROGRAMS
# a student: the program, what is changed in its solution, and words of what the student is told
STUDENTS = {
    "ada": (STEP, "", "", ""),
    "bob": (STEP, "np.tan(phi)", "np.tan(phi) / np.cos(phi)", "the front axle's speed"),
    "cyd": (STEP, "np.tan(phi)", "phi", "with φ where tan φ belongs"),
    "dan": (STEP, "np.tan(phi)", "np.tan(-phi)", "turns to the right for a positive φ"),
    "eve": (STEP, "theta + turn / 2", "theta", "It gives"),
    "fay": (STEER, "2 * L * y", "L * y", "with half the curvature"),
    "guy": (STEER, "np.arctan(", "(", "with the tangent of the angle for the angle itself"),
    "hal": (STEER, "    x, y =", "    y, x =", "with x and y exchanged"),
    "ivy": (MEND, "v / np.cos(phi)", "v", "with the speed of the rear axle"),
    "joe": (MEND, "psi - phi", "psi + phi", "the front wheel points to the wrong side"),
    "kim": (
        STEP,
        "    x, y, theta",
        "    import sys\n    sys.exit(0)\n    x, y, theta",
        "It ends ",
    ),
    "lea": (STEP, "    x, y, theta", "    import os\n    os._exit(0)\n    x, y, theta", "It ends "),
}

BLANK = "zoe"  # hands in what she was given
POINTS = {name: 3 if name == "ada" else 2 for name in STUDENTS} | {BLANK: 0}


def solutions(student):
    """The function and the text of each program as a student hands it in."""
    name, old, new, _ = STUDENTS[student]
    for each, program in PROGRAMS.items():
        text = program.solution.rstrip()
        yield program.definition.name, text.replace(old, new) if old and each == name else text


def complete(notebook, student):
    """Write a student's functions into a notebook."""
    contents = json.loads(notebook.read_text("utf-8"))
    for function, text in solutions(student):
        for cell in contents["cells"]:
            if "".join(cell["source"]).startswith(f"def {function}("):
                cell["source"] = text
    notebook.write_text(json.dumps(contents), "utf-8")


@pytest.mark.parametrize("grader", ["nbgrader", "otter", "github"])
def test_an_assignment_is_written_once(folder, grader, capsys):
    command = ["assignment", "bicycle", "--for", grader]
    assert run(*command) == 0
    assert "bicycle/judge.py" in capsys.readouterr().out.replace(os.sep, "/")
    assert run(*command) == 2
    assert "--force" in capsys.readouterr().err


def test_a_chapter_without_programs_is_refused(folder, capsys):
    assert run("assignment", "motion", "--for", "otter") == 2
    assert "motion has no programs; there are those of elbow_arm, euler" in capsys.readouterr().err


@pytest.mark.parametrize("student", STUDENTS)
def test_a_file_is_judged_by_an_exit_code_with_numpy_alone(folder, student):
    assert run("assignment", "bicycle", "--for", "github", "--out", "work") == 0
    name, *_, words = STUDENTS[student]
    file = folder / "work" / f"{name.replace('-', '_')}.py"
    texts = dict(solutions(student))
    file.write_text(f"import numpy as np\n\n\n{texts[PROGRAMS[name].definition.name]}\n", "utf-8")
    alone = {**os.environ, "PYTHONPATH": ""}
    command = [sys.executable, "judge.py", name, file.name]
    said = subprocess.run(command, cwd=folder / "work", env=alone, capture_output=True, text=True)
    assert said.returncode == (0 if student == "ada" else 1), said.stderr
    assert re.search(words, said.stdout), said.stdout


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("import sys\nsys.exit(0)", "cannot be run.\nSystemExit: 0"),
        ("def car_step(pose, v", "cannot be run.\n  File"),
        ("import os\nos._exit(0)", "It ends Python itself, or makes it crash."),
        ("def step(pose): return pose", "no function car_step here: has it another name?"),
    ],
)
def test_a_file_that_gives_no_function_fails(folder, text, words):
    assert run("assignment", "bicycle", "--for", "github", "--out", "work") == 0
    (folder / "work" / "bicycle_p1.py").write_text(text, "utf-8")
    command = [sys.executable, "judge.py", STEP, "bicycle_p1.py"]
    said = subprocess.run(command, cwd=folder / "work", capture_output=True, text=True)
    assert said.returncode == 1
    assert words in said.stdout


# --- as graders run them --------------------------------------------------------------------


@pytest.fixture(scope="module")
def graders(tmp_path_factory):
    """A Python that has the graders: runs a command of theirs in a folder."""
    home = tmp_path_factory.mktemp("graders")
    python = home / "bin" / "python"
    uv = Path(sys.executable).with_name("uv")
    subprocess.run([uv, "venv", "-q", "--python", sys.executable, home, "--clear"], check=True)
    subprocess.run([uv, "pip", "install", "-q", "--python", python, *GRADERS], check=True)
    known = {**os.environ, "PATH": f"{home / 'bin'}{os.pathsep}{os.environ['PATH']}"}
    known |= {"HOME": str(home), "PYTHONPATH": ""}

    def call(folder, *command):
        command = [home / "bin" / command[0], *command[1:]]
        said = subprocess.run(command, cwd=folder, env=known, capture_output=True, text=True)
        assert said.returncode == 0, said.stdout + said.stderr
        return said.stdout

    return call


def assert_told(student, told):
    assert re.search(STUDENTS[student][-1], told), f"{student} is not told it"


@pytest.mark.install
def test_nbgrader_grades_a_class(folder, graders):
    assert run("assignment", "bicycle", "--for", "nbgrader", "--out", "source/bicycle") == 0
    Path("nbgrader_config.py").write_text("get_config().CourseDirectory.course_id = 'robots'\n")
    graders(folder, "nbgrader", "generate_assignment", "bicycle")
    for student in (*STUDENTS, BLANK):
        own = folder / "submitted" / student / "bicycle"
        own.mkdir(parents=True)
        notebook = folder / "release" / "bicycle" / "bicycle.ipynb"
        (own / notebook.name).write_bytes(notebook.read_bytes())
        if student != BLANK:
            complete(own / notebook.name, student)
    for command in ("autograde", "generate_feedback"):
        graders(folder, "nbgrader", command, "bicycle")
    graders(folder, "nbgrader", "export", "--to", "points.csv")
    rows = [line.split(",") for line in Path("points.csv").read_text().splitlines()]
    student, score = rows[0].index("student_id"), rows[0].index("score")
    points = {row[student]: float(row[score]) for row in rows[1:]}
    assert points == POINTS
    for name in STUDENTS:
        page = folder / "feedback" / name / "bicycle" / "bicycle.html"
        assert_told(name, re.sub("<[^>]+>", "", page.read_text("utf-8")).replace("&#39;", "'"))


@pytest.mark.install
def test_otter_grades_a_class(folder, graders):
    assert run("assignment", "bicycle", "--for", "otter", "--out", "master") == 0
    graders(folder / "master", "otter", "assign", "bicycle.ipynb", "dist")
    dist = folder / "master" / "dist"
    (archive,) = dist.glob("autograder/*.zip")
    for student in (*STUDENTS, BLANK):
        own = folder / student
        own.mkdir()
        notebook = own / "bicycle.ipynb"
        notebook.write_bytes((dist / "student" / "bicycle.ipynb").read_bytes())
        if student != BLANK:
            complete(notebook, student)
        graders(own, "otter", "run", "-a", str(archive), "bicycle.ipynb")
        tests = json.loads((own / "results.json").read_text("utf-8"))["tests"]
        assert sum(test.get("score", 0) for test in tests) == POINTS[student]
        if student != BLANK:
            assert_told(student, "\n".join(test["output"] for test in tests))
