"""Four tools in ten minutes: arrows, directions, turns, arrays"""

TERMS = ()
