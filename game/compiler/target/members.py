"""What comes into a kernel, read where it lies: arguments, and members of those handed over by address.

numba makes values of all arguments first, and copies of them in memory. Here what a kernel asks for is read
once, at its beginning. What it only hands on to another kernel is not read at all.
"""

from __future__ import annotations

from collections import Counter
from typing import Any

from llvmlite import ir as llvm
from numba import types
from numba.core import cgutils, ir, lowering

from game.compiler.target.bundles import ADDRESS, is_by_address
from game.compiler.target.entries import Entry, fits_entry

DATA, SHAPE, STRIDES = 4, 5, 6  # of the structure of an array


def is_array(kind: Any) -> bool:
    """Whether values of a type are arrays of the usual structure."""
    return type(kind) is types.Array


class MemberLower(lowering.Lower):
    """numba's lowering, with arguments as they are handed over."""

    def init(self) -> None:
        """Find out which variables are arguments of several parts, or members of such."""
        super().init()
        self._calls_kernel = False
        self._arguments: dict[str, int] = {}  # variable: which argument it is
        self._members: dict[str, tuple[str, tuple[int, ...]]] = {}  # variable: argument, path of members
        self._read: dict[tuple[Any, ...], Any] = {}  # what was read, by argument and path
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
                if kind == self.typeof(name) and (is_array(kind) or is_by_address(self._model(kind))):
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
        if self.generator_info is not None:  # it keeps them between two calls, in numba's form
            return super().extract_function_arguments()
        packer = self.call_conv._get_arg_packer(self.fndesc.argtypes)
        self.fnargs = packer._unflattener.unflatten(self.call_conv.get_arguments(self.function))
        for k, kind in enumerate(self.fndesc.argtypes):
            if is_by_address(self._model(kind)):  # no other code writes there or keeps it
                self.fnargs[k].add_attribute("noalias")
                self.fnargs[k].add_attribute("captures(none)")
            elif k not in self._arguments.values():
                self.fnargs[k] = self._model(kind).from_argument(self.builder, self.fnargs[k])
        return self.fnargs

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
        return self._value_of(name) if name in self._members else super().loadvar(name)

    def _alloca_var(self, name: str, fetype: Any) -> None:
        if name not in self._members:
            super()._alloca_var(name, fetype)

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
        whole = [self._part(name, k) for k in range(SHAPE)]
        return [
            *whole,
            *([self._part(name, k, axis) for axis in range(array.ndim)] for k in (SHAPE, STRIDES)),
        ]

    # ------------------------------------------------------------------ calls, entries

    def fold_call_args(self, fnty: Any, signature: Any, pos_args: Any, vararg: Any, kw_args: Any) -> Any:
        """Arguments of a call; one of another kernel gets addresses and parts."""
        self._calls_kernel = isinstance(fnty, types.Dispatcher)
        return super().fold_call_args(fnty, signature, pos_args, vararg, kw_args)

    def _cast_var(self, var: Any, ty: Any) -> Any:
        name = getattr(var, "name", None)
        if self._calls_kernel and name in self._members and self.typeof(name) == ty:
            if is_by_address(self._model(ty)):
                return self._address(name)
            if is_array(ty):
                return self._parts(name, ty)
        return super()._cast_var(var, ty)

    def create_cpython_wrapper(self, release_gil: bool = False) -> None:
        """An entry for Python."""
        context, described = self.context, self.fndesc
        if self.genlower or not fits_entry(context, described.argtypes):
            super().create_cpython_wrapper(release_gil)
            return
        module = context.create_module("wrapper")
        kind = self.call_conv.get_function_type(described.restype, described.argtypes)
        inner = llvm.Function(module, kind, described.llvm_func_name)
        Entry(context, module, inner, described, self.env, self.call_helper, release_gil).build()
        self.library.add_ir_module(module)

    def create_cfunc_wrapper(self) -> None:
        """An entry for C: of kernels of numbers only, which machine code calls by their address."""
        if all(isinstance(kind, types.Number) for kind in self.fndesc.argtypes):
            super().create_cfunc_wrapper()
