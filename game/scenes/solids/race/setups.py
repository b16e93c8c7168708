"""What the solvers are given: structures that stand or hang, if one computes them well."""

from __future__ import annotations

from typing import NamedTuple

from game.scenes.solids.level import (
    ArchEntry,
    BodyEntry,
    CardEntry,
    LinksEntry,
    ShapeEntry,
    SolidContent,
    StackEntry,
    View,
)

RATIOS = (1.0, 10.0, 100.0, 1_000.0, 20_000.0)


class Setup(NamedTuple):
    """content; watched: number of the body whose sinking and leaning is told, negative from the last."""

    content: SolidContent
    watched: int = -1


def _heavy() -> SolidContent:
    top = BodyEntry(
        shapes=(ShapeEntry(box=(1.0, 1.0)),), position=(0.0, 10.5), density=1_000.0, colour="steel"
    )
    boxes = tuple(
        BodyEntry(shapes=(ShapeEntry(box=(1.0, 1.0)),), position=(0.0, 0.5 + k), colour="wood")
        for k in range(10)
    )
    return SolidContent(bodies=(*boxes, top), view=View(left=-4.5, bottom=-0.8, right=4.5, top=11.6))


def _ratios() -> SolidContent:
    bodies = []
    for k, ratio in enumerate(RATIOS):
        x = 1.8 * (k - 2)
        for row, (density, colour) in enumerate(((1.0, "wood"), (ratio, "steel"))):
            bodies.append(
                BodyEntry(
                    shapes=(ShapeEntry(box=(1.0, 1.0)),), position=(x, 0.5 + row), density=density,
                    colour=colour,  # type: ignore[arg-type]
                )
            )  # fmt: skip
    return SolidContent(bodies=tuple(bodies), view=View(left=-5.2, bottom=-0.6, right=5.2, top=4.6))


SETUPS = {
    "stack": Setup(SolidContent(
        stacks=(StackEntry(at=(0.0, 0.0), count=20, colour="wood"),),
        view=View(left=-6.0, bottom=-1.0, right=6.0, top=21.0),
    )),
    "pyramid": Setup(SolidContent(
        stacks=(StackEntry(form="pyramid", at=(0.0, 0.0), count=20, colour="stone"),),
        view=View(left=-11.0, bottom=-1.0, right=11.0, top=21.0),
    )),
    "heavy": Setup(_heavy()),
    "cards": Setup(SolidContent(
        cards=(CardEntry(at=(0.0, 0.0), storeys=3, thickness=0.03, lean=20.0, friction=0.8,
                         colour="yellow"),),
        view=View(left=-2.2, bottom=-0.2, right=2.2, top=3.4),
    )),
    "chain": Setup(SolidContent(
        links=(LinksEntry(
            start=(0.0, 6.5), end=(5.0, 6.5), links=20, radius=0.06, held="first", load=30.0, load_radius=0.4,
            colour="steel",
        ),),
        floor=None,
        view=View(left=-6.2, bottom=-0.2, right=6.2, top=7.2),
    )),
    "arch": Setup(SolidContent(
        arches=(ArchEntry(at=(0.0, 0.0), radius=3.0, thickness=0.3277, blocks=15, friction=0.8,
                          colour="stone"),),
        view=View(left=-4.4, bottom=-0.4, right=4.4, top=4.4),
    ), watched=7),
    "ratios": Setup(_ratios()),
}  # fmt: skip
