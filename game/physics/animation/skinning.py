"""Skin that follows bones: matrix palette skinning, and rotor blending that keeps limbs thick.

Palette: P_i = W_i B_i⁻¹, the motion of bone i since the skin was bound (frame B_i). It is 1 in that pose.

    linear   v' = Σ w_i P_i v                   matrices are blended (Magnenat-Thalmann and others 1988)
    rotor    v' = (Σ w_i M_i / |...|) v         unit rotors are blended (Kavan and others 2007, in the plane:
                                                Matsuda, Kaji, Ochiai 2014, anti-commutative dual complex
                                                numbers)

A blend of matrices is no rotation: with halves and a bend a, (1 + R(a)) / 2 = cos(a / 2) R(a / 2), so that a
joint shrinks by cos(a / 2) and vanishes at 180 degrees. A rotor M = p + q ε, with p = e^(iθ/2), q = t p̄ / 2
and ε z = z̄ ε, turns by θ and shifts by t: v' = p² v + 2 q p. A sum of rotors made unit is a rotor again: the
joint keeps its thickness, at the price of a bulge.

Arrays: worlds and palette (f, n, 3, 3), frames of bones in f poses, and inverse (n, 3, 3); rotors (f, n, 4);
bones and weights (v, k), which bones a point follows and how much; points (v, 2) and skinned (f, v, 2) m.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.animation.skeleton import Skeleton
from game.physics.animation.weights import Binding, WeightError

BLENDS = ("linear", "rotor")
FLAT = 1e-12  # |Σ w p| below which rotors cancel out (bends of 180 degrees): the first one is taken


@kernel
def make_palette(worlds, inverse, palette):
    """Write the motions (f, n, 3, 3) of bones since the skin was bound."""
    for k in range(worlds.shape[0]):
        for i in range(inverse.shape[0]):
            for row in range(3):
                for column in range(3):
                    total = 0.0
                    for j in range(3):
                        total += worlds[k, i, row, j] * inverse[i, j, column]
                    palette[k, i, row, column] = total


@kernel
def skin_linear(points, bones, weights, palette, skinned):
    """Write points (f, v, 2) moved by weighted sums of matrices; weights of a point fall."""
    for k in range(palette.shape[0]):
        for v in range(points.shape[0]):
            a = b = c = d = e = f = 0.0
            for j in range(bones.shape[1]):
                w = weights[v, j]
                if w == 0.0:
                    break
                i = bones[v, j]
                a += w * palette[k, i, 0, 0]
                b += w * palette[k, i, 0, 1]
                c += w * palette[k, i, 0, 2]
                d += w * palette[k, i, 1, 0]
                e += w * palette[k, i, 1, 1]
                f += w * palette[k, i, 1, 2]
            x, y = points[v, 0], points[v, 1]
            skinned[k, v, 0] = a * x + b * y + c
            skinned[k, v, 1] = d * x + e * y + f


@kernel
def make_rotors(palette, rotors):
    """Write rotors (f, n, 4), p and q as two complex numbers each, of rigid motions (f, n, 3, 3)."""
    for k in range(palette.shape[0]):
        for i in range(palette.shape[1]):
            c, s = palette[k, i, 0, 0], palette[k, i, 1, 0]
            if c >= 0.0:
                p = math.sqrt(0.5 + 0.5 * c)
                o = 0.5 * s / p
            else:
                o = math.sqrt(0.5 - 0.5 * c)
                p = 0.5 * s / o
            x, y = palette[k, i, 0, 2], palette[k, i, 1, 2]
            rotors[k, i, 0], rotors[k, i, 1] = p, o
            rotors[k, i, 2], rotors[k, i, 3] = 0.5 * (x * p + y * o), 0.5 * (y * p - x * o)


@kernel
def skin_rotor(points, bones, weights, rotors, skinned):
    """Write points (f, v, 2) moved by weighted sums of rotors, each turned to the side of the first."""
    for k in range(rotors.shape[0]):
        for v in range(points.shape[0]):
            i = bones[v, 0]
            w = weights[v, 0]
            first_p, first_o = rotors[k, i, 0], rotors[k, i, 1]
            p, o, q, r = w * first_p, w * first_o, w * rotors[k, i, 2], w * rotors[k, i, 3]
            for j in range(1, bones.shape[1]):
                w = weights[v, j]
                if w == 0.0:
                    break
                i = bones[v, j]
                if first_p * rotors[k, i, 0] + first_o * rotors[k, i, 1] < 0.0:
                    w = -w  # M and -M are one motion: the short way between two
                p += w * rotors[k, i, 0]
                o += w * rotors[k, i, 1]
                q += w * rotors[k, i, 2]
                r += w * rotors[k, i, 3]
            square = p * p + o * o
            if square < FLAT * FLAT:
                i = bones[v, 0]
                p, o, q, r = first_p, first_o, rotors[k, i, 2], rotors[k, i, 3]
                square = p * p + o * o
            x, y = points[v, 0], points[v, 1]
            c, s = (p * p - o * o) / square, 2.0 * p * o / square
            skinned[k, v, 0] = c * x - s * y + 2.0 * (q * p - r * o) / square
            skinned[k, v, 1] = s * x + c * y + 2.0 * (q * o + r * p) / square


class Skinner:
    """Moves a bound skin along with its skeleton, without allocating anything.

    `skinned` (v, 2) m is the result of the last call. WeightError for an unknown blend.
    """

    def __init__(self, binding: Binding) -> None:
        self.binding = binding
        count = len(binding.inverse)
        self.palette = np.empty((1, count, 3, 3))
        self.rotors = np.empty((1, count, 4))
        self._out = np.empty((1, len(binding.points), 2))
        self.skinned = self._out[0]

    def __call__(self, world: Floats, blend: str = "linear") -> Floats:
        """The skin (v, 2) m for the frames (n, 3, 3) of its bones; good until the next call."""
        blend_skin(self.binding, world[None], blend, self.palette, self.rotors, self._out)
        return self.skinned


def blend_skin(
    binding: Binding, worlds: Floats, blend: str, palette: Floats, rotors: Floats, skinned: Floats
) -> None:
    """Write the skin (f, v, 2) for frames (f, n, 3, 3); ``palette`` and ``rotors`` are space to work in.

    WeightError for a blend that is none of BLENDS.
    """
    make_palette(worlds, binding.inverse, palette)
    if blend == "linear":
        skin_linear(binding.points, binding.bones, binding.weights, palette, skinned)
    elif blend == "rotor":
        make_rotors(palette, rotors)
        skin_rotor(binding.points, binding.bones, binding.weights, rotors, skinned)
    else:
        raise WeightError(f"blend {blend!r}: expected one of {', '.join(BLENDS)}")


def skin(
    skeleton: Skeleton, binding: Binding, blend: str = "linear", angles: ArrayLike | None = None
) -> Floats:
    """The skin (v, 2) m in the skeleton's present pose, or (f, v, 2) for poses ``angles`` (f, n) rad.

    WeightError if the binding is one of another skeleton, or for an unknown blend.
    """
    if len(binding.inverse) != skeleton.count:
        raise WeightError(f"binding: has {len(binding.inverse)} bones, the skeleton {skeleton.count}")
    worlds = skeleton.world[None] if angles is None else skeleton.frames(angles)
    frames = len(worlds)
    palette, rotors = np.empty(worlds.shape), np.empty((frames, skeleton.count, 4))
    skinned = np.empty((frames, len(binding.points), 2))
    blend_skin(binding, worlds, blend, palette, rotors, skinned)
    return skinned[0] if angles is None else skinned
