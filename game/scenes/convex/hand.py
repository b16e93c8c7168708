"""The hand in the V-Clip and GJK scenes: edits, hulls that are taken, and the walk through a query."""

from __future__ import annotations

from game.scenes.convex.level import MOST_CORNERS
from game.scenes.convex.model.pair import PairModel
from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import Board, Rules, with_outlines
from game.scenes.shared.outlines.outline import Outline
from game.stage import Part, Pointer

REACH = 0.022  # of the height in view: how near to a thing the pointer takes it
RULES = Rules(most_outlines=2, most_points=MOST_CORNERS, may_be_open=False)
WHOLE = -1  # steps shown: all
ALL_CONVEX = "Both outlines are convex."


class Hand(Part):
    """Edits the outlines of a model, and says up to which step its last query is shown.

    shown: index of the step, or WHOLE.
    """

    def __init__(self, model: PairModel):
        self.model = model
        self.shown = WHOLE

    def take(self, event: Pointer) -> None:
        """A pointer event in the level's unit."""
        model, view, before = self.model, self.model.content.view, self.model.board
        reach = REACH * (view.top - view.bottom)
        model.board = editor.take_pointer(before, event, RULES, model.parameters.tool, reach)
        self._after_edit(before)

    def act(self, name: str) -> None:
        """One of the scene's named actions, or the editor's own."""
        model, before = self.model, self.model.board
        if name in ("earlier", "later", "all"):
            self._show(name)
        elif name == "start":
            self._next_start()
        elif name == "hull":
            self._accept_hulls()
        elif name in editor.TOOLS:
            model.parameters.tool = name
            model.board = editor.act(before, "cancel", RULES)
        elif name in ("turn-left", "turn-right"):
            model.board = editor.turn(before, editor.NOTCH if name == "turn-left" else -editor.NOTCH)
        else:
            model.board = editor.act(before, name, RULES)
        self._after_edit(before)

    def _after_edit(self, before: Board) -> None:
        """Pass on what the editor says, name a refusal, and measure again if something has changed."""
        model, board = self.model, self.model.board
        if board.told:
            model.messages.say(board.told)
        if board.outlines == before.outlines and bool(board.held) == bool(before.held):
            return
        for k in range(len(board.outlines)):
            refused = model.refusal(k)
            if refused is not None and not board.held:
                words = f"{'AB'[k]} is not convex at corner {refused.vertex + 1}. Press H to take its hull."
                if words not in model.messages.unread:
                    model.messages.say(words)
        model.query()

    def _accept_hulls(self) -> None:
        """Put the hull in place of each outline that is refused."""
        model = self.model
        outlines = list(model.board.outlines)
        for k, outline in enumerate(outlines):
            refused = model.refusal(k)
            if refused is not None:
                corners = tuple((x, y) for x, y in refused.hull.vertices.tolist())
                outlines[k] = Outline(corners, True, outline.position, outline.angle)
        if tuple(outlines) == model.board.outlines:
            model.messages.say(ALL_CONVEX)
            return
        model.board = with_outlines(model.board, tuple(outlines))

    def _next_start(self) -> None:
        """Begin at the next pair of features: of B first, then of A."""
        shapes = self.model.shapes()
        if shapes is None:
            return
        a, b = shapes
        first, second = self.model.starts()
        second += 1
        if second >= 2 * len(b):
            first, second = (first + 1) % (2 * len(a)), 0
        self.model.parameters.start_a, self.model.parameters.start_b = first, second
        self.model.query(fresh=True)

    def _show(self, name: str) -> None:
        """Show the query up to the step before ("earlier") or after ("later") the one shown, or all of it."""
        last = self.model.trace_length() - 1
        now = last if self.shown == WHOLE else min(self.shown, last)
        if name == "all" or last < 0:
            self.shown = WHOLE
        elif name == "earlier":
            self.shown = max(now - 1, 0)
        else:
            self.shown = WHOLE if self.shown == WHOLE or now >= last else now + 1
