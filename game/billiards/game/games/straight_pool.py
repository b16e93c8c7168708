"""Straight pool, 14.1 continuous: each called ball is a point, and fourteen are racked again (WPA 4).

When one ball is left, the other fourteen are racked without the apex, and the player goes on: that last
one is the break ball. Numbers such as 4.8 are paragraphs of the World Pool-Billiard Association's rules of
2016.
"""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.billiards.game.rules import (
    CUE_BALL,
    MOST_FOULS,
    Call,
    Foul,
    Game,
    Hand,
    Option,
    ShotSummary,
    Verdict,
    common_fouls,
    driven_to_cushions,
    rack_won,
    remaining,
)
from game.billiards.table import rack_area as area

ALL_BALLS = tuple(range(1, 16))
TARGET = 50  # points of a game; 150 at championships (4.4 leaves it open)
DRIVEN = 2  # object balls that must reach a cushion at the opening, beside the cue ball (4.3)
FOUL_POINTS, BREAKING_POINTS, SERIOUS_POINTS = 1, 2, 15  # taken away (4.9, 4.10, 4.11)

ACCEPT = Option("accept", "Play the table as it lies.")
BREAK_AGAIN = Option("other breaks", "Have the opening break played again.")

Place = tuple[int, float, float]


class StraightPool(Game, frozen=True, kw_only=True, tag="straight-pool"):
    """A game of straight pool. target: points that win it. points: of each player, below 0 after fouls.

    run, high: balls since this player's last miss, and the most of each player. racks: so often balls have
    been racked again. new_rack: the next stroke is the first at a new rack.
    """

    on_table: tuple[int, ...] = ALL_BALLS
    in_hand: Hand = "behind the line"
    opening: bool = True
    target: Annotated[int, msgspec.Meta(ge=1, le=1000)] = TARGET
    points: tuple[int, ...] = (0, 0)
    run: int = 0
    high: tuple[int, ...] = (0, 0)
    racks: int = 0
    new_rack: bool = False

    def needs_call(self) -> bool:
        """4.5: every stroke is called, the opening too."""
        return not (self.over or self.options)

    # -- a stroke -----------------------------------------------------------------------------------

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke."""
        self.check_playable()
        fouls = common_fouls(self, shot, self.on_table, push_out=False)
        called = shot.pocketing(call.ball) if call.ball is not None and not call.safety else None
        scores = called is not None and called.pocket == call.pocket
        if self.opening and not scores:
            driven = driven_to_cushions(shot)
            fouls = tuple(foul for foul in fouls if foul.kind != "no cushion")
            if CUE_BALL not in shot.cushioned or driven < DRIVEN:
                said = f"Opening: the cue ball and {DRIVEN} others must reach a cushion; {driven} did."
                return self._breaking_foul(shot, (*fouls, Foul("break", said)))
        if fouls:
            return self._standard_foul(shot, fouls)
        if not scores:
            return self._miss(shot, call)
        return self._score(shot)

    def _after(self, shot: ShotSummary, lost: int = 0, back: tuple[int, ...] = ()) -> StraightPool:
        """The state after a stroke, the same player at turn. lost: points; back: balls that are put back."""
        points = tuple(n - lost * (k == self.turn) for k, n in enumerate(self.points))
        return msgspec.structs.replace(
            self, on_table=tuple(sorted({*remaining(self, shot), *back})), points=points, opening=False,
            new_rack=False, in_hand="behind the line" if shot.cue_lost else "",
        )  # fmt: skip

    def _score(self, shot: ShotSummary) -> Verdict:
        """4.7: a point for the called ball, and one for each other that went down with it."""
        made = len(shot.pocketed)
        run = self.run + made
        after = msgspec.structs.replace(
            self._after(shot, lost=-made), run=run,
            high=_with(self.high, self.turn, max(run, self.high[self.turn])),
            fouls_in_row=_with(self.fouls_in_row, self.turn, 0),
        )  # fmt: skip
        words = [f"{self.shooter} has {after.points[self.turn]}, a run of {run}."]
        if after.points[self.turn] >= self.target:
            won = msgspec.structs.replace(after, winner=self.turn, won=rack_won(self, self.turn))
            score = " to ".join(str(n) for n in after.points)
            return Verdict(won, (), shot.balls_down, (*words, f"{self.shooter} wins, {score}."))
        if len(after.on_table) <= 1:
            again = after._racked_again(shot)
            return again._replace(scored=shot.balls_down, words=(*words, *again.words))
        return Verdict(after, (), shot.balls_down, (*words, f"{self.shooter} plays on."))

    def _miss(self, shot: ShotSummary, call: Call) -> Verdict:
        """4.4: the other plays; 4.6: what went down without its call is put back."""
        back = shot.balls_down
        lead = f"{self.shooter} played safe." if call.safety else self._why_not(shot, call)
        words = [lead, *([f"Put back: {', '.join(str(ball) for ball in back)}."] if back else [])]
        after = msgspec.structs.replace(
            self._after(shot, back=back), turn=self.other, run=0,
            fouls_in_row=_with(self.fouls_in_row, self.turn, 0),
        )  # fmt: skip
        return Verdict(after, (), (), (*words, f"{after.shooter} plays."), back)

    def _why_not(self, shot: ShotSummary, call: Call) -> str:
        """Why nothing counted."""
        if call.ball is None or call.pocket is None:
            return "No ball and pocket were called."
        if shot.pocketing(call.ball) is None:
            return f"The {call.ball} did not go down."
        return f"The {call.ball} went into another pocket."

    # -- fouls --------------------------------------------------------------------------------------

    def _standard_foul(self, shot: ShotSummary, fouls: tuple[Foul, ...]) -> Verdict:
        """4.9: a point is lost, and the other plays; the cue ball stays unless it is gone."""
        back = tuple(sorted({*shot.balls_down, *shot.numbered_off}))
        row = self.fouls_in_row[self.turn] + 1
        if row >= MOST_FOULS:
            return self._serious_foul(shot, fouls)
        words = [*(foul.words for foul in fouls), f"{self.shooter} loses a point."]
        if row == MOST_FOULS - 1:
            words.append(f"{self.shooter} is on two fouls: a third costs {SERIOUS_POINTS} more.")
        after = msgspec.structs.replace(
            self._after(shot, FOUL_POINTS, back), turn=self.other, run=0,
            fouls_in_row=_with(self.fouls_in_row, self.turn, row),
        )  # fmt: skip
        words.append(f"{after.shooter} plays{' from behind the line' if after.in_hand else ''}.")
        return after._reachable(shot, Verdict(after, fouls, (), tuple(words), back))

    def _serious_foul(self, shot: ShotSummary, fouls: tuple[Foul, ...]) -> Verdict:
        """4.11: the third foul in a row costs fifteen more; who made it opens again, with all balls."""
        said = f"{self.shooter} fouled {MOST_FOULS} times in a row: {FOUL_POINTS + SERIOUS_POINTS} points."
        fouls += (Foul("three in a row", said),)
        after = msgspec.structs.replace(
            self._opened_again(self.turn),
            points=self._after(shot, FOUL_POINTS + SERIOUS_POINTS).points,
            fouls_in_row=_with(self.fouls_in_row, self.turn, 0),
        )
        words = (*(foul.words for foul in fouls), f"{self.shooter} opens again.")
        return Verdict(after, fouls, (), words, rack=True)

    def _breaking_foul(self, shot: ShotSummary, fouls: tuple[Foul, ...]) -> Verdict:
        """4.10: two points are lost, and it does not count as one of three. 4.3: the other may accept."""
        back = tuple(sorted({*shot.balls_down, *shot.numbered_off}))
        after = msgspec.structs.replace(
            self._after(shot, BREAKING_POINTS, back), turn=self.other, options=(ACCEPT, BREAK_AGAIN), run=0
        )
        words = (*(foul.words for foul in fouls), f"{self.shooter} loses {BREAKING_POINTS} points.")
        return Verdict(after, fouls, (), (*words, f"{after.shooter} chooses."), back)

    def choose(self, name: str) -> Verdict:
        """4.3: to play, or to have the opening break again."""
        self.check_option(name)
        going_on = msgspec.structs.replace(self, options=())
        if name == ACCEPT.name:
            return Verdict(going_on, words=(f"{self.shooter} plays.",))
        state = going_on._opened_again(self.other)
        return Verdict(state, words=(f"{state.shooter} opens again.",), rack=True)

    def _opened_again(self, breaker: int) -> StraightPool:
        """All fifteen racked for an opening; points stay."""
        return msgspec.structs.replace(
            self,
            turn=breaker,
            on_table=ALL_BALLS,
            in_hand="behind the line",
            opening=True,
            run=0,
            new_rack=False,
            options=(),
        )

    def _reachable(self, shot: ShotSummary, verdict: Verdict) -> Verdict:
        """1.5: from behind the line there must be a ball to play at; else the nearest to it is put back."""
        lying = {ball: (x, y) for ball, x, y in shot.rest if ball not in (CUE_BALL, *verdict.spot)}
        held = all(map(area.behind_head_string, lying.values())) and bool(lying)
        if not self.in_hand or verdict.spot or not held:
            return verdict
        nearest = max(lying, key=lambda ball: lying[ball][1])
        words = f"All lie behind the line: the {nearest} is put on the foot spot."
        return verdict._replace(spot=(nearest,), words=(*verdict.words[:-1], words, verdict.words[-1]))

    # -- racks --------------------------------------------------------------------------------------

    def _racked_again(self, shot: ShotSummary) -> Verdict:
        """4.8: fourteen racked without the apex, or all; where break ball and cue ball then lie."""
        lying = {ball: (x, y) for ball, x, y in shot.rest}
        cue, fifteenth = lying[CUE_BALL], self.on_table[0] if self.on_table else None
        ball_at = lying.get(fifteenth) if fifteenth is not None else None
        cue_in = area.in_rack_area(cue)
        ball_in = ball_at is not None and area.in_rack_area(ball_at)
        words = "Fourteen are racked again."
        if ball_at is None or (cue_in and ball_in):  # (a), (b): all fifteen
            places, words = _racked(ALL_BALLS, whole=True), "All fifteen are racked again."
            cue_at = None if cue_in else cue
        else:
            assert fifteenth is not None
            ball_to, cue_at = _cleared(ball_at, ball_in, cue, cue_in)
            others = tuple(ball for ball in ALL_BALLS if ball != fifteenth)
            places = (*_racked(others), (fifteenth, *ball_to))
            if ball_to != ball_at:
                words += f" The {fifteenth} lay in the way."
        hand: Hand = "behind the line" if cue_at is None else ""
        if cue_at is not None:
            places = ((CUE_BALL, *cue_at), *places)
        after = msgspec.structs.replace(
            self, on_table=ALL_BALLS, in_hand=hand, racks=self.racks + 1, new_rack=True
        )
        where = ", the cue ball behind the line" if hand else ""
        return Verdict(after, words=(words, f"{self.shooter} plays on{where}."), places=tuple(sorted(places)))

    @property
    def from_behind(self) -> bool:
        """4.8: at the first stroke of a new rack any ball may be played at."""
        return self.in_hand == "behind the line" and not self.new_rack

    def next_rack(self) -> Verdict:
        """The next game of the same players, who open in turns."""
        breaker = (self.breaker + 1) % len(self.players)
        state = StraightPool(
            players=self.players, turn=breaker, breaker=breaker, won=self.won, target=self.target
        )
        return Verdict(state, words=(f"{state.shooter} opens.",), rack=True)


def _with(row: tuple[int, ...], player: int, value: int) -> tuple[int, ...]:
    """A tuple with one number changed."""
    return tuple(value if k == player else old for k, old in enumerate(row))


def _racked(balls: tuple[int, ...], whole: bool = False) -> tuple[Place, ...]:
    """Balls in the triangle, in their order from the front; without the apex unless it is whole (4.2)."""
    spots = area.rack_places().tolist()[0 if whole else 1 :]
    return tuple((ball, x, y) for ball, (x, y) in zip(balls, spots, strict=True))


def _cleared(
    ball: area.Point, ball_in: bool, cue: area.Point, cue_in: bool
) -> tuple[area.Point, area.Point | None]:
    """Where break ball and cue ball are put, m, if at most one of them is in the way of the rack (4.8).

    (c): the break ball to the head spot, or to the centre spot if the cue ball blocks that. (d): the cue
    ball in hand behind the line (None) if the break ball is before it. Else it goes to the head spot, or
    to the centre spot if the break ball blocks that.
    """
    if ball_in:
        return (area.CENTRE if area.blocks(cue, area.HEAD) else area.HEAD), cue
    if not cue_in:
        return ball, cue
    if area.blocks(ball, area.HEAD):
        return ball, area.CENTRE
    return ball, area.HEAD if area.behind_head_string(ball) else None
