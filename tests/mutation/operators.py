"""The small faults that can be sown: a sign, an index, a comparison, a dropped term, a forgotten write."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from typing import NamedTuple

COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
}
ARITHMETIC: dict[type[ast.operator], tuple[type[ast.operator], ...]] = {
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Mult,),
    ast.Mod: (ast.Mult,),
}


class Fault(NamedTuple):
    """One change of a source text: what stands between two offsets (bytes) is replaced."""

    kind: str
    line: int
    start: int
    end: int
    old: str
    new: str


def find_faults(source: str) -> list[Fault]:
    """All faults that can be sown into a source, in the order of its text.

    Docstrings, annotations, decorators and messages of errors are left alone: they do not compute.
    """
    offsets = _line_offsets(source)
    raw = source.encode()
    faults = []
    for node, inside_function in _walk(ast.parse(source), False):
        for kind, changed in _change(node, inside_function):
            start = offsets[node.lineno - 1] + node.col_offset  # type: ignore[attr-defined]
            end = offsets[node.end_lineno - 1] + node.end_col_offset  # type: ignore[attr-defined]
            new = changed if isinstance(changed, str) else ast.unparse(changed)
            if isinstance(node, (ast.BinOp, ast.BoolOp, ast.Compare, ast.UnaryOp)):
                new = f"({new})"
            faults.append(Fault(kind, node.lineno, start, end, raw[start:end].decode(), new))  # type: ignore[attr-defined]
    return sorted(faults, key=lambda fault: (fault.start, fault.kind, fault.new))


def sow(source: str, fault: Fault) -> str:
    """The source with one fault in it."""
    raw = source.encode()
    return (raw[: fault.start] + fault.new.encode() + raw[fault.end :]).decode()


def _walk(node: ast.AST, inside_function: bool) -> Iterator[tuple[ast.AST, bool]]:
    """Every node that computes, and whether it stands within a function."""
    yield node, inside_function
    for field, value in ast.iter_fields(node):
        if field in ("annotation", "returns", "decorator_list", "exc", "msg"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if not isinstance(child, ast.AST) or isinstance(
                child, (ast.Import, ast.ImportFrom, ast.JoinedStr)
            ):
                continue
            yield from _walk(child, inside_function or isinstance(node, (ast.FunctionDef, ast.Lambda)))


def _change(node: ast.AST, inside_function: bool) -> Iterator[tuple[str, ast.AST | str]]:
    """The changed forms of one node, each with the name of its kind."""
    if isinstance(node, ast.Compare) and len(node.ops) == 1:
        for other in COMPARISONS.get(type(node.ops[0]), ()):
            yield "comparison", _with(node, ops=[other()])
    elif isinstance(node, ast.BinOp) and not isinstance(node.left, ast.Constant | ast.JoinedStr):
        for operator in ARITHMETIC.get(type(node.op), ()):
            yield "operator", _with(node, op=operator())
        if isinstance(node.op, (ast.Add, ast.Sub)):
            yield "dropped term", node.left
    elif isinstance(node, ast.BoolOp):
        yield "and or", _with(node, op=ast.Or() if isinstance(node.op, ast.And) else ast.And())
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.Not)):
        yield "sign", node.operand
    elif isinstance(node, ast.Constant) and inside_function:
        yield from _change_number(node)
    elif isinstance(node, ast.AugAssign) and isinstance(node.op, (ast.Add, ast.Sub)):
        yield "sign", _with(node, op=ast.Sub() if isinstance(node.op, ast.Add) else ast.Add())
        yield "forgotten write", "pass"
    elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) and inside_function:
        yield "forgotten call", "pass"
    elif (
        isinstance(node, ast.Assign)
        and inside_function
        and isinstance(node.targets[0], (ast.Subscript, ast.Attribute))
    ):
        yield "forgotten write", "pass"


def _change_number(node: ast.Constant) -> Iterator[tuple[str, ast.AST | str]]:
    """A number that is one too large, or a tenth too large."""
    if isinstance(node.value, bool):
        yield "constant", ast.Constant(not node.value)
    elif isinstance(node.value, int):
        yield "constant", ast.Constant(node.value + 1 if node.value < 2 else node.value - 1)
    elif isinstance(node.value, float):
        yield "constant", ast.Constant(node.value * 1.1 if node.value else 1.0)


def _with(node: ast.AST, **fields: object) -> ast.AST:
    """A copy of a node with other fields."""
    changed = copy.copy(node)
    for name, value in fields.items():
        setattr(changed, name, value)
    return changed


def _line_offsets(source: str) -> list[int]:
    """Where each line begins, in bytes."""
    offsets = [0]
    for line in source.encode().splitlines(keepends=True):
        offsets.append(offsets[-1] + len(line))
    return offsets
