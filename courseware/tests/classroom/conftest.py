"""Folders that a teacher works in."""

import pytest
from commands import ONLY, run


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def keyed(folder, capsys):
    """A folder with a roster and a key for Ada and Bob."""
    (folder / "roster.csv").write_text("student\nAda\nBob\n")
    assert run("key", "roster.csv", *ONLY) == 0
    capsys.readouterr()
    return folder
