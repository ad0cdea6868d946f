"""What the things in the course's figures are made of, on a light page and on a dark one.

`tyre`, `dome` and others with form are gradients of these tones. `edge`, tones that end in it and
`rim` are round a thing and seen on every ground; `groove` and `accent_groove` are lines
within it. Tones that end in 2 after a colour of meaning (`left2`) are that meaning on rubber.
"""

from courseware.figures import Gradient, Ground, Materials

TONES = {
    # grounds
    "floor": ("#f1ede5", "#2a313a"),
    "floor_lit": ("#fbf9f5", "#38414d"),
    "seam": ("#dbd4c6", "#1d232a"),
    "asphalt": ("#dfe3e8", "#2b3138"),
    "asphalt_lit": ("#eceff2", "#38404a"),
    "paint": ("#ffffff", "#b9c2cc"),
    "kerb": ("#f4f1ea", "#68727e"),
    "kerb_edge": ("#77736a", "#97a1ad"),
    "wall": ("#e6e0d5", "#20262d"),
    "wall_lit": ("#f7f4ee", "#303943"),
    "wall_top": ("#b9b1a1", "#525d69"),
    "wood": ("#d9b587", "#6d543b"),
    "wood_dark": ("#b08653", "#4a3827"),
    "wood_lit": ("#ecd2ab", "#8b6d4d"),
    "paper": ("#ffffff", "#323a45"),
    "plank": ("#e6cba1", "#3f3023"),
    "plank_lit": ("#efdab6", "#4a392a"),
    "grain": ("#c9a26f", "#2c2118"),
    "wood_edge": ("#7d5a2c", "#c19b6c"),
    "night": ("#dde3ea", "#0c1015"),
    # bodies: light, middle, dark
    "shell": ("#ffffff", "#cbd3dc"),
    "shell_mid": ("#e3e8ee", "#a0abb8"),
    "shell_dark": ("#b3bdca", "#65717f"),
    "edge": ("#4b5664", "#9fa9b5"),
    "groove": ("#525d6b", "#14191f"),
    "accent_lit": ("#ffd591", "#f2b867"),
    "accent": ("#f2a93c", "#d58d2b"),
    "accent_dark": ("#cb8119", "#96600f"),
    "accent_edge": ("#85500a", "#f0bd75"),
    "accent_groove": ("#85500a", "#3a2408"),
    "metal": ("#f4f6f8", "#dfe5eb"),
    "metal_mid": ("#b9c2cd", "#97a2af"),
    "metal_dark": ("#818c99", "#56616d"),
    "wire": ("#8a95a2", "#98a4b1"),
    "rubber_lit": ("#8a95a2", "#8a96a3"),
    "rubber_mid": ("#545e6a", "#4f5a66"),
    "rubber": ("#2a3038", "#1c2127"),
    "tread": ("#15191e", "#0b0d10"),
    "rim": ("#14181c", "#9aa5b1"),
    "dark": ("#3a434f", "#2b333c"),
    "well": ("#22272e", "#0d1013"),
    "glass": ("#2c4259", "#101b26"),
    "glass_lit": ("#86a9c7", "#5d86aa"),
    "lamp": ("#ffe08a", "#ffe9a8"),
    "tail": ("#d43a32", "#ff6a5c"),
    "shadow": ("#1b2430", "#000000"),
    "goal": ("#cfe04a", "#c9da48"),
    "goal_dark": ("#9aab14", "#8c9a1c"),
    "goal_edge": ("#5a6600", "#eef08a"),
    "goal_mark": ("#5a6600", "#3f4700"),
    "light": ("#ffffff", "#ffffff"),
    # meanings on rubber
    "left2": ("#5cbcf5", "#5cbcf5"),
    "right2": ("#ff9a57", "#ff9a57"),
    "turning2": ("#c9a8ff", "#d8c4ff"),
    "velocity2": ("#46d3a0", "#46d3a0"),
}

