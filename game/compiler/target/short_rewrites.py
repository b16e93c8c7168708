"""numba's rewriting of array expressions, left out of kernels that have none.

numba looks for expressions of whole arrays, such as ``a + b``. Before that it notes after each statement
which variables are no longer needed, and afterwards it removes these notes. Most kernels read arrays element
by element: there is nothing to find.
"""

from __future__ import annotations

from typing import Any

from numba.core import ir, types
from numba.core.compiler_machinery import register_pass
from numba.core.rewrites import rewrite_registry
from numba.core.typed_passes import NopythonRewrites

# The rules that numba applies once types are known. The first two match an index that is a text.
# The others match an array that an operator or a call returns.
_KNOWN = {
    "RewriteStringLiteralGetitems",
    "RewriteStringLiteralSetitems",
    "RewriteArrayOfConsts",
    "RewriteArrayExprs",
}
_MAKING = frozenset(("unary", "binop", "call"))


@register_pass(mutates_CFG=True, analysis_only=False)
class ShortRewrites(NopythonRewrites):
    """The step of numba's that rewrites what has types."""

    _name = "carom_rewrites"

    def run_pass(self, state: Any) -> bool:
        """Rewrite, if there may be something to rewrite."""
        return bool(super().run_pass(state)) if may_be_rewritten(state.func_ir, state.typemap) else False


def may_be_rewritten(code: Any, kinds: Any) -> bool:
    """Whether a kernel has what one of numba's rules may match. ``kinds``: types by names of variables."""
    if {rule.__name__ for rule in rewrite_registry.rewrites["after-inference"]} != _KNOWN:
        return True
    if any(isinstance(kind, types.StringLiteral) for kind in kinds.values()):  # type: ignore[attr-defined]
        return True
    return any(
        isinstance(one.value, ir.Expr)
        and one.value.op in _MAKING
        and isinstance(kinds.get(one.target.name), types.Array)
        for block in code.blocks.values()
        for one in block.find_insts(ir.Assign)
    )
