"""Code of inner kernels is optimised once, where it is used, and never made into machine code of its own.

numba finishes each function by itself: it links in all that the function calls, optimises the whole, and
makes machine code of it. An inner kernel five calls deep is optimised five times so, and its own machine code
is never run. Here it stays as it was lowered; the kernel that Python calls links in all that it needs, from
whatever depth, and is optimised with it once. A quarter of the time of compiling goes away.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import llvmlite.binding as llvm
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult


class KernelLibrary(JITCodeLibrary):
    """What both kinds share."""

    def _optimize_functions(self, ll_module: Any) -> None:
        # numba makes a manager of passes anew for each function, also for those that are declared only
        ll_module.data_layout = self._codegen._data_layout
        manager, builder = self._codegen._function_pass_manager()
        for function in ll_module.functions:
            if not function.is_declaration:
                manager.run(function, builder)


class OuterLibrary(KernelLibrary):
    """Code of a kernel that Python may call."""

    def finalize(self) -> None:
        """Link, optimise, make machine code."""
        given: list[Any] = self._linking_libraries  # type: ignore[has-type]
        self._linking_libraries = _with_all_inner(given)
        super().finalize()


class InnerLibrary(KernelLibrary):
    """Code of an inner kernel: for others to link in."""

    @property
    def codegen(self) -> Any:
        """numba's, which is not asked for addresses of what has none."""
        return _NoAddresses(self._codegen)

    def finalize(self) -> None:
        """Nothing more is added."""
        self._raise_if_finalized()
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:
        """None: there is no machine code."""
        return 0

    def linked(self) -> list[Any]:
        """Libraries of what is called here."""
        return list(self._linking_libraries)

    def bitcode(self) -> bytes:
        """This code with all that it calls, to be kept."""
        whole = self._final_module.clone()
        for library in _with_all_inner(self._linking_libraries):
            whole.link_in(library._get_module_for_linking(), preserve=True)
        return bytes(whole.as_bitcode())

    @classmethod
    def from_bitcode(cls, codegen: Any, bitcode: bytes) -> InnerLibrary:
        """As it was when it was kept."""
        library = cls(codegen, "inner")
        library._final_module = llvm.parse_bitcode(bitcode)
        library.finalize()
        return library


class _NoAddresses:
    """numba's code generator, for code that is nowhere in memory."""

    def __init__(self, codegen: Any):
        self._codegen = codegen

    def __getattr__(self, name: str) -> Any:
        return getattr(self._codegen, name)

    def set_env(self, _name: str, _environment: Any) -> None:
        """There is nothing to point at it."""


def _with_all_inner(libraries: Iterable[Any]) -> list[Any]:
    """These and what inner ones of them call, each once, whoever is called after who calls it."""
    found: dict[int, Any] = {}
    waiting = list(libraries)[::-1]
    while waiting:
        library = waiting.pop()
        if id(library) not in found:
            found[id(library)] = library
            if isinstance(library, InnerLibrary):
                waiting.extend(library.linked()[::-1])
    return list(found.values())


class OuterCompiler(Compiler):
    """numba's compiler, into a library of this module."""

    library_class: type[KernelLibrary] = OuterLibrary

    def __init__(self, typing: Any, target: Any, library: Any, *rest: Any):
        if library is None:
            library = self.library_class(target.codegen(), "kernel")
            library.enable_object_caching()
        super().__init__(typing, target, library, *rest)


class InnerCompiler(OuterCompiler):
    """The same for an inner kernel."""

    library_class = InnerLibrary


def kept_form(result: Any) -> tuple[Any, ...]:
    """What a compiled function is rebuilt from by `rebuilt`, to be pickled."""
    library = result.library
    if not isinstance(library, InnerLibrary):
        return (*result._reduce(),)
    result.fndesc.typemap = result.fndesc.calltypes = None  # large, and not to be pickled
    return (library.bitcode(), result.fndesc, result.environment, result.signature, result.reload_init)


def rebuilt(target: Any, parts: tuple[Any, ...]) -> Any:
    """A compiled function from `kept_form`."""
    if not isinstance(parts[0], bytes):
        return CompileResult._rebuild(target, *parts)
    bitcode, described, environment, signature, reload_init = parts
    for function in reload_init:
        function()
    library = InnerLibrary.from_bitcode(target.codegen(), bitcode)
    return CompileResult(
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
        referenced_envs=[],
    )