GRADIENTS = {
    "pool": Gradient("r", ((0, "floor_lit"), (1, "floor"))),
    "road": Gradient("r", ((0, "asphalt_lit"), (1, "asphalt"))),
    "air": Gradient("r", ((0, "wall_lit"), (1, "wall"))),
    "bench": Gradient("y", ((0, "wood_dark"), (0.84, "wood"), (1, "wood_lit"))),
    "tyre": Gradient(
        "x", ((0, "tread"), (0.2, "rubber"), (0.5, "rubber_mid"), (0.8, "rubber"), (1, "tread"))
    ),
    "roller": Gradient(
        "y", ((0, "tread"), (0.25, "rubber"), (0.5, "rubber_mid"), (0.75, "rubber"), (1, "tread"))
    ),
    "dome": Gradient("r", ((0, "shell"), (0.72, "shell"), (1, "shell_mid"))),
    "side": Gradient("r", ((0, "shell_mid"), (0.86, "shell_mid"), (1, "shell_dark"))),
    "cover": Gradient("r", ((0, "metal"), (0.6, "metal_mid"), (0.88, "metal"), (1, "metal_dark"))),
    "tube": Gradient(
        "y",
        (
            (0, "accent_dark"),
            (0.25, "accent"),
            (0.5, "accent_lit"),
            (0.75, "accent"),
            (1, "accent_dark"),
        ),
    ),
    "steel": Gradient("y", ((0, "metal_dark"), (0.4, "metal"), (0.6, "metal"), (1, "metal_dark"))),
    "drum": Gradient(
        "x", ((0, "metal_dark"), (0.3, "metal"), (0.7, "metal_mid"), (1, "metal_dark"))
    ),
    "paintwork": Gradient(
        "y",
        (
            (0, "accent_dark"),
            (0.12, "accent"),
            (0.34, "accent_lit"),
            (0.5, "accent"),
            (0.66, "accent_lit"),
            (0.88, "accent"),
            (1, "accent_dark"),
        ),
    ),
    "roof": Gradient("y", ((0, "accent"), (0.5, "accent_lit"), (1, "accent"))),
    "tube_pale": Gradient(
        "y",
        (
            (0, "shell_dark"),
            (0.25, "shell_mid"),
            (0.5, "shell"),
            (0.75, "shell_mid"),
            (1, "shell_dark"),
        ),
    ),
    "drum_pale": Gradient(
        "x", ((0, "shell_dark"), (0.3, "shell"), (0.7, "shell_mid"), (1, "shell_dark"))
    ),
    "ball": Gradient("r", ((0, "goal"), (0.6, "goal"), (1, "goal_dark"))),
    "steel_ball": Gradient("r", ((0, "metal"), (0.55, "metal_mid"), (1, "metal_dark"))),
    "bubble": Gradient(
        "r", ((0, "glass_lit", 0.06), (0.7, "glass_lit", 0.2), (1, "glass_lit", 0.7))
    ),
    "sheen": Gradient("r", ((0, "light", 0.75), (1, "light", 0))),
    "lamplight": Gradient("r", ((0, "floor_lit"), (0.6, "floor_lit", 0.9), (1, "floor_lit", 0))),
    "table": Gradient("r", ((0, "plank_lit"), (1, "plank"))),
    "glaze": Gradient(
        "y",
        ((0, "glass"), (0.3, "glass_lit"), (0.5, "glass"), (0.7, "glass_lit"), (1, "glass")),
    ),
}

GROUNDS = {
    "tiles": Ground("pool", "floor", "seam", "floor_lit"),
    "wall": Ground("air", "wall"),
    "asphalt": Ground("road", "asphalt"),
    "paper": Ground("paper", "paper"),
    "night": Ground("night", "night"),
    "table": Ground("table", "plank"),
}

MATERIALS = Materials(TONES, GRADIENTS, GROUNDS)
