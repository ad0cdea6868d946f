"""Where is the robot, if it only counts turns of its wheels?"""

LEVEL = 3
TERMS = (
    "encoder",
    "dead reckoning",
    "covariance matrix|covariance",
    "random error",
    "systematic error",
)
