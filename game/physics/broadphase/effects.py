"""What a step of a broad-phase scene may compute: the boxes' motion, the boundary, and ways to keep pairs."""

from game.physics.effects import declare_effect

MOTION = declare_effect("broadphase", "box-motion", 44, "Motion", "Boxes move: explicit Euler.")
BOUNDARY = declare_effect(
    "broadphase", "boundary", 45, "Boundary", "The velocity of a box beyond the boundary is negated."
)
MATRIX_PAIRS = declare_effect(
    "broadphase", "matrix-pairs", 46, "Full matrix", "Pairs are kept in a full matrix, with begin and end."
)
HASHED_PAIRS = declare_effect(
    "broadphase", "hashed-pairs", 47, "Hash table", "Pairs are kept in a hash table, with begin and end."
)
NAIVE = declare_effect("spare", "naive-pairs", 58, "Naive n²", "Every box is tested against every other.")
