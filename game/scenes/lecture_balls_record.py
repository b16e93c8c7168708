"""The record of the last collision: one row of numbers in the state, and the names of its parts."""

WIDTH = 36
ANGLE, OVERLAP, RULE, EXCHANGED = range(4)
CONTACT = slice(4, 6)  # px
POSITIONS, NEW_POSITIONS = (
    slice(6, 10),
    slice(10, 14),
)  # of both balls, before and after they are parted
VELOCITIES, NEW_VELOCITIES = slice(14, 18), slice(18, 22)
PARTS, NEW_PARTS = slice(22, 26), slice(26, 30)  # along and across the line of centres
MOMENTA = slice(30, 34)  # of both balls together: before x, y, after x, y
ENERGY, NEW_ENERGY = 34, 35
