"""What each effect of a scene costs: with it, declared but off, not declared at all, and with none.

Every variant is a copy of the scene that plays on from the same state. The variants take turns, so that a
busy moment meets all of them, and the least CPU time of a step counts. Tables that are played by events do
all their work in the moment of a stroke: of them a break is measured in place of a step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from time import thread_time
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec

from game.physics.effects import EffectSet

if TYPE_CHECKING:
    from game.stage import Scene, Stage

BEGUN_S = 1.0  # simulated time after which a scene does what it is about
ROUNDS = 15  # turns of every variant
COPIES = 2  # of every variant: where arrays come to lie is a matter of luck
TURN_S = 2e-3  # CPU time of a turn, about
MOST_STEPS = 16  # of a turn: with more of them the variants would go different ways
BY_EVENTS = ("billiards", "three-tables")
BREAK_S = 1.5  # s of a break on those
STEP, BREAK = "a step", f"the first {BREAK_S:g} s of a break"
Work = Callable[[], float]  # does its work once and gives its seconds


class Price(NamedTuple):
    """An effect, and seconds of a step with it, with it off, and where it is not declared; NaN: not known."""

    label: str
    with_s: float
    without_s: float
    undeclared_s: float

    @property
    def cost_s(self) -> float:
        """What the effect adds."""
        return self.with_s - self.without_s


class Prices(NamedTuple):
    """Of one scene: a step as it opens, a step with no effect at all, each effect's price, s; of what."""

    step_s: float
    bare_s: float
    effects: tuple[Price, ...]
    work: str = STEP

    def to_dict(self) -> dict[str, Any]:
        """Plain values, as for a JSON file; `from_dict` takes them back."""
        return {**self._asdict(), "effects": [price._asdict() for price in self.effects]}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Prices:
        """The prices that `to_dict` gave. TypeError or KeyError if these are none."""
        return cls(**{**values, "effects": tuple(Price(**price) for price in values["effects"])})


def measure_prices(scene_type: type[Scene]) -> Prices:
    """Open a scene's first level, let it play, and measure it with and without each effect."""
    if scene_type.name in BY_EVENTS:
        active, variant = scene_type.effects, _break
    else:
        stage = _begun(scene_type)
        active, variant = stage.scene.active, partial(_steps, stage)
    declared = scene_type.effects
    variants = [(active, declared), (EffectSet(), declared)]
    for effect in declared:
        without = active.without(effect)
        variants += [
            (active.with_(effect), declared),
            (without, declared),
            (without, declared.without(effect)),
        ]
    step_s, bare_s, *rest = _least([[_prepared(variant, *one) for _ in range(COPIES)] for one in variants])
    prices = tuple(
        Price(effect.label, *rest[3 * i : 3 * i + 3]) for i, effect in enumerate(scene_type.effects)
    )
    return Prices(step_s, bare_s, prices, BREAK if scene_type.name in BY_EVENTS else STEP)


def _least(variants: list[list[Work | None]]) -> list[float]:
    """The least seconds of each by its copies, all by turns; NaN for what cannot be done."""
    least = [math.inf] * len(variants)
    for turn in range(ROUNDS):
        order = range(len(variants)) if turn % 2 else reversed(range(len(variants)))
        for i in order:
            for work in variants[i]:
                if work is not None:
                    least[i] = min(least[i], work())
    return [value if math.isfinite(value) else math.nan for value in least]


def _prepared(
    variant: Callable[[EffectSet, EffectSet], Work], active: EffectSet, declared: EffectSet
) -> Work | None:
    """A variant that has done its work once, so that its code is compiled; None if it cannot."""
    try:
        work = variant(active, declared)
        work()
    except Exception:  # without an effect a scene may run into what it is not made for
        return None
    return work


def _begun(scene_type: type[Scene]) -> Stage:
    """The scene at its first level, after some time of its demo."""
    from game.app.stagehand.opening import Opening
    from game.app.stagehand.script import Script, demo_of

    stage = Opening().make_stage(scene_type)
    Script(stage, demo_of(scene_type)).run(max(1, round(BEGUN_S / stage.dt)))
    return stage


def copy_declaring(stage: Stage, active: EffectSet, declared: EffectSet) -> Scene:
    """A copy of the scene as it began, with some effects active, of a class that declares those.

    Each copy has a class of its own, as Python is a little quicker with a class that it has to itself.
    """
    kind, level = stage.scene_type, stage.level
    made = type(kind.__name__, (kind,), {"effects": declared, "__doc__": kind.__doc__})
    if level is not None:
        kept = tuple(name for name in level.effects_off if name in declared.names)
        level = msgspec.structs.replace(level, effects_off=kept)
    return made(level, stage.scene.values, seed=stage.scene.seed, effects=active)


def _steps(stage: Stage, active: EffectSet, declared: EffectSet) -> Work:
    """Steps of a copy of the scene from its present state."""
    from game.stage.states.state import copy_state

    scene = copy_declaring(stage, active, declared)
    state = copy_state(stage.scene.state())
    scene.restore(copy_state(state))
    scene.advance(stage.dt)
    scene.restore(copy_state(state))
    begin = thread_time()
    scene.advance(stage.dt)
    steps = max(1, min(MOST_STEPS, round(TURN_S / max(thread_time() - begin, 1e-9))))

    def work() -> float:
        scene.restore(copy_state(state))
        scene.advance(stage.dt)  # after a restore some structures are built again
        begin = thread_time()
        for _ in range(steps):
            scene.advance(stage.dt)
        return (thread_time() - begin) / steps

    return work


def _break(active: EffectSet, declared: EffectSet) -> Work:
    """A break on the exact table under these effects, played for some time; it knows of no others."""
    from game.billiards import Table, eight_ball_rack, make_shot, simulate
    from game.billiards.shot_effects import physics_of, table_of

    table = Table.pool()
    rack = eight_ball_rack(table, gap=1e-4, seed=1)
    shot = make_shot(table_of(active, table), rack, physics=physics_of(active))
    struck = shot.struck(0, (0.1, 8.0), (-60.0, 0.0, 30.0))
    runs = 10

    def work() -> float:
        begin = thread_time()
        for _ in range(runs):
            simulate(struck, until=BREAK_S)
        return (thread_time() - begin) / runs

    return work
