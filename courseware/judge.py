"""The judge of programs: runs a student's function on stored inputs and says what is wrong with it.

It needs nothing but NumPy, and the numbers that `storing.py` has written. A function is refused
with the simplest input on which it is wrong; where its answers are those of a known mistake on all
ordinary inputs, that is named.

On Linux, and so in graders and hubs, all this happens in a process of its own: whatever a function
does ends there. A page has its worker for that.
"""

import dis
import inspect
import json
import linecache
import os
import re
import runpy
import select
import signal
import sys
import time
import traceback
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from functools import cache
from html import escape
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

import numpy as np

Stored = Mapping[str, Any]
TELLING = 20  # inputs on which a mistake must be far from right, before it is named
FAR = 10  # tolerances
NEAR = 1000  # tolerances: digits are missing, the formula is right
LEVEL = "An extra, if you like, is to take arrays of many inputs at once."
BORDER = "padding: .5rem .9rem; border-left: 4px solid {}"
COLORS = {True: "#2e8b57", False: "#c2344b"}  # of right and of wrong; pages may be dark
SIZE, LEAST = 1e-6, 1e-3  # a tolerance is this part of an answer's size; the least such size
STEPS = 2_000_000  # of the student's own code in one call: more is an endless loop
PATIENCE = 60  # seconds for a verdict, where no step is counted
KNOWN = "This is what you get {}."
ERRORS = {
    ZeroDivisionError: "Something is divided by 0: has this input a case of its own?",
    RecursionError: "The function calls itself without an end.",
    TypeError: "What the line works on is of another kind than it takes: often None, or a list in "
    "place of an array.",
    IndexError: "There are fewer places than that; the first has the number 0.",
}
SLIPS: dict[str, Callable[[Any, Stored], Any]] = {
    "with the sign the other way round": lambda right, _: -right,
    "with twice the right value": lambda right, _: 2 * right,
    "with half the right value": lambda right, _: right / 2,
    "when the angle is returned in degrees": lambda right, stored: np.where(
        stored["angles"], np.degrees(right), right
    ),
    "with the numbers in the opposite order": lambda right, _: right[::-1],
    "with rows and columns exchanged": lambda right, stored: (
        right.reshape(stored["shape"]).T.ravel() if len(stored["shape"]) == 2 else right
    ),
}


class Slip(BaseException):
    """What a programmer did that gives no numbers to compare, in words for the student.

    It is raised inside the function, too, and no `except Exception` there shall take it.
    """


@dataclass(frozen=True)
class Verdict:
    """The judgement of a program. Its text is for the student.

    lines: of the text; those that begin with a blank are code. numbers: of the picture that shows
    what is wrong: the right answer, the student's answer, the input; none where one is no number.
    picture: of these, as HTML, where there is something that draws.
    """

    right: bool
    lines: tuple[str, ...]
    numbers: tuple[float, ...] = ()
    picture: str = ""

    def __str__(self) -> str:
        return "\n".join(self.lines)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        parts = (
            f"<pre>{escape(line.strip())}</pre>" if line[0] == " " else f"<p>{quote_code(line)}</p>"
            for line in self.lines
        )
        kind, style = "right" if self.right else "wrong", BORDER.format(COLORS[self.right])
        head = f'<div class="rk-judged rk-{kind}" role="status" style="{style}">'
        return f"{head}{''.join(parts)}</div>{self.picture}"


def check(function: Any, stored: Stored) -> Verdict:
    """Judge a function."""
    return judge_apart(lambda: judge(function, stored))


def read_and_check(name: str, function: Any) -> Verdict:
    """Judge a function by the numbers of its file."""
    return check(function, read_stored(name))


def read_stored(name: str) -> Stored:
    """Return what the file `name.json` beside this one has."""
    stored: Stored = json.loads(Path(__file__).with_name(f"{name}.json").read_text("utf-8"))
    return stored


def main() -> int:
    """Judge a file: `python judge.py bicycle-p1 bicycle_p1.py` fails unless it is right."""
    name, file = sys.argv[1:]
    verdict = judge_apart(lambda: judge_file(file, read_stored(name)))
    print(f"{name}: {verdict}")
    return 0 if verdict.right else 1


