"""What a level expects of a readout, beside what is measured: one line each, for as long as one looks."""

from __future__ import annotations

from typing import NamedTuple

from game.scenes.spheres.model import CollisionModel
from game.scenes.spheres.readouts import readouts_of
from game.ui.look.numerals import format_si


class Caption(NamedTuple):
    """Words, and whether what is measured is as expected."""

    words: str
    met: bool


def captions_of(model: CollisionModel) -> list[Caption]:
    """One caption for each expectation of the content. ValueError, naming it, if there is no such readout."""
    if not model.content.expected:
        return []
    measured = {readout.name: readout for readout in readouts_of(model)}
    found = []
    for i, entry in enumerate(model.content.expected):
        if entry.readout not in measured:
            known = ", ".join(measured)
            raise ValueError(f"expected[{i}].readout: no readout {entry.readout!r}; there are {known}")
        _, value, unit = measured[entry.readout]
        met = abs(value - entry.value) <= entry.within
        shown = entry.value if met else value  # no figures of rounding
        expected, now = format_si(entry.value, unit), format_si(shown, unit)
        found.append(Caption(f"{entry.readout}: expected {expected}, measured {now}", met))
    return found
