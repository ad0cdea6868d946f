"""What does each wheel allow, what does it forbid?"""

CARD = "wheels-card"
