"""One dam by several methods, side by side, with the experiment."""

from __future__ import annotations

from game.lab.studies.water.dam import front_study
from game.physics.effects import EffectSet
from game.scenes.liquid import DAM
from game.scenes.liquid.dam_view import DamView
from game.scenes.liquid.dam_world import DamContent, DamParameters, DamWorld, readouts
from game.scenes.liquid.figure import draw_fall
from game.scenes.liquid.methods import COLUMNS
from game.stage import Equation, Strip
from game.worlds.painting.liquid import warm_up_liquid
from game.worlds.painting.particle_liquid import warm_up_particle_liquid
from game.worlds.scene import Parts, Told, WorldScene

FRONTS = tuple(f"front, {one.name}" for one in COLUMNS)
PRICES = tuple(f"price, {one.name}" for one in COLUMNS)
KNOWN = ("front, experiment", "front, Ritter")


class Dam(WorldScene):
    """A column of water whose gate is gone. The same fall is computed in different ways.

    Above: a liquid of particles on cells, which knows that water at the foot must first be set in motion.
    Then particles alone, each of which feels its neighbours. Both have their front at the same place.
    Below: shallow water, in which all water above a place goes at one speed, from the first moment.

    Shallow water is far ahead at first: its front starts at its full speed. It is much cheaper.
    In the experiment of 1952 the gate took its time, so that all computed fronts lead.

    PySPH, a particle code by others, is the measure of prices. With 3,938 particles it took 13.8 s of
    processor for a second of a column 1 m wide.

    In the equations: h depth, g gravity, c speed of a wave, a width of the column, x place, t time.
    """

    name, task, title = DAM.names
    parameters_type = DamParameters
    parameters: DamParameters
    model: DamWorld
    parts = Parts(DamWorld, lambda model: None, DamView)
    told = Told(readouts)
    effects = EffectSet()
    content_type, default_content = DamContent, DamContent()
    not_of_model = ("exact", "experiment")
    study = front_study
    figure = staticmethod(draw_fall)
    painters = (("water", warm_up_liquid), ("particles", warm_up_particle_liquid))
    dt = 1.0 / 240.0
    strips = (
        Strip("Front", "m", (*FRONTS, *KNOWN), exact=KNOWN, sometimes=KNOWN),
        Strip("Price", "s", PRICES, sometimes=PRICES),
    )
    equations = (
        Equation("Scaled time", r"T = t \sqrt{2 g / a}", "Martin and Moyce 1952"),
        Equation("A wave", r"c_0 = \sqrt{g h_0}", "Lagrange 1781"),
        Equation("Shallow water", r"h = \frac{(2 c_0 - x/t)^2}{9 g}", "Ritter 1892"),
    )
    try_this = (
        "Look at the first tenth of a second: only shallow water has a front that runs at once.",
        "Take 8 cells for the liquid, then 40: how little its front changes.",
        "Choose Müller's law for the particles: soft water falls behind, at a third of the price.",
        "Compare the two prices in the chart.",
    )
