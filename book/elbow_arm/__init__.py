"""Which joint angles bring the hand to a point?"""

CARD = "elbow-card"
