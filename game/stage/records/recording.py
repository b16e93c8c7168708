"""A recording: how a scene began, and every event with the step it acted before. That is all a replay needs.

Kept as JSON. The level is embedded whole, so a recording does not depend on files. Digests on the way and at
the end tell whether a replay went the same way.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Literal, TypeVar

import msgspec

from game import __version__
from game.files import FileProblem, read_text, write_text
from game.stage.events import Decision, Pointer, SetParameter, Stamped

MAX_BYTES = 256 << 20
MAX_EVENTS = 1_000_000
MAX_STEPS = 10**9
CHECK_INTERVAL = 120  # steps between digests

Struct = TypeVar("Struct", bound=msgspec.Struct)


class RecordingError(ValueError):
    """A recording that cannot be read, written or replayed: file, field and reason, in one line."""

    def __init__(self, file: Path | str | None, field: str, reason: str):
        self.file = str(file) if file else "recording"
        self.field = field
        self.reason = reason
        line = ": ".join(part for part in (self.file, field, reason) if part)
        super().__init__("".join(letter if letter.isprintable() else " " for letter in line)[:500])


class Check(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Digest of the state on arriving at a step, before the events of that step."""

    step: int
    digest: str


class Recording(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A session of a scene from its beginning, as it is kept in a file."""

    format: Literal[1] = 1
    version: Annotated[str, msgspec.Meta(max_length=40)] = __version__  # of Carom
    scene: Annotated[str, msgspec.Meta(max_length=40)]
    level: Annotated[str, msgspec.Meta(max_length=1 << 20)] | None = None  # text of the level's file
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**63 - 1)]
    dt: Annotated[float, msgspec.Meta(gt=0.0)]  # s
    parameters: Annotated[dict[str, float | bool | str], msgspec.Meta(max_length=1000)]
    effects_off: Annotated[list[str], msgspec.Meta(max_length=63)]
    events: Annotated[list[Stamped], msgspec.Meta(max_length=MAX_EVENTS)]
    checks: Annotated[list[Check], msgspec.Meta(max_length=MAX_STEPS // CHECK_INTERVAL)] = []
    steps: Annotated[int, msgspec.Meta(ge=0, le=MAX_STEPS)]
    digest: str  # after the last step and its events

    def save(self, path: Path | str) -> None:
        """Write the file, whole or not at all; RecordingError."""
        try:
            write_text(Path(path), msgspec.json.encode(self).decode("utf-8") + "\n")
        except FileProblem as problem:
            raise RecordingError(path, "", f"not written: {problem}") from None

    @classmethod
    def load(cls, path: Path | str) -> Recording:
        """The recording in a file; RecordingError if there is none or anything in it is not as it must be."""
        path = Path(path)
        try:
            text = read_text(path, MAX_BYTES)
        except FileProblem as problem:
            raise RecordingError(path, "", str(problem)) from None
        return cls.read(text, path)

    @classmethod
    def read(cls, text: str | bytes, path: Path | str) -> Recording:
        """The recording that a JSON text says; ``path`` is only named in a RecordingError."""
        recording = decoded(text, cls, path)
        recording._check(path)
        return recording

    def _check(self, path: Path | str) -> None:
        """Refuse what the types allow and no session can hold."""
        last = 0
        for index, stamped in enumerate(self.events):
            if not last <= stamped.step <= self.steps:
                raise RecordingError(path, f"events[{index}].step", f"{stamped.step} is out of order")
            last = stamped.step
            event = stamped.event
            numbers: tuple[float, ...] = ()
            if isinstance(event, Pointer):
                numbers = (event.x, event.y, event.wheel)
            elif isinstance(event, Decision):
                numbers = event.values
            elif isinstance(event, SetParameter) and isinstance(event.value, float):
                numbers = (event.value,)
            if not all(map(math.isfinite, numbers)):
                raise RecordingError(path, f"events[{index}]", "expected a finite number")
        if not math.isfinite(self.dt):
            raise RecordingError(path, "dt", "expected a finite number")


def decoded(text: str | bytes, kind: type[Struct], path: Path | str) -> Struct:
    """What a JSON text says, as a struct of that type; ``path`` is only named in a RecordingError."""
    try:
        return msgspec.json.decode(text, type=kind)
    except msgspec.ValidationError as error:
        reason, _, where = str(error).partition(" - at `$")
        raise RecordingError(path, where.strip("`.") or "content", reason.replace("`", "")) from None
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise RecordingError(path, "", f"not JSON: {error}") from None
