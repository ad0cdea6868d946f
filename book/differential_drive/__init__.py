"""Two wheels, two speeds: how does the robot move?"""

TERMS = ("angular velocity", "instantaneous centre of rotation|ICR", "twist", "nonholonomic")
