"""The challenge of the day: its level, the best stroke of each day as a text, and how others' compare.

The level lies in the user's folder as challenges/DAY.toml. challenges.json, format 1, holds for each day how
near one's best stroke came, m, and the text by which others can play it again.
"""

from __future__ import annotations

import contextlib
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import msgspec

from game.files import FileProblem, read_text, write_text
from game.folders import user_folder
from game.levels import Level, save_level

if TYPE_CHECKING:
    from game.stage import Stage
    from game.stage.records.scored import Scored

FOLDER, FILE_NAME, FORMAT = "challenges", "challenges.json", 1
LARGEST_BYTES = 8 << 20
Day = Annotated[str, msgspec.Meta(pattern=r"^\d{4}-\d\d-\d\d$")]


class Best(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One's best stroke of a day: m from the place, and its text."""

    distance: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)]
    text: Annotated[str, msgspec.Meta(max_length=8000)]


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    format: Annotated[int, msgspec.Meta(ge=FORMAT, le=FORMAT)]
    days: dict[Day, Best]


class Compared(NamedTuple):
    """What a stroke at the challenge is answered with: two sentences; complaint: of the file."""

    cause: str = ""
    consequence: str = ""
    complaint: str = ""


def today() -> str:
    """The date of the machine's clock."""
    return date.today().isoformat()


def write_challenge(day: str) -> Path:
    """The level of a day's challenge, written if it is not there yet.

    ValueError for no date, or a file that cannot be written.
    """
    from game.billiards.players.daily import challenge_of
    from game.scenes.billiards.level import BilliardsContent, PlacedBall

    path = user_folder() / FOLDER / f"{day}.toml"
    if path.exists():
        return path
    found = challenge_of(day)
    content = BilliardsContent(
        game="drill", balls=[PlacedBall(number=ball, position=(x, y)) for ball, x, y in found.balls],
        goal=found.goals[0], more=list(found.goals[1:]),
    )  # fmt: skip
    about = f"The same for all on that day. Par: {words_of(found.par)} from the middle of the rings."
    level = Level(
        scene="billiards", title=f"Challenge of {day}", about=about, parameters={"guide": "first"},
        content=content,
    )  # fmt: skip
    path.parent.mkdir(parents=True, exist_ok=True)
    save_level(level, path)
    return path


def day_of(stage: Stage) -> str:
    """The day whose challenge a stage plays; empty if it plays something else."""
    path = stage.level.path if stage.level is not None else None
    return path.stem if path is not None and path.parent == user_folder() / FOLDER else ""


def best_of(day: str) -> Best | None:
    """One's best stroke of a day; None if none is kept, or the file cannot be read."""
    with contextlib.suppress(ValueError, FileProblem):
        return _read().get(day)
    return None


def _read() -> dict[str, Best]:
    path = user_folder() / FILE_NAME
    if not path.exists():
        return {}
    try:
        return msgspec.json.decode(read_text(path, LARGEST_BYTES), type=_File).days
    except msgspec.DecodeError as error:
        raise ValueError(f"{FILE_NAME}: {' '.join(str(error).replace('`', '').split())}") from None


def _keep(day: str, best: Best) -> str:
    """Keep a best stroke; what there is to complain of. A file that cannot be read is not written over."""
    try:
        days = {**_read(), day: best}
        text = msgspec.json.format(msgspec.json.encode(_File(FORMAT, days)), indent=1).decode("utf-8")
        write_text(user_folder() / FILE_NAME, text + "\n")
    except ValueError as error:
        return f"{error}; nothing is written over it"
    except FileProblem as error:
        return f"{FILE_NAME}: {error}"
    return ""


def words_of(distance: float) -> str:
    """A distance for people."""
    return f"{100.0 * distance:.1f} cm"


class ChallengeKeeper:
    """Answers each stroke at the challenge of a day, once."""

    def __init__(self) -> None:
        self._strokes: int | None = None

    def update(self, stage: Stage, guest: bool) -> Compared | None:
        """What the stroke that has just ended is answered with; None if none has. guest: somebody else's."""
        seen = stage.scene.scored if (day := day_of(stage)) else None
        if seen is None:
            return None
        before, self._strokes = self._strokes, seen.strokes
        if before is None or seen.strokes != before + 1:
            return None
        return self._guest(day, seen) if guest else self._own(stage, day, seen)

    def _own(self, stage: Stage, day: str, seen: Scored) -> Compared:
        best = best_of(day)
        if seen.distance is None:
            return Compared("The 1 is to go down, and the cue ball is not.")
        said = f"{words_of(seen.distance)} from the middle; par is {words_of(seen.par)}."
        if best is not None and best.distance <= seen.distance:
            return Compared(said, f"Your best: {words_of(best.distance)}.")
        complaint = _keep(day, Best(seen.distance, stage.scene.given_text()))
        return Compared(said, "Your best of the day. Ctrl+Shift+X copies it for others.", complaint)

    def _guest(self, day: str, seen: Scored) -> Compared:
        best = best_of(day)
        if seen.distance is None:
            return Compared("The other's stroke did not pot the 1.")
        said = f"The other's stroke: {words_of(seen.distance)} from the middle."
        if best is None:
            return Compared(said, f"Par is {words_of(seen.par)}.")
        verdict = "you are nearer" if best.distance < seen.distance else "the other is nearer"
        if abs(best.distance - seen.distance) < 5e-4:
            verdict = "equally near"
        return Compared(said, f"Yours: {words_of(best.distance)}; {verdict}.")
