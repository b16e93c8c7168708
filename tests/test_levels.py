"""Level files: what is right comes back as it was, what is wrong is named in one line."""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import Annotated

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.levels import (
    MAX_BYTES,
    MAX_DEPTH,
    MAX_ITEMS,
    Level,
    LevelError,
    Unbounded,
    format_level,
    level_files,
    load_level,
    parse_level,
    save_level,
    user_level_files,
)


class Ball(msgspec.Struct, forbid_unknown_fields=True):
    """A part of a content."""

    radius: Annotated[float, msgspec.Meta(gt=0.0, le=10.0)]
    mass: Unbounded = 1.0
    position: tuple[float, float] = (0.0, 0.0)
    name: Annotated[str, msgspec.Meta(max_length=10)] | None = None


class Content(msgspec.Struct, forbid_unknown_fields=True):
    """A content."""

    balls: list[Ball] = []
    weights: dict[str, float] = {}
    far: list[Unbounded] = []


class Loose(msgspec.Struct):
    """A content that would pass over unknown keys."""

    ball: Ball | None = None


class Nested(msgspec.Struct, forbid_unknown_fields=True):
    """One that hides such a part."""

    parts: list[Loose] = []


HEAD = 'scene = "c12"\n'


def refused(text: str, content_type: type[msgspec.Struct] | None = Content) -> LevelError:
    with pytest.raises(LevelError) as caught:
        parse_level(text, "c12", content_type)
    error = caught.value
    assert "\n" not in str(error)
    assert len(str(error)) <= 500
    return error


class TestReading:
    def test_everything(self, tmp_path: Path) -> None:
        path = tmp_path / "a.toml"
        path.write_text(
            HEAD
            + 'title = "Two"\nabout = "Look."\nhard_case = "C12.H3"\nseed = 7\n'
            + '[parameters]\nrate = 5\nfine = true\nmethod = "rk4"\n[effects]\noff = ["gravity"]\n'
            + "[content]\nfar = [inf, 1.0]\n[[content.balls]]\nradius = 2\nmass = inf\n",
            encoding="utf-8",
        )
        level = load_level(path, "c12", Content)
        assert level == Level(
            scene="c12",
            title="Two",
            about="Look.",
            hard_case="C12.H3",
            seed=7,
            parameters={"rate": 5, "fine": True, "method": "rk4"},
            effects_off=("gravity",),
            content=Content(balls=[Ball(radius=2.0, mass=math.inf)], far=[math.inf, 1.0]),
            path=path,
        )

    def test_the_least(self) -> None:
        assert parse_level(HEAD, "c12", Content) == Level(scene="c12")

    @pytest.mark.parametrize(
        ("text", "field", "reason"),
        [
            ("", "scene", "missing"),
            ("seed = 1", "scene", "missing"),
            ("scene = 12", "scene", "expected str, got int"),
            ('scene = "c01"', "scene", "expected 'c12', not 'c01'"),
            (HEAD + "seed = -1", "seed", "expected int >= 0"),
            (HEAD + "seed = 1.5", "seed", "expected int, got float"),
            (HEAD + f"seed = {2**63}", "seed", ""),
            (HEAD + "seed = true", "seed", "expected int, got bool"),
            (HEAD + f'title = "{"x" * 201}"', "title", "expected str of length <= 200"),
            (HEAD + "color = 1", "color", "unknown key"),
            (HEAD + "[effects]\non = []", "effects.on", "unknown key"),
            (HEAD + "[effects]\noff = [1]", "effects.off[0]", "expected str, got int"),
            (HEAD + "[parameters]\na = nan", "parameters.a", "expected a finite number"),
            (HEAD + "[parameters]\na = -inf", "parameters.a", "expected a finite number"),
            (HEAD + "[parameters]\na = [1]", "parameters[...]", "got array"),
            (HEAD + "[parameters]\na = 1979-05-27", "parameters[...]", "got date"),
            (HEAD + "content = 1", "content", "got int"),
            (HEAD + "[content]\nballs = 1", "content.balls", "expected array, got int"),
            (HEAD + "[content]\nballs = [{}]", "content.balls[0].radius", "missing"),
            (HEAD + "[content]\nballs = [{radius = 1, hue = 1}]", "content.balls[0].hue", "unknown key"),
            (HEAD + "[content]\nballs = [{radius = 0}]", "content.balls[0].radius", "expected float > 0"),
            (HEAD + "[content]\nballs = [{radius = 11}]", "content.balls[0].radius", "expected float <= 10"),
            (HEAD + "[content]\nballs = [{radius = nan}]", "content.balls[0].radius", ""),
            (HEAD + '[content]\nballs = [{radius = "1"}]', "content.balls[0].radius", "got str"),
            (HEAD + "[content]\nballs = [{radius = 1, mass = nan}]", "content.balls[0].mass", "NaN"),
            (
                HEAD + "[content]\nballs = [{radius = 1}, {radius = 1, position = [0, inf]}]",
                "content.balls[1].position[1]",
                "expected a finite number",
            ),
            (
                HEAD + "[content]\nballs = [{radius = 1, position = [0]}]",
                "content.balls[0].position",
                "length 2",
            ),
            (HEAD + "[content.weights]\na = inf", "content.weights.a", "expected a finite number"),
            (HEAD + f"[content]\nfar = [1{'0' * 400}]", "content.far[0]", "out of range"),
        ],
    )
    def test_field_and_reason(self, text: str, field: str, reason: str) -> None:
        error = refused(text)
        assert error.field == field
        assert reason in error.reason
        assert str(error) == f"level: {field}: {error.reason}"

    def test_a_scene_without_content(self) -> None:
        assert refused(HEAD + "[content]\na = 1", None).field == "content"

    def test_the_file_is_named(self, tmp_path: Path) -> None:
        path = tmp_path / "odd name.toml"
        path.write_text(HEAD + "seed = -1")
        with pytest.raises(LevelError) as caught:
            load_level(path, "c12", Content)
        assert str(caught.value) == f"{path}: seed: expected int >= 0"

    @pytest.mark.parametrize("content_type", [Loose, Nested])
    def test_a_type_that_would_pass_over_unknown_keys(self, content_type) -> None:
        with pytest.raises(TypeError, match="Loose: a level's content needs forbid_unknown_fields"):
            parse_level(HEAD + "[content]\n", "c12", content_type)


