"""The kernel decorator and its disk cache: never stale, never in the way.

Each proof runs processes of their own on a small copy of the package, with a cache folder of their own.
"""

from __future__ import annotations

import hashlib
import json
import os
import pickle
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

import game
from game.compiler import cache, decorator
from game.compiler.cache import code_folder
from game.compiler.decorator import kernel
from game.compiler.prebuilt import GENERIC
from game.compiler.progress import Compiling, compiling
from game.compiler.target.kept import KernelCache

HELPER = """
from game.compiler.decorator import kernel
@kernel
def helper(x):
    return x + 1.0
"""
CONSTANTS = "FACTOR = 10.0\n"
USER = '''
"""A kernel that calls one of another file and uses a constant of a third."""
from game.compiler.decorator import (  # the bracket :) in this remark is none of the import's
    kernel,
)
from game.physics import (
    helping as h,  # a helper (in another file)
)
from ..constants import FACTOR

helper = h.helper
@kernel
def user(x):
    return FACTOR * helper(x)

def make(bits):
    @kernel
    def masked(x):
        if bits & 1:
            return x + 100.0
        return x
    return masked
'''
PROBE = """
import json, sys
from game.physics import using
from game.compiler.progress import compiling
one, two = using.make(0), using.make(1)
values = [using.user(1.0), one(1.0), two(1.0)]
kernels = [using.user, using.helper, one, two]
stats = [k.stats for k in kernels if hasattr(k, "stats")]
print(json.dumps({
    "values": values,
    "misses": sum(sum(s.cache_misses.values()) for s in stats),
    "hits": sum(sum(s.cache_hits.values()) for s in stats),
    "compiled": compiling().done,
}))
"""


class Answer(NamedTuple):
    """What a probing process says."""

    values: list[float]
    misses: int
    hits: int
    compiled: int


COLD = Answer([20.0, 1.0, 101.0], misses=4, hits=0, compiled=4)
WARM = Answer([20.0, 1.0, 101.0], misses=0, hits=3, compiled=0)  # the helper lies within its caller's code


def make_pipe(path: Path) -> None:
    """A pipe that nobody writes to, where there are such."""
    if not hasattr(os, "mkfifo"):
        pytest.skip("there are no pipes here")
    os.mkfifo(path)


