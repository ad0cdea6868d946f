"""What do all chapters use: arrows, directions, turns, arrays?"""