def judge_apart(work: Callable[[], Verdict]) -> Verdict:
    """Return the verdict of a process of its own; elsewhere NumPy and threads bear no fork."""
    if sys.platform != "linux":
        return work()
    read, write = os.pipe()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of threads, which a child has not
        child = os.fork()
    if not child:
        try:
            verdict = work()
            with open(write, "w", encoding="utf-8") as pipe:
                json.dump([verdict.right, verdict.lines, verdict.numbers], pipe)
        finally:
            os._exit(0)  # whatever still runs
    os.close(write)
    with open(read, "rb") as pipe:
        try:
            in_time, *_ = select.select([pipe], [], [], PATIENCE)
            text = pipe.read() if in_time else b""
        finally:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
    if text:
        right, lines, numbers = json.loads(text)
        return Verdict(right, tuple(lines), tuple(numbers))
    why = (
        "It ends Python itself, or makes it crash."
        if in_time
        else (f"It does not end: stopped after {PATIENCE} seconds.")
    )
    return Verdict(False, (f"Not yet. {why}",))


def judge_file(file: str, stored: Stored) -> Verdict:
    """Judge the function in a file."""
    try:
        with silence():
            names = runpy.run_path(file)
    except BaseException as error:  # also SystemExit, which would pass
        words = "".join(traceback.format_exception(error, limit=0)).rstrip()
        return Verdict(False, (f"Not yet. {file} cannot be run.\n{words}",))
    return judge(names.get(stored["function"]), stored)


def judge(function: Any, stored: Stored) -> Verdict:
    """Judge a function in this process."""
    with silence(), np.errstate(all="ignore"):
        try:
            refuse_function(function, stored)
        except Slip as slip:
            return Verdict(False, (f"Not yet. {slip}",))
        for place, case in enumerate(stored["cases"]):
            try:
                answer = call(function, case, stored)
            except Slip as slip:
                return refuse(stored, place, [str(slip)])
            if not agrees(answer, case, stored):
                return refuse_answer(function, stored, place, answer)
        return Verdict(True, (describe_success(stored), *describe_arrays(function, stored)))


@contextmanager
def silence() -> Iterator[None]:
    """Drop what is printed, which may be without end."""
    with open(os.devnull, "w", encoding="utf-8") as no, redirect_stdout(no), redirect_stderr(no):
        yield


def refuse_function(function: Any, stored: Stored) -> None:
    """Raise Slip if this is no function that takes such arguments."""
    name = stored["function"]
    if function is None:
        raise Slip(f"There is no function {name} here: has it another name?")
    if not callable(function):
        words = f"There is no function {name} here, but {shorten(function)}"
        raise Slip(f"{words}. Give its name alone, without brackets.")
    try:
        takes = inspect.signature(function)
    except ValueError:
        return  # it is not written in Python
    try:
        takes.bind(*stored["cases"][0]["arguments"])
    except TypeError:
        raise Slip(f"{name} takes {takes}, but must take ({stored['parameters']}).") from None


# --- one call --------------------------------------------------------------------------------


def call(function: Callable[..., Any], case: Stored, stored: Stored) -> Any:
    """Return the answer to an input as a flat array; raise Slip if it is none."""
    given, kept = (as_arguments(case["arguments"]) for _ in range(2))
    steps, stopped = 0, ""

    def trace(frame: FrameType, event: str, _: Any) -> Any:
        nonlocal steps, stopped
        module = frame.f_globals.get("__name__", "").partition(".")[0]
        if event == "call" and module == stored["library"]:
            stopped = f"It calls {module}: write down yourself what that function does."
            raise Slip(stopped)
        if not is_own(frame):
            return None
        steps += 1
        if steps > STEPS:
            stopped = (
                f"It does not end: stopped after {STEPS:,} steps. Does the condition of its loop "
                "ever become false?"
            )
            raise Slip(stopped)
        frame.f_trace_opcodes = True  # `while True: pass` has no lines
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        answer = function(*given)
    except (Slip, KeyboardInterrupt):
        raise
    except BaseException as error:  # also SystemExit
        raise Slip(describe_error(error)) from error
    finally:
        sys.settrace(before)
    if stopped:  # and the function took the Slip for an error
        raise Slip(stopped)
    if not all(map(np.array_equal, given, kept)):
        raise Slip("It changes an array that it was given: make a copy first, with np.array(…).")
    return to_numbers(answer, stored)


