"""Mutation testing: break one computing line at a time and see whether the tests notice.

    make mutate            the four modules, on two processors
    make mutate T=euler    only those whose name contains euler

The mutants are Cosmic Ray's, and those of `Swap` below; in messages, annotations and
decorators there are none. For each mutant this process, with everything slow already imported,
forks, and the fork runs the module's own tests up to the first failure: a few tenths of a second
instead of seconds (Unix only). The table goes to the terminal, the survivors to
`_build/mutation.txt`.
"""

import argparse
import ast
import gc
import os
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter, deque
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import mpmath  # noqa: F401  (here and below: imported once, for all forks)
import numpy  # noqa: F401
import parso
import pytest
import scipy.linalg
import scipy.spatial.transform  # noqa: F401
import sympy  # noqa: F401
from cosmic_ray.ast import Visitor, get_ast
from cosmic_ray.operators.operator import Operator
from cosmic_ray.operators.provider import OperatorProvider
from hypothesis import HealthCheck, Phase, settings

ROOT = Path(__file__).resolve().parents[1]
MODULES = ("motion", "euler", "elbow_arm", "wheels")
GOAL = 90  # percent killed
BROKEN = 70  # a fork's exit code if this program, not a test, has failed
# An operator is replaced by others of its family: + by << is only a TypeError.
FAMILIES = (
    {"Add", "Sub", "Mul", "Div", "FloorDiv", "Mod", "Pow"},
    {"BitAnd", "BitOr", "BitXor"},
    {"Eq", "NotEq", "Lt", "LtE", "Gt", "GtE"},
    {"Is", "IsNot"},
    {"Delete", "USub"},
    {"Delete", "Not"},
    {"Delete", "Invert"},
)
RARE = {"FloorDiv", "Mod", "Pow"}  # nor by these: such a mutant dies as soon as it runs
OTHERS = (
    "AddNot",
    "NumberReplacer",
    "ReplaceAndWithOr",
    "ReplaceFalseWithTrue",
    "ReplaceOrWithAnd",
    "ReplaceTrueWithFalse",
    "ZeroIterationForLoop",
)
PAIRS = (
    ("sin", "cos"),
    ("minimum", "maximum"),
    ("min", "max"),
    ("any", "all"),
    ("zeros", "ones"),
    ("+=", "-="),
    ("*=", "/="),
    ("|=", "&="),
)


class Swap(Operator):
    """One word or sign in place of another: what Cosmic Ray has no operator for."""

    def __init__(self, others):
        self.others = others

    def mutation_positions(self, node):
        if isinstance(node, parso.tree.Leaf) and node.value in self.others:
            yield node.start_pos, node.end_pos

    def mutate(self, node, index):
        node.value = self.others[node.value]
        return node

    @classmethod
    def examples(cls):
        return ()


@dataclass
class Mutant:
    line: int
    column: int
    what: str  # the operator's name
    before: str
    after: str
    code: str
    result: str = ""  # the test that failed, or how else it ended; "" if it survived


class Replacing(Visitor):
    """Replaces what an operator finds the n-th time, or, with n None, lists what it finds."""

    def __init__(self, operator, n=None):
        self.operator, self.n, self.found = operator, n, []

    def visit(self, node):
        for index, (start, _) in enumerate(self.operator.mutation_positions(node)):
            if len(self.found) == self.n:
                node = self.operator.mutate(node, index)
            self.found.append(start)
        return node


def operators() -> Iterator[tuple[str, Operator]]:
    provider = OperatorProvider()
    for name in provider:
        words = name.split("_")[1:]  # from, to
        related = any(set(words) <= family for family in FAMILIES) and not RARE & {*words[1:]}
        if related if words else name in OTHERS:
            yield name.removeprefix("Replace"), provider[name]()
    yield "Swap", Swap({a: b for pair in PAIRS for a, b in (pair, pair[::-1])})
    yield "Assign", Swap({sign: "=" for sign in ("+=", "-=", "*=", "/=", "|=", "&=")})


