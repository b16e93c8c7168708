"""The tree holds text; what is not text is a font or a picture, and lies in ``assets``."""

import subprocess
from pathlib import Path

import pytest

from tests.paths import ROOT

FONTS_AND_PICTURES = frozenset((".otf", ".ttf", ".png"))


def files_of_the_tree() -> list[Path]:
    """What git keeps, with what it would keep; without git, or in an unpacked copy, what the folders hold."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        done = subprocess.run(command, cwd=ROOT, capture_output=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        folders = (ROOT / name for name in ("assets", "game", "levels", "tests"))
        found = [path for folder in folders for path in folder.rglob("*")]
        return [path for path in (*ROOT.glob("*"), *found) if path.is_file() and path.suffix != ".pyc"]
    names = done.stdout.decode("utf-8").split("\0")
    return [ROOT / name for name in names if name and (ROOT / name).is_file()]


def is_text(path: Path) -> bool:
    data = path.read_bytes()
    try:
        return "\0" not in data.decode("utf-8")
    except UnicodeDecodeError:
        return False


def test_no_binary_lies_outside_of_the_assets() -> None:
    files = files_of_the_tree()
    assert len(files) > 1000
    binaries = [path for path in files if not is_text(path)]
    assert binaries, "there are fonts at least"
    assert [
        str(path.relative_to(ROOT))
        for path in binaries
        if path.suffix not in FONTS_AND_PICTURES or not path.is_relative_to(ROOT / "assets")
    ] == []


@pytest.mark.parametrize(("data", "text"), [(b"", True), ("ä\n".encode(), True), (b"a\0b", False),
                                            (b"PK\x03\x04\xff", False)])  # fmt: skip
def test_what_counts_as_text(data: bytes, text: bool, tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(data)
    assert is_text(path) == text