def is_own(frame: FrameType) -> bool:
    """Return whether code is the student's: of no module that was imported."""
    return frame.f_globals.get("__spec__") is None and frame.f_globals is not globals()


def as_arguments(stored: list[Any]) -> list[Any]:
    """Return an input as the function gets it: lists are arrays."""
    return [np.array(x) if isinstance(x, list) else x for x in stored]


def to_numbers(answer: Any, stored: Stored) -> Any:
    """Return an answer as a flat array of numbers; raise Slip if it is none."""
    shape = tuple(stored["shape"])
    asked = f"{np.prod(shape)} numbers, in the shape {shape}" if shape else "one number"
    if answer is None:
        raise Slip(
            "It returns nothing: here it comes to its end without a `return` (`print` only shows)."
        )
    try:
        numbers = np.asarray(answer)
    except ValueError:
        raise Slip(f"It returns lists of different lengths. Asked: {asked}.") from None
    if numbers.dtype.kind not in "biuf":
        kind = "text" if numbers.dtype.kind in "US" else f"a {type(answer).__name__}"
        raise Slip(f"It returns {kind}, {shorten(answer)}. Asked: {asked}.")
    if numbers.shape != shape and not (numbers.size == 1 and not shape):
        count = f"{numbers.size} number{'s' * (numbers.size != 1)}"
        raise Slip(f"It returns {count}, in the shape {numbers.shape}. Asked: {asked}.")
    return numbers.astype(float).ravel()


def agrees(answer: Any, case: Stored, stored: Stored) -> bool:
    """Return whether an answer is right."""
    return same(answer, np.array(case["right"]), case, stored)


def same(answer: Any, other: Any, case: Stored, stored: Stored, factor: float = 1.0) -> bool:
    """Return whether two answers to an input are the same, within a number of tolerances.

    Where several answers are right, what they do is compared.
    """
    if not stored["compared_value"]:
        return bool(np.all(apart(answer, other, stored) <= factor * np.array(stored["tolerance"])))
    one, two = (compute_compared_value(each, case, stored) for each in (answer, other))
    size = max(LEAST, np.abs(two).max())
    return bool(np.allclose(one, two, rtol=0, atol=factor * SIZE * size, equal_nan=True))


def apart(answer: Any, right: Any, stored: Stored) -> Any:
    """Return how far two answers are apart, number by number; NaN meets NaN."""
    difference = answer - right
    turned = np.remainder(difference + np.pi, 2 * np.pi) - np.pi
    size = np.abs(np.where(stored["circle"], turned, difference))
    alike = (answer == right) | (np.isnan(answer) & np.isnan(right))
    return np.where(alike, 0.0, np.nan_to_num(size, nan=np.inf))


def compute_compared_value(answer: Any, case: Stored, stored: Stored) -> Any:
    """Return what an answer does, by the formulas that are stored for it."""
    names = {"numpy": np, "given": join_numbers(answer, *case["arguments"])}
    return np.array(eval(read_formulas(stored["compared_value"]), names))


def join_numbers(*parts: Any) -> Any:
    """Return all numbers of these numbers and arrays in a row."""
    return np.hstack([np.ravel(part) for part in parts])


@cache
def read_formulas(text: str) -> CodeType:
    return compile(text, "<formulas>", "eval")


# --- what is wrong ---------------------------------------------------------------------------


