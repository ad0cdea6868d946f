"""The commands: what they refuse, and how the page for teachers uses them."""

import re
from pathlib import Path

from commands import ONLY, run, saved
from declared import table
from support import ROOT


def test_nothing_is_overwritten(keyed, capsys):
    for command, source, out in (("key", "roster.csv", "key.csv"), ("sheet", "key.csv", "sheets")):
        run(command, source, "--out", out, *(ONLY if command == "key" else ()))
        assert run(command, source, "--out", out) == 2
        assert "already there" in capsys.readouterr().err
        assert run(command, source, "--out", out, "--force") == 0


def test_a_missing_file_is_refused(folder, capsys):
    assert run("key", "nowhere.csv") == 2
    assert "nowhere.csv cannot be read: No such file" in capsys.readouterr().err


def test_what_the_system_refuses_is_told_without_a_traceback(keyed, capsys, monkeypatch):
    def full(*_, **__):
        raise OSError(28, "No space left on device", "key.csv")

    monkeypatch.setattr(Path, "replace", full)
    assert run("key", "roster.csv", "--force", *ONLY) == 2
    assert "key.csv: No space left on device; not finished" in capsys.readouterr().err
    assert len(table("key.csv")) == 4  # the old one is whole


def test_the_commands_of_the_page_on_one_s_own_course(folder, capsys):
    """From the roster that it shows to the files that it names."""
    page = (ROOT / "book" / "own_course.md").read_text("utf-8")
    blocks = re.findall(r"^```\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    roster = next(block for block in blocks if block.startswith("student\n"))
    (folder / "roster.csv").write_text(roster)
    (folder / "answers").mkdir()
    (folder / "answers" / "answers-s0471.csv").write_text(saved("s0471", {"euler-1": "1"}))
    commands = [block.split()[3:] for block in blocks if " -m courseware.classroom " in block]
    assert [command[0] for command in commands] == ["key", "grade"]
    assert [run(*command) for command in commands] == [0, 0]
    assert "students without an answer: 2\n  s0472\n  s0473\n" in capsys.readouterr().out
    for name in re.findall(r"`(hw1-grades[\w.-]*)`", page):
        assert (folder / name).exists()
