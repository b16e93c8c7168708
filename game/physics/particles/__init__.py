"""Particles: emitters, free flight by seven methods, impact on solids in three ways."""

from game.physics.particles.contacts import CONTACTS
from game.physics.particles.effects import OBSTACLES, REPORTS
from game.physics.particles.emitter import Emitter
from game.physics.particles.flight import EVALUATIONS, METHODS, ORDERS, STABILITY_LIMITS
from game.physics.particles.forces import Forces
from game.physics.particles.settings import CALM, KNOWN
from game.physics.particles.solids import Discs
from game.physics.particles.system import ParticleState, ParticleSystem

__all__ = [
    "CALM",
    "CONTACTS",
    "EVALUATIONS",
    "KNOWN",
    "METHODS",
    "OBSTACLES",
    "ORDERS",
    "REPORTS",
    "STABILITY_LIMITS",
    "Discs",
    "Emitter",
    "Forces",
    "ParticleState",
    "ParticleSystem",
]
