"""Track files: where the balls of filmed shots were, and when. JSON, SI units.

    format "tracks", version 1, what, note (texts)  all optional
    table.width, .length, .ball_diameter            optional as a whole: a match table for carom
    shots[].id                                      a text or a whole number, each once
    shots[].balls                                   by number, "0" to "15"; ball 0 is the one struck
    shots[].balls.N.t, .x, .y                       as many numbers each: time (s), place of the centre (m)

x runs along the table's width, y along its length, from a corner between the noses of the cushions. Times
begin at or after 0 and never fall. What else stands in a file is refused, and so is what no table can hold.
The complaint names file, field and reason in one line.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Any, NamedTuple, NoReturn

import msgspec
import numpy as np

from game.arrays import Floats
from game.files import FileProblem, read_text

MAX_BYTES = 64 * 2**20
MAX_SHOTS = 2000
MAX_BALLS = 16
MAX_SAMPLES = 20_000  # of one ball
MAX_SECONDS = 600.0
OUTSIDE = 0.02  # m; by how much a tracked centre may be outside of where a ball fits
BALL_NAMES = tuple(str(k) for k in range(MAX_BALLS))
STRUCK = "0"

Name = Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
Text = Annotated[str, msgspec.Meta(max_length=4000)]


class TrackError(ValueError):
    """A track file that cannot be read; the message is one line."""


class TableSize(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table without pockets, and its balls, m. The width and length are between the cushions' noses."""

    width: Annotated[float, msgspec.Meta(ge=0.2, le=10.0)] = 1.42
    length: Annotated[float, msgspec.Meta(ge=0.2, le=10.0)] = 2.84
    ball_diameter: Annotated[float, msgspec.Meta(ge=0.01, le=0.15)] = 0.0615


class Track(NamedTuple):
    """Where one ball was: times (m,) s, never falling; places (m, 2) m in the table's frame."""

    times: Floats
    places: Floats


class TrackedShot(NamedTuple):
    """One shot: its name, and the track of each ball; the first is the one struck."""

    id: str
    names: tuple[str, ...]
    tracks: tuple[Track, ...]

    @property
    def end_time(self) -> float:
        """Time of the last sample, s."""
        return max(float(track.times[-1]) for track in self.tracks)


class TrackFile(NamedTuple):
    """All shots of a file, and the table they were played on."""

    table: TableSize
    shots: tuple[TrackedShot, ...]


class _File(msgspec.Struct, forbid_unknown_fields=True):
    shots: Annotated[list[msgspec.Raw], msgspec.Meta(min_length=1, max_length=MAX_SHOTS)]
    format: str = "tracks"
    version: int = 1
    what: Text = ""
    note: Text = ""
    table: TableSize = TableSize()


class _Shot(msgspec.Struct, forbid_unknown_fields=True):
    id: Name | int
    balls: Annotated[dict[str, msgspec.Raw], msgspec.Meta(min_length=1, max_length=MAX_BALLS)]


Numbers = Annotated[list[float], msgspec.Meta(min_length=1, max_length=MAX_SAMPLES)]


class _Ball(msgspec.Struct, forbid_unknown_fields=True):
    t: Numbers
    x: Numbers
    y: Numbers


def load_tracks(path: str | Path) -> TrackFile:
    """Read and check a track file. TrackError names file, field and reason."""
    file = Path(path)
    try:
        return parse_tracks(read_text(file, MAX_BYTES).encode())
    except (FileProblem, TrackError) as problem:
        raise TrackError(" ".join(f"{file}: {problem}".split())) from None


def parse_tracks(text: bytes) -> TrackFile:
    """Tracks from the content of a file. TrackError names field and reason."""
    root = _decoded(text, _File, "")
    if root.format != "tracks":
        raise TrackError(f'format: must be "tracks", got {root.format[:40]!r}')
    if root.version != 1:
        raise TrackError(f"version: only 1 is known, got {root.version}")
    if root.table.ball_diameter > 0.2 * root.table.width:
        raise TrackError("table.ball_diameter: more than a fifth of the table's width")
    shots: list[TrackedShot] = []
    seen: set[str] = set()
    for k, raw in enumerate(root.shots):
        shot = _read_shot(raw, f"shots[{k}]", root.table)
        if shot.id in seen:
            raise TrackError(f"shots[{k}].id: {shot.id!r} is there twice")
        seen.add(shot.id)
        shots.append(shot)
    return TrackFile(root.table, tuple(shots))


