"""Programs that students write: right ones pass, wrong ones get their input and their name."""

import linecache
import re
import sys

import numpy as np
import pytest
from program_mutants import mutants

import book  # noqa: F401 (opens the course)
from courseware import explaining, judge, programs
from courseware.course import course
from courseware.errors import CourseError
from courseware.programs.picture import answer_figure, render_answer
from courseware.programs.program import all_programs
from courseware.programs.storing import draw_cases, store
from courseware.script import engine

PROGRAMS = all_programs()
STEP = PROGRAMS["bicycle-p1"]
EACH = pytest.mark.parametrize("name", PROGRAMS)


def load(source, function, file="<program>"):
    """A function from the text of a cell."""
    linecache.cache[file] = (len(source), None, source.splitlines(True), file)
    names = {"np": np}
    exec(compile(source, file, "exec"), names)
    return names[function]


def judged(program, source):
    return judge.check(load(source, program.definition.name), store(program))


def step(*lines):
    """A verdict on `car_step` with these lines."""
    body = "".join(f"    {line}\n" for line in lines)
    return judged(STEP, f"def car_step(pose, v, phi, L, dt):\n{body}")


# --- all that are declared ------------------------------------------------------------------


@pytest.mark.parametrize("chapter", course().modules("programs"))
def test_a_chapter_has_three(chapter):
    own = [name for name, program in PROGRAMS.items() if program.topic == chapter]
    assert len(own) >= 3, f"book/{chapter}/programs.py has {own}: at least three"


@EACH
def test_the_solution_is_right(name):
    verdict = judged(PROGRAMS[name], PROGRAMS[name].solution)
    assert verdict.right, verdict
    for special in PROGRAMS[name].specials:
        assert special in str(verdict)


@EACH
def test_a_starter_returns_nothing_or_makes_a_mistake_that_is_named(name):
    program = PROGRAMS[name]
    verdict = judged(program, program.starter)
    if program.is_new:
        assert "It returns nothing" in str(verdict)
    else:
        assert "its mistake is still in it" in str(verdict)


@EACH
def test_each_mistake_is_named_by_its_answers(name):
    """What has a name is far from right on enough inputs, and another only beside it."""
    stored = store(PROGRAMS[name])
    for known in stored["known"]:
        found = explaining.find_known(known["answers"], stored)
        if "taken for degrees" not in known["feedback"]:
            assert known["feedback"] in found


@EACH
def test_a_picture_shows_the_right_answer_and_the_one_that_came(name):
    """All that it draws is in its window."""
    program = PROGRAMS[name]
    right, answer, given = wrong_answer(program)
    drawn, good = (render_answer(program, (*right, *each, *given)) for each in (answer, right))
    assert drawn != good
    assert "NaN" not in drawn
    shown = engine.run(
        "((figure, numbers) => { courseware.renderAnswer(figure, numbers); const state = "
        "courseware.startState(figure); return courseware.compute(figure, "
        "courseware.settings(figure, state)); })"
        f"({answer_figure(program).code}, {[*right, *answer, *given]})"
    )
    x_low, x_high, y_low, y_high = shown["view"]
    at = np.take(shown["values"], answer_figure(program).compiled["contain"]).reshape(-1, 2)
    assert (at > [x_low, y_low]).all()
    assert (at < [x_high, y_high]).all()


def wrong_answer(program):
    """Right numbers, those of a known mistake, and an input on which they are far apart."""
    stored = store(program)
    for known in stored["known"]:
        for case, answer in zip(explaining.ordinary(stored), known["answers"], strict=True):
            right = np.array(case["right"])
            if not explaining.same(np.array(answer), right, case, stored, 1e4):
                return (
                    case["right"],
                    answer,
                    np.hstack([*map(np.ravel, case["arguments"])]).tolist(),
                )
    raise AssertionError("no mistake is wrong")


def test_a_verdict_has_the_numbers_of_its_picture():
    wrong = judged(STEP, STEP.solution.replace("y + chord", "y - chord"))
    case = store(STEP)["cases"][0]
    assert wrong.numbers[:3] == tuple(case["right"])
    assert wrong.numbers[6:] == (*case["arguments"][0], *case["arguments"][1:])
    assert judged(STEP, STEP.starter).numbers == (), "no answer"
    assert step("return pose / 0").numbers == (), "no number"
    assert judged(STEP, STEP.solution).numbers == ()
    box = programs.show("odometry-p2")
    assert "rk-answer" not in box.check(lambda before, after, span: None)._repr_html_()
    shown = box.check(lambda before, after, span: after - before)
    assert 'class="rk-answer"><svg' in shown._repr_html_()


