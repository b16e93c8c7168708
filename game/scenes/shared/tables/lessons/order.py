"""The first ten minutes at a table: five lessons with rings, alike at all tables, and which follows which."""

from __future__ import annotations

LESSON = "lesson-"  # how names of their levels begin
NEXT = {
    "lesson-1-stop": "lesson-2-follow",
    "lesson-2-follow": "lesson-3-draw",
    "lesson-3-draw": "lesson-4-side",
    "lesson-4-side": "lesson-5-speed",
}
LAST = "default"  # a game, after the last of them


def level_after(stem: str) -> str:
    """The level that follows a lesson, each by the name of its file; empty after what is no lesson."""
    return NEXT.get(stem, LAST) if stem.startswith(LESSON) else ""
