"""When to look at which key time: easing, and equal ways in equal times.

A part of the whole duration (0 to 1) is eased, then either spread evenly over the key times or over the
length of the path. What comes out is the time at which the key-frames are sampled. What is off is not
computed.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.animation.easing import Easing
from game.physics.animation.effects import CONSTANT_SPEED, EASING, PLAYBACKS
from game.physics.animation.keyframes import Keyframes
from game.physics.animation.piecewise import PiecewiseCubic
from game.physics.effects import Effect, EffectSet
from game.physics.kernels import elementwise

NOTHING = EffectSet(())


class Playback:
    """Key-frames from ``begin`` to ``end`` (s; by themselves those of the first and last key), as played.

    columns: those of the place, whose path has the length. effects: of `PLAYBACKS`. With constant speed the
    time outside the keys does not count, as nothing moves there. "nearest" has no way between its keys, so
    nothing is spread there, nor for a path that is a point. ValueError for other effects.
    """

    def __init__(
        self,
        track: Keyframes,
        columns: Sequence[int] = (0, 1),
        easing: Easing | None = None,
        effects: EffectSet | Effect = NOTHING,
        begin: float | None = None,
        end: float | None = None,
    ) -> None:
        effects = PLAYBACKS.checked(effects)
        first, last = track.span
        self.track, self.columns = track, list(columns)
        self.begin, self.end = first if begin is None else begin, last if end is None else end
        self.easing = easing if easing is not None and EASING in effects else None
        self.path: PiecewiseCubic | None = track.path(columns) if len(track) > 1 else None
        moves = CONSTANT_SPEED in effects and self.path is not None and track.interpolation != "nearest"
        self.spread = moves and self.path is not None and self.path.length > 0.0

    def key_times(self, parts: ArrayLike) -> Floats:
        """Times (s) at which the keys are sampled, for parts (0 to 1) of the duration."""
        along = np.asarray(parts, dtype=np.float64)
        if self.easing is not None:
            along = self.easing(along)
            if self.track.loop:  # a curve that draws back or overshoots goes round
                along = np.where((along < 0.0) | (along > 1.0), along - np.floor(along), along)
        if not self.spread or self.path is None:
            return np.asarray(self.begin + along * (self.end - self.begin))
        at = self.path.parameter_at(along * self.path.length)
        piece = np.minimum(at.astype(np.int64), self.path.pieces - 1)
        times = self.track.times
        return np.asarray(times[piece] + (at - piece) * (times[piece + 1] - times[piece]))

    def sample(self, parts: ArrayLike) -> Floats:
        """Values (..., m) at parts (...,) of the duration, as of `Keyframes.sample`."""
        return self.track.sample(self.key_times(parts))

    def speed(self, parts: ArrayLike) -> Floats:
        """Speed of the place at parts (k,) of the duration, in its unit by the whole duration."""
        along = np.asarray(parts, dtype=np.float64)
        pace = np.abs(self.easing.slope(along)) if self.easing is not None else np.ones(along.shape)
        if self.spread and self.path is not None:
            return np.asarray(pace * self.path.length)
        rates = self.track.rate(self.key_times(along))[..., self.columns]
        return np.asarray(pace * (self.end - self.begin) * np.sqrt((rates * rates).sum(axis=-1)))

    def heading(self, parts: ArrayLike) -> Floats:
        """Angle (...,) rad of the way at parts (...,) of the duration, also while it stands still."""
        return self.heading_at(self.key_times(parts))

    def heading_at(self, times: ArrayLike) -> Floats:
        """The same at times of the keys, s."""
        times = np.asarray(times, dtype=np.float64)
        if self.path is None:
            return np.zeros(times.shape)
        knots = self.track.times
        piece = np.clip(np.searchsorted(knots, times, side="right") - 1, 0, self.path.pieces - 1)
        length = knots[piece + 1] - knots[piece]
        u = np.divide(times - knots[piece], length, out=np.zeros(times.shape), where=length > 0.0)
        way = self.path.direction(piece + np.clip(u, 0.0, 1.0))
        return np.asarray(elementwise.arctan2(way[..., 1], way[..., 0]))
