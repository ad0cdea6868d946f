"""Write the skeleton of a new chapter: `python -m courseware.new_chapter gear_train`."""

import sys

from courseware.errors import CourseError
from courseware.new_chapter import write

if len(sys.argv) != 2:
    sys.exit(__doc__)
try:
    print(write(sys.argv[1]))
except CourseError as error:
    sys.exit(str(error))
