"""Which turns lead from one frame to another?"""

CARD = "two-frames"
