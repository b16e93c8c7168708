"""P22: tap a beat, and a stroke is found whose impacts meet it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from game.billiards.shot_effects import EXACT_EFFECTS
from game.lab.studies.billiards.rhythm import RHYTHM_STUDY
from game.scenes.beat import BEAT, view
from game.scenes.beat.figure import draw_laying
from game.scenes.beat.level import DEFAULT, BeatContent
from game.scenes.beat.model import BeatModel
from game.scenes.beat.parameters import BeatParameters
from game.scenes.beat.readouts import readouts_of
from game.scenes.beat.searching import Searcher
from game.scenes.beat.state import PLAYING, BeatState
from game.scenes.shared.tables import view as table_view
from game.stage import Decision, Equation, Frame, Hearing, Hint, Pointer, Scene, SceneAction, WarmUp
from game.worlds.scene import ModelScene, Told


class Beat(ModelScene):
    """Tap a beat with B, or on the bar below the table, and rest: a stroke is found whose impacts meet it.
    Nothing is steered. For each beat a ball is laid where one that moves then will just meet it, in any of
    many directions. The exact table says what comes of it. Layouts that click between the beats fall behind.
    The impacts are on the beat to rounding; what cushions add off the beat is counted.
    """

    name, task, title = BEAT.names
    parameters_type = BeatParameters
    parameters: BeatParameters
    content_type = BeatContent
    at_once = True
    told = Told(readouts_of)
    restore = Scene.restore  # the arrays stay where they are
    default_content = DEFAULT
    effects = EXACT_EFFECTS
    quarter_turns = 1
    dt = 1.0 / 480.0
    study = RHYTHM_STUDY
    figure = staticmethod(draw_laying)
    actions = (SceneAction("tap", "Tap", "b"), SceneAction("again", "Another shot", "n"))
    hints = (Hint(("B",), "tap the beat, then rest"), Hint(("N",), "another shot for it"))
    equations = (
        Equation("Meeting", r"x_{k} = x_i(t_k) + 2 R \, (\cos \theta, \sin \theta)", "laid for the beat k"),
        Equation(
            "Cost", r"C = \sqrt{\frac{1}{n} \sum_k \min_j (t_j - b_k)^2} + w \, (m - n)", "m impacts, n beats"
        ),
    )
    try_this = (
        "Tap a rhythm you know, and rest: after a second or two it is played.",
        "Press N: another shot for the same beat.",
        "Set the rounds to 0: clicks off the beat stay.",
    )

    def make(self, content: BeatContent) -> None:
        self.model = BeatModel(content, self.parameters, self.seed)
        self.said = self.model.messages
        self.searcher = Searcher(self.model)

    def state(self) -> BeatState:
        return self.model.data

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [WarmUp("rhythm", cls), *table_view.warm_ups()]

    def parameter_changed(self, name: str) -> None:
        """The model reads them as it needs them."""

    def effects_changed(self) -> None:
        """All shots are played with all effects."""

    def decisions(self, at_once: bool = False) -> Sequence[Decision]:
        return self.searcher.decisions(at_once)

    def decide(self, event: Decision) -> None:
        if event.name == "layout":
            self.model.take_layout(np.array(event.values))
        elif event.name == "nothing":
            self.model.found_nothing()
        else:
            raise ValueError(f"{event.name}: expected layout or nothing")

    def pointer(self, event: Pointer) -> None:
        if event.kind == "down" and event.button == 1 and view.PAD.left <= event.x <= view.PAD.right:
            self.model.tap()

    def action(self, name: str) -> None:
        if name == "tap":
            self.model.tap()
        else:
            self.model.search_again()

    def frame(self) -> Frame:
        return view.frame_of(self.model)

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(canvas, self.model, self.previous, alpha, self.captions())

    def hearing(self) -> Hearing:
        model = self.model
        shown = model.shown if model.phase == PLAYING else None
        return Hearing((model.phase, model.beats), model.clock, () if shown is None else shown.sounds)
