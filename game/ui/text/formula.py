"""Formulas set in type: boxes of glyphs, rules and strokes, put together from the tree of ``markup``.

A box has a width, a height above and a depth below its baseline, and draws nothing by itself until all is
measured. Spacing follows TeX's classes (Knuth 1984, The TeXbook, chapters 17 and 18) in eighteenths of an em.
"""

from __future__ import annotations

import pygame

from game.ui.look.fonts import FontBook
from game.ui.look.shapes import SurfaceStore
from game.ui.text.formula_boxes import Box, Glyphs, Stroke, moved, paint_box
from game.ui.text.formula_brackets import bracket
from game.ui.text.markup import FormulaError, Node, parse

__all__ = ["FormulaError", "measure", "render_formula"]

SCRIPT = 0.7  # size of scripts, of their base
SMALLEST = 10.0  # design px of any letter
AXIS = 0.25  # em above the baseline: middle of signs, fraction bars, brackets
_THICK, _MEDIUM, _THIN = 5 / 18, 4 / 18, 3 / 18  # em
_ACCENT_SIGNS = {"dot": "˙", "ddot": "¨", "hat": "ˆ", "bar": "¯", "tilde": "˜"}


_store = SurfaceStore(2_000_000)


def render_formula(fonts: FontBook, text: str, color: pygame.Color, size: float = 20.0) -> pygame.Surface:
    """A formula on a transparent surface, cropped to its ink; kept, so do not draw on it.

    ``size``: design px of its letters. Raises FormulaError for what cannot be read.
    """
    key = (text, fonts.k, tuple(color), size)
    return _store.get(key, lambda: paint_box(_row(parse(text), _Setter(fonts, size)), fonts, color))


def measure(fonts: FontBook, text: str, size: float = 20.0) -> tuple[float, float, float]:
    """Width, height and depth in window px."""
    box = _row(parse(text), _Setter(fonts, size))
    return box.width, box.height, box.depth


class _Setter:
    """The size at which a part is set, and whether it is a script (set without spaces)."""

    def __init__(self, fonts: FontBook, size: float, script: bool = False) -> None:
        self.fonts = fonts
        self.size = max(size, SMALLEST)
        self.script = script

    @property
    def em(self) -> float:
        return self.size * self.fonts.k

    @property
    def rule(self) -> float:
        """Width of bars and strokes."""
        return max(1.0, round(self.em * 0.055))

    def smaller(self) -> _Setter:
        return _Setter(self.fonts, self.size * SCRIPT, True)

    def reduced(self) -> _Setter:
        """For the parts of a fraction."""
        return _Setter(self.fonts, self.size * 0.86, self.script)


def _set(node: Node, at: _Setter) -> Box:
    kind = node[0]
    if kind == "symbol":
        return _symbol(node[1], node[2], node[3], at)
    if kind == "row":
        return _row(node, at)
    if kind == "space":
        return Box(node[1] * at.em, 0.0, 0.0, (), "space")
    if kind == "fraction":
        return _fraction(node[1], node[2], at)
    if kind == "script":
        return _script(node[1], node[2], node[3], at)
    if kind == "root":
        return _root(node[1], at)
    if kind == "accent":
        return _accent(node[1], node[2], at)
    if kind == "fence":
        return _fence(node[1], node[2], node[3], at)
    return _matrix(node[1], at)


def _symbol(text: str, face: str, kind: str, at: _Setter) -> Box:
    size = at.size * (1.35 if kind == "large" else 1.0)
    font = at.fonts.font(size, face)
    extents = [m or (0, 0, 0, 0, 0) for m in font.metrics(text)]
    for letter, (left, right, low, high, _) in zip(text, extents, strict=False):
        if left == right and low == high and not letter.isspace():
            raise FormulaError(f"formula: the font has no {letter!r}")
    if not extents:
        return Box(0.0, 0.0, 0.0)
    height = float(max(m[3] for m in extents))
    depth = float(-min(m[2] for m in extents))
    width = float(font.size(text)[0])
    slant = max(0.0, extents[-1][1] - extents[-1][4]) if face != "formula" else 0.0
    down = 0.0
    if kind == "large":
        down = 0.5 * (height - depth) - AXIS * at.em
    glyphs = Glyphs(0.0, down, text, size, face)
    return Box(width, height - down, depth + down, (glyphs,), kind, slant)


