"""The camera of a story: where it looks at each moment of the film, and how wide.

It is found as the story goes on, from what is known then: keys of (x, y, log width) are laid a little ahead
of the picture, where what is followed is expected to be. The picture goes through them by a monotone cubic.
So it is the same in a window, in a film and after a step back. It only looks, and is no part of the state.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.physics.animation import Keyframes
from game.physics.kernels import elementary
from game.stage.declarations import Frame

EVERY_S = 0.1  # s of film between keys
AHEAD_S = 0.2  # s of film that keys are laid ahead of the picture: a cubic wants two beyond it
LOOK_AHEAD_S = 0.4  # s by which the camera is ahead of what it follows
SMOOTHING_S = 0.3  # s over which the speed of what is followed is taken
MIDDLE = 0.3  # of the picture's size to each side of its middle: there is what is followed
LEAD = 0.18  # of the picture's size: most that looking ahead moves it
ASPECT = 16.0 / 9.0  # of the part of the world that is always in the picture
NEIGHBOURS = 3  # keys to each side that a piece of the curve is made of


class View(NamedTuple):
    """Middle of the picture (m) and the logarithm of its width (m)."""

    x: float
    y: float
    log_width: float

    @property
    def width(self) -> float:
        """m across."""
        return elementary.exp(self.log_width)

    def frame(self, turned: bool = False) -> Frame:
        """What is in the picture at least; ``turned``: the picture's width is along the world's y."""
        half = (0.5 * self.width, 0.5 * self.width / ASPECT)
        across, up = half[::-1] if turned else half
        return Frame(self.x - across, self.y - up, self.x + across, self.y + up)


def view_of(frame: Frame, turned: bool = False) -> View:
    """The view that shows all of a frame."""
    across, up = frame.right - frame.left, frame.top - frame.bottom
    if turned:
        across, up = up, across
    width = max(across, up * ASPECT, 1e-9)
    return View(0.5 * (frame.left + frame.right), 0.5 * (frame.bottom + frame.top), elementary.log(width))


def kept_inside(view: View, x: float, y: float, turned: bool = False) -> View:
    """The view moved just so far that a point is in the middle 60 % of it."""
    across, up = 2.0 * MIDDLE * 0.5 * view.width, 2.0 * MIDDLE * 0.5 * view.width / ASPECT
    if turned:
        across, up = up, across
    return View(min(max(view.x, x - across), x + across), min(max(view.y, y - up), y + up), view.log_width)


class Aim(NamedTuple):
    """What the camera is told: a target by name ("" for a fixed place), and how it gets there.

    ``width``: None keeps that of before. ``origin``: the view that it comes from. ``begins``: s of film.
    """

    target: str
    x: float
    y: float
    log_width: float
    begins: float
    ease: float
    origin: View


class _Key(NamedTuple):
    """A key of the path at ``film_s``, laid at a step; where its target was then, and its speed, m/s."""

    film_s: float
    view: View
    step: int
    seen_s: float
    place: tuple[float, float]
    speed: tuple[float, float]


class CameraPath:
    """Keys in the order of the film, in shots: from one cut to the next."""

    def __init__(self, start: View, turned: bool = False) -> None:
        """``turned``: the picture's width is along the world's y."""
        self._start = start
        self._turned = turned
        self._shots: list[list[_Key]] = [[]]

    @property
    def next_s(self) -> float:
        """When the next key is to be laid, s of film."""
        keys = self._shots[-1]
        return keys[-1].seen_s + EVERY_S if keys else -math.inf

    def last(self) -> View:
        """The view at the last key."""
        for keys in reversed(self._shots):
            if keys:
                return keys[-1].view
        return self._start

    def cut(self) -> None:
        """A new shot: nothing of what was before is gone on from."""
        if self._shots[-1]:
            self._shots.append([])

    def lay(
        self, film_s: float, step: int, aim: Aim, place: tuple[float, float], ahead: float = AHEAD_S
    ) -> None:
        """A key from what is known at a moment of the film. place: m, of what is followed or looked at.

        ahead: s of film that the picture may go on before the next key is laid.
        """
        keys = self._shots[-1]
        if keys and keys[-1].film_s > film_s + ahead - 0.5 * EVERY_S:
            return
        speed = self._speed(keys, film_s, aim, place)
        lead = ahead + LOOK_AHEAD_S if aim.target else 0.0
        width = elementary.exp(aim.log_width)
        most = (
            (LEAD * width / ASPECT, LEAD * width) if self._turned else (LEAD * width, LEAD * width / ASPECT)
        )
        x = place[0] + _limited(lead * speed[0], most[0])
        y = place[1] + _limited(lead * speed[1], most[1])
        u = 1.0 if aim.ease <= 0.0 else min(max((film_s - aim.begins) / aim.ease, 0.0), 1.0)
        s = u * u * u * (10.0 - u * (15.0 - 6.0 * u))
        goal, origin = View(x, y, aim.log_width), aim.origin
        view = View(*(a + (b - a) * s for a, b in zip(origin, goal, strict=True)))
        if not keys:
            for earlier in (-ahead, 0.0):
                keys.append(_Key(film_s + earlier, view, step, film_s, place, speed))
        keys.append(_Key(film_s + ahead, view, step, film_s, place, speed))

    @staticmethod
    def _speed(keys: list[_Key], film_s: float, aim: Aim, place: tuple[float, float]) -> tuple[float, float]:
        """Of what is followed, m in a second of film, without its sudden changes."""
        if not keys or film_s <= keys[-1].seen_s or keys[-1].seen_s < aim.begins:
            return 0.0, 0.0
        before = keys[-1]
        passed = film_s - before.seen_s
        share = 1.0 - elementary.exp(-passed / SMOOTHING_S)
        now = [(a - b) / passed for a, b in zip(place, before.place, strict=True)]
        vx, vy = (old + (new - old) * share for old, new in zip(before.speed, now, strict=True))
        return vx, vy

    def at(self, film_s: float) -> View:
        """Where it looks at a moment of the film that keys have been laid for."""
        keys = self._shot_at(film_s)
        if not keys:
            return self._start
        count = len(keys)
        after = next((i for i in range(count - 1, -1, -1) if keys[i].film_s <= film_s), 0)
        part = keys[max(after - NEIGHBOURS, 0) : after + NEIGHBOURS + 1]
        track = Keyframes([key.film_s for key in part], [key.view for key in part], "monotone")
        return View(*track.sample(film_s).tolist())

    def _shot_at(self, film_s: float) -> list[_Key]:
        for keys in reversed(self._shots):
            if keys and keys[0].seen_s <= film_s + 1e-9:
                return keys
        return self._shots[0]

    def cuts(self) -> list[float]:
        """When new shots begin, s of film."""
        return [keys[0].seen_s for keys in self._shots[1:] if keys]

    def forget_after(self, step: int) -> None:
        """Drop what was laid after a step."""
        self._shots = [[key for key in keys if key.step <= step] for keys in self._shots]
        self._shots = [keys for keys in self._shots if keys] or [[]]


def _limited(value: float, most: float) -> float:
    return min(max(value, -most), most)
