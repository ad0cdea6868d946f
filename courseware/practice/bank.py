"""The exercises and mistakes of the course that is open."""

from courseware.course import course
from courseware.errors import CourseError
from courseware.practice.declaration import Exercise
from courseware.practice.mistakes import Mistake


def all_exercises() -> dict[str, Exercise]:
    """Return every exercise by name, in the course's order."""
    for name, chapter in course().chapters_of("exercises", Exercise).items():
        stem = chapter.replace("_", "-")
        if name.rpartition("-")[0] != stem:
            raise CourseError(
                f"an exercise in the folder {chapter} is named {stem}-1, {stem}-2, …; got {name}"
            )
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
