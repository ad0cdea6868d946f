"""Which joint angles bring the hand to a point?"""

TERMS = (
    "forward kinematics",
    "inverse kinematics",
    "degree of freedom|degrees of freedom",
    "end effector",
    "workspace",
    "branch",
    "singularity|singularities",
)
