"""The entry by which Python enters a kernel that does not count references: its arguments, made ready.

numba writes some forty instructions for each array of a tuple, which for a world of solids are more than
those of the step itself. Here a loop goes over the arrays, and each is laid right where the kernel reads it
(see bundles.py).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.boxing import unbox_tuple
from numba.core.callwrapper import PyCallWrapper
from numba.core.pythonapi import NativeValue, PythonAPI, _UnboxContext
from numba.np.numpy_support import as_dtype

from game.compiler.target.bundles import is_by_address

_TAKES_ADDRESSES = "carom_takes_addresses"  # set on the builder of such an entry
_ITEM_SIZE = 24  # bytes, where an array's structure says how many bytes an element takes
_LONG = ir.IntType(64)
_REFUSED = "can't unbox array from PyObject into native value.  The object maybe of a different type"


class Entry(PyCallWrapper):
    """numba's function for Python around a kernel; large tuples are laid into memory."""

    def build_wrapper(self, api: Any, builder: Any, closure: Any, args: Any, kws: Any) -> None:
        """Write it."""
        setattr(builder, _TAKES_ADDRESSES, True)
        super().build_wrapper(api, builder, closure, args, kws)


def fits_entry(context: Any, kinds: tuple[Any, ...]) -> bool:
    """Whether a kernel of these arguments gets such an entry: numbers, arrays, and tuples of these.

    In a tuple that is handed over by its members none may lie that is passed by its address.
    """
    lookup = context.data_model_manager.lookup

    def is_plain(kind: Any, may_go: bool) -> bool:
        if isinstance(kind, types.BaseTuple):
            goes = is_by_address(lookup(kind))
            return (may_go or not goes) and all(is_plain(member, goes) for member in kind)
        return isinstance(kind, types.Number | types.Boolean) or type(kind) is types.Array

    return not context.enable_nrt and all(is_plain(kind, True) for kind in kinds)


class EntryAPI(PythonAPI):
    """How code talks with Python; at an entry large tuples are not unboxed, but laid into memory."""

    def to_native_value(self, typ: Any, obj: Any) -> Any:
        """What a kernel gets for an object of Python's."""
        if isinstance(typ, types.NamedTuple | types.NamedUniTuple):
            return _unbox_named_tuple(typ, obj, _UnboxContext(self.context, self.builder, self))
        return super().to_native_value(typ, obj)


def _unbox_named_tuple(kind: Any, obj: Any, c: Any) -> Any:
    """A NamedTuple of Python's for a kernel: the address of what it is in memory, at an entry."""
    model = c.context.data_model_manager[kind]
    if not (getattr(c.builder, _TAKES_ADDRESSES, False) and is_by_address(model)):
        return unbox_tuple(kind, obj, c)
    failed = cgutils.alloca_once_value(c.builder, cgutils.false_bit)
    address = model.room(c.builder)
    _lay_out(kind, obj, c, address, failed)
    return NativeValue(address, is_error=c.builder.load(failed))


def _lay_out(kind: Any, obj: Any, c: Any, address: Any, failed: Any) -> None:
    """Write the members of the tuple ``obj`` to where they belong from ``address`` on."""
    builder = c.builder
    size = c.pyapi.tuple_size(obj)
    fits = builder.icmp_unsigned("==", size, size.type(len(kind)))
    with builder.if_else(fits, likely=True) as (then, otherwise):
        with then:
            _lay_out_members(kind, obj, c, address, failed)
        with otherwise:
            said = f"size mismatch for tuple, expected {len(kind)} element(s) but got %zd"
            c.pyapi.err_format("PyExc_ValueError", said, size)
            builder.store(cgutils.true_bit, failed)


def _lay_out_members(kind: Any, obj: Any, c: Any, address: Any, failed: Any) -> None:
    builder, model = c.builder, c.context.data_model_manager[kind]
    arrays = [k for k, member in enumerate(kind) if type(member) is types.Array]
    if arrays:
        table = [(k, model.offsets[k], as_dtype(kind[k].dtype).itemsize) for k in arrays]
        _lay_out_arrays(table, obj, c, address, failed)
    for k, member in enumerate(kind):
        if k in arrays:
            continue
        item = c.pyapi.tuple_getitem(obj, k)
        if is_by_address(model.members[k]):
            _lay_out(member, item, c, model.address_of(builder, address, k), failed)
            continue
        native = c.unbox(member, item)
        builder.store(native.value, model.pointer_to(builder, address, k))
        with builder.if_then(native.is_error, likely=False):
            builder.store(cgutils.true_bit, failed)


def _lay_out_arrays(table: Any, obj: Any, c: Any, address: Any, failed: Any) -> None:
    """The same for arrays: for each its index, its offset, and bytes of an element."""
    builder = c.builder
    row = ir.ArrayType(_LONG, 3)
    rows = ir.Constant(ir.ArrayType(row, len(table)), [ir.Constant(row, list(one)) for one in table])
    place = cgutils.global_constant(builder.module, builder.module.get_unique_name(".arrays"), rows)
    get = c.pyapi._get_function(ir.FunctionType(obj.type, [obj.type, _LONG]), name="PyTuple_GetItem")
    with cgutils.for_range(builder, _LONG(len(table)), intp=_LONG) as loop:
        k, offset, expected = (
            builder.load(cgutils.gep_inbounds(builder, place, 0, loop.index, column)) for column in range(3)
        )
        own = builder.gep(address, [offset])
        code = c.pyapi.numba_array_adaptor(builder.call(get, [obj, k]), own)
        size = builder.load(builder.bitcast(builder.gep(own, [_LONG(_ITEM_SIZE)]), _LONG.as_pointer()))
        wrong = builder.icmp_unsigned("!=", size, expected)
        with builder.if_then(builder.or_(cgutils.is_not_null(builder, code), wrong), likely=False):
            c.pyapi.err_set_string("PyExc_TypeError", _REFUSED)
            builder.store(cgutils.true_bit, failed)