def _gap(before: str, after: str, at: _Setter) -> float:
    """Space between two neighbours, px."""
    if at.script or not before:
        return 0.0
    if "relation" in (before, after):
        return _THICK * at.em
    if "operator" in (before, after):
        return _MEDIUM * at.em
    if before == "punctuation":
        return _THIN * at.em
    if "function" in (before, after) and after != "open" and before not in ("open", ""):
        return _THIN * at.em
    if "large" in (before, after):
        return _THIN * at.em
    return 0.0


def _row(node: Node, at: _Setter) -> Box:
    x, height, depth, slant, previous = 0.0, 0.0, 0.0, 0.0, ""
    marks: list[Glyphs | Stroke] = []
    kinds: list[str] = []
    for part in node[1]:
        box = _set(part, at)
        kind = box.kind
        if kind == "operator" and previous in ("", "relation", "operator", "open", "punctuation", "function"):
            kind = "ordinary"  # a sign, not an operation
        if kind != "space":
            x += _gap(previous, kind, at)
            previous = kind
        if slant and kind == "close":
            x += 0.5 * slant
        marks += moved(box.marks, x, 0.0)
        x += box.width
        height, depth, slant = max(height, box.height), max(depth, box.depth), box.slant
        kinds.append(kind)
    alone = kinds[0] if len(kinds) == 1 else "ordinary"
    return Box(x, height, depth, tuple(marks), alone, slant)


def _fraction(above: Node, below: Node, at: _Setter) -> Box:
    inner = at.reduced() if not at.script else at
    top, bottom = _set(above, inner), _set(below, inner)
    rule, clearance = at.rule, max(2.0, 0.12 * at.em)
    side = 0.08 * at.em
    width = max(top.width + top.slant, bottom.width + bottom.slant) + 2 * side
    axis = round(AXIS * at.em)
    up = axis + 0.5 * rule + clearance + top.depth
    down = -axis + 0.5 * rule + clearance + bottom.height
    marks = (
        *moved(top.marks, 0.5 * (width - top.width), -up),
        *moved(bottom.marks, 0.5 * (width - bottom.width), down),
        Stroke(0.0, -axis, width, -axis, rule),
    )
    outer = 0.08 * at.em
    return Box(width + 2 * outer, up + top.height, down + bottom.depth, moved(marks, outer, 0.0), "ordinary")


def _script(base: Node, below: Node | None, above: Node | None, at: _Setter) -> Box:
    body = _set(base, at)
    if body.kind == "large" and not at.script:
        return _limits(body, below, above, at)
    small = at.smaller()
    marks, width, height, depth = list(body.marks), 0.0, body.height, body.depth
    sub = _set(below, small) if below is not None else None
    sup = _set(above, small) if above is not None else None
    up = max(0.40 * at.em, body.height - 0.32 * at.em) if sup else 0.0
    down = max(0.18 * at.em, body.depth + 0.02 * at.em) if sub else 0.0
    if sub and sup:
        overlap = (sub.height - down) - (up - sup.depth) + 0.1 * at.em
        if overlap > 0.0:
            up, down = up + 0.5 * overlap, down + 0.5 * overlap
    gap = 0.05 * at.em
    if sup:
        shift = body.width + body.slant + gap
        marks += moved(sup.marks, shift, -up)
        width, height = max(width, shift + sup.width), max(height, up + sup.height)
    if sub:
        marks += moved(sub.marks, body.width + gap, down)
        width, depth = max(width, body.width + gap + sub.width), max(depth, down + sub.depth)
    return Box(width + 0.03 * at.em, height, depth, tuple(marks), body.kind)


def _limits(body: Box, below: Node | None, above: Node | None, at: _Setter) -> Box:
    """Scripts under and over a large operator."""
    small = at.smaller()
    parts = [_set(node, small) if node is not None else None for node in (below, above)]
    width = max([body.width, *(part.width for part in parts if part)])
    marks = list(moved(body.marks, 0.5 * (width - body.width), 0.0))
    height, depth, gap = body.height, body.depth, 0.1 * at.em
    under, over = parts
    if under:
        y = body.depth + gap + under.height
        marks += moved(under.marks, 0.5 * (width - under.width), y)
        depth = y + under.depth
    if over:
        y = body.height + gap + over.depth
        marks += moved(over.marks, 0.5 * (width - over.width), -y)
        height = y + over.height
    return Box(width, height, depth, tuple(marks), "large")


