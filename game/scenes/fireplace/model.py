"""The fireplace: wood, gas and match together, stepped in one order; what is measured of them."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Point
from game.physics.combustion.effects import COMBUSTION
from game.physics.effects import EffectSet
from game.physics.gas.effects import GAS
from game.physics.heat import STEFAN_BOLTZMANN, cooled
from game.physics.heat import nodes as n
from game.physics.heat.effects import HEAT
from game.physics.kernels import elementary
from game.physics.solids.effects import SOLIDS
from game.scenes.fireplace import tables
from game.scenes.fireplace.air import Air
from game.scenes.fireplace.level import FireplaceContent, WoodEntry
from game.scenes.fireplace.match import Match
from game.scenes.fireplace.parameters import FireplaceParameters
from game.scenes.fireplace.sparks import Sparks, X, Y
from game.scenes.fireplace.wood import SPENT, Wood, WoodState
from game.worlds.hearing import Heard, impacts
from game.worlds.members.burning_air import AirState
from game.worlds.world import World

GIVES = np.array([(-0.8, 1.0), (0.0, 1.0), (0.8, 1.0), (-0.8, -1.0), (0.0, -1.0), (0.8, -1.0)])
SEES_FLAMES = 0.5  # most of what a piece sees that flames are
BRIGHT = 6.0e4  # W/m of flames at which it is so
FAR = 0.35  # m from the middle of the fire at which it is half of that
BEAT_S, LEAST_BEATS = 5.0, 4  # s over which the puffs are counted, and how many it takes
UNDER_ASH = 0.75  # share of its surface that coal still shows when it has burnt out
EMBER_FROM = 520.0  # K: hotter, a burnt out piece is an ember
HEARD_S = 0.25
POP, BREAK, TICK, FALL = 1, 2, 3, 4  # what is heard
LEAST_HEARD = 0.25  # m/s at which wood that falls is heard
TICKS = 0.12  # 1/s at which a piece of coal is heard to crack
HEAT_AT_FIRST, FUEL_AT_FIRST, COAL = range(3)  # of ``whole``
LOG = WoodEntry(at=(0.0, 0.0), length=0.44, thick=0.085, pieces=5)
POUR_REACH = 0.14  # m
TOUCH, TOUCH_HOT = 0.065, 1300.0  # m, K: of the flame of a match
GRIP, QUICKEST = 0.12, 2.0  # m, m/s of a hand


class FireplaceState(NamedTuple):
    """wood, air; logs (k, BOX_WIDTH) as the gas knows them; sparks (MOST, 6); heard (k, HEARD_WIDTH), see
    `tables`; ember (4,), whole (3,): see `FireplaceModel`.
    """

    wood: WoodState
    air: AirState
    logs: Floats
    sparks: Floats
    heard: Floats
    ember: Floats
    whole: Floats


class FireplaceModel(World):
    """shine: W/m of flames, as the eye sees it; crossings: s at which the fire began to puff.

    ember (4,): number of the piece that is followed (-1: none), K as the law of T⁴ has it, K and s when it
    had burnt out. changed: by a hand or by fire, so that it is no longer as the level says.
    """

    content: FireplaceContent
    parameters: FireplaceParameters

    def __init__(
        self, content: FireplaceContent, parameters: FireplaceParameters, active: EffectSet, seed: int
    ):
        super().__init__(content, parameters, active)
        self.shine, self.most_power, self.most_height, self.most_hot = 0.0, 0.0, 0.0, 0.0
        self.crossings: list[float] = []
        self.rising, self.mean_rise, self.last_beat = False, 0.0, 0.0
        self.changed = False
        self.held, self.target = -1, (0.0, 0.0)
        self.heard = Heard(24, HEARD_S)
        self.ember: Floats = np.array([-1.0, 0.0, 0.0, 0.0])
        self.wood = Wood(
            content, parameters.haste, parameters.moisture, active & HEAT.known, active & SOLIDS.known
        )
        self.air = Air(
            parameters.cells_now(), int(parameters.cycles), min(parameters.damper, content.damper),
            content.sealed,
            active & COMBUSTION.known, active & GAS.known,
        )  # fmt: skip
        self.air.wind = parameters.wind
        self.air.set_logs(self.wood.boxes(self.air.cell))
        self.match = Match(self.wood.world)
        self.sparks = Sparks(seed)
        self.whole: Floats = np.array([self.wood.nodes.heat(), self._fuel(), 0.0])

    # -- changes ------------------------------------------------------------------------------------------

    def change_parameter(self, name: str) -> None:
        chosen = self.parameters
        if name == "damper":
            self.air.set_damper(chosen.damper)
        elif name == "wind":
            self.air.wind = chosen.wind
        elif name == "haste":
            self.wood.change_haste(chosen.haste)
        elif name == "cycles":
            self.air.set_cycles(int(chosen.cycles))

    def change_effects(self, active: EffectSet) -> None:
        self.active = active
        self.wood.change_effects(active & HEAT.known, active & SOLIDS.known)
        self.air.set_effects(active & COMBUSTION.known, active & GAS.known)

    def add_log(self, point: Point) -> bool:
        """A log falls from a point (m); False if there is no space."""
        self.changed = True
        x = min(max(point[0], -0.3), 0.3)
        heat, fuel = self.wood.nodes.heat(), self._fuel()
        turn = 24.0 * elementary.sin(37.0 * x + self.time)
        entry = WoodEntry(at=(x, max(point[1], 0.3)), turn=turn, length=LOG.length, thick=LOG.thick, pieces=5)
        if not self.wood.add(entry):
            return False
        self.whole[HEAT_AT_FIRST] += self.wood.nodes.heat() - heat
        self.whole[FUEL_AT_FIRST] += self._fuel() - fuel
        return True

    def blow(self, point: Point, way: Point) -> None:
        """A gust along the way (m) of the hand."""
        self.air.blow(point, (min(max(14.0 * way[0], -3.0), 3.0), min(max(14.0 * way[1], -3.0), 3.0)), 0.09)

    def pour(self, point: Point) -> None:
        """Water on what is near."""
        self.changed = True
        nodes, away = self.wood.nodes, self.wood.places() - point
        near = np.flatnonzero(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1] < POUR_REACH * POUR_REACH)
        for piece in near.tolist():
            most = 0.4 * float(self.wood.table[piece, tables.WHOLE])
            self.whole[HEAT_AT_FIRST] += most * n.WATER_HEAT * tables.ROOM
            nodes.wet(piece, most)
        self.air.pour(point, POUR_REACH)

    def hold(self, point: Point) -> None:
        """Grip the piece of wood at a point, if there is one."""
        places = self.wood.places()
        if not len(places):
            return
        away = places - point
        nearest = int(np.argmin(away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1]))
        if elementary.length(*away[nearest].tolist()) <= GRIP:
            self.changed = True
            self.held, self.target = nearest, point

    def lead(self, point: Point) -> None:
        """Where what is gripped is to go."""
        self.target = point

    def let_go(self) -> None:
        """Grip nothing."""
        self.held = -1

    def _pull(self) -> None:
        """What is gripped goes to where the hand is, no faster than a hand."""
        if not 0 <= self.held < self.wood.count:
            return
        world, body = self.wood.world, int(self.wood.table[self.held, tables.BODY])
        way = np.array(self.target) - world.bodies.positions[body]
        fast = 8.0 * elementary.length(*way.tolist())
        world.set_velocity(
            body, 8.0 * way * min(1.0, QUICKEST / max(fast, 1e-9)), 0.5 * float(world.bodies.spins[body])
        )

    # -- a step -------------------------------------------------------------------------------------------

    def _surfaces(self) -> Floats:
        """(n, 6, 2) m: points just above and below each piece."""
        table = self.wood.table
        bodies = table[:, tables.BODY].astype(np.int64)
        rows = self.wood.world.bodies
        turned = rows.rotations[bodies]
        half = np.stack(
            [
                table[:, tables.HALF_LENGTH],
                table[:, tables.HALF_THICK] * table[:, tables.SCALE] + 0.6 * self.air.cell,
            ],
            1,
        )
        own = GIVES[None] * half[:, None]
        c, s = turned[:, 0, None], turned[:, 1, None]
        x, y = own[..., 0], own[..., 1]
        return np.stack([c * x - s * y, s * x + c * y], axis=2) + rows.positions[bodies][:, None]

    def advance(self, dt: float) -> str:
        """Match, wood, then gas."""
        self.match.lead(self.time, dt)
        self._pull()
        if self.match.lit(self.time):
            head, _ = self.match.place(self.time)
            self.air.heat_match(head, self.match.power(self.time), dt)
        if self.wood.count:
            self._burn_wood(dt)
        else:
            self.wood.world.step(dt)
        self.air.set_logs(self.wood.boxes(self.air.cell))
        self.air.advance(dt)
        self.time += dt
        self._see(dt)
        return ""

    def _burn_wood(self, dt: float) -> None:
        wood, points = self.wood, self._surfaces()
        gas, oxygen, speed = self.air.around(points)
        if self.match.lit(self.time):  # its flame is smaller than a cell
            away = wood.places() - self.match.place(self.time)[0]
            touched = away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1] < TOUCH * TOUCH
            gas[touched], speed[touched] = np.maximum(gas[touched], TOUCH_HOT), 4.0
        places = wood.places()
        away = places[:, 0] * places[:, 0] + elementary.square(places[:, 1] - 0.2)
        strong = SEES_FLAMES * min(1.0, max(self.shine, 0.0) / BRIGHT)
        wood.meet(gas, oxygen, speed, strong / (1.0 + away / (FAR * FAR)))
        torn = int(wood.nodes.torn.sum())
        wood.advance(dt)
        joule, vapour, burnt = (row[: wood.count] for row in wood.nodes.take_given())
        self.air.take(points, joule, vapour, burnt)
        self._spend()
        found = impacts(wood.world, LEAST_HEARD)
        fallen = found.heard(self.time, np.full(len(found.rows), FALL), found.rows[:, 3])
        self.heard.remember(fallen, self.time)
        broken = int(wood.nodes.torn.sum()) - torn
        if broken or wood.nodes.burning().any():
            self.changed = True
        self._crackle(broken, dt)

    def _spend(self) -> None:
        """What is nearly all ash burns no more."""
        wood = self.wood
        fuel = wood.nodes.nodes[n.FUEL, : wood.count]
        spent = (fuel > 0.0) & (fuel < SPENT * wood.table[:, tables.WHOLE])
        if not spent.any():
            return
        laws, hot = wood.made_of, wood.nodes.temperature
        for piece in np.flatnonzero(spent).tolist():
            self.whole[COAL] += float(fuel[piece])
            wood.nodes.nodes[1, piece] += laws.fuel_heat * float(fuel[piece])  # its warmth stays, as ash
            fuel[piece] = 0.0
            wood.nodes.nodes[n.AREA, piece] *= UNDER_ASH
            if self.ember[0] < 0.0 and hot[piece] > EMBER_FROM and wood.is_log()[piece]:
                self.ember[:] = piece, hot[piece], hot[piece], self.time

    def _crackle(self, broken: int, dt: float) -> None:
        """Sparks and sounds, by chance: the more burns, the more."""
        wood, chance = self.wood, self.sparks.chance
        burning = np.flatnonzero(wood.nodes.burning()[: wood.count])
        often = min(0.6 * len(burning) * dt, 0.5)
        pops = int(chance.random() < often) if len(burning) else 0
        for number in range(pops + 2 * broken):
            if not len(burning):
                break
            piece = int(burning[int(chance.integers(len(burning)))])
            x, y = wood.places()[piece].tolist()
            self.sparks.burst((x, y), 2 if number < pops else 10, 0.8 if number < pops else 1.2)
            self.heard.add(self.time, POP if number < pops else BREAK, 0.4 + 0.6 * float(chance.random()), x)
        glowing = np.flatnonzero(wood.nodes.temperature[: wood.count] > EMBER_FROM)
        if len(glowing) and chance.random() < TICKS * len(glowing) * dt:  # coal that shrinks as it cools
            x = float(wood.places()[int(glowing[int(chance.integers(len(glowing)))]), 0])
            self.heard.add(self.time, TICK, 0.1 + 0.3 * float(chance.random()), x)
        self.sparks.step(self.air.wind_at(self.sparks.table[:, X : Y + 1]), dt)

    def _see(self, dt: float) -> None:
        """What is measured from step to step."""
        power = self.power()
        self.shine += (power - self.shine) * min(1.0, dt / 0.12)
        self.most_power = max(self.most_power, self.shine)
        self.most_height = max(self.most_height, self.flame_height())
        self.most_hot = max(self.most_hot, float(np.max(self.air.temperature)))
        rise = self.air.draught()
        self.mean_rise += (rise - self.mean_rise) * min(1.0, dt / 1.5)
        if self.rising and rise < self.mean_rise - 0.06:
            self.rising = False
        elif not self.rising and rise > self.mean_rise + 0.06:
            self.rising = True
            self.crossings = [at for at in self.crossings if at > self.time - BEAT_S] + [self.time]
            if len(self.crossings) >= LEAST_BEATS:
                self.last_beat = (len(self.crossings) - 1) / (self.crossings[-1] - self.crossings[0])
        self.heard.forget(self.time)
        piece = int(self.ember[0])
        if piece >= 0:
            nodes = self.wood.nodes
            capacity = float(nodes.nodes[1, piece] + n.WATER_HEAT * nodes.nodes[n.WATER, piece])
            rate = (
                self.wood.made_of.emissivity * STEFAN_BOLTZMANN * float(nodes.nodes[n.AREA, piece]) / capacity
            )
            self.ember[1] = cooled(float(self.ember[1]), float(nodes.nodes[n.AMBIENT, piece]), rate, dt)

    # -- what there is ------------------------------------------------------------------------------------

    def power(self) -> float:
        """W/m of the flames."""
        return self.air.flames.power

    def flame_height(self) -> float:
        """m."""
        return self.air.flame_height()

    def embers_shine(self) -> float:
        """0 to 1: how much light what glows gives."""
        hot = self.wood.nodes.temperature[: self.wood.count]
        return (
            float(
                np.clip(np.sum(elementary.square(np.clip((hot - 750.0) / 500.0, 0.0, 1.0))) / 8.0, 0.0, 1.0)
            )
            if len(hot)
            else 0.0
        )

    def beat(self) -> float:
        """Hz at which the fire puffs, or did when it last puffed for some time; nan before that."""
        return self.last_beat if self.last_beat > 0.0 else math.nan

    def books(self) -> dict[str, float]:
        """J/m: made by burning and the match; radiated, gone with steam and through the sides, in gas and
        wood; "carrying": what the gas's way of carrying heat has lost of it, step by step; "refused",
        "covered": see `Air`; "open": what is missing of all that. It is rounding only if what was booked as
        made, given and radiated is what the cells were warmed by, which is measured by itself.
        """
        flames, wood, air = self.air.flames.books_now(), self.wood.nodes, self.air
        made = flames.released + float(wood.totals[n.OF_FUEL]) + air.of_match
        found = {
            "radiated": flames.radiated + float(wood.totals[n.RADIATED]),
            "steam": float(wood.totals[n.STEAM]),
            "flue": float(air.out[0]),
            "gas": air.heat(),
            "wood": wood.heat() - float(self.whole[HEAT_AT_FIRST]),
            "carrying": float(air.lost[0]),
            "refused": air.refused,
            "covered": float(air.covered[0]),
        }
        return {"made": made, **found, "open": made - sum(found.values())}

    def vapour(self) -> dict[str, float]:
        """kg/m of vapour. "given": what wood weighs less, but for what it has burnt itself. That is burnt in
        flames, gone through the sides, or in the gas; "carrying" and "covered" are as in `books`. "open": the
        rest.
        """
        air, of_wood = self.air, float(self.wood.nodes.totals[n.OF_FUEL]) / self.wood.made_of.heat
        given = float(self.whole[FUEL_AT_FIRST] - self.whole[COAL]) - self._fuel() - of_wood
        found = {
            "burnt": air.flames.books_now().burnt,
            "flue": float(air.out[1]),
            "gas": float(air.contents()[1]),
            "carrying": float(air.lost[1]),
            "covered": float(air.covered[1]),
        }
        return {"given": given, **found, "open": given - sum(found.values())}

    def burnt_share(self) -> float:
        """Of the wood, by its fuel."""
        first = float(self.whole[FUEL_AT_FIRST])
        return 1.0 - (self._fuel() + float(self.whole[COAL])) / first if first > 0.0 else 0.0

    def coal_share(self) -> float:
        """Of the wood, what is left under ash where no air comes to it."""
        first = float(self.whole[FUEL_AT_FIRST])
        return float(self.whole[COAL]) / first if first > 0.0 else 0.0

    def _fuel(self) -> float:
        """kg/m that can still burn."""
        return math.fsum(self.wood.nodes.fuel.tolist())

    def state(self) -> FireplaceState:
        """All that later steps depend on."""
        air, sounds = self.air.state()[0], self.heard.rows
        return FireplaceState(
            self.wood.state(), air, self.air.logs.rows, self.sparks.table, sounds, self.ember,
            self.whole,
        )  # fmt: skip

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        self.wood.restore(state.wood)
        self.air.restore_logs(state.logs.copy())
        self.air.restore(iter([state.air]))
        self.sparks.table[:], self.heard.rows, self.ember[:] = state.sparks, state.heard.copy(), state.ember
        self.whole[:] = state.whole
