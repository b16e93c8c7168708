"""The figures of the pages: parts of the tree, bounds and events, drawn from the structures themselves."""

from __future__ import annotations

import numpy as np

from game.physics.broadphase import BroadPhase, BspTree, KineticSweep
from game.scenes.shared.marks import outline
from game.ui.canvas.pen import Pen

LEFT, TOP, SIDE = 12.0, 12.0, 184.0  # of the square in which a world of 1 m by 1 m is drawn
TALL = 44.0  # of the bars of events


def _place(x: float, y: float) -> tuple[float, float]:
    return LEFT + SIDE * min(max(x, 0.0), 1.0), TOP + SIDE * (1.0 - min(max(y, 0.0), 1.0))


def _draw_boxes(pen: Pen, phase: BroadPhase, colors: dict[int, str]) -> None:
    for box in phase.ids().tolist():
        x0, y0, x1, y1 = phase.boxes[box].tolist()
        corners = [_place(x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        pen.area(corners, colors.get(box, "text3"), 0.3)


def _draw_parts(pen: Pen, tree: BspTree) -> None:
    for x0, y0, x1, y1 in tree.leaves()[:, :4].tolist():
        corners = [_place(x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))]
        pen.line(corners, "violet", 1.0)


def _tree(count: int, seed: int) -> tuple[BspTree, np.ndarray, np.ndarray]:
    """A tree over small boxes in a world of 1 m, their ids and lower corners."""
    low = np.random.default_rng(seed).random((count, 2)) * 0.95
    tree = BspTree()
    ids = tree.add_boxes(low, low + 0.04)
    tree.pairs()
    return tree, ids, low


def draw_cuts(pen: Pen) -> None:
    """Boxes, and the parts into which the tree cuts the world."""
    tree, _, _ = _tree(70, 5)
    _draw_boxes(pen, tree, {})
    _draw_parts(pen, tree)
    counts = tree.leaves()[:, 4]
    for row, words in enumerate(
        (f"{len(tree)} boxes", f"{len(counts)} leaves", f"at most {counts.max():.0f}")
    ):
        pen.words(words, 208.0, 30.0 + 18.0 * row, "text2", "left")


def draw_repairs(pen: Pen) -> None:
    """A step of motion: the boxes that crossed a cut, found by what the tree says of each by itself."""
    tree, ids, low = _tree(70, 5)
    shift = 0.012 * np.random.default_rng(6).standard_normal(low.shape)
    crossed: dict[int, str] = {}
    for box in ids.tolist():
        before = tree.work.repairs
        tree.update_box(box, low[box] + shift[box], low[box] + shift[box] + 0.04)
        if tree.work.repairs > before:
            crossed[box] = "amber"
    _draw_boxes(pen, tree, crossed)
    _draw_parts(pen, tree)
    pen.words(f"{len(crossed)} put anew", 208.0, 30.0, "amber", "left")
    pen.words(f"{len(ids) - len(crossed)} stay", 208.0, 48.0, "text2", "left")


def draw_gathered(pen: Pen) -> None:
    """A swarm has drawn together: its part was cut anew."""
    tree, ids, low = _tree(70, 5)
    for step in range(80):
        part = min(step / 40.0, 1.0)
        now = (1.0 - part) * low + part * (0.04 + 0.34 * low)
        tree.update_boxes(ids, now, now + 0.04 - 0.02 * part)
        tree.pairs()
    _draw_boxes(pen, tree, {})
    _draw_parts(pen, tree)
    pen.words(f"{tree.work.moved}", 208.0, 30.0, "text1", "left")
    pen.words("boxes in parts", 208.0, 48.0, "text2", "left")
    pen.words("cut anew, in", 208.0, 66.0, "text2", "left")
    pen.words("80 steps", 208.0, 84.0, "text2", "left")


def draw_leaves(pen: Pen) -> None:
    """A swarm has drawn together a little: leaves that were split, and leaves that were merged."""
    tree, ids, low = _tree(70, 5)
    before = {tuple(leaf) for leaf in tree.leaves()[:, :4].tolist()}
    now = 0.55 * low + 0.45 * (0.04 + 0.34 * low)
    tree.update_boxes(ids, now, now + 0.04)
    tree.pairs()
    _draw_boxes(pen, tree, {})
    _draw_parts(pen, tree)
    split = merged = 0
    for leaf in tree.leaves()[:, :4].tolist():
        if tuple(leaf) in before:
            continue
        x0, y0, x1, y1 = leaf
        holds = any(x0 <= a and y0 <= b and c <= x1 and d <= y1 for a, b, c, d in before)
        split, merged = split + (not holds), merged + holds
        corners = [_place(x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        pen.area(corners, "green" if holds else "amber", 0.7)
    pen.words(f"{split} by splitting", 208.0, 30.0, "amber", "left")
    pen.words(f"{merged} by merging", 208.0, 48.0, "green", "left")


def draw_once(pen: Pen) -> None:
    """Pairs, and the lower corner of each overlap: it lies in one leaf only."""
    low = np.random.default_rng(7).random((26, 2)) * 0.84
    tree = BspTree()
    tree.add_boxes(low, low + 0.14)
    pairs = tree.pairs()
    _draw_boxes(pen, tree, {})
    _draw_parts(pen, tree)
    leaves, shared = tree.leaves()[:, :4], 0
    for a, b in pairs.tolist():
        x0, y0 = np.maximum(tree.boxes[a, :2], tree.boxes[b, :2]).tolist()
        x1, y1 = np.minimum(tree.boxes[a, 2:], tree.boxes[b, 2:]).tolist()
        both = (leaves[:, 0] < x1) & (leaves[:, 1] < y1) & (leaves[:, 2] > x0) & (leaves[:, 3] > y0)
        shared += int(np.count_nonzero(both)) > 1
        pen.area([_place(x, y) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))], "amber", 0.6)
        pen.disc(*_place(x0, y0), 2.6, "vermilion")
    pen.words(f"{len(pairs)} pairs", 208.0, 30.0, "text1", "left")
    pen.words(f"{shared} in several", 208.0, 48.0, "text2", "left")
    pen.words("leaves, each", 208.0, 66.0, "text2", "left")
    pen.words("told once", 208.0, 84.0, "text2", "left")


def _sweep(slabs: int, growth: float = 3.0) -> KineticSweep:
    """A sweep over boxes in motion in a world of 1 m."""
    return _led(slabs, growth)[0]


def _led(slabs: int, growth: float = 3.0) -> tuple[KineticSweep, np.ndarray]:
    """The sweep, and lower corners (n, 2) m that its boxes will have if they go on as foreseen."""
    rng = np.random.default_rng(11)
    low = 0.1 + 0.75 * rng.random((16, 2))
    angles = 2.0 * np.pi * rng.random(16)
    way = 0.012 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    sweep = KineticSweep(slabs, growth)
    ids = sweep.add_boxes(low, low + 0.045)
    for step in range(4):
        now = low + step * way
        sweep.update_boxes(ids, now, now + 0.045)
        sweep.pairs()
    return sweep, low + 4.0 * way


def _draw_bounds(pen: Pen, slabs: int) -> None:
    sweep = _sweep(slabs)
    for box in sweep.ids().tolist():
        corners = [_place(x, y) for x, y in sweep.polygon(box).tolist()]
        outline(pen, corners, "chalk", 1.4, "chalk", 0.9)
    _draw_boxes(pen, sweep, {})
    pen.words(f"{slabs} sides", 208.0, 30.0, "text1", "left")
    pen.words(f"{sweep.candidates} candidates", 208.0, 48.0, "text2", "left")
    pen.words(f"{sweep.false_pairs} false", 208.0, 66.0, "text2", "left")


def draw_plain_bounds(pen: Pen) -> None:
    """Bounds with 4 sides: boxes about what is swept."""
    _draw_bounds(pen, 4)


def draw_aligned_bounds(pen: Pen) -> None:
    """Bounds with a slab across the motion, in one of eight directions."""
    _draw_bounds(pen, 16)


def draw_queue(pen: Pen) -> None:
    """Bounds that are used up in each of the next steps."""
    rng = np.random.default_rng(12)
    low = rng.random((600, 2))
    way = 0.001 * rng.standard_normal((600, 2))
    sweep = KineticSweep()
    ids = sweep.add_boxes(low, low + 0.03)
    for step in range(12):
        sweep.update_boxes(ids, low + step * way, low + step * way + 0.03)
        sweep.pairs()
    coming = sweep.coming_events()[:64]
    most = max(int(coming.max()), 1)
    for step, count in enumerate(coming.tolist()):
        x = 20.0 + 4.0 * step
        pen.line(((x, 170.0), (x, 170.0 - 130.0 * count / most)), "amber", 2.4)
    pen.line(((16.0, 171.0), (280.0, 171.0)), "line2", 1.0)
    pen.words("next step", 16.0, 186.0, "text2", "left")
    pen.words("64 steps on", 280.0, 186.0, "text2", "right")
    pen.words(f"600 boxes, at most {most} events in a step", 148.0, 18.0, "text2")


def draw_renewed(pen: Pen) -> None:
    """A step in which some boxes have turned: their bounds were made anew, all others stay."""
    sweep, low = _led(16)
    ids = sweep.ids()
    before = {box: sweep.polygon(box).tolist() for box in ids.tolist()}
    low[:3] += (0.02, -0.02)  # elsewhere than their straight way would have led
    sweep.update_boxes(ids, low, low + 0.045)
    sweep.pairs()
    anew = [box for box in ids.tolist() if sweep.polygon(box).tolist() != before[box]]
    for box in ids.tolist():
        color = "amber" if box in anew else "chalk"
        corners = [_place(x, y) for x, y in sweep.polygon(box).tolist()]
        outline(pen, corners, color, 1.4, color, 0.85)
    _draw_boxes(pen, sweep, dict.fromkeys(anew, "amber"))
    pen.words(f"{len(anew)} anew", 208.0, 30.0, "amber", "left")
    pen.words(f"{len(ids) - len(anew)} stay", 208.0, 48.0, "chalk", "left")


def draw_candidates(pen: Pen) -> None:
    """Pairs whose bounds overlap, and those of them whose boxes do."""
    low = np.random.default_rng(13).random((26, 2)) * 0.9
    way = 0.01 * np.random.default_rng(14).standard_normal((26, 2))
    sweep = KineticSweep(16, 3.0)
    ids = sweep.add_boxes(low, low + 0.08)
    for step in range(4):
        sweep.update_boxes(ids, low + step * way, low + step * way + 0.08)
        met = {tuple(pair) for pair in sweep.pairs().tolist()}
    _draw_boxes(pen, sweep, {})
    middles = 0.5 * (sweep.boxes[:, :2] + sweep.boxes[:, 2:])
    for a, b in sweep.candidate_pairs().tolist():
        color = "amber" if (a, b) in met else "text3"
        pen.line((_place(*middles[a].tolist()), _place(*middles[b].tolist())), color, 1.6)
    pen.words(f"{sweep.candidates} candidates", 208.0, 30.0, "text2", "left")
    pen.words(f"{len(met)} pairs", 208.0, 48.0, "amber", "left")
