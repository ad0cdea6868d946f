"""Each build writes into an empty folder, and alone.

What was read stays (`_build/.doctrees`), but all pages are written anew: so a page, picture or
script that is no longer in the book leaves the site, its zip and its search, and an incremental
build gives the same bytes as one after `make clean`.
"""

import os
import shutil
from pathlib import Path

if os.name != "nt":
    import fcntl

BUSY = "Another build of this site is running: wait until it is done, and start again."


def build_alone(app, config):
    """End the build where another one runs; the lock ends with the process, however it ends."""
    folder = Path(app.doctreedir)
    folder.mkdir(parents=True, exist_ok=True)
    app.lock = (folder / "lock").open("w")
    if os.name != "nt":  # Windows has other locks
        try:
            fcntl.flock(app.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise SystemExit(BUSY) from None


def empty_site(app):
    """Remove what earlier builds wrote, before this one writes anything."""
    if app.builder.name == "html":
        shutil.rmtree(app.outdir)
        os.mkdir(app.outdir)


def setup(app):
    """Called by Sphinx."""
    app.connect("config-inited", build_alone, priority=1)  # before what was read is loaded
    app.connect("builder-inited", empty_site, priority=1)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
