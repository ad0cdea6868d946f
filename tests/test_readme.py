"""README.md shows figures as they are; what it and CONTRIBUTING.md link, run or name is there."""

import re

import pytest
import readme_pictures
from support import ROOT

TEXTS = ["README.md", "CONTRIBUTING.md", "tests/README.md", "book/own_course.md"]
each_text = pytest.mark.parametrize("name", TEXTS)


@pytest.mark.parametrize("name", readme_pictures.render_pictures())
def test_a_picture_is_the_figure_of_today(name):
    stored = (readme_pictures.FOLDER / name).read_text("utf-8")
    message = "run: .venv/bin/python tools/readme_pictures.py"
    assert stored == readme_pictures.render_pictures()[name], message


def test_what_is_linked_is_there():
    text = (ROOT / "README.md").read_text("utf-8")
    linked = re.findall(r'(?:\]\(|src="|srcset=")(?!\w+:)([^)"#]+)#?([\w-]*)', text)
    assert linked
    for name, section in linked:
        assert (ROOT / name).is_file(), name
        if section:
            headings = re.findall(r"^#+ (.*)$", (ROOT / name).read_text("utf-8"), re.M)
            assert section in [each.lower().replace(" ", "-") for each in headings], section


@each_text
def test_what_is_run_or_named_is_there(name):
    """Each target of make, each file but those of a chapter to come, and what is in a file."""
    text, makefile = ((ROOT / each).read_text("utf-8") for each in (name, "Makefile"))
    targets = set(re.findall(r"^([a-z-]+):", makefile, re.M))
    run = set(re.findall(r"^ *make ([a-z-]+)|`(?:\w+ )?make ([a-z-]+)", text, re.M))
    gone = {a or b for a, b in run} - targets
    files = re.findall(r"(?<![\w./-])(?:book|robokin|tests|tools|courseware)/[\w./]+\.\w+", text)
    gone |= {file for file in files if not (ROOT / file).is_file()}
    for file, word in re.findall(r"([\w/]+\.py)(?: -k |`, in `)(\w+)", text):
        gone |= set() if word in (ROOT / file).read_text("utf-8") else {f"{word} in {file}"}
    assert run
    assert not gone, f"{name} names {sorted(gone)}, which are not there"
