"""Two wheels, two speeds: how does the robot move?"""

LEVEL = 1
TERMS = ("angular velocity", "instantaneous centre of rotation|ICR", "twist", "nonholonomic")
