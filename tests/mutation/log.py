"""The log of judged faults: a line each, the last one of a fault counts."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

from tests.mutation.drawing import Sown, find

EQUIVALENT = Path(__file__).with_name("equivalent.toml")

AT_IMPORT = "runs at import"  # what is said of a fault that no fork can be given


class Log:
    """What came of each fault."""

    def __init__(self, path: Path) -> None:
        """Read what the file holds, if there is one."""
        self.path = path
        lines = path.read_text().splitlines() if path.exists() else []
        self.rows: dict[str, dict[str, Any]] = {row["key"]: row for row in map(json.loads, lines)}
        entries = tomllib.loads(EQUIVALENT.read_text()).get("fault", [])
        self.equivalent: dict[str, str] = {entry["key"]: entry["why"] for entry in entries}

    def is_open(self, key: str, again: bool) -> bool:
        """Whether a fault is to be judged: it never was, or it was missed and is to be judged again."""
        row = self.rows.get(key)
        return row is None or (again and not row["noticed"] and key not in self.equivalent)

    def add(self, sown: Sown, noticed: bool, by: str, stage: str, seconds: float) -> None:
        """Write down what came of a fault in a round."""
        row = {
            "key": sown.key,
            "line": sown.fault.line,
            "noticed": noticed,
            "by": by,
            "round": stage,
            "s": round(seconds, 1),
        }
        self.rows[sown.key] = row
        with self.path.open("a") as file:
            file.write(json.dumps(row) + "\n")
        print(
            "noticed " if noticed else "MISSED  ",
            f"{sown.path}:{sown.fault.line}",
            sown.fault.kind,
            flush=True,
        )

    def report(self, root: Path) -> str:
        """How many faults were noticed, and each that was not and can still be sown below `root`."""
        rows = [row for row in self.rows.values() if row["noticed"] or find(row["key"], row["line"], root)]
        missed = [row for row in rows if not row["noticed"]]
        left = [row for row in missed if row["key"] not in self.equivalent]
        counted = len(rows) - (len(missed) - len(left))
        share = 100.0 * (counted - len(left)) / max(counted, 1)
        head = (
            f"{len(rows)} judged, {len(missed) - len(left)} equivalent, "
            f"{counted - len(left)} of {counted} noticed ({share:.1f} %)"
        )
        return "\n".join([head, *(f"MISSED line {row['line']} {row['key']}" for row in left)])
