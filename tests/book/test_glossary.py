"""The glossary sends to pages that use its terms."""

import re
from pathlib import Path

import nbformat
import pytest

from courseware.course import course

BOOK = Path("book")
TERMS = re.search(r"```{glossary}\n(.*?)```", (BOOK / "glossary.md").read_text("utf-8"), re.DOTALL)
# "terms\n  what they mean … {doc}`page`"
ENTRIES = [entry.split("\n", 1) for entry in re.split(r"\n\n(?=\S)", TERMS[1].strip())]


@pytest.mark.parametrize(("terms", "meaning"), ENTRIES, ids=[terms for terms, _ in ENTRIES])
def test_a_term_is_used_where_the_glossary_sends_to(terms, meaning):
    """One of its names, each word of it: "active and passive" may be two sentences."""
    pages = re.findall(r"\{doc\}`(?:[^`<]*<)?([^`>]+)", meaning)
    assert pages, f"say of {terms!r} which chapter uses it"
    notebook = nbformat.read(course().notebook(pages[0].partition("/")[0]), as_version=4)
    said = "\n".join(cell.source for cell in notebook.cells).lower()
    assert any(
        all(word in said for word in name.split() if word not in ("and", "of"))
        for name in terms.lower().split(", ")
    ), f"{pages[0]} does not say {terms!r}"
