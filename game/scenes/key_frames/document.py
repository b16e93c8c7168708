"""The motion that is edited: the chosen key, a drag that has begun, undo and redo."""

from __future__ import annotations

from typing import Any, NamedTuple

import msgspec

from game.physics.animation import EASINGS
from game.scenes.key_frames import editing
from game.scenes.key_frames.level import Motion
from game.scenes.key_frames.parameters import OWN, SHAPING, KeyFrameParameters
from game.stage.messages import Messages
from game.stage.part import Part

MOST_UNDO = 200
NOTHING = ("", -1)  # what an empty hand holds


class Edit(NamedTuple):
    """What undo and redo go between: the motion, and the parameters that shape it."""

    motion: Motion
    parameters: tuple[Any, ...]


class Document(Part):
    """A motion and its history.

    chosen: number of the chosen key, -1 for none. held: what a drag has taken, and its number. before: the
    edit that the drag began from, so that one drag is one edit to undo.
    """

    def __init__(self, parameters: KeyFrameParameters, motion: Motion) -> None:
        self.parameters = parameters
        self.motion = editing.ordered(motion)
        self.past: list[Edit] = []
        self.future: list[Edit] = []
        self.before: Edit | None = None
        self.held: tuple[str, int] = NOTHING
        self.chosen = -1
        self.shaped = self.shaping()
        self.messages = Messages()
        self._reason = ""  # told last, why a parameter does nothing

    def shaping(self) -> tuple[Any, ...]:
        """Values of the parameters that an undo takes back as well."""
        return tuple(self.parameters.values[name] for name in SHAPING)

    # -- messages -----------------------------------------------------------------------------------

    def tell(self, words: str) -> None:
        """Something worth telling the user."""
        self.messages.say(words)

    def refuse(self, error: ValueError) -> None:
        """Tell why an edit cannot be."""
        self.tell(f"{str(error).capitalize()}.")

    def tell_once(self, words: str) -> None:
        """Say why a parameter does nothing, but not again with each pixel of its slider."""
        if words != self._reason:
            self._reason = words
            self.tell(words)

    def forget_reason(self) -> None:
        """From now on a reason may be told again."""
        self._reason = ""

    # -- edits --------------------------------------------------------------------------------------

    def edit(self) -> Edit:
        """What there is now, for an undo."""
        return Edit(self.motion, self.shaping())

    def set_edit(self, edit: Edit) -> None:
        """Go to what there was."""
        self.motion = edit.motion
        self.parameters.values.update(zip(SHAPING, edit.parameters, strict=True))
        self.shaped = edit.parameters
        self.choose(min(self.chosen, len(self.motion.keys) - 1))

    def note(self, before: Edit, parameters: tuple[Any, ...] | None = None) -> None:
        """Something has been changed; undo leads to ``before``. parameters: those now; else the panel's."""
        if before != Edit(self.motion, self.shaping() if parameters is None else parameters):
            self.past = [*self.past, before][-MOST_UNDO:]
            self.future = []

    def note_shaping(self) -> None:
        """A parameter that shapes the motion has been changed: that is an edit."""
        self.note(Edit(self.motion, self.shaped))
        self.shaped = self.shaping()

    def take_hold(self, what: str, index: int) -> None:
        """A drag has taken something."""
        self.held = (what, index)

    def let_go(self) -> None:
        """End a drag here: what it has done so far is one edit."""
        if self.before is not None:
            self.note(self.before, self.shaped)
        self.before, self.held = None, NOTHING

    def cancel(self) -> None:
        """End a drag and take back what it has done."""
        if self.before is not None:
            self.set_edit(self.before)
            self.before = None
        self.let_go()

    def change(self, motion: Motion) -> None:
        """Another motion, in one edit."""
        before = self.edit()
        self.motion = motion
        self.note(before)
        self.choose(min(self.chosen, len(motion.keys) - 1))

    def undo(self) -> None:
        """Take the last edit back."""
        self._go_between(self.past, self.future, "There is nothing to undo.")

    def redo(self) -> None:
        """Do again what was taken back last."""
        self._go_between(self.future, self.past, "There is nothing to redo.")

    def _go_between(self, source: list[Edit], target: list[Edit], words: str) -> None:
        if not source:
            self.tell(words)
            return
        now = self.edit()
        edit = source[-1]
        source[:] = source[:-1]
        target.append(now)
        self.set_edit(edit)

    # -- keys and timing ----------------------------------------------------------------------------

    def delete_key(self, index: int) -> None:
        """Take a key away."""
        try:
            motion = editing.without_key(self.motion, index)
        except ValueError as error:
            self.refuse(error)
            return
        if self.chosen >= index:
            self.chosen -= 1
        self.change(motion)

    def choose(self, index: int) -> None:
        """Let a key be the chosen one (-1: none), and the panel say what it is."""
        self.chosen = index
        self.show_chosen()

    def show_chosen(self) -> None:
        """The panel's numbers are those of the chosen key."""
        if not 0 <= self.chosen < len(self.motion.keys):
            return
        key, shown = self.motion.keys[self.chosen], self.parameters
        shown.key_time, shown.key_angle = key.time, key.angle
        shown.key_x, shown.key_y = key.position

    def take_chosen(self, name: str) -> None:
        """Give the chosen key what the panel says."""
        index, motion, shown = self.chosen, self.motion, self.parameters
        if name == "key_time":
            motion, self.chosen = editing.with_time(motion, index, shown.key_time)
        elif name == "key_angle":
            motion = editing.with_change(motion, index, angle=shown.key_angle)
        else:
            motion = editing.with_change(motion, index, position=(shown.key_x, shown.key_y))
        self.change(motion)

    def timing(self) -> tuple[float, float, float, float]:
        """Handles of the present timing curve."""
        easing = self.parameters.easing
        return self.motion.timing if easing == OWN else EASINGS[easing]

    def set_timing(self, four: list[float]) -> None:
        """A timing curve of one's own."""
        self.motion = msgspec.structs.replace(self.motion, timing=tuple(four))
        self.parameters.easing = OWN
        self.shaped = self.shaping()
