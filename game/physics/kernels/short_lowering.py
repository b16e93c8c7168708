"""numba's last step before LLVM, in fewer words.

For ``a[i, 0]`` numba copies the whole of a into memory, reads all its lengths and strides back, puts both
indices into a tuple and takes them out again: fifty lines of LLVM's language, of which five are left in the
end. Here only those five are written. Members of tuples that came in by their address (see bundles.py) are
read where they lie, once in a kernel.

What is not an element of an array of numbers, or a member of such a tuple, is left to numba.
"""

from __future__ import annotations

import operator
from collections import Counter
from functools import partial
from typing import Any

from llvmlite import ir as llvm
from numba import types
from numba.core import cgutils, ir, lowering
from numba.core.compiler_machinery import register_pass
from numba.core.errors import LoweringError, new_error_context
from numba.core.typed_passes import NativeLowering
from numba.np.arrayobj import fix_integer_index, load_item, store_item

from game.physics.kernels.bundles import ADDRESS, is_by_address
from game.physics.kernels.entering import Door, fits_door

_NUMBER = (types.Integer, types.Float, types.Boolean)
_POWERS = (operator.pow, operator.ipow)
_DATA, _SHAPE, _STRIDES = 4, 5, 6  # of the structure of an array


def _is_array(kind: Any) -> bool:
    """Whether values of a type are arrays of the usual structure."""
    return type(kind) is types.Array


