"""Buttons and keys of the billiard game."""

from __future__ import annotations

from game.billiards.game.games import Drill, Ghost, Practice
from game.scenes.billiards import layout
from game.scenes.billiards.beside import BESIDE, COACH
from game.scenes.billiards.modes import Replay, SetUp, leave
from game.scenes.billiards.play import AIMING, REPLAY, ROLLING, SET_UP, Play
from game.scenes.billiards.practice.drill_maker import DrillMaker
from game.scenes.billiards.practice.side import Side
from game.scenes.billiards.stroke.calling import announced
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.actions import OPTIONS
from game.scenes.shared.tables.choices import GUIDE_BUTTONS, GUIDES, following, next_player
from game.scenes.shared.tables.eye.choices import SIDES
from game.scenes.shared.tables.grip import NOTHING, Grip, Held
from game.scenes.shared.tables.seats.cup import after_match
from game.stage import Part

POWER_STEP = 0.1  # m/s for a key or a notch of the wheel


class Buttons(Part):
    """What buttons and keys do. hint_shown: the solution of a puzzle. goes_on: the next lesson is wanted.
    films: how often a film of the match has been asked for.
    """

    def __init__(self, play: Play, replay: Replay, set_up: SetUp, side: Side, maker: DrillMaker) -> None:
        self.play = play
        self.replay = replay
        self.set_up = set_up
        self.side = side
        self.maker = maker
        self.hint_shown = False
        self.goes_on = False
        self.films = 0

    def rows(self) -> list[tuple[str, str, bool]]:
        """Buttons right of the table, from below: action, words, whether it is on."""
        play = self.play
        if self.maker.active:
            needed = f"{self.maker.needed} of {self.maker.tries}"
            return [("drill-play", "Play drill", not self.maker.lacking), ("drill-needed", needed, False),
                    ("drill-zone", "No zone", False), ("drill", "Balls only", False)]  # fmt: skip
        if play.phase == SET_UP:
            return [("set-up", "Done", True), ("clear", "Clear", False), ("full", "Rack", False),
                    ("drill", "Drill", False)]  # fmt: skip
        if play.phase == REPLAY:
            return [("replay", "Back", True), ("side", SIDES[self.replay.from_side], False)]
        back = play.model.match_behind
        lesson = play.model.content.lesson
        rows = [] if lesson else [("set-up", "Set up", False)]
        rows += [("replay", "Replay", False), ("eye", "Sight", bool(play.parameters.eye)),
                ("undo", "To match" if back else "Undo", back),
                ("view", GUIDE_BUTTONS[play.guide], False)]  # fmt: skip
        game = play.model.frame.game
        if play.model.content.solution is not None:
            rows.append(("hint", "Hint", self.hint_shown))
        rows.append(("coach", "Coach", self.side.beside == COACH))
        if lesson:
            rows.append(("lesson", "Next lesson", isinstance(game, Drill) and game.best > 0))
        if game.over:
            own = isinstance(game, Practice) and bool(game.set_up)
            again = "Again" if len(game.players) == 1 else "New match"
            if len(game.players) == 2 and play.log.entries:
                rows.append(("film-strokes", "Film", False))
            again = again if own or play.match_over else "Next rack"
            rows.append(("rack", after_match(play) or again, True))
        elif game.may_push_out():
            call = play.aiming.call
            rows.append(("safety", "Safety" if call.safety else "Push out", call.safety or call.push_out))
        elif game.needs_call():
            rows.append(("safety", "Safety", play.aiming.call.safety))
        if play.may_aim:
            rows.append(("strike", "Strike", True))
        return rows

    def at(self, x: float, y: float) -> Grip:
        """The button, card or option at a point; NOTHING if there is none."""
        for row, (name, _, _) in enumerate(self.rows()):
            if layout.button_box(row).holds(x, y):
                return grip.button(name)
        game = self.play.model.frame.game
        if len(game.players) == 2:
            for player in range(1 if isinstance(game, Ghost) else 2):
                if layout.card_box(player).holds(x, y):
                    return grip.card(player)
        if self.play.phase == AIMING and self.play.person_plays:
            for row in range(len(game.options)):
                if layout.option_box(row, len(game.options)).holds(x, y):
                    return grip.option(row)
        if self.play.phase == REPLAY:
            if layout.PLAY.holds(x, y):
                return grip.button("replay-run")
            if layout.SPEED.holds(x, y):
                return grip.button("replay-speed")
        return NOTHING

    def press(self, held: Grip) -> None:
        """A button, a player's card or an option has been pressed and let go."""
        name = held.name
        if held.kind is Held.OPTION:
            self.play.take_option(held.number)
        elif held.kind is Held.CARD:
            self.play.set_grade(held.number, next_player(self.play.grade_of(held.number)))
        elif name == "replay-run":
            self.replay.toggle()
        elif name == "replay-speed":
            self.replay.change_speed()
        elif name in ("clear", "full"):
            self.set_up.fill(name == "full")
        elif name == "film-strokes":
            self.films += 1
        elif name.startswith("drill"):
            {
                "drill": self.maker.toggle, "drill-play": self.maker.finish,
                "drill-zone": self.maker.clear_zone, "drill-needed": lambda: self.maker.change_needed(1),
            }[name]()  # fmt: skip
        else:
            self.act(name)

    def act(self, name: str) -> None:
        """A named action."""
        play, aiming = self.play, self.play.aiming
        if name in OPTIONS:
            if play.person_plays:
                play.take_option(OPTIONS.index(name))
        elif name in ("undo", "rack") and play.phase in (REPLAY, SET_UP):
            leave(self.replay, self.set_up)
        elif name in ("left", "right"):
            if play.person_plays and play.phase == AIMING:
                aiming.nudge(name)
        elif name in BESIDE:
            self.side.turn(name)
        elif name == "thoughts":
            play.parameters.considered = not play.parameters.considered
        elif name == "cloud":
            play.parameters.cloud = not play.parameters.cloud
        elif name.startswith("spin-"):
            aiming.nudge_tip(name)
        elif name in ("harder", "softer"):
            step = POWER_STEP if name == "harder" else -POWER_STEP
            aiming.set_power(round(play.parameters.power + step, 3))
        else:
            {
                "strike": self._strike_or_skip,
                "undo": play.undo,
                "replay": self._watch,
                "side": self._watch_side,
                "eye": self._show_eye,
                "set-up": self._lay_out,
                "rack": play.rack,
                "view": self._change_guide,
                "safety": self._announce,
                "lock": self._lock,
                "demo": self._play_itself,
                "hint": self._show_hint,
                "centre": aiming.centre,
                "breath": play.push.breathe,
                "chalk": lambda: play.messages.say(play.push.chalk()),
                "lesson": self._go_on,
                "ask": self._ask,
            }[name]()

    def _strike_or_skip(self) -> None:
        """Strike with the power that is set; while balls roll, go to the end; in a replay, run or stand."""
        play = self.play
        if play.phase == REPLAY:
            self.replay.toggle()
        elif play.phase == ROLLING:
            play.skip()
        elif play.phase == AIMING and play.model.frame.game.over:
            play.rack()
        elif play.may_aim:
            play.strike_by_hand()

    def _watch(self) -> None:
        if self.play.phase == REPLAY:
            self.replay.end()
        elif self.play.phase == AIMING:
            self.replay.begin()

    def _watch_side(self) -> None:
        """The last stroke from its best side; in a replay, from there or from above."""
        if self.play.phase == REPLAY:
            self.replay.from_side = not self.replay.from_side
        elif self.play.phase == AIMING:
            self.replay.begin(from_side=True)

    def _show_eye(self) -> None:
        self.play.parameters.eye = not self.play.parameters.eye

    def _lay_out(self) -> None:
        if self.play.phase == SET_UP:
            self.set_up.end()
        elif self.play.phase == AIMING:
            self.set_up.begin()

    def _change_guide(self) -> None:
        self.play.parameters.guide = following(self.play.guide, GUIDES)

    def _lock(self) -> None:
        if self.play.may_aim:
            self.play.toggle_lock()

    def _announce(self) -> None:
        if self.play.person_plays and self.play.phase == AIMING:
            self.play.aiming.call = announced(self.play.model.frame, self.play.aiming.call)

    def _play_itself(self) -> None:
        self.play.plays_itself = not self.play.plays_itself
        self.play.let_go()
        self.play.rest_s = 0.0
        leave(self.replay, self.set_up)

    def _ask(self) -> None:
        self.play.parameters.beside = COACH
        self.play.ask_coach()

    def _go_on(self) -> None:
        self.goes_on = bool(self.play.model.content.lesson)

    def _show_hint(self) -> None:
        self.hint_shown = not self.hint_shown
        if self.play.model.content.solution is None:
            self.hint_shown = False
            self.play.messages.say("No hint. Only puzzles and drills have one.")
