"""C03: a chain of bones is taken to a target, by six methods side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from game.lab.studies.animation.inverse_kinematics import reaching_study
from game.scenes.skeletons import C03
from game.scenes.skeletons.base import EDITING, FigureScene, warm_ups_of_figures
from game.scenes.skeletons.cells import frame_of_cells
from game.scenes.skeletons.figure import draw_ccd
from game.scenes.skeletons.hand import ReachingHand
from game.scenes.skeletons.level import BoneEntry, ChainEntry, FigureContent, PathEntry, View
from game.scenes.skeletons.parameters import ReachingParameters
from game.scenes.skeletons.reaching_model import ReachingModel
from game.scenes.skeletons.readouts import NAMES, readouts_of_methods
from game.scenes.skeletons.view.chain import ChainView
from game.stage import Equation, Frame, Hint, SceneAction, Strip, WarmUp


class InverseKinematics(FigureScene):
    """Pull the end of a chain of bones: the joints find angles by which it gets there. Six methods solve the
    same target, each from its own last pose and with so many iterations in each step. Each figure says how
    many it took, what error is left, and the time. Some microseconds of that are the call from Python.

    The gradient turns each joint a little in the direction that helps. With a fixed step it needs hundreds of
    iterations; with Buss's step, or a line search, a tenth of them. Damped least squares solves for all
    joints at once, and damps as much as it must. Cyclic coordinate descent points joint by joint, FABRIK
    pulls points along the chain.

    A target out of reach is met by a straight chain, without shaking. A straight chain with its target on
    its axis is a dead point, where every gradient is zero: it is kicked. With joint limits all six may stop
    short of a target that another pose would reach: turn the joints by hand, and they begin from there.

    In the equations: θ angles of the joints, p joints with the last of them the chain's end, t target, e the
    error, J how the end moves as each joint turns, α step, s the change of the angles, c 0.0001, λ damping,
    l lengths of the bones and L their sum.
    """

    name, task, title = C03.names
    parameters_type = ReachingParameters
    parameters: ReachingParameters
    model: ReachingModel
    study = reaching_study

    strips = (
        Strip("Error", "m", NAMES),
        Strip("Iterations", "", tuple(f"{name} iterations" for name in NAMES)),
        Strip("Time", "s", tuple(f"{name} time" for name in NAMES)),
    )
    told = FigureScene.told._replace(readouts=readouts_of_methods)
    figure = staticmethod(draw_ccd)
    equations = (
        Equation("Error", r"\v{e} = \v{t} - \v{p}_n(\theta)", "target and end of the chain"),
        Equation(
            "Gradient",
            r"\Delta\theta_i = \alpha (J^T e)_i = \alpha (\v{p}_n - \v{p}_i) \times \v{e}",
            "J: how the end moves as each joint turns",
        ),
        Equation("Buss's step", r"\alpha = \frac{e · J J^T e}{|J J^T e|^2}", "Buss 2004"),
        Equation(
            "Armijo's step",
            r"|\v{e}(\theta + \v{s})|^2 \le |\v{e}|^2 - \frac{2c}{\alpha}|\v{s}|^2,  \v{s} = \alpha J^T e",
            "halved until it holds; Armijo 1966",
        ),
        Equation(
            "Damped least squares",
            r"\Delta\theta = J^T (J J^T + \lambda^2)^{-1} e",
            "λ: damping; Wampler 1986",
        ),
        Equation(
            "CCD",
            r"\Delta\theta_i = \angle(\v{p}_n - \v{p}_i, \v{t} - \v{p}_i),  i = n - 1, \ldots, 0",
            "Wang and Chen 1991",
        ),
        Equation(
            "FABRIK",
            r"\v{p}_i \gets \v{p}_{i+1} + l_i \frac{\v{p}_i - \v{p}_{i+1}}{|\v{p}_i - \v{p}_{i+1}|}",
            "from the tip, then from the root; Aristidou and Lasenby 2011",
        ),
        Equation(
            "Reach",
            r"\max(0, 2 l_{max} - L) \le |\v{t}| \le L,  L = \sum l_i",
            "l: lengths of the bones; without limits",
        ),
    )
    try_this = (
        "Pull the target out of reach and around: nothing shakes. Let damping be fixed: it thrashes.",
        "One iteration a step: who follows your hand?",
        "Show the Jacobian of one figure alone: which joint is asked to turn most, and which cannot help?",
        "Set the gradient's step to 2.1 and stretch the chain.",
        "Switch joint limits off: elbows bend the wrong way.",
        "Open the dead point: what happens first?",
    )
    hints = (
        Hint(("Drag",), "pull the target"),
        Hint(("1", "2", "3", "4", "5"), "pull, turn, bone, chain, skin"),
        Hint(("C",), "all or one"),
        Hint(("M",), "motion"),
        Hint(("Ctrl+Z",), "undo"),
    )
    actions = (
        SceneAction("pull", "pull the target", "1"),
        SceneAction("pose", "turn a bone", "2"),
        SceneAction("bone", "new bone", "3"),
        SceneAction("chain", "pick a chain", "4"),
        SceneAction("skin", "draw a skin", "5"),
        *EDITING,
        SceneAction("compare-all", "all or one", "c"),
    )
    default_content: ClassVar[FigureContent] = FigureContent(
        bones=tuple(
            BoneEntry(name=f"bone {i + 1}", parent=f"bone {i}" if i else "", length=0.3, angle=20.0)
            for i in range(6)
        ),
        chain=ChainEntry(
            start="bone 1",
            end="bone 6",
            target=(0.6, 0.8),
            path=PathEntry(centre=(0.6, 0.8), reach=(0.6, 0.4)),
        ),
        view=View(left=-1.0, bottom=-0.6, right=2.0, top=2.0),
    )

    # -- building and events ------------------------------------------------------------------------

    def make(self, content: FigureContent) -> None:
        self.model = ReachingModel(self.parameters, self.active, content)
        self.said = self.model.messages
        self.hand = ReachingHand(self.model)
        self.view = ChainView(self.model)

    def parameter_changed(self, name: str) -> None:
        if name == "method":
            self.model.stand_as_chosen()
        else:
            super().parameter_changed(name)

    # -- what there is to see -----------------------------------------------------------------------

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return ()

    def frame(self) -> Frame:
        return self.with_captions(frame_of_cells(self.model.bench.figure.view))

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (*warm_ups_of_figures(), WarmUp(cls.title, lambda: cls().advance(cls.dt)))
