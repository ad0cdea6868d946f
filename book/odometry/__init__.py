"""Where is the robot, if it only counts turns of its wheels?"""

CARD = "odometry-card"
