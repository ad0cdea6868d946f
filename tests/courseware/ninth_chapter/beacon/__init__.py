"""How far is a beacon, and in which direction does the robot see it?"""

TERMS = ()
