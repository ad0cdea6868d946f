"""How fast must the joints turn for the hand to follow a line?"""

CARD = "planar-card"
