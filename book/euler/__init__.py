"""Which turns lead from one frame to another?"""

TERMS = ("rotation matrix", "intrinsic", "extrinsic", "gimbal lock")
