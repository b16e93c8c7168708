"""Writing a file whole or not at all; folders."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from game import files, folders
from game.files import FileProblem, read_text, write_text


class TestWriting:
    def test_it_replaces_and_leaves_nothing_beside(self, tmp_path: Path) -> None:
        path = tmp_path / "a.txt"
        for text in ("one", "zwei \u00e4\u2082", ""):
            write_text(path, text)
            assert path.read_text(encoding="utf-8") == text
        assert list(tmp_path.iterdir()) == [path]

    @pytest.mark.parametrize("failing", ["fsync", "replace", "write"])
    def test_a_failure_leaves_the_old_file(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: str
    ) -> None:
        path = tmp_path / "a.txt"
        path.write_text("old")

        def fail(*arguments, **named):
            raise OSError(28, "No space left on device")

        if failing == "fsync":
            monkeypatch.setattr(files.os, "fsync", fail)
        elif failing == "write":
            monkeypatch.setattr(files.os, "fdopen", fail)
        else:
            monkeypatch.setattr(Path, "replace", fail)
        with pytest.raises(FileProblem, match="no space left on device"):
            write_text(path, "new")
        assert path.read_text() == "old"
        assert list(tmp_path.iterdir()) == [path]

    def test_an_interruption_leaves_the_old_file(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        path = tmp_path / "a.txt"
        path.write_text("old")

        def interrupt(*arguments):
            raise KeyboardInterrupt

        monkeypatch.setattr(files.os, "fsync", interrupt)
        with pytest.raises(KeyboardInterrupt):
            write_text(path, "new")
        assert path.read_text() == "old"
        assert list(tmp_path.iterdir()) == [path]

    def test_what_is_no_place_for_a_file(self, tmp_path: Path) -> None:
        (tmp_path / "file").write_text("x")
        (tmp_path / "link").symlink_to(tmp_path / "file")
        os.mkfifo(tmp_path / "pipe")
        for path, reason in (
            (tmp_path, "not a regular file"),
            (tmp_path / "pipe", "not a regular file"),
            (tmp_path / "link", "symbolic link"),
            (tmp_path / "file" / "a", "not a directory"),
            (tmp_path / ("x" * 300), "too long"),
            (tmp_path / "a\x00b", "not a file name"),
        ):
            with pytest.raises(FileProblem, match=reason):
                write_text(path, "new")
        assert (tmp_path / "file").read_text() == "x"

    def test_permissions(self, tmp_path: Path) -> None:
        path = tmp_path / "a.txt"
        mask = os.umask(0o027)
        try:
            write_text(path, "one")
            assert stat.S_IMODE(path.stat().st_mode) == 0o640
            path.chmod(0o604)
            write_text(path, "two")
            assert stat.S_IMODE(path.stat().st_mode) == 0o604
            assert os.umask(0o027) == 0o027
        finally:
            os.umask(mask)

    @pytest.mark.skipif(os.name == "nt", reason="folders cannot be opened there")
    def test_it_is_on_the_disk_before_it_has_its_name_and_then_the_name_is(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        """Otherwise after a failure of power the name may stand for an empty file, or for none."""
        path, done, flush = tmp_path / "a.txt", [], os.fsync

        def fsync(handle: int) -> None:
            found = os.fstat(handle)
            if stat.S_ISDIR(found.st_mode):
                done.append(("folder", os.path.samestat(found, tmp_path.stat()), path.exists()))
            else:
                done.append(("file", found.st_size, path.exists()))
            flush(handle)

        monkeypatch.setattr(os, "fsync", fsync)
        write_text(path, "x" * 100)
        assert done == [("file", 100, False), ("folder", True, True)]

    def test_reading_is_limited(self, tmp_path: Path) -> None:
        path = tmp_path / "a.txt"
        path.write_text("x" * 100)
        assert read_text(path, 100) == "x" * 100
        with pytest.raises(FileProblem, match="longer than 99 bytes"):
            read_text(path, 99)


class TestFolders:
    def test_data(self) -> None:
        for kind in ("assets", "levels"):
            assert folders.data_folder(kind).is_dir()
        with pytest.raises(ValueError, match="data folder 'songs'"):
            folders.data_folder("songs")

    def test_data_of_an_installation(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(folders, "PACKAGE", tmp_path / "game")
        with pytest.raises(FileNotFoundError, match="no folder of levels"):
            folders.data_folder("levels")
        (tmp_path / "game" / "data" / "levels").mkdir(parents=True)
        (tmp_path / "levels").mkdir()
        assert folders.data_folder("levels") == tmp_path / "game" / "data" / "levels"

    def test_the_person_may_say_where(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("CAROM_HOME", str(tmp_path))
        monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "cache"))
        assert folders.user_folder() == tmp_path
        assert folders.pictures_folder() == tmp_path / "pictures"
        assert folders.cache_folder() == tmp_path / "cache"

    def test_an_empty_word_says_nothing(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("CAROM_HOME", "")
        monkeypatch.setenv("CAROM_CACHE_DIR", "")
        assert folders.user_folder().is_absolute()
        assert "carom" in str(folders.cache_folder())

    def test_a_person_without_a_home(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """No "~" folder is made in the folder the program stands in."""
        monkeypatch.setenv("CAROM_CACHE_DIR", "")
        monkeypatch.setattr(folders.platformdirs, "user_cache_dir", lambda *a, **n: "~/.cache/carom")
        monkeypatch.setattr(folders.tempfile, "gettempdir", lambda: str(tmp_path))
        first = folders.cache_folder()
        assert first.is_absolute()
        assert tmp_path in first.parents
        assert folders.cache_folder() == first
        assert stat.S_IMODE(first.parent.stat().st_mode) == 0o700

    @pytest.mark.parametrize("home", ["", "relative", "./here"])
    def test_a_home_that_is_none(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, home: str) -> None:
        """A user whom the system does not know, as in a container, without the variables that help."""
        pwd = pytest.importorskip("pwd")

        def unknown(user: int) -> None:
            raise KeyError(user)

        monkeypatch.setattr(pwd, "getpwuid", unknown)
        for name in list(os.environ):
            if name.startswith(("XDG_", "CAROM_")):
                monkeypatch.delenv(name)
        monkeypatch.setenv("HOME", home)
        monkeypatch.setattr(folders.tempfile, "gettempdir", lambda: str(tmp_path))
        mine = tmp_path / f"carom-{os.getuid()}"
        assert folders.user_folder() == mine / "data"
        assert folders.cache_folder() == mine / "cache"
        assert folders.pictures_folder() == mine / "pictures" / "Carom"

    def test_a_temporary_folder_of_somebody_else_is_not_taken(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("CAROM_CACHE_DIR", "")
        monkeypatch.setattr(folders.platformdirs, "user_cache_dir", lambda *a, **n: "~/.cache/carom")
        monkeypatch.setattr(folders.tempfile, "gettempdir", lambda: str(tmp_path))
        mine = folders.cache_folder().parent
        mine.chmod(0o777)
        assert folders.cache_folder().parent != mine
        mine.chmod(0o700)
        monkeypatch.setattr(folders.os, "getuid", lambda: os.geteuid() + 1)
        (tmp_path / f"carom-{os.geteuid() + 1}").mkdir(mode=0o700)
        assert folders.cache_folder().parent.name != f"carom-{os.geteuid() + 1}"
