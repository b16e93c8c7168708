"""What a step of a broad-phase scene may compute: the boxes' motion, the boundary, and ways to keep pairs."""

from game.physics.effects import Room, declare_effect

MOTION = declare_effect("box-motion", "Motion", "Boxes move: explicit Euler.")
BOUNDARY = declare_effect("boundary", "Boundary", "The velocity of a box beyond the boundary is negated.")
MATRIX_PAIRS = declare_effect(
    "matrix-pairs", "Full matrix", "Pairs are kept in a full matrix, with begin and end."
)
HASHED_PAIRS = declare_effect(
    "hashed-pairs", "Hash table", "Pairs are kept in a hash table, with begin and end."
)
NAIVE = declare_effect("naive-pairs", "Naive n²", "Every box is tested against every other.")
BOXES = Room("boxes", MOTION | BOUNDARY | MATRIX_PAIRS | HASHED_PAIRS | NAIVE)
