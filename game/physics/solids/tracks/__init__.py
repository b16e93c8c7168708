"""Balls on smooth tracks: they roll and slide along curves, lift off, fly and land; no chords, no bumps."""

from game.physics.solids.tracks.curves import Curve, moved_aside
from game.physics.solids.tracks.world import DISC, SPHERE, TrackSettings, TrackState, TrackWorld

__all__ = ["DISC", "SPHERE", "Curve", "TrackSettings", "TrackState", "TrackWorld", "moved_aside"]
