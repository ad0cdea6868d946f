"""What a class needs of a JupyterHub: starts kernels, all at once, that each run a chapter.

    python tools/classroom.py 30 differential_drive

Prints the memory of a kernel after its chapter, and how long a student waits for the first cell and
for all. The chapter is run without pauses, as no student does: the times are the worst.
"""

import asyncio
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

import nbformat
import psutil
from jupyter_client import AsyncKernelManager

BOOK = Path(__file__).parents[1] / "book"
WAIT = 900  # seconds at most for a cell


async def student(cells, folder):
    """Seconds to the first result and to the last one, seconds of a core, megabytes at the end."""
    began = time.monotonic()
    kernel = AsyncKernelManager()
    await kernel.start_kernel(cwd=folder, extra_arguments=["--log-level=ERROR"])
    client = kernel.client()
    client.start_channels()
    try:
        await client.wait_for_ready(timeout=WAIT)
        first = 0
        for cell in cells:
            reply = await client.execute_interactive(
                cell, timeout=WAIT, output_hook=lambda message: None, allow_stdin=False
            )
            assert reply["content"]["status"] == "ok", reply["content"]
            first = first or time.monotonic() - began
        process = psutil.Process(kernel.provisioner.pid)
        busy = sum(process.cpu_times()[:2])
        return first, time.monotonic() - began, busy, process.memory_info().rss / 1e6
    finally:
        client.stop_channels()
        await kernel.shutdown_kernel(now=True)


def server_memory():
    """The memory of a JupyterLab with nothing open, in MB, and the seconds to its start."""
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--port=0", "--allow-root"]
    began = time.monotonic()
    server = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    try:
        while "is running at" not in server.stderr.readline():
            assert server.poll() is None
        return psutil.Process(server.pid).memory_info().rss / 1e6, time.monotonic() - began
    finally:
        server.terminate()
        server.communicate()


async def main(number, chapter):
    folder = BOOK / chapter
    notebook = nbformat.read(folder / f"{chapter}.ipynb", as_version=4)
    cells = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    memory, seconds = server_memory()
    print(f"JupyterLab's server: {memory:.0f} MB, up after {seconds:.1f} s")
    print(f"{number} kernels, {os.cpu_count()} cores, load before {os.getloadavg()[0]:.1f}")
    found = await asyncio.gather(*(student(cells, folder) for _ in range(number)))
    names = ("first cell, s", "whole chapter, s", "of a core, s", "memory, MB")
    for name, values in zip(names, zip(*found, strict=True), strict=True):
        print(f"{name:20} median {statistics.median(values):6.1f}  worst {max(values):6.1f}")


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1]), sys.argv[2]))