class TestAbsurdTexts:
    @pytest.mark.parametrize(
        "text",
        [
            "{",
            "scene",
            "scene = ",
            "scene = 'c12'\nscene = 'c12'",
            "\x00" * 100,
            '"' * 100_000,
            "a = '''" * 20_000,
            'x = """' + "\\" * 100_001,
            HEAD + "x = " + "[" * 5_000 + "]" * 5_000,
            HEAD + "x = " + "{a = " * 200 + "1" + "}" * 200,
            HEAD + "x = " + "[" * (MAX_DEPTH + 2) + "]" * (MAX_DEPTH + 2),
            HEAD + "a." * 200_000 + "a = 1",
            HEAD + '"a b" . ' * 50_000 + "a = 1",
            HEAD + "[" + "a." * 100_000 + "a]",
            HEAD + "x = {" + "a." * 100_000 + "a = 1}",
            HEAD + "seed = 1" + "0" * 5_000,
            HEAD + "[[a]]\n" * (MAX_ITEMS + 1),
            HEAD + f"x = [{'1,' * (MAX_ITEMS + 1)}]",
            HEAD + "a" * 500_000 + " = 1",
        ],
        ids=range(19),
    )
    def test_they_are_refused_in_one_line(self, text: str) -> None:
        assert "\n" not in str(refused(text))

    def test_dots_in_words_are_no_long_keys(self) -> None:
        dotted = ".".join("abcdefghijklmnopqrst")
        level = parse_level(f"{HEAD}title = '{dotted}' # {dotted}\nabout = '''\n{dotted} = 1'''", "c12", None)
        assert level.title == dotted

    @given(st.text(max_size=300))
    def test_any_text_is_a_level_or_a_level_error(self, text: str) -> None:
        for whole in (text, HEAD + text, HEAD + "[content]\n" + text):
            try:
                parse_level(whole, "c12", Content)
            except LevelError as error:
                assert "\n" not in str(error)


