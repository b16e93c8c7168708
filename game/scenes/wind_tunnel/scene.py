"""P16: a wind tunnel in which the air's forces on any shape are measured, fitted, and flown by."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from game.lab.studies.flow.wind_tunnel import drag_study
from game.physics.tunnel import SHAPES, TUNNEL
from game.scenes.wind_tunnel import WIND_TUNNEL
from game.scenes.wind_tunnel.figure import draw_forces
from game.scenes.wind_tunnel.hand import WindTunnelHand
from game.scenes.wind_tunnel.layout import layout_of
from game.scenes.wind_tunnel.level import DEFAULT, WindTunnelContent
from game.scenes.wind_tunnel.model import WindTunnelModel
from game.scenes.wind_tunnel.parameters import OF_MAKING, OF_PICTURE, WindTunnelParameters
from game.scenes.wind_tunnel.readouts import readouts_of
from game.scenes.wind_tunnel.view import WindTunnelView
from game.scenes.wind_tunnel.warming import warm_up
from game.stage import Equation, Frame, Hint, SceneAction, Strip, WarmUp
from game.worlds.expectations import with_headroom
from game.worlds.scene import ModelScene, Told


class WindTunnel(ModelScene):
    """A shape stands in the wind. What the air does to it is measured twice at every moment: by pressure
    and friction along its outline, and by the book of momentum, what flows into a box around it less what
    flows out. It is one force: at the wall it is read in the few cells that the outline cuts, so the two come
    together with more cells along the chord. Draw a shape of your own, or choose one, and turn it.

    A sweep turns it round, angle by angle, and averages drag, lift and moment of each. A Fourier series is
    fitted to them, and the plates' law as far as it can be. Then both fly beside the law as it is.

    In the equations: U wind, c chord, ρ density, F force and M moment (nose up) on the shape, u flow, p
    pressure, τ friction, n normal outwards, P momentum in a box around it, α angle of attack, A, B, C_T
    coefficients of the plates' law, a, b coefficients of the series.
    """

    name, task, title = WIND_TUNNEL.names
    parameters_type = WindTunnelParameters
    parameters: WindTunnelParameters
    model: WindTunnelModel
    effects = TUNNEL.known
    content_type = WindTunnelContent
    told = Told(readouts_of)
    not_of_model = (*OF_PICTURE, *OF_MAKING)
    covers = True
    builds = True
    default_content = DEFAULT
    study = drag_study
    dt = 1.0 / 60.0
    takes: ClassVar[frozenset[str]] = frozenset(("right",))
    legend_in_panel = True
    figure = staticmethod(draw_forces)
    hints = (Hint(("Drag",), "turn the shape"), Hint(("Right drag",), "draw another"))
    actions = (
        SceneAction("sweep", "Sweep the angle", "s"),
        SceneAction("stop", "Stop the sweep", "x"),
        SceneAction("fly", "Let it fly again", "f"),
        SceneAction("next-shape", "Next shape", "n"),
    )
    strips = (
        Strip("Drag and lift", "", ("drag now", "lift now"), colors=("vermilion", "green")),
        Strip("Drag, both ways", "", ("drag", "drag, wall")),
        Strip("Fall", "m/s", ("by its law", "by the fit", "as measured")),
    )
    equations = (
        Equation(
            "Coefficients",
            r"C_D = \frac{2 F_x}{\rho U^2 c}, C_L = \frac{2 F_y}{\rho U^2 c}, "
            r"C_M = \frac{2 M}{\rho U^2 c^2}",
        ),
        Equation("Along the wall", r"\v{F} = \int (\tau - p \v{n})", "pressure and friction"),
        Equation(
            "Momentum book",
            r"\v{F} = - \dot{\v{P}} - \int (\v{u} u_n + p \v{n} - \tau)",
            "over the sides of a box",
        ),
        Equation(
            "Series",
            r"C = a_0 + \sum a_k \cos k \alpha + b_k \sin k \alpha",
            "as Martin, Umetani and Bickel 2015, in the plane",
        ),
        Equation(
            "Plates' law",
            r"C_D = A - B \cos 2 \alpha, C_L = C_T \sin 2 \alpha",
            "Andersen, Pesavento and Wang 2005",
        ),
    )
    try_this = (
        "Draw a shape with the right button, press S, and watch it fly when the sweep is done.",
        "Turn a plate from flat to upright: the lift rises, breaks down, and the wake begins to beat.",
        "Open the channel: drag and lift of the benchmark of Schäfer and Turek, with its own walls.",
        "Halve the height of the tunnel: the squeezed wind drags harder.",
        "Lower Order to 2, and see what the series loses at the amber checks.",
    )

    def make(self, content: WindTunnelContent) -> None:
        self.model = WindTunnelModel(content, self.parameters, self.active)
        self.said = self.model.said
        self.hand = WindTunnelHand(self.model)
        self.view = WindTunnelView(self.model, self.hand)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (WarmUp(cls.name, lambda: cls().advance(cls.dt)), WarmUp("fit and flight", warm_up))

    def why_idle(self, name: str) -> str:
        if name == "attack" and self.model.sweep.running:
            return "The sweep turns it."
        return ""

    def save_content(self) -> WindTunnelContent:
        made = self.model.tunnel.outline
        own = self.parameters.shape == "drawn"
        corners = tuple((float(x), float(y)) for x, y in made.corners.tolist()) if own else ()
        content = self.model.content
        return WindTunnelContent(
            width=content.width, at=content.at, profile=content.profile, nudge=content.nudge,
            outline=corners, sweep=self.model.sweep.running, expected=content.expected,
        )  # fmt: skip

    def action(self, name: str) -> None:
        model = self.model
        if name == "sweep":
            model.begin_sweep()
        elif name == "stop" and model.sweep.running:
            model.stop_sweep()
        elif name == "fly":
            model.launch()
        elif name == "next-shape":
            at = SHAPES.index(self.parameters.shape) if self.parameters.shape in SHAPES else -1
            self.parameters.shape = SHAPES[(at + 1) % len(SHAPES)]
            model.change_parameter("shape")

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return (
            ("line:vermilion", "drag", ""),
            ("line:green", "lift", ""),
            ("line:violet", "moment, nose up", ""),
            ("ring:amber", "not given to the fit; or here", ""),
        )

    def frame(self) -> Frame:
        return with_headroom(layout_of(self.model).whole, len(self.model.content.expected))
