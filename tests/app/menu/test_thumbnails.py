"""Pictures kept for the menu's cards: read again only where nobody else can have put them."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pygame
import pytest

from game.app.menu.thumbnails import Thumbnails
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.app.tests_app import Driver

SIZE = (24, 16)
only_with_owners = pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A picture that an earlier session has kept."""
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "cache"))
    path = tmp_path / "cache" / "thumbnails" / f"example-{DARK.name}-24x16.png"
    path.parent.mkdir(parents=True, mode=0o700)
    picture = pygame.Surface(SIZE, 0, 32)
    picture.fill((200, 30, 40))
    pygame.image.save(picture, str(path))
    path.chmod(0o600)
    return path


def taken(driver: Driver) -> pygame.Surface | None:
    return Thumbnails(driver.app).load("example", SIZE, Look(DARK))


def test_a_picture_of_ones_own_is_shown_again(driver: Driver, kept: Path) -> None:
    picture = taken(driver)
    assert picture is not None and tuple(picture.get_at((3, 3)))[:3] == (200, 30, 40)


@only_with_owners
@pytest.mark.parametrize("open_to_others", ["file", "folder", "folder above"])
def test_what_others_may_have_written_is_not_read(driver: Driver, kept: Path, open_to_others: str) -> None:
    place = {"file": kept, "folder": kept.parent, "folder above": kept.parent.parent}[open_to_others]
    place.chmod(stat.S_IMODE(place.stat().st_mode) | 0o022)
    assert taken(driver) is None


def test_a_damaged_or_missing_picture_is_none(driver: Driver, kept: Path) -> None:
    kept.write_bytes(b"no picture")
    assert taken(driver) is None
    kept.unlink()
    assert taken(driver) is None
