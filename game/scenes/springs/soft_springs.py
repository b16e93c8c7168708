"""Particles and soft springs, by position based dynamics in three ways."""

from __future__ import annotations

from game.lab.studies.springs import spring_study
from game.scenes.springs import C15
from game.scenes.springs.base import MassSpringScene
from game.scenes.springs.figure import draw_sweeps
from game.scenes.springs.links import SoftLaw
from game.scenes.springs.parameters import SoftSpringParameters
from game.scenes.springs.readouts import area_kept
from game.stage import Equation, Readout, Strip


class Springs(MassSpringScene):
    """Springs in place of rigid links: each correction goes only a part k of the way. What comes out is soft,
    but how soft depends on how many sweeps there are and how long a step is: more sweeps are stiffer.

    With k' = 1 − (1 − k)^(1/n) it no longer depends on the sweeps, but still on the step. With compliance a
    spring has a stiffness in newtons to the metre that depends on neither. The three agree for one sweep of
    a step of 1/60 s on a bead of 1 kg; change the step and watch them part.

    Jellies keep the area of their meshes, rings the area within: switch areas off to see why.

    The speed limit slows each particle by itself: where springs far from their length meet it, momentum is
    lost.

    In the equations: p position, w inverse mass, C excess length or area, n direction of the spring,
    h substep of n sweeps, g gravity, α compliance, λ multiplier, k_N stiffness in N/m, A area.
    """

    name, task, title = C15.names
    study = spring_study
    parameters_type = SoftSpringParameters
    parameters: SoftSpringParameters

    strips = (
        Strip("Stretch", "", ("worst", "overall")),
        Strip("Energy", "J", ("kinetic", "elastic", "sum")),
        Strip("Area", "", ("area kept",)),
    )
    figure = staticmethod(draw_sweeps)
    equations = (
        Equation("Correction", r"\Delta\v{p}_a = k \frac{w_a}{w_a + w_b} C \v{n}", "Müller and others 2007"),
        Equation("Rest stretch of a bead", r"g h^2 \frac{q}{1-q},  q = (1-k)^n", "fixed point of n sweeps"),
        Equation("Spread over n sweeps", r"k' = 1 - (1-k)^{1/n}", "Müller and others 2007"),
        Equation(
            "Compliance",
            r"\Delta\lambda = \frac{C - \alpha\lambda / h^2}{w_a + w_b + \alpha / h^2}",
            "Macklin and others 2016",
        ),
        Equation(
            "Hooke",
            r"\alpha = \frac{1}{k_N} = \frac{1-k}{k} (1/60 \text{ s})^2 / \text{kg}",
            "how k is read here",
        ),
        Equation("Area", r"C = \frac{1}{2}\sum \v{p}_i \times \v{p}_{i+1} - A_0", "Müller and others 2007"),
    )
    try_this = (
        "Open the three springs, raise the iterations: with k they stiffen; with k′ and compliance not.",
        "Halve the time step: only compliance keeps its stretch.",
        "Switch areas off: the jelly and the ring lose their shape.",
        "Set the stiffness to 1: the springs are the rigid links of C14.",
    )

    def link_law(self) -> SoftLaw:
        return SoftLaw(self.parameters)

    def readouts(self) -> list[Readout]:
        return [*super().readouts(), area_kept(self.model)]
