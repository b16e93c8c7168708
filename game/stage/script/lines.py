"""The words of a story: eight verbs, each a line; and what must be true of it.

Times of a story are those of its film (s): where it goes slowly, a second of film is less of simulated time.
Only `Do` touches the scene, by the events that a hand would send.
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.levels import Level

Seconds = Annotated[float, msgspec.Meta(ge=0.0, le=3600.0)]
Words = Annotated[str, msgspec.Meta(min_length=1, max_length=300)]
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=60)]
Coordinate = Annotated[float, msgspec.Meta(ge=-1e9, le=1e9)]
Width = Annotated[float, msgspec.Meta(ge=1e-9, le=1e9)]
Place = tuple[Coordinate, Coordinate] | str  # m, or what the scene calls it
# (msgspec 0.22 mixes up the lengths of a text and of a list where both are limited within one union)

WHOLE = "whole"  # the place, and the width, of the frame that the scene shows by itself
EASE_S = 1.5


class Line(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """What all lines may say of when they begin.

    at: a moment at which it begins, out of its turn; without one it waits for the line before. after: s more.
    meanwhile: the line after it does not wait for its end.
    """

    at: str = ""
    after: Seconds = 0.0
    meanwhile: bool = False


class Title(Line, frozen=True, kw_only=False):
    """A card over the picture: a heading and a line below it. seconds: how long."""

    title: Words
    line: Annotated[str, msgspec.Meta(max_length=120)] = ""
    seconds: Seconds = 4.0


class _Camera(Line, frozen=True, kw_only=True):
    """width: m that are seen across, else as before. ease: s until it is there. cut: at once."""

    width: Width | Literal["whole"] | None = None
    ease: Seconds = EASE_S
    cut: bool = False


class Look(_Camera, frozen=True, kw_only=False):
    """The camera goes to a place and stays."""

    look: Place


class Follow(_Camera, frozen=True, kw_only=False):
    """The camera goes with what the scene calls so."""

    follow: Name


class Deed(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """One of: an action; a parameter set to a value; an effect on or off; a pointer at a place.

    over: s of simulated time in which a parameter goes to its value, or a drag or move ``to`` a place.
    Without it they are there at once.
    """

    action: str = ""
    parameter: str = ""
    value: float | bool | str | None = None
    effect: str = ""
    on: bool = True
    pointer: Literal["", "click", "drag", "move", "down", "up", "wheel"] = ""
    place: Place | None = None
    to: Place | None = None
    button: Annotated[int, msgspec.Meta(ge=1, le=3)] = 1
    wheel: Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)] = 0.0
    shift: bool = False
    control: bool = False
    over: Seconds = 0.0


class Do(Line, frozen=True, kw_only=False):
    """What a hand would do."""

    do: Deed


class Chart(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """What is measured over what is expected, in a corner of the picture for as long as a caption stands.

    measured: a readout. expected: another, or a number. over: the readout along which both are drawn; "time"
    is that of the simulation, s, if no readout is called so; "" for two marks on an axis. since: a moment
    from which on they are drawn; a curve begins again where ``over`` does. mean: what is drawn is the mean of
    the notes of so much of ``over`` before. names: of both, if not those of the readouts. limit: a value that
    is ruled across a curve, limited: what that is called. shows: what the scene calls so
    (`Scene.story_charts`), in place of all these.
    """

    measured: Annotated[str, msgspec.Meta(max_length=60)] = ""
    expected: Annotated[str, msgspec.Meta(max_length=60)] | float = ""
    over: Annotated[str, msgspec.Meta(max_length=60)] = ""
    since: Annotated[str, msgspec.Meta(max_length=60)] = ""
    mean: Annotated[float, msgspec.Meta(ge=0.0, le=1e9)] = 0.0
    names: tuple[Name, Name] | None = None
    limit: float | None = None
    limited: Annotated[str, msgspec.Meta(max_length=20)] = "limit"
    shows: Annotated[str, msgspec.Meta(max_length=60)] = ""
    corner: Literal["top right", "top left", "bottom right", "bottom left"] = "top right"


class Say(Line, frozen=True, kw_only=False):
    """A caption; {readout} stands for its value with its unit, {readout:.1f} for the number alone.

    until: the moment at which it goes, once it could be read; without one it stays as long as reading takes.
    above: it stands at the picture's head. chart: what is drawn in a corner meanwhile.
    names: what the scene calls single things (`Scene.story_names`) stands beside them meanwhile.
    """

    say: Words
    until: str = ""
    above: bool = False
    names: bool = False
    chart: Chart | None = None


class Moment(Line, frozen=True, kw_only=False):
    """Waits until the state is so. when: one or more of "READOUT > NUMBER" (or <, >=, <=), all at a time.

    deadline: s of simulated time that it may take. chapter: how the film calls what begins then; quiet: no
    chapter begins. subject: the place, as the scene calls it, that has to be seen well then.
    """

    moment: Name
    when: str | tuple[str, ...]
    deadline: Annotated[float, msgspec.Meta(gt=0.0, le=3600.0)]
    chapter: Annotated[str, msgspec.Meta(max_length=60)] = ""
    quiet: bool = False
    subject: Annotated[str, msgspec.Meta(max_length=60)] = ""

    @property
    def conditions(self) -> tuple[str, ...]:
        """All that must be true at a time."""
        return (self.when,) if isinstance(self.when, str) else self.when

    @property
    def heading(self) -> str:
        """The name of its chapter; "" if it begins none."""
        if self.quiet:
            return ""
        return self.chapter or self.moment[0].upper() + self.moment[1:]


class Slow(Line, frozen=True, kw_only=False):
    """Simulated seconds for one of the film, from here on; 1 is as fast as it is."""

    slow: Annotated[float, msgspec.Meta(ge=1.0 / 16.0, le=4.0)]


class HandOver(Line, frozen=True, kw_only=False):
    """The end card; from then on the scene is the viewer's. seconds: how long it stands in a film."""

    hand_over: Words
    seconds: Annotated[float, msgspec.Meta(ge=1.0, le=60.0)] = 5.0