class TestAbsurdFiles:
    def told(self, path: Path) -> str:
        with pytest.raises(LevelError) as caught:
            load_level(path, "c12", Content)
        assert str(caught.value).startswith(f"{path}: ")
        assert "\n" not in str(caught.value)
        return caught.value.reason

    def test_what_is_no_file(self, tmp_path: Path) -> None:
        (tmp_path / "loop").symlink_to(tmp_path / "loop")
        (tmp_path / "dangling").symlink_to(tmp_path / "nowhere")
        (tmp_path / "file").write_text("x")
        os.mkfifo(tmp_path / "pipe")
        assert "is a directory" in self.told(tmp_path)
        assert "not a regular file" in self.told(tmp_path / "pipe")
        assert "not a regular file" in self.told(Path("/dev/zero"))
        assert "no such file" in self.told(tmp_path / "missing")
        assert "no such file" in self.told(tmp_path / "dangling")
        assert "not a directory" in self.told(tmp_path / "file" / "a.toml")
        assert "symbolic links" in self.told(tmp_path / "loop")

    def test_a_name_that_is_too_long(self, tmp_path: Path) -> None:
        with pytest.raises(LevelError, match=r"^…x+: file name too long$"):
            load_level(tmp_path / ("x" * 300), "c12", Content)

    def test_a_name_that_is_none(self) -> None:
        with pytest.raises(LevelError, match="not a file name"):
            load_level(Path("a\x00b"), "c12", Content)

    @pytest.mark.parametrize(
        ("data", "reason"),
        [
            (b"", "empty"),
            (b" \n\t\n", "empty"),
            (b"scene = \xff", "not UTF-8 text (byte 8)"),
            (bytes(range(256)), "not UTF-8"),
            (b"#" * (MAX_BYTES + 1), f"longer than {MAX_BYTES} bytes"),
            ("scene = 'c12'".encode("utf-16"), "not UTF-8"),
        ],
        ids=["empty", "blank", "not utf-8", "binary", "long", "utf-16"],
    )
    def test_what_is_no_text(self, tmp_path: Path, data: bytes, reason: str) -> None:
        path = tmp_path / "a.toml"
        path.write_bytes(data)
        assert reason in self.told(path)

    def test_a_link_to_a_level_is_followed(self, tmp_path: Path) -> None:
        (tmp_path / "real.toml").write_text(HEAD)
        (tmp_path / "link.toml").symlink_to(tmp_path / "real.toml")
        assert load_level(tmp_path / "link.toml", "c12", None).scene == "c12"

    def test_a_byte_order_mark_is_passed_over(self, tmp_path: Path) -> None:
        (tmp_path / "a.toml").write_bytes(b"\xef\xbb\xbf" + HEAD.encode())
        assert load_level(tmp_path / "a.toml", "c12", None).scene == "c12"


finite = st.floats(allow_nan=False, allow_infinity=False)
words = st.text(st.characters(exclude_categories=["Cs"]), max_size=10)
keys = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=8)
levels = st.builds(
    Level,
    scene=st.just("c12"),
    title=words,
    about=words,
    hard_case=words,
    seed=st.integers(0, 2**63 - 1),
    parameters=st.dictionaries(keys, finite | st.booleans() | words, max_size=4),
    effects_off=st.lists(words, max_size=3).map(tuple),
    content=st.none()
    | st.builds(
        Content,
        balls=st.lists(
            st.builds(
                Ball,
                radius=st.floats(5e-324, 10.0),
                mass=st.floats(allow_nan=False),
                position=st.tuples(finite, finite),
                name=st.none() | words,
            ),
            max_size=3,
        ),
        weights=st.dictionaries(keys, finite, max_size=3),
        far=st.lists(st.floats(allow_nan=False), max_size=3),
    ),
)


