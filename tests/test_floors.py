"""The floors of the house: each imports only those above it, and the lower ones know no screen."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest

import game

ROOT = Path(game.__file__).resolve().parent
FLOORS = (
    *(
        "definition",
        "trust",
        "folders",
        "files",
        "packed_text",
        "naming",
        "arrays",
        "settings",
    ),  # where things lie and how they are read and written: for every floor
    *(
        "compiler",
        "physics",
        "billiards",
        "level_checks",
        "teaching",
        "levels",
        "lab",
        "stage",
        "ui",
        "worlds",
        "scenes",
        "app",
        "__main__",
    ),
)
SCREENLESS = FLOORS[: FLOORS.index("ui")]
MOST_MODULES = 20  # of a folder
MOST_PARAMETERS = 9  # of a function, self not counted
# Functions that take more: at most so many, and that may only shrink. What is left: kernels called from
# Python for every shot or step, as tuples would cost more to pass than a short one to play; kernels of
# solids and of the raster, all numbers; and declarations of which callers name what they need.
MANY_PARAMETERS = 17
# The folders of a floor, from the ground up; those of one row are strangers to one another.
FOLDERS = {
    "compiler": ("tried", "sources prebuilt progress", "cache", "target", "decorator entrances"),
    "physics": (
        "kernels",
        "effects integrators",
        "fields proximity_effects dominoes accretion",
        "animation bounds broadphase constraints narrowphase particles rigid solids",
        "spheres generations oscillators acoustics spacetime deformables heat",
        "surfaces cloth waves particle_fluids hydrostatics",
        "grid",
        "multigrid",
        "gas liquid",
        "combustion stable_fluids",
        "plates",
        "tunnel",
    ),
    "billiards": (
        "table",
        "laws",
        "shot",
        "exact stepped lecture",
        "flight",
        "shot_effects",
        "simulation",
        "many growing",
        "fitting",
        "game",
        "search",
        "map rhythm",
        "players",
        "career",
    ),
    "ui": ("look raster steady", "sound", "text", "canvas", "painters widgets", "charts panel"),
    "worlds": (
        "entries quality shards stopwatch tables",
        "world",
        "painting hearing rubbing",
        "members",
        "hands",
        "expectations",
        "scene",
    ),
    "app": (
        "window",
        "stagehand",
        "compile film report",
        "screens",
        "menu scene",
        "cards",
        "application",
        "loop",
        "start fuzz",
        "commands",
    ),
}
# What decides simulated numbers, by no C library's functions but `physics.kernels.elementary`:
# these floors, and of worlds and scenes whatever does not draw.
DECIDING = ("physics", "billiards", "levels", "lab", "stage")
TRANSCENDENTAL = {  # as math and numpy have them
    *(
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "sinh",
        "cosh",
        "tanh",
        "asinh",
        "acosh",
        "atanh",
    ),
    *("exp", "exp2", "expm1", "log", "log1p", "log2", "log10", "pow", "hypot", "dist", "cbrt", "erf", "erfc"),
    *("gamma", "lgamma", "sumprod", "arcsin", "arccos", "arctan", "arctan2", "arcsinh", "arccosh", "arctanh"),
    *("power", "float_power", "logaddexp", "angle", "unwrap", "sinc", "i0"),
}
# What `game.physics.kernels.linear` has in their place.
FUSED = {
    *(
        f"np.{name}"
        for name in ("dot", "vdot", "inner", "matmul", "einsum", "tensordot", "interp", "convolve")
    ),
    *(
        f"np.linalg.{name}"
        for name in ("solve", "inv", "det", "eig", "eigh", "eigvalsh", "lstsq", "svd", "qr")
    ),
}
NOT_IN_PHYSICS = {"time", "datetime", "io", "os", "shutil", "pathlib", "tempfile", "random", "platformdirs"}


MODULES: list[tuple[str, ast.Module]] = []  # of the package: path within it, syntax tree
NAMES: set[str] = set()  # of these modules, dotted


@pytest.fixture(scope="module", autouse=True)
def modules() -> Iterator[None]:
    """Read the package for these tests only: whoever looks for garbage goes through millions of nodes."""
    for path in sorted(ROOT.rglob("*.py")):
        where = path.relative_to(ROOT).as_posix()
        MODULES.append((where, ast.parse(path.read_text(encoding="utf-8"))))
        NAMES.add(dotted(where))
    yield
    for kept in (MODULES, NAMES):
        kept.clear()
    for known in (nodes, imported, calls):
        known.cache_clear()


@cache
def nodes(tree: ast.AST) -> tuple[ast.AST, ...]:
    """All that a tree consists of."""
    return tuple(ast.walk(tree))


@cache
def imported(tree: ast.AST, where: str, typing_too: bool = True) -> tuple[str, ...]:
    """Dotted names that a module imports, relative ones in full."""
    return tuple(_imported(tree, where, typing_too))


def _imported(tree: ast.AST, where: str, typing_too: bool) -> Iterator[str]:
    package = ["game", *where.split("/")[:-1]]
    skipped = set()
    if not typing_too:
        for node in nodes(tree):
            if isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
                skipped.update(id(inner) for inner in ast.walk(node))
    for node in nodes(tree):
        if id(node) in skipped:
            continue
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            name = ".".join([*base, *filter(None, [node.module])])
            yield name
            yield from (f"{name}.{alias.name}" for alias in node.names)


def floor_of(name: str) -> str | None:
    """Floor of a dotted name or a path in the package; None outside it or for the package itself."""
    parts = name.removesuffix(".py").replace("/", ".").removeprefix("game.").split(".")
    return parts[0] if parts[0] in FLOORS else None


def roots(tree: ast.AST, where: str, typing_too: bool = True) -> set[str]:
    """First parts of the names that a module imports."""
    return {name.split(".")[0] for name in imported(tree, where, typing_too)}


@cache
def calls(tree: ast.AST) -> set[str]:
    """Names of what a module calls."""
    return {ast.unparse(node.func) for node in nodes(tree) if isinstance(node, ast.Call)}


def dotted(where: str) -> str:
    """``ui/look/look.py`` as game.ui.look.look; a package by its own name."""
    return "game." + where.removesuffix(".py").replace("/", ".").removesuffix(".__init__").removesuffix(
        "__init__"
    )


def inside(names: Iterable[str]) -> Iterator[str]:
    """Modules of the package among imported names; of a thing in a module, the module."""
    for name in names:
        if name in NAMES:
            yield name
        elif name.rpartition(".")[0] in NAMES:
            yield name.rpartition(".")[0]


def _place(order: tuple[str, ...], path: str) -> int:
    """Which row of an order names the folder or file at the head of a path."""
    head = path.partition("/")[0].removesuffix(".py")
    return next(i for i, row in enumerate(order) if head in row.split())


def test_every_module_stands_on_a_floor() -> None:
    assert [where for where, _ in MODULES if floor_of(where) is None] == ["__init__.py"]


def test_each_floor_imports_only_those_above() -> None:
    wrong = []
    for where, tree in MODULES:
        own = floor_of(where)
        for name in imported(tree, where):
            floor = floor_of(name) if name.split(".")[0] == "game" else None
            if own is not None and floor is not None and FLOORS.index(floor) > FLOORS.index(own):
                wrong.append(f"{where} imports {name}")
    assert wrong == []


def test_no_screen_below_the_ui() -> None:
    lower = [(where, tree) for where, tree in MODULES if floor_of(where) in SCREENLESS]
    assert len(lower) > 20
    assert [where for where, tree in lower if roots(tree, where) & {"pygame", "pygame_gui"}] == []


def test_the_folders_of_a_floor_import_only_those_before() -> None:
    """Folders and files that stand in one word row are strangers to one another."""
    wrong = []
    for where, tree in MODULES:
        floor, _, rest = where.partition("/")
        if floor not in FOLDERS or rest == "__init__.py":
            continue
        own = _place(FOLDERS[floor], rest)
        for name in inside(imported(tree, where)):
            parts = name.split(".")
            if len(parts) < 3 or parts[1] != floor or parts[2] == rest.partition("/")[0].removesuffix(".py"):
                continue
            if _place(FOLDERS[floor], parts[2]) >= own:
                wrong.append((where, name.removeprefix("game.")))
    assert sorted(set(wrong)) == []


def test_no_circle_of_imports_anywhere() -> None:
    """Each module can be read after those that it imports; imports for typing count."""
    waiting = {
        dotted(where): (set(inside(imported(tree, where))) & NAMES) - {dotted(where)}
        for where, tree in MODULES
    }
    for where, _ in MODULES:
        if where.endswith("__init__.py"):  # a package's face imports what lies in it
            waiting[dotted(where)] = set()
    while ready := [name for name, others in waiting.items() if not others]:
        for name in ready:
            del waiting[name]
        for others in waiting.values():
            others.difference_update(ready)
    while idle := waiting.keys() - set().union(*waiting.values()):  # what merely stands above a circle
        for name in idle:
            del waiting[name]
    assert sorted(waiting) == []


# Folders whose parts still stand in a circle; that may only shrink.
CIRCLES: set[str] = set()


def test_no_circle_of_folders() -> None:
    """What lies in one folder, files and folders, has an order: each knows only those before it."""
    known = {dotted(where): set(inside(imported(tree, where))) for where, tree in MODULES}
    packages = {dotted(where) for where, _ in MODULES if where.endswith("__init__.py")}
    found = set()
    for folder in packages:
        above = f"{folder}."
        waiting: dict[str, set[str]] = {}
        for name, others in known.items():
            if name.startswith(above):
                part = name.removeprefix(above).partition(".")[0]
                parts = {
                    other.removeprefix(above).partition(".")[0] for other in others if other.startswith(above)
                }
                waiting.setdefault(part, set()).update(parts - {part})
        while ready := [part for part, others in waiting.items() if not others & waiting.keys()]:
            for part in ready:
                del waiting[part]
        if waiting:
            found.add(folder)
    assert found == CIRCLES


def test_a_scene_is_known_to_none_of_its_parts() -> None:
    """Parts look down only: none imports a module that holds a scene, not even for typing."""
    holding = {
        dotted(where)
        for where, tree in MODULES
        if floor_of(where) == "scenes" and any(_is_scene(node) for node in tree.body)
    }
    assert len(holding) > 15
    wrong = [
        f"{where} imports {name}"
        for where, tree in MODULES
        if floor_of(where) == "scenes" and dotted(where) not in holding
        for name in inside(imported(tree, where))
        if name in holding
    ]
    assert wrong == []


def _is_scene(node: ast.stmt) -> bool:
    """A class with a base that is called a scene."""
    return isinstance(node, ast.ClassDef) and any(ast.unparse(base).endswith("Scene") for base in node.bases)


def test_no_scene_knows_the_folder_of_another() -> None:
    wrong = []
    for where, tree in MODULES:
        floor, _, rest = where.partition("/")
        if floor != "scenes" or "/" not in rest:
            continue
        allowed = {rest.split("/")[0], "shared"}
        for name in inside(imported(tree, where)):
            parts = name.split(".")
            if parts[1] == "scenes" and len(parts) > 2 and parts[2] not in allowed:
                wrong.append(f"{where} imports {name}")
    assert wrong == []


def test_no_folder_has_more_than_twenty_modules() -> None:
    folders: dict[str, int] = {}
    for where, _ in MODULES:
        folder, _, name = where.rpartition("/")
        folders[folder] = folders.get(folder, 0) + (name != "__init__.py")
    assert {folder: count for folder, count in folders.items() if count > MOST_MODULES} == {}


def parameters_of(function: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    """How many parameters a function has, positional and by keyword, without self or cls."""
    given = function.args
    names = [argument.arg for argument in (*given.posonlyargs, *given.args, *given.kwonlyargs)]
    return len(names) - (names[:1] in (["self"], ["cls"]))


def test_few_functions_take_many_parameters() -> None:
    many = [
        f"{where}: {node.name} takes {parameters_of(node)}"
        for where, tree in MODULES
        for node in nodes(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and parameters_of(node) > MOST_PARAMETERS
    ]
    assert len(many) <= MANY_PARAMETERS, "\n".join(many)
    assert len(many) == MANY_PARAMETERS, f"there are only {len(many)} left: lower MANY_PARAMETERS"


def test_physics_is_numbers_only() -> None:
    physics = [(where, tree) for where, tree in MODULES if floor_of(where) == "physics"]
    assert len(physics) > 3
    wrong = [where for where, tree in physics if roots(tree, where, typing_too=False) & NOT_IN_PHYSICS]
    assert wrong == []


def test_what_computes_does_not_talk() -> None:
    lower = [
        (where, tree)
        for where, tree in MODULES
        if floor_of(where) in ("compiler", "physics", "billiards", "stage")
    ]
    assert [where for where, tree in lower if calls(tree) & {"print", "input", "breakpoint"}] == []


def test_nothing_is_executed_from_data() -> None:
    assert [where for where, tree in MODULES if calls(tree) & {"eval", "exec", "compile"}] == []
    loaders = {"pickle", "marshal", "shelve", "dill"}
    found = [where for where, tree in MODULES if roots(tree, where) & loaders]
    assert found == ["compiler/target/kept.py"]


def test_kernels_come_from_the_one_decorator() -> None:
    wrong = []
    for where, tree in MODULES:
        if floor_of(where) == "compiler":
            continue
        for node in nodes(tree):
            named = [ast.unparse(item) for item in getattr(node, "decorator_list", [])]
            wrong += [f"{where}: @{name}" for name in named if "jit" in name or name.startswith("numba.")]
    assert wrong == []


def test_no_scipy_at_run_time() -> None:
    """Only benchmarks may import it, as a peer, when they are run."""
    users = [where for where, tree in MODULES if "scipy" in roots(tree, where)]
    assert [where for where in users if not where.startswith("lab/benchmarks/")] == []


def test_the_floors_without_a_screen_import_without_one() -> None:
    """Importing the stage brings no pygame, whatever it imports in turn."""
    code = (
        "import sys, game.stage.stage, game.billiards, game.levels, game.lab; print('pygame' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def decides(where: str, tree: ast.AST) -> bool:
    """Whether a module decides simulated numbers; one of a scene does unless it draws (but for examples)."""
    if where.startswith("worlds/painting/"):
        return False
    if floor_of(where) in ("worlds", "scenes"):
        draws = any(name.startswith("game.ui") for name in imported(tree, where))
        return not draws or where.startswith("scenes/examples/")
    return floor_of(where) in DECIDING


def libm_calls(tree: ast.AST) -> Iterator[str]:
    """What of a module a C library would reckon: functions of math and numpy, and powers of floats."""
    for node in nodes(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            if node.value.id in ("math", "np", "numpy") and node.attr in TRANSCENDENTAL:
                yield f"{node.lineno}: {ast.unparse(node)}"
        elif isinstance(node, ast.ImportFrom) and node.module in ("math", "numpy"):
            yield from (f"{node.lineno}: {a.name}" for a in node.names if a.name in TRANSCENDENTAL)
        elif isinstance(node, ast.Import) and any(alias.name == "cmath" for alias in node.names):
            yield f"{node.lineno}: cmath"
        elif (
            (isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and not _is_exact(node))
            or (isinstance(node, ast.AugAssign) and isinstance(node.op, ast.Pow))
            or (isinstance(node, ast.Call) and ast.unparse(node.func) == "pow")
        ):
            yield f"{node.lineno}: {ast.unparse(node)}"


def blas_calls(tree: ast.AST) -> Iterator[str]:
    """What of a module numpy would hand to a BLAS, or to sums that a compiler may fuse."""
    for node in nodes(tree):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult):
            yield f"{node.lineno}: {ast.unparse(node)}"
        elif isinstance(node, ast.Call):
            name = ast.unparse(node.func)
            if name in FUSED or (name.endswith(".uniform") and name != "linear.uniform"):
                yield f"{node.lineno}: {ast.unparse(node)}"


def _is_exact(power: ast.BinOp) -> bool:
    """Of two numbers as written: a whole number to a whole power, or a power of two."""
    try:
        base, exponent = ast.literal_eval(power.left), ast.literal_eval(power.right)
    except ValueError:
        return False
    return exponent == int(exponent) and (isinstance(base, int) or base in (2.0, 0.5))


def test_no_c_library_decides_a_simulated_number() -> None:
    deciding = [(where, tree) for where, tree in MODULES if decides(where, tree)]
    assert len(deciding) > 600
    wrong = [
        f"{where}:{found}"
        for where, tree in deciding
        if not where.startswith("physics/kernels/elementary/")
        for found in libm_calls(tree)
    ]
    assert wrong == []


def test_no_blas_decides_a_simulated_number() -> None:
    wrong = [
        f"{where}:{found}"
        for where, tree in MODULES
        if decides(where, tree)
        and floor_of(where) != "lab"  # which weighs and draws, and tells references apart
        for found in blas_calls(tree)
    ]
    assert wrong == []


def test_sorting_is_stable() -> None:
    """No argsort with ties in an order of its own"""
    unstable = []
    for where, tree in MODULES:
        for node in nodes(tree):
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "argsort":
                kinds = [ast.unparse(word.value).strip("'") for word in node.keywords if word.arg == "kind"]
                if kinds not in (["stable"], ["mergesort"]):
                    unstable.append(f"{where}:{node.lineno}")
    assert unstable == []


def test_the_elementary_functions_themselves_call_none() -> None:
    own = [(where, tree) for where, tree in MODULES if where.startswith("physics/kernels/elementary/")]
    assert len(own) > 5
    allowed = {"math.inf", "math.nan", "math.fabs", "math.sqrt", "math.floor", "math.copysign", "math.fsum"}
    used = {
        ast.unparse(node)
        for _, tree in own
        for node in nodes(tree)
        if isinstance(node, ast.Attribute) and ast.unparse(node.value) in ("math", "np", "numpy")
    }
    assert {name for name in used if name.startswith("math.")} <= allowed
    assert not {name for name in used if name.split(".")[1] in TRANSCENDENTAL}


def test_what_a_c_library_would_reckon_is_found() -> None:
    for code in (
        *("math.sin(x)", "np.hypot(x, y)", "x ** 2", "x **= 2", "pow(x, 2)", "10.0 ** 3", "2.0 ** x"),
        *("import cmath", "from math import exp"),
    ):
        assert list(libm_calls(ast.parse(code))), code
    for code in ("2.0 ** -53", "10 ** 9", "math.sqrt(x)", "x * x", "np.floor(x)"):
        assert not list(libm_calls(ast.parse(code))), code
