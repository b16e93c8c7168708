"""numba's last step before LLVM, in fewer words.

For ``a[i, 0]`` numba copies the whole of a into memory, and reads all its lengths and strides back. It puts
both indices into a tuple and takes them out again: fifty lines of LLVM's language, of which five are left in
the end. Here only those five are written. Members of tuples that came in by their address (see bundles.py)
are read where they lie, once in a kernel.

What is not an element of an array of numbers, or a member of such a tuple, is left to numba.
"""

from __future__ import annotations

import operator
from functools import partial
from typing import Any

from numba import types
from numba.core import ir
from numba.core.compiler_machinery import register_pass
from numba.core.errors import LoweringError, new_error_context  # type: ignore[attr-defined]
from numba.core.typed_passes import NativeLowering
from numba.np.arrayobj import fix_integer_index, load_item, store_item

from game.compiler.target.bundles import ADDRESS
from game.compiler.target.members import DATA, SHAPE, STRIDES, MemberLower, is_array

_NUMBER = (types.Integer, types.Float, types.Boolean)
_POWERS = (operator.pow, operator.ipow)


class ShortLower(MemberLower):
    """Writes a kernel in LLVM's language."""

    def init(self) -> None:
        """Begin."""
        super().init()
        self._pairs: dict[str, list[Any]] = {}  # indices of several dimensions, by the tuple's variable

    # ------------------------------------------------------------------ variables

    def lower_block(self, block: Any) -> None:
        """Write a block; an error tells of the statement."""
        self.pre_block(block)
        for inst in block.body:
            self.loc = inst.loc
            try:
                self.lower_inst(inst)
            except Exception:
                told = partial(LoweringError, loc=self.loc)
                with new_error_context('lowering "{inst}" at {loc}', inst=inst, loc=self.loc, errcls_=told):
                    raise
        self.post_block(block)

    def lower_inst(self, inst: Any) -> Any:
        """Write a statement; none for what is read where it lies, and for indices."""
        if isinstance(inst, ir.Del):
            self.delvar(inst.value)
            return None
        if not isinstance(inst, ir.Assign):
            return super().lower_inst(inst)
        name = inst.target.name
        if name in self._members or self._is_pair(inst):
            return None
        if self.context.enable_debuginfo or isinstance(inst.value, ir.Arg):
            return super().lower_inst(inst)
        self.notify_loc(self.loc)
        self.storevar(self.lower_assign(self.typeof(name), inst), name)
        return None

    def _is_pair(self, inst: Any) -> bool:
        """Remember a tuple of integers that is used in this block only: it may be no more than an index."""
        name, value = inst.target.name, inst.value
        if not isinstance(value, ir.Expr) or value.op != "build_tuple":
            return False
        kind = self.typeof(name)
        if name not in self._singly_assigned_vars or not all(isinstance(k, types.Integer) for k in kind):
            return False
        self._pairs[name] = [
            self.context.cast(self.builder, self.loadvar(item.name), self.typeof(item.name), to)
            for item, to in zip(value.items, kind, strict=True)
        ]
        return True

    def loadvar(self, name: str) -> Any:
        """The value of a variable."""
        if name in self._pairs and name not in self._blk_local_varmap:
            kind = self.typeof(name)
            self._blk_local_varmap[name] = self.context.make_tuple(self.builder, kind, self._pairs[name])
        return super().loadvar(name)

    def storevar(self, value: Any, name: str, argidx: int | None = None) -> None:
        """Set a variable."""
        if self.context.enable_nrt or self.context.enable_debuginfo:
            super().storevar(value, name, argidx)
        elif name in self._singly_assigned_vars:
            self._blk_local_varmap[name] = value
        else:  # what it was before is not counted
            self._alloca_var(name, self.typeof(name))
            self.builder.store(value, self.getvar(name))

    def delvar(self, name: str) -> None:
        """Forget a variable."""
        if name in self._members or name in self._pairs:
            return
        if self.context.enable_nrt:
            super().delvar(name)

    # ------------------------------------------------------------------ elements of arrays

    def lower_getitem(self, resty: Any, expr: Any, value: Any, index: Any, signature: Any) -> Any:
        """An element of an array, or whatever numba has for square brackets."""
        array = self.typeof(value.name)
        if array != signature.args[0] or not self._is_element(array, signature.args[1]):
            return super().lower_getitem(resty, expr, value, index, signature)
        place = self._element(value.name, array, index.name, signature.args[1])
        item = load_item(self.context, self.builder, array, place)
        return self.context.cast(self.builder, item, array.dtype, resty)

    def lower_setitem(self, target: Any, index: Any, value: Any, signature: Any) -> Any:
        """The same for writing."""
        array, (whole, kind, given) = self.typeof(target.name), signature.args
        if array != whole or not self._is_element(array, kind) or not isinstance(given, _NUMBER):
            return super().lower_setitem(target, index, value, signature)
        place = self._element(target.name, array, index.name, kind)
        item = self.context.cast(self.builder, self.loadvar(value.name), self.typeof(value.name), given)
        item = self.context.cast(self.builder, item, given, array.dtype)
        store_item(self.context, self.builder, array, item, place)
        return None

    def _is_element(self, array: Any, index: Any) -> bool:
        """Whether an index of this type gives a number of an array."""
        if not is_array(array) or not isinstance(array.dtype, _NUMBER):
            return False
        kinds = index if isinstance(index, types.BaseTuple) else (index,)
        return (
            array.ndim == len(kinds)
            and all(isinstance(kind, types.Integer) for kind in kinds)
            and not self.context.enable_boundscheck
        )

    def _element(self, name: str, array: Any, index: str, kind: Any) -> Any:
        """A pointer to an element. Negative indices count from the end."""
        builder = self.builder
        kinds = kind if isinstance(kind, types.BaseTuple) else (kind,)
        steps = []
        for k, (value, own, to) in enumerate(self._indices(index, kinds)):
            value = self.context.cast(builder, value, own, to)
            constant = getattr(value, "constant", None)
            if isinstance(constant, int) and constant >= 0:
                value = self.context.cast(builder, value, to, types.intp if to.signed else types.uintp)
            else:
                value = fix_integer_index(
                    self.context, builder, to, value, self._part(name, SHAPE, k) if to.signed else None
                )
            steps.append(value)
        data = self._part(name, DATA)
        if array.layout == "C":
            place = steps[0]
            for k in range(1, array.ndim):  # (i * columns + j) * layers + k
                place = builder.add(builder.mul(place, self._part(name, SHAPE, k)), steps[k])
            return builder.gep(data, [place])
        place = None
        for k, step in enumerate(steps):
            offset = builder.mul(step, self._part(name, STRIDES, k))
            place = offset if place is None else builder.add(place, offset)
        return builder.bitcast(builder.gep(builder.bitcast(data, ADDRESS), [place]), data.type)

    def _indices(self, name: str, kinds: Any) -> list[tuple[Any, Any, Any]]:
        """Each index with its type and the type that it is read as."""
        own = self.typeof(name)
        if name in self._pairs:
            return list(zip(self._pairs[name], own, kinds, strict=True))
        value = self.loadvar(name)
        if not isinstance(own, types.BaseTuple):
            return [(value, own, kinds[0])]
        parts = [self.builder.extract_value(value, k) for k in range(len(own))]
        return list(zip(parts, own, kinds, strict=True))

    # ------------------------------------------------------------------ expressions and calls

    def lower_expr(self, resty: Any, expr: Any) -> Any:
        """The value of an expression."""
        if expr.op == "getattr" and expr.attr == "shape":
            array = self.typeof(expr.value.name)
            if is_array(array) and isinstance(resty, types.UniTuple):
                parts = [self._part(expr.value.name, SHAPE, axis) for axis in range(array.ndim)]
                return self.context.make_tuple(self.builder, resty, parts)
        elif expr.op == "static_getitem" and expr.index_var is not None:
            array, signature = self.typeof(expr.value.name), self.fndesc.calltypes[expr]
            if signature is not None and self._is_element(array, signature.args[1]):
                return self.lower_getitem(resty, expr, expr.value, expr.index_var, signature)
        return super().lower_expr(resty, expr)

    def lower_binop(self, resty: Any, expr: Any, op: Any) -> Any:
        """Of two numbers; whether one of them is known by now makes a difference for powers only."""
        own = self.typeof(expr.lhs.name), self.typeof(expr.rhs.name)
        if op in _POWERS or not all(isinstance(kind, _NUMBER) for kind in own):
            return super().lower_binop(resty, expr, op)
        context, builder, signature = self.context, self.builder, self.fndesc.calltypes[expr]
        values = [
            context.cast(builder, self.loadvar(side.name), kind, to)
            for side, kind, to in zip((expr.lhs, expr.rhs), own, signature.args, strict=True)
        ]
        function = context.typing_context.resolve_value_type(op)
        answer = context.typing_context.call_type(function, signature.args)
        value = context.get_function(function, answer)(builder, values)
        return context.cast(builder, value, signature.return_type, resty)


@register_pass(mutates_CFG=True, analysis_only=False)
class ShortLowering(NativeLowering):
    """The step of numba's that makes LLVM's language of a kernel."""

    _name = "carom_lowering"

    @property
    def lowering_class(self) -> type[ShortLower]:
        """The function that writes it."""
        return ShortLower
