"""What all solvers share: velocities and places of bodies through the substeps of one step."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary
from game.physics.solids.arrays import state

SMALL_TURN = 0.1  # rad, up to which a short series gives cosine and sine to 1e-12


@inner_kernel
def start_motion(bodies, scratch, numbers):
    """Velocities to motion, accelerations from gravity and from the forces of this step; forces are
    emptied.
    """
    motion, pulls = scratch.motion, scratch.accelerations
    for i in range(bodies.flags.shape[0]):
        flags = bodies.flags[i]
        awake = flags & state.USED and not flags & state.ASLEEP
        motion[i, state.VX] = bodies.velocities[i, 0] if awake else 0.0
        motion[i, state.VY] = bodies.velocities[i, 1] if awake else 0.0
        motion[i, state.W] = bodies.spins[i] if awake else 0.0
        motion[i, state.DX], motion[i, state.DY], motion[i, state.DA] = 0.0, 0.0, 0.0
        motion[i, state.DC], motion[i, state.DS] = 1.0, 0.0
        pulls[i, 0], pulls[i, 1], pulls[i, 2] = 0.0, 0.0, 0.0
        scratch.air[i, 2] = 1.0 if awake and flags & state.DYNAMIC else 0.0
        if awake and flags & state.DYNAMIC:
            scale, weight = bodies.gravity_scales[i], bodies.inverse_masses[i]
            pulls[i, 0] = scale * numbers.gravity_x + weight * bodies.forces[i, 0]
            pulls[i, 1] = scale * numbers.gravity_y + weight * bodies.forces[i, 1]
            pulls[i, 2] = bodies.inverse_inertias[i] * bodies.forces[i, 2]
        bodies.forces[i, 0], bodies.forces[i, 1], bodies.forces[i, 2] = 0.0, 0.0, 0.0


@inner_kernel
def accelerate(scratch, numbers):
    """Velocities after h of forces; then of drag, against the air, implicitly."""
    motion, pulls, air, h = scratch.motion, scratch.accelerations, scratch.air, numbers.h
    for i in range(motion.shape[0]):
        motion[i, state.VX] += h * pulls[i, 0]
        motion[i, state.VY] += h * pulls[i, 1]
        motion[i, state.W] += h * pulls[i, 2]
    if numbers.drag > 0.0 or numbers.spin_drag > 0.0:
        keep, keep_spin = 1.0 / (1.0 + h * numbers.drag), 1.0 / (1.0 + h * numbers.spin_drag)
        for i in range(motion.shape[0]):
            if air[i, 2] > 0.0:
                motion[i, state.VX] = air[i, 0] + keep * (motion[i, state.VX] - air[i, 0])
                motion[i, state.VY] = air[i, 1] + keep * (motion[i, state.VY] - air[i, 1])
                motion[i, state.W] *= keep_spin


@inner_kernel
def cosine_sine(angle):
    """Of an angle (rad), by a series where it is small."""
    if abs(angle) < SMALL_TURN:
        q = angle * angle
        c = 1.0 - q * (0.5 - q * (1.0 / 24.0 - q * (1.0 / 720.0 - q / 40320.0)))
        s = angle * (1.0 - q * (1.0 / 6.0 - q * (1.0 / 120.0 - q * (1.0 / 5040.0 - q / 362880.0))))
        return c, s
    return elementary.cos(angle), elementary.sin(angle)


@inner_kernel
def move(motion, h):
    """Places after h of the velocities that there are."""
    for i in range(motion.shape[0]):
        motion[i, state.DX] += h * motion[i, state.VX]
        motion[i, state.DY] += h * motion[i, state.VY]
        if motion[i, state.W] != 0.0:
            motion[i, state.DA] += h * motion[i, state.W]
            motion[i, state.DC], motion[i, state.DS] = cosine_sine(motion[i, state.DA])
