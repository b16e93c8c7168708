"""Accounts of the scenes as they are kept: a file for each, and how they are compared."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tests.golden.pictures import other_parts

FOLDER = Path(__file__).with_name("accounts")
SUM = 2e-7  # of the sizes that were added, by which a weighted sum may differ: it is kept to nine digits
NUMBER = 2e-5  # of itself, and
NOTHING = 1e-9  # at least, by which a single number may: it is kept to six digits
BRIGHT = 0.3  # of 255, by which the mean brightness of a part of a picture may
_NUMBER = re.compile(r"-?\d[\d.]*(?:e[-+]?\d+)?(?:/[\d.]+(?:e[-+]?\d+)?)?")


def file_of(name: str) -> Path:
    """Where a scene's accounts are kept."""
    return FOLDER / f"{name}.json"


def read(name: str) -> dict[str, Any]:
    """The accounts that are kept of a scene."""
    kept: dict[str, Any] = json.loads(file_of(name).read_text(encoding="utf-8"))
    return kept


def write(name: str, account: dict[str, Any]) -> None:
    """Keep the accounts of a scene."""
    FOLDER.mkdir(exist_ok=True)
    text = json.dumps(account, indent=1, ensure_ascii=False)
    file_of(name).write_text(text + "\n", encoding="utf-8")


def differences(kept: Any, now: Any, place: str = "") -> Iterator[str]:
    """Where two accounts say something else, a line each."""
    if isinstance(kept, dict) and isinstance(now, dict):
        for key in [*kept, *(key for key in now if key not in kept)]:
            yield from differences(kept.get(key), now.get(key), f"{place} / {key}" if place else key)
    elif isinstance(kept, list) and isinstance(now, list):
        missing = max(len(kept), len(now))
        pairs = zip(
            [*kept, *[None] * (missing - len(kept))], [*now, *[None] * (missing - len(now))], strict=True
        )
        for number, (one, other) in enumerate(pairs):
            yield from differences(one, other, f"{place} {number}")
    elif kept is not None and now is not None and place.endswith("picture"):
        yield from (f"{place}: {part}" for part in other_parts(kept, now))
    elif kept is None or now is None or not same(kept, now, place.endswith("painted")):
        yield f"{place}: kept {kept!r}, now {now!r}"


def same(kept: str, now: str, painted: bool = False) -> bool:
    """Whether two lines say the same: words are equal, numbers as near as rounding leaves them."""
    return kept == now or (
        len(kept.split()) == len(now.split())
        and all(
            one == other or _near(one, other, painted)
            for one, other in zip(kept.split(), now.split(), strict=True)
        )
    )


def _near(one: str, other: str, painted: bool) -> bool:
    if not (_NUMBER.fullmatch(one) and _NUMBER.fullmatch(other)) or ("/" in one) != ("/" in other):
        return False
    a, _, size = one.partition("/")
    b, _, other_size = other.partition("/")
    apart = abs(float(a) - float(b))
    if painted:
        return apart <= BRIGHT
    if size:
        return apart <= SUM * float(size) and abs(float(size) - float(other_size)) <= 1e-3 * float(size)
    if "." not in one + other and "e" not in one + other:
        return False  # counts and check sums are equal or not
    return apart <= max(NOTHING, NUMBER * abs(float(a)))
