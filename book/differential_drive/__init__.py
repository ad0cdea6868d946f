"""Two wheels, two speeds: how does the robot move?"""