@pytest.mark.slow
@EACH
def test_small_changes_of_a_solution_are_refused(name):
    """Of sign, function, number, name: those that are left compute the same.

    Two always may: half a span more or less is the same on a counter that wraps round, and the
    middle column of a matrix meets a speed of 0.
    """
    program = PROGRAMS[name]
    changed = [*mutants(program.solution)]
    left = [source for source in changed if judged(program, source).right]
    assert len(left) <= max(2, 0.05 * len(changed)), "\n\n".join(left)


@EACH
@pytest.mark.parametrize("width", [0.1, 0.03, 0.01])
def test_a_branch_for_a_special_case_that_is_too_wide_is_wrong_on_some_input(name, width):
    """Within a part of the ranges it takes an input for the special case itself."""
    program, stored = PROGRAMS[name], store(PROGRAMS[name])
    inputs = [numbers for *_, numbers in draw_cases(program)]
    for special, fixed in program.specials.items():
        refused = 0
        for numbers, case in zip(inputs, stored["cases"], strict=True):
            away = [abs(numbers[s] - at) / span(program, s) for s, at in fixed.items()]
            if case["special"] == special and case["near"] and max(away) <= width:
                given = [np.array(x) for x in program.arguments(*(numbers | fixed).values())]
                try:
                    answer = np.ravel(program.right(*given))
                except ValueError:  # such a mixture may be out of reach
                    continue
                refused += not explaining.agrees(answer, case, stored)
        assert refused >= 2, special


def span(program, symbol):
    low, high = program.ranges.get(symbol, (symbol.low, symbol.high))
    return high - low


WIDE = "On all ordinary inputs it is right. Near a special case"
FEW = "ordinary inputs it is right: is a branch (`if`) missing, or too wide?"
LOST = "It is nearly right on all inputs, but about six digits are asked."
# a program, what is changed in its solution, and the explanation: "" is none
EXPLAINED = [
    ("bicycle-p2", "    return", "    if abs(y) < 0.3: return 0.0\n    return", FEW),
    ("bicycle-p2", "    return", "    if abs(y) < 0.03: return 0.0\n    return", WIDE),
    ("bicycle-p2", "x**2 + y**2", "x**2 - y**2", ""),
    ("bicycle-p2", "* y /", "* abs(y) /", ""),  # not "behind the car"
    ("bicycle-p2", "np.arctan(", "-np.arctan(", "with the sign the other way round"),
    ("bicycle-p3", "v / np.cos(phi)", "v * np.cos(phi)", ""),  # near for small angles only
    ("bicycle-p3", "np.tan(phi)", "np.sin(phi)", ""),
    ("odometry-p1", "np.pi", "3.14", LOST),
    ("odometry-p1", "np.sin(beta / 2)", "beta / 2", LOST),
    ("odometry-p2", "- span / 2", "- span / 2 - 1", ""),  # -1701 for -1700 is no rounding
    ("elbow-arm-p2", "    lead", "    if abs(A) > 0.98: theta3 *= A < 0\n    lead", WIDE),
    ("elbow-arm-p2", "    lead", "    if A > 0.9995: theta3 = 0\n    lead", WIDE),
    ("elbow-arm-p2", "np.array([np", "np.degrees([np", "in degrees"),
    ("elbow-arm-p2", "np.array([np.arctan2(y, x), theta2, theta3])",
     "np.array([np.arctan2(y, x), theta2 + 2 * lead, -theta3]) * 2", "twice the right value"),
    ("frames-p1", "x, y, turn_db", "x, y, 1.0001 * turn_db", LOST),
]  # fmt: skip


@pytest.mark.parametrize(("name", "old", "new", "words"), EXPLAINED)
def test_an_explanation_is_the_one_that_fits(name, old, new, words):
    program = PROGRAMS[name]
    assert old in program.solution
    told = judged(program, program.solution.replace(old, new))
    assert not told.right
    assert ("(" in told.lines[0]) == (words == WIDE), "a special case has no part in it"
    assert words in str(told) if words else len(told.lines) == 4, told


