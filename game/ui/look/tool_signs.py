"""Signs of the tools of a hand: what each makes, joins, moves or takes away."""

from __future__ import annotations

from game.ui.look.strokes import Part, arc, disc, frame, line, ring, solid

_PENTAGON = ((0.0, -6.4), (6.1, -2.0), (3.8, 5.2), (-3.8, 5.2), (-6.1, -2.0))
_WIDTH = 1.6

TOOL_SIGNS: dict[str, tuple[Part, ...]] = {
    "select": (
        solid((-4.6, -6.6), (4.9, 2.0), (-4.6, 6.0)),
        line((-0.6, 2.0), (2.2, 6.6), width=2.0),
    ),
    "grab": (
        line((-6.6, 0.0), (6.6, 0.0), width=_WIDTH),
        line((0.0, -6.6), (0.0, 6.6), width=_WIDTH),
        line((-4.6, -2.0), (-6.6, 0.0), (-4.6, 2.0), width=_WIDTH),
        line((4.6, -2.0), (6.6, 0.0), (4.6, 2.0), width=_WIDTH),
        line((-2.0, -4.6), (0.0, -6.6), (2.0, -4.6), width=_WIDTH),
        line((-2.0, 4.6), (0.0, 6.6), (2.0, 4.6), width=_WIDTH),
    ),
    "throw": (
        disc(-4.2, 4.2, 2.6),
        line((-2.0, 2.0), (5.8, -5.8), width=_WIDTH),
        line((1.4, -5.8), (5.8, -5.8), (5.8, -1.4), width=_WIDTH),
    ),
    "ball": (ring(0.0, 0.0, 5.9, _WIDTH), line((0.0, 0.0), (4.2, -4.2), width=1.3)),
    "box": (frame(5.6, 5.0, 0.8, _WIDTH),),
    "polygon": (line(*_PENTAGON, _PENTAGON[0], width=_WIDTH),),
    "capsule": (frame(6.8, 3.4, 3.4, _WIDTH),),
    "outline": (
        line((-6.6, 6.6), (-5.2, 2.4), (2.8, -5.6), (5.6, -2.8), (-2.4, 5.2), (-6.6, 6.6), width=_WIDTH),
        line((0.6, -3.4), (3.4, -0.6), width=1.3),
    ),
    "pin": (ring(0.0, -2.6, 3.2, _WIDTH), disc(0.0, -2.6, 1.2), line((0.0, 0.6), (0.0, 6.6), width=_WIDTH)),
    "weld": (
        frame(3.0, 3.0, 0.6, 1.4, -3.4, 0.0),
        frame(3.0, 3.0, 0.6, 1.4, 3.4, 0.0),
        line((-1.7, -5.8), (1.7, -2.4), width=_WIDTH),
        line((1.7, -5.8), (-1.7, -2.4), width=_WIDTH),
    ),
    "motor": (
        arc(0.0, 0.0, 5.6, 320.0, 270.0, _WIDTH),
        line((1.4, -4.6), (4.5, -3.6), (5.2, -6.9), width=_WIDTH),
        disc(0.0, 0.0, 1.7),
    ),
    "rope": (arc(0.0, -4.4, 6.0, 0.0, 180.0, _WIDTH), disc(-6.0, -4.4, 1.7), disc(6.0, -4.4, 1.7)),
    "spring": (
        line(
            (-7.2, 0.0),
            (-5.0, 0.0),
            (-3.8, -3.6),
            (-1.4, 3.6),
            (1.0, -3.6),
            (3.4, 3.6),
            (5.0, 0.0),
            (7.2, 0.0),
            width=1.5,
        ),
    ),
    "cut": (
        ring(-3.6, 4.6, 2.1, 1.4),
        ring(3.6, 4.6, 2.1, 1.4),
        line((-2.5, 2.8), (3.6, -6.6), width=_WIDTH),
        line((2.5, 2.8), (-3.6, -6.6), width=_WIDTH),
    ),
    "duplicate": (
        frame(4.2, 4.2, 0.8, 1.5, 2.0, 2.0),
        line((1.2, -6.2), (-6.2, -6.2), (-6.2, 1.2), width=1.5),
    ),
    "delete": (
        line((-5.6, -4.2), (5.6, -4.2), width=_WIDTH),
        line((-1.8, -6.2), (1.8, -6.2), width=_WIDTH),
        line((-4.2, -4.0), (-3.4, 6.2), (3.4, 6.2), (4.2, -4.0), width=_WIDTH),
        line((-1.2, -1.2), (-0.9, 3.4), width=1.2),
        line((1.2, -1.2), (0.9, 3.4), width=1.2),
    ),
    "track": (
        arc(-3.2, 0.0, 3.3, 180.0, 180.0, 1.7),
        arc(3.3, 0.0, 3.2, 0.0, 180.0, 1.7),
        disc(-6.0, 2.6, 1.5),
    ),
    "pour": (
        line((-4.2, 1.6), (0.0, -6.2), (4.2, 1.6), width=1.6),
        arc(0.0, 2.0, 4.2, 0.0, 180.0, 1.6),
    ),
    "push": (
        line((-6.4, -2.6), (3.0, -2.6)),
        line((0.4, -5.4), (3.4, -2.6), (0.4, 0.2)),
        line((-6.4, 4.4), (-3.2, 2.6), (0.0, 4.4), (3.2, 2.6), (6.4, 4.4), width=1.5),
    ),
    "bend": (
        arc(0.0, 6.6, 8.4, 205.0, 130.0, _WIDTH),
        line((0.0, -1.0), (0.0, -6.6), width=1.4),
        line((-2.2, -4.4), (0.0, -6.6), (2.2, -4.4), width=1.4),
    ),
    "dye": (
        line((0.0, -6.6), (4.1, 0.6), width=_WIDTH),
        line((0.0, -6.6), (-4.1, 0.6), width=_WIDTH),
        arc(0.0, 2.0, 4.4, -18.0, 216.0, _WIDTH),
    ),
}
