"""Leaves in a wind: a story in a park, and a place to blow leaves about."""

from __future__ import annotations

from game.lab.studies.plates import leaf_study
from game.physics.plates.effects import PLATES
from game.scenes.leaves import A18
from game.scenes.leaves.figure import draw_gust
from game.scenes.leaves.hand import leaves_hand
from game.scenes.leaves.level import DEFAULT, LeavesContent
from game.scenes.leaves.model import LeavesModel
from game.scenes.leaves.parameters import OF_PICTURE, LeavesParameters
from game.scenes.leaves.told import hearing, names, readouts, sizes, targets
from game.scenes.leaves.view import LeavesView
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import Parts, Told, WorldScene


class Leaves(WorldScene):
    """Leaves lie on the lawn of a park. A small wind takes them up, and each comes down as its shape asks:
    light broad ones swing, stiff ones turn over and over, those with their weight at one end glide. In the
    end most of them are in the litter basket.

    Each leaf is a plate in air by the law of Andersen, Pesavento and Wang (2005), with halves that bend about
    the midrib. The wind is given by formulas: gusts that come, go and travel. It is taken relative to each
    leaf, and as it changes it pushes by the air that a leaf takes along. Leaves lie on the ground and on one
    another with friction.

    In the equations: ψ stream function of a gust, S its wind, L its size, T how long it lasts, v velocity
    of a leaf, w of the wind, u through the air, q bend, σ stiffness, C_T lift.
    """

    name, task, title = A18.names
    parameters_type = LeavesParameters
    parameters: LeavesParameters
    model: LeavesModel
    parts = Parts(LeavesModel, leaves_hand, LeavesView)
    told = Told(readouts, targets=targets, hearing=hearing, sizes=sizes, names=names)
    painters = (("polygons", warm_up_painter),)
    effects = PLATES.known
    content_type = LeavesContent
    not_of_model = OF_PICTURE
    default_content = DEFAULT
    study = leaf_study
    legend_in_panel = True
    figure = staticmethod(draw_gust)
    hints = (Hint(("Drag",), "draw a gust"), Hint(("Right click",), "drop a leaf"))
    actions = (SceneAction("whirl", "A gust from below", "b"), SceneAction("calm", "No gusts", "n"))
    strips = (
        Strip("Leaves", "", ("in the air", "in the basket")),
        Strip("Wind at leaves", "m/s", ("wind at leaves",)),
        Strip(
            "Descent",
            "m/s",
            ("descent", "broadside"),
            exact=("broadside",),
            sometimes=("descent", "broadside"),
        ),
    )
    equations = (
        Equation(
            "A gust",
            r"\psi = (S_x y - S_y x) e^{-(x^2 + y^2) / 2 L^2} \sin^2 (\pi t / T)",
            "no divergence",
        ),
        Equation("Through the air", r"\v{u} = \v{v} - \v{w}"),
        Equation(
            "Changing wind",
            r"\v{g} - \dot{\v{w}}",
            "in place of gravity: Maxey and Riley 1983",
        ),
        Equation("Bend", r"\ddot{q} = -\sigma^2 q", "and what the air does to each half"),
        Equation("Lift", r"C_L = C_T \sin 2 \alpha", "Andersen, Pesavento and Wang 2005"),
    )
    try_this = (
        "Draw a gust along the lawn, slowly upwards at its end.",
        "Make all leaves a little heavier: those that turned over begin to swing, irregularly.",
        "Move the balance: with their mass at one end all of them glide.",
        "Curl them by half a radian more: they come down like parachutes.",
        "Switch off gust inertia: leaves lag behind each gust.",
        "Press F7 in the story for the wind, and the map with a dot for each leaf.",
    )

    def do(self, name: str) -> str:
        if name == "whirl":
            x, _ = self.model.cloud()
            self.model.blow((x, 0.35), (0.02, 0.9))
        else:
            self.model.gusts.take(self.model.wind.gusts[:0])
        return ""
