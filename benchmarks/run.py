"""How fast robokin is beside other libraries, and beside the bare NumPy calls: one table.

Run it with `make bench`; README.md here says how the numbers come about.
"""

import os

os.environ |= dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")

import gc
import platform
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, version
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, thread_time
from typing import Any

from computations import COMPUTATIONS, Computation
from single_calls import CALLS

SIZES = (1, 1_000, 100_000)
LIBRARIES = ("scipy", "pytransform3d", "roboticstoolbox-python", "spatialmath-python", "pin")
SINGLE_CALL = 50e-6  # seconds that one call may take
IMPORT_GOAL = 1.2
BUDGET = 0.25  # seconds of timing for each call in a row
SAMPLES = range(3, 41)  # so many for each call; a single one where it takes longer than LONG
LONG, SHORT = 2.0, 500e-6  # shorter calls are repeated within a sample
LINE = "{:<27}{:>8}{:>12}{:>9}  {:<17}{:>8}  {:<41}{}"


@dataclass
class Timed:
    """One call, and the seconds that it took, sample by sample."""

    call: Callable[[], Any]
    samples: list[float] = field(default_factory=list)
    spent: float = 0.0
    repeat: int = 1

    def wants_more(self) -> bool:
        n = len(self.samples)
        if n and self.samples[0] > LONG:
            return False
        return n < SAMPLES.start or (n < SAMPLES.stop and self.spent < BUDGET)

    def sample(self) -> None:
        start = thread_time()
        for _ in range(self.repeat):
            self.call()
        seconds = thread_time() - start
        self.samples.append(seconds / self.repeat)
        self.spent += seconds

    def first(self) -> Any:
        """Call it once, for its result and to see how often it fits into a sample."""
        start = thread_time()
        result = self.call()
        seconds = thread_time() - start
        if seconds > LONG:
            self.samples.append(seconds)
        else:
            start = thread_time()
            self.call()
            self.repeat = max(1, round(SHORT / max(thread_time() - start, 1e-7)))
        return result

    @property
    def seconds(self) -> float:
        return median(self.samples)


@dataclass
class Line:
    """What one line of the table shows; times in seconds, peers with the fastest first."""

    computation: Computation
    n: int
    ours: float
    limit: float
    peers: list[tuple[str, float]]

    @property
    def to_peer(self) -> float:
        return self.ours / self.peers[0][1] if self.peers else float("nan")

    @property
    def keeps_floor(self) -> bool:
        return self.n < SIZES[1] or not self.to_peer >= 1

    @property
    def misses(self) -> list[str]:
        """What the line misses: the floor, a goal, the bound of a single call."""
        c, found = self.computation, []
        if not self.keeps_floor:
            found.append("FLOOR")
        if self.n == SIZES[-1] and self.to_peer > c.peer_goal:
            bound = self.limit / self.peers[0][1]  # what even the limit has for ÷ best
            beyond = f" (the limit itself: {bound:.2g})" if bound > c.peer_goal else ""
            found.append(f"peer goal {c.peer_goal:g}{beyond}")
        if self.n == SIZES[-1] and self.ours / self.limit > c.limit_goal:
            found.append(f"limit goal {c.limit_goal:g}")
        if self.n == 1 and self.ours > SINGLE_CALL:
            found.append(f"over {SINGLE_CALL * 1e6:.0f} µs")
        return found

    def __str__(self) -> str:
        name = self.peers[0][0] if self.peers else "-"
        others = ", ".join(f"{other} {self.ours / t:.2g}" for other, t in self.peers[1:])
        return LINE.format(
            self.computation.name,
            f"{self.n:,}",
            f"{self.ours * 1e6:,.1f}",
            f"{self.to_peer:.3g}" if self.peers else "-",
            name,
            f"{self.ours / self.limit:.2f}",
            ", ".join(self.misses),
            others,
        ).rstrip()


def measure(calls: list[Timed]) -> None:
    """Time calls in turn, so that whatever slows the machine down slows all of them."""
    gc.collect()
    gc.disable()
    while any(timed.wants_more() for timed in calls):
        for timed in calls:
            if timed.wants_more():
                timed.sample()
    gc.enable()


