"""Heads of levels: read without what follows, whatever a file looks like."""

from __future__ import annotations

import tomllib
from pathlib import Path
from types import SimpleNamespace

import pytest

from game.app.stagehand import level_index
from game.app.stagehand.files import level_rows
from game.app.stagehand.level_index import LevelHead, level_heads
from game.scenes import CATALOGUE

HEAD = 'scene = "example"\ntitle = "A level"\nabout = "Words."\nhard_case = "E.H1"\n'
LONG = "\n[content]\npoints = [\n" + "  [0.25, 0.5],\n" * 5000 + "]\n"


@pytest.fixture
def heads_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Heads of a scene that has these files, and how many letters were parsed for them."""
    monkeypatch.setattr(level_index, "level_files", lambda name: sorted(tmp_path.glob("*.toml")))
    monkeypatch.setattr(level_index, "user_level_files", lambda name: [])
    parsed: list[int] = []

    def loads(text: str) -> dict[str, object]:
        parsed.append(len(text))
        return tomllib.loads(text)

    monkeypatch.setattr(level_index, "tomllib", SimpleNamespace(loads=loads))

    level_index._read.cache_clear()

    def write_and_read(text: str | None) -> tuple[LevelHead, int]:
        if text is not None:
            (tmp_path / "a-file.toml").write_text(text, encoding="utf-8")
        parsed.clear()
        return level_heads("example")[0], sum(parsed)

    return write_and_read


def test_only_the_head_is_parsed(heads_of):
    head, letters = heads_of(HEAD + LONG)
    assert head[1:4] == ("A level", "Words.", "E.H1")
    assert letters <= len(HEAD) + 1


def test_a_file_is_read_again_when_it_has_changed(heads_of):
    assert heads_of(HEAD)[0].title == "A level"
    head, letters = heads_of(None)
    assert head.title == "A level" and letters == 0
    head, letters = heads_of(HEAD.replace("A level", "Another level"))
    assert head.title == "Another level" and letters > 0


@pytest.mark.parametrize(
    "text",
    [
        HEAD.replace('"Words."', '"""\n[not a table]\nWords."""') + LONG,
        "more = [\n  [1],\n  [2],\n]\n" + HEAD,
        "# only words\n" + HEAD,
    ],
)
def test_a_bracket_that_begins_no_table(heads_of, text: str):
    head, _ = heads_of(text)
    assert head.title == "A level" and "Words." in head.about and head.hard_case == "E.H1"


@pytest.mark.parametrize("text", ["", "[[[[", "title = ", 'title = """\n', "\x00", "a = " + "[" * 5000])
def test_a_broken_file_is_named_by_its_file(heads_of, text: str):
    head, _ = heads_of(text)
    assert head[1:4] == ("A file", "", "")


def test_heads_are_those_of_the_whole_files():
    for name in ("c02", "c13", "billiards"):
        for head in level_heads(CATALOGUE[name].name):
            whole = tomllib.loads(head.path.read_text(encoding="utf-8"))
            assert head.title == whole["title"] and head.about == whole.get("about", "")


@pytest.mark.parametrize("entry", tuple(CATALOGUE), ids=lambda entry: entry.name)
def test_a_hard_case_is_called_so_and_not_by_its_id(entry):
    rows = level_rows(entry.load())
    marked = [row for row in rows if row.marked]
    assert {row.chip for row in marked} <= {"hard case"}
    assert len(marked) == sum(bool(head.hard_case) for head in level_heads(entry.name))
