"""The noise of one's own pushed strokes in words: how far direction and speed stray from what was meant."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from game.billiards.game.arrangement import Stroke
from game.billiards.map.hand import FEWEST, noise_of
from game.scenes.shared.tables.through.push import Push

ROLLING = "rolling"  # phase, as of `course` and of pool's `play`
TOLD_EVERY = 10  # strokes


def hand_words(pairs: Sequence[tuple[Stroke, Stroke]], radius: float) -> str:
    """Standard deviations of strokes, (meant, made) each; empty for too few. radius of the ball, m."""
    noise = noise_of(pairs, radius)
    if noise is None:
        return ""
    return f"±{math.degrees(noise.azimuth):.2f}°, ±{noise.speed:.2f} m/s from {len(pairs)} strokes"


def news_of_hand(pairs: Sequence[tuple[Stroke, Stroke]], radius: float) -> str:
    """The same as soon as it can be told, and after each TOLD_EVERY strokes; else empty."""
    count = len(pairs)
    told = count == FEWEST or count % TOLD_EVERY == 0
    words = hand_words(pairs, radius) if told else ""
    return f"Your hand: {words}." if words else ""


def pushed(course: Any) -> Stroke | None:
    """The stroke that rolls, if it was pushed: the instruments show it as it was made, not as it was set."""
    pair, last = course.aimed_and_done, course.model.frame.last
    if course.phase != ROLLING or not course.push.chosen or pair is None or last is None:
        return None
    made: Stroke = pair[1]
    return made if last.stroke == made else None


def stroke_words(meant: Stroke, made: Stroke, ball_per_cue: float) -> str:
    """How a stroke strayed from what was meant, in words; speeds are those of a ball struck in its middle."""
    off = math.degrees(math.remainder(made.azimuth - meant.azimuth, math.tau))
    side = "left" if off > 0.0 else "right"
    aside = f"{abs(off):.2f}° to the {side}" if abs(off) >= 0.005 else "straight"
    fast, wanted = made.cue_speed * ball_per_cue, meant.cue_speed * ball_per_cue
    return f"{fast:.1f} m/s for {wanted:.1f}, {aside}"


def sway_words(push: Push) -> str:
    """How much the aim sways, or how long the breath lasts; empty where no stroke is pushed."""
    if not push.chosen:
        return ""
    if push.breath.holding:
        return f"breath {push.breath.left_s:.0f} s"
    return f"sways ±{math.degrees(push.breath.size):.2f}°"
