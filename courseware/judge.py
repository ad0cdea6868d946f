"""The judge of programs: runs a student's function on stored inputs and says what is wrong with it.

It needs nothing but NumPy, `explaining.py`, and the numbers that `storing.py` has written. A
function is refused with the simplest input on which it is wrong; where its answers are those of a
known mistake on all ordinary inputs, that is named.

A file is run in a process of its own, which only sends answers: whatever the file does ends there.
On Linux, and so in graders and hubs, a function of a notebook is, too. A page has its worker.
"""

import dis
import inspect
import json
import linecache
import os
import runpy
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np

from courseware.explaining import Stored, Verdict, agrees, describe_input, explain, join_numbers

STEPS = 2_000_000  # of the student's own code in one call: more is an endless loop
PATIENCE = 60  # seconds for all answers, where no step is counted
ERRORS = {
    ZeroDivisionError: "Something is divided by 0: has this input a case of its own?",
    RecursionError: "The function calls itself without an end.",
    TypeError: "What the line works on is of another kind than it takes: often None, or a list in "
    "place of an array.",
    IndexError: "There are fewer places than that; the first has the number 0.",
}


class Slip(BaseException):
    """What a programmer did that gives no numbers to compare, in words for the student.

    It is raised inside the function, too, and no `except Exception` there shall take it.
    """


Tried = dict[str, Any]  # answers: flat lists; slip: on the next input; hints; or refused: words


def check(function: Any, stored: Stored) -> Verdict:
    """Judge a function."""
    if sys.platform != "linux":  # NumPy and threads bear no fork
        return judge(try_function(function, stored), stored)
    return judge(run_apart("fork", try_function, function, stored), stored)


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
    stored = read_stored(name)
    verdict = judge(run_apart("spawn", try_file, file, stored), stored)
    print(f"{name}: {verdict}")
    return 0 if verdict.right else 1


def run_apart(start: str, work: Callable[..., Tried], *given: Any) -> Tried:
    """Return the result of a function in a process of its own, or that it has none."""
    import multiprocessing  # not in a page, whose Python has none

    context: Any = multiprocessing.get_context(start)
    read, write = context.Pipe(duplex=False)
    child = context.Process(target=send_result, args=(write, work, *given))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of threads, which a child has not
        child.start()
    write.close()
    try:
        if not read.poll(PATIENCE):
            return {"refused": f"It does not end: stopped after {PATIENCE} seconds."}
        tried: Tried = json.loads(read.recv_bytes())
        return tried
    except EOFError:
        return {"refused": "It ends Python itself, or makes it crash."}
    finally:
        child.kill()
        child.join()


def send_result(write: Any, work: Callable[..., Tried], *given: Any) -> None:
    write.send_bytes(json.dumps(work(*given)).encode())


def try_file(file: str, stored: Stored) -> Tried:
    """Try the function in a file."""
    try:
        with silence():
            names = runpy.run_path(file)
    except BaseException as error:  # also SystemExit, which would pass
        words = "".join(traceback.format_exception(error, limit=0)).rstrip()
        return {"refused": f"{file} cannot be run.\n{words}"}
    return try_function(names.get(stored["function"]), stored)


def try_function(function: Any, stored: Stored) -> Tried:
    """Return the answers of a function, up to the first input on which it gives none."""
    answers: list[list[float]] = []
    tried = {"answers": answers, "slip": "", "hints": find_hints(function)}
    with silence(), np.errstate(all="ignore"):
        try:
            refuse_function(function, stored)
        except Slip as slip:
            return {"refused": str(slip)}
        try:
            for case in stored["cases"]:
                answers.append(call(function, case, stored).tolist())
        except Slip as slip:
            tried["slip"] = str(slip)
    return tried


@np.errstate(all="ignore")
def judge(tried: Tried, stored: Stored) -> Verdict:
    """Judge what came of a function."""
    if "refused" in tried:
        return Verdict(False, (f"Not yet. {tried['refused']}",))
    answers, cases = [*map(np.array, tried["answers"])], stored["cases"]
    for place, (answer, case) in enumerate(zip(answers, cases, strict=False)):
        if not agrees(answer, case, stored):
            lines = explain(answers, place, stored, tried["hints"])
            numbers = join_numbers(case["right"], answer, *case["arguments"])
            shown = tuple(numbers.tolist()) if np.isfinite(numbers).all() else ()
            return Verdict(False, (*describe_input(case, stored), *lines), shown)
    if tried["slip"]:
        return Verdict(False, (*describe_input(cases[len(answers)], stored), tried["slip"]))
    specials = dict.fromkeys(case["special"] for case in cases if case["special"])
    also = f", also: {'; '.join(specials)}" if specials else ""
    return Verdict(True, (f"✓ Right on all {len(cases)} inputs{also}.",))


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
        if event == "call" and module and module == stored["library"]:
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


def shorten(value: Any) -> str:
    text = repr(value)
    return text if len(text) < 60 else f"{text[:57]}…"


if __name__ == "__main__":
    sys.exit(main())