def left_out(code: str) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """From where to where nothing is computed: messages, annotations, decorators, imports."""
    found: list[ast.AST | None] = []
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Raise | ast.Import | ast.ImportFrom):
            found.append(node)
        elif isinstance(node, ast.AnnAssign):
            found.append(node.annotation)
        elif isinstance(node, ast.ClassDef | ast.FunctionDef):
            found += node.decorator_list
        if isinstance(node, ast.FunctionDef):
            every = (*node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg)
            found += [node.returns, *(arg.annotation for arg in every if arg)]
            if node.name.endswith("_message"):
                found.append(node)
    lines = [line.encode() for line in code.splitlines()]

    def place(line: int, column: int) -> tuple[int, int]:  # ast counts bytes, parso characters
        return line, len(lines[line - 1][:column].decode())

    return [
        (place(node.lineno, node.col_offset), place(node.end_lineno, node.end_col_offset))
        for node in found
        if node is not None
    ]


def mutants(code: str) -> list[Mutant]:
    """Every mutant of a module, each text once."""
    out, seen, holes = [], {ast.dump(ast.parse(code))}, left_out(code)
    for name, operator in operators():
        looking = Replacing(operator)
        looking.walk(get_ast(code))
        for n, place in enumerate(looking.found):
            if any(start <= place < end for start, end in holes):
                continue
            mutated = Replacing(operator, n).walk(get_ast(code)).get_code()
            try:
                meaning = ast.dump(ast.parse(mutated))
            except SyntaxError:
                continue
            if meaning in seen:  # as x + -y and x - +y are
                continue
            seen.add(meaning)
            line = place[0]
            before, after = (text.splitlines()[line - 1].strip() for text in (code, mutated))
            out.append(Mutant(*place, name, before, after, mutated))
    return sorted(out, key=lambda mutant: (mutant.line, mutant.column))


class FirstFailure:
    """A pytest plugin that writes down which test failed."""

    def __init__(self, path: Path):
        self.path = path

    def pytest_runtest_logreport(self, report):
        if report.failed and not self.path.exists():
            self.path.write_text(report.nodeid.partition("::")[2].partition("[")[0])


def run_tests(place: Path, module: str, first: list[str], limit: int) -> int:
    """In a fork: run a module's tests in a copy of the repository; pytest's exit code."""
    signal.alarm(limit)  # which ends the fork by the signal
    os.chdir(place)
    sys.path.insert(0, str(place))
    for stream in (1, 2):
        os.dup2(os.open(place / "output", os.O_WRONLY | os.O_CREAT | os.O_TRUNC), stream)
    tests = f"book/{module}/test_{module}.py"
    options = ["-o", "addopts=--import-mode=importlib", "-x", "-q", "-p", "no:cacheprovider"]
    options += ["--tb=no"]  # and of the project's options those of a plugin are left out
    options += ["-m", "not long", "-p", "_hypothesis_pytestplugin", "--hypothesis-profile=mutation"]
    options += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]  # hypothesis is there already
    plugin = FirstFailure(place / "failed")
    selected = [f"{tests}::{test}" for test in first]
    return int(pytest.main([*options, *selected, tests], plugins=[plugin]))


def prepare(place: Path, module: str) -> None:
    """A copy of what the module's tests need."""
    leave = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "robokin", place / "robokin", ignore=leave)
    for name in ("tests/support.py", f"book/{module}/test_{module}.py", "pyproject.toml"):
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, place / name)


def fork(place: Path, module: str, code: str, first: list[str], limit: int) -> int:
    """Start the tests of a module with this text; the fork's process id."""
    (place / "failed").unlink(missing_ok=True)
    (place / "robokin" / f"{module}.py").write_text(code, encoding="utf-8")
    sys.stdout.flush()
    pid = os.fork()
    if pid == 0:
        end = BROKEN
        try:
            end = run_tests(place, module, first, limit)
            sys.stdout.flush()
        except BaseException:
            traceback.print_exc()
        finally:
            os._exit(end)
    return pid


def verdict(status: int, place: Path) -> str:
    """How a fork ended: "" if all tests passed."""
    if os.WIFSIGNALED(status):
        return "timeout" if os.WTERMSIG(status) == signal.SIGALRM else "crash"
    failed = place / "failed"
    if os.WEXITSTATUS(status) == BROKEN:
        raise SystemExit((place / "output").read_text())
    if os.WEXITSTATUS(status) == pytest.ExitCode.OK:
        return ""
    return failed.read_text() if failed.exists() else "import"


