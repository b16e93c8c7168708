"""Settings: kept whole, read back, and a broken file costs one line."""

from pathlib import Path

import pytest

from game.app.window.settings import Settings, load_settings, save_settings, settings_path


def test_no_file_means_defaults(tmp_path: Path):
    loaded = load_settings(tmp_path)
    assert loaded.settings == Settings()
    assert loaded.complaint == ""


def test_what_is_saved_is_read_back(tmp_path: Path):
    settings = Settings(
        theme="light", ui_scale=1.25, less_motion=True, width=800, height=600, keys={"pause": "p"}
    )
    save_settings(settings, tmp_path / "new" / "folder")
    loaded = load_settings(tmp_path / "new" / "folder")
    assert loaded.settings == settings
    assert loaded.complaint == ""
    assert [path.name for path in (tmp_path / "new" / "folder").iterdir()] == ["settings.toml"]


@pytest.mark.parametrize(
    ("content", "word"),
    [
        (b"theme = ", "settings.toml"),
        (b'theme = "pink"', "theme"),
        (b"ui_scale = 9.0", "ui_scale"),
        (b"ui_scale = nan", "ui_scale"),
        (b"width = 0", "width"),
        (b"colour = 1", "colour"),
        (b'[keys]\npause = "nonsense"', "nonsense"),
        (b'[keys]\nfly = "f"', "fly"),
        (b'[keys]\npause = "x"\nstep = "x"', "also the key of pause"),
        (b"\xff\xfe\x00", "UTF-8"),
        (b"", "empty"),
        (b"a = " + b"[" * 3000, "settings.toml"),
        (b"# " + b"x" * 200_000, "longer"),
    ],
)
def test_broken_file_gives_one_line_and_is_kept(tmp_path: Path, content: bytes, word: str):
    path = settings_path(tmp_path)
    path.write_bytes(content)
    loaded = load_settings(tmp_path)
    assert loaded.settings == Settings()
    assert word in loaded.complaint
    assert "\n" not in loaded.complaint
    assert (tmp_path / "settings.broken.toml").read_bytes() == content
    assert not path.exists()


def test_folder_in_place_of_the_file(tmp_path: Path):
    settings_path(tmp_path).mkdir()
    loaded = load_settings(tmp_path)
    assert loaded.settings == Settings()
    assert loaded.complaint


def test_settings_that_cannot_be_kept_are_told_and_hold(start):
    driver = start()
    settings_path(driver.app.folder).unlink(missing_ok=True)
    settings_path(driver.app.folder).mkdir(parents=True)
    before = driver.app.settings.theme
    driver.app.toggle_theme()
    driver.frames(1)
    assert driver.app.settings.theme != before and driver.app.look.theme.name == driver.app.settings.theme
    assert driver.app.toasts.shown.cause == "Settings not kept."
    assert "not a regular file" in driver.app.toasts.shown.consequence
