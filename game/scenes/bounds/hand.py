"""The hand in the scenes of bounding-volume trees: edits in each part of the picture, and the walks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from game.scenes.bounds import walk
from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import Board, Rules
from game.scenes.shared.outlines.level import MOST_POINTS
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.bounds.base import BoundsScene

REACH = 0.022  # of the height in view: how near to a thing the pointer takes it
RULES = Rules(most_outlines=2, most_points=MOST_POINTS)
DEEPEST = 24  # level that can be shown


def take_pointer(scene: BoundsScene, event: Pointer) -> None:
    """A pointer event, in the part of the picture where it is."""
    seen = scene.frame()
    reach = REACH * (seen.top - seen.bottom)
    panes = scene.panes()
    if len(panes) == 2:
        pane = panes[0] if event.x < 0.5 * (seen.left + seen.right) else panes[1]
        x, y = pane.world((event.x, event.y))
        event, reach = msgspec.structs.replace(event, x=x, y=y), reach / pane.scale
    _take_board(scene, editor.take_pointer(scene.board, event, RULES, scene.tool, reach))


def act(scene: BoundsScene, name: str) -> None:
    """One of the scene's named actions, or the editor's own."""
    if name in editor.TOOLS:
        scene.values["tool"] = name
        scene.parameter_changed("tool")
    elif name == "hierarchy":
        scene.values["hierarchy"] = not scene.hierarchy
    elif name in ("level-up", "level-down"):
        deeper = int(scene.deepest) + (1 if name == "level-down" else -1)
        scene.values["deepest"] = min(max(deeper, 0), DEEPEST)
    elif name == "walk":
        following = walk.WALKS[(walk.WALKS.index(scene.walked) + 1) % len(walk.WALKS)]
        scene.values["walked"] = following
        scene.parameter_changed("walked")
    elif name in ("walk-on", "walk-back"):
        walk.stand_at(scene, scene.cursor + (1 if name == "walk-on" else -1))
    elif name == "walk-start":
        walk.stand_at(scene, 0)
    elif name == "walk-play":
        scene.values["playing"] = not scene.playing
        scene.parameter_changed("playing")
    else:
        _take_board(scene, editor.act(scene.board, name, RULES))


def _take_board(scene: BoundsScene, board: Board) -> None:
    """Go on with a board, and say what it has to say."""
    outlines = scene.outlines
    scene.board = board
    if board.told:
        scene.told.append(board.told)
    if board.outlines is not outlines:
        scene.cursor = min(scene.cursor, walk.length_of(scene))
        scene.ask(scene.coherent)
