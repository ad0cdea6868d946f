"""Which turns lead from one frame to another?"""
