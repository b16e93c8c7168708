"""What skinning costs: bones for each point against the error, blends against the area they lose.

Influences: a skin whose points follow only their k heaviest bones, against all bones. Collapse: a straight
bar bent in the middle, by one joint or by several that share the bend. With halves on both bones of a joint
the offset of a point from it shrinks by cos(a / 2). The area of the bar goes with it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study, Workload
from game.physics.animation import Binding, Skeleton, Skinner, bind_weights, chain_skeleton, skin
from game.physics.animation.outlines import area

BONES, POINTS, FRAMES = 12, 4_000, 10
FALLOFF = 2.0
THICK, LONG = 0.1, 1.0  # m, half of the bar's height and of its length
GRAIN = 0.004  # m, between points of the bar's outline
JOINTED = 0.3  # m, the joints are within so much of the middle
BEND = math.radians(150.0)


class Run:
    """A skin moved so many times from the same pose."""

    simulated_s = FRAMES / 60.0

    def __init__(self, work: Callable[[], Floats], error: Callable[[Floats], float], count: int) -> None:
        self.work, self.error, self.count = work, error, count
        self.result: Floats = np.zeros((0, 2))

    def reset(self) -> None:
        """Nothing is kept between runs."""

    def run(self) -> None:
        for _ in range(FRAMES):
            self.result = self.work()

    def outcome(self) -> Outcome:
        return Outcome(self.error(self.result), self.count * FRAMES)


# -- influences -----------------------------------------------------------------------------------------


def curled() -> tuple[Skeleton, Floats]:
    """A chain of twelve bones bound straight and then curled, and points around it."""
    skeleton = chain_skeleton(np.full(BONES, 1.0 / BONES))
    points = np.random.default_rng(7).uniform((-0.05, -0.12), (1.05, 0.12), (POINTS, 2))
    return skeleton, points


@cache
def whole(blend: str) -> Floats:
    """Where the points go if all bones count (v, 2) m."""
    skeleton, points = curled()
    binding = bind_weights(skeleton, points, math.inf, FALLOFF, BONES)
    skeleton.pose(bends())
    return skin(skeleton, binding, blend)


def bends() -> Floats:
    """The pose: each bone by 14 degrees, so that no two are half a turn apart."""
    return np.radians(np.full(BONES, 14.0))


def by_numpy(skeleton: Skeleton, binding: Binding) -> Callable[[], Floats]:
    """Matrix palette skinning by whole arrays: what one writes first."""
    points = np.column_stack([binding.points, np.ones(len(binding.points))])

    def work() -> Floats:
        palette = np.einsum("nij,njk->nik", skeleton.world, binding.inverse)[:, :2]
        blended = np.einsum("vk,vkij->vij", binding.weights, palette[binding.bones])
        moved: Floats = np.einsum("vij,vj->vi", blended, points)
        return moved

    return work


def influence_trial(setting: Setting) -> Run:
    """The curled chain with so many influences."""
    k = int(setting.knob)
    blend = "rotor" if setting.method == "rotor" else "linear"
    skeleton, points = curled()
    binding = bind_weights(skeleton, points, math.inf, FALLOFF, k)
    skeleton.pose(bends())
    skinner = Skinner(binding)
    work = (
        by_numpy(skeleton, binding) if setting.method == "numpy" else lambda: skinner(skeleton.world, blend)
    )

    def error(moved: Floats) -> float:
        off = moved - whole(blend)
        return math.sqrt(float((off * off).sum(axis=1).max()))

    return Run(work, error, k * POINTS)


def influence_settings() -> list[Setting]:
    """One to all bones for a point."""
    return [
        Setting(
            name, k, {}, {"influences": min(k, 8), "blend": "rotor" if name == "rotor" else "linear"}, 5.0 + k
        )
        for k in range(1, BONES + 1)
        for name in ("linear", "rotor", "numpy")
    ]


def present_influences(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    return Setting(str(parameters["blend"]), float(parameters["influences"]))


# -- collapse -------------------------------------------------------------------------------------------


def bar() -> Floats:
    """The outline of a bar from -1 to 1 m, 0.2 m high."""
    x = np.linspace(-LONG, LONG, round(2 * LONG / GRAIN) + 1)
    y = np.full(len(x), THICK)
    return np.vstack([np.column_stack([x, -y]), np.column_stack([x[::-1], y])])


@cache
def bound_bar(joints: int) -> tuple[Skeleton, Binding]:
    """So many joints about the middle of the bar, and the bar bound to the bones; last, a point above one.

    Every point follows two bones; the one above a joint follows both by halves.
    """
    places = np.linspace(-JOINTED, JOINTED, joints) if joints > 1 else np.zeros(1)
    starts = np.concatenate([[-LONG], places])
    lengths = np.diff(np.append(starts, LONG))
    offsets = np.zeros((joints + 1, 2))
    offsets[:, 0] = np.concatenate([[-LONG], lengths[:-1]])
    skeleton = Skeleton(np.arange(joints + 1) - 1, lengths, offsets=offsets)
    points = np.vstack([bar(), [(places[joints // 2], THICK)]])
    return skeleton, bind_weights(skeleton, points, math.inf, 8.0, 2)


def bent(bend: float, blend: str, joints: int = 1) -> tuple[Floats, float]:
    """The outline of the bar bent by so much (rad) in all, and how far the last point is from its joint."""
    skeleton, binding = bound_bar(joints)
    skeleton.pose(np.concatenate([[0.0], np.full(joints, bend / joints)]))
    moved = skin(skeleton, binding, blend)
    off = moved[-1] - skeleton.bases[1 + joints // 2]
    return moved[:-1], math.sqrt(float(off @ off))


def thickness_lost(bend: float, blend: str, joints: int = 1) -> float:
    """Share by which a point at a joint comes nearer to it: 1 - cos(a / 2) for matrices, a of one joint."""
    return abs(1.0 - bent(bend, blend, joints)[1] / THICK)


def area_off(bend: float, blend: str, joints: int = 1) -> float:
    """Share of the bar's area that is lost, or won."""
    return abs(1.0 - area(bent(bend, blend, joints)[0]) / area(bar()))


