"""What the README and the pages beside it show must run, and they name what there is."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
README = ROOT / "README.md"
TEXT = README.read_text(encoding="utf-8")
ASSETS = ROOT / "assets"
PAGES = [*ROOT.glob("*.md"), *ASSETS.glob("*.md")]
PROGRAMS = re.findall(
    r"```python\n(.*?)```", TEXT + (ASSETS / "LIBRARY.md").read_text(encoding="utf-8"), re.S
)
PRINTED = ("events in", "events in", "cm high", "into pocket", "pairs, near a corner", "Verlet order 2")
MOST_LINES = 200  # of the README


@pytest.mark.parametrize(("program", "printed"), list(zip(PROGRAMS, PRINTED, strict=True)))
def test_programs_run(program, printed, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exec(compile(program, "README.md", "exec"), {})
    assert printed in capsys.readouterr().out


def test_pictures_are_there():
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", TEXT)
    assert pictures and all((ROOT / picture).is_file() for picture in pictures)


def test_both_commands_are_one_line_each():
    for mark in ("play", "test"):
        fence = re.search(rf"<!-- {mark} -->\n```\n(.*?)```", TEXT, re.S)
        assert fence is not None and len(fence.group(1).strip().splitlines()) == 1


def test_every_scene_is_named():
    from game.scenes import CATALOGUE

    told = (ASSETS / "SCENES.md").read_text(encoding="utf-8")
    assert [entry.name for entry in CATALOGUE if told.count(f"`{entry.name}`") != 1] == []


def test_the_readme_is_short():
    assert len(TEXT.splitlines()) <= MOST_LINES


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_of_pages_lead_somewhere(page):
    links = re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8"))
    assert [
        link for link in links if not link.startswith("https://") and not (page.parent / link).exists()
    ] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_modules_that_pages_name_are_there(page):
    named = re.findall(r"`((?:game|tests)/[\w/]+\.(?:py|json))`", page.read_text(encoding="utf-8"))
    assert [name for name in named if not (ROOT / name).exists()] == []


def test_the_architecture_names_every_floor_and_every_room_of_physics():
    from tests.test_floors import FLOORS

    told = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    assert [floor for floor in FLOORS if floor != "__main__" and f"`{floor}`" not in told] == []
    named = re.findall(r"`((?:physics|billiards)/[a-z/_.]+)`", told)
    assert len(named) > 20
    assert [name for name in named if not (ROOT / "game" / name).exists()] == []
