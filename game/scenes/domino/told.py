"""Words of the dominoes: readouts beside theory, places for stories, sounds, the present level."""

from __future__ import annotations

import math

import msgspec

from game.arrays import Point
from game.scenes.domino import world
from game.scenes.domino.blocks import QUIET
from game.scenes.domino.level import DominoContent, SingleEntry
from game.scenes.domino.world import DominoWorld
from game.stage import Hearing, Readout
from game.worlds.hearing import ROOM
from game.worlds.rubbing import rubbing_heard

NAMES = {world.WOOD: "wood", world.BALL: "ball", world.THUD: "thud"}
LOUD = 400.0  # W, of rolling or sliding that is as loud as can be
HALF = 12.0  # m to either side of the front, from the left to the right


def readouts(model: DominoWorld) -> list[Readout]:
    """All of it: the wave first, then the balls, then the blocks."""
    wave, theory, speeds = model.dominoes.wave.speed or math.nan, model.theory(), model.ball_speeds()
    rows = [
        Readout("struck", model.dominoes.struck()),
        Readout("dominoes", len(model.dominoes.there())),
        Readout("wave speed", wave, "m/s"),
        Readout("theory", theory, "m/s"),
        Readout("wave error", 100.0 * abs(wave / theory - 1.0) if theory > 0.0 else math.nan, "%"),
        Readout("awake", model.solids.awake()),
        Readout("fastest ball", float(speeds.max(initial=0.0)), "m/s"),
        Readout("moving balls", int((speeds > world.CRAWL).sum())),
        Readout("at rest", model.blocks.at_rest()),
    ]
    return [*rows, *_slides(model), Readout("a step", model.solids.watch.median("step"), "s")]


def _slides(model: DominoWorld) -> list[Readout]:
    """How far each block has slid since the line, what the formula says, the worst error of those at rest."""
    found, worst, blocks = [], math.nan, model.blocks
    for k, speed in enumerate(blocks.speeds().tolist()):
        exact = blocks.distance_by_law(k, model.gravity())
        far = math.nan if math.isnan(exact) else float(blocks.table.distance[k])
        if speed < QUIET and math.isfinite(exact) and exact > 0.0:
            error = 100.0 * abs(far / exact - 1.0)
            worst = error if math.isnan(worst) else max(worst, error)
        found += [Readout(f"block {k + 1}", far, "m"), Readout(f"formula {k + 1}", exact, "m")]
    return [*found, Readout("slide error", worst, "%")] if found else []


def saved(model: DominoWorld) -> DominoContent:
    """The level; where a hand has added, moved or taken away dominoes, all of them one by one.

    Fallen ones are written where they stood: a level is what is there before the first push.
    """
    if not model.dominoes.changed:
        return model.content
    table = model.dominoes.table
    singles = tuple(
        SingleEntry(
            at=(float(table.x[k]), float(table.y[k])), lean=math.degrees(float(table.lean[k])),
            to=1 if table.to[k] > 0.0 else -1, size=(float(table.thick[k]), float(table.tall[k])),
        )
        for k in model.dominoes.there().tolist()
    )  # fmt: skip
    return msgspec.structs.replace(model.content, rows=(), singles=singles)


def targets(model: DominoWorld) -> dict[str, Point]:
    """The front, the first and the last domino, the balls by their names, the blocks by number, the first of
    them and their middle; m.
    """
    places, table, found = model.world.bodies.positions, model.dominoes.table, {"front": model.front()}
    if len(table.body):
        for name, number in (("first", 0), ("end", -1)):
            found[name] = (float(table.x[number]), float(table.y[number]) + 0.5)
    for k, (entry, body) in enumerate(zip(model.content.balls, model.ball_ids, strict=True)):
        x, y = places[body].tolist()
        found[entry.name or f"ball {k + 1}"] = (x, y)
    blocks = places[model.blocks.table.body]
    for k, (x, y) in enumerate(blocks.tolist()):
        found[f"block {k + 1}"] = (x, y)
    if len(blocks):
        x, y = (0.5 * (blocks.max(axis=0) + blocks.min(axis=0))).tolist()
        found["blocks"] = (x, y)
    return found


def names(model: DominoWorld) -> list[tuple[Point, str]]:
    """Balls by name and speed; blocks by friction, and by weight beside the first one's."""
    rows, found = model.world.bodies, []
    balls = zip(model.content.balls, model.ball_ids, model.ball_speeds().tolist(), strict=True)
    for entry, body, speed in balls:
        x, y = rows.positions[body].tolist()
        found.append(((x, y), f"{entry.name or 'ball'}, {speed:.1f} m/s"))
    table = model.blocks.table
    for body, mu in zip(table.body.tolist(), table.mu.tolist(), strict=True):
        x, y = rows.positions[body].tolist()
        heavier = float(rows.inverse_masses[table.body[0]] / rows.inverse_masses[body])
        found.append(((x, y), f"μ = {mu:.2f}, {heavier:.3g} m"))
    return found


def hearing(model: DominoWorld) -> Hearing:
    """Contacts that began in the last moments and what rolls and slides, to the sides of the front."""
    middle = model.front()[0]
    steady = rubbing_heard(model.world, model.parameters.values["step_length"], LOUD, HALF, middle)
    return Hearing("dominoes", model.time, model.heard.sounds(NAMES, HALF, middle), [ROOM, *steady])
