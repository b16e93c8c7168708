"""Particles and infinitely stiff links, by position based dynamics."""

from __future__ import annotations

from game.lab.studies.constraints import stretch_study
from game.scenes.springs import C14
from game.scenes.springs.base import MassSpringScene
from game.scenes.springs.figure import draw_projection
from game.scenes.springs.links import RigidLaw
from game.scenes.springs.parameters import RigidLinkParameters
from game.stage import Equation


class RigidLinks(MassSpringScene):
    """Particles are joined by links that should never change their length. In every step gravity and damping
    move the particles where they like. Then link by link, in a few sweeps, both ends are moved along the link
    until its length is right again. What has become of the positions gives the velocities.

    A sweep mends one link and spoils its neighbours, so a long rope stretches like rubber unless there are
    very many sweeps. Taking the same work for smaller substeps is better by their number. A chain can also
    be solved as a whole.

    A particle with inverse mass 0 is fixed in space. Build, pin, cut and drag while it runs.

    Links far from their length would shoot off: the speed limit slows each particle by itself, and what it
    takes of the momentum is lost. The catenary meets it in its first step, and so does what is overstretched.

    In the equations: x position, p predicted position, v velocity, h substep, g gravity, k_d damping,
    w inverse mass, C constraint, L length at rest, n direction of the link, α compliance, λ multiplier,
    M mass at the end of a chain of N links over that of each other particle.
    """

    name, task, title = C14.names
    study = stretch_study
    parameters_type = RigidLinkParameters
    parameters: RigidLinkParameters

    figure = staticmethod(draw_projection)
    equations = (
        Equation(
            "Prediction",
            r"\v{v}^* = \frac{\v{v}}{1 + h k_d w} + h\v{g},  \v{p} = \v{x} + h\v{v}^*",
            "Müller and others 2007",
        ),
        Equation("Constraint", r"C = \abs{\v{p}_b - \v{p}_a} - L = 0"),
        Equation(
            "Projection",
            r"\Delta\v{p}_a = \frac{w_a}{w_a + w_b} C \v{n},  \Delta\v{p}_b = -\frac{w_b}{w_a + w_b} C \v{n}",
            "the same",
        ),
        Equation("Velocity", r"\v{v} = (\v{p} - \v{x}) / h", "the same"),
        Equation("Error left by a sweep", r"\cos^2 \frac{\pi}{2N}", "chain of N links; Young 1954"),
        Equation(
            "Stretch, one sweep a substep", r"(N-1)\left(M + \frac{N-2}{2}\right) g h^2", "hanging chain"
        ),
        Equation(
            "Compliance",
            r"\Delta\lambda = \frac{C - \alpha\lambda / h^2}{w_a + w_b + \alpha / h^2}",
            "Macklin and others 2016",
        ),
        Equation("Second order", r"\v{v} = (3\v{p} - 4\v{x} + \v{x}_-) / 2h", "English and Bridson 2008"),
    )
    try_this = (
        "Open the long rope: 20 iterations in one substep, then 20 substeps of one: less than a twentieth.",
        "Open the sweep, link by link: each link that is put right spoils the one before.",
        "Choose BDF2, let the pendulum swing: its energy stays; Euler loses three quarters in ten seconds.",
        "Take the cloth with the mouse and pull until it tears; cut it with the right button.",
        "Choose the direct solver for the rope with the heavy end: no stretch, at the price of two sweeps.",
    )

    def link_law(self) -> RigidLaw:
        return RigidLaw(self.parameters)
