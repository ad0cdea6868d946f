"""Each build writes into an empty folder, one build at a time.

Parsed pages stay (`_build/.doctrees`), but all pages are written anew. So a page, picture or script
that leaves the book also leaves the site, its zip and its search, and an incremental build gives
the same bytes as one after `make clean`.
"""

import os
import shutil
from pathlib import Path

if os.name != "nt":
    import fcntl

BUSY = "Another build of this site is running: wait until it is done, and start again."


def lock_build(app, config):
    """End the build if another one runs; the lock ends with the process, however that ends."""
    folder = Path(app.doctreedir)
    folder.mkdir(parents=True, exist_ok=True)
    app.lock = (folder / "lock").open("w")
    if os.name != "nt":  # Windows has other locks
        try:
            fcntl.flock(app.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise SystemExit(BUSY) from None


def empty_site(app):
    """Remove the files of earlier builds, before this one writes any."""
    if app.builder.name == "html":
        shutil.rmtree(app.outdir)
        os.mkdir(app.outdir)


def setup(app):
    """Register both steps with Sphinx."""
    app.connect("config-inited", lock_build, priority=1)  # before parsed pages are loaded
    app.connect("builder-inited", empty_site, priority=1)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
