"""Four tools in ten minutes: arrows, directions, turns, arrays"""

LEVEL = 1
TERMS = ()
