"""What is to be heard of a stroke: tip, balls, cushions and pockets, as loud as they meet."""

from __future__ import annotations

from game.billiards.game.frame import Struck
from game.scenes.billiards.modes import Replay
from game.scenes.billiards.play import PHASE_S, REPLAY, ROLLING, Play
from game.scenes.shared.tables.sounds import sounds_of
from game.stage import Hearing, Sound


class StrokeSounds:
    """The sounds of the last stroke, made when they are asked for; no part of the state."""

    def __init__(self, play: Play, replay: Replay) -> None:
        self.play = play
        self.replay = replay
        self._of: Struck | None = None
        self._sounds: tuple[Sound, ...] = ()

    @property
    def sounds(self) -> tuple[Sound, ...]:
        """What is to be heard of the last stroke."""
        last = self.play.model.frame.last
        if self._of is not last:
            played = self.play.model.played
            slipped = last is not None and self.play.push.slipped and last.stroke == self.play.done
            self._sounds = (
                sounds_of(played.trajectory, last.stroke.cue_speed, slipped=slipped)
                if last and played
                else ()
            )
            self._of = last
        return self._sounds

    def hearing(self) -> Hearing | None:
        """The line of sounds of the shot that rolls or is replayed, and the moment in it."""
        play, frame = self.play, self.play.model.frame
        if play.phase not in (ROLLING, REPLAY) or frame.last is None or play.model.played is None:
            return None
        again = play.phase == REPLAY
        if again and (not self.replay.runs or self.replay.speed < 0.5):
            return None  # sounds are not slowed down
        time = self.replay.time if again else float(play.clock[PHASE_S])
        return Hearing((play.phase, frame.strokes, id(frame.last)), time, self.sounds)
