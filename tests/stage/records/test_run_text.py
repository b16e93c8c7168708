"""The text of a run: as short as it says, and the same session again; hostile texts get one clear line."""

from __future__ import annotations

import base64
import json
import tracemalloc
import zlib

import pytest

from game.levels import Level
from game.stage import Pointer, RecordingError, SetParameter, Stage, replay, replay_scene
from game.stage.records import run_text
from game.stage.records.excerpt import Excerpt
from game.stage.records.run_text import WORDS, looks_like_a_run, recording_in, text_of
from game.stage.replaying import recording_of_excerpt
from tests.stage.example_scene import KICK, BouncingBall
from tests.stage.odd_scenes import BURST, Cloud, CloudContent, Fragile
from tests.stage.records.test_recordings import CATALOGUE, played


def packed(document: object, words: bytes = WORDS) -> str:
    """A payload that holds a JSON document."""
    data = document if isinstance(document, bytes) else json.dumps(document).encode()
    packer = zlib.compressobj(9, zdict=words) if words else zlib.compressobj(9)
    return base64.urlsafe_b64encode(packer.compress(data) + packer.flush()).decode().rstrip("=")


def unpacked(text: str) -> dict:
    """What a payload holds."""
    payload = text.rpartition(".")[2]
    data = base64.urlsafe_b64decode(payload + "=" * (-len(payload) % 4))
    return json.loads(zlib.decompressobj(zdict=WORDS).decompress(data))


def with_payload(text: str, payload: str) -> str:
    return f"{text.rpartition('.')[0]}.{payload}"


class TestRoundTrip:
    def test_a_text_gives_back_the_session_to_its_digest(self) -> None:
        stage = played()
        text = text_of(stage.recording)
        again = recording_in(text)
        assert again.events == stage.recording.events
        assert (again.steps, again.dt, again.seed) == (stage.step_number, stage.dt, 0)
        assert replay(again, CATALOGUE).digest() == stage.digest()

    def test_it_reads_as_its_format_says(self) -> None:
        stage = played()
        text = text_of(stage.recording)
        head, scene, digest, payload = text.split(".")
        assert (head, scene, digest) == ("carom1", "example", stage.digest())
        assert set(payload) <= set("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_")
        document = unpacked(text)
        assert "checks" not in document and "digest" not in document and "scene" not in document
        assert document["version"] and document["steps"] == 275
        pointer = document["events"][2]["event"]
        assert pointer == {"type": "pointer", "kind": "down", "x": 0.1, "y": 0.2, "button": 1}
        assert len(text) < 0.6 * len(json.dumps(document))

    def test_the_words_of_format_1_stay(self) -> None:
        """Another dictionary cannot read what was written with this one."""
        assert zlib.adler32(WORDS) == ADLER_OF_WORDS

    def test_a_text_of_the_first_day_is_read(self) -> None:
        assert replay_scene(recording_in(OF_THE_FIRST_DAY), BouncingBall).step_number == 60

    def test_a_level_and_numbers_to_the_last_bit(self) -> None:
        content = CloudContent(points=[(1.0 / 3.0, -2.5e-17), (1e100 * 1e-99, 5.0)], speed=0.1)
        stage = Stage(Cloud, level=Level(scene="cloud", seed=12, content=content), seed=99)
        stage.run(5)
        stage.post(Pointer("move", 1.0 / 7.0, -0.0, 0, shift=True))
        recording = recording_in(text_of(stage.recording))
        assert recording.level == stage.recording.level and recording.seed == 99
        assert recording.events[0].event == Pointer("move", 1.0 / 7.0, 0.0, 0, shift=True)
        assert replay_scene(recording, Cloud).digest() == stage.digest()

    def test_values_that_are_zero_or_off_are_not_lost(self) -> None:
        stage = Stage(BouncingBall)
        stage.post(SetParameter("height", 0.5))
        stage.post(SetParameter("height", 1.0))
        events = recording_in(text_of(stage.recording)).events
        assert [stamped.event.value for stamped in events] == [0.5, 1.0]

    def test_mail_may_wrap_and_quote_it(self) -> None:
        text = text_of(played().recording)
        lines = "\n".join(f"> > {text[k : k + 40]}  " for k in range(0, len(text), 40))
        assert looks_like_a_run(lines) and recording_in(f"\n{lines}\n") == recording_in(text)

    def test_what_is_no_run_does_not_look_like_one(self) -> None:
        assert not looks_like_a_run("/tmp/carom.json") and not looks_like_a_run("")