def test_an_angle_is_shown_on_the_turn_of_the_answer():
    told = judged(STEP, STEP.solution.replace("theta + turn]", "theta + turn + 0.1]"))
    given, right = (float(line.rpartition(", ")[2].strip("].")) for line in told.lines[2:4])
    assert given - right == pytest.approx(0.1)


def test_who_replaces_a_function_of_numpy_gains_nothing(monkeypatch):
    for name in ("all", "allclose", "array_equal", "isclose"):
        monkeypatch.setattr(np, name, lambda *_, **__: True)
    assert not step("return [1, 2, 3]").right


# --- the verdict ----------------------------------------------------------------------------

TURN = "turn = v * dt / L * np.tan(phi)"
HEAD = ("x, y, theta = pose", TURN, "m, u = theta + turn / 2, turn / 2 / np.pi")
END = "w = v * dt * np.sinc(u); return [x + w * np.cos(m), y + w * np.sin(m), theta + turn]"


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (["pass"], "It returns nothing"),
        (["print(pose)"], "It returns nothing"),
        (
            ['return "0.5, 1, 2"'],
            "It returns text, '0.5, 1, 2'. Asked: 3 numbers, in the shape (3,).",
        ),
        (
            ["return [1, 2]"],
            "It returns 2 numbers, in the shape (2,). Asked: 3 numbers, in the shape (3,).",
        ),
        (["return [[1], [2, 3], 4]"], "It returns lists of different lengths"),
        (["return [1, 2, 3j]"], "It returns a list, [1, 2, 3j]"),
        (["pose[2] += 1", "return pose"], "It changes an array that it was given"),
        (["while True: pass"], "It does not end"),
        (["n = 0", "while n < 1: n -= 1"], "It does not end"),
        (["return pose + heading"], "Line 2, `return pose + heading`: NameError"),
        (["return car_step(pose, v, phi, L, dt)"], "RecursionError"),
        (["return car_step(pose, v, phi, L, dt)"], "calls itself without an end"),
        (["return 1 / 0"], "has this input a case of its own?"),
        (["return pose + None"], "of another kind than it takes"),
        (["return pose[3]"], "the first has the number 0"),
        (
            ["from robokin import bicycle", "return bicycle.path(pose, v, phi, L, dt)[-1]"],
            "It calls robokin: write down yourself what that function does.",
        ),
        (
            [*HEAD[:2], HEAD[2].replace("turn / 2,", "turn // 2,"), END],
            "Its // drops all that comes after the point",
        ),
    ],
)
def test_slips_of_programmers(lines, words):
    verdict = step(*lines)
    assert not verdict.right
    assert words in str(verdict), verdict


def test_a_special_case_alone_is_named():
    """The textbook's arc divides by zero straight ahead."""
    verdict = step(*HEAD[:2], "R = v * dt / turn", "t = theta + turn",
                   "return [x + R * (np.sin(t) - np.sin(theta)),"
                   " y - R * (np.cos(t) - np.cos(theta)), t]")  # fmt: skip
    assert "wrong (straight ahead):" in str(verdict)
    assert "nan means: no number. It comes of 0/0" in str(verdict)
    assert "On all ordinary inputs it is right" in str(verdict)


def test_what_is_wrong_on_few_ordinary_inputs_is_not_called_right_on_all():
    verdict = step(*HEAD, "if x < -1.5: return pose", "if phi == 0: return pose", END)
    assert not verdict.right
    assert "On all ordinary inputs it is right" not in str(verdict)


def test_a_number_from_outside_is_asked_about():
    """It may be a cell's above: where it is right all the same, nothing is said."""
    names = {"np": np, "L_car": 2.5}
    source = "def car_step(pose, v, phi, L, dt):\n    return pose + L_car\n"
    exec(compile(source, "<cell>", "exec"), names)
    told = str(judge.check(names["car_step"], store(STEP)))
    assert "It takes L_car from outside of the function" in told


def test_a_whole_division_is_asked_about_in_a_lambda_too():
    told = judged(STEP, "car_step = lambda pose, v, phi, L, dt: pose // 2")
    assert "Its // drops all that comes after the point" in str(told)


