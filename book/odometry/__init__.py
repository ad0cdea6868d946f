"""Where is the robot, if it only counts turns of its wheels?"""

CARD = "odometry-card"
LEVEL = 3
TERMS = (
    "encoder",
    "dead reckoning",
    "covariance matrix|covariance",
    "random error",
    "systematic error",
)
