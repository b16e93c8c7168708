"""What can be chosen about the cloth, the fire and the air."""

from __future__ import annotations

from game.stage import Choice, Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members.solids import choose_step
from game.worlds.quality import Quality

TOOLS = (
    Tool("match", "Match"), Tool("write", "Write"), Tool("wash", "Wash out"), Tool("water", "Wet"),
    Tool("drag", "Drag"), Tool("blow", "Blow"),
)  # fmt: skip
OF_PICTURE = ("marks", "view")
VIEWS = ("fire", "heat", "saltpetre", "gas")
QUALITY = Quality(56, 80, 112, "meshes of the cloth across")
WORDS = ("FIRE", "CAROM", "HEAT", "1952", "♥", "blank")


class BurningClothParameters(Parameters):
    """Tools, what is written, cloth, air, how finely it is computed, and what is shown."""

    tool = choose_tool(TOOLS)
    word = Choice(
        "FIRE", WORDS, labels=("FIRE", "CAROM", "HEAT", "1952", "A heart", "Nothing"), group="Cloth",
        label="Written", rebuild=True,
        help="with saltpetre; a level can have any word, and Write adds by hand",
    )  # fmt: skip
    retardant = Param(
        1.0, 0.0, 1.0, group="Cloth", label="Retardant",
        help="1: the plain cloth chars and resists; 0: bare cotton, which burns as well",
    )  # fmt: skip
    law = Choice(
        "ignition", ("ignition", "fisher"), labels=("From a temperature on", "Fisher's"), group="Cloth",
        label="Burns",
        help="from its ignition temperature on, or in proportion to its warmth, which is Fisher's equation",
    )  # fmt: skip
    wind = Param(
        0.0, -4.0, 4.0, unit="m/s", group="Air", label="Wind", help="to the right, and slantwise at the cloth"
    )
    tier = QUALITY.choose("teach", "Accuracy", "; the gas follows")
    meshes = Param(
        80, 16, 160, step=8, whole=True, group="Accuracy", rebuild=True, help="of the cloth across, with Own"
    )
    substeps = Param(8, 2, 32, whole=True, group="Accuracy", help="of the cloth's motion in a step")
    cycles = Param(4, 2, 20, whole=True, group="Accuracy", label="V-cycles", help="of the pressure in a step")
    step_length = choose_step(1.0 / 60.0, 1.0 / 480.0, 1.0 / 30.0, "Accuracy")
    view = Choice(
        "fire", VIEWS, labels=("As it looks", "Heat", "Saltpetre", "Gas"), group="Shown", label="Picture",
        help="as it looks, or what is measured of cloth and gas",
    )  # fmt: skip
    marks = Toggle(
        False, group="Shown", label="Threads", help="each mesh that holds, and how much it is stretched"
    )

    def meshes_now(self) -> int:
        """By the quality that is chosen."""
        return QUALITY.parts(self.tier, self.meshes)

    def cells_now(self) -> int:
        """Of the gas across, by the meshes of the cloth."""
        return max(16, 8 * round(0.15 * self.meshes_now()))
