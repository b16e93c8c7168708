"""Files that travel with the program are found, and missed by name."""

import pytest

from game.ui.look.assets import asset


def test_fonts_and_their_licences_are_there():
    for name in ("LICENSE-Inter.txt", "LICENSE-STIX.txt", "CaromSans-Medium.otf", "STIXGeneral-Regular.otf"):
        assert asset("fonts", name).is_file()


def test_a_missing_file_is_named():
    with pytest.raises(FileNotFoundError, match=r"assets: there is no fonts/Comic\.otf"):
        asset("fonts", "Comic.otf")
