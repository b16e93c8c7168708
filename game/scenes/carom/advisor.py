"""The map of the position on the table, drawn in a thread of its own, and what a click on it decides.

Nothing of it belongs to the state: what is chosen comes back as a decision, which the stage lets in as an
event. The newest position is drawn first; what was drawn last stays to be seen until then.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import NamedTuple

from numpy.typing import NDArray

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromFrame, Points
from game.billiards.map.carom import CaromMap, Group, Position, draw_map
from game.billiards.map.hand import noise_of
from game.billiards.map.routes import Wanted
from game.billiards.map.tolerance import Tolerance, tip_map, tolerance_of
from game.billiards.players.carom import CAROM_GRADES, position_of, wanted_of
from game.billiards.search.strokes import Noise
from game.billiards.shot.physics import Physics
from game.billiards.table.carom import BALL_RADIUS
from game.scenes.carom.course import Course
from game.scenes.carom.layout import ROWS
from game.scenes.shared.tables.choices import OWN
from game.scenes.shared.tables.course import AIMING
from game.stage import Decision


class MapKey(NamedTuple):
    """What a map is drawn of: equal for equal positions, rules, cloths and hands."""

    places: Points
    cue: int
    wanted: Wanted
    physics: Physics
    noise: Noise


class Drawn(NamedTuple):
    """A map, and of which position."""

    key: MapKey
    position: Position
    map: CaromMap


class Studied(NamedTuple):
    """What is known of one stroke: how far it may be off, and the map of its tip."""

    stroke: Stroke
    tolerance: Tolerance
    tips: NDArray


class MapMaker:
    """Draws the map of the newest position that it is asked for."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._wanted: tuple[MapKey, Callable[[], Position], Noise] | None = None
        self._begun: object = None
        self._thread: threading.Thread | None = None
        self._latest: Drawn | None = None
        self.failure = ""

    @property
    def latest(self) -> Drawn | None:
        """What was drawn last, be it of an older position."""
        with self._lock:
            return self._latest

    def ask(self, key: MapKey, make: Callable[[], Position], noise: Noise) -> None:
        """Have a map drawn; asking again for the same costs nothing."""
        with self._lock:
            if self._begun == key or (self._wanted is not None and self._wanted[0] == key):
                return
            self._wanted = (key, make, noise)
            if self._thread is None or not self._thread.is_alive():
                self._thread = threading.Thread(target=self._run, daemon=True, name="map")
                self._thread.start()

    def wait(self) -> None:
        """Until nothing is being drawn any more."""
        with self._lock:
            thread = self._thread
        if thread is not None:
            thread.join()

    def answer(self, key: MapKey, make: Callable[[], Position], noise: Noise) -> Drawn:
        """The whole map here and now."""
        found = self.latest
        if found is None or found.key != key or not found.map.fine:
            for drawn in draw_map(position := make(), noise):
                found = Drawn(key, position, drawn)
            with self._lock:
                self._latest, self._begun = found, key
        assert found is not None
        return found

    def _run(self) -> None:
        while True:
            with self._lock:
                wanted, self._wanted = self._wanted, None
                if wanted is None:
                    self._thread = None
                    return
                self._begun = wanted[0]
            try:
                self._draw(*wanted)
            except Exception as error:  # a map that fails must not stop the game
                self.failure = f"{type(error).__name__}: {error}"

    def _draw(self, key: MapKey, make: Callable[[], Position], noise: Noise) -> None:
        """Stage by stage, as long as nothing newer is wanted."""
        position = make()
        for drawn in draw_map(position, noise):
            with self._lock:
                if self._begun == key:
                    self._latest = Drawn(key, position, drawn)
                if self._wanted is not None:
                    return


class Advisor:
    """What is known of the position, and what a person has clicked on; no part of the state."""

    def __init__(self, course: Course) -> None:
        self.course = course
        self.maker = MapMaker()
        self._clicked: tuple[object, str, Stroke] | None = None
        self._studied: tuple[object, Studied] | None = None

    @property
    def active(self) -> bool:
        """True while a map is wanted: a person may play, or watches the table rest."""
        course = self.course
        frame = course.model.frame
        return (
            bool(course.parameters.map) and course.phase == AIMING and frame.playable and course.person_plays
        )

    @property
    def noise(self) -> Noise:
        """Of the hand whose chances are shown."""
        chosen = str(self.course.parameters.odds)
        own = noise_of(self.course.own, BALL_RADIUS) if chosen == OWN else None
        return own or CAROM_GRADES["club" if chosen == OWN else chosen].noise

    @property
    def key(self) -> MapKey:
        """What a map of the table would be drawn of."""
        frame, game = self.course.model.frame, self.course.model.frame.game
        return MapKey(frame.places, game.cue, wanted_of(frame), frame.physics, self.noise)

    def frame_of(self, drawn: Drawn) -> CaromFrame | None:
        """The table as it lay when a map was drawn of it; None if more than places has changed since."""
        frame = self.course.model.frame
        if drawn.key._replace(places=frame.places) != self.key:
            return None
        return frame if drawn.key.places == frame.places else frame.replace(places=drawn.key.places)

    def _make(self) -> Callable[[], Position]:
        frame = self.course.model.frame
        return lambda: position_of(frame)

    def drawn(self) -> Drawn | None:
        """The newest map there is; asks for that of the position on the table."""
        if not self.active:
            return None
        self.maker.ask(self.key, self._make(), self.noise)
        return self.maker.latest

    def now(self) -> Drawn | None:
        """The map of the position on the table, drawn here if it has not been; None while none is wanted."""
        return self.maker.answer(self.key, self._make(), self.noise) if self.active else None

    def group(self, row: int) -> Group | None:
        """The group in a row of the list as it is shown, if it is of the position on the table."""
        drawn = self.maker.latest
        if not self.active or drawn is None or drawn.key != self.key:
            return None
        groups = drawn.map.groups[:ROWS]
        return groups[row] if 0 <= row < len(groups) else None

    def click(self, row: int) -> None:
        """A row of the list is clicked: its stroke is shown, and at the second click played."""
        group = self.group(row)
        if group is not None:
            name = "play" if self.course.chosen == group.stroke else "show"
            self._clicked = (self.key, name, group.stroke)

    def decisions(self, at_once: bool) -> list[Decision]:
        """What was clicked since the last call. at_once: the map is drawn before anything is decided."""
        if at_once:
            self.now()
        clicked, self._clicked = self._clicked, None
        if clicked is None or not self.active or clicked[0] != self.key:
            return []
        return [Decision(clicked[1], tuple(clicked[2]))]

    def study(self) -> Studied | None:
        """What is known of the chosen stroke; None without one."""
        stroke, drawn = self.course.chosen, self.maker.latest
        if stroke is None or drawn is None or drawn.key != self.key:
            return None
        if self._studied is None or self._studied[0] != (drawn.key, stroke):
            studied = Studied(stroke, tolerance_of(drawn.position, stroke), tip_map(drawn.position, stroke))
            self._studied = ((drawn.key, stroke), studied)
        return self._studied[1]
