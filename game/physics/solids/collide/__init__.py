"""Manifolds: where and how deep two shapes touch, as one normal and at most two points.

Everything happens in the frame of the first shape's body; the second one's corners are brought there. Kernels
write ``manifold`` (8,): the normal from the first to the second, then for each point its place midway between
both surfaces and the gap (negative: overlap), and ``features`` (2,): which corners met, by which a point is
known again. They return the number of points. Gaps up to ``reach`` (m) count: contacts are there before they
touch.
"""
