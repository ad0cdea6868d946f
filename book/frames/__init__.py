"""Where does the hand see the object that a camera sees?"""

CARD = "frames-card"
