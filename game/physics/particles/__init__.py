"""Particles: emitters, free flight by seven methods, impact on solids in three ways."""

from game.physics.particles.contacts import CONTACTS
from game.physics.particles.effects import OBSTACLES, PARTICLES, REPORTS
from game.physics.particles.emitter import Emitter
from game.physics.particles.flight import EVALUATIONS, METHODS, ORDERS, STABILITY_LIMITS
from game.physics.particles.forces import Forces
from game.physics.particles.settings import CALM
from game.physics.particles.solids import Discs
from game.physics.particles.system import ParticleState, ParticleSystem

__all__ = [
    "CALM",
    "CONTACTS",
    "EVALUATIONS",
    "METHODS",
    "OBSTACLES",
    "ORDERS",
    "PARTICLES",
    "REPORTS",
    "STABILITY_LIMITS",
    "Discs",
    "Emitter",
    "Forces",
    "ParticleState",
    "ParticleSystem",
]
