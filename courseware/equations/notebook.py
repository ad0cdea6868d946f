"""What a chapter's notebook prints: its cells, their results, and the formulas among them."""

import json
from typing import Any

from courseware.course import course
from courseware.equations.core import Equation, declared
from courseware.equations.rendering import MIME


def cells(chapter: str) -> list[dict[str, Any]]:
    """The cells of a chapter's notebook; what chapters share has none."""
    if chapter not in course().taught:
        return []
    found: list[dict[str, Any]] = json.loads(course().notebook(chapter).read_text("utf-8"))["cells"]
    return found


def results(cell: dict[str, Any]) -> list[dict[str, Any]]:
    """What the outputs of a cell hold, by MIME type."""
    return [output.get("data", {}) for output in cell.get("outputs", ())]


def shown_equations(chapter: str) -> list[tuple[Equation, bool]]:
    """The equations that a chapter's notebook shows, and whether in the form that is computed.

    Without those that have lost their name since it ran: it must run again to say so.
    """
    found = [data[MIME] for cell in cells(chapter) for data in results(cell) if MIME in data]
    known = declared()
    return [(known[data["name"]], data["computed"]) for data in found if data["name"] in known]
