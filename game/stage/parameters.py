"""What a person may change about a scene: numbers, choices and switches, declared as class attributes.

A declared parameter checks every value in one place, wherever it comes from: panel, level file, command line
or replay. Controls, help page, level file and command line are made from the declarations alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from numbers import Real
from typing import Any, Generic, TypeVar, overload

from game.definition import DefinitionError
from game.naming import titled
from game.settings import Number, Option, declared

T = TypeVar("T")
STEP_LENGTH = "step_length"  # a parameter of this name (s) is the length of a step


class ParameterError(ValueError):
    """A value that a parameter refuses; the message names the parameter, the value and what is allowed."""


class Parameter(Generic[T]):
    """One thing that may be changed: a descriptor whose values live in ``scene.values``."""

    name: str = ""
    _wrong: str = ""

    def __init__(
        self,
        default: T,
        *,
        label: str = "",
        help: str = "",
        group: str = "",
        rebuild: bool = False,
        in_panel: bool = True,
    ):
        self.default = default
        self._label = label
        self.help = help
        self.group = group
        self.rebuild = rebuild  # a change builds the scene again
        self.in_panel = in_panel  # else its control is elsewhere: a key, the picture, the bar

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name
        try:
            # in the parameter's own type, so that kernels see one type only
            self.default = self.check(self.default)
        except ParameterError as error:  # raised by `check_defaults`: here it would be wrapped in another
            self._wrong = f"the default of {error}"

    @property
    def label(self) -> str:
        """Words for the panel: given, or the name itself."""
        return self._label or self.name.replace("_", " ").capitalize()

    @overload
    def __get__(self, scene: None, owner: type) -> Parameter[T]: ...
    @overload
    def __get__(self, scene: Any, owner: type) -> T: ...
    def __get__(self, scene: Any, owner: type) -> Any:
        return self if scene is None else scene.values[self.name]

    def __set__(self, scene: Any, value: T) -> None:
        scene.values[self.name] = self.check(value)

    def check(self, value: Any) -> T:
        """Return the value in the parameter's own type, or raise ParameterError."""
        raise NotImplementedError

    def parse(self, text: str) -> T:
        """Value of a command line or text field word; ParameterError if it is none."""
        raise NotImplementedError

    def _refuse(self, value: Any, reason: str) -> ParameterError:
        return ParameterError(f"{self.name} = {value!r}: {reason}")


class Param(Parameter[float]):
    """A number in a closed range, with its unit.

    ``log`` spreads the slider over decades, ``whole`` admits integers only, ``step`` is the slider's grain.
    ValueError for a range that is empty, not finite, or logarithmic without being above 0.
    """

    def __init__(
        self,
        default: float,
        minimum: float,
        maximum: float,
        *,
        unit: str = "",
        whole: bool = False,
        log: bool = False,
        step: float | None = None,
        label: str = "",
        help: str = "",
        group: str = "",
        rebuild: bool = False,
        in_panel: bool = True,
    ):
        if not (math.isfinite(minimum) and math.isfinite(maximum)):
            raise ValueError(f"Param: the range {minimum} to {maximum} is not finite")
        if not minimum < maximum:
            raise ValueError(f"Param: minimum {minimum} is not below maximum {maximum}")
        if log and minimum <= 0.0:
            raise ValueError(f"Param: a logarithmic range needs a minimum above 0, not {minimum}")
        self.minimum = minimum
        self.maximum = maximum
        self.unit = unit
        self.whole = whole
        self.log = log
        self.step = 1.0 if whole and step is None else step
        super().__init__(default, label=label, help=help, group=group, rebuild=rebuild, in_panel=in_panel)

    def check(self, value: Any) -> float:
        """The value as a number; ParameterError if it is none, out of range, or not whole if it must be."""
        if isinstance(value, bool) or not isinstance(value, Real):
            raise self._refuse(value, "expected a number")
        try:
            number = float(value) + 0.0  # no negative zero
        except OverflowError:
            raise self._refuse(math.inf, "too large") from None
        if not math.isfinite(number):
            raise self._refuse(value, "expected a finite number")
        if not self.minimum <= number <= self.maximum:
            unit = f" {self.unit}" if self.unit else ""
            raise self._refuse(value, f"outside {self.minimum:g} to {self.maximum:g}{unit}")
        if self.whole and number != int(number):
            raise self._refuse(value, "expected a whole number")
        return int(number) if self.whole else number

    def parse(self, text: str) -> float:
        """The number that a text says, with a point or a comma; ParameterError as for `check`."""
        cleaned = text.strip().replace("\u202f", "").replace("\u2212", "-").replace(",", ".")
        try:
            return self.check(float(cleaned))
        except ValueError as error:
            if isinstance(error, ParameterError):
                raise
            raise self._refuse(text, "expected a number") from None