def _read_shot(raw: msgspec.Raw, place: str, table: TableSize) -> TrackedShot:
    shot = _decoded(raw, _Shot, place)
    for name in shot.balls:
        if name not in BALL_NAMES:
            raise TrackError(f'{place}.balls: known are "0" to "{MAX_BALLS - 1}", got {name[:40]!r}')
    if STRUCK not in shot.balls:
        raise TrackError(f'{place}.balls: "{STRUCK}" is missing, the ball that is struck')
    names = tuple(sorted(shot.balls, key=int))
    tracks = tuple(_read_track(shot.balls[name], f"{place}.balls.{name}", table) for name in names)
    if len(tracks[0].times) < 3:
        raise TrackError(f"{place}.balls.{STRUCK}.t: a struck ball needs at least 3 samples")
    return TrackedShot(str(shot.id), names, tracks)


def _read_track(raw: msgspec.Raw, place: str, table: TableSize) -> Track:
    ball = _decoded(raw, _Ball, place)
    for axis in ("x", "y"):
        count = len(getattr(ball, axis))
        if count != len(ball.t):
            raise TrackError(f"{place}.{axis}: {count} numbers for {len(ball.t)} times")
    times = np.array(ball.t)
    places = np.column_stack([ball.x, ball.y])
    wrong = np.flatnonzero(~((times >= 0.0) & (times <= MAX_SECONDS)))
    if wrong.size:
        raise TrackError(f"{place}.t[{wrong[0]}]: must be 0 to {MAX_SECONDS:g} s, got {times[wrong[0]]:.6g}")
    falls = np.flatnonzero(np.diff(times) < 0.0)
    if falls.size:
        k = int(falls[0]) + 1
        raise TrackError(f"{place}.t[{k}]: times must not fall, got {times[k]:.6g} after {times[k - 1]:.6g}")
    radius = 0.5 * table.ball_diameter
    for column, extent in enumerate((table.width, table.length)):
        low, high = radius - OUTSIDE, extent - radius + OUTSIDE
        wrong = np.flatnonzero(~((places[:, column] >= low) & (places[:, column] <= high)))
        if wrong.size:
            value = places[wrong[0], column]
            raise TrackError(
                f"{place}.{'xy'[column]}[{wrong[0]}]: the ball is off the table,"
                f" {value:.6g} is not within {low:.4g} to {high:.4g} m"
            )
    times.setflags(write=False)
    places.setflags(write=False)
    return Track(times, places)


def _decoded(text: bytes | msgspec.Raw, kind: Any, place: str) -> Any:
    """``msgspec.json.decode`` with its complaint taken apart into field and reason."""
    try:
        return msgspec.json.decode(text, type=kind)
    except msgspec.ValidationError as error:
        _refuse(str(error), place)
    except msgspec.DecodeError as error:
        reason = str(error).replace("JSON is malformed: ", "")
        raise TrackError(f"{place + ': ' if place else ''}not JSON: {reason}") from None
    except RecursionError:
        raise TrackError(f"{place + ': ' if place else ''}nested too deeply") from None


def _refuse(message: str, place: str) -> NoReturn:
    found = re.search(r" - at `(?:key in )?\$\.?([^`]*)`$", message)
    reason = message[: found.start()] if found else message
    where = ".".join(part for part in (place, found.group(1) if found else "") if part).replace(".[", "[")
    named = re.match(r"Object (contains unknown|missing required) field `(.*)`$", reason)
    if named:
        where = f"{where}.{named.group(2)}" if where else named.group(2)
        reason = "is missing" if named.group(1).startswith("missing") else "unknown field"
    reason = reason[0].lower() + reason[1:].replace("`", "")
    raise TrackError(f"{where[:160]}: {reason}" if where else reason) from None


def write_tracks(table: TableSize, shots: tuple[TrackedShot, ...], what: str = "", note: str = "") -> str:
    """Text of a track file, to the tenth of a millimetre and of a millisecond."""
    content = {
        "format": "tracks",
        "version": 1,
        "what": what,
        "note": note,
        "table": msgspec.to_builtins(table),
        "shots": [
            {
                "id": shot.id,
                "balls": {
                    name: {
                        "t": [round(t, 4) for t in track.times.tolist()],
                        "x": [round(x, 4) for x in track.places[:, 0].tolist()],
                        "y": [round(y, 4) for y in track.places[:, 1].tolist()],
                    }
                    for name, track in zip(shot.names, shot.tracks, strict=True)
                },
            }
            for shot in shots
        ],
    }
    return msgspec.json.encode(content).decode() + "\n"
