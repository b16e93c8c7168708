"""Bounds of what comes in from files: both sides of each, and the words that say so."""

from __future__ import annotations

import base64
import math
import os
import tempfile
import zlib
from pathlib import Path
from typing import Annotated

import msgspec
import pytest

from game import folders
from game.files import FileProblem, read_text, save_text, write_bytes, write_text
from game.level_checks import (
    MAX_DEPTH,
    MAX_ITEMS,
    LevelError,
    Unbounded,
    check_numbers,
    check_sizes,
    check_strict,
    check_text,
    convert,
)
from game.packed_text import pack, unpack


class TestPacked:
    @pytest.mark.parametrize("words", [b"", b"the most frequent last"])
    @pytest.mark.parametrize("size", [0, 1, 2, 3, 4, 5, 1000])
    def test_bytes_come_back_and_the_text_is_bare(self, words: bytes, size: int) -> None:
        data = bytes((7 * k * k) % 251 for k in range(size))
        text = pack(data, words)
        assert "=" not in text and all(letter.isalnum() or letter in "-_" for letter in text)
        assert unpack(text, size, words) == data  # exactly as many as are allowed

    def test_one_byte_more_than_is_allowed_is_refused(self) -> None:
        text = pack(b"x" * 100)
        assert unpack(text, 101) == unpack(text, 100) == b"x" * 100
        with pytest.raises(ValueError, match=r"^unpacks to more than 99 bytes$"):
            unpack(text, 99)
        with pytest.raises(ValueError, match=r"^unpacks to more than 10 bytes$"):
            unpack(pack(b"y" * 10_000_000), 10)

    def test_what_is_damaged_says_how(self) -> None:
        data = os.urandom(300)
        text = pack(data)
        for damaged, reason in (
            (text[:200], "damaged: its end is missing"),
            ("!" + text[1:], "damaged: the packed part cannot be unpacked"),
            ("AAAA" + text, "damaged: the packed part cannot be unpacked"),
        ):
            with pytest.raises(ValueError, match=rf"^{reason}$"):
                unpack(damaged, 1000)
        with pytest.raises(ValueError, match=r"^damaged: there is more behind its end$"):
            unpack(_text_of(zlib.compress(data) + b"abc"), 1000)
        with pytest.raises(ValueError, match=r"^damaged: the packed part cannot be unpacked$"):
            unpack(pack(data, b"words"), 1000, b"other words")


def _text_of(packed: bytes) -> str:
    return base64.urlsafe_b64encode(packed).decode().rstrip("=")


class TestFiles:
    def test_a_text_comes_back_without_its_mark_of_byte_order(self, tmp_path: Path) -> None:
        path = tmp_path / "a" / "b" / "c.txt"
        write_bytes(path, b"\xef\xbb\xbfone\xc3\xa4")
        assert read_text(path, 8) == "one\u00e4"
        with pytest.raises(FileProblem, match=r"^longer than 7 bytes$"):
            read_text(path, 7)

    def test_what_cannot_be_read_says_why_in_a_few_words(self, tmp_path: Path) -> None:
        (tmp_path / "blank").write_bytes(b" \n\t ")
        (tmp_path / "latin").write_bytes(b"abc\xe4def")
        for name, reason in (
            ("none", "no such file or directory"), ("blank", "empty"),
            ("latin", "not UTF-8 text (byte 3)"), ("a\x00", "not a file name"),
        ):  # fmt: skip
            with pytest.raises(FileProblem) as caught:
                read_text(tmp_path / name, 100)
            assert str(caught.value) == reason

    def test_what_cannot_be_saved_is_an_error_of_the_system_that_names_the_file(self, tmp_path: Path) -> None:
        save_text(tmp_path / "a.txt", "x")
        assert (tmp_path / "a.txt").read_bytes() == b"x"
        with pytest.raises(OSError, match=r"a regular file") as caught:
            save_text(tmp_path, "x")
        assert str(caught.value).startswith(f"{tmp_path}: there is something")

    def test_a_new_file_is_hidden_beside_until_it_is_whole(self, tmp_path, monkeypatch) -> None:
        seen = []
        make = tempfile.mkstemp
        monkeypatch.setattr(tempfile, "mkstemp", lambda **named: (seen.append(named), make(**named))[1])
        write_text(tmp_path / "a.txt", "x")
        assert seen == [{"prefix": ".", "suffix": ".part", "dir": tmp_path}]


