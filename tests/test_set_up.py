"""The Makefile and the kit's `start.py` in other people's folders; what they install is a stub."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support import ROOT

pytestmark = pytest.mark.skipif(os.name == "nt", reason="no make")

# Stands for a Python: makes environments of itself, and says where it is as a real one does
STUB = """#!/bin/sh
case "$*" in
*--clear*) rm -rf .venv && mkdir -p .venv/bin && cp "$0" .venv/bin/python && cp "$0" .venv/bin/uv ;;
*sys.base_prefix*) echo "$PWD" VERSION ;;
"-m pip config list") echo "global.index-url='https://mirror.example/simple'" ;;
*) echo "$0 $*"; env ;;
esac
"""
OTHERS = {  # what other projects have set
    "PIP_USER": "1",
    "PIP_TARGET": "/elsewhere",
    "PIP_PREFIX": "/elsewhere",
    "PIP_REQUIRE_HASHES": "1",
    "PYTHONPATH": "/elsewhere",
    "PYTHONWARNINGS": "error",
    "PYTHONOPTIMIZE": "2",
    "MPLBACKEND": "Qt5Agg",
}


@pytest.fixture(params=["here", "a b'c $d `e` & é"])
def tree(request, tmp_path):
    """A folder with the Makefile and what `.venv` depends on, and two stubs of Python."""
    folder = tmp_path / request.param
    names = ("Makefile", "requirements.txt", "pyproject.toml")
    for name in (*names, "courseware/pyproject.toml", "book/pyproject.toml"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    for name in ("python3", "python4"):
        stub = tmp_path / "bin" / name
        stub.parent.mkdir(exist_ok=True)
        stub.write_text(STUB.replace("VERSION", name), "utf-8")
        stub.chmod(0o755)
    return folder


def set_up(folder, *arguments, **env):
    """What `make` says when it sets the folder up; "" when there is nothing to do."""
    path = f"{folder.parent / 'bin'}:{os.environ['PATH']}"
    done = subprocess.run(
        ["make", "-s", ".venv/.ready", *arguments],
        cwd=folder,
        env={"PATH": path, **env},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_it_is_set_up_once(tree):
    assert "--require-hashes -r requirements.txt" in set_up(tree)
    assert set_up(tree) == ""


def test_after_an_interruption_it_starts_clean(tree):
    set_up(tree)
    (tree / ".venv" / "half").touch()
    (tree / ".venv" / ".ready").unlink()
    assert set_up(tree)
    assert not (tree / ".venv" / "half").exists()


def test_a_folder_that_is_moved_or_copied_is_set_up_again(tree):
    set_up(tree)
    shutil.copytree(tree, tree.parent / "copy")
    assert set_up(tree.parent / "copy")
    tree.rename(tree.parent / "moved")
    assert set_up(tree.parent / "moved")


def test_the_python_that_is_asked_for_is_taken_and_kept(tree):
    set_up(tree)
    assert set_up(tree, "PYTHON=python4")
    assert set_up(tree) == ""  # none is asked for
    (tree / ".venv" / "bin" / "python").unlink()  # as if it had been removed from the system
    assert set_up(tree)


def test_other_projects_settings_do_not_matter(tree):
    said = set_up(tree, **OTHERS, UV_REQUIRE_HASHES="1", SOURCE_DATE_EPOCH="0")
    names = {line.partition("=")[0] for line in said.splitlines()}
    assert "PATH" in names
    assert not names & {*OTHERS, "UV_REQUIRE_HASHES", "SOURCE_DATE_EPOCH"}


def test_uv_asks_pips_index(tree):
    assert "UV_DEFAULT_INDEX=https://mirror.example/simple" in set_up(tree)
    (tree / ".venv" / ".ready").unlink()
    said = set_up(tree, UV_DEFAULT_INDEX="https://own.example")  # its own goes first
    assert "UV_DEFAULT_INDEX=https://own.example" in said


def test_a_python_that_is_not_there_is_told(tree):
    command = ["make", "-s", "check", "PYTHON=python3.99"]
    run = subprocess.run(command, cwd=tree, capture_output=True, text=True)
    assert run.returncode
    assert "python3.99 is not there, or older than Python 3.11" in run.stdout


# --- the kit ----------------------------------------------------------------------------------

RUN = """
import os, subprocess, sys, venv
class Lab:
    def __init__(self, command, **options): print("started", *sorted(os.environ), sep="\\n")
    def wait(self): return 0
def create(folder, symlinks=False, **options):
    print("set up", "links" if symlinks else "copies")
    os.makedirs(folder, exist_ok=True)
venv.create, subprocess.Popen, subprocess.run = create, Lab, lambda *command, **options: None
sys.base_prefix = sys.argv.pop()
import runpy
runpy.run_path("start.py", None, "__main__")
"""


def start(folder, prefix=sys.base_prefix, **env):
    """What `start.py` says, and does, when a Python of that folder runs it."""
    (folder / "notebooks").mkdir(parents=True, exist_ok=True)
    shutil.copy(ROOT / "book" / "_kit" / "start.py", folder)
    command = [sys.executable, "-c", RUN, prefix]
    env = {**os.environ, **env}
    return subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True)


def test_the_kit_is_set_up_once_for_each_python(tmp_path):
    first, again, other = (start(tmp_path, *prefix) for prefix in ((), (), ("/other",)))
    assert first.stdout.splitlines()[1:3] == ["set up links", "started"], first.stderr
    assert again.stdout.startswith("started")
    assert "set up links" in other.stdout


def test_the_kit_forgets_other_projects_settings(tmp_path):
    settings = {**OTHERS, "PYTHONWARNINGS": "default", "PYTHONOPTIMIZE": "1"}
    said = start(tmp_path, **settings).stdout.splitlines()
    assert "started" in said
    assert not set(said) & set(OTHERS)


def test_a_colon_in_the_kits_path_is_told(tmp_path):
    run = start(Path(tmp_path, "a:b"))
    assert run.returncode == 1
    assert "with ':' in its path" in run.stderr
    assert "Traceback" not in run.stderr
