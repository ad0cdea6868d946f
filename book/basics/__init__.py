"""Three tools in five minutes: directions, turns, arrays"""

TERMS = ()
