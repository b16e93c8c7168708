"""A fault put into a program that runs: its functions get the code of the changed source."""

from __future__ import annotations

import gc
import inspect
from collections.abc import Iterator
from types import CodeType, FunctionType
from typing import NamedTuple


class Change(NamedTuple):
    """What a changed source makes of the functions of a module."""

    function: str | None
    """Name of the outermost function that changes; None: nothing that is computed differs."""
    at_import: bool
    """Whether something changes that runs once, when the module is imported."""
    codes: dict[tuple[str, int], CodeType]
    """New code by the old one's qualified name and first line."""


def compare(old: str, new: str, file: str) -> Change | None:
    """How two sources of one file differ; None where they do not have the same functions."""
    before = list(_codes(compile(old, file, "exec", dont_inherit=True)))
    after = list(_codes(compile(new, file, "exec", dont_inherit=True)))
    if [code.co_qualname for code in before] != [code.co_qualname for code in after]:
        return None
    pairs = list(zip(before, after, strict=True))
    changed = [one for one, other in pairs if _said(one) != _said(other)]
    of_functions = [code for code in changed if code.co_flags & inspect.CO_OPTIMIZED]
    return Change(
        function=outermost(of_functions[0]) if of_functions else None,
        at_import=len(of_functions) < len(changed),
        codes={(one.co_qualname, one.co_firstlineno): other for one, other in pairs},
    )


def outermost(code: CodeType) -> str:
    """Qualified name of the function that a code stands in, closures and comprehensions counted to it."""
    return code.co_qualname.split(".<locals>")[0]


def functions_of(root: str) -> dict[str, list[FunctionType]]:
    """All living functions whose source lies below a folder, by file."""
    found: dict[str, list[FunctionType]] = {}
    for thing in gc.get_objects():
        if type(thing) is FunctionType and thing.__code__.co_filename.startswith(root):
            found.setdefault(thing.__code__.co_filename, []).append(thing)
    return found


def swap(functions: list[FunctionType], change: Change) -> bool:
    """Give living functions their new code; whether that can be done (closures must keep their cells)."""
    for function in functions:
        old = function.__code__
        new = change.codes.get((old.co_qualname, old.co_firstlineno))
        if new is None or old.co_freevars != new.co_freevars:
            return False
        function.__code__ = new
    return True


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)


def _said(code: CodeType) -> tuple[object, ...]:
    """What a code computes, apart from the codes within it and from where its lines are."""
    constants = repr([each for each in code.co_consts if not isinstance(each, CodeType)])
    return code.co_code, constants, code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars
