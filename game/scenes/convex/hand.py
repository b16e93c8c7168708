"""The hand in the V-Clip and GJK scenes: edits, hulls that are taken, and the walk through a query."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.scenes.convex.level import MOST_CORNERS
from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import Board, Rules, with_outlines
from game.scenes.shared.outlines.outline import Outline
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.convex.base import ConvexPairScene

REACH = 0.022  # of the height in view: how near to a thing the pointer takes it
RULES = Rules(most_outlines=2, most_points=MOST_CORNERS, may_be_open=False)
WHOLE = -1  # steps shown: all
ALL_CONVEX = "Both outlines are convex."


def take_pointer(scene: ConvexPairScene, event: Pointer) -> None:
    """A pointer event in the level's unit."""
    view, before = scene.content.view, scene.board
    reach = REACH * (view.top - view.bottom)
    scene.board = editor.take_pointer(scene.board, event, RULES, scene.tool, reach)
    after_edit(scene, before)


def act(scene: ConvexPairScene, name: str) -> None:
    """One of the scene's named actions, or the editor's own."""
    before = scene.board
    if name in ("earlier", "later", "all"):
        show(scene, name)
    elif name == "start":
        next_start(scene)
    elif name == "hull":
        accept_hulls(scene)
    elif name in editor.TOOLS:
        scene.values["tool"] = name
        scene.board = editor.act(scene.board, "cancel", RULES)
    elif name in ("turn-left", "turn-right"):
        scene.board = editor.turn(scene.board, editor.NOTCH if name == "turn-left" else -editor.NOTCH)
    else:
        scene.board = editor.act(scene.board, name, RULES)
    after_edit(scene, before)


def after_edit(scene: ConvexPairScene, before: Board) -> None:
    """Tell what the editor says, name a refusal, and measure again if something has changed."""
    board = scene.board
    if board.told:
        scene.told.append(board.told)
    if board.outlines == before.outlines and bool(board.held) == bool(before.held):
        return
    for k in range(len(board.outlines)):
        refused = scene.refusal(k)
        if refused is not None and not board.held:
            words = f"{'AB'[k]} is not convex at corner {refused.vertex}. Press H to take its hull."
            if words not in scene.told:
                scene.told.append(words)
    scene.query()


def accept_hulls(scene: ConvexPairScene) -> None:
    """Put the hull in place of each outline that is refused."""
    outlines = list(scene.board.outlines)
    for k, outline in enumerate(outlines):
        refused = scene.refusal(k)
        if refused is not None:
            corners = tuple((x, y) for x, y in refused.hull.vertices.tolist())
            outlines[k] = Outline(corners, True, outline.position, outline.angle)
    if tuple(outlines) == scene.board.outlines:
        scene.told.append(ALL_CONVEX)
        return
    scene.board = with_outlines(scene.board, tuple(outlines))


def next_start(scene: ConvexPairScene) -> None:
    """Begin at the next pair of features: of B first, then of A."""
    a, b = scene.shape(0), scene.shape(1)
    if a is None or b is None:
        return
    first, second = scene.starts()
    second += 1
    if second >= 2 * len(b):
        first, second = (first + 1) % (2 * len(a)), 0
    scene.values["start_a"], scene.values["start_b"] = first, second
    scene.query(fresh=True)


def show(scene: ConvexPairScene, name: str) -> None:
    """Show the query up to the step before ("earlier") or after ("later") the one shown, or all of it."""
    last = scene.trace_length() - 1
    now = last if scene.shown == WHOLE else min(scene.shown, last)
    if name == "all" or last < 0:
        scene.shown = WHOLE
    elif name == "earlier":
        scene.shown = max(now - 1, 0)
    else:
        scene.shown = WHOLE if scene.shown == WHOLE or now >= last else now + 1