def _root(inside: Node, at: _Setter) -> Box:
    body = _set(inside, at)
    rule, head = at.rule, 0.12 * at.em
    top = body.height + head + rule
    foot = max(body.depth, 0.04 * at.em)
    hook, stem = 0.22 * at.em, 0.30 * at.em
    x0 = hook + stem
    middle = 0.45 * (top + foot) - foot
    strokes = (
        Stroke(0.02 * at.em, -middle + 0.06 * at.em, hook * 0.6, -middle, rule),
        Stroke(hook * 0.6, -middle, hook + 0.12 * at.em, foot, 1.6 * rule),
        Stroke(hook + 0.12 * at.em, foot, x0, -top + 0.5 * rule, rule),
        Stroke(
            x0 - 0.5 * rule,
            -top + 0.5 * rule,
            x0 + body.width + body.slant + 0.1 * at.em,
            -top + 0.5 * rule,
            rule,
        ),
    )
    width = x0 + body.width + body.slant + 0.14 * at.em
    return Box(width, top, foot, (*strokes, *moved(body.marks, x0 + 0.05 * at.em, 0.0)))


def _accent(name: str, inside: Node, at: _Setter) -> Box:
    body = _set(inside, at)
    middle = 0.5 * (body.width + body.slant) + 0.04 * at.em
    if name == "bar":
        y = -(body.height + 0.12 * at.em)
        half = 0.5 * body.width
        stroke = Stroke(middle - half, y, middle + half, y, at.rule)
        return body._replace(height=-y + at.rule, marks=(*body.marks, stroke))
    sign = _symbol(_ACCENT_SIGNS[name], "formula", "ordinary", at)
    low = -sign.depth  # how far the sign's ink starts above the baseline
    lift = body.height + 0.08 * at.em - low
    marks = (*body.marks, *moved(sign.marks, middle - 0.5 * sign.width, -lift))
    return body._replace(height=lift + sign.height, marks=marks)


def _fence(left: str, inside: Node, right: str, at: _Setter) -> Box:
    """Content between brackets that are as high as it is, symmetric about the axis."""
    body = _set(inside, at)
    axis = AXIS * at.em
    half = max(body.height - axis, body.depth + axis, 0.55 * at.em) + 0.06 * at.em
    x = 0.0
    marks: list[Glyphs | Stroke] = []
    for sign in (left, None, right):
        if sign is None:
            marks += moved(body.marks, x, 0.0)
            x += body.width + body.slant
        elif sign:
            strokes, width = bracket(sign, half, at.em, at.rule)
            marks += moved(strokes, x, -axis)
            x += width
    return Box(x, axis + half, half - axis, tuple(marks), "ordinary")


def _matrix(rows: tuple[tuple[Node, ...], ...], at: _Setter) -> Box:
    cells = [[_set(cell, at.reduced()) for cell in row] for row in rows]
    count = max(len(row) for row in cells)
    widths = [max((row[j].width for row in cells if j < len(row)), default=0.0) for j in range(count)]
    gap_x, gap_y = 0.7 * at.em, 0.28 * at.em
    heights = [max(max(cell.height for cell in row), 0.5 * at.em) for row in cells]
    depths = [max(max(cell.depth for cell in row), 0.15 * at.em) for row in cells]
    total = sum(heights) + sum(depths) + gap_y * (len(cells) - 1)
    y = -0.5 * total - AXIS * at.em
    marks: list[Glyphs | Stroke] = []
    for row, height, depth in zip(cells, heights, depths, strict=True):
        y += height
        x = 0.0
        for cell, width in zip(row, widths, strict=False):
            marks += moved(cell.marks, x + 0.5 * (width - cell.width), y)
            x += width + gap_x
        y += depth + gap_y
    width = sum(widths) + gap_x * (count - 1)
    half, axis = 0.5 * total, AXIS * at.em
    return Box(width, half + axis, half - axis, tuple(marks))
