"""Beads on springs, beside the sum of their normal modes: a whole scene in one file."""

import math
from typing import NamedTuple

import numpy as np

from game.lab.studies.motion import chain_study
from game.physics.constraints import LINKS
from game.physics.effects import EffectSet
from game.physics.integrators import METHODS, integrate
from game.physics.kernels import elementwise, linear
from game.physics.oscillators import bead_positions, spring_pull
from game.scenes.examples import SPRING_CHAIN
from game.scenes.examples.figure import draw_modes
from game.scenes.examples.marks import arrow_legend, mark_beads
from game.stage import Choice, Equation, Frame, Param, Pointer, Readout, Scene, Strip
from game.ui.canvas.canvas import EXACT_DASH

WIDE = 4.0  # m, between the walls


class ChainState(NamedTuple):
    """beads, rates: (n,) displacements (m) and rates (m/s)."""

    beads: np.ndarray
    rates: np.ndarray


class SpringChain(Scene):
    """Equal beads, each pulled by the springs to its neighbours, between two walls. However it is let go, its
    motion is a sum of modes that swing each for itself (Lagrange 1788): the dashed chain. Drag a bead.
    """

    name, task, title = SPRING_CHAIN.names
    effects = EffectSet([LINKS])
    method = Choice("verlet", METHODS, help="how a step is made")
    count = Param(15, 1, 60, whole=True, rebuild=True, help="beads between the walls")
    mode = Param(0, 0, 60, whole=True, rebuild=True, help="in which it begins; 0: plucked in the middle")
    stiffness = Param(100.0, 1.0, 400.0, unit="1/s²", rebuild=True, help="of a spring, over a bead's mass")
    step_length = Param(1.0 / 120.0, 1.0 / 2000.0, 0.1, unit="s", log=True, help="of time")
    strips = (Strip("Energy", "J/kg", ("energy",)), Strip("Error", "m", ("error",)))
    equations = (Equation("Motion", r"\ddot{u}_j = \frac{k}{m} (u_{j-1} - 2 u_j + u_{j+1})", "Newton 1687"),)
    try_this = ("Begin in mode 5: it keeps its shape.", "Choose explicit Euler: it bursts.")
    figure = staticmethod(draw_modes)
    legend = arrow_legend
    study = chain_study("spring-chain")

    def build(self, level):
        places = np.arange(1, self.count + 1) / (self.count + 1)
        number = min(self.mode, self.count)
        beads = elementwise.sin(number * math.pi * places) if number else 1.0 - np.abs(2.0 * places - 1.0)
        self.chain, self.time, self.held = ChainState(beads, 0.0 * beads), 0.0, -1
        self.free = beads.tolist(), 0.0  # displacements and time of letting go, for the exact motion

    def advance(self, dt):
        self.time += dt
        if self.held >= 0:
            self.free = self.chain.beads.tolist(), self.time
        elif LINKS in self.active:
            beads, rates = integrate(self.method, spring_pull(self.stiffness), *self.chain, dt, 1)
            self.chain.beads[:], self.chain.rates[:] = beads, rates

    def state(self):
        return self.chain

    def pointer(self, event: Pointer):
        if event.kind == "down":
            self.held = int(np.clip(round(event.x / WIDE * (self.count + 1)) - 1, 0, self.count - 1))
        if event.kind in ("up", "cancel"):
            self.held = -1
        elif self.held >= 0:
            knots = [-1, self.held, self.count], [0.0, float(np.clip(event.y, -2.0, 2.0)), 0.0]
            self.chain.beads[:], self.chain.rates[:] = linear.interpolated(np.arange(self.count), *knots), 0.0
            self.free = self.chain.beads.tolist(), self.time

    def effects_changed(self):
        self.free = [math.nan for _ in self.free[0]], self.time  # of what begins now no exact motion is known

    def frame(self):
        return Frame(-0.3, -1.3, WIDE + 0.3, 1.3)

    def exact(self, ago=0.0):
        return bead_positions(self.free[0], np.sqrt(self.stiffness), max(self.time - ago - self.free[1], 0.0))

    def readouts(self):
        beads, rates = self.chain
        springs = np.diff(beads, prepend=0.0, append=0.0)
        energy = 0.5 * float((rates * rates).sum() + self.stiffness * (springs * springs).sum())
        return [Readout("error", max(abs(beads - self.exact())), "m"), Readout("energy", energy, "J/kg")]

    def draw(self, canvas, alpha):
        canvas.grid()
        x = WIDE * np.arange(self.count + 2) / (self.count + 1)
        canvas.segments(*(np.array([(0.0, y), (WIDE, y)]) for y in (-0.25, 0.25)), "text1", 3.0)
        beads = self.previous.beads + alpha * (self.chain.beads - self.previous.beads)
        exact = self.exact((1.0 - alpha) * self.step_length)
        for y, color, dash in ((exact, "text1", EXACT_DASH), (beads, "text2", None)):
            canvas.polyline(np.column_stack((x, np.pad(y, 1))), color, 1.6, dash=dash)
        mark_beads(canvas, x[1:-1].tolist(), beads, self.chain.rates, self.stiffness)