class ShortLower(lowering.Lower):  # type: ignore[misc]
    """Writes a kernel in LLVM's language."""

    def init(self) -> None:
        """Find out which variables are arguments handed over by address, or members of these."""
        super().init()
        self._arguments: dict[str, int] = {}  # variable: which argument it is
        self._members: dict[str, tuple[str, tuple[int, ...]]] = {}  # variable: argument, path of members
        self._read: dict[tuple[Any, ...], Any] = {}  # what was read, by argument and path
        self._pairs: dict[str, list[Any]] = {}  # indices of several dimensions, by the tuple's variable
        if self.generator_info is None:
            self._find_members()

    def _find_members(self) -> None:
        assigned = [one for _, block in sorted(self.blocks.items()) for one in block.find_insts(ir.Assign)]
        times = Counter(one.target.name for one in assigned)
        for one in assigned:
            name, value = one.target.name, one.value
            if times[name] > 1:
                continue
            if isinstance(value, ir.Arg):
                kind = self.typeof("arg." + value.name)
                if kind == self.typeof(name) and (_is_array(kind) or is_by_address(self._model(kind))):
                    self._members[name] = name, ()
                    self._arguments[name] = value.index
            elif isinstance(value, ir.Var):
                if value.name in self._members and self.typeof(value.name) == self.typeof(name):
                    self._members[name] = self._members[value.name]
            elif isinstance(value, ir.Expr) and value.op == "getattr" and value.value.name in self._members:
                kind = self.typeof(value.value.name)
                if not is_by_address(self._model(kind)) or value.attr not in kind.fields:
                    continue
                k = kind.fields.index(value.attr)
                if kind[k] == self.typeof(name):
                    root, path = self._members[value.value.name]
                    self._members[name] = root, (*path, k)

    def _model(self, kind: Any) -> Any:
        return self.context.data_model_manager[kind]

    def extract_function_arguments(self) -> Any:
        """Values of the arguments; of arrays their parts, of tuples in memory their addresses."""
        packer = self.call_conv._get_arg_packer(self.fndesc.argtypes)
        self.fnargs = packer._unflattener.unflatten(self.call_conv.get_arguments(self.function))
        for k, kind in enumerate(self.fndesc.argtypes):
            if is_by_address(self._model(kind)):  # nobody else writes there, and nobody keeps it
                self.fnargs[k].add_attribute("noalias")
                self.fnargs[k].add_attribute("captures(none)")
            elif k not in self._arguments.values():
                self.fnargs[k] = self._model(kind).from_argument(self.builder, self.fnargs[k])
        return self.fnargs

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

    def lower_assign(self, ty: Any, inst: Any) -> Any:
        """The value of an assignment."""
        if isinstance(inst.value, ir.Arg):
            index = inst.value.index
            model, value = self._model(self.fndesc.argtypes[index]), self.fnargs[index]
            if is_by_address(model) and value.type == ADDRESS:
                self.fnargs[index] = model.load(self.builder, value)
        return super().lower_assign(ty, inst)

    def loadvar(self, name: str) -> Any:
        """The value of a variable."""
        if name in self._members:
            return self._value_of(name)
        if name in self._pairs and name not in self._blk_local_varmap:
            kind = self.typeof(name)
            self._blk_local_varmap[name] = self.context.make_tuple(self.builder, kind, self._pairs[name])
        return super().loadvar(name)

    def _alloca_var(self, name: str, fetype: Any) -> None:
        if name not in self._members:
            super()._alloca_var(name, fetype)

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

    # ------------------------------------------------------------------ members of tuples

    def _address(self, name: str) -> Any:
        """Where a variable lies that is a member, found once in the kernel."""
        root, path = self._members[name]
        key = root, path, "address"
        if key not in self._read:
            index, offset = self._arguments[root], 0
            address, model = self.fnargs[index], self._model(self.fndesc.argtypes[index])
            for k in path:
                offset, model = offset + model.offsets[k], model.members[k]
            with self.builder.goto_entry_block():
                if offset:
                    address = cgutils.gep_inbounds(self.builder, address, offset)
                if not is_by_address(model):
                    address = self.builder.bitcast(address, model.get_value_type().as_pointer())
            self._read[key] = address
        return self._read[key]

    def _value_of(self, name: str) -> Any:
        """The value of such a variable."""
        root, path = self._members[name]
        key = root, path, "value"
        if key not in self._read:
            model, builder = self._model(self.typeof(name)), self.builder
            by_parts = not path and not is_by_address(model)
            place = self.fnargs[self._arguments[root]] if by_parts else self._address(name)
            with builder.goto_entry_block():
                if by_parts:
                    self._read[key] = model.from_argument(builder, place)
                elif is_by_address(model):
                    self._read[key] = model.load(builder, place)
                else:
                    self._read[key] = builder.load(place)
        return self._read[key]

    def _part(self, name: str, *indices: int) -> Any:
        """A number or address in the structure of an array."""
        if name not in self._members:
            return self.builder.extract_value(self.loadvar(name), indices)
        root, path = self._members[name]
        if not path:
            part = self.fnargs[self._arguments[root]]
            for k in indices:
                part = part[k]
            return part
        key = root, path, indices
        if key not in self._read:
            address = self._address(name)
            with self.builder.goto_entry_block():
                place = cgutils.gep_inbounds(self.builder, address, 0, *indices)
                self._read[key] = self.builder.load(place)
        return self._read[key]

    def _parts(self, name: str, array: Any) -> Any:
        """All parts of an array, as another kernel takes them."""
        sizes = [[self._part(name, 5 + k, axis) for axis in range(array.ndim)] for k in range(2)]
        return [*(self._part(name, k) for k in range(5)), *sizes]

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
        array, kind, given = self.typeof(target.name), *signature.args[1:]
        if array != signature.args[0] or not self._is_element(array, kind) or not isinstance(given, _NUMBER):
            return super().lower_setitem(target, index, value, signature)
        place = self._element(target.name, array, index.name, kind)
        item = self.context.cast(self.builder, self.loadvar(value.name), self.typeof(value.name), given)
        item = self.context.cast(self.builder, item, given, array.dtype)
        store_item(self.context, self.builder, array, item, place)
        return None

    def _is_element(self, array: Any, index: Any) -> bool:
        """Whether an index of this type gives a number of an array."""
        if not _is_array(array) or not isinstance(array.dtype, _NUMBER):
            return False
        kinds = index if isinstance(index, types.BaseTuple) else (index,)
        return (
            array.ndim == len(kinds)
            and array.layout in "CA"
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
                    self.context, builder, to, value, self._part(name, _SHAPE, k) if to.signed else None
                )
            steps.append(value)
        data = self._part(name, _DATA)
        if array.layout == "C":
            place = steps[0]
            for k in range(1, array.ndim):  # (i * columns + j) * layers + k
                place = builder.add(builder.mul(place, self._part(name, _SHAPE, k)), steps[k])
            return builder.gep(data, [place])
        place = None
        for k, step in enumerate(steps):
            offset = builder.mul(step, self._part(name, _STRIDES, k))
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

    # ------------------------------------------------------------------ doors

    def create_cpython_wrapper(self, release_gil: bool = False) -> None:
        """A door for Python."""
        context, described = self.context, self.fndesc
        if self.genlower or not fits_door(context, described.argtypes):
            super().create_cpython_wrapper(release_gil)
            return
        module = context.create_module("wrapper")
        kind = self.call_conv.get_function_type(described.restype, described.argtypes)
        inner = llvm.Function(module, kind, described.llvm_func_name)
        Door(context, module, inner, described, self.env, self.call_helper, release_gil).build()
        self.library.add_ir_module(module)

    def create_cfunc_wrapper(self) -> None:
        """A door for C: of kernels of numbers only, which machine code calls by their address."""
        if all(isinstance(kind, types.Number) for kind in self.fndesc.argtypes):
            super().create_cfunc_wrapper()

    # ------------------------------------------------------------------ expressions and calls

    def lower_expr(self, resty: Any, expr: Any) -> Any:
        """The value of an expression."""
        if expr.op == "getattr" and expr.attr == "shape":
            array = self.typeof(expr.value.name)
            if _is_array(array) and isinstance(resty, types.UniTuple):
                parts = [self._part(expr.value.name, _SHAPE, axis) for axis in range(array.ndim)]
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
        answer = function.get_call_type(context.typing_context, signature.args, {})
        value = context.get_function(function, answer)(builder, values)
        return context.cast(builder, value, signature.return_type, resty)

    def fold_call_args(self, fnty: Any, signature: Any, pos_args: Any, vararg: Any, kw_args: Any) -> Any:
        """Arguments of a call; one of another kernel gets addresses and parts."""
        self._calls_kernel = isinstance(fnty, types.Dispatcher)
        return super().fold_call_args(fnty, signature, pos_args, vararg, kw_args)

    def _cast_var(self, var: Any, ty: Any) -> Any:
        name = getattr(var, "name", None)
        if self._calls_kernel and name in self._members and self.typeof(name) == ty:
            if is_by_address(self._model(ty)):
                return self._address(name)
            if _is_array(ty):
                return self._parts(name, ty)
        return super()._cast_var(var, ty)


@register_pass(mutates_CFG=True, analysis_only=False)
class ShortLowering(NativeLowering):  # type: ignore[misc]
    """The step of numba's that makes LLVM's language of a kernel."""

    _name = "carom_lowering"

    @property
    def lowering_class(self) -> type[ShortLower]:
        """Who writes it."""
        return ShortLower
