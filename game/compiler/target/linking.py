"""Code of inner kernels is optimised once, where it is used, and never made into machine code of its own.

numba finishes each function by itself: it links in all that the function calls, optimises the whole, and
makes machine code of it. An inner kernel five calls deep is optimised five times so, and its own machine code
is never run. Here it stays as it was lowered. The kernel that Python calls links in all that it needs, from
whatever depth, and is optimised with it once. A fifth of the time of compiling goes away.

Each function's name in the code is its own in all processes (see contexts.py). So what two kept kernels hold
under one name is the same.

Of a finished kernel numba keeps LLVM's module twice, for a look at it and for others to link in. Here both
are let go, and bitcode is kept, a fraction of their size: it is read where another kernel links it in.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any

import llvmlite.binding as llvm
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult
from numba.core.environment import lookup_environment
from numba.core.typed_passes import NativeLowering, NopythonRewrites

from game.compiler.target.short_lowering import ShortLowering
from game.compiler.target.short_rewrites import ShortRewrites

_ENVIRONMENT = "_ZN08NumbaEnv"  # how the name of a function's environment begins, numba's table of constants
_OWN_STEPS = {NativeLowering: ShortLowering, NopythonRewrites: ShortRewrites}  # by those of numba's
_CIRCLE = ".numba.unresolved$"  # and that of a function that is called before it is there


class KernelLibrary(JITCodeLibrary):
    """Code of a kernel that Python may call."""

    counts_references = True
    environments: list[Any]  # of the functions whose code is in it
    symbols: list[str]  # names of what it calls and does not hold
    _final_module: Any
    _bitcode = (
        b""  # of all that others may link in; none before it is finished, or where it must stay a module
    )
    _code = b""  # machine code, until it is kept

    def _optimize_functions(self, ll_module: Any) -> None:
        # numba runs all passes on each function by itself as well, with a manager made anew for each, also
        # for those that are declared only; the passes on the whole do all of that again
        ll_module.data_layout = self._codegen._data_layout

    def finalize(self) -> None:
        """Link, optimise, make machine code."""
        linked = _with_all_inner(self._linking_libraries)  # type: ignore[has-type]
        self._linking_libraries = [_Own(one) if isinstance(one, InnerLibrary) else one for one in linked]
        super().finalize()
        self._linking_libraries = []
        for environment in self.environments:
            self._codegen.set_env(environment.env_name, environment)

    def _finalize_final_module(self) -> None:
        module = self._final_module
        self.environments = environments_of(module)
        self.symbols = symbols_of(module)
        if any(one.name.startswith(_CIRCLE) for one in module.global_variables):
            super()._finalize_final_module()  # an address in it is filled in later
            return
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._codegen._engine._load_defined_symbols(module)
        self._code = self._codegen._tm.emit_object(module)
        for function in module.functions:
            if not function.is_declaration and function.linkage == llvm.Linkage.external:
                function.linkage = "linkonce_odr"
        self._bitcode = module.as_bitcode()
        self._final_module = llvm.parse_assembly(str(self._codegen._create_empty_module(self.name)))
        self._load(self._code)
        self._codegen._scan_and_fix_unresolved_refs(module)

    def _load(self, code: bytes) -> None:
        """Have LLVM take machine code, as that of a module without anything."""
        self.enable_object_caching()
        self._set_compiled_object(code)
        super()._finalize_final_module()

    @classmethod
    def from_object(cls, codegen: Any, name: str, code: bytes, bitcode: bytes) -> KernelLibrary:
        """As it was when it was kept."""
        library = cls(codegen, name)
        library._bitcode = bitcode
        library._load(code)
        codegen._engine._load_defined_symbols(library._get_module_for_linking())
        return library

    def serialize_using_object_code(self) -> Any:
        """Name, form and parts, as numba has them; the machine code is handed over once."""
        if not self._bitcode:
            return super().serialize_using_object_code()
        code, self._code = self._code, b""
        return self.name, "object", (code, self._bitcode)

    def _get_module_for_linking(self) -> Any:
        self._ensure_finalized()
        return llvm.parse_bitcode(self._bitcode) if self._bitcode else super()._get_module_for_linking()

    def get_defined_functions(self) -> Any:
        """Functions whose code is in it."""
        return [one for one in self._get_module_for_linking().functions if not one.is_declaration]

    def get_llvm_str(self) -> str:
        """The module in LLVM's language."""
        return str(self._get_module_for_linking())

    def get_asm_str(self) -> str:
        """The machine's instructions."""
        return str(self._codegen._tm.emit_assembly(self._get_module_for_linking()))

    def _optimize_final_module(self) -> None:
        # numba runs a cheaper set of passes before, so that counts of references meet and cancel each other
        if self.counts_references:
            super()._optimize_final_module()
            return
        manager, builder = self._codegen._module_pass_manager()
        manager.run(self._final_module, builder)


