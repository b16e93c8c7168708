"""What bounding volumes cost: area against the angle step.

The search by degrees is of first order in the step. The least box has a side flush with the hull and its area
has a kink there. Calipers are exact and no dearer.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.studies.bounds.gap import gap_study
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import chosen_setting, computation
from game.physics.bounds import (
    FITS,
    fit_capsule,
    fit_obb,
    minimal_capsule,
    minimal_obb,
    near_least_capsule,
    principal_box,
    thinnest_box,
    thinnest_capsule,
)
from game.physics.kernels import elementary, elementwise

STEPS_DEGREES = (45.0, 30.0, 20.0, 15.0, 10.0, 6.0, 4.0, 2.5, 1.5, 1.0, 0.6, 0.4, 0.25, 0.1)
SHAPES = 40
CAPSULE_SHAPES = 16
GOLDEN_TRIALS = 46  # directions that golden section looks at


def shapes(count: int) -> list[Floats]:
    """Rectangles and clouds of points, long and not so long, turned anyhow."""
    random = np.random.default_rng(8)
    made = []
    for i in range(count):
        aspect = float(elementwise.exp(random.uniform(0.0, elementary.log(20.0))))
        if i % 2:
            points = random.normal(size=(30, 2)) * (aspect, 1.0)
        else:
            points = np.array([(0.0, 0.0), (aspect, 0.0), (aspect, 1.0), (0.0, 1.0)])
        angle = random.uniform(0.0, math.pi)
        c, s = elementary.cos(angle), elementary.sin(angle)
        x, y = points[:, 0], points[:, 1]
        made.append(np.column_stack((c * x - s * y, s * x + c * y)))
    return made


def fit_trial(fit: Callable[[Floats], Any], given: list[Floats], least: list[float], counter: int) -> Trial:
    """Volumes round given points (k, 2): the mean area above the least, m², over the least."""

    def judge(areas: list[float]) -> Outcome:
        excess = [a / b - 1.0 for a, b in zip(areas, least, strict=True)]
        return Outcome(max(float(np.mean(excess)), 0.0), counter)

    return computation(float(len(given)), lambda: [fit(points).area for points in given], judge)


def directions(step: float, quarter: float) -> int:
    """How many directions a search by steps tries over ``quarter``, both in degrees."""
    return math.ceil(quarter / step - 1e-9)


def tried(setting: Setting, count: int, quarter: float) -> int:
    """Directions tried for so many shapes, those of golden section among them."""
    if setting.method not in SEARCHES:
        return count
    return count * (directions(setting.knob, quarter) + (GOLDEN_TRIALS if setting.method == "refined" else 0))


BOXES: dict[str, Callable[[float], Callable[[Floats], Any]]] = {
    "search": lambda step: lambda points: fit_obb(points, step),
    "refined": lambda step: lambda points: fit_obb(points, step, refine=True),
    "thinnest": lambda step: thinnest_box,
    "exact": lambda step: minimal_obb,
    "principal": lambda step: principal_box,
}
CAPSULES: dict[str, Callable[[float], Callable[[Floats], Any]]] = {
    "search": lambda step: lambda points: fit_capsule(points, step),
    "refined": lambda step: lambda points: fit_capsule(points, step, refine=True),
    "thinnest": lambda step: thinnest_capsule,
    "exact": lambda step: near_least_capsule,
}
SEARCHES = ("search", "refined")  # by steps; the others have none


def fit_settings(methods: Mapping[str, Any]) -> list[Setting]:
    """Every step for those methods that have one; the others once."""
    found = []
    for step in STEPS_DEGREES:
        for name in methods:
            if name in SEARCHES or step == 1.0:
                scene = {"fit": name, "angle_step": step} if name in FITS else {}
                found.append(Setting(name, step, {}, scene, 90.0 / step))
    return found


def box_trial(setting: Setting) -> Trial:
    """Boxes round all shapes."""
    given = shapes(SHAPES)
    least = [minimal_obb(points).area for points in given]
    return fit_trial(BOXES[setting.method](setting.knob), given, least, tried(setting, SHAPES, 90.0))


def capsule_trial(setting: Setting) -> Trial:
    """Capsules round some of the shapes."""
    given = shapes(CAPSULE_SHAPES)
    least = [minimal_capsule(points).area for points in given]
    return fit_trial(
        CAPSULES[setting.method](setting.knob), given, least, tried(setting, CAPSULE_SHAPES, 180.0)
    )


box_study = Study(
    name="c08",
    title="Oriented boxes: area against the angle step",
    error="mean area above the least, over the least",
    error_unit="",
    counter="directions tried",
    knob=Knob("angle_step", "angle step", "°"),
    methods=(
        Method("search", "by degrees", 1.0),
        Method("refined", "golden section", None, "finds the flush side"),
        Method("thinnest", "least breadth", None, "by calipers"),
        Method("exact", "exact", None, "least area, by calipers"),
        Method("principal", "greatest variance", None, "no search at all"),
    ),
    settings=lambda: fit_settings(BOXES),
    trial=box_trial,
    reference="rotating calipers, which are exact.",
    expectation=(
        "Half the step, half the excess: the least box has a side on the hull, and its area a kink there. "
        "Golden section goes down to that kink."
    ),
    floor=1e-9,
    present=chosen_setting("fit", "angle_step"),
    workload=Workload("40 shapes"),
    cost="CPU time for one shape",
    short="Fit",
    related=(gap_study,),
)

capsule_study = Study(
    name="c09",
    title="Capsules: area against the angle step",
    error="mean area above the least, over the least",
    error_unit="",
    counter="directions tried",
    knob=Knob("angle_step", "angle step", "°"),
    methods=(
        Method("search", "by degrees", None, "in the middle of the projection"),
        Method("refined", "golden section", None, "in the middle of the projection"),
        Method("thinnest", "least radius", None, "by calipers"),
        Method("exact", "exact", None, "least area to 0.1 %, by branch and bound"),
    ),
    settings=lambda: fit_settings(CAPSULES),
    trial=capsule_trial,
    reference="branch and bound over directions and radii, to 0.1 % and polished.",
    expectation=(
        "Golden section gains nothing below some 20°: what is left is the price of laying the "
        "core in the middle of the projection, with half of the breadth for a radius. The least radius "
        "costs still more on what is nearly round. Only a search over radii too comes down, and is dear."
    ),
    floor=1e-9,
    present=chosen_setting("fit", "angle_step"),
    workload=Workload("16 shapes"),
    cost="CPU time for one shape",
    short="Fit",
    related=(gap_study,),
)
