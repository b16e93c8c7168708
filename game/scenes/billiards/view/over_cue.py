"""The pool table as an eye sees it: from the cue in a corner of the picture, from the side in place of it."""

from __future__ import annotations

from game.billiards.game.rules import CUE_BALL
from game.scenes.billiards import layout
from game.scenes.billiards.modes import Replay
from game.scenes.billiards.play import REPLAY, ROLLING, Play
from game.scenes.billiards.view.cloth import dress_of
from game.scenes.billiards.view.cue import SEEN, cue_seen
from game.scenes.billiards.view.words import foul_of
from game.scenes.shared.tables.boxes import rect_of
from game.scenes.shared.tables.eye.inset import Inset
from game.scenes.shared.tables.eye.lines import lines_of
from game.scenes.shared.tables.eye.picture import Furniture, Seen
from game.scenes.shared.tables.eye.view import Aimed, EyeView, Shown, ghost_of
from game.scenes.shared.tables.moments import OFF
from game.scenes.shared.tables.prediction import Sight
from game.scenes.shared.tables.view import Balls
from game.ui.canvas.canvas import Canvas


class OverCue:
    """Draws both. What it shows is the state of the game; it changes nothing."""

    def __init__(self, play: Play, replay: Replay) -> None:
        self.play = play
        self.replay = replay
        self._inset = Inset(play.parameters, play.model)
        self._eye = EyeView()

    @property
    def from_side(self) -> bool:
        """Whether the stroke that rolls, or is replayed, is seen from its side."""
        play = self.play
        if play.model.played is None:
            return False
        if play.phase == ROLLING:
            return play.parameters.eye_follows != OFF
        return play.phase == REPLAY and self.replay.from_side

    def draw_side(self, canvas: Canvas, balls: Balls, time: float) -> None:
        """The stroke from its best side, over the table, at a time of the phase, s."""
        frame, played = self.play.model.frame, self.play.model.played
        assert played is not None and frame.last is not None
        cue = frame.last.frame.layout.numbers.index(CUE_BALL)
        shown, furniture = Shown(played.trajectory, cue), Furniture(frame.table, dress_of(self.play))
        rect = rect_of(canvas, layout.TABLE)
        follows = time if self.play.phase == ROLLING else None
        self._eye.draw_side(canvas, rect, furniture, balls, shown, follows)

    def draw_inset(self, canvas: Canvas, balls: Balls, sight: Sight | None, time: float) -> None:
        """The view from the cue, if it is shown; of a stroke that rolls from where it was played."""
        box, play = self._inset.box, self.play
        if box is None or play.phase == REPLAY:
            return
        cue = cue_seen(play, time)
        last = play.model.frame.last
        if cue is not None:
            before, stroke = cue.before, cue.stroke
        elif play.phase == ROLLING and last is not None:
            before, stroke = last.frame, last.stroke
        else:
            before, stroke = play.model.frame, play.aiming.stroke
        if before.cue_ball is None:
            return
        radius = float(before.layout.balls.radii[CUE_BALL])
        gap = cue.gap if cue is not None and cue.solid >= SEEN else None
        foul = sight is not None and foul_of(before.game, play.aiming.call, sight.target, sight.short)
        lines = lines_of(sight, radius) if sight is not None else []
        seen = Seen(balls, lines, ghost_of(sight, radius, bool(foul)))
        aimed = Aimed(before.cue_ball, stroke, radius, gap)
        self._eye.draw_inset(
            canvas, box, Furniture(before.table, dress_of(play)), aimed, seen, play.parameters
        )
