"""The real table: tracked shots over what five models compute for them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.billiards.fitting.tracks import TrackError
from game.lab.studies.billiards.real_table import real_table_study
from game.scenes.real_table import REAL_TABLE, view
from game.scenes.real_table.comparison import MODELS
from game.scenes.real_table.figure import draw_residuals
from game.scenes.real_table.level import RealTableContent
from game.scenes.real_table.model import RealTableModel, own_files, tracks_folder
from game.scenes.real_table.parameters import RealTableParameters
from game.scenes.real_table.readouts import readouts_of
from game.scenes.shared.tables import view as table_view
from game.stage import Equation, Frame, Hint, SceneAction, Strip, WarmUp
from game.worlds.scene import ModelScene, Told


class RealTableState(NamedTuple):
    """clock (1,): time on the clock of the track, s. stroke (5,): azimuth, speed, tip left and up, start; SI.
    places (16, 2) m: where the balls are computed; 0 for those that there are not.
    """

    clock: np.ndarray
    stroke: np.ndarray
    places: np.ndarray


class RealTable(ModelScene):
    """Where balls of a real table were seen, and what models of it compute. The dots are samples of a track;
    the line is the path of the exact table with the stroke that explains them best: direction, speed, and the
    point of the ball that the tip meets.

    Three models of the cushions are compared, each with a stroke of its own, and two tables that step. What
    is left between track and path grows from contact to contact: a model that is a little wrong at the first
    cushion is far off at the sixth. The list tells how far each is off, and what a shot costs it.

    The shipped tracks are made by the program, with noise that the level states. Put track files of your own
    into the folder "tracks" among your data and press O. assets/TRACKS.md says what they look like, and
    "python -m game fit" finds the table's numbers for the panel.
    """

    name, task, title = REAL_TABLE.names
    parameters_type = RealTableParameters
    parameters: RealTableParameters
    content_type = RealTableContent
    default_content = RealTableContent()
    told = Told(readouts_of)
    quarter_turns = 1
    study = real_table_study
    strips = (Strip("Cue ball off its track", "m", MODELS, colors=tuple(view.COLORS[m] for m in MODELS)),)
    hints = (Hint(("N",), "next shot"), Hint(("O",), "open tracks"))
    actions = (
        SceneAction("next", "next shot", "N"),
        SceneAction("open", "open the next track file", "O"),
    )
    figure = staticmethod(draw_residuals)
    equations = (
        Equation("Residual", r"r = \abs{\v{x}_\text{seen} - \v{x}(t)}", "of each sample"),
        Equation("Restitution", r"e = e_0 - \alpha v", "Hunt, Crossley 1975"),
        Equation("Friction of balls", r"P_t \le \mu P_n", "Wallace, Schroeder 1988"),
    )
    try_this = (
        "Lower Han's restitution by 0.02 and watch its curve: the residual grows with each cushion.",
        "Set the fall of the restitution to 0 and watch the fast first cushions.",
        "Compare what a shot costs: the model that follows the impact step by step is the dearest exact one.",
    )

    def make(self, content: RealTableContent) -> None:
        self.model = RealTableModel(content, self.parameters)

    def parameter_changed(self, name: str) -> None:
        if name == "shot":
            self.model.further = 0
            self.model.time = 0.0

    def state(self) -> RealTableState:
        return RealTableState(np.array([self.model.time]), *self.model.computed)

    def restore(self, state: RealTableState) -> None:
        self.model.time = float(state.clock[0])

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [WarmUp("real table", _compare_once), *table_view.warm_ups()]

    def action(self, name: str) -> None:
        if name == "next":
            self.model.next_shot()
        else:
            self._open()

    def _open(self) -> None:
        if not own_files():
            self.said.say(f"There are no track files in {tracks_folder()}.")
            return
        try:
            self.model.open_next()
        except (TrackError, OSError) as problem:
            self.said.say(str(problem))

    def frame(self) -> Frame:
        return view.frame_of(self.model)

    def draw(self, canvas: Any, alpha: float) -> None:
        time = self.model.time
        before = self.previous.clock[0] if self.previous is not None else time
        view.draw(canvas, self.model, before + alpha * (time - before) if before <= time else time)


def _compare_once() -> None:
    scene_model = RealTableModel(RealTableContent(), RealTableParameters())
    assert scene_model.compared.models
