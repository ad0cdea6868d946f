"""A course on robot kinematics: a folder for each chapter, with all that belongs to it."""

from book.things.materials import MATERIALS
from courseware.course import open_course
from robokin.styles import KINDS

open_course(__name__, name="robokin", looks=KINDS, library="robokin", materials=MATERIALS)
__version__ = "0.1.0"