class Copy:
    """A small copy of the package with kernels of its own, and processes that run it."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.cache = folder / "cache"
        source = Path(game.__file__).parent
        (folder / "game" / "physics").mkdir(parents=True)
        shutil.copytree(source / "compiler", folder / "game" / "compiler")
        for name in ("__init__.py", "folders.py", "trust.py", "physics/__init__.py"):
            shutil.copy(source / name, folder / "game" / name)
        self.write("physics/helping.py", HELPER)
        self.write("physics/using.py", USER)
        self.write("constants.py", CONSTANTS)

    def write(self, name: str, text: str) -> None:
        (self.folder / "game" / name).write_text(text)

    def start(self, code: str = PROBE, **environment: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-W", "error", "-c", code],
            cwd=self.folder,
            env={
                **os.environ,
                "PYTHONPATH": str(self.folder),
                "PYTHONDONTWRITEBYTECODE": "1",
                "CAROM_CACHE_DIR": str(self.cache),
                "NUMBA_DISABLE_JIT": "0",
                **environment,
            },
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def finish(self, process: subprocess.Popen[str]) -> Answer:
        out, err = process.communicate(timeout=900)
        assert process.returncode == 0, err
        assert err == ""
        return Answer(**json.loads(out))

    def run(self, code: str = PROBE, **environment: str) -> Answer:
        return self.finish(self.start(code, **environment))

    def code_files(self) -> list[Path]:
        return sorted(self.cache.rglob("*.code"))


@pytest.fixture
def copy(tmp_path: Path) -> Copy:
    return Copy(tmp_path)


@pytest.fixture(scope="module")
def warm(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    """A copy whose cache is filled; tests that change it work on a copy of it in turn."""
    copy = Copy(tmp_path_factory.mktemp("warm"))
    answer = copy.run()
    assert answer == COLD
    return copy


def of_warm(warm: Copy, tmp_path: Path) -> Copy:
    copy = Copy(tmp_path)
    shutil.copytree(warm.cache, copy.cache)
    return copy


class TestFreshness:
    def test_a_second_process_compiles_nothing(self, warm: Copy) -> None:
        assert warm.run() == WARM

    @pytest.mark.parametrize(
        ("name", "text", "value"),
        [
            ("physics/helping.py", HELPER.replace("1.0", "2.0"), 30.0),
            ("constants.py", "FACTOR = 20.0\n", 40.0),
            ("physics/using.py", USER.replace("* helper", "- helper"), 8.0),
        ],
    )
    def test_an_edit_anywhere_below_is_seen(
        self, warm: Copy, tmp_path: Path, name: str, text: str, value: float
    ) -> None:
        copy = of_warm(warm, tmp_path)
        copy.write(name, text)
        answer = copy.run()
        assert answer.values[0] == value
        assert answer.misses > 0
        assert copy.run() == WARM._replace(values=answer.values)

    def test_an_edit_elsewhere_costs_nothing(self, warm: Copy, tmp_path: Path) -> None:
        copy = of_warm(warm, tmp_path)
        copy.write("physics/others.py", "from game.physics.using import user\n")
        copy.write("__init__.py", "REMARK = 1\n")
        assert copy.run().compiled == 0

    def test_the_same_sources_elsewhere_share_their_code(self, warm: Copy, tmp_path: Path) -> None:
        assert of_warm(warm, tmp_path).run().compiled == 0

    @pytest.mark.parametrize(
        ("name", "old", "new", "value"),
        [
            ("physics/helping.py", HELPER, HELPER.replace("1.0", "2.0"), 30.0),
            ("constants.py", CONSTANTS, "FACTOR = 200.0\n", 400.0),
        ],
    )
    def test_an_edit_while_the_process_runs(
        self, copy: Copy, name: str, old: str, new: str, value: float
    ) -> None:
        """The module is loaded as it was, the text on disk is another; neither may get the other's code."""
        module = "game." + name.removesuffix(".py").replace("/", ".")
        edit = f"""
import game.compiler.decorator, {module}, pathlib
pathlib.Path("game/{name}").write_text({new!r})
"""
        assert copy.run(edit + PROBE).values[0] == 20.0
        assert copy.run().values[0] == value
        copy.write(name, old)
        assert copy.run().values[0] == 20.0

    def test_options_of_the_compiler_belong_to_the_name(self, warm: Copy, tmp_path: Path) -> None:
        copy = of_warm(warm, tmp_path)
        assert copy.run(NUMBA_BOUNDSCHECK="1").compiled == 4
        assert copy.run().compiled == 0


class TestTwoOfOneName:
    """Closures over different integers have one name for numba; kept code of them may be of two processes."""

    TWINS = """
from game.compiler.decorator import kernel
def make(bits):
    @kernel(inline="never")
    def twin(x):
        for i in range(50):
            x = x * 0.5 + i
        return 1000.0 if bits & 1 else -5.0
    return twin
a, b = make(0), make(1)
@kernel
def both(x):
    return a(x) + 10.0 * b(x)
"""

    def test_a_kernel_calls_either(self, copy: Copy) -> None:
        copy.write("physics/twins.py", self.TWINS)
        for call in ("a", "b", "both"):
            code = f"from game.physics.twins import {call}; import sys; print({call}(1.0))"
            out, err = copy.start(code).communicate(timeout=900)
            assert (float(out), err) == ({"a": -5.0, "b": 1000.0, "both": 9995.0}[call], "")


