"""practice.json: kept, read back, refused in one line, and nothing of it lost."""

import json

import pytest

from game import files
from game.stage.records import history
from game.stage.records.history import LaterFormatError, PracticeSet, history_path, keep_set, read_history

ONE = PracticeSet("ghost nine-ball 10", "9-ball ghost", "2026-11-22T10:00:00.000001", 3, 10, 10)
TWO = PracticeSet("drill 0123", "Stop", "2026-11-22T11:00:00", 1, 2, 0)


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    return tmp_path


def write(content) -> None:
    text = content if isinstance(content, str) else json.dumps(content)
    history_path().write_text(text)


def test_sets_are_kept_in_their_order_and_gone_on_with():
    assert read_history() == ()
    assert keep_set(ONE) == keep_set(TWO) == ""
    longer = PracticeSet(TWO.key, TWO.title, TWO.when, 2, 3, 0)
    assert keep_set(longer) == ""
    assert read_history() == (ONE, longer)
    assert json.loads(history_path().read_text())["format"] == 1
    assert ONE.share == 0.3


def one_set(**changed) -> dict:
    """A file of one set, in which something is not as it must be."""
    fields = {"key": "a", "title": "", "when": "2026-11-22T10:00:00", "made": 0, "tried": 1, "of": 0}
    return {"format": 1, "sets": [{**fields, **changed}]}


@pytest.mark.parametrize(
    ("content", "why"),
    [("", "empty"), ("not json", "malformed"), ([], "object"), ({"sets": []}, "format"),
     ({"format": 0}, "never was"), ({"format": 1, "more": 2}, "unknown field"), ("[" * 5000, "practice.json"),
     ({"format": 1, "sets": [{"key": "a"}]}, "title"), (one_set(when="soon"), "regex"),
     (one_set(made=2), "2 of 1"), (one_set(tried=3, of=2), "0 of 3 of 2"), (one_set(tried=0), "tried")],
)  # fmt: skip
def test_a_broken_file_is_one_line_and_put_aside(home, content, why):
    write(content)
    with pytest.raises(ValueError, match=why) as caught:
        read_history()
    line = str(caught.value)
    assert line.startswith("practice.json: ") and "\n" not in line and len(line) <= 400
    broken = history_path().read_text()
    complaint = keep_set(ONE)
    assert complaint.startswith("practice.json: ") and complaint.endswith(
        "; the file is kept as practice.broken.json"
    )
    assert (home / "practice.broken.json").read_text() == broken and read_history() == (ONE,)


def test_a_second_broken_file_does_not_replace_the_first(home):
    for number, name in enumerate(("practice.broken.json", "practice.broken2.json")):
        write(f"broken {number}")
        assert name in keep_set(ONE)
    assert (home / "practice.broken.json").read_text() == "broken 0"
    assert (home / "practice.broken2.json").read_text() == "broken 1"


def test_where_no_name_is_left_the_last_broken_file_is_replaced(home):
    names = [f"practice.broken{number}.json" for number in ("", *range(2, files.MOST_BROKEN + 1))]
    for name in names:
        (home / name).write_text(f"earlier {name}")
    write("broken at last")
    assert names[-1] in keep_set(ONE)
    assert (home / names[-1]).read_text() == "broken at last"
    assert all((home / name).read_text() == f"earlier {name}" for name in names[:-1])


def test_a_file_of_a_later_version_is_left_as_it_is(home):
    later = json.dumps({"format": 2, "sessions": [1, 2, 3]})
    write(later)
    with pytest.raises(LaterFormatError, match="is of format 2; this Carom reads format 1"):
        read_history()
    assert keep_set(ONE).endswith("; nothing is written over it")
    assert history_path().read_text() == later and sorted(p.name for p in home.iterdir()) == ["practice.json"]


def test_a_folder_that_cannot_be_written_is_told(home, monkeypatch):
    history_path().mkdir()
    assert keep_set(ONE).startswith("practice.json: ")


def test_of_very_many_the_oldest_go(monkeypatch):
    monkeypatch.setattr(history, "MOST_SETS", 3)
    for k in range(5):
        keep_set(PracticeSet("a", "", f"2026-11-22T10:00:0{k}", 0, 1, 0))
    assert [one.when[-1] for one in read_history()] == ["2", "3", "4"]
