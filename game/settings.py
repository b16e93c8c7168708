"""Settings of a method, each declared once beside it: what it may be, its unit, what it does.

    class Settings(NamedTuple):
        restitution: Annotated[float, Number(0.0, 1.0, help="normal speed that is kept")] = 0.95
        rule: Annotated[int, Option(("conserving", "scaled"), help="what a collision does")] = 0

Controls and level fields are made of the declarations (`game.stage.parameters`), and so is the check of what
comes in otherwise. A kernel takes the tuple. Options have words outside and their places inside.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from numbers import Integral, Real
from typing import Any, NamedTuple, TypeVar, get_type_hints

Settings = TypeVar("Settings", bound=tuple[Any, ...])


class Number(NamedTuple):
    """A number in a closed range."""

    minimum: float
    maximum: float
    help: str = ""
    unit: str = ""
    whole: bool = False

    def checked(self, name: str, value: Any) -> float:
        """The value in the setting's own type; ValueError if it is none."""
        kind: Any = Integral if self.whole else Real
        if isinstance(value, bool) or not (
            isinstance(value, kind) and self.minimum <= float(value) <= self.maximum
        ):
            words = "a whole number" if self.whole else "a number"
            raise ValueError(
                f"{name}: must be {words} from {self.minimum:g} to {self.maximum:g}, got {value!r}"
            )
        return int(value) if self.whole else float(value)

    def placed(self, value: Any) -> float:
        """A checked value as the kernel takes it."""
        return value


class Option(NamedTuple):
    """One of a few words, or true or false without any."""

    words: tuple[str, ...] = ()
    help: str = ""

    def checked(self, name: str, value: Any) -> int | bool:
        """The place of a word; ValueError for another."""
        if value not in self.words if self.words else not isinstance(value, bool):
            raise ValueError(
                f"{name}: must be one of {', '.join(self.words) or 'true, false'}, got {value!r}"
            )
        return self.placed(value)

    def placed(self, value: Any) -> int | bool:
        """A checked value as the kernel takes it."""
        return self.words.index(value) if self.words else value


@cache
def declared(kind: type[tuple[Any, ...]]) -> dict[str, Number | Option]:
    """What each field of a tuple of settings may be."""
    hints = get_type_hints(kind, include_extras=True)
    return {name: hint.__metadata__[0] for name, hint in hints.items()}


def changed(base: Settings, changes: Mapping[str, Any]) -> Settings:
    """Settings like ``base``, some changed, options by their words.

    ValueError names a setting that there is not, or one that is out of range.
    """
    known = declared(type(base))
    unknown = sorted(changes.keys() - known)
    if unknown:
        raise ValueError(f"{unknown[0]}: no such setting; there are {', '.join(known)}")
    found: Settings = base._replace(  # type: ignore[attr-defined]
        **{name: known[name].checked(name, value) for name, value in changes.items()}
    )
    return found


def taken(kind: type[Settings], values: Mapping[str, Any]) -> Settings:
    """Settings of values by name that were checked as they came in; the rest as declared."""
    known = declared(kind)
    return kind(**{name: known[name].placed(value) for name, value in values.items() if name in known})


def set_one(settings: Settings, name: str, value: Any) -> Settings:
    """Settings with another value of one name, which was checked as it came in; as they are without it."""
    setting = declared(type(settings)).get(name)
    if setting is None:
        return settings
    found: Settings = settings._replace(**{name: setting.placed(value)})  # type: ignore[attr-defined]
    return found