class TestFolders:
    def test_a_home_for_a_while_comes_back_as_it_was(self, tmp_path: Path, monkeypatch) -> None:
        for before in (None, "/somewhere/else"):
            if before is None:
                monkeypatch.delenv("CAROM_HOME", raising=False)
            else:
                monkeypatch.setenv("CAROM_HOME", before)
            with pytest.raises(KeyError), folders.home_at(tmp_path):
                assert folders.user_folder() == tmp_path
                raise KeyError
            assert os.environ.get("CAROM_HOME") == before

    def test_without_words_the_systems_places_are_taken(self, tmp_path: Path, monkeypatch) -> None:
        for name in ("CAROM_HOME", "CAROM_CACHE_DIR"):
            monkeypatch.delenv(name, raising=False)
        asked = []
        for name in ("user_data_dir", "user_cache_dir"):
            monkeypatch.setattr(
                folders.platformdirs, name,
                lambda app, appauthor, name=name: (asked.append((app, appauthor)), f"{tmp_path}/{name}")[1],
            )  # fmt: skip
        monkeypatch.setattr(folders.platformdirs, "user_pictures_dir", lambda: f"{tmp_path}/pictures")
        assert folders.user_folder() == tmp_path / "user_data_dir"
        assert folders.cache_folder() == tmp_path / "user_cache_dir"
        assert folders.pictures_folder() == tmp_path / "pictures" / "Carom"
        assert asked == [("carom", False)] * 2

    @pytest.mark.skipif(os.name == "nt", reason="no permissions there")
    def test_a_temporary_home_is_taken_only_if_nobody_else_may_write_to_it(self, tmp_path, monkeypatch):
        """The cache holds machine code."""
        monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
        mine = tmp_path / f"carom-{os.getuid()}"
        assert folders._temporary_home() == mine and mine.stat().st_mode & 0o777 == 0o700
        for mode, taken in ((0o755, True), (0o720, False), (0o702, False), (0o744, True)):
            mine.chmod(mode)
            assert (folders._temporary_home() == mine) == taken, oct(mode)
        mine.rmdir()
        mine.write_text("a file")
        other = folders._temporary_home()
        assert other != mine and other.name.startswith("carom-") and other.parent == tmp_path


class TestLevelErrors:
    def test_its_line_is_file_field_reason(self) -> None:
        error = LevelError(Path("a.toml"), "content.x", "missing")
        assert str(error) == "a.toml: content.x: missing"
        assert (error.file, error.field, error.reason) == ("a.toml", "content.x", "missing")
        assert str(LevelError(None, "", "empty")) == "level: empty"
        assert str(LevelError("a\nb", "", "c\x00d")) == "a b: c d"

    @pytest.mark.parametrize(("length", "cut"), [(250, False), (251, True)])
    def test_a_long_name_keeps_its_end(self, length: int, cut: bool) -> None:
        name = "".join(chr(97 + k % 26) for k in range(length))
        shown = str(LevelError(name, "", "r")).removesuffix(": r")
        assert shown == ("…" + name[-249:] if cut else name) and len(shown) == 250

    @pytest.mark.parametrize(("length", "cut"), [(120, False), (121, True)])
    def test_a_long_field_keeps_its_beginning(self, length: int, cut: bool) -> None:
        field = "".join(chr(97 + k % 26) for k in range(length))
        assert LevelError("f", field, "r").field == (field[:119] + "…" if cut else field)

    @pytest.mark.parametrize(("length", "cut"), [(497, False), (498, True)])
    def test_a_long_line_is_cut(self, length: int, cut: bool) -> None:
        reason = "".join(chr(97 + k % 26) for k in range(length))
        line = "f: " + reason
        assert str(LevelError("f", "", reason)) == (line[:499] + "…" if cut else line)


