"""What the live figures must show, a module a topic, computed by `robokin`.

Each module has READOUTS (figure → function from the columns of its settings to its readouts),
SPECIALS (figure → settings that are always tried) and WORDS (figure, settings, readout, word).
"""
