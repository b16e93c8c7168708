"""The hand in the scenes of bounding-volume trees: edits in each part of the picture, and the walks."""

from __future__ import annotations

import msgspec

from game.scenes.bounds.model import BoundsModel
from game.scenes.bounds.panes import Panes
from game.scenes.bounds.walk import Walk
from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import Board, Rules
from game.scenes.shared.outlines.level import MOST_POINTS
from game.stage import Part, Pointer

REACH = 0.022  # of the height in view: how near to a thing the pointer takes it
RULES = Rules(most_outlines=2, most_points=MOST_POINTS)
DEEPEST = 24  # level that can be shown


class Hand(Part):
    """Edits the outlines of a model, and walks through its method."""

    def __init__(self, model: BoundsModel, walk: Walk, panes: Panes):
        self.model, self.walk = model, walk
        self.panes = panes

    def take(self, event: Pointer) -> None:
        """A pointer event, in the part of the picture where it is."""
        seen, panes = self.model.content.view, self.panes()
        reach = REACH * (seen.top - seen.bottom)
        if len(panes) == 2:
            pane = panes[0] if event.x < 0.5 * (seen.left + seen.right) else panes[1]
            x, y = pane.world((event.x, event.y))
            event, reach = msgspec.structs.replace(event, x=x, y=y), reach / pane.scale
        tool = self.model.parameters.tool
        self._take_board(editor.take_pointer(self.model.board, event, RULES, tool, reach))

    def act(self, name: str) -> None:
        """One of the scene's named actions, or the editor's own."""
        parameters, walk = self.model.parameters, self.walk
        if name in editor.TOOLS:
            parameters.tool = name
            self.act("cancel")
        elif name == "hierarchy":
            parameters.hierarchy = not parameters.hierarchy
        elif name in ("level-up", "level-down"):
            deeper = int(parameters.deepest) + (1 if name == "level-down" else -1)
            parameters.deepest = min(max(deeper, 0), DEEPEST)
        elif name == "walk":
            walk.take_next()
        elif name in ("walk-on", "walk-back"):
            walk.stand_at(walk.cursor + (1 if name == "walk-on" else -1))
        elif name == "walk-start":
            walk.stand_at(0)
        elif name == "walk-play":
            parameters.playing = not parameters.playing
            walk.start_if_ended()
        else:
            self._take_board(editor.act(self.model.board, name, RULES))

    def _take_board(self, board: Board) -> None:
        """Go on with a board, and pass on what it has to say."""
        model, outlines = self.model, self.model.outlines
        model.board = board
        if board.told:
            model.messages.say(board.told)
        if board.outlines is not outlines:
            self.walk.stay_within()
            model.ask(model.coherent)
