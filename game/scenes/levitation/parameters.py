"""What can be chosen about grains in a sound field."""

from __future__ import annotations

from game.physics.acoustics import FIGURES
from game.physics.acoustics.array import PATTERNS
from game.stage import Choice, Param, Parameters, Toggle

VIEWS = ("pressure", "wave", "potential", "nothing")
OF_PICTURE = ("view", "trails", "forces")


class LevitationParameters(Parameters):
    """The figure, the sound, the grains, the steps, and what is shown."""

    figure = Choice("circle", tuple(FIGURES), group="Figure", help="that the focus is led along")
    size = Param(0.02, 0.002, 0.06, unit="m", log=True, group="Figure", help="half its width")
    speed = Param(
        0.2, 0.0, 5.0, unit="m/s", group="Figure",
        help="of the focus, once it is up to it; also the fastest that it follows the hand",
    )  # fmt: skip
    acceleration = Param(1.0, 0.01, 100.0, unit="m/s²", log=True, group="Figure", help="of the focus")
    rows = Choice("2", ("2", "4"), labels=("Below and above", "All around"), group="Sound", rebuild=True,
                  label="Transducers")  # fmt: skip
    pattern = Choice(
        "focus", PATTERNS, labels=("Focus", "Plane waves"), group="Sound",
        help="phases for one place, or the same for all of a row",
    )  # fmt: skip
    strength = Param(
        10.0, 0.0, 40.0, unit="Pa m", group="Sound",
        help="pressure times distance of each transducer of the plane, which stands for a column of them",
    )  # fmt: skip
    radius = Param(0.6e-3, 0.05e-3, 2.1e-3, unit="m", log=True, group="Grains", help="of the grains")
    density = Param(29.0, 1.0, 20_000.0, unit="kg/m³", log=True, group="Grains",
                    help="expanded polystyrene 29, water 1000, steel 7800")  # fmt: skip
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="Grains", help="downwards")
    substeps = Param(16, 1, 256, whole=True, log=True, group="Steps",
                     help="parts of a step; in each the phases follow the focus")  # fmt: skip
    step_length = Param(1.0 / 240.0, 1.0 / 2000.0, 1.0 / 30.0, unit="s", log=True, group="Steps",
                        label="Time step")  # fmt: skip
    view = Choice("pressure", VIEWS, group="Shown", label="Field",
                  help="amplitude of the pressure, the wave slowed down, or the potential")  # fmt: skip
    trails = Toggle(True, group="Shown", help="the way that the grains have made")
    forces = Toggle(False, group="Shown", help="of the sound on each grain")