class TestTroubles:
    def test_processes_that_start_at_once(self, copy: Copy) -> None:
        answers = [copy.finish(process) for process in [copy.start() for _ in range(3)]]
        assert {tuple(answer.values) for answer in answers} == {(20.0, 1.0, 101.0)}
        assert copy.run() == WARM
        assert not list(copy.cache.rglob("*.part"))

    def test_a_folder_that_cannot_be_written_only_costs_time(self, copy: Copy) -> None:
        copy.cache.write_text("not a folder")
        assert copy.run() == COLD
        assert copy.cache.read_text() == "not a folder"

    def damaged(self, data: bytes, damage: str) -> bytes:
        middle = len(data) // 2
        body = pickle.dumps(("no", "code"))
        return {
            "empty": b"",
            "cut": data[:middle],
            "flipped": data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :],
            "random": np.random.default_rng(1).bytes(len(data)),
            "another thing": hashlib.blake2b(body, digest_size=16).digest() + body,
        }[damage]

    @pytest.mark.parametrize(
        "damages",
        [("empty", "cut", "flipped", "random"), ("another thing", "flipped", "cut", "another thing")],
    )
    def test_damaged_files_are_mended(self, warm: Copy, tmp_path: Path, damages: tuple[str, ...]) -> None:
        copy = of_warm(warm, tmp_path)
        for path, damage in zip(copy.code_files(), damages, strict=True):
            path.write_bytes(self.damaged(path.read_bytes(), damage))
        assert copy.run() == COLD
        assert copy.run() == WARM

    @pytest.mark.parametrize(
        ("make", "words"), [(Path.mkdir, "a folder, not a file"), (make_pipe, "not a regular file")]
    )
    def test_something_else_in_the_place_of_a_file_is_said_once(
        self, warm: Copy, tmp_path: Path, make: Callable[[Path], object], words: str
    ) -> None:
        copy = of_warm(warm, tmp_path)
        for path in copy.code_files():
            path.unlink()
            make(path)
        out, said = copy.start().communicate(timeout=900)
        assert Answer(**json.loads(out)) == COLD
        assert said.startswith("carom: machine code is not kept, ") and said.count("\n") == 1
        assert f".code: it is {words}" in said

    def test_from_a_zip_file(self, copy: Copy) -> None:
        archive = copy.folder / "game.zip"
        with zipfile.ZipFile(archive, "w") as file:
            for path in sorted((copy.folder / "game").rglob("*.py")):
                file.write(path, path.relative_to(copy.folder))
        shutil.rmtree(copy.folder / "game")
        answer = copy.run(PYTHONPATH=str(archive))
        assert answer.values == [20.0, 1.0, 101.0]

    def test_without_the_compiler_it_is_python(self, copy: Copy) -> None:
        assert copy.run(NUMBA_DISABLE_JIT="1") == Answer([20.0, 1.0, 101.0], 0, 0, 0)
        assert not copy.cache.exists()


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
class TestStrangers:
    """What another user may have put there is not run."""

    def plant(self, copy: Copy, sign: Path) -> None:
        """Under every known name a pickle that leaves a sign when it is loaded."""
        body = pickle.dumps(Planted(str(sign)))
        for path in copy.code_files():
            path.write_bytes(hashlib.blake2b(body, digest_size=16).digest() + body)

    def finish(self, copy: Copy, **environment: str) -> tuple[Answer, str]:
        process = copy.start(**environment)
        out, err = process.communicate(timeout=900)
        assert process.returncode == 0, err
        return Answer(**json.loads(out)), err

    def test_planted_code_would_be_run(self, warm: Copy, tmp_path: Path) -> None:
        """Otherwise the tests below prove nothing."""
        copy, sign = of_warm(warm, tmp_path), tmp_path / "sign"
        self.plant(copy, sign)
        assert copy.run() == COLD
        assert sign.exists()

    @pytest.mark.parametrize("level", [0, 1, 2])
    @pytest.mark.parametrize("how", ["mode", "sticky", "owner"])
    def test_a_folder_that_others_may_change(self, warm: Copy, tmp_path: Path, level: int, how: str) -> None:
        if how == "owner" and os.geteuid() != 0:
            pytest.skip("only root may give files away")
        copy, sign = of_warm(warm, tmp_path), tmp_path / "sign"
        kernels = copy.cache / "kernels"
        for folder in {0: [copy.cache], 1: [kernels], 2: list(kernels.iterdir())}[level]:
            if how == "owner":
                os.chown(folder, 54_321, -1)
            else:
                folder.chmod(0o777 if how == "mode" else 0o1777)
        self.plant(copy, sign)
        before = [path.read_bytes() for path in copy.code_files()]
        answer, said = self.finish(copy)
        if how == "sticky" and level < 2:  # nobody can rename what is this user's in there
            assert sign.exists()
            return
        assert answer == COLD
        assert not sign.exists()
        assert [path.read_bytes() for path in copy.code_files()] == before
        assert said.count("\n") == 1
        assert said.startswith("carom: machine code is not kept, ")
        assert str(copy.cache) in said

    @pytest.mark.parametrize("how", ["mode", "link", "owner"])
    def test_a_file_that_others_may_change_is_made_anew(self, warm: Copy, tmp_path: Path, how: str) -> None:
        if how == "owner" and os.geteuid() != 0:
            pytest.skip("only root may give files away")
        copy, sign = of_warm(warm, tmp_path), tmp_path / "sign"
        self.plant(copy, sign)
        for path in copy.code_files():
            if how == "owner":
                os.chown(path, 54_321, -1)
            elif how == "mode":
                path.chmod(0o666)
            else:
                path.symlink_to(path.rename(path.with_suffix(".other")))
        assert copy.run() == COLD
        assert not sign.exists()
        assert copy.run() == WARM

    def test_folders_are_made_for_this_user_alone(self, copy: Copy) -> None:
        before = os.umask(0)
        try:
            assert copy.run() == COLD
        finally:
            os.umask(before)
        for folder in (copy.cache, copy.cache / "kernels", *(copy.cache / "kernels").iterdir()):
            assert folder.stat().st_mode & 0o777 == 0o700
        assert copy.run() == WARM


