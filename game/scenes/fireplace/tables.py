"""The hearth's measures, and rows of the table of pieces of wood."""

from __future__ import annotations

# m: the box of gas, the hood and the flue above it
HALF, TALL = 0.8, 1.6
HOOD_OUT, HOOD_FOOT, HOOD_IN, THROAT, WALL = 0.6, 0.8, 0.15, 1.18, 0.05
GRATE, BAR = 0.135, 0.011  # m: height of the middle of its bars, and their radius
BARS = (-0.32, -0.19, -0.06, 0.07, 0.2, 0.33)
UPRIGHTS = (-0.38, 0.38)
DAMPER_AT = 1.26  # m
ROOM = 293.15  # K
# of a piece: body, wood it belongs to, number in it, half length, half thickness (m) when whole, share of its
# thickness that is left, fuel (kg) when whole, joint to the one before it
BODY, OF, NUMBER, HALF_LENGTH, HALF_THICK, SCALE, WHOLE, JOINT = range(8)
PIECE_WIDTH = 8
NONE = -1.0