def refuse(stored: Stored, place: int, lines: list[str], **more: Any) -> Verdict:
    """Return the verdict of a wrong program: the input first."""
    case = stored["cases"][place]
    where = f" ({case['special']})" if case["special"] else ""
    shown = ", ".join(format_argument(x) for x in case["arguments"])
    first = f"Not yet. This is the simplest input on which it is wrong{where}:"
    return Verdict(False, (first, f" {stored['function']}({shown})", *lines), **more)


def refuse_answer(function: Callable[..., Any], stored: Stored, place: int, answer: Any) -> Verdict:
    """Return the verdict of a program whose answer is another: by how much, and why."""
    case = stored["cases"][place]
    right = np.array(case["right"])
    is_near = same(answer, right, case, stored, NEAR)
    digits = 13 if is_near else 7
    example = ", for example," if stored["compared_value"] else ""
    right_is = f"Right is{example} {format_answer(right, stored, digits)}."
    lines = [
        describe(answer, case, stored, digits),
        right_is + describe_rows(answer, right, stored),
    ]
    answers = all_answers(function, stored)
    known = find_known(answers, stored)
    lines += [entry["feedback"] for entry in known] or find_hints(function)
    if is_near and not known:
        lines.append(
            "It is nearly right, but about seven digits are asked. Digits get lost where almost "
            "equal numbers are subtracted, in a branch for small numbers that is too wide, by "
            "rounding, and by approximation."
        )
    elif case["special"] and all_right(answers, stored):
        lines.append(
            "On all ordinary inputs it is right: give this case a branch of its own, or "
            "find a formula that needs none."
        )
    numbers = join_numbers(right, answer, *case["arguments"])
    return refuse(
        stored,
        place,
        lines,
        numbers=tuple(numbers.tolist()) if np.isfinite(numbers).all() else (),
    )


def describe(answer: Any, case: Stored, stored: Stored, digits: int) -> str:
    """Say what answer."""
    words = f"It gives {format_answer(answer, stored, digits)}."
    if np.isnan(answer).any() and not np.isnan(case["right"]).any():
        words += (
            " nan means: no number. It comes of 0/0, inf/inf, 0·inf or inf − inf (look for a "
            "division by 0), of a root of a negative number, and of arccos or arcsin of a number "
            "beyond ±1. Rounding can lead there, and np.clip limits a number."
        )
    return words


def describe_rows(answer: Any, right: Any, stored: Stored) -> str:
    """Say which rows of a matrix are wrong, unless all are, or another answer could be right."""
    if len(stored["shape"]) < 2 or stored["compared_value"]:
        return ""
    far = apart(answer, right, stored) > stored["tolerance"]
    wrong = np.flatnonzero(far.reshape(stored["shape"]).any(axis=1))
    if len(wrong) == stored["shape"][0]:
        return ""
    return f" Wrong: row{'s' * (len(wrong) > 1)} {', '.join(map(str, wrong))}, counted from 0."


def ordinary(stored: Stored) -> list[Stored]:
    return [case for case in stored["cases"] if not case["special"]]


def all_answers(function: Callable[..., Any], stored: Stored) -> Any:
    """Return the answers to all ordinary inputs (n, numbers), or None if one has none."""
    try:
        return np.array([call(function, case, stored) for case in ordinary(stored)])
    except Slip:
        return None


def all_right(answers: Any, stored: Stored) -> bool:
    cases = ordinary(stored)
    return answers is not None and all(map(lambda a, c: agrees(a, c, stored), answers, cases))


def find_known(answers: Any, stored: Stored) -> list[Stored]:
    """Return the known mistakes whose answers these are, on all ordinary inputs."""
    if answers is None:
        return []
    rights = np.array([case["right"] for case in ordinary(stored)])
    candidates = [(known, np.array(known["answers"])) for known in stored["known"]]
    slips = [
        ({"name": words, "feedback": KNOWN.format(words)}, [slip(r, stored) for r in rights])
        for words, slip in SLIPS.items()
    ]
    found: list[Stored] = []
    for some in (candidates, slips):  # a slip of any answer only where no mistake is met
        found = found or [known for known, its in some if is_named(answers, its, stored)]
    return found


