"""How fast must the joints turn for the hand to follow a line?"""

CARD = "planar-card"
LEVEL = 3
TERMS = (
    "Jacobian",
    "singularity|singularities",
    "manipulability",
    "workspace",
    "damped least squares|damp",
    "resolved-rate control",
    "null space",
)