class Expect(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A readout must lie from ``least`` to ``most``.

    at: when, a moment or s of simulated time. by: at some time not later than that. Without either: at the
    end.
    """

    expect: Name
    least: float | None = None
    most: float | None = None
    at: Name | Seconds | None = None
    by: Name | Seconds | None = None

    def holds(self, value: float) -> bool:
        """Whether a value lies within; one that is not a number does not."""
        low, high = self.least, self.most
        return value == value and (low is None or value >= low) and (high is None or value <= high)

    @property
    def range(self) -> str:
        """The range in words."""
        low, high = self.least, self.most
        if low is None:
            return f"at most {high:g}"
        return f"at least {low:g}" if high is None else f"{low:g} to {high:g}"


class WhatIf(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """What the end card offers: back to a moment, one thing changed, and on without the script.

    say: what is changed, as a question. at: the moment; "" is the beginning.
    """

    say: Annotated[str, msgspec.Meta(min_length=1, max_length=60)]
    do: Deed
    at: Name | Literal[""] = ""


StoryLine = Title | Look | Follow | Do | Say | Moment | Slow | HandOver
VERBS: dict[str, type[StoryLine]] = {
    "title": Title, "look": Look, "follow": Follow, "do": Do, "say": Say, "moment": Moment, "slow": Slow,
    "hand_over": HandOver,
}  # fmt: skip


class Story(msgspec.Struct, frozen=True, kw_only=True):
    """A whole story. ``level`` is what it begins with, its title and words among them."""

    name: str
    level: Level
    lines: tuple[StoryLine, ...]
    expectations: tuple[Expect, ...] = ()
    what_if: WhatIf | None = None

    @property
    def scene(self) -> str:
        """Name of the scene that it is played in."""
        return self.level.scene

    @property
    def title(self) -> str:
        """Its title."""
        return self.level.title

    def moment_before(self, number: int) -> str:
        """The moment that stands before a line, or at which it begins; "" if there is none."""
        if self.lines[number].at:
            return self.lines[number].at
        before = (line for line in reversed(self.lines[:number]) if isinstance(line, Moment) and not line.at)
        return next((line.moment for line in before), "")

    def first_words(self, number: int) -> list[int]:
        """The lines that tell of a moment: the first caption after it, and those at it."""
        moment = self.lines[number]
        assert isinstance(moment, Moment)
        found = [i for i, line in enumerate(self.lines) if isinstance(line, Say) and line.at == moment.moment]
        if moment.at:
            return found
        for i, line in enumerate(self.lines[number + 1 :], number + 1):
            if line.at:
                continue
            if isinstance(line, (Moment, Title, HandOver)):
                break
            if isinstance(line, Say):
                return [i, *found]
        return found
