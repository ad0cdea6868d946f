"""Print one table of ratios after the benchmarks, instead of pytest-benchmark's many of times."""

import os

os.environ |= dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")

from collections import defaultdict
from importlib.metadata import version
from importlib.util import find_spec

import pytest

PEERS = ("numpy", "scipy", "pytransform3d", "roboticstoolbox-python", "spatialmath-python", "pin")
TITLES = ("computation", "items", "robokin µs", "÷ saved", "loop ÷ batch", "÷ peers, fastest first")
LINE = "{:<34}{:>9}{:>12}{:>9}{:>14}   {}"
TIMES = pytest.StashKey[tuple]()


def pytest_report_header():
    peers = ", ".join(f"{peer} {version(peer)}" for peer in PEERS)
    return [f"robokin: {find_spec('robokin').origin}", f"peers: {peers}"]


def pytest_benchmark_group_stats(config, benchmarks):
    """Keep the times for the table. Without groups, pytest-benchmark prints none of its own."""
    now, saved = config.stash[TIMES] = defaultdict(dict), defaultdict(dict)
    for bench in benchmarks:
        computation, items, library = bench["params"].values()
        times = saved if bench["path"] else now  # the path of what --benchmark-compare names
        times[computation, items][library] = bench["min"]
    return []


def pytest_terminal_summary(terminalreporter, config):
    now, saved = config.stash.get(TIMES, ({}, {}))
    lines = []
    for (computation, items), times in now.items():
        if ours := times.get("robokin"):
            before = saved.get((computation, items), {}).get("robokin")
            single = items > 1 and now.get((computation, 1), {}).get("robokin")
            peers = sorted((seconds, peer) for peer, seconds in times.items() if peer != "robokin")
            columns = [
                f"{ours * 1e6:,.1f}",
                f"{ours / before:.2f}" if before else "",
                f"{items * single / ours:,.1f}" if single else "",
                ", ".join(f"{ours / seconds:.3g} {peer}" for seconds, peer in peers),
            ]
            lines.append(LINE.format(computation, f"{items:,}", *columns).rstrip())
    if lines:
        terminalreporter.section("robokin's time, and divided by others'")
        terminalreporter.write("\n".join([LINE.format(*TITLES), *lines, ""]))