class TestHostileTexts:
    def refused(self, text: str) -> str:
        with pytest.raises(RecordingError) as caught:
            recording_in(text)
        line = str(caught.value)
        assert line.startswith("text of a run: ") and "\n" not in line and len(line) <= 500
        return line

    @pytest.mark.parametrize("text", [
        "", "hello", "carom", "carom1", "carom1.", "carom1..", "\x00", "carom1.a.b.c",
        "carom1.example." + 32 * "0" + ".", "carom1.EXAMPLE." + 32 * "0" + ".AA",
    ])  # fmt: skip
    def test_no_run_at_all(self, text: str) -> None:
        assert "expected carom1.SCENE.DIGEST.PAYLOAD" in self.refused(text)

    def test_a_later_format(self) -> None:
        text = text_of(played().recording).replace("carom1", "carom2", 1)
        assert "format 2; this Carom reads format 1, a later one is needed" in self.refused(text)
        assert "format 0; this Carom reads format 1" in self.refused(text.replace("carom2", "carom0"))

    def test_a_letter_that_is_wrong_anywhere(self) -> None:
        text = text_of(played().recording)
        begin = text.rfind(".") + 1
        same = 0
        for place in range(begin, len(text) - 1):
            wrong = text[:place] + ("A" if text[place] != "A" else "B") + text[place + 1 :]
            try:
                assert recording_in(wrong) == recording_in(text)
                same += 1
            except RecordingError as error:
                assert "\n" not in str(error)
        assert same <= 1  # the bits that fill the last byte of what is packed say nothing

    def test_one_that_is_cut(self) -> None:
        text = text_of(played().recording)
        for length in range(len(text) - 8, len(text) - 1):
            assert "damaged" in self.refused(text[:length])

    def test_one_with_more_behind_its_end(self) -> None:
        text = text_of(played().recording)
        data = base64.urlsafe_b64decode(text.rpartition(".")[2] + "==") + b"more"
        more = base64.urlsafe_b64encode(data).decode().rstrip("=")
        assert "more behind its end" in self.refused(with_payload(text, more))

    def test_another_dictionary_or_none(self) -> None:
        text = text_of(played().recording)
        assert "cannot be unpacked" in self.refused(with_payload(text, packed(unpacked(text), b"other")))
        plain = with_payload(text, packed(unpacked(text), b""))
        assert recording_in(plain) == recording_in(text)  # a stream that never refers to it is one as well

    def test_a_bomb_is_not_unpacked(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(run_text, "MOST_BYTES", 1 << 20)
        bomb = with_payload(text_of(played().recording), packed(b" " * (64 << 20)))
        assert len(bomb) < 100_000
        tracemalloc.start()
        assert "unpacks to more than 1048576 bytes" in self.refused(bomb)
        assert tracemalloc.get_traced_memory()[1] < 8 << 20
        tracemalloc.stop()

    @pytest.mark.parametrize("filling", ["events", "values", "parameters", "lists", "text"])
    def test_what_unpacks_into_very_much_is_refused_before_it_costs_much(self, filling: str) -> None:
        """Each of them is a text of some 50 kB, and fills what may be unpacked to the last."""
        text = text_of(played().recording)
        document = unpacked(text)
        event, room = {"step": 0, "event": {"type": "action", "name": "kick"}}, run_text.MOST_BYTES - 2000
        document.update({
            "events": {"events": [event] * (room // 60)},
            "values": {"events": [{"step": 0, "event": {**event["event"], "values": [1.0] * (room // 5)}}]},
            "parameters": {"parameters": {str(i): 1.0 for i in range(room // 18)}},
            "lists": {"more": [[]] * (room // 4)}, "text": {"level": "x" * room},
        }[filling])  # fmt: skip
        bomb = with_payload(text, packed(document))
        tracemalloc.start()
        said = self.refused(bomb)
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert most < 16 * run_text.MOST_BYTES
        assert filling != "events" or f"length <= {run_text.MOST_EVENTS}" in said

    def test_no_text_is_made_that_is_not_read(self, monkeypatch: pytest.MonkeyPatch) -> None:
        recording = played().recording
        monkeypatch.setattr(run_text, "MOST_EVENTS", len(recording.events) - 1)
        with pytest.raises(RecordingError, match=r"events: \d+, and a text holds \d+"):
            text_of(recording)
        monkeypatch.setattr(run_text, "MOST_EVENTS", len(recording.events))
        assert text_of(recording)
        monkeypatch.undo()
        monkeypatch.setattr(run_text, "MOST_BYTES", 100)
        with pytest.raises(RecordingError, match="and a text holds 100"):
            text_of(recording)

    def test_one_that_is_too_long(self) -> None:
        assert "longer than" in self.refused("carom1." + "a" * run_text.MOST_LETTERS)

    def test_what_is_packed_is_no_recording(self) -> None:
        text = text_of(played().recording)
        document = unpacked(text)
        for wrong, reason in (
            (b"\xff\xfe", "not JSON"), (b"[" * 200_000, "Expected object, got array"),
            ([1], "Expected object, got array"), ({}, "Object missing required field"),
            ({**document, "more": 1}, "unknown field"),
            ({**document, "digest": "0" * 32}, "unknown field digest"),
            ({**document, "steps": 10}, "is out of order"), ({**document, "seed": -1}, "seed"),
            ({**document, "dt": 0.0}, "dt"),
            ({**document, "events": [{"step": 0, "event": {"type": "no"}}]}, "events"),
        ):  # fmt: skip
            assert reason in self.refused(with_payload(text, packed(wrong))), wrong

    def test_a_wrong_digest_is_found_by_the_replay(self) -> None:
        stage = played()
        text = text_of(stage.recording)
        forged = text.replace(stage.digest(), "0" * 32)
        with pytest.raises(RecordingError, match="ended otherwise"):
            replay(recording_in(forged), CATALOGUE)

    def test_a_scene_that_there_is_not(self) -> None:
        text = text_of(played().recording).replace(".example.", ".elsewhere.")
        with pytest.raises(RecordingError, match="elsewhere"):
            replay(recording_in(text), CATALOGUE)


class TestExcerpt:
    def test_a_part_of_a_session_by_itself(self) -> None:
        scene = Stage(BouncingBall).scene
        level = Level(scene="example", parameters={"height": 2.0})
        excerpt = Excerpt("kick", level, 3, scene.active.without("test-ground"), (KICK,), 40)
        recording = recording_of_excerpt(BouncingBall, excerpt)
        assert (recording.steps, recording.seed, len(recording.events)) == (40, 3, 1)
        assert recording.effects_off == ["test-ground"] and recording.parameters["height"] == 2.0
        assert replay_scene(recording, BouncingBall).step_number == 40

    def test_one_that_cannot_be_played_says_so(self) -> None:
        active = Stage(Fragile).scene.active
        excerpt = Excerpt("burst", Level(scene="fragile"), 0, active, (BURST,), 5)
        with pytest.raises(RecordingError, match="burst: "):
            recording_of_excerpt(Fragile, excerpt)


ADLER_OF_WORDS = 4123519777
OF_THE_FIRST_DAY = (
    "carom1.example.e111d1259a563dbd39a33c74e6574e33.ePn1x-shqyavLEdLpkWJZZklQNMt9SyArkWPZWDaARee0GonrSi_ClhoQ9I"
    "otqg1wuIz9OjKzkzOBkZWLLxaMTOoBQAQuT6O"
)
