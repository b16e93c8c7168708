"""Lets the result of a career's match come back: watches what is played, and keeps how it ended."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import TYPE_CHECKING, NamedTuple

from game.app.stagehand.career_file import keep_career, load_career
from game.app.stagehand.stroke_file import keep_stroke
from game.billiards.career.career import Hand, Match, Player, Result, rating_of
from game.billiards.career.matches import with_result
from game.billiards.career.prizes import PRIZES, unlocked_of
from game.billiards.career.strokes import StrokeFact
from game.billiards.players.ladder import BY_NAME

if TYPE_CHECKING:
    from game.stage import Stage
    from game.stage.records.contested import Contested


class News(NamedTuple):
    """What a result brought: a cause and a consequence for a message; complaint: of the file."""

    cause: str = ""
    consequence: str = ""
    complaint: str = ""


class CareerKeeper:
    """Keeps a result once, at the step at which the match ends."""

    def __init__(self, now: Callable[[], datetime] = datetime.now) -> None:
        self._now = now
        self._over = False
        self._highest = 0
        self._strokes: int | None = None
        self._complaint = ""

    def update(self, stage: Stage) -> News:
        """Keep what has ended, if it was the match that the career waits for."""
        seen = stage.scene.contest
        if seen is None:
            return News()
        self._highest = max(self._highest, seen.highest)
        if self._strokes is not None and seen.strokes == self._strokes + 1:
            self._complaint = self._count(stage, seen) or self._complaint
        self._strokes = seen.strokes
        if self._complaint:
            complaint, self._complaint = self._complaint, ""
            return News(complaint=complaint)
        if not seen.over:
            self._over = False
            return News()
        if self._over:
            return News()
        self._over = True
        return self._keep(seen)

    def _count(self, stage: Stage, seen: Contested) -> str:
        """Keep what was measured of the stroke that has just ended, if the person played it."""
        found = stage.scene.stroke_measured()
        if found is None:
            return ""
        fact = StrokeFact(
            self._now().isoformat(timespec="seconds"), seen.game, seen.opponent, found.kind,
            found.distance, found.cut, found.made, found.chance, found.stray, found.speed, found.cushions,
        )  # fmt: skip
        return keep_stroke(seen.person, fact)

    def _keep(self, seen: Contested) -> News:
        career, complaint = load_career()
        player = career.player
        if player is None or player.pending is None or not _is(seen, player, player.pending):
            return News(complaint=complaint)
        result = Result(
            player.pending, self._now().isoformat(timespec="seconds"), seen.won[0], seen.won[1],
            seen.victory, self._highest,
        )  # fmt: skip
        self._highest = 0
        after = with_result(player, result)
        if seen.hand is not None:
            after = after.replace(hand=Hand(*seen.hand))
        complaint = keep_career(career.with_player(after)) or complaint
        cause, consequence = told(player, after, result)
        return News(cause, " ".join((consequence, *_won(player, after))).strip(), complaint)


def _is(seen: Contested, player: Player, match: Match) -> bool:
    """Whether the match that has ended is the one that was agreed upon."""
    return (seen.game, seen.person, seen.opponent, seen.head_start) == (
        match.game, player.name, match.opponent, match.head_start,
    )  # fmt: skip


def _won(before: Player, after: Player) -> list[str]:
    """A sentence for each prize that is new."""
    known = unlocked_of(before)
    return [f"Unlocked: {one.title.lower()}." for one in PRIZES if one.name in after.unlocked and
            one.name not in known]  # fmt: skip


def told(before: Player, after: Player, result: Result) -> tuple[str, str]:
    """What a result brought, in two sentences."""
    other = (
        BY_NAME[result.match.opponent].title if result.match.opponent in BY_NAME else result.match.opponent
    )
    verb = "beaten" if result.victory else "lost to"
    cause = f"You have {verb} {other}, {result.won} : {result.lost}."
    if len(after.cups) > len(before.cups):
        reached = after.cups[-1].reached
        return cause, "The cup is yours!" if reached == 3 else "The tournament is over for you."
    if result.match.cup:
        assert after.cup is not None
        return cause, f"On to the next: {after.cup.knockout.round_name.lower()}."
    rating = rating_of(after)
    return cause, f"Your rating: {rating.points:.0f} ± {rating.error:.0f}." if rating else ""
