"""Files that travel with the program are found in a checkout and when installed, and missed by name."""

import pytest

from game.ui import assets
from game.ui.assets import asset, assets_folder


def test_fonts_and_their_licences_are_there():
    names = {path.name for path in (assets_folder() / "fonts").iterdir()}
    assert {"LICENSE-Inter.txt", "LICENSE-STIX.txt", "CaromSans-Medium.otf"} <= names


def test_a_missing_file_is_named():
    with pytest.raises(FileNotFoundError, match=r"assets: there is no fonts/Comic\.otf"):
        asset("fonts", "Comic.otf")


def test_an_installed_package_brings_its_own(tmp_path, monkeypatch):
    package = tmp_path / "site-packages" / "game"
    (package / "data" / "assets" / "fonts").mkdir(parents=True)
    monkeypatch.setattr(assets, "_PACKAGE", package)
    assert assets_folder.__wrapped__() == package / "data" / "assets"
    (tmp_path / "site-packages" / "assets" / "fonts").mkdir(parents=True)
    assert assets_folder.__wrapped__() == tmp_path / "site-packages" / "assets"
