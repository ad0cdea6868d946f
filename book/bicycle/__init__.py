"""Where does a car go when its front wheels turn?"""

TERMS = ("instantaneous centre of rotation|ICR", "angular velocity", "twist", "nonholonomic")
