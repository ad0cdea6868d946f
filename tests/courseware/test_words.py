"""The words of figures: listed, and in another language."""

from dataclasses import replace
from types import SimpleNamespace

from declared import FIGURES
from six_figures import BUILDS

from courseware.course import Course
from courseware.figures.words import list_words


def test_words_are_those_that_a_reader_sees():
    words = list_words(FIGURES["park"])
    assert {"park here", "left wheel v_L", FIGURES["park"].title} <= set(words)
    assert not {"tiles", "park", "slider", "clock"} & set(words)
    assert {"steered", "castor", "Mecanum"} <= set(list_words(BUILDS))


def test_a_table_of_the_chapter_puts_them_in_another_language(monkeypatch):
    park = FIGURES["park"]
    table = SimpleNamespace(WORDS={"park here": "hier parken", "tiles": "Fliesen"})
    module = Course.module
    monkeypatch.setattr(
        Course, "module", lambda self, *of: table if of[1] == "words" else module(self, *of)
    )
    german = replace(park, readouts=park.readouts)  # compiled anew
    assert "hier parken" in list_words(german)
    assert "park here" not in list_words(german)
    assert german.compiled["ground"] == "tiles"
