"""What accuracy costs for a front of embers in a cloth: patches across a strip against its speed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import Computation
from game.physics.cloth import Cloth, Fabric, GasAt, Hanging
from game.physics.cloth.layout import BEGAN, HOT
from game.physics.heat.effects import CONDUCTION, SMOULDERING
from game.physics.heat.exact import fisher_speed_on_grid

LONG, SECONDS, HEATED = 0.8, 20.0, 0.04  # m, s, m that are hot at first
MESHES = (8, 16, 32, 64, 80)
OF_A_CLOTH = 1.6  # m: width of the scene's cloth, over which its meshes are counted
FROM = 0.35  # of the way of the front, over whose rest its speed is taken


def strip_fabric(reaction: str) -> Fabric:
    """All written on, without losses."""
    plain = Fabric()
    return Fabric(
        reaction=reaction, effects=CONDUCTION | SMOULDERING, salted=plain.salted._replace(oxygen=1.0)
    )  # fmt: skip


class Strip:
    """A strip of cloth, one mesh high, in so many meshes; its left end is hot."""

    def __init__(self, reaction: str, meshes: int):
        self.fabric = strip_fabric(reaction)
        self.cloth = Cloth(meshes, self.fabric, Hanging(width=LONG, height=LONG / meshes, span=LONG))
        self.cloth.write(np.ones(self.cloth.patches.shape[1:]))
        self.cloth.patches[HOT, :, : round(HEATED / self.cloth.size)] = 1500.0
        self.air, self.still = np.zeros((1, 1, 4)), np.zeros((1, 1))
        self.air[0, 0, 0] = self.fabric.ambient
        self.gas = GasAt(-LONG, 0.0, 10.0, 1e9, 1e9, 0.27, 1.3, 1e6, 0.0, 0.0, 0.0)

    def run(self, seconds: float, dt: float) -> None:
        """Burn for so long."""
        for _ in range(round(seconds / dt)):
            self.cloth.heat(dt, self.air, self.still, self.gas)
            self.cloth.others[0] += dt

    def speed(self) -> float:
        """m/s over the last part of the way."""
        began = self.cloth.patches[BEGAN, 0]
        came = np.flatnonzero(began >= 0.0)
        a, b = int(came[int(FROM * len(came))]), int(came[-1])
        return float((b - a) * self.cloth.size / (began[b] - began[a]))


def expected_speed(reaction: str, strip: Strip, dt: float) -> float:
    """By the closed form; for Fisher's law that of the finest grid, at so long a time."""
    if reaction == "ignition":
        return strip.fabric.front_speed(lossless=True)
    return fisher_speed_on_grid(strip.fabric.diffusivity, strip.fabric.salted.rate, 1e-3, dt)


def front_trial(setting: Setting) -> Trial:
    """The strip in so many meshes: how far the front's speed is off."""
    dt = 1.0 / setting.others["rate"]

    def work(strip: Strip) -> Strip:
        strip.run(SECONDS, dt)
        return strip

    def judge(strip: Strip) -> Outcome:
        exact = expected_speed(setting.method, strip, dt)
        return Outcome(abs(strip.speed() / exact - 1.0), strip.cloth.patches.shape[2])

    return Computation(SECONDS, lambda: Strip(setting.method, int(setting.knob)), work, judge)


def _settings() -> list[Setting]:
    return [
        Setting(
            reaction, float(meshes), {"rate": rate},
            {"tier": "own", "meshes": round(meshes * OF_A_CLOTH / LONG), "law": reaction,
             "step_length": 1.0 / rate},
            meshes * rate,
        )
        for reaction in ("ignition", "fisher")
        for rate in (60.0, 240.0)
        for meshes in MESHES
    ]  # fmt: skip


def _present(parameters: Mapping[str, Any]) -> Setting | None:
    """The scene's meshes on a strip as long as this; its step, as long as it is near to one of these."""
    tiers = {"play": 56, "teach": 80, "film": 112}
    meshes = tiers.get(str(parameters["tier"]), int(parameters["meshes"]))
    rate = 1.0 / float(parameters["step_length"])
    near = 60.0 if rate < 120.0 else 240.0
    return Setting(str(parameters["law"]), float(round(meshes * LONG / OF_A_CLOTH)), {"rate": near})


front_study = Study(
    name="front",
    title="A front of embers in a cloth",
    error="speed of the front, relative",
    error_unit="1",
    counter="patches",
    order_over="counter",
    knob=Knob("meshes", "meshes along 0.8 m", parts=True),
    methods=(
        Method("ignition", "from a temperature on", 1.0),
        Method("fisher", "Fisher's law", None),
    ),
    settings=_settings,
    trial=front_trial,
    reference="The closed form of the law of steps; for Fisher's law the least speed on a fine grid.",
    expectation="From a temperature on, a patch waits for its neighbour, so the error goes as the size of a "
    "patch. Fisher's front is pulled by its tip and comes to its speed only as 1 / t: there finer patches do "
    "not help within 20 s.",
    present=_present,
    workload=Workload("a strip of 0.8 m, written on, without losses, 20 s"),
)