class Planted:
    """What loads as a call that leaves a sign."""

    def __init__(self, sign: str):
        self.sign = sign

    def __reduce__(self):
        return os.mkdir, (self.sign,)


class TestCleaning:
    def folder(self, root: Path, name: str, age_days: float, size: int = 10) -> Path:
        folder = root / name
        folder.mkdir(parents=True)
        (folder / "a.code").write_bytes(b"x" * size)
        now = folder.stat().st_mtime
        os.utime(folder, (now - age_days * 86_400, now - age_days * 86_400))
        return folder

    def left(self, root: Path) -> list[str]:
        return sorted(path.name for path in root.iterdir())

    def test_stale_folders_of_the_same_module_go(self, tmp_path: Path) -> None:
        current = self.folder(tmp_path, "game.a-3", 0)
        self.folder(tmp_path, "game.a-1", 30)
        self.folder(tmp_path, "game.a-2", 3)
        self.folder(tmp_path, "game.a.b-1", 30)
        self.folder(tmp_path, "game.b-1", 30)
        (tmp_path / "note").write_text("x")
        cache.remove_old_folders(current)
        assert self.left(tmp_path) == ["game.a-2", "game.a-3", "game.a.b-1", "game.b-1", "note"]

    def test_the_oldest_go_until_there_is_room(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(cache, "MAX_BYTES", 250)
        current = self.folder(tmp_path, "game.a-1", 6, 100)
        for age in range(1, 6):
            self.folder(tmp_path, f"game.m{age}-1", age, 100)
        cache.remove_old_folders(current)
        assert self.left(tmp_path) == ["game.a-1", "game.m1-1"]

    def test_the_current_one_stays_however_large(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(cache, "MAX_BYTES", 10)
        current = self.folder(tmp_path, "game.a-1", 0, 1000)
        cache.remove_old_folders(current)
        assert self.left(tmp_path) == ["game.a-1"]

    def test_a_missing_folder_is_no_trouble(self, tmp_path: Path) -> None:
        cache.remove_old_folders(tmp_path / "none" / "game.a-1")
        assert not (tmp_path / "none").exists()


class First(NamedTuple):
    """Two fields."""

    x: float
    y: float


def other_first() -> type:
    """A type of the same name with its fields the other way round."""

    class First(NamedTuple):
        y: float
        x: float

    return First


def plain_difference(point):
    return point.x - point.y


difference = kernel(plain_difference)


class TestNames:
    """What the file of a piece of code is called"""

    def path(self, function, sig, folder: Path, options: str = "") -> Path | None:
        return KernelCache(function, folder, options)._path(sig, GENERIC)

    def test_types_of_one_name_differ(self, tmp_path: Path) -> None:
        import numba

        sigs = [(numba.typeof(kind(x=1.0, y=2.0)),) for kind in (First, other_first())]
        assert repr(sigs[0]) == repr(sigs[1])
        paths = [self.path(plain_difference, sig, tmp_path) for sig in sigs]
        assert paths[0] != paths[1]
        assert difference(First(1.0, 2.0)) == difference(other_first()(y=2.0, x=1.0)) == -1.0

    def test_closures_differ_by_value_and_kind(self, tmp_path: Path) -> None:
        def make(bits):
            def inner(x):
                return x + bits

            return inner

        paths = {self.path(make(bits), (), tmp_path) for bits in (0, 1, True, 2)}
        assert len(paths) == 4

    def test_functions_on_one_line_differ(self, tmp_path: Path) -> None:
        functions = [lambda x: x + 1.0, lambda x: x + 2.0, lambda x: abs(x), lambda x: hash(x)]  # fmt: skip
        assert len({function.__code__.co_firstlineno for function in functions}) == 1
        paths = {self.path(function, (), tmp_path) for function in functions}
        assert len(paths) == 4
        assert not any(set("<>:*?|") & set(path.name) for path in paths)

    def test_options_differ(self, tmp_path: Path) -> None:
        assert self.path(plain_difference, (), tmp_path, "a") != self.path(
            plain_difference, (), tmp_path, "b"
        )

    def test_types_without_a_lasting_name_are_not_kept(self, tmp_path: Path) -> None:
        import numba
        from numba.core.registry import CPUDispatcher

        sig = (numba.typeof(CPUDispatcher(plain_difference)),)
        assert self.path(plain_difference, sig, tmp_path) is None


class TestDecorator:
    @pytest.mark.parametrize("option", ["fastmath", "parallel", "cache", "error_model", "nogil"])
    @pytest.mark.parametrize("value", [True, False])
    def test_options_that_are_refused(self, option: str, value: bool) -> None:
        with pytest.raises(ValueError, match=f"the option {option} is not to be had"):
            kernel(**{option: value})

    def test_options_that_are_passed_on(self) -> None:
        @kernel(inline="always")
        def inlined(x):
            return 2.0 * x

        @kernel
        def caller(x):
            return inlined(x) + 1.0

        assert caller(3.0) == 7.0

    def test_division_by_zero_is_as_in_numpy(self) -> None:
        @kernel
        def divide(a, b):
            return a / b

        if isinstance(divide, type(compiling)):
            pytest.skip("without the compiler division is Python's")
        assert divide(1.0, 0.0) == np.inf
        assert np.isnan(divide(0.0, 0.0))

    def test_kernels_of_other_places_are_not_kept(self, tmp_path: Path) -> None:
        assert code_folder(Path(__file__)) is None
        assert code_folder(tmp_path / "missing.py") is None
        assert code_folder(Path(decorator.__file__).with_name("no_such_module.py")) is None
        assert code_folder(Path(decorator.__file__)) is not None

    def test_what_is_compiling_is_known(self) -> None:
        from numba.core import event

        seen: list[Compiling] = []

        class Look(event.Listener):
            def on_start(self, event):
                seen.append(compiling())

            def on_end(self, event):
                pass

        @kernel
        def inner(x):
            return x + 1.0

        @kernel
        def outer(x):
            return inner(x)

        before = compiling()
        assert before.names == ()
        with event.install_listener("numba:compile", Look()):
            assert outer(1.0) == 2.0
        if not seen:
            pytest.skip("there is no compiler")
        names = [tuple(name.rpartition(".")[2] for name in look.names) for look in seen]
        assert names == [("outer",), ("outer", "inner")]
        assert compiling() == Compiling((), before.done + 2)