class InnerLibrary(KernelLibrary):
    """Code of an inner kernel: for others to link in."""

    @property
    def codegen(self) -> Any:
        """numba's, which is not asked for addresses of what has none."""
        return _NoAddresses(self._codegen)

    def finalize(self) -> None:
        """Nothing more is added. Variables leave the memory, and what is unused goes."""
        self._raise_if_finalized()
        manager, builder = _tidying(self._codegen)
        manager.run(self._final_module, builder)
        if any(one.name.startswith(_CIRCLE) for one in self._final_module.global_variables):
            raise NotImplementedError("lean or inner kernels that call each other in a circle: use kernel")
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:
        """None: there is no machine code."""
        return 0

    def whole(self) -> Any:
        """This code with all that it calls."""
        whole = self._final_module.clone()
        for library in _with_all_inner(self._linking_libraries):
            one = _Own(library) if isinstance(library, InnerLibrary) else library
            whole.link_in(one._get_module_for_linking(), preserve=True)
        return whole

    def own(self) -> Any:
        """This code alone, to be linked where what it calls is linked as well."""
        return super()._get_module_for_linking()

    def _get_module_for_linking(self) -> Any:
        # asked for by numba's own libraries, as those of a test, which look no deeper
        module = self.whole()
        for function in module.functions:
            if not function.is_declaration and function.linkage == llvm.Linkage.external:
                function.linkage = "linkonce_odr"
        return module

    @classmethod
    def from_bitcode(cls, codegen: Any, bitcode: bytes) -> InnerLibrary:
        """As it was when it was kept."""
        library = cls(codegen, "inner")
        library._final_module = llvm.parse_bitcode(bitcode)
        library.finalize()
        return library


@cache
def _tidying(codegen: Any) -> tuple[Any, Any]:
    """Passes that take variables out of memory, and then drop what is not used any more.

    The latter are, above all, the addresses of the kernels that are called. numba mentions them beside each
    call, and the next process has others: code that uses one cannot be kept.
    """
    manager = llvm.create_new_module_pass_manager()
    manager.add_sroa_pass()
    manager.add_simplify_cfg_pass()
    manager.add_dead_code_elimination_pass()
    manager.add_global_dead_code_eliminate_pass()
    return manager, codegen._pass_builder(opt=0)


class _Own:
    """An inner library that hands over its own code only."""

    def __init__(self, library: InnerLibrary):
        self._reload_init = library._reload_init
        self._get_module_for_linking = library.own


class _NoAddresses:
    """numba's code generator, for code that is nowhere in memory."""

    def __init__(self, codegen: Any):
        self._codegen = codegen

    def __getattr__(self, name: str) -> Any:
        return getattr(self._codegen, name)

    def set_env(self, _name: str, _environment: Any) -> None:
        """There is nothing to point at it; that is done where the code is linked in."""


def _with_all_inner(libraries: Iterable[Any]) -> list[Any]:
    """These and what inner ones of them call, each once, the called after the caller."""
    found: dict[int, Any] = {}
    waiting = list(libraries)[::-1]
    while waiting:
        library = waiting.pop()
        if id(library) not in found:
            found[id(library)] = library
            if isinstance(library, InnerLibrary):
                waiting.extend(library._linking_libraries[::-1])
    return list(found.values())


class OuterCompiler(Compiler):
    """numba's compiler, into a library of this module."""

    library_class: type[KernelLibrary] = KernelLibrary

    def __init__(
        self, typing: Any, target: Any, library: Any, arguments: Any, returned: Any, flags: Any, local: Any
    ):
        if library is None:
            library = self.library_class(target.codegen(), "kernel")
            library.counts_references = bool(flags.nrt)
            library.enable_object_caching()
        super().__init__(typing, target, library, arguments, returned, flags, local)

    def define_pipelines(self) -> list[Any]:
        """numba's steps, two of them in this package's form."""
        found: list[Any] = super().define_pipelines()
        for pipeline in found:
            pipeline.passes = [(_OWN_STEPS.get(step, step), said) for step, said in pipeline.passes]
            pipeline.finalize()
        return found


class InnerCompiler(OuterCompiler):
    """The same for an inner kernel."""

    library_class = InnerLibrary


def environments_of(module: Any) -> list[Any]:
    """Environments of the functions whose code is in a module."""
    names = [one.name for one in module.global_variables if one.name.startswith(_ENVIRONMENT)]
    return [found for found in map(lookup_environment, names) if found is not None]


def symbols_of(module: Any) -> list[str]:
    """Names of what the code in a module calls and does not hold."""
    return sorted(function.name for function in module.functions if function.is_declaration)


def kept_form(result: Any) -> tuple[list[str], tuple[Any, ...]]:
    """Symbols that a compiled function calls, and what `rebuilt` makes it of; to be pickled."""
    library = result.library
    if not isinstance(library, InnerLibrary):
        bare = result._replace(type_annotation="")  # or numba writes down the type of each statement
        cached = tuple(one for one in library.environments if one.can_cache())
        return library.symbols, (*bare._reduce()[:-1], cached)
    whole = library.whole()
    result.fndesc.typemap = result.fndesc.calltypes = None  # large, and not to be pickled
    environments = [one for one in environments_of(whole) if one.can_cache()]
    parts = result.fndesc, result.environment, result.signature, result.reload_init, environments
    return symbols_of(whole), (bytes(whole.as_bitcode()), *parts)


def rebuilt(target: Any, parts: tuple[Any, ...]) -> Any:
    """A compiled function from the second part of its `kept_form`; LLVM must know the symbols by now."""
    if isinstance(parts[0], bytes):
        bitcode, described, environment, signature, reload_init, environments = parts
    else:
        (name, _, coded), described, environment, signature, _, _, _, reload_init, environments = parts
    for function in reload_init:
        function()
    if isinstance(parts[0], bytes):
        library: KernelLibrary = InnerLibrary.from_bitcode(target.codegen(), bitcode)
    else:
        library = KernelLibrary.from_object(target.codegen(), name, *coded)
    result = CompileResult(
        typing_context=target.typing_context,
        target_context=target,
        entry_point=target.get_executable(library, described, environment),
        typing_error=None,
        type_annotation="",
        signature=signature,
        objectmode=False,
        lifted=(),
        fndesc=described,
        library=library,
        call_helper=None,
        environment=environment,
        metadata=None,
        reload_init=reload_init,
        referenced_envs=environments,
    )
    for one in environments:
        library.codegen.set_env(one.env_name, one)
    return result
