"""The parameters of the rigid body: its method, its material, the hand, its world, and what is shown."""

from __future__ import annotations

from game.physics.rigid import METHODS
from game.physics.rigid.window import WALLS
from game.scenes.rigid_body.camera import HOME
from game.stage import Choice, Param, Parameters, Toggle

LABELS = (
    "Explicit Euler", "Semi-implicit Euler", "Exponential map", "Midpoint", "Runge-Kutta 4",
    "Implicit gyroscopic", "Splitting", "Exact (Jacobi)", "Euler of ω, body frame", "Euler of ω, world frame",
)  # fmt: skip
TOOLS = ("push", "sphere", "remove")
SHOWN_ONLY = ("turn", "tilt", "vectors", "axes", "ghost", "momentum_sphere", "tool", "pushing", "new_density")


class RigidBodyParameters(Parameters):
    """What of the body, and of how it is seen, can be chosen."""

    method = Choice(
        METHODS[0], METHODS, labels=LABELS, group="Method", label="Integrator",
        help="how position, quaternion and momenta are advanced by a step",
    )  # fmt: skip
    step_length = Param(1.0 / 60.0, 1.0 / 2000.0, 0.1, unit="s", log=True, group="Method", label="Time step")
    normalizing = Toggle(
        True, group="Method", label="Normalize q", help="bring |q| back to 1 after each step"
    )
    twin = Toggle(False, group="Method", label="Twin view", rebuild=True, help="two methods side by side")
    second = Choice(
        "splitting", METHODS, labels=LABELS, group="Method", label="Integrator of B", help="in the twin view"
    )
    density = Param(
        700.0,
        1.0,
        20_000.0,
        unit="kg/m³",
        log=True,
        group="Body",
        help="of the material; mass and inertia follow",
    )
    keep = Choice(
        "momentum", ("momentum", "velocity"), labels=("Momenta", "Velocities"), group="Body",
        label="New density keeps", help="what goes on as it was when the density is changed",
    )  # fmt: skip
    tool = Choice(
        "push", TOOLS, labels=("Push", "New sphere", "Remove"), group="Hand",
        help="what the left button does",
    )  # fmt: skip
    pushing = Choice(
        "release", ("release", "hold"), labels=("Let go", "While held"), group="Hand", label="Push when",
        help="a force that is drawn and then let go, or a pull as long as the button is down",
    )  # fmt: skip
    strength = Param(
        2_000.0, 1.0, 1e6, unit="N/m", log=True, group="Hand", help="force for each metre of the arrow drawn"
    )
    push_time = Param(0.1, 0.001, 2.0, unit="s", log=True, group="Hand", help="how long a drawn force acts")
    new_density = Param(
        1.0, 0.01, 100.0, log=True, group="Hand", label="New sphere", help="density over that of the material"
    )
    wall = Choice(
        "mirror", WALLS, labels=("Mirror", "Strike"), group="World", label="Window",
        help="mirrors the velocity; or strikes the point of contact, so that the spin changes",
    )  # fmt: skip
    restitution = Param(1.0, 0.0, 1.0, group="World", help="speed after the window over speed before")
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    damping = Param(0.2, 0.0, 20.0, unit="1/s", group="World", help="share of both momenta lost to the air")
    turn = Param(
        HOME[0],
        -180.0,
        180.0,
        unit="°",
        group="View",
        label="Azimuth",
        help="of the camera, about the vertical",
    )
    tilt = Param(
        HOME[1],
        -90.0,
        90.0,
        unit="°",
        group="View",
        label="Elevation",
        help="of the camera: from above if above 0",
    )
    ghost = Toggle(True, group="View", label="Exact body", help="outline of the exact solution")
    vectors = Toggle(True, group="View", label="Vectors", help="f, v, a, P, and ω, L of the turning")
    axes = Toggle(False, group="View", label="Principal axes", help="1, 2, 3 by ascending moment")
    momentum_sphere = Toggle(True, group="View", label="Sphere of L", help="L as the body sees it")
