"""The events of a session in the order they acted, and a place in it that can be moved back.

After a step back the events of later steps are still there and act again when their step comes, so going
forward repeats what was. The first new event takes another way: what was to come is dropped.
"""

from __future__ import annotations

from collections.abc import Sequence

from game.stage.events import Pointer, StageEvent, Stamped


class Timeline:
    """Stamped events; the first ``acted`` of them have acted (numbers count from the session's beginning)."""

    def __init__(self, coming: Sequence[Stamped] = ()) -> None:
        """``coming``: events that have yet to act."""
        self._events: list[Stamped] = list(coming)
        self._dropped = 0
        self.acted = 0

    def __len__(self) -> int:
        """How many events are known, dropped ones included."""
        return self._dropped + len(self._events)

    @property
    def whole(self) -> bool:
        """True if no event was dropped at the beginning, so that the session can be replayed."""
        return self._dropped == 0

    @property
    def has_future(self) -> bool:
        """True if events are remembered that have yet to act."""
        return self.acted < len(self)

    def past(self) -> list[Stamped]:
        """The events that have acted, as far as they are kept."""
        return self._events[: self.acted - self._dropped]

    def since(self, number: int) -> list[Stamped]:
        """The events that have acted, from the one of that number on."""
        return self._events[max(number - self._dropped, 0) : self.acted - self._dropped]

    def add(self, step: int, event: StageEvent) -> None:
        """An event has acted now: there is no other future any more."""
        self.drop_future()
        self._events.append(Stamped(step, event))
        self.acted += 1

    def due(self, step: int) -> StageEvent | None:
        """The next event if it belongs to that step; it counts as having acted."""
        index = self.acted - self._dropped
        if index < len(self._events) and self._events[index].step == step:
            self.acted += 1
            return self._events[index].event
        return None

    def drop_future(self) -> None:
        """Forget the events that have yet to act."""
        del self._events[self.acted - self._dropped :]

    def drop_from(self, number: int) -> None:
        """Forget the event of that number and all after it, whether they have acted or not."""
        del self._events[max(number - self._dropped, 0) :]
        self.acted = min(self.acted, len(self))

    def drop_before(self, number: int) -> None:
        """Forget events before that number: no snapshot reaches back to them."""
        count = number - self._dropped
        if count > 0:
            del self._events[:count]
            self._dropped = number

    def held(self) -> Pointer | None:
        """The pointer event that began a drag which no later event has ended."""
        for stamped in reversed(self.past()):
            event = stamped.event
            if isinstance(event, Pointer) and event.kind in ("down", "up", "cancel"):
                return event if event.kind == "down" else None
        return None
