"""Time and memory of kernels that all run a chapter at once, for the page on JupyterHub.

python tools/kernel_load.py 30 differential_drive
"""

import asyncio
import statistics
import sys
import time
from pathlib import Path

import nbformat
import psutil
from nbclient import NotebookClient

BOOK = Path(__file__).parents[1] / "book"


async def run_chapter(chapter):
    """Run a chapter; return its seconds, those of a core, and the kernel's megabytes."""
    notebook = nbformat.read(BOOK / chapter / f"{chapter}.ipynb", as_version=4)
    client = NotebookClient(notebook, timeout=900, extra_arguments=["--log-level=ERROR"])
    began = time.monotonic()
    async with client.async_setup_kernel():
        for number, cell in enumerate(notebook.cells):
            await client.async_execute_cell(cell, number)
        kernel = psutil.Process(client.km.provisioner.pid)
        busy, memory = sum(kernel.cpu_times()[:2]), kernel.memory_info().rss / 1e6
        return time.monotonic() - began, busy, memory


async def main(count, chapter):
    found = await asyncio.gather(*(run_chapter(chapter) for _ in range(count)))
    for name, *values in zip(("seconds", "of a core", "megabytes"), *found, strict=True):
        print(f"{name:10} median {statistics.median(values):6.1f}  worst {max(values):6.1f}")


asyncio.run(main(int(sys.argv[1]), sys.argv[2]))
