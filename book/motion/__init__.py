"""Planar motion, which all wheeled robots share; taught in the chapter on two wheels."""
