"""Exercises with numbers of their own for every student, and a check that names the mistake.

In a notebook: `practice.exercise("differential-drive-1")`. For teachers, on the command line:
`python -m robokin.practice --help`.
"""

from importlib import import_module

from robokin.practice.bank import EXERCISES, MISTAKES, TOPICS
from robokin.practice.notebook import COURSE, answers, example, exercise, export, mistake, student

__all__ = [
    "COURSE",
    "EXERCISES",
    "MISTAKES",
    "TOPICS",
    "answers",
    "example",
    "exercise",
    "export",
    "mistake",
    "student",
]

for topic in TOPICS:  # each declares its exercises, in the order of the chapters
    import_module(f"robokin.practice.{topic}")
