"""Which tracks there are, which shot is compared, and what time it is on its clock."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np

from game.arrays import Floats
from game.billiards.fitting.fitting import FittedStroke
from game.billiards.fitting.made import make_tracks
from game.billiards.fitting.tables import START_OF_CAROM, FittedTable
from game.billiards.fitting.tracks import MAX_BALLS, TableSize, TrackedShot, TrackFile, load_tracks
from game.folders import user_folder
from game.scenes.real_table.comparison import Comparison
from game.scenes.real_table.level import MadeTracks, RealTableContent
from game.scenes.real_table.parameters import CUSHIONS, RealTableParameters
from game.stage import Part

PAUSE_S = 1.5  # between the end of a shot and its beginning again


@lru_cache(maxsize=8)
def made_tracks(made: MadeTracks) -> TrackFile:
    """Tracks that the program makes; the same for the same numbers."""
    table = FittedTable(TableSize(), START_OF_CAROM)
    shots = make_tracks(table, made.shots, made.seed, 0.001 * made.noise_mm)
    return TrackFile(table.size, tuple(one.tracked for one in shots))


@lru_cache(maxsize=8)
def _loaded(path: str, _changed: int) -> TrackFile:
    return load_tracks(path)


def tracks_folder() -> Path:
    """Where track files of one's own lie."""
    return user_folder() / "tracks"


def own_files() -> list[Path]:
    """Track files of one's own, by name; none if there is no folder."""
    folder = tracks_folder()
    return sorted(folder.glob("*.json")) if folder.is_dir() else []


class RealTableModel(Part):
    """The shot that is compared. time: s on the track's clock. source: the track file, empty for made ones.

    compared is kept for the same numbers only, and is no part of what is remembered.
    """

    def __init__(self, content: RealTableContent, parameters: RealTableParameters) -> None:
        self.content = content
        self.parameters = parameters
        self.source = ""
        self.further = 0  # shots beyond the one that the parameter names
        self.time = 0.0
        self._shelf = _Shelf()

    @property
    def tracks(self) -> TrackFile:
        """All shots there are."""
        if self.source:
            return _loaded(self.source, Path(self.source).stat().st_mtime_ns)
        return made_tracks(self.content.made)

    @property
    def shot(self) -> TrackedShot:
        """The one that is shown."""
        shots = self.tracks.shots
        first = min(int(self.parameters.shot), len(shots)) - 1
        return shots[(first + self.further) % len(shots)]

    @property
    def size(self) -> TableSize:
        """The table's."""
        return self.tracks.table

    @property
    def compared(self) -> Comparison:
        """The shot under all models, on the table as its numbers are now."""
        size = self.size
        tables = {name: self.parameters.table(size, name) for name in CUSHIONS}
        base = FittedTable(size, START_OF_CAROM)
        return self._shelf.get(self.shot, tables, base, self.parameters.stepped_step)

    @property
    def computed(self) -> tuple[Floats, Floats]:
        """The stroke (5,) on Han's table, and where its balls are now: places (16, 2) m, 0 for none."""
        places = np.zeros((MAX_BALLS, 2))
        played = self.compared.models.get("han")
        if played is None:
            return np.zeros(len(FittedStroke._fields)), places
        places[: len(self.shot.tracks)] = played.places(np.array([self.time]))[0]
        return np.array(played.stroke), places

    def open_next(self) -> None:
        """The next track file of one's own, or the made ones after the last. TrackError if it is wrong."""
        names = ["", *(str(path) for path in own_files())]
        at = names.index(self.source) if self.source in names else 0
        name = names[(at + 1) % len(names)]
        if name:
            _loaded(name, Path(name).stat().st_mtime_ns)
        self.source = name
        self.time = 0.0

    def next_shot(self) -> None:
        """Go on to the next shot, after the last to the first."""
        self.further += 1
        self.time = 0.0

    def advance(self, dt: float) -> None:
        """Time goes on, and begins again some time after the shot's end."""
        self.time += dt
        if self.time > self.shot.end_time + PAUSE_S:
            self.time = 0.0


class _Shelf:
    """The latest comparison."""

    def __init__(self) -> None:
        self._key: object = None
        self._kept: Comparison | None = None

    def get(
        self, shot: TrackedShot, tables: dict[str, FittedTable], base: FittedTable, dt: float
    ) -> Comparison:
        """The comparison of a shot on tables, computed if it is not the latest."""
        key = (*tables.values(), base, dt)
        if self._kept is None or self._kept.shot is not shot or key != self._key:
            self._key, self._kept = key, Comparison(shot, tables, base, dt)
        return self._kept
