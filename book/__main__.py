"""For teachers: `python -m book --help`."""

import sys

from workshop.practice.command import main

sys.exit(main())
