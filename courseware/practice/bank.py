"""The exercises and mistakes of the course that is open."""

from courseware.course import course
from courseware.practice.exercises import Exercise
from courseware.practice.mistakes import Mistake


def all_exercises() -> dict[str, Exercise]:
    """Return every exercise by name, in the course's order."""
    return course().find_all("exercises", Exercise)


def find_exercise(name: str) -> Exercise:
    return course().find("exercises", Exercise, name)


def all_mistakes() -> dict[str, Mistake]:
    return course().find_all("exercises", Mistake)


def find_mistake(name: str) -> Mistake:
    return course().find("exercises", Mistake, name)


def all_topics() -> list[str]:
    """Return the chapters that have exercises, in the course's order."""
    return list(dict.fromkeys(exercise.topic for exercise in all_exercises().values()))
