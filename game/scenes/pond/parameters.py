"""Controls of the pond, and the tools of the hand."""

from __future__ import annotations

from game.physics.waves.floats import FloatSettings
from game.physics.waves.wave_particles import WaveSettings
from game.stage import Choice, Param, Parameters, Toggle, control_of
from game.worlds.hands.hand import Tool, choose_tool

TOOLS = (
    Tool("drop", "Drop", "drop", "click to drop a stone, drag for a row of them", "O", "pour"),
    Tool("boat", "Boat", "boat", "drag: the boat follows", "B", "push"),
    Tool("float", "Float", "float", "click to put a float, drag one away", "F", "ball"),
)
RADII = (0.15, 0.25, 0.45)  # m
SIZES = ("short", "middling", "long")
OF_PICTURE = ("tool", "dots", "law")


class PondParameters(Parameters):
    """The pond, what falls into it, the method, and what is shown."""

    tool = choose_tool(TOOLS)
    waves = Choice("middling", SIZES, group="Waves", help="length of those that come: 30, 50 or 90 cm")
    stone = Param(0.05, 0.005, 0.3, unit="m", log=True, group="Waves", help="first crest of what is dropped")
    rain = Param(0.0, 0.0, 60.0, unit="1/s", group="Waves", help="drops that fall on all of it")
    depth = control_of(WaveSettings, "depth", group="Pond", log=True)
    gravity = control_of(WaveSettings, "gravity", group="Pond")
    fading = control_of(WaveSettings, "fading", group="Pond")
    density = Param(0.5, 0.02, 4.0, log=True, group="Floats", help="of the next one; water has 1")
    radius = Param(0.2, 0.03, 1.0, unit="m", log=True, group="Floats", help="of the next one")
    drag = control_of(FloatSettings, "drag", group="Floats")
    heave = control_of(FloatSettings, "heave", group="Floats")
    keeps = control_of(
        WaveSettings, "keeps", labels=("Height (as printed)", "Energy"), group="Method", label="A front keeps"
    )
    spacing = control_of(WaveSettings, "spacing", group="Method", label="Divides at", log=True)
    lowest = control_of(WaveSettings, "lowest", group="Method", label="Left out below")
    most = Param(100_000, 100, 200_000, whole=True, log=True, group="Method", label="At most", rebuild=True,
                 help="particles")  # fmt: skip
    cell = Param(0.05, 0.02, 0.15, unit="m", log=True, group="Method", rebuild=True,
                 help="of the grid on which heights add up")  # fmt: skip
    dots = Toggle(False, group="Shown", label="Particles", help="red ones are crests, blue ones troughs")
    law = Toggle(True, group="Shown", help="the ring, or the wedge, by theory")