class TestSizes:
    @staticmethod
    def nested(depth: int) -> object:
        value: object = {}
        for _ in range(depth):
            value = [value]
        return value

    def test_the_deepest_that_may_be(self) -> None:
        check_sizes(self.nested(MAX_DEPTH), None)
        with pytest.raises(LevelError, match=r"^level: \[0\](\[0\])*: nested deeper than 12$") as caught:
            check_sizes(self.nested(MAX_DEPTH + 1), None)
        assert caught.value.field == "[0]" * (MAX_DEPTH + 1)
        with pytest.raises(LevelError) as caught:
            check_sizes({"a": {"b": self.nested(MAX_DEPTH - 1)}}, Path("x.toml"))
        assert caught.value.field.startswith("a.b[0]") and caught.value.file == "x.toml"

    def test_the_longest_that_may_be(self) -> None:
        check_sizes({"a": [0] * MAX_ITEMS}, None)
        with pytest.raises(LevelError, match=r"^level: b.a: more than 100000 items$"):
            check_sizes({"b": {"a": [0] * (MAX_ITEMS + 1)}}, None)

    def test_a_key_of_the_most_parts_that_may_be(self) -> None:
        check_text(".".join("k" * (MAX_DEPTH + 1)) + " = 1\n", None)
        for text in (
            ".".join("k" * (MAX_DEPTH + 2)),
            " . ".join("k" * (MAX_DEPTH + 2)),
            'k."a b".' * 7 + "k",
        ):
            with pytest.raises(LevelError, match=r"^level: a key has more than 12 dots$"):
                check_text(f"{text} = 1\n", None)
        long = ".".join("k" * 30)
        check_text(
            f"a = \"{long}\"  # {long}\nb = '{long}'\nc = \"\"\"{long}\"\"\"\nd = '''{long}'''\n", None
        )


class Inner(msgspec.Struct, forbid_unknown_fields=True):
    x: float = 0.0
    most: Unbounded = 1.0


class Outer(msgspec.Struct, forbid_unknown_fields=True):
    inner: Inner = msgspec.field(default_factory=Inner)
    rows: list[Inner] = []
    named: dict[str, float] = {}
    pair: tuple[float, float] | None = None
    limit: Annotated[float, msgspec.Meta(ge=0.0)] | Unbounded = 1.0
    count: int = msgspec.field(default=0, name="how-many")


class Loose(msgspec.Struct):
    x: float = 0.0


class TestNumbers:
    @pytest.mark.parametrize(
        ("content", "field"),
        [
            (Outer(Inner(x=math.inf)), "content.inner.x"),
            (Outer(rows=[Inner(), Inner(x=-math.inf)]), "content.rows[1].x"),
            (Outer(named={"a": 1.0, "b": math.inf}), "content.named.b"),
            (Outer(pair=(0.0, math.inf)), "content.pair[1]"),
        ],
    )
    def test_what_is_not_finite_is_named(self, content: Outer, field: str) -> None:
        with pytest.raises(LevelError, match=r"expected a finite number$") as caught:
            check_numbers(content, Outer, None)
        assert caught.value.field == field

    def test_infinity_stands_where_a_field_is_unbounded_and_nan_nowhere(self) -> None:
        check_numbers(Outer(Inner(most=math.inf), rows=[Inner(most=-math.inf)]), Outer, None)
        for content, field in (
            (Outer(Inner(most=math.nan)), "content.inner.most"),
            (Outer(named={"z": math.nan}), "content.named.z"),
        ):
            with pytest.raises(LevelError, match=r"NaN is no number$") as caught:
                check_numbers(content, Outer, None)
            assert caught.value.field == field
        check_numbers(Outer(), Outer, None)

    def test_a_type_that_would_pass_over_unknown_keys_is_a_slip(self) -> None:
        check_strict(Outer)
        for loose in (Loose, list[Loose], dict[str, Loose], Loose | None, tuple[Inner, Loose]):
            with pytest.raises(
                TypeError, match=r"^Loose: a level's content needs forbid_unknown_fields=True$"
            ):
                check_strict(loose)

    @pytest.mark.parametrize(
        ("raw", "field", "reason"),
        [
            ({"inner": {"y": 1}}, "content.inner.y", "unknown key"),
            ({"z": 1}, "content.z", "unknown key"),
            ({"rows": [{}, {"x": "a"}]}, "content.rows[1].x", "expected float, got str"),
            ({"how-many": 1.5}, "content.how-many", "expected int, got float"),
            ({"named": {"a": []}}, "content.named[...]", "expected float, got array"),
            ([], "content", "expected object, got array"),
        ],
    )
    def test_a_complaint_is_taken_apart(self, raw: object, field: str, reason: str) -> None:
        with pytest.raises(LevelError) as caught:
            convert(raw, Outer, None, "content")
        assert (caught.value.field, caught.value.reason) == (field, reason)