def bent_trial(name: str, bend: float, joints: int) -> Run:
    """The bar bent so, its error by the method's name: ``linear``, ``rotor-area`` and so on."""
    blend, _, what = name.partition("-")
    skeleton, binding = bound_bar(joints)
    skeleton.pose(np.concatenate([[0.0], np.full(joints, bend / joints)]))
    skinner = Skinner(binding)
    measure = area_off if what == "area" else thickness_lost
    return Run(lambda: skinner(skeleton.update(), blend), lambda _: measure(bend, blend, joints), joints)


LOSSES = ("linear", "linear-area", "rotor", "rotor-area")


def loss_methods(order: float) -> tuple[Method, ...]:
    """What is measured at a bend."""
    return (
        Method("linear", "matrices: thickness", order, "1 - cos(a/2)"),
        Method("linear-area", "matrices: area of the bar", None),
        Method("rotor", "rotors: thickness", None, "kept to rounding"),
        Method("rotor-area", "rotors: area of the bar", None),
    )


def loss_settings(knobs: tuple[float, ...]) -> list[Setting]:
    """All losses at these bends, or numbers of joints."""
    return [Setting(name, knob, {}, {"blend": name.split("-")[0]}) for knob in knobs for name in LOSSES]


LEAST_BEND = 0.1  # °; less is straight


def present_bend(parameters: Mapping[str, Any]) -> Setting | None:
    """The joint that is bent most, if one is bent."""
    bend = float(parameters["bend"])
    return Setting(str(parameters["blend"]), bend) if bend >= LEAST_BEND else None


BENDS = (5.0, 8.0, 12.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 150.0, 175.0)

collapse_study = Study(
    name="c02-collapse",
    title="Skinning: what is lost at a bend",
    error="share lost at the joint",
    error_unit="",
    counter="joints",
    knob=Knob("bend", "bend", "°"),
    methods=loss_methods(2.0),
    settings=lambda: loss_settings(BENDS),
    trial=lambda setting: bent_trial(setting.method, math.radians(setting.knob), 1),
    reference="cos(a/2) of halves blended; the bar as it was bound.",
    expectation="Matrices lose 1 - cos(a/2) of the thickness, all of it at 180°. Rotors keep it, and bulge.",
    floor=1e-13,
    present=present_bend,
    workload=Workload("a bar bent at one joint"),
    no_place="No mark: no joint of the figure is bent.",
    axes=Axes("knob", "error"),
    short="Collapse",
)
joints_study = Study(
    name="c02-joints",
    title="Skinning: a bend shared by joints",
    error="share lost at a bend of 150°",
    error_unit="",
    counter="joints",
    knob=Knob("joints", "joints that share the bend", parts=True),
    methods=loss_methods(2.0),
    settings=lambda: loss_settings((1, 3, 5, 7, 9, 13, 17, 25, 33)),
    trial=lambda setting: bent_trial(setting.method, BEND, int(setting.knob)),
    reference="cos(a/2) of halves blended; the bar as it was bound.",
    expectation="n joints in place of one lose n squared times less. Rotors lose nothing with one.",
    order_over="counter",
    floor=1e-13,
    no_place="No mark: in the figure each joint has a bend of its own.",
    workload=Workload("a bar bent by 150°"),
    axes=Axes("knob", "error"),
    short="Joints",
)

skinning_study = Study(
    name="c02",
    title="Skinning: bones for each point",
    error="farthest point from where all twelve bones take it",
    error_unit="m",
    counter="influences blended",
    knob=Knob("influences", "influences", parts=True),
    methods=tuple(
        Method(name, label)
        for name, label in (("linear", "matrices"), ("rotor", "rotors"), ("numpy", "matrices by NumPy"))
    ),
    settings=influence_settings,
    trial=influence_trial,
    reference="the same blend of all bones.",
    expectation="The error falls with every influence; time grows slowly, as most weights are small.",
    lesson=True,
    order_over="counter",
    floor=1e-13,
    present=present_influences,
    workload=Workload("a curled chain of twelve bones"),
    short="Influences",
    related=(collapse_study, joints_study),
)
