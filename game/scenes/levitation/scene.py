"""P28: grains in the sound field of a phased array."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from game.lab.studies.levitation import trap_study
from game.physics.acoustics.effects import GRAINS
from game.scenes.levitation import LEVITATION
from game.scenes.levitation.figure import draw_standing_wave
from game.scenes.levitation.hand import LevitationHand
from game.scenes.levitation.level import DEFAULT, LevitationContent
from game.scenes.levitation.model import APART, LevitationModel
from game.scenes.levitation.parameters import OF_PICTURE, LevitationParameters
from game.scenes.levitation.readouts import readouts_of
from game.scenes.levitation.view import LevitationView
from game.stage import Equation, Frame, Hint, SceneAction, Strip
from game.worlds.expectations import draw_captions
from game.worlds.scene import ModelScene, Told


class Levitation(ModelScene):
    """Rows of ultrasonic transducers, of 40 kHz, face each other. Where their waves meet they stand still:
    every half wave length, 4.3 mm, is a node of the pressure. A small light grain is pushed there from both
    sides, harder than it weighs.

    By their phases the waves meet at any place one likes. Lead that place along a figure, and the grains
    draw it, until they are led faster than the sound can hold them.

    In the equations: p pressure and v speed of the air, V volume and a radius of a grain, ρ density and c
    speed of sound of the air, k wave number, φ phase of a transducer at r_j, f_1 and f_2 how much lighter
    to squeeze and heavier than air the grain is, E energy density, η viscosity.
    """

    name, task, title = LEVITATION.names
    parameters_type = LevitationParameters
    parameters: LevitationParameters
    model: LevitationModel
    effects = GRAINS.known
    content_type = LevitationContent
    told = Told(readouts_of)
    not_of_model = OF_PICTURE
    default_content = DEFAULT
    study = trap_study
    takes = frozenset(("right",))
    figure = staticmethod(draw_standing_wave)
    hints = (Hint(("Drag",), "lead the focus"), Hint(("Right click",), "a grain more"))
    actions = (SceneAction("clear", "No grains", "n"), SceneAction("refill", "Grains as they were", "g"))
    strips = (
        Strip("Distance from the focus", "m", ("off the focus",)),
        Strip("Speed", "m/s", ("focus speed", "fastest", "drag limit"), exact=("drag limit",)),
    )
    equations = (
        Equation(
            "Potential", r"U = V (\frac{f_1 p^2}{2 \rho c^2} - \frac{3}{4} f_2 \rho v^2)", "Gor'kov 1962"
        ),
        Equation(
            "In a standing wave",
            r"F = 4 \pi a^3 k E (\frac{f_1}{3} + \frac{f_2}{2}) \sin 2 k z",
            "Bruus 2012",
        ),
        Equation("Focus", r"\phi_j = -k \abs{\v{r} - \v{r}_j}", "all arrive together"),
        Equation("Drag", r"F = 6 \pi \eta a v (1 + 0.15 Re^{0.687})", "Schiller and Naumann 1933"),
    )
    try_this = (
        "Raise Speed until grains are left behind; the strip shows how far they lag before that.",
        "Make the grains heavier, step by step, and see from which nodes they sink first.",
        "Look at the wave itself, slowed down, and find the nodes where the grains sit.",
        "Open the lattice: four rows hold a grain at every half wave, both ways.",
    )

    def make(self, content: LevitationContent) -> None:
        self.model = LevitationModel(content, self.parameters, self.active)
        self.hand = LevitationHand(self.model)
        self.view = LevitationView(self.model)

    def save_content(self) -> LevitationContent:
        places = tuple((float(x), float(y)) for x, y in self.model.levitator.positions)
        return LevitationContent(grains=places, expected=self.model.content.expected)

    def advance(self, dt: float) -> None:
        self.model.advance(dt, self.hand.place)

    def action(self, name: str) -> None:
        self.model.clear()
        if name == "refill":
            for place in [*self.model.node_places(), *self.model.content.grains]:
                self.model.add(place)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return (
            ("disc:yellow", "carried", ""),
            ("disc:text3", "not carried", ""),
            ("disc:amber", "focus", ""),
        )

    def frame(self) -> Frame:
        half = 0.5 * APART + 0.008
        return Frame(-half, -half, half, half)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha, self.model.steps * self.dt)
        draw_captions(canvas, (0.0, 0.5 * APART - 0.004), self.captions())
