"""The cloth, the layer of gas it hangs in, match and ashes, stepped in one order; what is measured."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from game.arrays import Flags, Floats, Point
from game.physics.cloth import Cloth, ClothState, Fabric, Hanging, charring, layout
from game.physics.cloth.effects import CLOTH
from game.physics.combustion.effects import COMBUSTION
from game.physics.effects import EffectSet
from game.physics.gas.effects import GAS
from game.physics.heat.effects import HEAT
from game.scenes.burning_cloth import tables
from game.scenes.burning_cloth.air import Air
from game.scenes.burning_cloth.ashes import Ashes
from game.scenes.burning_cloth.ashes import X as ASH_X
from game.scenes.burning_cloth.ashes import Y as ASH_Y
from game.scenes.burning_cloth.letters import Lettering, lettering
from game.scenes.burning_cloth.level import MOST_DABS, BurningClothContent
from game.scenes.burning_cloth.match import WATT, Match
from game.scenes.burning_cloth.parameters import BurningClothParameters
from game.worlds.hearing import HEARD_TIME, Heard
from game.worlds.members.burning_air import AirState
from game.worlds.world import Kept, Whole, World

STROKE = 0.064  # m, of the brush
WINDOW_S, FRONT_EVERY = 1.2, 6  # s over which the front's speed is taken; steps from one look to the next
HEARD_S = 0.25
POUR_REACH, POUR_MOST = 0.13, 0.22  # m, kg/m² of a splash
BLOWS = 9.0  # m/s for a m that the hand goes


class BurningClothState(NamedTuple):
    """cloth, air; ashes (MOST, 8); heard (k, HEARD_WIDTH), see `tables`; seen (4,): see the model."""

    cloth: ClothState
    air: AirState
    ashes: Floats
    heard: Floats
    seen: Floats


class BurningClothModel(World):
    """written: dabs of the hand, (right, down) m on the cloth, and washed ones.

    seen (4,): W of flames as the eye sees it, the most of that, m/s of the front when it last was measured
    (-1: never), m of the highest flame.
    """

    state_type = BurningClothState
    content: BurningClothContent
    parameters: BurningClothParameters

    def __init__(
        self, content: BurningClothContent, parameters: BurningClothParameters, active: EffectSet, seed: int
    ):
        super().__init__(content, parameters, active)
        self.steps = 0
        self.written: list[Point] = list(content.dabs)
        self.washed: list[Point] = list(content.washed)
        self.heard = Heard(24, HEARD_S)
        self.seen: Floats = np.array([0.0, 0.0, -1.0, 0.0])
        self.front_now, self.threads_parted = math.nan, 0
        self.cloth = Cloth(
            parameters.meshes_now(),
            self._fabric(),
            Hanging(
                width=tables.WIDTH,
                height=tables.HEIGHT,
                span=tables.SPAN,
                top=tables.TOP,
                substeps=int(parameters.substeps),
                effects=active & CLOTH.known,
            ),
        )
        self.cloth.settle()
        self.letters = self._write()
        self.air = Air(
            parameters.cells_now(), int(parameters.cycles), active & COMBUSTION.known, active & GAS.known
        )
        self.air.wind = parameters.wind
        self.match, self.ashes = Match(), Ashes(seed)
        self.members = (
            Whole(self.cloth), self.air, Kept(self.ashes, "table"), self.heard, Kept(self, "seen"),
        )  # fmt: skip
        patches = self.cloth.patches
        patches[layout.WATER] = content.wet
        self.water_at_first = content.wet * tables.WIDTH * tables.HEIGHT
        for entry in content.hot:
            self._heat(entry.at, entry.radius, entry.kelvin)
        self.heat_at_first = self.cloth.warmth()
        self.fuel_at_first = float(np.sum(patches[layout.FUEL] * patches[layout.SALT]))

    def _fabric(self) -> Fabric:
        chosen = self.parameters
        return Fabric(retardant=chosen.retardant, reaction=chosen.law, effects=self.active & HEAT.known)

    def _write(self) -> Lettering:
        """What is written on the cloth, by the level or by what is chosen, and by hand."""
        cloth, word = self.cloth, self.parameters.word
        words = self.content.words if self.content.words is not None else ("" if word == "blank" else word)
        found = lettering(words, cloth.patches.shape[1:], cloth.size, STROKE)
        cloth.write(found.share)
        for dab in self.written:
            cloth.dab(dab, 0.5 * STROKE)
        for dab in self.washed:
            cloth.dab(dab, 0.7 * STROKE, 0.0)
        return found

    def _heat(self, at: Point, radius: float, kelvin: float) -> None:
        rows, columns = self.cloth.patches.shape[1:]
        right = (np.arange(columns) + 0.5) * self.cloth.size - at[0]
        down = (np.arange(rows) + 0.5) * self.cloth.size - at[1]
        near = (right * right)[None, :] + (down * down)[:, None] < radius * radius
        self.cloth.patches[layout.HOT][near] = kelvin

    # -- changes ------------------------------------------------------------------------------------------

    def change_parameter(self, name: str) -> None:
        chosen = self.parameters
        if name in ("retardant", "law"):
            self.cloth.made_of = self._fabric()
        elif name == "wind":
            self.air.wind = chosen.wind
        elif name == "substeps":
            self.cloth.hanging = replace(self.cloth.hanging, substeps=int(chosen.substeps))
        elif name == "cycles":
            self.air.set_cycles(int(chosen.cycles))

    def change_effects(self, active: EffectSet) -> None:
        self.active = active
        self.cloth.made_of = self._fabric()
        self.cloth.hanging = replace(self.cloth.hanging, effects=active & CLOTH.known)
        self.air.set_effects(active & COMBUSTION.known, active & GAS.known)

    def strike(self) -> None:
        """Take up the match and lead it to the foot of each letter."""
        self.match.take_up(self.time, self.feet())

    def feet(self) -> list[Point]:
        """m: where each letter begins, on the cloth as it hangs now; of what was written by hand the first
        dab.
        """
        on = [*self.letters.feet.tolist()] or (
            [self.written[0]] if self.written else [(0.5 * tables.WIDTH, 0.8 * tables.HEIGHT)]
        )
        return [self.place_on(right, down) for right, down in on]

    def place_on(self, right: float, down: float) -> Point:
        """m: where a point of the cloth, from its upper left corner, is in the picture."""
        nodes, spacing = self.cloth.nodes, self.cloth.spacing
        row = min(max(round(down / spacing), 0), nodes.shape[1] - 1)
        column = min(max(round(right / spacing), 0), nodes.shape[2] - 1)
        x, y = nodes[layout.X : layout.X + 2, row, column].tolist()
        return x + right - spacing * column, y - down + spacing * row

    def write_at(self, point: Point, washes: bool) -> bool:
        """A dab of the brush at a place (m); False if there is no cloth, or too much is written already."""
        on, dabs = self.cloth.point_on(point), self.washed if washes else self.written
        if on is None or len(dabs) >= MOST_DABS:
            return False
        on = (round(on[0], 4), round(on[1], 4))  # as a level file has it
        dabs.append(on)
        self.cloth.dab(on, (0.7 if washes else 0.5) * STROKE, 0.0 if washes else 1.0)
        return True

    def pour(self, point: Point) -> None:
        """Water on what is near."""
        self.cloth.pour(point, POUR_REACH, POUR_MOST)
        self.air.cool(point, POUR_REACH)

    def wet_all(self) -> None:
        """Buckets of water over the whole cloth."""
        self.cloth.pour((0.0, tables.TOP - 0.5 * tables.HEIGHT), 4.0 * tables.WIDTH, 2.0 * POUR_MOST)
        self.air.cool((0.0, tables.TOP - 0.5 * tables.HEIGHT), tables.WIDTH)

    def blow(self, point: Point, way: Point) -> None:
        """A gust along the way (m) of the hand."""
        self.air.blow(point, (min(max(BLOWS * way[0], -3.0), 3.0), min(max(BLOWS * way[1], -3.0), 3.0)), 0.2)

    # -- a step -------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """Match, cloth, then gas; then what has parted."""
        air, cloth = self.air, self.cloth
        lit = self.match.lit(self.time)
        if lit:
            (x, y), _ = self.match.place(self.time)
            air.heat_match((x, y + 0.012), WATT * self.match.strength(self.time), dt)
        air.gust(self.time, dt)
        air.look()
        before = cloth.whole.copy()
        wind = (air.gas.u, air.gas.v, air.breeze(self.time))
        flame = self.match.flame(self.time)
        if cloth.step(dt, air.gas.scalars, air.speed_now, air.at_cloth(), wind, flame):
            self._part((before > 0.0) & (cloth.whole <= 0.0))
        air.advance(dt)
        self.ashes.step(self.air.wind_at(self.ashes.table[:, ASH_X : ASH_Y + 1]), dt)
        self.time += dt
        self.steps += 1
        self._see(dt, lit)
        return ""

    def _part(self, lost: Flags) -> None:
        """Flakes from meshes that were just lost, and their sound."""
        rows, columns = np.nonzero(lost)
        nodes = self.cloth.nodes
        places = (
            0.25
            * (
                nodes[layout.X : layout.X + 2, rows, columns]
                + nodes[layout.X : layout.X + 2, rows, columns + 1]
                + nodes[layout.X : layout.X + 2, rows + 1, columns]
                + nodes[layout.X : layout.X + 2, rows + 1, columns + 1]
            ).T
        )
        velocities = nodes[layout.VX : layout.VX + 2, rows, columns].T
        self.ashes.part(places, np.clip(velocities, -1.0, 1.0), self.cloth.spacing)
        self.threads_parted += 2 * len(rows)
        heard = self.heard.rows
        if len(rows) and (not len(heard) or heard[-1, HEARD_TIME] < self.time - 0.05):
            strong = 0.25 + 0.5 * float(self.ashes.chance.random())
            self.heard.add(self.time, 1, strong, float(places[0, 0]))

    def _see(self, dt: float, was_lit: bool) -> None:
        """What is measured from step to step, and what is to be heard of the match."""
        seen = self.seen
        seen[0] += (self.air.power - seen[0]) * min(1.0, dt / 0.15)
        seen[1] = max(seen[1], seen[0])
        if self.steps % FRONT_EVERY == 0:
            self.front_now = self.cloth.front(WINDOW_S)
            if not math.isnan(self.front_now):
                seen[2] = self.front_now
            seen[3] = max(seen[3], self.air.flame_height())
        if not was_lit and self.match.lit(self.time):
            (x, _), _ = self.match.place(self.time)
            self.heard.add(self.time, 2, 0.8, x)
        self.heard.forget(self.time)

    # -- what there is ------------------------------------------------------------------------------------

    def letters_alight(self) -> int:
        """Letters of which something has burnt."""
        begun = self.letters.of[self.cloth.patches[5] >= 0.0]
        return len(np.unique(begun[begun >= 0]))

    def burnt_of(self, row: float) -> float:
        """Share of the fuel of what is written (1) or plain (0) that has gone, by its saltpetre."""
        patches = self.cloth.patches
        share = patches[layout.SALT] if row > 0.5 else 1.0 - patches[layout.SALT]
        dry = self.cloth.made_of.dry
        there = np.repeat(np.repeat(self.cloth.whole > 0.0, layout.PER, axis=0), layout.PER, axis=1)
        left = float(np.sum(np.where(there, patches[layout.FUEL], 0.0) * share))
        return 1.0 - left / max(dry * float(np.sum(share)), 1e-12)

    def charred(self) -> float:
        """Share of the plain cloth's first mass that is char now."""
        patches = self.cloth.patches
        plain = 1.0 - patches[layout.SALT]
        whole = self.cloth.made_of.dry * float(np.sum(plain))
        return float(np.sum(patches[layout.CHAR] * plain)) / max(whole, 1e-12)

    def books(self) -> dict[str, float]:
        """J: made by what burns and the match; where that, and the heat at first, is; what is missing
        ("open").
        """
        cloth, air = self.cloth, self.air
        flames = air.flames.books_now()
        deep = air.at_cloth().volume / (air.cell * air.cell)
        made = (
            deep * flames.released
            + float(cloth.totals[charring.MADE])
            + float(cloth.totals[charring.MATCH])
            + float(air.flows[0])
        )
        found = {
            "radiated": deep * flames.radiated + float(cloth.totals[charring.RADIATED]),
            "steam": float(cloth.totals[charring.STEAM]), "air": float(air.flows[1]), "gas": air.heat(),
            "cloth": cloth.warmth(), "ash": float(cloth.ash[0]),
        }  # fmt: skip
        return {"made": made, **found, "open": made + self.heat_at_first - sum(found.values())}

    @property
    def alight(self) -> int:
        """Patches that burnt in the last step."""
        return int(self.cloth.totals[charring.ALIGHT])

    @property
    def hottest(self) -> float:
        """K, of the cloth in the last step."""
        return float(self.cloth.totals[charring.HOTTEST])
