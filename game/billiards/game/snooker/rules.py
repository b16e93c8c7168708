"""Snooker and six-red snooker: points, fouls and what follows from them, choices, frames and matches.

Rules are the WPBSA's Official Rules of the Games of Snooker and Billiards (2019 edition); numbers such as
3.12 are theirs: section, rule, paragraph. Their order was checked against published copies and
translations, the wording is from memory. Not judged: what needs an eye or a body (feet, clothes, touched
balls), and a jump shot (2.20), which no ball here can make.
"""

from __future__ import annotations

import random

import msgspec

from game.billiards.game.rules import CUE_BALL, Call, Foul, Hand, Option, ShotSummary, Verdict
from game.billiards.game.snooker.misses import MOST_FULL, MOST_SIX_RED, MissRule, is_miss
from game.billiards.game.snooker.sight import (
    Places,
    full_path,
    snookered,
    snookering_balls,
)
from game.billiards.game.snooker.standing import Before, SnookerStanding, Stage
from game.billiards.game.snooker.stroke import (
    Penalty,
    Seen,
    Target,
    cost,
    penalties,
    scored_points,
)
from game.billiards.table.snooker import (
    BLACK,
    COLOURS,
    PINK,
    name_of,
    respotted,
    value_of,
)

QUIET = 12  # strokes without a point; then a restart can be agreed upon (3.16 leaves it to the referee)

PLAY = Option("play", "Play from here.")
FREE = Option("play", "Play from here, with a free ball.")
AGAIN = Option("again", "Let the other play again.")
REPLAY = Option("replay", "Put the balls back: again.")
ANYWHERE = Option("anywhere", "Play, the cue ball anywhere.")
GO_FIRST = Option("first", "Play first at the black.")
GO_SECOND = Option("second", "Let the other play first.")


