"""Which sources belong to a kernel: whatever form an import is written in, it is found."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import game
from game.compiler import sources
from game.compiler.sources import closure_of, imports_of, module_name, source_digest

ROOT = Path(game.__file__).resolve().parent

FORMS = {
    "import game.a": {"game.a"},
    "import game.a.b as c": {"game.a.b"},
    "import os, game.a as x, game.b": {"game.a", "game.b"},
    "    import game.a": {"game.a"},
    "if fast: import game.a": {"game.a"},
    "x = 1; import game.a; import game.b": {"game.a", "game.b"},
    "import game.a, \\\n    game.b": {"game.a", "game.b"},
    "from game import a": {"game.a"},
    "from game.a import b as c, d": {"game.a", "game.a.b", "game.a.d"},
    "from game.a import (b,\n    c as d,\n)": {"game.a.b", "game.a.c"},
    "from game.a import (  # one)\n    b,  # (two\n    # three, four)\n    c,\n)": {"game.a.b", "game.a.c"},
    "from game.a import(b)": {"game.a.b"},
    "from game.a import \\\n    b, \\\n    c": {"game.a.b", "game.a.c"},
    "from game.a import \\\r\n    b": {"game.a.b"},
    "from game.a import *": {"game.a"},
    "from game.a import b  # and c, d": {"game.a.b"},
    "from . import a": {"game.here.a"},
    "from .a import b": {"game.here.a", "game.here.a.b"},
    "from .. import a": {"game.a"},
    "from ..a.b import c": {"game.a.b", "game.a.b.c"},
    "try:\n\tfrom game.a import b\nexcept ImportError: from game.c import d": {"game.a.b", "game.c.d"},
    "def f():\n        from game.a import b": {"game.a.b"},
    "import_module('game.a.b')": {"game.a.b"},
    'LATER = {"B": "game.a.b"}': {"game.a.b"},
    "import_module('.a', __package__)": {"game.here.a"},
    "from game.a import b; from game.c import d": {"game.a.b", "game.c.d"},
    "import game.a\nimport game.b\n": {"game.a", "game.b"},
}


@pytest.mark.parametrize("form", list(FORMS))
def test_forms_of_import(form: str) -> None:
    assert imports_of(form, "game.here.me", is_package=False) >= FORMS[form]


def test_relative_imports_of_a_package() -> None:
    assert imports_of("from . import a", "game.here", is_package=True) >= {"game.here.a"}


def by_syntax(path: Path) -> set[str]:
    """The slow twin: what the syntax tree of a module imports."""
    name = module_name(path)
    assert name is not None
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            origin = ".".join([*base, *filter(None, [node.module])])
            found.add(origin)
            found.update(f"{origin}.{alias.name}" for alias in node.names if alias.name != "*")
    return found


def test_nothing_is_missed_in_the_whole_package() -> None:
    modules = sorted(ROOT.rglob("*.py"))
    assert len(modules) > 30
    for path in modules:
        text = path.read_text(encoding="utf-8")
        found = imports_of(text, module_name(path) or "", path.name == "__init__.py")
        assert by_syntax(path) <= found, path


def test_a_closure_holds_its_own_file_and_what_it_imports() -> None:
    closure = closure_of(ROOT / "stage" / "watch.py")
    assert closure == sorted(
        ROOT / name
        for name in (
            *("stage/watch.py", "physics/kernels/finite.py", "folders.py", "trust.py"),
            *(f"compiler/{name}.py" for name in ("cache", "decorator", "prebuilt", "progress", "sources")),
            "compiler/tried.py",
            *(path.relative_to(ROOT) for path in (ROOT / "compiler" / "target").glob("[a-z]*.py")),
        )
    )


def test_the_compiler_belongs_to_every_digest(monkeypatch: pytest.MonkeyPatch) -> None:
    path = ROOT / "files.py"
    assert sources.COMPILER_FILES[0] not in closure_of(path)
    before = source_digest(path)
    texts = dict.fromkeys(sources.COMPILER_FILES, b"another compiler")
    monkeypatch.setattr(sources, "_text_digest", lambda file: texts.get(file) or sources._source(file))
    source_digest.cache_clear()
    try:
        assert source_digest(path) != before
    finally:
        source_digest.cache_clear()


def test_files_outside() -> None:
    assert module_name(Path(__file__)) is None
    with pytest.raises(ValueError, match="not in the package"):
        closure_of(Path(__file__))
    with pytest.raises(OSError, match="no_such_module"):
        source_digest(ROOT / "physics" / "no_such_module.py")
