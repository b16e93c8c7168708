"""Folders that code may be taken from: who could have written there, link by link."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from game import trust
from game.trust import is_private_file, make_private_folder, reason_to_distrust

STRANGER = 54_321  # a user and a group that nobody here is
pytestmark = pytest.mark.skipif(not hasattr(os, "geteuid"), reason="files have no owners here")
as_root = pytest.mark.skipif(getattr(os, "geteuid", lambda: 1)() != 0, reason="only root may give files away")


@pytest.fixture
def chain(tmp_path: Path) -> list[Path]:
    """Three folders, each within the one before."""
    folders = [tmp_path / "a", tmp_path / "a" / "b", tmp_path / "a" / "b" / "c"]
    make_private_folder(folders[-1])
    return folders


class TestFolders:
    def test_made_here_it_is_trusted(self, chain: list[Path]) -> None:
        assert [reason_to_distrust(folder) for folder in chain] == ["", "", ""]

    def test_what_is_made_is_private_whatever_the_mask(self, tmp_path: Path) -> None:
        before = os.umask(0)
        try:
            make_private_folder(tmp_path / "x" / "y")
        finally:
            os.umask(before)
        assert stat.S_IMODE((tmp_path / "x").stat().st_mode) == 0o700
        assert stat.S_IMODE((tmp_path / "x" / "y").stat().st_mode) == 0o700

    @pytest.mark.parametrize("place", [0, 1, 2])
    def test_others_may_write_anywhere_on_the_way(self, chain: list[Path], place: int) -> None:
        chain[place].chmod(0o777)
        assert reason_to_distrust(chain[-1]) == f"others may write in {chain[place]}"

    def test_a_sticky_folder_on_the_way_but_not_at_the_end(self, chain: list[Path]) -> None:
        chain[1].chmod(0o1777)
        assert reason_to_distrust(chain[2]) == ""
        assert reason_to_distrust(chain[1]) == f"others may write in {chain[1]}"

    @as_root
    @pytest.mark.parametrize("place", [0, 1, 2])
    def test_another_users_folder(self, chain: list[Path], place: int) -> None:
        chain[0].chmod(0o1777)
        os.chown(chain[place], STRANGER, STRANGER)
        assert reason_to_distrust(chain[-1]) == f"{chain[place]} belongs to another user"

    @as_root
    def test_a_group_of_others_may_not_write(self, chain: list[Path]) -> None:
        os.chown(chain[1], -1, STRANGER)
        chain[1].chmod(0o770)
        assert reason_to_distrust(chain[2]) == f"others may write in {chain[1]}"

    @pytest.mark.parametrize(("members", "trusted"), [([], True), (["me"], True), (["me", "you"], False)])
    def test_a_group_of_one_may(
        self, chain: list[Path], members: list[str], trusted: bool, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        grp, pwd = pytest.importorskip("grp"), pytest.importorskip("pwd")
        chain[1].chmod(0o770)
        group = chain[1].stat().st_gid
        monkeypatch.setattr(grp, "getgrgid", lambda gid: grp.struct_group(("me", "x", gid, members)))
        monkeypatch.setattr(
            pwd, "getpwuid", lambda uid: pwd.struct_passwd(("me", "x", uid, group, "", "/", ""))
        )
        trust._is_group_of_one.cache_clear()
        try:
            assert (reason_to_distrust(chain[2]) == "") is trusted
        finally:
            trust._is_group_of_one.cache_clear()

    def test_missing(self, chain: list[Path]) -> None:
        with pytest.raises(FileNotFoundError):
            reason_to_distrust(chain[2] / "d")

    def test_a_file_on_the_way(self, chain: list[Path]) -> None:
        (chain[2] / "file").write_text("x")
        for path in (chain[2] / "file", chain[2] / "file" / "d"):
            with pytest.raises(NotADirectoryError):
                reason_to_distrust(path)

    def test_where_files_have_no_owners(self, chain: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
        chain[0].chmod(0o777)
        monkeypatch.delattr(os, "geteuid")
        assert reason_to_distrust(chain[2]) == ""


class TestLinks:
    def test_a_link_of_this_user_is_followed(self, chain: list[Path], tmp_path: Path) -> None:
        (tmp_path / "link").symlink_to(chain[1])
        (chain[0] / "near").symlink_to("b/../b")
        assert reason_to_distrust(tmp_path / "link" / "c") == ""
        assert reason_to_distrust(chain[0] / "near" / "c") == ""

    @pytest.mark.parametrize("target", ["{}", "../a/b/c", "b/c", "b/../b/c", "../a/./b/c/../c"])
    def test_where_it_leads_is_looked_at(self, chain: list[Path], target: str) -> None:
        link = chain[0] / "link"
        link.symlink_to(target.format(chain[2]))
        chain[1].chmod(0o777)
        assert reason_to_distrust(link) == f"others may write in {chain[1]}"

    def test_where_it_lies_is_looked_at(self, chain: list[Path], tmp_path: Path) -> None:
        make_private_folder(tmp_path / "d")
        (tmp_path / "d" / "link").symlink_to(chain[2])
        (tmp_path / "d").chmod(0o777)
        assert reason_to_distrust(tmp_path / "d" / "link") == f"others may write in {tmp_path / 'd'}"

    def test_a_way_that_ends_by_going_up(self, chain: list[Path]) -> None:
        """The last folder was met on the way; at the end more is wanted of it."""
        chain[1].chmod(0o1777)
        assert reason_to_distrust(chain[2] / "..") == f"others may write in {chain[1]}"

    @as_root
    def test_another_users_link_in_a_sticky_folder(self, chain: list[Path], tmp_path: Path) -> None:
        shared = tmp_path / "shared"
        shared.mkdir()
        shared.chmod(0o1777)
        (shared / "link").symlink_to(chain[2])
        assert reason_to_distrust(shared / "link") == ""
        os.chown(shared / "link", STRANGER, STRANGER, follow_symlinks=False)
        assert reason_to_distrust(shared / "link") == f"{shared / 'link'} belongs to another user"

    def test_in_a_ring(self, chain: list[Path]) -> None:
        (chain[0] / "one").symlink_to("two")
        (chain[0] / "two").symlink_to("one")
        assert reason_to_distrust(chain[0] / "one").endswith("too many links")


class TestFiles:
    @pytest.mark.parametrize(
        ("mode", "private"), [(0o600, True), (0o644, True), (0o664, False), (0o602, False)]
    )
    def test_modes(self, tmp_path: Path, mode: int, private: bool) -> None:
        path = tmp_path / "a"
        path.write_text("x")
        path.chmod(mode)
        assert is_private_file(path.stat()) is private

    def test_no_file(self, tmp_path: Path) -> None:
        assert not is_private_file(tmp_path.stat())

    @as_root
    def test_another_users(self, tmp_path: Path) -> None:
        path = tmp_path / "a"
        path.write_text("x")
        os.chown(path, STRANGER, STRANGER)
        assert not is_private_file(path.stat())