class Snooker(SnookerStanding, frozen=True, kw_only=True, tag="snooker"):
    """A frame of snooker before a stroke, and what follows from strokes and choices."""

    # -- a stroke -----------------------------------------------------------------------------------

    def judge(
        self,
        shot: ShotSummary,
        call: Call = Call(),  # noqa: B008  (immutable)
        seen: Seen = Seen(),  # noqa: B008  (immutable)
    ) -> Verdict:
        """What follows from a stroke. seen: what else the referee saw. ValueError if none may be played."""
        self.check_playable()
        if self.stage == "colour" and call.ball is None and shot.first[:1] and shot.first[0] in COLOURS:
            call = call._replace(ball=shot.first[0])  # 2.12: it was plain which one was meant
        target = self.target(call)
        found = penalties(target, shot, seen)
        points, scored = scored_points(target, shot) if not found else (0, ())
        kept = scored if self.stage == "order" and not found else ()
        kept = tuple(ball for ball in kept if ball != target.free)
        spot = tuple(
            ball for ball in (*shot.balls_down, *shot.off_table) if ball in COLOURS and ball not in kept
        )
        gone = {*shot.balls_down, *shot.off_table} - set(spot)
        rest = respotted({ball: (x, y) for ball, x, y in shot.rest}, spot)
        hand: Hand = "in the D" if shot.cue_pocketed or CUE_BALL in shot.off_table else ""
        after = msgspec.structs.replace(
            self, on_table=tuple(ball for ball in self.on_table if ball not in gone), in_hand=hand,
            opening=False, free_ball=False, before=None, quiet=0 if points or found else self.quiet + 1,
        )  # fmt: skip
        if not found and not points:
            found = after._hidden(self, target, rest, seen)
        if found:
            return after._fouled(self, target, found, shot, seen, rest, spot)
        verdict = after._scored(points, scored) if points else after._passed()
        return after._drilled(verdict, bool(points))._replace(spot=verdict.spot or spot)

    def _hidden(self, was: Snooker, target: Target, rest: Places, seen: Seen) -> list[Penalty]:
        """3.12(c)(ii): snookered behind the free ball; six-red rule 3: behind the nominated colour."""
        by = target.free
        if by is None and was.six_red and was.stage == "colour" and target.nominated:
            by = target.first[0]
        if by is None or len(self.players) == 1 or (target.free and set(self.on_table) <= {PINK, BLACK}):
            return []
        following = self._to_play(self.other)
        if by in following.balls_on() or by not in snookering_balls(rest, following.balls_on(), seen.curves):
            return []
        kind = "free ball" if target.free else "nominated colour"
        words = f"The cue ball is snookered behind the {kind}, the {name_of(by)}."
        return [Penalty(Foul("behind the ball", words), target.value)]

    def _scored(self, points: int, scored: tuple[int, ...]) -> Verdict:
        """The striker goes on: after a red a colour, after a colour a red, at last the colours (3.3)."""
        run = self.run + points
        stage: Stage = "colour" if self.stage == "red" else "red" if self.reds_left else "order"
        mine = _with(self.points, self.turn, self.points[self.turn] + points)
        after = msgspec.structs.replace(
            self, run=run, points=mine, stage=stage, misses=0, full_misses=0,
            high=_with(self.high, self.turn, max(run, self.high[self.turn])),
        )  # fmt: skip
        if not after.on_table:
            return after._frame_ends((), scored)
        said = f"{points} for {self.shooter}: a break of {run}."
        return Verdict(after, (), scored, (said, after.on_sentence()))

    def _drilled(self, verdict: Verdict, scored: bool) -> Verdict:
        """A drill's attempt is over: with a miss, with a single stroke, or with the table cleared."""
        after = verdict.game
        if (
            not self.drill
            or not isinstance(after, Snooker)
            or (self.drill == "break" and scored and not after.over)
        ):
            return verdict
        made = verdict.legal and (scored or self.drill == "escape")
        after = msgspec.structs.replace(
            after, winner=0, attempts=self.attempts + 1, made=self.made + made, points=(0,), run=0,
        )  # fmt: skip
        had = self.run + sum(value_of(ball) for ball in verdict.scored)
        lead = f"A break of {had}." if self.drill == "break" else "Made." if made else "Not made."
        words = (lead, *(foul.words for foul in verdict.fouls))
        return verdict._replace(game=after, words=words)

    def _passed(self) -> Verdict:
        """No point and no foul: the other plays."""
        after = self._to_play(self.other)
        after = msgspec.structs.replace(after, misses=0, full_misses=0)
        return Verdict(after, (), (), (f"{after.shooter} plays.", after.on_sentence()))

    def _to_play(self, player: int) -> Snooker:
        """A player coming to the table: reds are on while there are any (3.3(d))."""
        stage: Stage = "red" if self.reds_left else "order"
        return msgspec.structs.replace(self, turn=player, stage=stage, run=0)

    def _fouled(
        self, was: Snooker, target: Target, found: list[Penalty], shot: ShotSummary, seen: Seen, rest: Places,
        spot: tuple[int, ...],
    ) -> Verdict:  # fmt: skip
        """Points for the other, who then chooses (3.11, 3.12, 3.14)."""
        points, fouls = cost(found), tuple(one.foul for one in found)
        why = tuple(foul.words for foul in fouls)
        if len(self.players) == 1:
            after = self._to_play(0)
            said = (f"Foul: {points} away. Play on.", *why)
            return self._drilled(Verdict(after, fouls, (), said, spot), False)
        gains = _with(self.points, self.other, self.points[self.other] + points)
        after = msgspec.structs.replace(self._to_play(self.other), points=gains)
        if was.stage == "order" and was.on_table == (BLACK,):
            ended = after._frame_ends(fouls, (), (f"Foul: {points} to {after.shooter}.", *why))
            return ended._replace(spot=ended.spot or spot)
        open_to_all = full_path(seen.places, was.legal_first())  # also of what could have been on
        missed = is_miss(
            was.miss_rule, target, shot, seen, was.excused or after.excused,
            was.full_misses > 0 and open_to_all,
        )  # fmt: skip
        full = missed and open_to_all
        after = msgspec.structs.replace(
            after, misses=was.misses + 1 if missed else 0, full_misses=was.full_misses + 1 if full else 0,
            before=Before(was.stage, was.free_ball, was.on_table, was.in_hand) if missed else None,
            free_ball=snookered(rest, after.balls_on(), seen.curves),
        )  # fmt: skip
        if full and after.full_misses >= MOST_FULL:
            return after._awarded(fouls, (*why, "A third miss, with a full ball to be hit."), spot)
        after = msgspec.structs.replace(after, options=after._options(missed))
        lead = f"Foul{' and a miss' * missed}: {points} to {after.shooter}."
        words = (lead, *after._warnings(), *why, f"{after.shooter} chooses.")
        return Verdict(after, fouls, (), words, spot)

    def _options(self, missed: bool) -> tuple[Option, ...]:
        """What the player who comes to the table after a foul may choose (3.12, 3.13, 3.14(a))."""
        options = [FREE if self.free_ball else PLAY, AGAIN]
        if missed and self.six_red and self.misses >= MOST_SIX_RED:
            return (*options, ANYWHERE)  # where snookers are needed no miss is called, and so none counts
        return (*options, REPLAY) if missed else tuple(options)

    def _warnings(self) -> tuple[str, ...]:
        """What must be said with a foul: free ball, and what another miss would bring."""
        said = []
        if self.free_ball:
            said.append("Snookered: a free ball.")
        if self.full_misses == MOST_FULL - 1:
            said.append("Warning: a third miss from here loses the frame.")
        if self.six_red and self.misses == MOST_SIX_RED - 1:
            said.append("Warning: with a fifth miss the cue ball may be put anywhere.")
        return tuple(said)

    # -- choices ------------------------------------------------------------------------------------

    def choose(self, name: str) -> Verdict:
        """What follows from the player at turn choosing. `reset`: the balls go back to before the miss."""
        self.check_option(name)
        chosen = msgspec.structs.replace(self, options=(), before=None)
        if name == REPLAY.name and self.before is not None:
            then = self.before
            chosen = msgspec.structs.replace(
                chosen, turn=self.other, stage=then.stage, free_ball=then.free_ball, on_table=then.on_table,
                in_hand=then.in_hand,
            )  # fmt: skip
            return Verdict(
                chosen, words=(f"{chosen.shooter} plays again from where the balls lay.",), reset=True
            )
        chosen = msgspec.structs.replace(chosen, misses=0, full_misses=0)
        if name in (AGAIN.name, GO_SECOND.name):
            chosen = msgspec.structs.replace(chosen, turn=self.other, free_ball=False)
        if name == ANYWHERE.name:
            chosen = msgspec.structs.replace(chosen, in_hand="anywhere", free_ball=False)
        return Verdict(chosen, words=(f"{chosen.shooter} plays.", chosen.on_sentence()))

    def on_sentence(self) -> str:
        """What is on, as a sentence."""
        if self.over:
            return ""
        if self.free_ball:
            return "A free ball: nominate any ball."
        if self.stage == "red":
            return "A red is on."
        return (
            "A colour is on: nominate it."
            if self.stage == "colour"
            else f"The {name_of(self.balls_on()[0])} is on."
        )

    # -- how frames end -----------------------------------------------------------------------------

    def _frame_ends(
        self, fouls: tuple[Foul, ...], scored: tuple[int, ...], words: tuple[str, ...] = ()
    ) -> Verdict:
        """The black is decided (3.4): the most points win; if level, the black is put back and lots are
        drawn.
        """
        if len(self.players) == 1:
            after = msgspec.structs.replace(self, winner=0, won=(self.won[0] + 1,))
            return Verdict(after, fouls, scored, (f"The table is cleared: {self.points[0]} points.", *words))
        mine, others = self.points
        if mine != others:
            winner = 0 if mine > others else 1
            return Verdict(self._won_by(winner), fouls, scored, (self._result(winner), *words))
        draw = random.Random(f"{self.lot} {self.won} {self.points}").randrange(2)
        after = msgspec.structs.replace(
            self, on_table=(BLACK,), in_hand="in the D", stage="order", black_again=True, run=0, turn=draw,
            options=(GO_FIRST, GO_SECOND), free_ball=False,
        )  # fmt: skip
        lead = f"Level at {mine}: the black goes back on its spot."
        return Verdict(
            after, fouls, scored, (lead, f"{after.shooter} wins the draw and chooses.", *words), (BLACK,)
        )

    def _won_by(self, winner: int) -> Snooker:
        won = _with(self.won, winner, self.won[winner] + 1)
        return msgspec.structs.replace(self, winner=winner, won=won, options=(), free_ball=False)

    def _result(self, winner: int) -> str:
        score = f"{self.points[winner]} to {self.points[1 - winner]}"
        return f"{self.players[winner]} wins the frame, {score}."

    def _awarded(self, fouls: tuple[Foul, ...], why: tuple[str, ...], spot: tuple[int, ...]) -> Verdict:
        """3.14(c)(ii): the frame goes to the player at turn."""
        after = self._won_by(self.turn)
        return Verdict(after, fouls, (), (f"The frame is awarded to {self.shooter}.", *why), spot)

    @property
    def may_claim(self) -> bool:
        """2.1(b): only the black is left and the striker leads by more than seven."""
        ahead = self.points[self.turn] - self.points[1 - self.turn] if len(self.points) == 2 else 0
        return not self.over and self.on_table == (BLACK,) and ahead > value_of(BLACK)

    def claim(self) -> Verdict:
        """The striker claims the frame (2.1(b)). ValueError if that is not allowed."""
        if not self.may_claim:
            raise ValueError("game: a frame is claimed when only the black is left, by more than 7 points")
        return Verdict(self._won_by(self.turn), words=(self._result(self.turn), f"{self.shooter} claims it."))

    def concede(self) -> Verdict:
        """The player at turn concedes (2.1(a)). ValueError if the frame is over, or there is no other."""
        if self.over or len(self.players) == 1:
            raise ValueError("game: there is nothing to concede")
        after = self._won_by(self.other)
        return Verdict(
            after, words=(f"{self.players[self.other]} wins the frame.", f"{self.shooter} concedes.")
        )

    @property
    def may_restart(self) -> bool:
        """True if no player has scored for so long that a stalemate may be agreed upon (3.16)."""
        return not self.over and not self.options and self.quiet >= QUIET

    def restart(self) -> Verdict:
        """3.16: a stalemate; the frame begins again, the same player breaks. ValueError if it may not."""
        if not self.may_restart:
            raise ValueError(f"game: a restart takes {QUIET} strokes without a point")
        return self._fresh(self.breaker, ("The frame begins again.",))

    def next_rack(self) -> Verdict:
        """The next frame; the players break in turns (3.3(b)). After a match the next one."""
        breaker = (self.breaker + 1) % len(self.players)
        won = (0,) * len(self.players) if self.match_over else self.won
        return msgspec.structs.replace(self, won=won)._fresh(breaker, ())

    def _fresh(self, breaker: int, words: tuple[str, ...]) -> Verdict:
        """A frame of the same match at its beginning."""
        zeros = (0,) * len(self.players)
        after = Snooker(
            players=self.players, turn=breaker, breaker=breaker, won=self.won, reds=self.reds,
            best_of=self.best_of, miss_rule=self.miss_rule, points=zeros, high=self.high,
            fouls_in_row=zeros, on_table=(*range(1, self.reds + 1), *COLOURS), lot=self.lot,
        )  # fmt: skip
        return Verdict(after, words=(*words, f"{after.shooter} breaks off."), rack=True)


def _with(values: tuple[int, ...], place: int, value: int) -> tuple[int, ...]:
    """The same with one changed."""
    return tuple(value if k == place else old for k, old in enumerate(values))


def new_snooker(
    players: tuple[str, ...] = ("Ada", "Ben"), reds: int = 15, best_of: int = 1,
    miss_rule: MissRule = "professional", lot: int = 0,
) -> Snooker:  # fmt: skip
    """A match at its beginning; one player practises. ValueError for reds that no triangle has."""
    if reds not in (15, 10, 6):
        raise ValueError(f"reds: expected 15, 10 or 6, got {reds!r}")
    zeros = (0,) * len(players)
    return Snooker(
        players=players, reds=reds, best_of=best_of, miss_rule=miss_rule, points=zeros, high=zeros, won=zeros,
        fouls_in_row=zeros, on_table=(*range(1, reds + 1), *COLOURS), lot=lot,
    )  # fmt: skip
