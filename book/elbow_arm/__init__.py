"""Which joint angles bring the hand to a point?"""

CARD = "elbow-card"
LEVEL = 2
TERMS = (
    "forward kinematics",
    "inverse kinematics",
    "degree of freedom|degrees of freedom",
    "configuration",
    "end effector",
    "workspace",
    "branch",
    "singularity|singularities",
)
