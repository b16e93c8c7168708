"""What can be chosen about balls on tracks."""

from __future__ import annotations

from game.stage import Choice, Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("hand", "Move a ball", "move", "", "G", "grab"),
    Tool("select", "Select", "select", "click a ball to see and change what is its own", "V", "select"),
    Tool("ball", "New ball", "new ball", "click, drag and let go: a new ball", "N", "ball", apart=True),
    Tool("draw", "Draw a track", "draw a track", "draw a track", "D", "track"),
    Tool("bend", "Bend a track", "bend a track", "drag a track", "B", "bend"),
    Tool("delete", "Delete", "delete", "click a ball or a track", "E", "delete", apart=True),
)
FORMS = ("disc", "sphere", "ring")
COLOURS = ("chalk", "green", "vermilion", "pink", "violet", "yellow", "amber")
OF_CHOSEN = ("own_mass", "own_friction", "own_restitution", "own_colour")  # say and set what is clicked
CHOSEN = "Chosen ball"  # group of the parameters on the card
OF_TOOLS = ("radius", "form", "bending")
OF_PICTURE = ("velocities", "trails", "points")


class TrackParameters(Parameters):
    """Tools, balls, steps, and what is shown."""

    tool = choose_tool(TOOLS)
    form = Choice("disc", FORMS, group="Tools", label="New ball", help="I = ½, ⅖ or 1 times m r²")
    radius = Param(0.1, 0.01, 2.0, unit="m", log=True, group="Tools", help="of a new ball")
    bending = Param(
        0.6, 0.05, 5.0, unit="m", log=True, group="Tools", help="how far along a track a bend reaches"
    )
    own_mass = Param(
        1.0, 1e-3, 1e3, unit="kg", log=True, group=CHOSEN, label="Mass", help="of the chosen ball",
        in_panel=False,
    )  # fmt: skip
    own_friction = Param(
        0.6, 0.0, 5.0, group=CHOSEN, label="Friction", help="of the chosen ball", in_panel=False
    )
    own_restitution = Param(
        0.0, 0.0, 1.0, group=CHOSEN, label="Restitution", help="of the chosen ball", in_panel=False
    )
    own_colour = Choice(
        COLOURS[0], COLOURS, group=CHOSEN, label="Colour", help="of the chosen ball", in_panel=False
    )
    friction = Param(
        0.6, 0.0, 5.0, group="World", help="Coulomb's coefficient, of balls without one of their own"
    )
    restitution = Param(0.0, 0.0, 1.0, group="World", help="part of the speed of an impact that comes back")
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    again = Toggle(
        True, group="World", label="Balls come back",
        help="a ball that has flown out of view begins again where it began",
    )  # fmt: skip
    tier = solids.choose_quality("Steps")
    substeps = solids.choose_substeps(64, "Steps")
    step_length = solids.choose_step(1.0 / 120.0, 1.0 / 2000.0, 1.0 / 20.0, "Steps")
    chords = Param(
        0, 0, 800, whole=True, group="Steps", rebuild=True,
        help="tracks of a formula go through so many points; 0: as many as the level says",
    )  # fmt: skip
    velocities = Toggle(False, group="Shown", label="Velocities")
    trails = Toggle(True, group="Shown", label="Trails")
    points = Toggle(False, group="Shown", label="Points", help="that the smooth curves go through")
