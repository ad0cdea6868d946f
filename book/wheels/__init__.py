"""What does each wheel allow, what does it forbid?"""

CARD = "wheels-card"
LEVEL = 3
TERMS = (
    "rolling constraint|rolling row",
    "sliding constraint|sliding row",
    "degree of mobility",
    "degree of steerability|steerability",
    "degree of manoeuvrability",
)