RETURN = STEP.solution.partition("\n")[2]
ORDINARY = {
    "a star import": f"from numpy import *\n{STEP.solution.replace('np.pi', 'pi')}",
    "an import of a name": f"from math import pi\n{STEP.solution.replace('np.pi', 'pi')}",
    "an import inside": STEP.solution.replace(
        "    turn", "    import wave, this\n    from math import pi\n    turn", 1
    ),
    "a constant in if, for, try": "if True:\n    ONE = 1\nfor TWO in [2]:\n    pass\n"
    "try:\n    THREE = 3\nfinally:\n    pass\n"
    + STEP.solution.replace("return", "return TWO * ONE * 3 / THREE / 2 *"),
    "a decorator": "from functools import wraps\n\n\ndef same(f):\n    @wraps(f)\n"
    "    def inner(*given):\n        return f(*given)\n    return inner\n\n\n@same\n"
    + STEP.solution,
    "a helper": f"def of(pose, v, phi, L, dt):\n{RETURN}\n\ncar_step = lambda *given: of(*given)",
    "a callable": f"class Step:\n  def __call__(self, pose, v, phi, L, dt):\n{RETURN}\n"
    "car_step = Step()",
}


@pytest.mark.parametrize("source", ORDINARY.values(), ids=ORDINARY)
def test_ordinary_python_is_right(source):
    verdict = judged(STEP, source)
    assert verdict.right, verdict


ENDS = {
    "import sys; sys.exit(0)": "It ends the program",
    "raise SystemExit": "It ends the program",
    "import os; os._exit(0)": "It ends Python itself, or makes it crash.",
    "import os; os.kill(os.getpid(), 9)": "It ends Python itself, or makes it crash.",
    "import threading; threading.Thread(target=threading.Event().wait).start()": "returns nothing",
    "while True:\n  try: 1 / 0\n  except Exception: continue": "It does not end",
    "while True:\n  try:\n    while True: pass\n  except: pass": "stopped after 3 seconds",
    "while True: print(pose)": "It does not end",
}


@pytest.mark.skipif(sys.platform != "linux", reason="no process of its own")
@pytest.mark.parametrize("code", ENDS)
def test_whatever_a_function_does_ends_with_it(code, monkeypatch):
    monkeypatch.setattr(judge, "PATIENCE", 3)
    assert ENDS[code] in str(step(*code.split("\n")))


@pytest.mark.parametrize("takes", ["pose, v", "", "*, pose", "a, b, c, d, e, f"])
def test_other_parameters_are_told(takes):
    verdict = judged(STEP, f"def car_step({takes}): return 1")
    assert str(verdict) == (
        f"Not yet. car_step takes ({takes}), but must take (pose, v, phi, L, dt)."
    )


def test_the_rows_of_a_matrix_that_are_wrong_are_told():
    program = PROGRAMS["elbow-arm-p1"]
    wrong = program.solution.replace("z3 = r2 +", "z3 = r2 -").replace("z2 + a3", "z2 - a3", 1)
    assert "Wrong: row 3, counted from 0." in str(judged(program, wrong))
    assert "Wrong: row" not in str(judged(program, "def places(theta, *_): return np.ones((4, 3))"))


def test_what_is_no_function_is_said_so():
    assert "There is no function car_step here, but 3." in str(judge.check(3, store(STEP)))
    assert "There is no function car_step here: has it" in str(judge.check(None, store(STEP)))


def test_all_right_answers_are_right_where_there_are_several():
    program = PROGRAMS["euler-p1"]
    other = program.solution + (
        "\n\nfirst = yaw_pitch_roll\n\ndef yaw_pitch_roll(R):\n"
        "    a, b, c = np.moveaxis(first(R), -1, 0)\n"
        "    return np.stack([a + np.pi, np.pi - b, c + np.pi], axis=-1)\n"
    )
    assert judged(program, other).right


def test_the_verdict_is_for_a_page_too():
    html = judged(STEP, STEP.starter)._repr_html_()
    assert "<pre>car_step(np.array([" in html
    assert html.startswith('<div class="rk-judged rk-wrong" role="status"')
    assert "without a <code>return</code>" in html


def test_what_is_asked_has_hints_that_open_one_another():
    html = programs.show("bicycle-p1")._repr_mimebundle_()["text/html"]
    assert re.findall("<summary>(.*?)</summary>", html) == [
        "Hint 1",
        "Hint 2",
        "Hint 3",
        "A solution",
    ]


def test_a_name_that_there_is_not_is_refused():
    with pytest.raises(CourseError, match="there is no program 'bicycle-p9'"):
        programs.show("bicycle-p9")