class TestWriting:
    @given(levels)
    def test_what_is_written_is_read_back(self, level: Level) -> None:
        again = parse_level(format_level(level), "c12", Content)
        assert msgspec.structs.replace(again, path=None) == level

    @pytest.mark.parametrize(
        "content",
        [
            Content(far=[math.nan]),
            Content(weights={"a": math.inf}),
            Content(balls=[Ball(radius=math.nan)]),
            Content(balls=[Ball(radius=-1.0)]),
            Content(balls=[Ball(radius=1.0, name="much too long")]),
        ],
    )
    def test_what_could_not_be_read_is_not_written(self, tmp_path: Path, content: Content) -> None:
        path = tmp_path / "a.toml"
        path.write_text("old")
        with pytest.raises(LevelError):
            save_level(Level(scene="c12", content=content), path)
        assert path.read_text() == "old"
        assert [entry.name for entry in tmp_path.iterdir()] == ["a.toml"]

    def test_what_is_too_long_is_not_written(self, tmp_path: Path) -> None:
        content = Content(far=[1.0 / 3.0] * 60_000)
        with pytest.raises(LevelError, match="would be longer"):
            save_level(Level(scene="c12", content=content), tmp_path / "a.toml")
        assert not list(tmp_path.iterdir())

    def test_numbers_out_of_arrays(self, tmp_path: Path) -> None:
        place = np.array([0.1, 0.2])
        content = Content(balls=[Ball(radius=np.float64(0.3), position=(place[0], place[1]))], far=place)
        save_level(Level(scene="c12", content=content), tmp_path / "a.toml")
        again = load_level(tmp_path / "a.toml", "c12", Content).content
        assert again == Content(balls=[Ball(radius=0.3, position=(0.1, 0.2))], far=[0.1, 0.2])

    def test_folders_on_the_way_are_made(self, tmp_path: Path) -> None:
        save_level(Level(scene="c12"), tmp_path / "a" / "b" / "c.toml")
        assert load_level(tmp_path / "a" / "b" / "c.toml", "c12", None).scene == "c12"


class TestListing:
    def test_order(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        folder = tmp_path / "levels" / "c12"
        folder.mkdir(parents=True)
        for name in (
            "hard-b.toml",
            "rope.toml",
            "default.toml",
            "hard-a.toml",
            "a.toml",
            "notes.txt",
            ".x.toml",
        ):
            (folder / name).write_text(HEAD)
        monkeypatch.setenv("CAROM_HOME", str(tmp_path))
        names = [path.name for path in user_level_files("c12")]
        assert names == ["default.toml", "a.toml", "rope.toml", "hard-a.toml", "hard-b.toml"]

    def test_a_scene_without_levels(self) -> None:
        assert level_files("no-such-scene") == []

    @pytest.mark.parametrize("name", ["", "..", "a/b", "../c01", "C01", "a b", "-a", "a\x00"])
    def test_names_that_are_none(self, name: str) -> None:
        with pytest.raises(ValueError, match="scene name"):
            level_files(name)
        with pytest.raises(ValueError, match="scene name"):
            user_level_files(name)


def test_the_limit_of_a_file_counts_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    level = Level(scene="example", about="é" * 60)
    path = tmp_path / "a.toml"
    text = format_level(level)
    monkeypatch.setattr("game.levels.MAX_BYTES", len(text.encode()) - 1)
    assert len(text) < len(text.encode()) - 1
    with pytest.raises(LevelError, match="longer than"):
        save_level(level, path)
    assert not path.exists()
    monkeypatch.setattr("game.levels.MAX_BYTES", len(text.encode()))
    save_level(level, path)
    assert load_level(path, "example", None).about == level.about


def test_the_pace_of_a_level_is_kept_and_has_bounds():
    text = 'scene = "example"\npace = 0.25\n'
    level = parse_level(text, "example", None)
    assert level.pace == 0.25 and "pace = 0.25" in format_level(level)
    assert "pace" not in format_level(Level(scene="example"))
    for wrong in ("0.01", "5.0", '"slow"'):
        with pytest.raises(LevelError, match="pace"):
            parse_level(text.replace("0.25", wrong), "example", None)
