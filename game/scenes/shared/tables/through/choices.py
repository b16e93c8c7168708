"""What can be chosen of a stroke by the hand, and of the tip, declared once for every cue table."""

from __future__ import annotations

from game.stage import Choice, Param, Toggle
from game.stage.declarations import StartLine

RELEASE, PUSH = STROKES = ("release", "push")
STROKE_LABELS = ("Pull and let go", "Push through")
AUTO, ON, OFF = MISCUES = ("auto", "on", "off")


def stroke_by() -> Choice:
    """How a stroke is made with the pointer."""
    return Choice(
        RELEASE, STROKES, labels=STROKE_LABELS, group="Stroke", label="Your stroke",
        help="let go of the cue, or push it through the ball as fast as the pointer goes",
    )  # fmt: skip


def reach() -> Param:
    """How far the cue goes for a metre of the pointer on the table."""
    return Param(
        1.0, 0.25, 4.0, log=True, group="Stroke", label="Cue per pointer",
        help="how far a pushed cue goes for the pointer's path on the table",
    )  # fmt: skip


def sway() -> Param:
    """How far the aim of a pushed stroke sways, degrees."""
    return Param(
        0.15, 0.0, 1.0, unit="°", group="Stroke", label="Sway of the aim",
        help="of a stroke that is pushed; a steadying breath makes it smaller",
    )  # fmt: skip


def miscues() -> Choice:
    """Whether a tip that strikes too far out slips."""
    return Choice(
        AUTO, MISCUES, labels=("With a pushed stroke", "Always", "Never"), group="Stroke", label="Miscues",
        help="the tip slips where it strikes farther out than its friction holds",
    )  # fmt: skip


def chalk() -> Param:
    """Coefficient of friction of tip and ball."""
    return Param(
        0.65, 0.1, 1.0, group="Stroke", label="Friction of the tip",
        help="with chalk 0.6 to 0.7: it holds up to about half a radius from the middle",
    )  # fmt: skip


def wear() -> Toggle:
    """Whether the friction of the tip falls from stroke to stroke, until it is chalked again."""
    return Toggle(
        False, group="Stroke", label="Chalk wears off",
        help="the tip holds less far out with each stroke, until you chalk it (key slash)",
    )  # fmt: skip


def recoil() -> Toggle:
    """Whether the picture gives way a little as a person strikes."""
    return Toggle(
        True, group="Stroke", label="Recoil of the picture", help="as you strike; it changes no ball"
    )


START_LINE = StartLine(
    "stroke_by", "Your stroke", "how the cue is moved", tuple(zip(STROKES, STROKE_LABELS, strict=True)),
    RELEASE,
)  # fmt: skip
