"""Track files: what is read, and what is said of what is not."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from game.billiards.fitting.tracks import (
    MAX_SAMPLES,
    TableSize,
    TrackError,
    load_tracks,
    parse_tracks,
    write_tracks,
)


def ball(t: Any = (0, 0.02, 0.04), x: Any = (0.5, 0.51, 0.52), y: Any = (1.0, 1.0, 1.01)) -> dict[str, Any]:
    return {"t": list(t), "x": list(x), "y": list(y)}


def content(**balls: Any) -> dict[str, Any]:
    return {"shots": [{"id": "a", "balls": {"0": ball(), **{k[1:]: v for k, v in balls.items()}}}]}


def complaint(data: Any) -> str:
    text = data if isinstance(data, bytes) else json.dumps(data).encode()
    with pytest.raises(TrackError) as caught:
        parse_tracks(text)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_what_stands_in_a_file_is_read() -> None:
    data = content(_2=ball([0], [1.0], [2.0]))
    data["shots"].append({"id": 7, "balls": {"10": ball(), "2": ball(), "0": ball()}})
    file = parse_tracks(json.dumps({"what": "w", "note": "n", **data}).encode())
    assert file.table == TableSize(1.42, 2.84, 0.0615)
    assert [shot.id for shot in file.shots] == ["a", "7"]
    assert file.shots[0].names == ("0", "2")
    assert file.shots[1].names == ("0", "2", "10")  # by number, not by letter
    track = file.shots[0].tracks[0]
    assert track.times.tolist() == [0.0, 0.02, 0.04]
    assert track.places.tolist() == [[0.5, 1.0], [0.51, 1.0], [0.52, 1.01]]
    assert file.shots[0].end_time == 0.04


def test_two_samples_may_share_a_tick_of_the_clock() -> None:
    file = parse_tracks(json.dumps(content(_1=ball(t=(0, 0.02, 0.02)))).encode())
    assert file.shots[0].tracks[1].times.tolist() == [0.0, 0.02, 0.02]


def test_a_table_of_another_size() -> None:
    data = {"table": {"width": 1.0, "length": 2.0, "ball_diameter": 0.05}, **content()}
    assert parse_tracks(json.dumps(data).encode()).table == TableSize(1.0, 2.0, 0.05)


def test_what_is_written_is_read_again() -> None:
    file = parse_tracks(json.dumps(content(_1=ball())).encode())
    again = parse_tracks(write_tracks(file.table, file.shots, "what", "note").encode())
    assert again.table == file.table
    for before, after in zip(file.shots, again.shots, strict=True):
        assert before.id == after.id and before.names == after.names
        for a, b in zip(before.tracks, after.tracks, strict=True):
            np.testing.assert_array_equal(a.times, b.times)
            np.testing.assert_array_equal(a.places, b.places)


WRONG: list[tuple[Any, str]] = [
    (b"", "not JSON"),
    (b"[" * 5000, "expected object"),
    (b"[]", "expected object, got array"),
    ({}, "shots: is missing"),
    ({"shots": []}, "shots: expected array of length >= 1"),
    ({"shots": [{"id": 1}]}, "shots[0].balls: is missing"),
    ({"shots": [{"id": "", "balls": {"0": ball()}}]}, "shots[0].id: "),
    ({"shots": [{"id": 1, "balls": {}}]}, "shots[0].balls: "),
    ({"shots": [{"id": 1, "balls": {"1": ball()}}]}, 'shots[0].balls: "0" is missing'),
    (content(_16=ball()), "shots[0].balls: known are"),
    (content(_1={"t": [0], "x": [1]}), "shots[0].balls.1.y: is missing"),
    (content(_1={**ball(), "z": [1]}), "shots[0].balls.1.z: unknown field"),
    (content(_1=ball(t=[])), "shots[0].balls.1.t: "),
    (content(_1=ball(x=[0.5])), "shots[0].balls.1.x: 1 numbers for 3 times"),
    (content(_1=ball(y=[0.5] * 4)), "shots[0].balls.1.y: 4 numbers for 3 times"),
    (content(_1=ball(t=[0, 0.2, 0.1])), "shots[0].balls.1.t[2]: times must not fall, got 0.1 after 0.2"),
    (content(_1=ball(t=[-0.1, 0.1, 0.2])), "shots[0].balls.1.t[0]: must be 0 to 600 s"),
    (content(_1=ball(t=[0.1, 0.2, 601])), "shots[0].balls.1.t[2]: must be 0 to 600 s"),
    (content(_1=ball(x=[0.5, 0.5, 1.42])), "shots[0].balls.1.x[2]: the ball is off the table"),
    (content(_1=ball(y=[0.0, 0.5, 0.5])), "shots[0].balls.1.y[0]: the ball is off the table"),
    (content(_1=ball(x=[0.5, "a", 0.5])), "shots[0].balls.1.x[1]: expected float, got str"),
    (content(_1=ball(x=[0.5, True, 0.5])), "shots[0].balls.1.x[1]: expected float, got bool"),
    (content(_1=ball(x=[0.5, None, 0.5])), "shots[0].balls.1.x[1]: expected float, got null"),
    (content(_1=ball(*[[0.1] * (MAX_SAMPLES + 1)] * 3)), "shots[0].balls.1.t: expected array of length"),
    ({"shots": [{"id": 1, "balls": {"0": ball([0, 1], [1, 1], [1, 1])}}]}, "at least 3 samples"),
    ({**content(), "format": "shot"}, 'format: must be "tracks"'),
    ({**content(), "version": 2}, "version: only 1 is known"),
    ({**content(), "other": 2}, "other: unknown field"),
    ({**content(), "table": {"width": -1.0}}, "table.width: expected float >= 0.2"),
    ({**content(), "table": {"width": 0.3, "ball_diameter": 0.1}}, "table.ball_diameter: "),
    ({"shots": content()["shots"] * 2}, "shots[1].id: 'a' is there twice"),
    (json.dumps(content()).replace("0.52", "NaN").encode(), "not JSON"),
    (json.dumps(content()).replace("0.52", "Infinity").encode(), "not JSON"),
    (json.dumps(content()).replace("0.52", "1e999").encode(), "shots[0].balls.0.x[2]: number out of range"),
]


@pytest.mark.parametrize(("data", "words"), WRONG, ids=[words[:40] for _, words in WRONG])
def test_what_is_wrong_is_named_by_field_and_reason(data: Any, words: str) -> None:
    assert words in complaint(data)


def test_the_file_is_named(tmp_path: Path) -> None:
    path = tmp_path / "some tracks.json"
    with pytest.raises(TrackError, match=r"some tracks\.json: no such file"):
        load_tracks(path)
    path.write_text(json.dumps(content(_1=ball(t=[0, 2, 1]))))
    with pytest.raises(TrackError, match=r"some tracks.json: shots\[0\].balls.1.t\[2\]: "):
        load_tracks(path)
