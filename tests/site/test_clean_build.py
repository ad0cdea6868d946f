"""A build writes into an empty folder, and alone: what has left the book has left the site."""

import fcntl
import pickle
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from clean_build import BUSY
from declared import course
from support import ROOT

from courseware.site import sources

pytest_plugins = ["browser"]

CONF = f"""
import sys
sys.path.insert(0, {str(ROOT / "book" / "_ext")!r})
extensions = ["clean_build"]
master_doc = "index"
"""


@pytest.fixture
def build(tmp_path):
    """A function that builds a site of two pages."""
    (tmp_path / "conf.py").write_text(CONF, "utf-8")
    (tmp_path / "index.rst").write_text("A\n=\n\n.. toctree::\n   :glob:\n\n   b*\n", "utf-8")
    (tmp_path / "b.rst").write_text("B\n=\n", "utf-8")
    command = [sys.executable, "-m", "sphinx", "-q", "-d", "read", ".", "html"]
    return lambda: subprocess.run(
        command, cwd=tmp_path, stdin=subprocess.DEVNULL, capture_output=True, text=True
    )


def test_a_page_that_is_removed_leaves_the_site(build, tmp_path):
    assert build().returncode == 0
    assert (tmp_path / "html" / "b.html").exists()
    (tmp_path / "b.rst").rename(tmp_path / "b2.rst")
    assert build().returncode == 0
    found = {file.stem for file in (tmp_path / "html").rglob("b*.*")}
    assert "b2" in found
    assert "b" not in found


def test_an_incremental_build_gives_the_same_bytes(build, tmp_path):
    (tmp_path / "b2.rst").write_text("C\n=\n", "utf-8")
    build()
    (tmp_path / "b2.rst").unlink()
    build()
    incremental = files(tmp_path / "html")
    for name in ("read", "html"):
        shutil.rmtree(tmp_path / name)
    build()
    assert incremental == files(tmp_path / "html")


def test_a_chapter_more_changes_the_list_of_files_and_nothing_else_does(tmp_path, monkeypatch):
    """On which every page depends that tells of chapters."""
    app, file = SimpleNamespace(doctreedir=tmp_path), tmp_path / sources.LIST
    sources.list_files(app)
    before = file.stat().st_mtime_ns
    sources.list_files(app)
    assert file.stat().st_mtime_ns == before
    monkeypatch.setitem(vars(course()), "taught", [*course().taught, "beacon"])
    sources.list_files(app)
    assert file.stat().st_mtime_ns > before


MADE_OF = {  # a page, and the modules of chapters that it tells of
    "intro": ("__init__", "checks", "exercises", "figures", "formulas"),
    "practice": ("exercises",),
    "errata": ("exercises",),
    "notation": ("figures", "formulas"),
    "checks": ("checks", "formulas"),
    "api": (),
    "bicycle/bicycle": ("exercises", "figures", "formulas", "predictions"),
}


@pytest.mark.parametrize("page", MADE_OF)
def test_a_page_is_read_again_when_a_chapter_changes_or_there_is_another(site, page):
    doctrees = site.parent / ".doctrees"
    environment = pickle.loads((doctrees / "environment.pickle").read_bytes())
    found = {"/".join(Path(name).parts[-2:]) for name in environment.dependencies[page]}
    wanted = {f".doctrees/{sources.LIST}", *(f"bicycle/{part}.py" for part in MADE_OF[page])}
    missing = wanted - found
    assert not missing, f"{page} is made without `note_sources` (site/sources.py): {missing}"
    assert (doctrees / sources.LIST).exists()


def files(folder):
    """All files below a folder, as bytes."""
    found = (file for file in folder.rglob("*") if file.is_file())
    return {file.relative_to(folder): file.read_bytes() for file in found}


def test_two_builds_at_once_end_with_a_sentence(build, tmp_path):
    build()
    with (tmp_path / "read" / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        run = build()
    assert run.returncode
    assert run.stderr.strip() == BUSY
    assert build().returncode == 0
