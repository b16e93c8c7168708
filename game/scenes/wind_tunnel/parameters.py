"""What can be chosen about the tunnel, the measurement and the flight."""

from __future__ import annotations

from game.physics.tunnel import SHAPES
from game.physics.tunnel.tunnel import WALLS
from game.stage import Choice, Param, Parameters, Toggle

VIEWS = ("smoke", "vorticity", "pressure", "speed")
OF_PICTURE = ("view", "streaks", "forces", "box", "tool")
OF_MAKING = ("cells", "height", "walls")
OF_MEASURING = ("settle", "window", "angles", "checks", "symmetry")


class WindTunnelParameters(Parameters):
    """The shape, the wind, the grid, how it is measured, and how it flies."""

    tool = Choice("turn", ("turn", "draw"), labels=("Turn", "Draw"), group="Shape",
                  help="what a drag does; the right button draws in any case")  # fmt: skip
    shape = Choice(
        "aerofoil", (*SHAPES, "drawn"), group="Shape", help="in the wind; chord 1 m, or as it is drawn"
    )
    attack = Param(25.0, -180.0, 180.0, unit="°", group="Shape", label="Angle of attack",
                   help="how far its nose, at the left, is raised")  # fmt: skip
    reynolds = Param(300.0, 1.0, 2_000.0, log=True, group="Wind", label="Reynolds number",
                     help="wind times chord over viscosity")  # fmt: skip
    wind = Param(1.0, 0.0, 2.0, unit="m/s", group="Wind", help="from the left")
    cells = Param(12, 4, 48, whole=True, log=True, group="Grid", rebuild=True, help="of the grid, to a metre")
    height = Param(6.0, 1.5, 24.0, unit="m", log=True, group="Grid", rebuild=True, label="Height",
                   help="of the tunnel: a low one squeezes the wind past the shape")  # fmt: skip
    walls = Choice("slip", WALLS, group="Grid", rebuild=True,
                   help="below and above: the air slips, is let out, or sticks")  # fmt: skip
    courant = Param(0.8, 0.1, 10.0, log=True, group="Grid", label="Courant number",
                    help="cells that the wind moves in a step of the gas")  # fmt: skip
    pace = Param(2, 1, 16, whole=True, log=True, group="Grid", label="Steps at once",
                 help="of the gas in a step of the scene: how fast the tunnel runs")  # fmt: skip
    measure = Choice("book", ("book", "wall"), labels=("Momentum", "Wall"), group="Measured", label="Fitted",
                     help="what the curves are made of: momentum, or pressure and friction")  # fmt: skip
    settle = Param(8.0, 0.0, 200.0, unit="c/U", group="Measured", label="Settling",
                   help="time that is waited for after a turn, in chords that the wind goes")  # fmt: skip
    window = Param(12.0, 0.1, 400.0, unit="c/U", log=True, group="Measured", label="Averaged",
                   help="time over which an angle of a sweep is averaged")  # fmt: skip
    angles = Param(24, 4, 72, step=4, whole=True, group="Measured", help="of a whole turn, in a sweep")
    checks = Param(3, 0, 24, whole=True, group="Measured",
                   help="angles in between that are measured, and that no fit is given")  # fmt: skip
    symmetry = Toggle(True, group="Measured", label="Use symmetry",
                      help="what a shape's own symmetry says is not measured again")  # fmt: skip
    order = Param(6, 0, 16, whole=True, group="Measured", label="Order", help="of the Fourier series")
    inertia = Param(1.4, 1.02, 50.0, log=True, group="Flight", label="Inertia",
                    help="mass of what flies, over that of the air in a circle about its chord")  # fmt: skip
    half_chord = Param(0.05, 0.005, 0.5, unit="m", log=True, group="Flight", label="Half chord",
                       help="of what flies, by the coefficients of the tunnel's Reynolds number")  # fmt: skip
    view = Choice("vorticity", VIEWS, group="Shown", label="Air")
    streaks = Toggle(True, group="Shown", help="smoke from nozzles across the inflow")
    forces = Toggle(True, group="Shown", help="drag, lift and moment, as means")
    box = Toggle(False, group="Shown", label="Momentum box", help="over whose sides momentum is booked")
