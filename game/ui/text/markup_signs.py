"""Signs of formulas: what letters, operators and named functions look like and how they are spaced.

Each becomes a node ("symbol", text, face, class) or ("space", em) of the tree in markup.py.
"""

from __future__ import annotations

from typing import Any

Node = tuple[Any, ...]

_GREEK_NAMES = (
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
    "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
)  # fmt: skip
_GREEK = dict(zip(_GREEK_NAMES, "αβγδεζηθικλμνξπρστυϕχψω", strict=True))
_CAPITAL_NAMES = ("Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega")
_GREEK_CAPITALS = dict(zip(_CAPITAL_NAMES, "ΓΔΘΛΞΠΣΦΨΩ", strict=True))
_RELATIONS = {
    "=": "=", "<": "<", ">": ">", "le": "≤", "ge": "≥", "ne": "≠", "approx": "≈", "propto": "∝", "to": "→",
    "gets": "←", "in": "∈", "equiv": "≡", "ll": "≪", "gg": "≫", "sim": "∼", "perp": "⊥", "parallel": "∥",
    "Rightarrow": "⇒", ":": ":",
}  # fmt: skip
_OPERATORS = {
    "+": "+", "-": "−", "−": "−", "cdot": "·", "times": "×", "pm": "±", "mp": "∓", "*": "∗", "otimes": "⊗",
    "oplus": "⊕", "ominus": "⊖", "circ": "∘", "wedge": "∧",
}  # fmt: skip
_SIGNS = {
    "partial": "∂", "nabla": "∇", "infty": "∞", "ldots": "…", "prime": "′", "degree": "°", "ell": "ℓ",
    "dagger": "†", "T": "⊤", "half": "½", "percent": "%", "{": "{", "}": "}", "angle": "∠", "hbar": "ℏ",
}  # fmt: skip
_LARGE = {"sum": "∑", "prod": "∏", "int": "∫"}
_FUNCTIONS = frozenset((
    "sin", "cos", "tan", "atan2", "arctan", "arccos", "exp", "log", "ln", "min", "max", "sign", "det", "tr",
    "arg", "floor", "ceil", "mod",
))  # fmt: skip
ACCENTS = frozenset(("dot", "ddot", "hat", "bar", "tilde"))
_SPACES = {",": 1 / 6, ";": 5 / 18, "!": -1 / 6, " ": 0.25, "quad": 1.0}
_OPEN, _CLOSE = frozenset("([{⟨"), frozenset(")]}⟩")


def sign_of(c: str) -> Node:
    """The symbol of one character."""
    if c in _RELATIONS:
        return ("symbol", _RELATIONS[c], "formula", "relation")
    if c in _OPERATORS:
        return ("symbol", _OPERATORS[c], "formula", "operator")
    if c == "'":
        return ("symbol", "′", "formula", "ordinary")
    if c in ",;":
        return ("symbol", c, "formula", "punctuation")
    if c in _OPEN:
        return ("symbol", c, "formula", "open")
    if c in _CLOSE:
        return ("symbol", c, "formula", "close")
    return ("symbol", c, "formula-italic" if c.isalpha() else "formula", "ordinary")


def known_signs() -> frozenset[str]:
    """All names that `named_sign` knows."""
    tables = (_GREEK, _GREEK_CAPITALS, _RELATIONS, _OPERATORS, _SIGNS, _LARGE, _FUNCTIONS, _SPACES)
    return frozenset().union(*tables)


def named_sign(name: str) -> Node | None:
    """A sign, letter, function or space by its name."""
    if name in _GREEK:
        return ("symbol", _GREEK[name], "formula-italic", "ordinary")
    if name in _FUNCTIONS:
        return ("symbol", name, "formula", "function")
    if name in _SPACES:
        return ("space", _SPACES[name])
    for table, kind in (
        (_GREEK_CAPITALS, "ordinary"), (_RELATIONS, "relation"), (_OPERATORS, "operator"),
        (_SIGNS, "ordinary"), (_LARGE, "large"),
    ):  # fmt: skip
        if name in table:
            return ("symbol", table[name], "formula", kind)
    return None
