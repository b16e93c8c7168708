"""Names of methods and options in words: as on the command line, but for proper names and joined words."""

from __future__ import annotations

PROPER = {
    "rk4": "RK4", "xpbd": "XPBD", "euler": "Euler", "lagrangian": "Lagrangian", "jacobi": "Jacobi",
    "gauss": "Gauss", "seidel": "Seidel", "maccormack": "MacCormack", "stam": "Stam", "armijo": "Armijo",
    "verlet": "Verlet", "baumgarte": "Baumgarte",
}  # fmt: skip
JOINED = ("semi-implicit", "gauss-seidel", "time-centred", "no-slip", "v-cycles")  # keep their hyphen


def words_of(name: str) -> str:
    """A name such as "semi-implicit-euler" in words: "semi-implicit Euler"."""
    for joined in JOINED:
        name = name.replace(joined, joined.replace("-", "\N{NON-BREAKING HYPHEN}"))
    words = " ".join(PROPER.get(word, word) for word in name.split("-"))
    halves = [PROPER.get(half, half) for half in words.split("\N{NON-BREAKING HYPHEN}")]
    return "-".join(halves)


def titled(name: str) -> str:
    """A name in words, with a capital."""
    words = words_of(name)
    return words[:1].upper() + words[1:]
