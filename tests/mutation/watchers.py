"""Which tests watch over a module: those that import it first, then its folder's, then what stands on it."""

from __future__ import annotations

import ast
from functools import cache
from itertools import takewhile
from pathlib import Path

SLOW = ("tests/benchmarks", "tests/mutation")


class Watchers:
    """The tests of one checkout, found by what they import."""

    def __init__(self, root: Path) -> None:
        """Read the imports of all modules and tests below `root`."""
        self.root = root
        sources = {_module_name(path, root): path for path in sorted((root / "game").rglob("*.py"))}
        self.modules = sources
        self.imports = {name: self._imports_of(path) for name, path in sources.items()}
        self.tests = {
            path: self._imports_of(path)
            for path in sorted((root / "tests").rglob("test_*.py"))
            if not path.relative_to(root).as_posix().startswith(SLOW)
        }

    def near(self, module: str) -> list[str]:
        """Test files that import the module by itself or bear its name, nearest first."""
        name = module.rsplit(".", 1)[-1]
        named = [path for path in self.tests if path.stem == f"test_{name}"]
        direct = [path for path, imports in self.tests.items() if module in imports]
        return self._nearest_first(module, [*named, *direct])

    def folder(self, module: str) -> list[str]:
        """Test files of the mirrored folder, and those that import what imports the module."""
        parts = module.split(".")[1:-1]
        while parts and not (self.root / "tests" / Path(*parts)).is_dir():
            parts.pop()
        mirrored = sorted((self.root / "tests" / Path(*parts)).glob("test_*.py")) if parts else []
        users = {name for name, imports in self.imports.items() if module in imports}
        second = [path for path, imports in self.tests.items() if users & imports]
        return self._nearest_first(module, [*(path for path in mirrored if path in self.tests), *second])

    def scenes(self, module: str) -> list[str]:
        """Names of scene folders that stand on the module, directly or not."""
        standing = self._standing_on(module)
        return sorted(
            {
                name.split(".")[2]
                for name in standing
                if name.startswith("game.scenes.") and name.count(".") > 2
            }
        )

    @cache  # noqa: B019 - one object lives as long as the program
    def _standing_on(self, module: str) -> frozenset[str]:
        found = {module}
        grown = True
        while grown:
            more = {name for name, imports in self.imports.items() if name not in found and imports & found}
            grown = bool(more)
            found |= more
        return frozenset(found)

    def _imports_of(self, path: Path) -> frozenset[str]:
        """Modules of the game that a file imports: where the names are defined, not handed on."""
        found: set[str] = set()
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Import):
                found |= {alias.name for alias in node.names if alias.name.startswith("game")}
            elif (
                isinstance(node, ast.ImportFrom)
                and node.module
                and node.level == 0
                and node.module.startswith("game")
            ):
                package = node.module or ""
                found.add(package)
                found |= {self._home(package, alias.name) for alias in node.names}
        return frozenset(found)

    @cache  # noqa: B019 - one object lives as long as the program
    def _home(self, package: str, name: str) -> str:
        """The module that defines a name which a package hands on."""
        below = self.root / Path(*package.split("."))
        if (below / f"{name}.py").exists() or (below / name).is_dir():
            return f"{package}.{name}"
        front = below / "__init__.py"
        if front.exists():
            for node in ast.walk(ast.parse(front.read_text())):
                if (
                    isinstance(node, ast.ImportFrom)
                    and node.module
                    and any(alias.name == name for alias in node.names)
                ):
                    return self._home(node.module, name) if node.module != package else package
        return package

    def _nearest_first(self, module: str, paths: list[Path]) -> list[str]:
        """Paths of tests, those that share most folders with a module foremost."""
        names = [path.relative_to(self.root).as_posix() for path in dict.fromkeys(paths)]

        def shared(name: str) -> int:
            pairs = zip(name.split("/")[1:], module.split(".")[1:], strict=False)
            return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))

        return sorted(names, key=shared, reverse=True)


def _module_name(path: Path, root: Path) -> str:
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
