"""What can be chosen about soft bodies and the table that finds their contacts."""

from __future__ import annotations

from game.stage import Choice, Param, Parameters, Toggle

GROUNDS = ("meshes", "cells", "table")
OF_PICTURE = ("view", "contacts", "strip")


class DeformablesParameters(Parameters):
    """The grid and its table, the bodies, the steps, and what is shown."""

    cell = Param(1.0, 0.05, 100.0, log=True, group="Detection", label="Cell size",
                 help="in mean lengths of the meshes' edges")  # fmt: skip
    table = Param(4001, 1, 2_000_000, whole=True, log=True, group="Detection", label="Table",
                  help="slots; any number, a prime or not")  # fmt: skip
    push = Param(0.5, 0.0, 1.0, group="Bodies", label="Push",
                 help="share of a depth that a substep takes away")  # fmt: skip
    friction = Param(0.3, 0.0, 2.0, group="Bodies", help="coefficient of Coulomb's law, between meshes")
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="Bodies", help="downwards")
    damping = Param(0.02, 0.0, 10.0, unit="N s/m", group="Bodies", help="against the motion of each vertex")
    substeps = Param(4, 1, 60, whole=True, group="Steps", help="parts of a step; contacts are found in each")
    iterations = Param(
        6, 1, 60, whole=True, group="Steps", help="sweeps over edges and outlines in a substep"
    )
    step_length = Param(1.0 / 60.0, 1.0 / 2000.0, 1.0 / 20.0, unit="s", log=True, group="Steps",
                        label="Time step")  # fmt: skip
    view = Choice("meshes", GROUNDS, labels=("Meshes", "Cells", "Cells by slot"), group="Shown",
                  label="Ground",
                  help="cells by how many vertices they have; or coloured by their slot")  # fmt: skip
    contacts = Toggle(True, group="Shown", help="vertices in triangles, edges that cross the rim, ways out")
    strip = Toggle(True, group="Shown", label="Hash table",
                   help="its slots from left to right, as high as their chains")  # fmt: skip
