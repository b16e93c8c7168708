"""Random numbers that are a function of a key and a counter, so a particle's fate hangs on no other's.

Threefry-2x32 with 20 rounds (Salmon, Moraes, Dror, Shaw 2011, "Parallel random numbers: as easy as 1, 2, 3";
the authors' Random123 test vectors are among the tests). Only sums, rotations and exclusive-ors of 32-bit
words kept in 64-bit integers: nothing overflows, compiled or not.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel

WORD = 0xFFFFFFFF
PARITY = 0x1BD11BDA
UNIT = 2.0**-32


@lean_kernel
def mix_four(a, b, r0, r1, r2, r3):
    """Four rounds: a sum, then the second word rotated to the left and crossed with the first."""
    a = (a + b) & WORD
    b = ((b << r0 | b >> (32 - r0)) & WORD) ^ a
    a = (a + b) & WORD
    b = ((b << r1 | b >> (32 - r1)) & WORD) ^ a
    a = (a + b) & WORD
    b = ((b << r2 | b >> (32 - r2)) & WORD) ^ a
    a = (a + b) & WORD
    b = ((b << r3 | b >> (32 - r3)) & WORD) ^ a
    return a, b


@lean_kernel
def threefry(key_a, key_b, counter_a, counter_b):
    """Two 32-bit words from two of key and two of counter."""
    key_c = key_a ^ key_b ^ PARITY
    a = (counter_a + key_a) & WORD
    b = (counter_b + key_b) & WORD
    a, b = mix_four(a, b, 13, 15, 26, 6)
    a = (a + key_b) & WORD
    b = (b + key_c + 1) & WORD
    a, b = mix_four(a, b, 17, 29, 16, 24)
    a = (a + key_c) & WORD
    b = (b + key_a + 2) & WORD
    a, b = mix_four(a, b, 13, 15, 26, 6)
    a = (a + key_a) & WORD
    b = (b + key_b + 3) & WORD
    a, b = mix_four(a, b, 17, 29, 16, 24)
    a = (a + key_b) & WORD
    b = (b + key_c + 4) & WORD
    a, b = mix_four(a, b, 13, 15, 26, 6)
    return (a + key_c) & WORD, (b + key_a + 5) & WORD


@lean_kernel
def uniform_pair(seed, stream, index):
    """Two numbers in (0, 1), the same for the same three integers, 0 or more and below 2**62.

    Each is the middle of one of 2**32 equal intervals, so neither 0 nor 1 ever comes. Seed and stream count
    by their lowest 32 bits.
    """
    a, b = threefry(seed & WORD, stream & WORD, index & WORD, (index >> 32) & WORD)
    return (a + 0.5) * UNIT, (b + 0.5) * UNIT
