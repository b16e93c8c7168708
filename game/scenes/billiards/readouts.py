"""What is measured of the balls on the billiard table."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.rules import CUE_BALL
from game.physics.kernels import linear
from game.scenes.billiards.play import PHASE_S, REPLAY, REPLAY_S, ROLLING, Play
from game.scenes.billiards.story.targets import StrokeSeen
from game.scenes.billiards.story.throw import Contact, throw_by_law
from game.stage import Readout


def readouts(play: Play, seen: StrokeSeen) -> tuple[Readout, ...]:
    """Balls, energy (of motion, without spin), speed of the cue ball, events so far, strokes, time.

    Then how far the first contact cuts and throws, beside the law, and what is down and scored.
    """
    frame = play.model.frame
    energy, speed, count = _measured(play)
    return (
        Readout("balls", len([number for number in frame.layout.numbers if number != CUE_BALL])),
        Readout("energy", energy, "J"),
        Readout("cue ball", speed, "m/s"),
        Readout("events", count),
        Readout("strokes", frame.strokes),
        Readout("shot", float(play.clock[PHASE_S]) if play.phase == ROLLING else 0.0, "s"),
        *_of_contact(seen.contact),
        Readout("down", len(seen.fallen) if play.phase == ROLLING else 0),
        *_scored(play),
    )


def _scored(play: Play) -> tuple[Readout, ...]:
    """Points of both players in a game that counts them, and whether it is over."""
    game = play.model.frame.game
    points = [*getattr(game, "points", ()), 0, 0][:2]
    names = ("points of the first", "points of the second")
    return (
        *(Readout(name, int(value)) for name, value in zip(names, points, strict=True)),
        Readout("over", int(game.over)),
    )


def _of_contact(contact: Contact | None) -> tuple[Readout, ...]:
    """Cut and throw of the first contact, degrees, what the law says, and how far both are apart."""
    cut = throw = law = math.nan
    if contact is not None:
        cut, throw = math.degrees(contact.cut), math.degrees(contact.throw)
        law = math.degrees(throw_by_law(contact.cut, contact.speed, contact.roll, contact.side))
    return (
        Readout("cut", cut, "°"),
        Readout("throw", throw, "°"),
        Readout("throw by law", law, "°"),
        Readout("throw error", abs(throw - law), "°"),
    )


def _measured(play: Play) -> tuple[float, float, int]:
    """Energy J, speed of the cue ball m/s, and events so far; zeros while nothing moves."""
    last = play.model.frame.last
    if play.phase not in (ROLLING, REPLAY) or play.model.played is None or last is None:
        return 0.0, 0.0, 0
    time = float(play.clock[PHASE_S if play.phase == ROLLING else REPLAY_S])
    trajectory = play.model.played.trajectory
    moving = trajectory.state_at(time).velocities
    numbers = list(last.frame.layout.numbers)
    masses = last.frame.layout.balls.masses[numbers]
    up = trajectory.rises_at(time)[1]
    energy = float((0.5 * masses * ((moving * moving).sum(axis=1) + up * up)).sum())
    cue_ball = moving[numbers.index(CUE_BALL)]
    count = int(np.searchsorted(trajectory.times, time, side="right"))
    return energy, math.sqrt(float(linear.product(cue_ball, cue_ball))), count
