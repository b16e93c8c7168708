"""What a scene is, without a screen.

A scene is one class: its attributes declare what may be changed, which effects it calls for and what its
help page says; its methods build, advance and draw. Controls, level files, command line, replay and
digest are made from the declarations.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec
import numpy as np

from game.levels import Level
from game.physics.effects import EffectSet
from game.stage.declarations import (
    Comparison,
    Frame,
    Hearing,
    Hint,
    Inspected,
    Readout,
    Table,
    ToolButton,
    WarmUp,
)
from game.stage.events import Decision, Pointer, StageEvent
from game.stage.opening.definition import check_class, check_whole
from game.stage.opening.from_level import check_locks, check_teaching, refusal, take_over
from game.stage.parameters import STEP_LENGTH, Parameters
from game.stage.part import structures_of
from game.stage.scene_declaration import SceneDeclaration

if TYPE_CHECKING:
    from game.stage.records.contested import Contested, StrokeMeasured
    from game.stage.records.excerpt import Excerpt
    from game.stage.records.history import Practised
    from game.stage.records.scored import Scored


class Scene(SceneDeclaration):
    """Base of all scenes. Subclasses declare attributes (`SceneDeclaration`) and override what they need."""

    parameters: Parameters

    def __init_subclass__(cls) -> None:
        check_class(cls, Scene)
        length = cls.declared_parameters().get(STEP_LENGTH)
        if length is not None:
            cls.dt = length.default

    def __init__(
        self,
        level: Level | None = None,
        parameters: Mapping[str, Any] | None = None,
        *,
        seed: int | None = None,
        effects_off: Iterable[str] = (),
        effects: EffectSet | None = None,
    ):
        """Make the scene from a level (None: its defaults), with some parameters set otherwise.

        ``seed`` stands in for the level's if given; ``effects_off`` are switched off beside those that the
        level switches off; ``effects`` are active exactly, whatever the level says. Raises LevelError if the
        level says what the scene refuses, ParameterError if the other arguments do.
        """
        check_whole(type(self), Scene)
        self.values: dict[str, Any] = {
            name: parameter.default for name, parameter in self.declared_parameters().items()
        }
        self.parameters = self.parameters_type(self.values)
        self.active = self.effects
        self.previous: Any = None  # state before the last step, kept by the stage for the picture
        self.begun = False  # whether there has been a step, kept by the stage likewise
        self.level = level
        self.seed = seed if seed is not None else level.seed if level is not None else 0
        if level is not None:
            take_over(self, level)
        for key, value in (parameters or {}).items():
            self.parameter(key).__set__(self, value)
        if effects is not None:
            self.active = effects
        for name in effects_off:
            self.active = self.active.without(self.effect(name))
        check_locks(self, level)
        try:
            self.build(level)
        except ValueError as error:
            refused = refusal(error, level, asked_beside=bool(parameters))
            if refused is error:
                raise
            raise refused from error
        check_teaching(self, level)

    def level_value(self, name: str) -> Any:
        """What a parameter is in the level: said there, or its default."""
        parameter = self.parameter(name)
        said = self.level.parameters if self.level is not None else {}
        by_present_name = {self.parameter(key).name: value for key, value in said.items()}
        return parameter.check(by_present_name.get(parameter.name, parameter.default))

    def content_of(self, level: Level | None) -> Any:
        """What is in a level; ``default_content`` if it says nothing."""
        return level.content if level is not None and level.content is not None else self.default_content

    # -- to override --------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        """Make the state from the level's content and the parameters. Called on opening and on reset."""
        raise NotImplementedError

    def advance(self, dt: float) -> None:
        """One fixed step. No drawing, no wall clock, no global random numbers."""
        raise NotImplementedError

    def state(self) -> NamedTuple:
        """A NamedTuple of the arrays (and numbers) that are the state: snapshot, digest, step back.

        What later steps depend on, but for parameters and effects. Plain attributes of the scene (numbers,
        words, and lists of them; see memory.py) the stage remembers by itself. Arrays are given as they are,
        not copied. Floats must be finite, but for fields named in ``may_be_infinite``.
        """
        raise NotImplementedError

    def restore(self, state: Any) -> None:
        """Take over a state that ``state`` gave (as copies).

        Default: copy into the arrays in place; what has another shape, or is no array, becomes the
        attribute of its name.
        """
        now = self.state()
        for name, present, then in zip(now._fields, now, state, strict=True):
            same_shape = isinstance(present, np.ndarray) and present.shape == np.shape(then)
            if same_shape and present.flags.writeable:
                np.copyto(present, then)
            elif name in self.__dict__:
                setattr(self, name, then.copy() if isinstance(then, np.ndarray) else then)
            else:
                raise NotImplementedError(f"{type(self).__name__}.restore must set {name}")

    def pointer(self, event: Pointer) -> None:
        """A pointer event in world coordinates."""

    def action(self, name: str) -> None:
        """One of ``actions``."""

    def given_text(self) -> str:
        """What was done last as a text that another player goes on with; ValueError if there is none."""
        raise ValueError("stroke: this scene has none that travels as a text")

    def take_text(self, text: str) -> tuple[Decision, ...] | None:
        """The decisions that a pasted text of another player stands for, each of which may then be posted.

        None if it is no such text. ValueError in one line for one that does not fit. Nothing changes.
        """
        return None

    @property
    def way_out(self) -> str:
        """The action that leads out of a part of the scene, such as a replay, before one leaves it; or ""."""
        return ""

    @property
    def resting(self) -> bool:
        """Whether the scene's own timeline is paused; Space then plays it by the ``play_action``."""
        return False

    def decisions(self, at_once: bool = False) -> Sequence[Decision]:
        """What the scene's own players have decided since the last call; each is to be posted as an event.

        Asked for where somebody plays, never in a replay. It must not change the state. ``at_once``: they
        think to their end within the call, so that what they decide depends on nothing but the state.
        """
        return ()

    @property
    def plays_alone(self) -> bool:
        """True if the scene's own players decide everything, so that no demo is wanted."""
        return False

    def decide(self, event: Decision) -> None:
        """A decision of ``decisions``; ValueError for one that cannot be."""
        raise ValueError(f"{event.name}: {self.name} takes no decisions")

    def parameter_changed(self, name: str) -> None:
        """A parameter without ``rebuild`` has a new value."""

    def why_idle(self, name: str) -> str:
        """Why the parameter of that name changes nothing as the scene stands, in a sentence; "" if it acts.

        The panel shows such a parameter grey and takes no hand to it; its tool tip begins with the sentence.
        It is asked for in every frame, so it must be quick. A value that comes another way is taken all the
        same.
        """
        return ""

    def slider_range(self, name: str) -> tuple[float, float] | None:
        """The part of a parameter's range that its slider spans now; None: all of it.

        What is typed may still be any value of the range. It is asked for in every frame.
        """
        return None

    def takes_long(self, event: StageEvent | None) -> bool:
        """Whether an event (None: a step) may take longer than a frame, so that a window had better not wait.

        What comes out is the same either way.
        """
        return False

    def effects_changed(self) -> None:
        """``active`` has changed."""

    def draw(self, canvas: Any, alpha: float) -> None:
        """Draw the state ``alpha`` of the way from ``previous`` to now. Never changes the state."""

    def frame(self) -> Frame:
        """The part of the world to show."""
        return Frame(-1.0, -1.0, 1.0, 1.0)

    def story_targets(self) -> Mapping[str, tuple[float, float]]:
        """Places (x, y) that a story may name, where they are now: what moves and what stays; no part of the
        state. All that can be named is there from the beginning.
        """
        return {}

    def story_sizes(self) -> Mapping[str, float]:
        """How large (m, from its foot to its head) is what stands at some of these places, by their names."""
        return {}

    def story_names(self) -> Sequence[tuple[tuple[float, float], str]]:
        """What single things of a story are called, and what is measured of them: place (x, y), words."""
        return ()

    def story_charts(self) -> Mapping[str, Comparison]:
        """Measured beside expected, as it stands now, by the names that a story gives them.

        Readouts need none: a story draws them by itself. All that can be named is there from the beginning.
        """
        return {}

    def readouts(self) -> Sequence[Readout]:
        """Measured values; the first is shown in the top bar, those named in strips are charted."""
        return ()

    def standing(self) -> Mapping[str, float]:
        """Figures of the state from which studies tell where the scene is, beside parameters and effects."""
        return {}

    def chosen(self) -> dict[str, Any]:
        """Effects (True where on), `standing` and parameters by name: what a study is asked with.

        A word may name an effect and a parameter, such as gravity: here it is the parameter, as it is in the
        points of studies.
        """
        effects = {effect.name: effect in self.active for effect in self.effects}
        return {**effects, **self.standing(), **self.values}

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """Rows of the legend: (mark, words, live count or ""); mark is "shape:colour", e.g. "disc:chalk"."""
        return ()

    def hints_now(self) -> Sequence[Hint]:
        """Keys and gestures that count as the scene stands, such as those of the tool in the hand."""
        return self.hints

    def tool_bar(self) -> Sequence[ToolButton]:
        """Buttons on the stage for what the hand can do. It is asked for in every frame."""
        return ()

    def inspected(self) -> Inspected | None:
        """The thing whose own parameters are shown on a card on the stage; None: there is none."""
        return None

    def panel_table(self) -> Table | None:
        """Figures of single things, for the panel; None: there are none to show."""
        return None

    def point_at(self, key: int | None) -> None:
        """A row of ``panel_table`` is under the pointer (None: none is): to be lit, and nothing more."""

    def messages(self) -> Sequence[str]:
        """New things worth telling since the last call (fouls, limits reached); shown as fading messages."""
        return ()

    def hearing(self) -> Hearing | None:
        """What is to be heard, and where in it the scene is now; None: nothing."""
        return None

    @classmethod
    def is_heard(cls) -> bool:
        """Whether there is ever anything to be heard."""
        return cls.hearing is not Scene.hearing

    def worth_keeping(self) -> object:
        """A value that changes whenever the content should be kept against a crash; None: never."""
        return None

    @property
    def stars(self) -> tuple[int, int] | None:
        """Most stars won by a person in this level, and how many there are; None: it has none."""
        return None

    @property
    def level_wanted(self) -> str:
        """Name of the file, without its ending, of the scene's own level that is to be opened now; or ""."""
        return ""

    @property
    def practised(self) -> Practised | None:
        """How the set stands that a person practises, to be kept with its history; None: it is no
        practice.
        """
        return None

    @property
    def scored(self) -> Scored | None:
        """How near the last stroke came to a place that it is measured against; None: nothing is."""
        return None

    @property
    def contest(self) -> Contested | None:
        """How a match stands between a person and a computer player, for a career; None: there is none."""
        return None

    @property
    def round_wanted(self) -> int:
        """How often the next round of a cup has been asked for at the scene itself."""
        return 0

    def stroke_measured(self) -> StrokeMeasured | None:
        """What was measured of the last stroke of a person in a contest; None if nothing was."""
        return None

    @property
    def level_title(self) -> str:
        """Title of a level that the scene is saved as; "": any will do."""
        return ""

    def save_content(self) -> msgspec.Struct | None:
        """The present content as a level's [content], or None if the scene keeps none."""
        return None

    def excerpt(self) -> Excerpt | None:
        """The last thing that is worth passing on by itself, such as a stroke; None: the session is."""
        return None

    def highlights(self) -> tuple[Excerpt, ...]:
        """The parts of what was played that decided it, in their order; none: there are none, or not yet."""
        return ()

    @property
    def film_wanted(self) -> int:
        """How often a film of the highlights has been asked for at the scene itself."""
        return 0

    def check(self) -> None:
        """Check the invariants of the structures that it owns; AssertionError says which one is broken."""
        for structure in structures_of(self):
            if callable(getattr(type(structure), "check", None)):
                structure.check()

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """Kernels to compile before the scene opens, in order, by calling them on a small input."""
        return (WarmUp(cls.name, lambda: cls().advance(cls.dt)),)
