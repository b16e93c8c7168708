"""The command line: what it writes, and one line with status 2 for every mistake."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pygame
import pytest

from game.app.commands import run_command_line
from game.app.commands.given import read_level
from game.app.window.mistake import MistakeError
from game.levels import Level, save_level
from game.scenes import CATALOGUE as SCENES
from game.stage import Equation
from game.ui.look.layout import arrange, auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.paths import ROOT


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    """Status, output and complaint of a command."""
    status = run_command_line(arguments)
    said = capsys.readouterr()
    return status, said.out, said.err


@pytest.fixture
def level(tmp_path: Path) -> Path:
    """A level file of the example scene."""
    path = tmp_path / "high.toml"
    save_level(Level(scene="example", title="High", seed=3, parameters={"height": 20.0}), path)
    return path


def test_run_writes_what_it_measured(capsys, tmp_path: Path):
    file = tmp_path / "s.json"
    status, out, err = run(
        capsys, "run", "example", "--seconds", "2", "--set", "gravity=5", "--json", str(file)
    )
    assert (status, err) == (0, "")
    report = json.loads(file.read_text())
    assert report["scene"] == "example"
    assert report["steps"] == 240
    assert report["simulated_s"] == pytest.approx(2.0)
    assert report["cpu_s"] >= 0.0
    assert report["parameters"]["gravity"] == 5.0
    assert report["effects"] == {"test-gravity": True, "test-ground": True}
    assert set(report["readouts"]) == {"energy", "height"}
    assert report["digest"] in out


def test_two_runs_have_one_digest_and_another_parameter_another(capsys, tmp_path: Path):
    digests = []
    for extra in ([], [], ["--set", "restitution=0.5"], ["--effects-off", "test-ground"]):
        file = tmp_path / "s.json"
        assert run(capsys, "run", "example", "--seconds", "3", "--json", str(file), *extra)[0] == 0
        digests.append(json.loads(file.read_text())["digest"])
    assert digests[0] == digests[1]
    assert len(set(digests)) == 3


def test_json_to_standard_output_is_nothing_but_json(capsys):
    status, out, _ = run(capsys, "run", "example", "--seconds", "0", "--json", "-")
    assert status == 0
    assert json.loads(out)["steps"] == 0


def test_run_takes_a_level_and_draws_a_picture(capsys, tmp_path: Path, level: Path):
    picture, file = tmp_path / "a.png", tmp_path / "s.json"
    arguments = (
        "--level",
        str(level),
        "--screenshot",
        str(picture),
        "--size",
        "320x200",
        "--json",
        str(file),
    )
    assert run(capsys, "run", "example", "--seconds", "1", *arguments)[0] == 0
    assert pygame.image.load(str(picture)).get_size() == (320, 200)
    report = json.loads(file.read_text())
    assert (report["level"], report["parameters"]["height"]) == ("High", 20.0)


def test_a_picture_shows_the_whole_window_if_asked_and_the_run_is_the_same(capsys, tmp_path: Path):
    import numpy as np

    picture, plain, window = tmp_path / "a.png", tmp_path / "p.json", tmp_path / "w.json"
    common = ("run", "example", "--seconds", "3", "--size", "1000x600")
    assert run(capsys, *common, "--json", str(plain))[0] == 0
    status, *_ = run(capsys, *common, "--window", "--screenshot", str(picture), "--json", str(window))
    assert status == 0
    assert json.loads(plain.read_text())["digest"] == json.loads(window.read_text())["digest"]

    look = Look(DARK, auto_scale(1000, 600))
    strips = sys.modules["example_scene"].BouncingBall.strips
    layout = arrange(1000, 600, look.k, panel=True, strips=len(strips))
    shown = pygame.surfarray.array3d(pygame.image.load(str(picture)))
    assert shown.shape == (1000, 600, 3)
    for part in (layout.panel, layout.top_bar, layout.hint_bar, layout.strips):
        colors = np.unique(shown[part.x : part.right, part.y : part.bottom].reshape(-1, 3), axis=0)
        assert len(colors) > 20, part  # letters, controls, curves
    panel = shown[layout.panel.x + 4, layout.panel.y + 4]
    assert tuple(panel) == tuple(look.theme.panel)[:3]


def test_a_window_smaller_than_any_and_one_without_a_file_are_refused(capsys, tmp_path: Path):
    status, _, err = run(capsys, "run", "example", "--window")
    assert status == 2 and "--screenshot" in err and err.count("\n") == 1
    file = str(tmp_path / "a.png")
    status, _, err = run(capsys, "run", "example", "--window", "--screenshot", file, "--size", "200x100")
    assert status == 2 and "at least 320x240" in err and err.count("\n") == 1


def test_recorded_run_is_replayed_with_the_same_digests(capsys, tmp_path: Path):
    recording, file = tmp_path / "r.json", tmp_path / "s.json"
    run(capsys, "run", "example", "--seconds", "3", "--record", str(recording), "--json", str(file))
    first = json.loads(file.read_text())
    status, out, _ = run(capsys, "replay", str(recording), "--json", str(file))
    assert status == 0
    assert "same digests" in out
    assert json.loads(file.read_text())["digest"] == first["digest"]


def test_altered_recording_does_not_pass(capsys, tmp_path: Path):
    recording = tmp_path / "r.json"
    run(capsys, "run", "example", "--seconds", "3", "--record", str(recording))
    content = json.loads(recording.read_text())
    content["parameters"]["gravity"] = 9.0
    recording.write_text(json.dumps(content))
    status, _, err = run(capsys, "replay", str(recording))
    assert status == 2
    assert "step 120" in err


def test_list_names_parameters_and_levels(capsys):
    import game.scenes
    from game.stage.catalogue import Catalogue
    from tests.app.tests_app import CATALOGUE

    game.scenes.CATALOGUE = Catalogue(CATALOGUE.entries[:1])
    status, out, _ = run(capsys, "list")
    assert status == 0
    assert "gravity" in out and "9.81 m/s²  (0 to 100)" in out
    status, out, _ = run(capsys, "list", "example", "--json", "-")
    row = json.loads(out)["scenes"][0]
    assert row["parameters"][0] == {
        "name": "gravity", "label": "Gravity", "help": "acceleration downwards", "default": 9.81,
        "kind": "number", "minimum": 0.0, "maximum": 100.0, "unit": "m/s²", "whole": False,
    }  # fmt: skip


def test_list_goes_by_category_and_topic(capsys, monkeypatch):
    import game.scenes
    from game.stage.catalogue import Catalogue
    from tests.app.tests_app import example_entry

    places = {
        "one": ("Stories", ""),
        "two": ("Course", "Animation"),
        "three": ("Stories", ""),
        "four": ("Play", ""),
    }
    rows = [example_entry(name)._replace(category=c, topic=t) for name, (c, t) in places.items()]
    monkeypatch.setattr(game.scenes, "CATALOGUE", Catalogue(tuple(rows)))
    status, out, _ = run(capsys, "list")
    lines = [line.split()[0] for line in out.splitlines() if not line.startswith(" ")]
    assert status == 0 and lines == ["Play", "four", "Course:", "two", "Stories", "one", "three"]
    status, out, _ = run(capsys, "list", "two")
    assert out.startswith("two ")
    status, out, _ = run(capsys, "list", "--json", "-")
    told = [(row["name"], row["category"], row["topic"]) for row in json.loads(out)["scenes"]]
    assert told[:2] == [("four", "Play", ""), ("two", "Course", "Animation")]


def test_selftest_passes_the_example_and_fails_the_broken(capsys, tmp_path: Path):
    status, out, _ = run(capsys, "selftest", "example")
    assert status == 0
    assert "1 levels, 0 failed" in out
    golden = tmp_path / "golden.json"
    golden.write_text(json.dumps({"example/(none)": "0" * 32}))
    status, out, _ = run(capsys, "selftest", "example", "--golden", str(golden))
    assert status == 1
    assert "the kept digest is 000" in out


@pytest.mark.parametrize("option", ("--golden", "--update-golden"))
def test_selftest_updates_the_digests_of_the_scenes_named_and_no_others(capsys, tmp_path: Path, option: str):
    golden = tmp_path / "golden.json"
    kept = {
        "another/one": "1" * 32,
        "example/(none)": "0" * 32,
        "example/gone": "3" * 32,
        "other/two": "2" * 32,
    }
    golden.write_text(json.dumps(kept))
    more = ("--update-golden",) if option == "--golden" else ()
    status, out, _ = run(capsys, "selftest", "example", option, str(golden), *more)
    assert status == 0 and "0 failed" in out
    updated = json.loads(golden.read_text())
    assert list(updated) == ["another/one", "example/(none)", "other/two"]
    assert (updated["another/one"], updated["other/two"]) == ("1" * 32, "2" * 32)
    assert len(updated["example/(none)"]) == 32 and updated["example/(none)"] != "0" * 32
    assert run(capsys, "selftest", "example", "--golden", str(golden))[0] == 0


def test_selftest_writes_nothing_of_a_scene_that_fails(capsys, tmp_path: Path, monkeypatch):
    golden = tmp_path / "golden.json"
    golden.write_text(json.dumps({"example/(none)": "0" * 32}))
    monkeypatch.setattr(sys.modules["example_scene"].BouncingBall, "check", lambda self: 1 / 0)
    assert run(capsys, "selftest", "example", "--update-golden", str(golden))[0] == 1
    assert json.loads(golden.read_text()) == {"example/(none)": "0" * 32}


def test_selftest_misses_a_digest_that_is_not_kept_and_a_level_that_is_gone(capsys, tmp_path: Path):
    golden = tmp_path / "golden.json"
    _, out, _ = run(capsys, "selftest", "example")
    digest = out.split()[2]
    for kept, status, word in (
        ({"example/(none)": digest}, 0, digest),
        ({"example/(none)": digest, "other/default": "0"}, 0, digest),  # nobody asked for that scene
        ({"other/default": "0"}, 1, f"no digest is kept, it is {digest}"),
        ({"example/(none)": digest, "example/gone": "0"}, 1, "but there is no such level"),
    ):
        golden.write_text(json.dumps(kept))
        found, out, _ = run(capsys, "selftest", "example", "--golden", str(golden))
        assert (found, word in out) == (status, True)
        assert f", {status} failed" in out


def test_all_scenes_are_asked_for_every_kept_digest():
    from game.app.commands.selftest import Result, against_golden

    golden = {"a/one": "1", "b/two": "2"}
    (well, gone) = against_golden([Result("a", "one", "1", "")], golden, [])
    assert not well.trouble
    assert gone.name == "b/two" and gone.trouble
    (fault,) = against_golden([Result("a", "one", "", "it stopped")], {"a/one": "1"}, [])
    assert fault.trouble == "it stopped"


def test_selftest_finds_a_scene_that_forgets_part_of_its_state(capsys, monkeypatch):
    import example_scene

    def advance(self, dt):
        self.forgotten = getattr(self, "forgotten", [0])
        self.forgotten[0] += 1
        self.ball.position[0] += 1e-3 * (self.forgotten[0] % 7)

    monkeypatch.setattr(example_scene.BouncingBall, "advance", advance)
    monkeypatch.setattr("game.stage.session.remember", lambda scene: _Nothing())
    monkeypatch.setattr("game.stage.session.recall", lambda scene, memory: None)
    status, out, _ = run(capsys, "selftest", "example")
    assert status == 1
    assert "another state" in out


class _Nothing:
    bytes = 0


def test_selftest_reads_the_equations(capsys, monkeypatch):
    odd = (Equation("Odd", r"\aplha", ""),)
    monkeypatch.setattr(sys.modules["example_scene"].BouncingBall, "equations", odd, raising=False)
    status, out, _ = run(capsys, "selftest", "example")
    assert status == 1 and r"\aplha is not known; did you mean \alpha" in out


def test_selftest_checks_invariants(capsys, monkeypatch):
    import example_scene

    def check(self):
        raise AssertionError("the ball is where it should be")

    monkeypatch.setattr(example_scene.BouncingBall, "check", check)
    status, out, _ = run(capsys, "selftest", "example")
    assert status == 1
    assert "the ball is where it should be" in out


def test_selftest_in_plain_python(capsys):
    from game.app.commands import selftest

    good = selftest.Result("lecture-balls", "default", "0", "", 1e-6)
    slow = selftest.Result("lecture-balls", "hard-03-corner", "0", "", 10.0)
    bad = selftest.Result("lecture-balls", "no-such-level", "0", "", 1e-6)._replace(scene="nowhere")
    results = selftest._with_pure_steps([good, slow, bad], quiet=True)
    assert [result.pure_steps for result in results] == [12, 0, 12]
    assert results[0].trouble == results[1].trouble == ""
    assert "nowhere" in results[2].trouble


WRONG = [
    (("frobnicate",), "frobnicate"),
    (("run",), "SCENE"),
    (("run", "nowhere"), "nowhere"),
    (("run", "example", "--set", "gravity"), "gravity"),
    (("run", "example", "--set", "=3"), "=3"),
    (("run", "example", "--set", "mass=3"), "mass"),
    (("run", "example", "--set", "gravity=nan"), "gravity"),
    (("run", "example", "--set", "gravity=inf"), "gravity"),
    (("run", "example", "--set", "gravity=-1"), "gravity"),
    (("run", "example", "--set", "gravity=1e400"), "gravity"),
    (("run", "example", "--set", "gravity=heavy"), "heavy"),
    (("run", "example", "--set", "frozen=perhaps"), "perhaps"),
    (("run", "example", "--effects-off", "wind"), "wind"),
    (("run", "example", "--seconds", "-1"), "-1"),
    (("run", "example", "--seconds", "nan"), "nan"),
    (("run", "example", "--seconds", "inf"), "inf"),
    (("run", "example", "--seconds", "1e300"), "1e+300"),
    (("run", "example", "--seconds", "soon"), "soon"),
    (("run", "example", "--seed", "1.5"), "1.5"),
    (("run", "example", "--seed", "-1"), "-1"),
    (("run", "example", "--seed", "99999999999999999999"), "9999"),
    (("run", "example", "--size", "0x10"), "0x10"),
    (("run", "example", "--size", "99999x99999"), "99999"),
    (("run", "example", "--size", "big"), "big"),
    (("run", "example", "--theme", "pink"), "pink"),
    (("run", "example", "--level", "no/such/file.toml"), "no/such/file.toml"),
    (("run", "example", "--level", "/dev/null"), "/dev/null"),
    (("run", "example", "--level", "."), "."),
    (("run", "example", "--json", "no/such/folder/s.json"), "no/such/folder"),
    (("run", "example", "--json", "."), "--json"),
    (("run", "example", "--json", ""), "--json"),
    (("run", "example", "--json", "x" * 5000), "--json"),
    (("run", "example", "--screenshot", "no/such/folder/a.png"), "no/such/folder"),
    (("run", "example", "--record", "no/such/folder/r.json"), "no/such/folder"),
    (("run", "example", "--frames", "3"), "--frames"),
    (("play", "nowhere"), "nowhere"),
    (("play", "example", "--set", "gravity=-1"), "gravity"),
    (("play", "example", "--level", "missing.toml"), "missing.toml"),
    (("play", "example", "--replay", "missing.json"), "missing.json"),
    (("play", "example", "--replay", "r.json", "--set", "gravity=1"), "--set"),
    (("play", "example", "--replay", "r.json", "--seed", "0"), "--seed"),
    (("record", "example", "--out", "a.gif", "--replay", "r.json", "--level", "x"), "--level"),
    (("play", "example"), "no display"),
    (("list", "nowhere"), "nowhere"),
    (("replay", "missing.json"), "missing.json"),
    (("replay", str(ROOT / "pyproject.toml")), "pyproject.toml"),
    (("selftest", "nowhere"), "nowhere"),
    (("selftest", "--golden", "missing.json"), "missing.json"),
    (("match", "--json", ""), "--json"),
    (("record", "example", "--out", ""), "--out"),
    (("record", "example", "--out", "film.gif/"), "this is a folder"),
    (("record", "example", "--out", "film.gif/."), "this is a folder"),
    (("record", "example", "--fps", "3²"), "--fps"),
    (("record", "example", "--fps", "²"), "--fps"),
    (("record", "example", "--fps", "٣٠"), "--fps"),
    (("record", "example", "--fps", "9" * 5000), "--fps"),
    (("record", "example", "--size", "٦٤x64"), "--size"),
    (("record", "example", "--replay", ""), "is a directory"),
    (("run", "example", "--level", ""), "is a directory"),
    (("run", "example", "--screenshot", "a.png/"), "this is a folder"),
    (("selftest", "--golden", ""), "--golden"),
    (("accuracy",), "--all"),
    (("accuracy", "example"), "no study"),
    (("accuracy", "nowhere"), "nowhere"),
    (("accuracy", "example", "--out", "/dev/null/folder"), "--out"),
    (("shot", "missing.json"), "missing.json"),
    (("shot",), "FILE"),
]


@pytest.mark.parametrize(
    ("arguments", "word"), WRONG, ids=lambda value: " ".join(value)[:60] if isinstance(value, tuple) else ""
)
def test_a_mistake_is_one_line_and_status_2(capsys, tmp_path: Path, monkeypatch, arguments, word: str):
    monkeypatch.chdir(tmp_path)
    status, out, err = run(capsys, *arguments)
    assert status == 2
    assert out == ""
    assert err.startswith("carom: ")
    assert err.count("\n") == 1
    assert word in err
    assert [path.name for path in tmp_path.iterdir() if path.name != "report"] == []


EVIL = "a\x1b[31mred\x07\x9b2J\u202egnp.\u2066\r\nb"


def test_names_from_files_cannot_steer_the_terminal(capsys, tmp_path: Path, monkeypatch, level: Path):
    def harmless(text: str) -> bool:
        return all(letter.isprintable() for line in text.split("\n") for letter in line) and "\r" not in text

    from game.app.commands import listing

    listing.print_scene(
        {"name": EVIL, "task": EVIL, "title": EVIL, "parameters": [], "effects": [{"name": EVIL}],
         "levels": [{"name": EVIL}]}, in_full=False)  # fmt: skip
    said = capsys.readouterr()
    assert "[31mred" in said.out and said.out.count("\n") == 3 and harmless(said.out)
    for arguments in (("run", "example", "--level", EVIL), ("replay", EVIL), ("shot", EVIL), ("run", EVIL)):
        status, out, err = run(capsys, *arguments)
        assert (status, out) == (2, "")
        assert "red" in err and err.count("\n") == 1 and harmless(err)
    monkeypatch.setattr("game.app.commands.listing.execute", lambda options: Path(EVIL).read_text())
    status, _, err = run(capsys, "list")
    assert status == 1 and "red" in err and err.count("\n") == 1 and harmless(err)


def test_json_escapes_what_is_not_printable(capsys, tmp_path: Path):
    from game.app.commands import output

    values = {"title": EVIL + "\udc80 é 😀 \U000e0001"}
    output.write_json(values, "-")
    text = capsys.readouterr().out
    assert json.loads(text) == values
    assert "é 😀" in text and all(letter.isprintable() for letter in text.replace("\n", ""))
    output.write_json(values, str(tmp_path / "a.json"))
    assert (tmp_path / "a.json").read_text(encoding="utf-8") == text


BETWEEN = "--- the next command ---"


@pytest.mark.parametrize(
    "words",
    [
        {"LANG": "C", "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
        {"PYTHONIOENCODING": "ascii"},
        {"PYTHONIOENCODING": "latin-1"},
        {"PYTHONIOENCODING": "cp1252:strict"},
    ],
)
def test_a_terminal_that_is_not_unicode(words: dict[str, str]):
    """Four commands, one after another in a process whose encoding is settled when it starts."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    commands = (["list"], ["list", "c12"], ["list", "--json", "-"], ["run", "c12", "--seconds", "0"])
    code = f"""
import sys
from game.__main__ import main
for arguments in {commands}:
    assert main(arguments) == 0
    print("{BETWEEN}")
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, cwd=ROOT, env=environment | words
    )
    assert (done.returncode, done.stderr) == (0, b"")
    text = done.stdout.decode("latin-1" if "latin-1" in words.values() else "cp1252")
    *said, end = text.split(BETWEEN)
    assert len(said) == len(commands) and not end.strip()
    assert all("c12" in each for each in said)
    rows = {row["name"]: row for row in json.loads(said[2])["scenes"]}
    assert "\N{DEGREE SIGN}" in {
        parameter.get("unit") for row in rows.values() for parameter in row["parameters"]
    }


def test_plain_words_for_what_an_encoding_lacks():
    import io

    from game.app.window import words

    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    before, sys.stdout = sys.stdout, stream
    try:
        words.speak_what_is_understood()
        words.say("−3 × 20 °, é")
    finally:
        sys.stdout = before
    stream.flush()
    assert stream.buffer.getvalue() == b"-3 x 20  deg, ?" + os.linesep.encode()


def test_scene_that_cannot_be_imported_is_told_in_one_line(capsys):
    status, _, err = run(capsys, "run", "broken")
    assert status == 1
    assert err == "carom: broken cannot be opened: No module named 'no_such_module'\n"


@pytest.mark.parametrize(
    ("content", "word"),
    [
        ('scene = "example"\n[parameters]\nheight = nan', "parameters.height"),
        ('scene = "example"\n[parameters]\nheight = "tall"', "parameters.height"),
        ('scene = "example"\nweight = 3', "weight"),
        ('scene = "other"', "scene"),
        ("scene = ", "TOML"),
        ('scene = "example"\n[content]\nx = 1', "content"),
    ],
)
def test_broken_level_is_named_by_file_and_field(capsys, tmp_path: Path, content: str, word: str):
    file = tmp_path / "bad.toml"
    file.write_text(content)
    status, _, err = run(capsys, "run", "example", "--level", str(file))
    assert status == 2
    assert err.count("\n") == 1
    assert "bad.toml" in err and word in err


def test_no_display_plays_the_demo_and_names_its_picture(capsys, tmp_path: Path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    status, out, err = run(capsys)
    assert (status, err) == (0, "")
    assert out.count("\n") == 1
    assert out.startswith("carom: no display (")
    (picture,) = (tmp_path / "pictures").iterdir()
    assert str(picture) in out
    assert pygame.image.load(str(picture)).get_size() == (1280, 720)


def test_version_and_help(capsys):
    for word in ("--version", "--help"):
        with pytest.raises(SystemExit) as end:
            run_command_line([word])
        assert end.value.code == 0
        assert "carom" in capsys.readouterr().out


def test_closed_pipe_and_real_process_give_no_traceback(tmp_path: Path):
    environment = {**os.environ, "CAROM_HOME": str(tmp_path), "PYTHONUNBUFFERED": "1"}
    command = f"{sys.executable} -m game --help | head -1; {sys.executable} -m game run nowhere; echo $?"
    done = subprocess.run(
        ["bash", "-c", command], cwd=ROOT, env=environment, capture_output=True, text=True, timeout=900
    )
    assert "Traceback" not in done.stderr
    assert done.stderr.count("\n") == 1
    assert done.stdout.split()[-1] == "2"


def test_naming_commands_does_not_import_what_they_need():
    code = "import sys, game.app.commands as c; c.build_parser(); print('numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=900)
    assert done.stdout.split()[-1] == "False"
    assert done.stderr == ""


def test_window_and_menu_do_not_import_the_compiler():
    code = "import sys, game.app.start, game.app.application; print('numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, timeout=900)
    assert done.stdout.split()[-1] == "False"


def test_a_level_that_no_scene_has_is_answered_with_names():
    scene_type = SCENES["billiards"].load()
    for word, offered in (("ghost-9-ball", "ghost-09"), ("drill", "drill-01-stop"), ("zzz", "there are ")):
        with pytest.raises(MistakeError, match=f"no level of billiards is called {word}") as refused:
            read_level(scene_type, word)
        assert offered in str(refused.value) and "\n" not in str(refused.value)
