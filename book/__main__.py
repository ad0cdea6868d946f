"""For teachers: `python -m book --help`."""

import sys

from courseware.practice.command import main

sys.exit(main())
