"""Which faults are sown: drawn at random over all floors by their shares."""

from __future__ import annotations

import random
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from tests.mutation.operators import Fault, find_faults

SHARES = {
    "physics": 90,
    "billiards": 60,
    "levels": 15,
    "lab": 30,
    "stage": 40,
    "ui": 15,
    "worlds": 10,
    "scenes": 35,
    "app": 15,
}
PICTURES = (
    "figure.py",
    "card.py",
    "view.py",
    "view/",
    "painters/",
    "look/",
)  # lengths and shades that only the eye judges


class Sown(NamedTuple):
    """A fault and the file it is sown into, relative to the checkout."""

    path: str
    fault: Fault
    text: str
    """The line it stands in."""

    @property
    def key(self) -> str:
        """What names the fault in logs: it survives changes elsewhere in the file."""
        old, new = " ".join(self.fault.old.split()), " ".join(self.fault.new.split())
        return f"{self.path}: {self.text} | {old} -> {new}"

    @property
    def module(self) -> str:
        """Name of the module the fault is sown into."""
        return ".".join(Path(self.path).with_suffix("").parts).removesuffix(".__init__")


def faults_of(path: str, root: Path) -> list[Sown]:
    """All faults that can be sown into a file, in the order of its text."""
    source = (root / path).read_text()
    lines = source.splitlines()
    return [Sown(path, fault, lines[fault.line - 1].strip()) for fault in find_faults(source)]


def find(key: str, line: int, root: Path) -> Sown | None:
    """The fault that a log names so, nearest to a line where there are several; None if it is gone."""
    path = key.split(": ")[0]
    alike = [sown for sown in faults_of(path, root) if sown.key == key] if (root / path).exists() else []
    return min(alike, key=lambda sown: abs(sown.fault.line - line), default=None)


def choose(seed: int, count: int, root: Path, floors: Sequence[str] = tuple(SHARES)) -> list[Sown]:
    """Faults drawn at random over some floors by their shares, each kind as often as another."""
    generator = random.Random(seed)
    chosen: dict[str, Sown] = {}
    shares = {floor: share for floor, share in SHARES.items() if floor in floors}
    for floor, share in shares.items():
        kinds: dict[str, list[Sown]] = {}
        for path in sorted((root / "game").rglob("*.py")):
            name = path.relative_to(root / "game").as_posix()
            if name.split("/")[0].removesuffix(".py") == floor and not any(part in name for part in PICTURES):
                for sown in faults_of(f"game/{name}", root):
                    kinds.setdefault(sown.fault.kind, []).append(sown)
        wanted = len(chosen) + round(count * share / sum(shares.values()))
        while len(chosen) < wanted and any(kinds.values()):
            several = generator.choice([each for each in kinds.values() if each])
            sown = several.pop(generator.randrange(len(several)))
            chosen[sown.key] = sown
    drawn = list(chosen.values())
    generator.shuffle(drawn)
    return drawn
