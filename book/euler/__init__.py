"""Which turns lead from one frame to another?"""

CARD = "two-frames"
LEVEL = 2
TERMS = (
    "orientation",
    "rotation matrix",
    "orthogonal",
    "intrinsic",
    "extrinsic",
    "Tait–Bryan angles|Tait–Bryan",
    "axis–angle",
    "gimbal lock",
    "representation singularity",
)