def is_named(answers: Any, its: Any, stored: Stored) -> bool:
    """Return whether answers are a mistake's own, and far from right on enough inputs."""
    cases = ordinary(stored)
    if not all(map(lambda a, b, case: same(a, b, case, stored), answers, its, cases)):
        return False
    rights = (np.array(case["right"]) for case in cases)
    near = map(lambda a, right, case: same(a, right, case, stored, FAR), its, rights, cases)
    return len(cases) - sum(near) >= TELLING


def find_hints(function: Any) -> list[str]:
    """Say what in a function may be meant otherwise: `//`, and numbers from outside."""
    code, words = getattr(function, "__code__", None), list[str]()
    for each in dis.get_instructions(code) if code else ():
        if each.argrepr in ("//", "//="):
            words.append("Its // drops all that comes after the point: should it be / ?")
        if each.opname == "LOAD_GLOBAL":
            value = function.__globals__.get(each.argval)
            if isinstance(value, float | np.ndarray) and np.any(value != np.pi):
                words.append(
                    f"It takes {each.argval} from outside of the function: should that be an "
                    "argument, or be computed inside?"
                )
    return list(dict.fromkeys(words))


def describe_error(error: BaseException) -> str:
    """Return the student's line in which an error was raised, and Python's message."""
    if isinstance(error, SystemExit):
        return "It ends the program: a function gives its answer back with `return`."
    frames = [step for step in traceback.walk_tb(error.__traceback__) if is_own(step[0])]
    where = ""
    for frame, number in frames[-1:]:
        line = linecache.getline(frame.f_code.co_filename, number).strip()
        where = f"Line {number}, `{line}`: " if line else ""
    words = [words for kind, words in ERRORS.items() if isinstance(error, kind)]
    return " ".join([f"{where}{type(error).__name__}: {error}.", *words])


# --- right -----------------------------------------------------------------------------------


def describe_success(stored: Stored) -> str:
    specials = list(dict.fromkeys(case["special"] for case in stored["cases"] if case["special"]))
    tried = f", also: {'; '.join(specials)}" if specials else ""
    return f"✓ Right on all {len(stored['cases'])} inputs{tried}."


def describe_arrays(function: Any, stored: Stored) -> list[str]:
    """Say whether the function takes arrays of inputs too, and how much faster that is."""
    if not stored["arrays"]:
        return []
    cases = ordinary(stored)
    stacks = [np.array(each) for each in zip(*(case["arguments"] for case in cases), strict=True)]
    start = time.perf_counter()
    for case in cases:
        function(*as_arguments(case["arguments"]))
    alone = time.perf_counter() - start
    start = time.perf_counter()
    try:
        answers = np.asarray(function(*stacks), dtype=float)
    except (Exception, SystemExit) as error:
        return [f"{LEVEL} So far it does not: {describe_error(error)}"]
    ratio, asked = alone / (time.perf_counter() - start), (len(cases), *stored["shape"])
    if answers.shape != asked:
        return [f"{LEVEL} So far it gives the shape {answers.shape}, asked is {asked}."]
    rows = answers.reshape(len(cases), -1)
    if not all_right(rows, stored):
        return [f"{LEVEL} So far it gives other numbers than with each input alone."]
    return [f"It takes arrays, too: {len(cases)} inputs at once are {ratio:.0f} times as fast."]


# --- texts -----------------------------------------------------------------------------------


def format_argument(value: Any) -> str:
    return f"np.array({value})" if isinstance(value, list) else repr(value)


def format_answer(answer: Any, stored: Stored, digits: int) -> str:
    """Return an answer as text."""
    texts = [f"{x + 0.0:.{digits}g}" for x in answer]
    return str(np.reshape(texts, stored["shape"]).tolist()).replace("'", "")


def quote_code(text: str) -> str:
    """Return a text as HTML, what stands in `…` as code."""
    return re.sub("`([^`]+)`", r"<code>\1</code>", escape(text))


def shorten(value: Any) -> str:
    text = repr(value)
    return text if len(text) < 60 else f"{text[:57]}…"


if __name__ == "__main__":
    sys.exit(main())
