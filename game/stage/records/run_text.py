"""A run as a short text that can be pasted anywhere: any scene's recording, packed, with its digest.

    carom1.SCENE.DIGEST.PAYLOAD

Format 1, all in ASCII. SCENE is the scene's name. DIGEST is that of the run's end, which a replay must come
to (`game.stage.states.state.digest_of`). PAYLOAD is base64url without padding (RFC 4648, section 5) of a zlib
stream (RFC 1950) with the preset dictionary WORDS. The stream holds the recording as JSON in UTF-8 (see
`recording.Recording`), without the fields that have their default. Scene and digest stand before it. Digests
on the way are left out. White space anywhere, and ``>`` at the beginning of lines, as mail adds them, is
passed over. WORDS belongs to the format: another dictionary would be format 2.
"""

from __future__ import annotations

import re
from typing import Annotated, Any

import msgspec

from game.packed_text import pack, unpack
from game.stage.events import Stamped
from game.stage.records.recording import Recording, RecordingError, decoded

NAME = "text of a run"  # in errors, in place of a file
FORMAT = 1
PREFIX = "carom"
MOST_LETTERS = 4 << 20  # of a text that is read
MOST_BYTES = 8 << 20  # of the JSON in it, however small it is packed
MOST_EVENTS = 60_000  # in a text: a quarter of an hour of a hand that never rests

# What many recordings say, the most frequent last (RFC 1950 lets a stream refer to it). Part of format 1.
WORDS = (
    b'"kind":"up","kind":"cancel","kind":"wheel","wheel":1.0,"wheel":-1.0,"shift":true,"control"'
    b':true,"effects_off":[],"version":"0.1.0","seed":0,"dt":0.008333333333333333,"steps":true,"'
    b'false,"none","person","novice","club","expert","master","auto","level","open","level":"sce'
    b'ne = \\"title = \\"about = \\"\\n\\n[parameters]\\n\\n[effects]\\noff = []\\n[content]\\ngame = '
    b'\\"eight-ball\\"\\nnine-ball\\"\\ncombination\\"\\npractice\\"\\ndrill\\"\\ncalling = \\"none\\"'
    b'\\nplayers = [\\n    \\"Ada\\",\\n    \\"Ben\\",\\n]\\nballs = [\\n    { number = 0, position = ['
    b"\\n        0.,\\n        1.,\\n        2.,\\n    ] },\\n    { number = 1, position = [\\n       "
    b' 1.2699999999999998,\\n\\n[content.saved]\\ngame = \\"turn = 0\\non_table = [\\n    1,\\n    2,\\'
    b"n    3,\\n    4,\\n    5,\\n    6,\\n    7,\\n    8,\\n    9,\\n    10,\\n    11,\\n    12,\\n   "
    b' 13,\\n    14,\\n    15,\\n]\\nin_hand = \\"behind the line\\"anywhere\\"\\"\\nopening = false\\n'
    b"options = []\\nfouls_in_row = [\\n    0,\\n    0,\\n]\\nwon = [\\n    0,\\n    0,\\n]\\nbreaker ="
    b' 0\\n"parameters":{"game":"first_player":"second_player":"race":"considered":false,"power":'
    b'4.0,"tip_left":0.0,"tip_up":0.0,"elevation":0.0,"guide":"events":30,"hand":"sliding":0.2,"'
    b'rolling":0.01,"ball_restitution":0.95,"cushion_restitution":0.85,"radius_spread":0.0,"mass'
    b'_spread":0.0},"events":[{"step":0,"event":{"type":"decision","name":"stroke","values":[{"t'
    b'ype":"action","name":"strike"}},{"type":"effect","name":"on":true}},{"type":"knob","name":'
    b'"power","value":4.0}},{"step":1,"event":{"type":"pointer","kind":"down","x":0.1,"y":0.1,"b'
    b'utton":1}},{"step":10,"event":{"type":"pointer","kind":"move","x":0.,"y":1.,"button":0}},'
)