class Choice(Parameter[str]):
    """One of a few named options.

    ``formerly``: values that options had in earlier versions, and what each is called now; levels and
    recordings that have them still open. ValueError for more or fewer labels than options, and for a former
    name that is an option or stands for none.
    """

    def __init__(
        self,
        default: str,
        options: tuple[str, ...],
        *,
        labels: tuple[str, ...] = (),
        formerly: Mapping[str | bool, str] | None = None,
        label: str = "",
        help: str = "",
        group: str = "",
        rebuild: bool = False,
        in_panel: bool = True,
    ):
        self.options = options
        self.formerly = dict(formerly or {})
        for old, new in self.formerly.items():
            if old in options or new not in options:
                raise ValueError(f"Choice: formerly {old!r}, now {new!r}: expected a name no longer in use")
        self.labels = labels or tuple(titled(option) for option in options)
        if len(self.labels) != len(options):
            raise ValueError("Choice: expected as many labels as options")
        super().__init__(default, label=label, help=help, group=group, rebuild=rebuild, in_panel=in_panel)

    def check(self, value: Any) -> str:
        """The option, by its present name; ParameterError, naming all, if it is none."""
        option = self.formerly.get(value, value) if isinstance(value, str | bool) else value
        if not isinstance(option, str) or option not in self.options:
            raise self._refuse(value, "expected one of " + ", ".join(self.options))
        return str(option)

    def parse(self, text: str) -> str:
        """The option that a text names; ParameterError if it is none."""
        return self.check(text.strip())


class Toggle(Parameter[bool]):
    """A switch."""

    def check(self, value: Any) -> bool:
        """The value; ParameterError unless it is True or False."""
        if not isinstance(value, bool):
            raise self._refuse(value, "expected true or false")
        return value

    def parse(self, text: str) -> bool:
        """True for "on", "yes", "true" or "1", False for their opposites; ParameterError for another word."""
        word = text.strip().lower()
        if word in ("true", "on", "yes", "1"):
            return True
        if word in ("false", "off", "no", "0"):
            return False
        raise self._refuse(text, "expected true or false")


def control_of(
    kind: type[tuple[Any, ...]],
    name: str,
    *,
    minimum: float = -math.inf,
    maximum: float = math.inf,
    **how: Any,
) -> Any:
    """The parameter of a method's setting, as it is declared there (`game.settings`).

    minimum, maximum: of a range that is narrower here; how: group, label, labels and so on.
    """
    setting: Number | Option = declared(kind)[name]
    default = kind._field_defaults[name]  # type: ignore[attr-defined]
    if isinstance(setting, Option):
        if not setting.words:
            return Toggle(default, help=setting.help, **how)
        return Choice(setting.words[default], setting.words, help=setting.help, **how)
    low, high = max(minimum, setting.minimum), min(maximum, setting.maximum)
    return Param(default, low, high, unit=setting.unit, whole=setting.whole, help=setting.help, **how)


def parameters_of(owner: type) -> dict[str, Parameter[Any]]:
    """All parameters that a class declares or inherits, in the order of declaration."""
    found: dict[str, Parameter[Any]] = {}
    for base in reversed(owner.__mro__):
        found.update(_own_parameters(base))
    return found


def check_defaults(owner: type) -> None:
    """DefinitionError for a parameter of a class whose default is none that it takes."""
    for name, parameter in _own_parameters(owner):
        if parameter._wrong:
            raise DefinitionError(f"{owner.__name__}.{name}: {parameter._wrong}")


class Parameters:
    """Declared parameters and their values, apart from the scene, so that its parts can share them.

        class FountainParameters(Parameters):
            rate = Param(8_000.0, 0.0, 100_000.0, unit="1/s")

        class Fountain(Scene):
            parameters_type = FountainParameters
            parameters: FountainParameters

    A part that is given ``scene.parameters`` always sees the present values. ``values``: by name, each
    checked already; None for the defaults. The dict is shared, not copied.
    """

    def __init_subclass__(cls) -> None:
        check_defaults(cls)

    def __init__(self, values: dict[str, Any] | None = None):
        self.values = {name: parameter.default for name, parameter in parameters_of(type(self)).items()}
        if values is not None:
            self.values = values


def _own_parameters(owner: type) -> Iterator[tuple[str, Parameter[Any]]]:
    return ((name, value) for name, value in vars(owner).items() if isinstance(value, Parameter))