def compare(computation: Computation, n: int, missing: dict[str, str]) -> Line:
    """Check the peers' results, then time all; peers that cannot be imported go to `missing`."""
    row = computation.row(n)
    ours, limit, peers = Timed(row.ours), Timed(computation.limit(n)), {}
    result = ours.first()
    limit.first()
    for name, call in row.peers.items():
        peers[name] = Timed(call)
        try:
            off = row.agree(result, peers[name].first())
        except ImportError as error:
            missing[name.rstrip("*")] = str(error)
            del peers[name]
            continue
        if not off <= row.tolerance:
            sys.exit(f"{computation.name}, {n} items: {name} differs by {off:.3g}")
    measure([ours, limit, *peers.values()])
    fastest_first = sorted(((p, t.seconds) for p, t in peers.items()), key=lambda item: item[1])
    return Line(computation, n, ours.seconds, limit.seconds, fastest_first)


def single_calls() -> dict[str, float]:
    """Seconds of one call of each public function."""
    timed = {name: Timed(call) for name, call in CALLS.items()}
    for one in timed.values():
        one.first()
    measure(list(timed.values()))
    return {name: one.seconds for name, one in timed.items()}


def import_seconds(imports: str, cache: str) -> float:
    code = f"from time import process_time as t; s = t(); import {imports}; print(t() - s)"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=os.environ | {"PYTHONPYCACHEPREFIX": cache, "PYTHONDONTWRITEBYTECODE": ""},
        capture_output=True,
        text=True,
        check=True,
    )
    return float(done.stdout)


def import_ratio(runs: int = 21) -> tuple[float, float]:
    """Seconds to import NumPy, and how many times as long all of robokin takes, NumPy included.

    All of it compiled beforehand, by the first pair of imports, which is not counted.
    """
    with TemporaryDirectory() as cache:
        pairs = [
            (import_seconds("numpy", cache), import_seconds("robokin", cache))
            for _ in range(runs + 1)
        ]
    numpy, robokin = (median(times) for times in zip(*pairs[1:], strict=True))
    return numpy, robokin / numpy


def installed(library: str) -> str:
    try:
        return f"{library} {version(library)}"
    except PackageNotFoundError:
        return f"{library} not installed"


def print_summary(lines: list[Line], missing: dict[str, str]) -> None:
    for name, reason in missing.items():
        print(f"{name} cannot be installed or imported, so it has no entries: {reason}")
    calls = sorted(single_calls().items(), key=lambda item: -item[1])
    slow = [f"{name} {seconds * 1e6:.1f}" for name, seconds in calls if seconds > SINGLE_CALL]
    slowest = ", ".join(f"{name} {seconds * 1e6:.1f}" for name, seconds in calls[:5])
    print(f"\nSingle calls of all public functions; the slowest, in µs: {slowest}")
    print(f"  over {SINGLE_CALL * 1e6:.0f} µs: {', '.join(slow) or 'none'}")
    numpy, ratio = import_ratio()
    verdict = "kept" if ratio <= IMPORT_GOAL else "MISSED"
    print(f"Import of robokin ÷ import of NumPy ({numpy * 1e3:.0f} ms): {ratio:.2f}", end="")
    print(f" (goal {IMPORT_GOAL}: {verdict})")
    below = [f"{line.computation.name} at {line.n:,}" for line in lines if not line.keeps_floor]
    print("Floor (faster than every peer from 1,000 items up): ", end="")
    print(f"MISSED in {'; '.join(below)}" if below else "holds")
    goals = sum(bool(line.misses) for line in lines)
    print(f"Lines that miss something: {goals} of {len(lines)}")


def main() -> None:
    start, lines = perf_counter(), []
    missing: dict[str, str] = {}
    libraries = ", ".join(installed(library) for library in ("robokin", "numpy", *LIBRARIES))
    print(f"Python {platform.python_version()}, {libraries}")
    print("Medians of processor time. Peers with * have no function for batches: they are called")
    print("item by item, with fewer repetitions. ÷: robokin's time divided by theirs. Missed: the")
    print(
        "floor (faster than every peer from 1,000 items up), the goals at 100,000 items, the bound"
    )
    print("of a single call.\n")
    print(
        LINE.format(
            "computation",
            "items",
            "robokin µs",
            "÷ best",
            "best peer",
            "÷ limit",
            "missed",
            "÷ other peers",
        )
    )
    for computation in COMPUTATIONS:
        for n in SIZES:
            lines.append(compare(computation, n, missing))
            print(lines[-1], flush=True)
    print_summary(lines, missing)
    print(f"This run took {perf_counter() - start:.0f} s; load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
