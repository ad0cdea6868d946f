"""Where does a car go when its front wheels turn?"""

CARD = "bicycle-card"