def run(module: str, jobs: int, lines: list[int] | None) -> list[Mutant]:
    """All mutants of a module, tried."""
    code = (ROOT / "robokin" / f"{module}.py").read_text(encoding="utf-8")
    every = [mutant for mutant in mutants(code) if not lines or mutant.line in lines]
    with tempfile.TemporaryDirectory() as folder:
        places = [Path(folder, str(n)) for n in range(jobs)]
        for place in places:
            # without a mutant: the tests must pass, and leave their own bytecode for the forks
            prepare(place, module)
            began = time.monotonic()
            _, status = os.waitpid(fork(place, module, code, [], 600), 0)
            if verdict(status, place) != "":
                raise SystemExit((place / "output").read_text())
            seconds = time.monotonic() - began
            for compiled in (place / "robokin").rglob(f"{module}.*.pyc"):
                compiled.unlink()
        limit = int(4 * seconds) + 20
        print(f"{module}: {len(every)} mutants, the tests take {seconds:.0f} s", flush=True)
        sys.dont_write_bytecode = True
        gc.freeze()  # or each fork copies, page by page, what it never changes
        killers: Counter[str] = Counter()
        queue, running = deque(every), {}
        while queue or running:
            while queue and places:
                place, mutant = places.pop(), queue.popleft()
                first = [name for name, _ in killers.most_common(8)]  # likely to see it, too
                pid = fork(place, module, mutant.code, first, limit)
                running[pid] = mutant, place
            pid, status = os.wait()
            mutant, place = running.pop(pid)
            mutant.result = verdict(status, place)
            if mutant.result.startswith("test_"):
                killers[mutant.result] += 1
            elif mutant.result == "":
                print(f"{module}.py:{mutant.line}: {mutant.after}", flush=True)
            places.append(place)
            done = len(every) - len(queue) - len(running)
            if done % 100 == 0:
                print(f"{module}: {done} of {len(every)} tried", flush=True)
        sys.dont_write_bytecode = False
    return every


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("only", nargs="?", default="", help="a part of the module's name")
    parser.add_argument("--jobs", type=int, default=2, help="processes at the same time (2)")
    parser.add_argument("--lines", type=int, nargs="+", help="only the mutants of these lines")
    options = parser.parse_args()
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # nbval's import alone takes two seconds
    settings.register_profile(
        "mutation",
        deadline=None,
        derandomize=True,
        phases=(Phase.explicit, Phase.generate),  # a failure need not be made smaller
        suppress_health_check=list(HealthCheck),
    )
    began, report, reached = time.monotonic(), [], True
    for module in MODULES:
        if options.only not in module:
            continue
        start = time.monotonic()
        every = run(module, options.jobs, options.lines)
        alive = [mutant for mutant in every if mutant.result == ""]
        late = sum(mutant.result == "timeout" for mutant in every)
        percent = 100 * (1 - len(alive) / max(len(every), 1))
        reached &= percent >= GOAL
        report.append(
            f"{module:10} {len(every):5} mutants, {len(every) - len(alive):5} killed "
            f"({late} by timeout), {len(alive):4} survived: {percent:.1f} %, "
            f"{(time.monotonic() - start) / 60:.1f} min"
        )
        print(report[-1], flush=True)
        for mutant in every:
            if mutant.result in ("", "timeout"):
                end = mutant.result or "survived"
                report.append(f"    {module}.py:{mutant.line}:{mutant.column} {mutant.what}: {end}")
                report.append(f"      - {mutant.before}\n      + {mutant.after}")
    path = ROOT / "_build" / "mutation.txt"
    path.parent.mkdir(exist_ok=True)
    path.write_text("\n".join(report) + "\n", encoding="utf-8")
    print(f"{(time.monotonic() - began) / 60:.1f} min in all; the survivors: {path}")
    return 0 if reached and report else 1


if __name__ == "__main__":
    sys.exit(main())
