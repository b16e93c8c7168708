"""What is said of a scene that was stopped."""

from __future__ import annotations

from typing import NamedTuple

LONGEST = 300  # characters of what an exception says


class Fault(NamedTuple):
    """Why a scene was stopped: the quantity that went wrong, the step that did it, and a line to show.

    ``error`` is the exception, if the scene raised one; ``quantity`` is then its type's name.
    """

    quantity: str
    step: int
    message: str
    error: Exception | None = None


def fault_at(step: int, quantity: str, error: Exception | None) -> Fault:
    """A quantity that is not finite at a step, or an exception that the step raised."""
    if error is None:
        return Fault(quantity, step, f"{quantity} is not finite at step {step}")
    return Fault(quantity, step, f"step {step} failed: {quantity}: {_said(error)}", error)


def fault_in(step: int, what: str, error: Exception) -> Fault:
    """Something asked of a scene at a step, its readouts say, that raised an exception."""
    kind = type(error).__name__
    return Fault(what, step, f"{what} failed at step {step}: {kind}: {_said(error)}", error)


def _said(error: Exception) -> str:
    """What an exception says, in a line."""
    return (" ".join(str(error).split()) or "no reason given")[:LONGEST]
