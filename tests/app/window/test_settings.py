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
        theme="light", ui_scale=1.25, less_motion=True, width=800, height=600, keys={"pause": "p"},
        favourites=["c13", "no more"], recent=["c01"],
    )  # fmt: skip
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


def test_what_is_sound_in_a_broken_file_holds(tmp_path: Path):
    path = settings_path(tmp_path)
    lists = 'favourites = ["c13", "c04"]\nrecent = ["c01"]\n'
    path.write_text(f'theme = "pink"\n{lists}volume = 0.25\n[keys]\nfly = "f"')
    loaded = load_settings(tmp_path)
    assert loaded.settings == Settings(favourites=["c13", "c04"], recent=["c01"], volume=0.25)
    assert "theme" in loaded.complaint and "\n" not in loaded.complaint
    assert "settings.broken.toml" in loaded.complaint and not loaded.first_start


@pytest.mark.parametrize("field", ["favourites", "recent"])
@pytest.mark.parametrize("value", ['"c13"', "[1, 2]", '{ a = "b" }', '["' + "x" * 101 + '"]'])
def test_scene_names_that_are_none_are_refused(tmp_path: Path, field: str, value: str):
    settings_path(tmp_path).write_text(f"{field} = {value}\nvolume = 0.25")
    loaded = load_settings(tmp_path)
    assert loaded.settings == Settings(volume=0.25) and field in loaded.complaint


def test_files_that_broke_earlier_are_not_written_over(tmp_path: Path):
    for content in ("theme = 1", "theme = 2", "theme = 3"):
        settings_path(tmp_path).write_text(content)
        load_settings(tmp_path)
    kept = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert kept == {
        "settings.broken.toml": "theme = 1",
        "settings.broken2.toml": "theme = 2",
        "settings.broken3.toml": "theme = 3",
    }


def test_first_start_is_one_without_a_file(tmp_path: Path):
    assert load_settings(tmp_path).first_start
    save_settings(Settings(), tmp_path)
    assert not load_settings(tmp_path).first_start
    settings_path(tmp_path).write_text("theme = ")
    assert not load_settings(tmp_path).first_start


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
