"""How stiff links are: what a scene's parameters mean to the solver."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np

from game.arrays import Floats
from game.scenes.springs.network import NOT_OWN
from game.scenes.springs.parameters import RigidLinkParameters, SoftSpringParameters

REFERENCE_HZ = 60.0  # 1/s: at one sweep of a step of 1/60 s all three models agree for a bead of 1 kg
SOFTEST = 1e12  # m/N


class Firmness(NamedTuple):
    """How firmly links hold."""

    stiffness: Floats  # (m,) 0 to 1
    compliance: Floats  # (m,) m/N


class LinkLaw(Protocol):
    """What the solver is to know about links. noun: what they are called. area_stiffness, 0 to 1, and
    area_compliance, m³/N: how firmly outlines hold."""

    noun: str
    area_stiffness: float
    area_compliance: float

    @property
    def model(self) -> str:
        """The solver's model of a link, one of MODELS."""
        ...

    def firmness(self, own: Floats) -> Firmness:
        """Of links (m,) with these stiffnesses of their own (or NOT_OWN)."""
        ...


class RigidLaw:
    """Infinitely stiff links, or such with one compliance."""

    noun = "links"
    area_stiffness, area_compliance = 1.0, 0.0

    def __init__(self, parameters: RigidLinkParameters):
        self.parameters = parameters

    @property
    def model(self) -> str:
        return self.parameters.model

    def firmness(self, own: Floats) -> Firmness:
        return Firmness(np.ones_like(own), np.full_like(own, self.parameters.compliance))


class SoftLaw:
    """Springs with a stiffness k from 0 to 1; areas hold nearly as firmly as they can with each model."""

    noun = "springs"
    area_stiffness, area_compliance = 0.9, 1e-6

    def __init__(self, parameters: SoftSpringParameters):
        self.parameters = parameters

    @property
    def model(self) -> str:
        return self.parameters.model

    def firmness(self, own: Floats) -> Firmness:
        k = np.where(own == NOT_OWN, self.parameters.stiffness, own)
        soft = np.where(k > 0.0, (1.0 - k) / np.maximum(k, 1e-300) / (REFERENCE_HZ * REFERENCE_HZ), SOFTEST)
        return Firmness(k, np.minimum(soft, SOFTEST))
