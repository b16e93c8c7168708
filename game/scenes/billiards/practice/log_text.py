"""The log of a game as a level keeps it: one packed text, versioned, bounded, checked when it is read.

    1.PACKED

Format 1: PACKED is JSON (see `_Document`) as `game.packed_text` packs it.
"""

from __future__ import annotations

import math
from typing import Annotated, Any

import msgspec
import numpy as np

from game.billiards.game.arrangement import Arrangement, Stroke
from game.billiards.game.frame import Frame, Struck
from game.billiards.game.log import MOST_LOGGED, START, Log, Logged
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.shot.cue import strike
from game.packed_text import pack, unpack
from game.scenes.billiards.level import read_game

FORMAT = 1
MOST_LETTERS = 400_000  # of the text; a level's file has a megabyte
MOST_BYTES = 8 << 20  # of its JSON
Place = tuple[Annotated[int, msgspec.Meta(ge=0, le=15)], float, float]
Words = Annotated[str, msgspec.Meta(max_length=300)]


class _Entry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, omit_defaults=True):
    """A stroke: see `Logged`. game: as msgspec writes it; places: of the balls before it."""

    number: Annotated[int, msgspec.Meta(ge=1, le=10**9)]
    after: Annotated[int, msgspec.Meta(ge=0, le=10**9)]
    rack: Annotated[int, msgspec.Meta(ge=0, le=10**9)]
    game: dict[str, Any]
    places: Annotated[list[Place], msgspec.Meta(max_length=16)]
    stroke: tuple[float, float, float, float, float]
    call: tuple[int | None, int | None, bool, bool] = (None, None, False, False)
    down: Annotated[list[int], msgspec.Meta(max_length=16)] = []
    words: Annotated[list[Words], msgspec.Meta(max_length=20)] = []
    foul: bool = False
    winner: Annotated[str, msgspec.Meta(max_length=40)] = ""


class _Document(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """at: see `Log`."""

    at: Annotated[int, msgspec.Meta(ge=0, le=10**9)]
    strokes: Annotated[list[_Entry], msgspec.Meta(max_length=MOST_LOGGED)]


def text_of_log(log: Log) -> str:
    """The log without what was left; empty if nothing was played. The oldest strokes go where it is too
    long.
    """
    entries = [_entry_of(entry) for entry in log.entries]
    while entries:
        text = f"{FORMAT}.{pack(msgspec.json.encode(_Document(log.at, entries)))}"
        if len(text) <= MOST_LETTERS:
            return text
        del entries[: max(len(entries) // 4, 1)]
    return ""


def _entry_of(entry: Logged) -> _Entry:
    frame, (speed, azimuth, elevation, left, up), (ball, pocket, safety, push_out) = entry.struck
    return _Entry(
        entry.number, entry.after, entry.rack, msgspec.to_builtins(frame.game), list(frame.layout.places),
        (speed, azimuth, elevation, left, up), (ball, pocket, safety, push_out), list(entry.down),
        list(entry.words), entry.foul, entry.winner,
    )  # fmt: skip


def log_in(text: str, like: Frame) -> Log:
    """The log that a text says, on the table, with the balls and the cloth of ``like``. ValueError, in a
    line, for what is damaged, of a later format, or cannot be.
    """
    if not text:
        return Log()
    version, dot, packed = text.partition(".")
    if not dot or not version.isdecimal() or len(version) > 6:
        raise ValueError("log: damaged: it has no format")
    if int(version) != FORMAT:
        raise ValueError(f"log: is of format {int(version)}; this Carom reads format {FORMAT}")
    try:
        document = msgspec.json.decode(unpack(packed, MOST_BYTES), type=_Document)
    except (msgspec.DecodeError, ValueError, RecursionError) as error:
        raise ValueError(f"log: {str(error).replace('`', '')}") from None
    entries = tuple(_logged(entry, like) for entry in document.strokes)
    numbers = [entry.number for entry in entries]
    if numbers != sorted(set(numbers)):
        raise ValueError("log: its strokes are out of order")
    if any(entry.after >= entry.number for entry in entries):
        raise ValueError("log: a stroke comes after itself")
    if document.at != START and document.at not in numbers:
        raise ValueError(f"log: there is no stroke {document.at}")
    return Log(entries, document.at)


def _logged(entry: _Entry, like: Frame) -> Logged:
    """One stroke; ValueError for balls that cannot lie so, or a stroke that none can be."""
    where = f"log: stroke {entry.number}"
    numbers = [number for number, _, _ in entry.places]
    if numbers != sorted(set(numbers)) or CUE_BALL not in numbers:
        raise ValueError(f"{where}: its balls are not those of a stroke")
    positions = np.array([(x, y) for _, x, y in entry.places])
    if not np.isfinite(positions).all() or float(np.abs(positions).max()) > 10.0:
        raise ValueError(f"{where}: a ball lies outside")
    if not all(map(math.isfinite, entry.stroke)):
        raise ValueError(f"{where}: expected finite numbers")
    try:
        game = read_game(entry.game)
        strike(*entry.stroke)
        if {number for number in numbers if number != CUE_BALL} != set(game.on_table):
            raise ValueError("the balls on the table are not those of the game")
        game.check_playable()
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from None
    layout = Arrangement(tuple(numbers), positions, like.layout.balls)
    try:
        layout.shot(like.table, like.physics)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from None
    frame = Frame(game, layout, like.table, like.physics)
    return Logged(
        entry.number, entry.after, entry.rack, Struck(frame, Stroke(*entry.stroke), Call(*entry.call)),
        tuple(entry.down), tuple(entry.words), entry.foul, entry.winner,
    )  # fmt: skip
