"""The map of the position on the pool table, drawn in a thread of its own, and what a click on it decides.

Nothing of it belongs to the state: what is chosen comes back as a decision, which the stage lets in as an
event.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from game.billiards.map.pool import PoolMap, Pot, pool_map
from game.billiards.search.legality import Legality, board_of, legality_of
from game.billiards.search.strokes import Board
from game.scenes.billiards.beside import MAP
from game.scenes.billiards.play import AIMING, SET_UP, Play
from game.scenes.billiards.practice.columns import ROWS
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.shared.newest import Newest
from game.stage import Decision

SAME = 1e-9  # by which the numbers of an aim may differ that was set for a stroke
SHOW, PLAY = "show", "pot"  # decisions: cue speed, azimuth, elevation, tip left and up, ball, pocket


class Drawn(NamedTuple):
    """A map, and the board it is of."""

    board: Board
    map: PoolMap


class PoolAdvisor:
    """What is known of the position, and what a person has clicked on."""

    def __init__(self, play: Play) -> None:
        self.play = play
        self.maker: Newest[Drawn] = Newest("pool map")
        self._clicked: tuple[object, str, Pot] | None = None
        self._chosen: tuple[object, Pot] | None = None  # of which question

    @property
    def active(self) -> bool:
        """True while a map is wanted: a person may play, or sets the balls up."""
        play, frame = self.play, self.play.model.frame
        if play.parameters.beside != MAP or frame.cue_ball is None or len(frame.layout.numbers) < 2:
            return False
        if play.phase == SET_UP:
            return True
        return play.phase == AIMING and frame.playable and play.person_plays

    @property
    def key(self) -> object:
        """Equal for equal positions, rules, cloths and hands."""
        frame = self.play.model.frame
        return frame.layout.places, frame.conditions, self._legality, hand_of(self.play).noise

    @property
    def _legality(self) -> Legality | None:
        """What the rules ask of the stroke; nothing while the balls are set up."""
        return None if self.play.phase == SET_UP else legality_of(self.play.model.frame)

    def _work(self) -> Callable[[], Drawn]:
        """What answers the question of the position on the table."""
        frame, legality, noise = self.play.model.frame, self._legality, hand_of(self.play).noise

        def draw() -> Drawn:
            board = Board(frame.layout, frame.table, frame.physics) if legality is None else board_of(frame)
            return Drawn(board, pool_map(board, noise, legality, groups=ROWS))

        return draw

    def drawn(self) -> Drawn | None:
        """The newest map there is, be it of an older position; asks for that of the position on the table."""
        if not self.active:
            return None
        self.maker.ask(self.key, self._work())
        latest = self.maker.latest
        return latest.value if latest is not None else None

    def now(self) -> Drawn | None:
        """The map of the position on the table, drawn here if it has not been; None while none is wanted."""
        return self.maker.answer(self.key, self._work()) if self.active else None

    @property
    def fresh(self) -> bool:
        """True if the newest map is of the position on the table."""
        latest = self.maker.latest
        return self.active and latest is not None and latest.key == self.key

    @property
    def chosen(self) -> Pot | None:
        """The pot of the row that was clicked, while the position is the same."""
        if self._chosen is None or not self.active or self._chosen[0] != self.key:
            return None
        return self._chosen[1]

    @property
    def aimed(self) -> Pot | None:
        """The pot that was clicked, while its stroke is the one that is set."""
        pot = self.chosen
        if pot is None or not np.allclose(self.play.aiming.stroke, pot.stroke, rtol=0.0, atol=SAME):
            return None
        return pot

    def click(self, row: int) -> None:
        """A row is clicked: its stroke is aimed and its map shown, at the second click, or while the balls
        are set up, it is played.
        """
        latest = self.maker.latest
        if not self.fresh or latest is None or not 0 <= row < len(latest.value.map.pots):
            return
        pot = latest.value.map.pots[row]
        again = self.aimed is pot
        at_once = again or self.play.phase == SET_UP
        self._chosen = (self.key, pot)
        self._clicked = (self.key, PLAY if at_once else SHOW, pot)

    def decisions(self, at_once: bool) -> list[Decision]:
        """What was clicked since the last call. at_once: the map is drawn before anything is decided."""
        if at_once:
            self.now()
        clicked, self._clicked = self._clicked, None
        if clicked is None or not self.active or clicked[0] != self.key:
            return []
        pot = clicked[2]
        return [Decision(clicked[1], (*pot.stroke, float(pot.ball), float(pot.pocket)))]
