"""What a network of particles and links is worth: energies, momentum, how far the constraints are off.

Arrays: fields (FIELD_ROWS, n), see `motion`; links (m, 2) and rows (LINK_ROWS, m) in the order of solving.
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.constraints import motion
from game.physics.constraints.links import REST


@kernel
def measure_energy(fields, count, gravity, floor):
    """Kinetic and potential energy (J) of the particles that are not fixed; height counts from the floor."""
    kinetic = 0.0
    potential = 0.0
    for i in range(count):
        w = fields[motion.INVERSE_MASS, i]
        if w > 0.0:
            vx = fields[motion.VX, i]
            vy = fields[motion.VY, i]
            kinetic += 0.5 * (vx * vx + vy * vy) / w
            potential += gravity * (fields[motion.Y, i] - floor) / w
    return kinetic, potential


@kernel
def measure_momentum(fields, count):
    """Momentum (kg m/s) and angular momentum about the origin (kg m²/s) of those not fixed: (x, y, spin)."""
    px = 0.0
    py = 0.0
    spin = 0.0
    for i in range(count):
        w = fields[motion.INVERSE_MASS, i]
        if w > 0.0:
            px += fields[motion.VX, i] / w
            py += fields[motion.VY, i] / w
            spin += (
                fields[motion.X, i] * fields[motion.VY, i] - fields[motion.Y, i] * fields[motion.VX, i]
            ) / w
    return px, py, spin


@kernel
def measure_links(fields, links, rows, order, torn, compliance, strains):
    """Write each link's strain (excess / length at rest, or m if that is 0; 0 if torn) to ``strains`` (m,).

    Returns (greatest strain by magnitude, root of the mean square of the excess in m, elastic energy in J,
    stretch). The energy is by the compliance, the stretch the sum of lengths over that at rest.
    """
    worst = 0.0
    squares = 0.0
    energy = 0.0
    length_now = 0.0
    length_rest = 0.0
    whole = 0
    for e in range(links.shape[0]):
        place = order[e]
        strains[e] = 0.0
        if torn[place]:
            continue
        dx = fields[motion.X, links[e, 1]] - fields[motion.X, links[e, 0]]
        dy = fields[motion.Y, links[e, 1]] - fields[motion.Y, links[e, 0]]
        length = math.sqrt(dx * dx + dy * dy)
        rest = rows[REST, e]
        excess = length - rest
        strains[e] = excess / rest if rest > 0.0 else excess
        worst = max(worst, abs(strains[e]))
        squares += excess * excess
        if compliance[place] > 0.0:
            energy += 0.5 * excess * excess / compliance[place]
        length_now += length
        length_rest += rest
        whole += 1
    mean = math.sqrt(squares / whole) if whole else 0.0
    return worst, mean, energy, length_now / length_rest if length_rest > 0.0 else 1.0
