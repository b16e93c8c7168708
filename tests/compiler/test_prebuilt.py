"""Machine code that came with Carom: taken where it fits and is sound, never where others could change it.

As in test_decorator.py, processes run a small copy of the package; here its kernels are packed into it.
"""

from __future__ import annotations

import json
import os
import pickle
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from game.compiler import prebuilt
from game.compiler.prebuilt import DamagedError, UnfitError, file_name, pack, unpack
from tests.compiler.test_decorator import COLD, CONSTANTS, PROBE, WARM, Answer, Copy, Planted, make_pipe

PACK = """
from game.compiler.cache import code_in, files_used
from game.compiler.prebuilt import PACKAGE, file_name, pack
file = PACKAGE / "data" / "kernels" / file_name()
file.parent.mkdir(parents=True)
codes = {f"{path.parent.name}/{path.name}": code_in(path) for path in files_used()}
file.write_bytes(pack(codes, ["one"]))
file.chmod(0o644)
"""
TAKEN = """
from game.compiler import cache, prebuilt
code = prebuilt.prebuilt()
print(json.dumps([len(code.taken) if code else 0, len(cache.files_used())]))
"""
GENERIC = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
WORDS = "carom: machine code that came with Carom is not taken and is compiled anew, "


@pytest.fixture(scope="module")
def packed(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    """A copy with machine code in it, made from an empty cache and with nothing left of that."""
    copy = Copy(tmp_path_factory.mktemp("packed"))
    out, err = copy.start(PROBE + PACK, **GENERIC).communicate(timeout=900)
    assert (Answer(**json.loads(out)), err) == (COLD, "")
    shutil.rmtree(copy.cache)
    return copy


@pytest.fixture
def shipped(packed: Copy, tmp_path: Path) -> Copy:
    """A copy of that for one test."""
    copy = Copy(tmp_path)
    shutil.copytree(packed.folder / "game" / "data", copy.folder / "game" / "data")
    return copy


def file_of(copy: Copy) -> Path:
    return copy.folder / "game" / "data" / "kernels" / file_name()


def run(copy: Copy, code: str = PROBE, **environment: str) -> tuple[Answer, str]:
    """A process's answer and what it says beside it."""
    process = copy.start(code, **environment)
    out, err = process.communicate(timeout=900)
    assert process.returncode == 0, err
    return Answer(**json.loads(out.splitlines()[0])), err


class TestUse:
    def test_with_an_empty_cache_nothing_is_compiled_and_nothing_written(self, shipped: Copy) -> None:
        assert shipped.run() == WARM
        assert not shipped.cache.exists()

    def test_where_nothing_can_be_written(self, shipped: Copy) -> None:
        shipped.cache.write_text("not a folder")
        assert shipped.run() == WARM

    def test_code_for_this_very_processor_is_compiled_if_asked_for_and_goes_before_it(
        self, shipped: Copy
    ) -> None:
        assert shipped.run(CAROM_PREBUILT="0") == COLD
        assert len(shipped.code_files()) == 4
        out, err = shipped.start(PROBE + TAKEN).communicate(timeout=900)
        answer, counts = map(json.loads, out.splitlines())
        assert (Answer(**answer), counts, err) == (WARM, [0, 3], "")

    def test_without_the_compiler_it_is_not_looked_for(self, shipped: Copy) -> None:
        file_of(shipped).write_bytes(b"damaged")
        assert shipped.run(NUMBA_DISABLE_JIT="1") == Answer([20.0, 1.0, 101.0], 0, 0, 0)

    def test_other_sources_get_none_of_it(self, shipped: Copy) -> None:
        """All but the helper, which knows nothing of the constant that was changed."""
        shipped.write("constants.py", CONSTANTS.replace("10", "20"))
        assert shipped.run() == Answer([40.0, 1.0, 101.0], misses=3, hits=1, compiled=3)

    def test_two_versions_side_by_side_share_a_cache(self, shipped: Copy, tmp_path: Path) -> None:
        other = Copy(tmp_path / "other")
        other.cache = shipped.cache
        other.write("constants.py", CONSTANTS.replace("10", "20"))
        newer = COLD._replace(values=[40.0, 1.0, 101.0])
        assert other.run(PROBE + PACK, **GENERIC) == newer
        assert shipped.run() == WARM
        assert other.run() == WARM._replace(values=newer.values)

    def test_another_file_is_named(self, shipped: Copy, tmp_path: Path) -> None:
        elsewhere = file_of(shipped).rename(tmp_path / "elsewhere")
        assert shipped.run(CAROM_PREBUILT=str(elsewhere)) == WARM


class TestTampering:
    @pytest.mark.parametrize("place", [0, 25, 70, 400, -1])
    def test_one_bit(self, packed: Copy, place: int) -> None:
        data = bytearray(file_of(packed).read_bytes())
        assert len(unpack(bytes(data))) == 4
        data[place] ^= 1
        with pytest.raises(DamagedError):
            unpack(bytes(data))

    @pytest.mark.parametrize("length", [0, 10, 60, 1000])
    def test_cut_off(self, packed: Copy, length: int) -> None:
        with pytest.raises(DamagedError):
            unpack(file_of(packed).read_bytes()[:length])

    def test_it_is_refused_said_once_and_compiled_anew(self, shipped: Copy) -> None:
        file = file_of(shipped)
        data = bytearray(file.read_bytes())
        data[len(data) // 2] ^= 1
        file.write_bytes(data)
        answer, said = run(shipped)
        assert answer == COLD
        assert said.startswith(f"{WORDS}{file}: ") and said.count("\n") == 1
        assert run(shipped) == (WARM, "")  # from the cache now

    def test_a_sound_file_of_something_else(self, shipped: Copy) -> None:
        index = pickle.dumps("no index")
        content = len(index).to_bytes(8, "little") + index
        file_of(shipped).write_bytes(prebuilt._MAGIC + prebuilt._checksum(content) + content)
        answer, said = run(shipped)
        assert answer == COLD and said.count("\n") == 1


class TestNoFile:
    """What lies in the place of the file, or that nothing does, is said in one line."""

    @pytest.mark.parametrize(
        ("make", "words"),
        [(Path.mkdir, "a folder, not a file"), (make_pipe, "not a regular file")],
    )
    @pytest.mark.parametrize("named", [False, True])
    def test_something_else(
        self, shipped: Copy, make: Callable[[Path], object], words: str, named: bool
    ) -> None:
        file = file_of(shipped)
        file.unlink()
        make(file)
        answer, said = run(shipped, **({"CAROM_PREBUILT": str(file)} if named else {}))
        assert answer == COLD
        assert said == f"{WORDS}{file}: it is {words}\n"

    @pytest.mark.parametrize("place", ["missing", "no/folder/either"])
    def test_a_named_one_that_is_missing(self, shipped: Copy, tmp_path: Path, place: str) -> None:
        answer, said = run(shipped, CAROM_PREBUILT=str(tmp_path / place))
        assert answer == COLD
        assert said == f"{WORDS}{tmp_path / place}: no such file\n"

    def test_where_none_came_nothing_is_said(self, shipped: Copy) -> None:
        file_of(shipped).unlink()
        assert run(shipped) == (COLD, "")


class TestFit:
    @pytest.mark.parametrize("what", ["Python", "numba", "llvmlite", "numpy", "platform"])
    def test_it_must_be_made_for_what_is_here(self, monkeypatch: pytest.MonkeyPatch, what: str) -> None:
        here = prebuilt.what_must_fit()
        monkeypatch.setattr(prebuilt, "what_must_fit", lambda: {**here, what: "0.1"})
        made_for_another = pack({"a/b": b"code"}, [])
        monkeypatch.setattr(prebuilt, "what_must_fit", lambda: here)
        with pytest.raises(UnfitError, match=f"made for {what} 0.1, and here is {here[what]}"):
            unpack(made_for_another)

    def test_what_does_not_fit_is_passed_over_without_a_word(self, shipped: Copy) -> None:
        file = file_of(shipped)
        head = len(prebuilt._MAGIC) + prebuilt._CHECKSUM
        content = file.read_bytes()[head:].replace(b'"numba": "', b'"numba": "9')
        content = (int.from_bytes(content[:8], "little") + 1).to_bytes(8, "little") + content[8:]
        file.write_bytes(prebuilt._MAGIC + prebuilt._checksum(content) + content)
        assert shipped.run() == COLD

    def test_what_is_packed_comes_out(self) -> None:
        codes = {"game.a-1/f-3.code": b"one" * 100, "game.b-2/g-4.code": b""}
        made = unpack(pack(codes, ["x", "y"]))
        assert {name: made.take(name) for name in made} == codes
        assert made.taken == set(codes) and made.scenes == {"x", "y"}
        assert made.take("game.a-2/f-3.code") is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
class TestStrangers:
    """What another user may have put there is not run."""

    @pytest.fixture
    def sign(self, shipped: Copy, tmp_path: Path) -> Path:
        """Under every name a pickle that leaves a sign when it is loaded."""
        sign, file = tmp_path / "sign", file_of(shipped)
        names = list(unpack(file.read_bytes()))
        file.write_bytes(pack(dict.fromkeys(names, pickle.dumps(Planted(str(sign)))), []))
        return sign

    def test_planted_code_would_be_run(self, shipped: Copy, sign: Path) -> None:
        """Otherwise the tests below prove nothing."""
        assert shipped.run() == COLD
        assert sign.exists()

    @pytest.mark.parametrize("how", ["file", "folder", "above", "owner", "link"])
    def test_what_others_may_change_is_not_taken(self, shipped: Copy, sign: Path, how: str) -> None:
        file = file_of(shipped)
        if how == "owner":
            if os.geteuid() != 0:
                pytest.skip("only root may give files away")
            os.chown(file, 54_321, -1)
        elif how == "link":
            file.symlink_to(file.rename(file.with_suffix(".other")))
        else:
            place = {"file": file, "folder": file.parent, "above": file.parents[2]}[how]
            place.chmod(0o666 if how == "file" else 0o777)
        answer, said = run(shipped)
        assert answer == COLD
        assert not sign.exists()
        assert said.startswith(WORDS) and said.count("\n") == 1
