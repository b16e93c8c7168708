"""Wild levels, written from what a scene declares: its parameters, effects, and the types of its content.

Each is the text of a level file, the same for the same scene and number. Numbers lie at the ends of their
ranges, near nothing, or anywhere; lists are empty, short, or as long as they may be; and as a level whose
every part is far from every other tests little, most of them have all their lengths of one small size.
"""

from __future__ import annotations

import math
from random import Random
from typing import Any

import tomli_w
from msgspec import inspect

from game.levels import MAX_BYTES
from game.stage import Choice, Param, Scene, Toggle

MOST = 20_000  # numbers and words in a level; a file has no room for many more
WORDS = ("", "a", "wall", "first", "both", "none", "row", "corners", "points", "coast")


class Writer:
    """Writes one level. ``tame``: choices and effects as they are by default, so that little is compiled."""

    def __init__(self, scene_type: type[Scene], number: int, tame: bool = False):
        self.scene_type = scene_type
        self.hand = Random(f"{scene_type.name} {number}")
        self.tame = tame
        self.size = self.hand.choice((0.0, 1.0, 3.0, 3.0, 10.0, math.inf))  # of lengths in the content
        self.full = self.hand.random() < 0.4  # some lists as long as they may be
        self.alike = self.hand.random() < 0.15  # what is in a list is the same thing again and again
        self.left = MOST

    def text(self) -> str:
        """The level's file."""
        document: dict[str, Any] = {"scene": self.scene_type.name, "title": "wild"}
        document["seed"] = self.hand.choice((0, 1, self.hand.randrange(2**31), 2**63 - 1))
        document["parameters"] = self._parameters()
        names = self.scene_type.effects.names
        if names and not self.tame and self.hand.random() < 0.5:
            document["effects"] = {"off": self.hand.sample(names, self.hand.randrange(len(names)))}
        content_type = self.scene_type.content_type
        if content_type is not None and self.hand.random() < 0.9:
            for most in (MOST, MOST // 8, MOST // 64):
                self.left = most
                content = self.value(inspect.type_info(content_type))
                text = tomli_w.dumps({**document, "content": content})
                if len(text) < MAX_BYTES:
                    return text
                self.full = self.alike = False
        return tomli_w.dumps(document)

    def _parameters(self) -> dict[str, Any]:
        """Some parameters, few or most of them."""
        share = self.hand.choice((0.0, 0.3, 1.0))
        values: dict[str, Any] = {}
        for name, parameter in self.scene_type.declared_parameters().items():
            if self.hand.random() >= share:
                continue
            if isinstance(parameter, Param):
                values[name] = self._parameter(parameter)
            elif isinstance(parameter, Toggle):
                values[name] = self.hand.random() < 0.5
            elif isinstance(parameter, Choice) and not self.tame:
                values[name] = self.hand.choice(parameter.options)
        return values

    def _parameter(self, parameter: Param) -> float:
        """A number that the parameter may have: at an end, as by default, or between."""
        low, high, hand = parameter.minimum, parameter.maximum, self.hand
        value = hand.choice(
            (low, high, high, parameter.default, hand.uniform(low, high), hand.uniform(low, high))
        )
        if parameter.log and hand.random() < 0.5:
            value = min(max(math.exp(hand.uniform(math.log(low), math.log(high))), low), high)
        return float(round(value)) if parameter.whole else float(value)

    def value(self, info: Any, meta: Any = None, optional: bool = False) -> Any:
        """A value of a type, as the parser has it."""
        hand = self.hand
        self.left -= 1
        if isinstance(info, inspect.Metadata):
            return self.value(info.type, meta)
        if isinstance(info, inspect.StructType):
            return self._struct(info)
        if isinstance(info, inspect.UnionType):
            types = [part for part in info.types if not isinstance(part, inspect.NoneType)]
            return self.value(hand.choice(types))
        if isinstance(info, inspect.LiteralType):
            return hand.choice(info.values)
        if isinstance(info, inspect.BoolType):
            return hand.random() < 0.5
        if isinstance(info, inspect.IntType):
            return self._whole(info)
        if isinstance(info, inspect.FloatType):
            return self._number(info)
        if isinstance(info, inspect.StrType):
            word = hand.choice(WORDS[1:] if info.min_length else WORDS)
            return word[: info.max_length] if info.max_length is not None else word
        if isinstance(info, inspect.NamedTupleType):
            return [self.value(field.type) for field in info.fields]
        if isinstance(info, inspect.TupleType):
            return [self.value(part) for part in info.item_types]
        if isinstance(info, (inspect.VarTupleType, inspect.ListType)):
            return self._list(info)
        if isinstance(info, inspect.DictType):
            return {hand.choice(WORDS[1:]): self.value(info.value_type) for _ in range(hand.randrange(4))}
        if isinstance(info, inspect.AnyType):
            return hand.choice((0, 1.0, -3.5, True, "a", [], [0, 1], [[0.0, 1.0]]))
        raise TypeError(f"no wild value is known for {info}")

    def _struct(self, info: Any) -> dict[str, Any]:
        values: dict[str, Any] = {}
        if info.tag_field is not None:
            values[info.tag_field] = info.tag
        share = self.hand.choice((0.2, 0.6, 1.0))
        for field in info.fields:
            if field.required or (self.left > 0 and self.hand.random() < share):
                values[field.encode_name] = self.value(field.type)
        return values

    def _list(self, info: Any) -> list[Any]:
        hand, least = self.hand, info.min_length or 0
        most = info.max_length if info.max_length is not None else 50
        count = hand.choice((0, 1, 2, hand.randrange(40)))
        if self.full and hand.random() < 0.7:
            count = most
        count = min(max(count, least), most)
        if count and self.alike:
            before = self.left
            item = self.value(info.item_type)
            each = before - self.left
            count = min(count, max(1 + self.left // each, least))
            self.left -= each * (count - 1)
            return [item] * count
        values: list[Any] = []
        while len(values) < count and (self.left > 0 or len(values) < least):
            values.append(self.value(info.item_type))
        return values

    def _whole(self, info: Any) -> int:
        low, high = self._range(info, -(2**31), 2**31, 1)
        kind = self.hand.randrange(4)
        if kind == 0:
            return int(self.hand.choice((low, high)))
        return self.hand.randint(int(low), int(min(high, low + (5, 40)[kind - 1])) if kind < 3 else int(high))

    def _number(self, info: Any) -> float:
        hand = self.hand
        low, high = self._range(info, -1e300, 1e300, 0)
        if math.isfinite(self.size) and hand.random() < 0.97:
            low, high = max(low, min(-self.size, high)), min(high, max(self.size, low))
        if hand.random() < 0.08:
            return float(hand.choice((low, high, min(max(0.0, low), high), min(max(5e-324, low), high))))
        return float(hand.uniform(low / 2.0, high / 2.0) * 2.0) if low < high else float(low)

    @staticmethod
    def _range(info: Any, low: float, high: float, grain: int) -> tuple[float, float]:
        """The range of a number as declared; limits that are left out are the next number within."""
        if info.ge is not None:
            low = info.ge
        elif info.gt is not None:
            low = info.gt + grain if grain else math.nextafter(info.gt, math.inf)
        if info.le is not None:
            high = info.le
        elif info.lt is not None:
            high = info.lt - grain if grain else math.nextafter(info.lt, -math.inf)
        return low, high


def wild_level(scene_type: type[Scene], number: int, tame: bool = False) -> str:
    """The text of wild level ``number`` of a scene."""
    return Writer(scene_type, number, tame).text()