class _Packed(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What a payload holds, of the fields of `Recording`: read at once as these types, so that whatever else
    is packed costs no memory."""

    version: str
    level: str | None = None
    seed: int
    dt: float
    parameters: Annotated[dict[str, float | bool | str], msgspec.Meta(max_length=1000)] = {}
    effects_off: list[str] = []
    events: Annotated[list[Stamped], msgspec.Meta(max_length=MOST_EVENTS)]
    steps: int


def text_of(recording: Recording) -> str:
    """The recording as a text of one line; RecordingError for a scene's name that a text cannot hold, and
    for more than any text may hold."""
    if len(recording.events) > MOST_EVENTS:
        raise RecordingError(NAME, "events", f"{len(recording.events)}, and a text holds {MOST_EVENTS}")
    if not re.fullmatch(r"[a-z0-9-]+", recording.scene):
        raise RecordingError(NAME, "scene", f"{recording.scene!r} is no name of a scene")
    document = msgspec.to_builtins(recording)
    for name in ("scene", "digest", "checks", "format"):
        del document[name]
    for name, default in _DEFAULTS.items():
        if document[name] == default:
            del document[name]
    document["events"] = [_brief(stamped) for stamped in document["events"]]
    data = msgspec.json.encode(document)
    if len(data) > MOST_BYTES:
        raise RecordingError(NAME, "", f"{len(data)} bytes of a session, and a text holds {MOST_BYTES}")
    payload = pack(data, WORDS)
    return f"{PREFIX}{FORMAT}.{recording.scene}.{recording.digest}.{payload}"


def looks_like_a_run(text: str) -> bool:
    """True for what begins as the text of a run of any format does."""
    return re.match(rf"[>\s]*{PREFIX}[0-9]", text[:1000]) is not None


def recording_in(text: str) -> Recording:
    """The recording that a text holds, its digest not yet compared with a replay.

    RecordingError, in one line, for what is no such text, too long, damaged, of a later format, or says what
    no recording may.
    """
    scene, digest, payload = _parts(text)
    document = msgspec.to_builtins(decoded(_unpacked(payload), _Packed, NAME))
    return Recording.read(msgspec.json.encode({**document, "scene": scene, "digest": digest}), NAME)


_DEFAULTS: dict[str, Any] = {"level": None, "effects_off": [], "parameters": {}}


def _brief(stamped: dict[str, Any]) -> dict[str, Any]:
    """An event without the fields that have their default."""
    event = {
        name: value for name, value in stamped["event"].items() if value not in (0, 0.0) or name in _SAID
    }
    return {"step": stamped["step"], "event": event}


_SAID = frozenset(("x", "y", "kind", "name", "value", "values", "on", "type"))  # fields without a default


def _parts(text: str) -> tuple[str, str, str]:
    """Scene, digest and payload."""
    if len(text) > MOST_LETTERS:
        raise RecordingError(NAME, "", f"longer than {MOST_LETTERS} letters")
    bare = re.sub(r"\s+", "", re.sub(r"(?m)^[>\s]+", "", text))
    found = re.match(rf"{PREFIX}([0-9]{{1,6}})\.", bare)
    if found is None:
        raise RecordingError(NAME, "", f"expected {PREFIX}{FORMAT}.SCENE.DIGEST.PAYLOAD")
    if int(found[1]) != FORMAT:
        later = int(found[1]) > FORMAT
        why = f"is of format {int(found[1])}; this Carom reads format {FORMAT}"
        raise RecordingError(NAME, "", f"{why}, a later one is needed" if later else why)
    parts = re.fullmatch(r"([a-z0-9-]{1,40})\.([0-9a-f]{8,64})\.([A-Za-z0-9_-]+)", bare[found.end() :])
    if parts is None:
        raise RecordingError(
            NAME, "", f"expected {PREFIX}{FORMAT}.SCENE.DIGEST.PAYLOAD; it is cut or damaged"
        )
    return parts[1], parts[2], parts[3]


def _unpacked(payload: str) -> bytes:
    """The bytes of a payload, MOST_BYTES of them at most."""
    try:
        return unpack(payload, MOST_BYTES, WORDS)
    except ValueError as error:
        raise RecordingError(NAME, "", str(error)) from None
