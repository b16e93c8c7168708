"""Large NamedTuples go from kernel to kernel as an address, and arrays in the parts that they came in.

numba hands a tuple over member by member, an array as seven to ten numbers and addresses. A world of solids
is a hundred arrays: each call of a kernel with it took a thousand arguments. They were put together anew at
its beginning and taken apart at each call that it makes. That was most of the code that LLVM was given.

Here the caller lays such a tuple into memory, and hands on where that is. A kernel that has it from its own
caller passes the address on. It is never written to: a tuple never changes.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import cgutils
from numba.core.datamodel import models

MOST_BY_VALUE = 16  # numbers and addresses; a tuple of more is passed by its address
ADDRESS = ir.IntType(8).as_pointer()


class ArrayModel(models.ArrayModel):
    """An array, or its parts nested as they are in its structure."""

    def as_argument(self, builder: Any, value: Any) -> Any:
        """Parts of an array."""
        return value if isinstance(value, tuple | list) else super().as_argument(builder, value)


class _ByAddress(models.DataModel):
    """How a tuple is handed over; else as numba has it."""

    def __init__(self, manager: Any, kind: Any):
        super().__init__(manager, kind)
        self.by_address = _count(super().get_argument_type()) > MOST_BY_VALUE
        self.members = tuple(manager.lookup(member) for member in kind)
        self.offsets, self.size = _laid_out(self.members) if self.by_address else ((), 0)

    def get_argument_type(self) -> Any:
        """What is handed over."""
        return ADDRESS if self.by_address else super().get_argument_type()

    def as_argument(self, builder: Any, value: Any) -> Any:
        """A tuple, or the address of one, as what is handed over."""
        if not self.by_address:
            return super().as_argument(builder, value)
        if value.type == ADDRESS:
            return value
        address = self.room(builder)
        self.store(builder, address, value)
        return address

    def from_argument(self, builder: Any, value: Any) -> Any:
        """A tuple from what was handed over."""
        return self.load(builder, value) if self.by_address else super().from_argument(builder, value)

    def room(self, builder: Any) -> Any:
        """Memory for such a tuple, until the function returns."""
        with builder.goto_entry_block():
            return builder.bitcast(builder.alloca(ir.IntType(64), self.size // 8), ADDRESS)

    def store(self, builder: Any, address: Any, value: Any) -> None:
        """Lay a tuple out at an address."""
        for k, member in enumerate(self.members):
            part = builder.extract_value(value, k)
            if is_by_address(member):
                member.store(builder, self.address_of(builder, address, k), part)
            else:
                builder.store(part, self.pointer_to(builder, address, k))

    def load(self, builder: Any, address: Any) -> Any:
        """The tuple at an address, as numba has it."""
        value = ir.Constant(self.get_value_type(), ir.Undefined)
        for k, member in enumerate(self.members):
            if is_by_address(member):
                part = member.load(builder, self.address_of(builder, address, k))
            else:
                part = builder.load(self.pointer_to(builder, address, k))
            value = builder.insert_value(value, part, k)
        return value

    def address_of(self, builder: Any, address: Any, k: int) -> Any:
        """Where the k-th member lies."""
        return cgutils.gep_inbounds(builder, address, self.offsets[k]) if self.offsets[k] else address

    def pointer_to(self, builder: Any, address: Any, k: int) -> Any:
        """The same, as a pointer to what it is."""
        kind = self.members[k].get_value_type()
        return builder.bitcast(self.address_of(builder, address, k), kind.as_pointer())


class NamedTupleModel(_ByAddress, models.TupleModel):
    """Of members of several types."""


class NamedUniTupleModel(_ByAddress, models.UniTupleModel):
    """Of members of one type."""


def is_by_address(model: Any) -> bool:
    """Whether a type's values are handed over as an address."""
    return isinstance(model, _ByAddress) and model.by_address


def _count(nested: Any) -> int:
    return sum(map(_count, nested)) if isinstance(nested, tuple | list) else 1


def _laid_out(members: tuple[Any, ...]) -> tuple[tuple[int, ...], int]:
    """Offsets of the members, each a multiple of 8 bytes, and how many bytes all take."""
    offsets, end = [], 0
    for member in members:
        offsets.append(end)
        size = member.size if is_by_address(member) else _size(member.get_value_type())
        end += -(-size // 8) * 8
    return tuple(offsets), end


def _size(kind: Any) -> int:
    """Bytes that suffice for a value: each number in it takes eight, or more if it is longer."""
    if isinstance(kind, ir.ArrayType):
        return int(kind.count * _size(kind.element))
    if isinstance(kind, ir.BaseStructType):
        return sum(map(_size, kind.elements))
    width = getattr(kind, "width", 64)
    return max(8, width // 8)
