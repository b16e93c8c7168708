"""Eight-ball: fifteen balls, two groups, and the 8 last (WPA 3).

Called pockets are an option: "all" (as the rules have it), "eight" (only for the 8) or "none".
"""

from __future__ import annotations

from typing import Literal

import msgspec

from game.billiards.game.rules import (
    NEEDED_AT_BREAK,
    Call,
    Foul,
    Game,
    Hand,
    Option,
    ShotSummary,
    Verdict,
    common_fouls,
    counted_fouls,
    driven_to_cushions,
    rack_won,
    remaining,
)

EIGHT = 8
ALL_BALLS = tuple(range(1, 16))
GROUPS = {"solids": tuple(range(1, 8)), "stripes": tuple(range(9, 16))}
OTHER_GROUP = {"solids": "stripes", "stripes": "solids"}

ACCEPT = Option("accept", "Play the table as it lies.")
RACK_AND_BREAK = Option("break", "Rack again and break.")
RACK_FOR_OTHER = Option("other breaks", "Rack again; the same player breaks again.")
SPOT_EIGHT = Option("spot the eight", "Put the 8 back and play on.")
IN_HAND = Option("in hand", "Take the cue ball behind the line.")


class EightBall(Game, frozen=True, kw_only=True, tag="eight-ball"):
    """A rack of eight-ball. groups: of each player, "" while the table is open."""

    on_table: tuple[int, ...] = ALL_BALLS
    in_hand: Hand = "behind the line"
    opening: bool = True
    groups: tuple[str, str] = ("", "")
    calling: Literal["all", "eight", "none"] = "all"

    @property
    def open_table(self) -> bool:
        """True while no player has a group."""
        return not self.groups[self.turn]

    def balls_of(self, player: int) -> tuple[int, ...]:
        """What is left on the table of a player's group; without a group, of all but the 8."""
        group = GROUPS.get(self.groups[player], tuple(b for b in ALL_BALLS if b != EIGHT))
        return tuple(ball for ball in self.on_table if ball in group)

    def legal_first(self) -> tuple[int, ...]:
        """Any ball at the break; else the own group, the 8 after it; on an open table all but the 8 (3.4)."""
        if self.opening:
            return self.on_table
        own = self.balls_of(self.turn)
        return own + self._eight_if_on()

    def barred(self) -> tuple[int, ...]:
        """The 8 before its turn (3.8); at the break it does not lose."""
        return (EIGHT,) if not self.opening and not self._eight_if_on() else ()

    def targets(self) -> tuple[int, ...]:
        """The balls that may be hit first are those that count."""
        return self.legal_first()

    def _eight_if_on(self) -> tuple[int, ...]:
        """The 8 if it may be played at: the own group is down, or on an open table one of the groups is."""
        groups = [self.groups[self.turn]] if not self.open_table else list(GROUPS)
        cleared = any(not set(GROUPS[group]) & set(self.on_table) for group in groups)
        return (EIGHT,) if cleared and EIGHT in self.on_table else ()

    def needs_call(self) -> bool:
        """True if ball and pocket must be called for the next stroke to score."""
        if self.opening or self.over or self.options:
            return False
        return self.calling == "all" or (self.calling == "eight" and bool(self._eight_if_on()))

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke."""
        self.check_playable()
        fouls = common_fouls(self, shot, self.legal_first(), push_out=False)
        if self.opening:
            return self._judge_break(shot, fouls)
        if EIGHT in shot.balls_down or EIGHT in shot.off_table:
            return self._judge_eight(shot, call, fouls)
        return self._judge_shot(shot, call, fouls)

    def _judge_break(self, shot: ShotSummary, fouls: tuple[Foul, ...]) -> Verdict:
        """3.3. Contact and cushions are a matter of the break rules here."""
        fouls = tuple(foul for foul in fouls if foul.kind != "no cushion")
        words = [foul.words for foul in fouls]
        back = (EIGHT,) if EIGHT in shot.off_table else ()
        after = self._after(shot, fouls, in_hand="", back=back)
        if EIGHT in shot.balls_down:
            words.append("The 8 went down at the break.")
            chooser = self.other if fouls else self.turn
            return self._ask(after, chooser, (SPOT_EIGHT, RACK_AND_BREAK), fouls, words)
        driven = driven_to_cushions(shot)
        lawful = bool(shot.pocketed) or driven >= NEEDED_AT_BREAK
        if not lawful:
            words.append(
                f"Not a legal break: no ball went down, and {driven} of {NEEDED_AT_BREAK} balls reached"
                " a cushion."
            )
        if fouls or not lawful:
            options = [] if shot.cue_lost else [ACCEPT]
            options += [IN_HAND] if fouls else []
            options += [] if lawful else [RACK_AND_BREAK, RACK_FOR_OTHER]
            return self._ask(after, self.other, tuple(options), fouls, words, back)
        if shot.pocketed:
            words += ["The table is open: any ball but the 8.", f"{self.shooter} plays on."]
            return Verdict(after, fouls, shot.balls_down, tuple(words))
        after = msgspec.structs.replace(after, turn=self.other)
        words += ["Nothing went down.", f"{after.shooter} plays; the table is open."]
        return Verdict(after, fouls, (), tuple(words))

    def _judge_eight(self, shot: ShotSummary, call: Call, fouls: tuple[Foul, ...]) -> Verdict:
        """The 8 went down or off the table, which ends the rack (3.8)."""
        fallen = shot.pocketing(EIGHT)
        why = ""
        if fallen is None:
            why = "the 8 left the table"
        elif not self._eight_if_on():
            why = "the 8 went down before its turn"
        elif fouls:
            why = "the 8 went down with a foul"
        elif self.calling != "none" and (call.ball, call.pocket) != (EIGHT, fallen.pocket):
            why = "the 8 went into a pocket that was not called"
        winner = self.other if why else self.turn
        words = [foul.words for foul in fouls]
        words.append(
            f"{self.players[winner]} wins the rack: {why}." if why else f"{self.shooter} pots the 8 and wins."
        )
        after = msgspec.structs.replace(
            self._after(shot, fouls, in_hand=""), winner=winner, won=rack_won(self, winner)
        )
        return Verdict(after, fouls, () if why else (EIGHT,), tuple(words))

    def _judge_shot(self, shot: ShotSummary, call: Call, fouls: tuple[Foul, ...]) -> Verdict:
        """Any stroke in which the 8 stays on the table."""
        words = [foul.words for foul in fouls]
        if fouls:
            after = msgspec.structs.replace(self._after(shot, fouls, in_hand="anywhere"), turn=self.other)
            words.append(f"{after.shooter} has the cue ball in hand.")
            return Verdict(after, fouls, (), tuple(words))
        after = self._after(shot, fouls, in_hand="")
        scored = () if call.safety else self._scored(shot, call)
        if not scored:
            words.append(self._why_nothing(shot, call))
            after = msgspec.structs.replace(after, turn=self.other)
            words.append(f"{after.shooter} plays.")
            return Verdict(after, fouls, (), tuple(words))
        if self.open_table:
            group = "solids" if scored[0] < EIGHT else "stripes"
            scored = tuple(ball for ball in scored if ball in GROUPS[group])
            groups = (group, OTHER_GROUP[group]) if self.turn == 0 else (OTHER_GROUP[group], group)
            after = msgspec.structs.replace(after, groups=groups)
            words.append(f"{self.shooter} has the {group}.")
        words.append(f"{self.shooter} plays on.")
        return Verdict(after, fouls, scored, tuple(words))

    def _scored(self, shot: ShotSummary, call: Call) -> tuple[int, ...]:
        """Balls that keep the shooter at the table; the called one first, if pockets are called."""
        own = [ball for ball in shot.balls_down if ball in self.balls_of(self.turn)]
        if self.calling == "all":
            fallen = shot.pocketing(call.ball) if call.ball is not None else None
            if fallen is None or fallen.ball not in own or fallen.pocket != call.pocket:
                return ()
            own.remove(fallen.ball)
            own.insert(0, fallen.ball)
        return tuple(own)

    def _why_nothing(self, shot: ShotSummary, call: Call) -> str:
        """Why a stroke without a foul did not score."""
        if call.safety:
            return f"{self.shooter} played safe."
        if not shot.pocketed:
            return "Nothing went down."
        if self.calling == "all" and call.ball is None:
            return "No pocket was called, so nothing counts."
        if self.calling == "all":
            fallen = shot.pocketing(call.ball) if call.ball is not None else None
            return (
                "The called ball went into another pocket." if fallen else "The called ball did not go down."
            )
        return f"No ball of {self.shooter} went down."

    def _after(
        self, shot: ShotSummary, fouls: tuple[Foul, ...], in_hand: Hand, back: tuple[int, ...] = ()
    ) -> EightBall:
        """The state after a stroke, the same player at turn. back: balls that are put back at once."""
        return msgspec.structs.replace(
            self,
            on_table=tuple(sorted({*remaining(self, shot), *back})),
            in_hand=in_hand,
            opening=False,
            fouls_in_row=counted_fouls(self, bool(fouls)),
        )

    def _ask(
        self,
        after: EightBall,
        player: int,
        options: tuple[Option, ...],
        fouls: tuple[Foul, ...],
        words: list[str],
        spot: tuple[int, ...] = (),
    ) -> Verdict:
        """The state in which a player must choose; where there is one option only, it is taken."""
        asked = msgspec.structs.replace(after, turn=player, options=options)
        if len(options) == 1:
            taken = asked.choose(options[0].name)
            return taken._replace(fouls=fouls, words=(*words, *taken.words), spot=spot)
        return Verdict(asked, fouls, (), (*words, f"{asked.shooter} chooses."), spot)

    def choose(self, name: str) -> Verdict:
        """What follows from a choice after the break (3.3)."""
        self.check_option(name)
        going_on = msgspec.structs.replace(self, options=())
        if name == ACCEPT.name:
            return Verdict(going_on, words=(f"{self.shooter} plays.",))
        if name == IN_HAND.name:
            return Verdict(
                msgspec.structs.replace(going_on, in_hand="behind the line"),
                words=(f"{self.shooter} has the cue ball behind the line.",),
            )
        if name == SPOT_EIGHT.name:
            state = msgspec.structs.replace(
                going_on,
                on_table=tuple(sorted({*self.on_table, EIGHT})),
                in_hand="" if self.turn == self.breaker else "behind the line",
            )
            return Verdict(state, words=("The 8 is put back.", f"{self.shooter} plays."), spot=(EIGHT,))
        breaker = self.turn if name == RACK_AND_BREAK.name else self.other
        return self._racked(breaker)

    def next_rack(self) -> Verdict:
        """The next rack; the players break in turns."""
        return self._racked((self.breaker + 1) % len(self.players))

    def _racked(self, breaker: int) -> Verdict:
        """A new rack."""
        state = EightBall(
            players=self.players, turn=breaker, breaker=breaker, won=self.won, calling=self.calling
        )
        return Verdict(state, words=(f"{state.shooter} breaks.",), rack=True)
