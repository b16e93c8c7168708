"""What each effect of the exact table costs, and how far the balls go astray without it.

Cloth, spin decay, throw and cushion friction are switched off one by one, then together. They are tried on a
shot with three balls and on a break. What is switched off is not computed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.shot_effects import CLOTH, EXACT_EFFECTS, RUBBER, SPIN_DECAY, THROW, physics_of
from game.billiards.simulation import simulate
from game.billiards.table.rack import eight_ball_rack
from game.billiards.table.table import Table
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.effects import EffectSet

EFFECTS = {"cloth": CLOTH, "spin-decay": SPIN_DECAY, "throw": THROW, "rubber": RUBBER}
TIME = 1.5  # s
SHOTS_IN_A_RUN = 20  # one takes about the tick of the clock
BREAK_BALLS = 16


def effects_without(name: str) -> EffectSet:
    """All effects of the exact table but one; "all" takes none away, "none" all those studied."""
    if name == "all":
        return EXACT_EFFECTS
    left = EXACT_EFFECTS
    for taken in EFFECTS.values() if name == "none" else [EFFECTS[name]]:
        left = left.without(taken)
    return left


def shot_of(balls: int, active: EffectSet) -> Shot:
    """Three balls with side spin, or a break of sixteen, on a bare table under these effects."""
    table = Table.bare(1.27, 2.54)
    physics = physics_of(active)
    if balls == BREAK_BALLS:
        rack = make_shot(table, eight_ball_rack(table, gap=1e-4, seed=1), physics=physics)
        return rack.struck(0, (0.1, 8.0), (-60.0, 0.0, 30.0))
    few = make_shot(table, [[0.35, 0.5], [0.75, 1.25], [0.95, 2.1]], physics=physics)
    return few.struck(0, (1.154, 2.104), (-27.0, 14.8, -35.0))


def shot_without(shot: Shot, full: Shot) -> Trial:
    """A shot without some effect, played many times: the farthest ball from where the full shot has it."""
    exact = simulate(full, until=TIME)

    def work() -> Trajectory:
        for _ in range(SHOTS_IN_A_RUN):
            played = simulate(shot, until=TIME)
        return played

    def judge(played: Trajectory) -> Outcome:
        apart = played.state_at(TIME).positions - exact.state_at(TIME).positions
        return Outcome(math.sqrt(float((apart * apart).sum(axis=1).max())), len(played.times))

    return computation(SHOTS_IN_A_RUN * TIME, work, judge)


def _trial(setting: Setting) -> Trial:
    balls = int(setting.knob)
    return shot_without(shot_of(balls, active_of(setting.scene)), shot_of(balls, EXACT_EFFECTS))


def switches(active: EffectSet) -> dict[str, bool]:
    """The studied effects by name, on or off."""
    return {name: effect in active for name, effect in EFFECTS.items()}


def active_of(switched: Mapping[str, object]) -> EffectSet:
    """All effects of the exact table but those that are switched off."""
    off = [effect for name, effect in EFFECTS.items() if not switched[name]]
    return EffectSet(effect for effect in EXACT_EFFECTS if effect not in off)


def present_setting(parameters: Mapping[str, object]) -> Setting:
    """Where a scene with these effects stands, in a break."""
    switched = {name: bool(parameters[name]) for name in EFFECTS}
    names = (name for name in ("all", *EFFECTS, "none") if switches(effects_without(name)) == switched)
    return Setting(next(names, "present"), float(BREAK_BALLS), {}, switched)


def _settings() -> Sequence[Setting]:
    return [
        Setting(name, float(balls), {}, switches(effects_without(name)), float(balls))
        for balls in (3, BREAK_BALLS)
        for name in ("all", *EFFECTS, "none")
    ]


effects_study = Study(
    name="three-tables-effects",
    title="Exact table: what each effect costs",
    error="farthest ball from where it is with all effects, after 1.5 s",
    error_unit="m",
    counter="events",
    knob=Knob("balls", "balls"),
    methods=(
        Method("all", "all effects"),
        Method("cloth", "without cloth"),
        Method("spin-decay", "without spin decay"),
        Method("throw", "without throw"),
        Method("rubber", "without cushion friction"),
        Method("none", "without any of them"),
    ),
    settings=_settings,
    short="Effects",
    trial=_trial,
    present=present_setting,
    workload=Workload("a break of so many balls"),
    reference="the exact table with all effects.",
    expectation="An effect costs the events that it brings: in a break the cloth is every other one, as "
    "balls begin to roll and come to rest. Throw, spin decay and cushion friction cost little, and each puts "
    "a ball millimetres to centimetres aside; in a break, anywhere.",
)
