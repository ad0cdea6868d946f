"""The words of figures, which a chapter may give in another language.

A chapter's `words.py` holds them in one table: `WORDS = {"park here": "hier parken"}`. What is not
in it stays as it is declared; `list_words(figure)` says what there is.
"""

from collections.abc import Callable
from typing import Any

from courseware.course import course

TEXTS = {"title", "label", "sentence", "words"}  # fields of a compiled figure that hold words


def translate(data: Any, chapter: str) -> Any:
    """Return a compiled figure in the words of its chapter's table, if it has one."""
    module = course().module(chapter, "words") if chapter in course().chapters else None
    table = getattr(module, "WORDS", {})
    return _map_words(data, lambda text: table.get(text, text)) if table else data


def list_words(figure: Any) -> list[str]:
    """Return the words of a figure, in order and each once."""
    found: dict[str, None] = {}
    _map_words(figure.compiled, lambda text: found.setdefault(text) or text)
    return [text for text in found if text]


def _map_words(data: Any, change: Callable[[str], str], is_words: bool = False) -> Any:
    if isinstance(data, dict):
        return {
            key: _map_words(value, change, is_words or key in TEXTS) for key, value in data.items()
        }
    if isinstance(data, list):
        return [_map_words(each, change, is_words) for each in data]
    return change(data) if type(data) is str and is_words else data
