"""README.md shows figures as they are, and links what there is."""

import re

import pytest
import readme_pictures
from support import ROOT


@pytest.mark.parametrize("name", readme_pictures.pictures())
def test_a_picture_is_the_figure_of_today(name):
    stored = (readme_pictures.FOLDER / name).read_text("utf-8")
    message = "run: .venv/bin/python tools/readme_pictures.py"
    assert stored == readme_pictures.pictures()[name], message


def test_what_is_linked_is_there():
    text = (ROOT / "README.md").read_text("utf-8")
    linked = re.findall(r'(?:\]\(|src="|srcset=")(?!\w+:)([^)"#]+)#?([\w-]*)', text)
    assert linked
    for name, section in linked:
        assert (ROOT / name).is_file(), name
        if section:
            headings = re.findall(r"^#+ (.*)$", (ROOT / name).read_text("utf-8"), re.M)
            assert section in [each.lower().replace(" ", "-") for each in headings], section
