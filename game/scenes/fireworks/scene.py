"""A night of fireworks over a lake: shells, stars that burst into stars, wind, smoke and late thunder."""

from __future__ import annotations

from typing import ClassVar

from game.lab.studies.stars import star_study
from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WIND
from game.physics.generations import BURNING, THRUST, TRAILS
from game.scenes.fireworks import A09
from game.scenes.fireworks.figure import draw_ballistics
from game.scenes.fireworks.hand import FireworksHand
from game.scenes.fireworks.level import FireworksContent
from game.scenes.fireworks.model import FireworksModel
from game.scenes.fireworks.parameters import FireworksParameters
from game.scenes.fireworks.told import hearing, names, readouts, sizes, targets
from game.scenes.fireworks.view import FireworksView, warm_up_shine
from game.stage import (
    Equation,
    Hint,
    SceneAction,
    Strip,
)
from game.worlds.scene import Parts, Told, WorldScene


class Fireworks(WorldScene):
    """A shell is thrown from a mortar, and bursts at the top of its way into stars, which leave sparks or
    burst again. Each star is a point with a mass that burns away. The air drags it, the more the less of it
    is left, and carries it with the wind. Births and bursts have their own instant within a step.

    All shells of the programme are laid for still air; the wind takes them off the mark, and is seen in the
    smoke. A burst's radius stands beside what drag ballistics say of its fastest stars in still air. Its
    momentum is that of the shell: stars fly off in opposite pairs.

    What bursts is heard later by its distance over 343.2 m/s, where the listener on the near bank stands.

    In the equations: u velocity through the air, w wind, m mass as a share of the full one, g gravity, k and
    c linear and quadratic drag, t time, v_0 speed at the burst, v_e speed of a rocket's gas, b share of the
    mass that burns in a second, d distance.
    """

    name, task, title = A09.names
    effects = GRAVITY | DRAG | QUADRATIC_DRAG | WIND | GROUND | BURNING | THRUST | TRAILS
    parameters_type = FireworksParameters
    parameters: FireworksParameters
    model: FireworksModel
    parts = Parts(FireworksModel, FireworksHand, FireworksView)
    told = Told(readouts, targets=targets, hearing=hearing, names=names, sizes=sizes)
    painters = (("shine", warm_up_shine),)
    content_type = FireworksContent
    default_content: ClassVar[FireworksContent] = FireworksContent()
    study = star_study
    legend_in_panel = True

    strips = (
        Strip("Stars alight", "", ("alive",)),
        Strip(
            "Burst radius",
            "m",
            ("ballistics", "burst radius"),
            ("ballistics",),
            ("ballistics", "burst radius"),
        ),
        Strip("Wind", "m/s", ("wind", "smoke drift"), (), ("smoke drift",)),
    )
    hints = (
        Hint(("Click",), "fire a shell to burst there"),
        Hint(("Right click",), "burst one at once"),
        Hint(("Drag",), "walk the listener along the bank"),
    )
    actions = (
        SceneAction("salvo", "fire one of each shell", "B"),
        SceneAction("clear", "put out all stars", "C"),
    )
    figure = staticmethod(draw_ballistics)
    equations = (
        Equation(
            "A star in the air",
            r"\dot{\v{u}} = \v{g} - (k + \frac{c}{m} \abs{\v{u}}) \v{u},  m = 1 - b t",
            "Newton 1687",
        ),
        Equation(
            "Split drag, exact for the drag alone",
            r"\v{u}_{n+1} = \frac{E \v{u}_n}{1 + c G \abs{\v{u}_n}},  E = e^{-k h},  G = \frac{1 - E}{k}",
            "Strang 1968",
        ),
        Equation("Radius of a burst", r"r = \frac{1}{c} \ln (1 + c v_0 t)", "drag ballistics, still air"),
        Equation(
            "A star that burns away",
            r"\frac{1}{v} = \frac{1}{v_0} - \frac{c}{b} \ln (1 - b t)",
        ),
        Equation("A rocket", r"v = v_e \ln \frac{m_0}{m} - g t", "Tsiolkovsky 1903"),
        Equation("Momentum of a burst", r"\sum m_i (\v{v}_i - \v{v}) = 0", "opposite pairs"),
        Equation("Sound", r"t = t_0 + \frac{d}{343.2}"),
    )
    try_this = (
        "Click high over the lake: the shell is laid for the wind as it is and bursts there.",
        "Set the wind to 20 m/s: smoke streams off, and the programme's shells burst off the mark.",
        "Drag the listener away, and see how long each sound takes.",
        "Make stars ten times as heavy: bursts grow, and ballistics with them.",
        "Open the level with one burst in still air and choose explicit Euler: the radius is off at once.",
    )

    def do(self, name: str) -> str:
        (self.model.fire_all if name == "salvo" else self.model.clear)()
        return ""
