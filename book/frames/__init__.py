"""Where does the hand see the object that a camera sees?"""

TERMS = ("frame", "homogeneous transform", "inverse", "loop closure")
