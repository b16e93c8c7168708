"""A stroke as a short text that another table plays on with.

    stroke1.SCENE.CHECK.PAYLOAD

Format 1, all in ASCII. SCENE is the scene's name. CHECK is the first eight hexadecimal digits of BLAKE2b
(RFC 7693) over SCENE, a point and PAYLOAD. PAYLOAD is base64url without padding of a zlib stream. That holds
JSON: ``before`` and ``after``, the words of the frames between which the stroke lies, and ``steps``, the
decisions that lead there, each a name and numbers. White space, and ``>`` as mail adds it, is passed over.
"""

from __future__ import annotations

import hashlib
import re
from typing import Annotated

import msgspec

from game.packed_text import pack, unpack

PREFIX, FORMAT = "stroke", 1
MOST_LETTERS, MOST_BYTES = 8_000, 16_000
Name = Annotated[str, msgspec.Meta(max_length=20)]
Numbers = Annotated[tuple[float, ...], msgspec.Meta(max_length=12)]
Word = Annotated[str, msgspec.Meta(pattern="^[0-9a-f]{16}$")]


class StrokeText(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """before, after: words of the frames. steps: decisions, each a name and its numbers; the last strikes."""

    before: Word
    after: Word
    steps: Annotated[tuple[tuple[Name, Numbers], ...], msgspec.Meta(min_length=1, max_length=4)]


def looks_like_a_stroke(text: str) -> bool:
    """True for what begins as the text of a stroke of any format does."""
    return re.match(rf"[>\s]*{PREFIX}[0-9]", text[:200]) is not None


def packed_stroke(scene: str, stroke: StrokeText) -> str:
    """The text of a stroke, in one line."""
    payload = pack(msgspec.json.encode(stroke))
    return f"{PREFIX}{FORMAT}.{scene}.{_check(scene, payload)}.{payload}"


def read_stroke(text: str, scene: str) -> StrokeText:
    """The stroke in a text for a table of that scene. ValueError in one line, "field: reason", for others."""
    if len(text) > MOST_LETTERS:
        raise ValueError(f"text: longer than {MOST_LETTERS} letters")
    bare = re.sub(r"\s+", "", re.sub(r"(?m)^[>\s]+", "", text))
    found = re.match(rf"{PREFIX}([0-9]{{1,6}})\.", bare)
    if found is None:
        raise ValueError(f"text: expected {PREFIX}{FORMAT}.SCENE.CHECK.PAYLOAD")
    if int(found[1]) != FORMAT:
        raise ValueError(f"format: {int(found[1])}, and this Carom reads {FORMAT}")
    parts = re.fullmatch(r"([a-z0-9-]{1,40})\.([0-9a-f]{8})\.([A-Za-z0-9_-]+)", bare[found.end() :])
    if parts is None:
        raise ValueError("text: it is cut or damaged")
    name, check, payload = parts.groups()
    if check != _check(name, payload):
        raise ValueError("check: a letter of the text is wrong, or missing")
    if name != scene:
        raise ValueError(f"scene: the stroke is of {name}, and this table is {scene}")
    try:
        return msgspec.json.decode(unpack(payload, MOST_BYTES), type=StrokeText)
    except msgspec.ValidationError as error:
        where = re.search(r"`\$\.([a-z]+)", str(error))
        raise ValueError(f"{where[1] if where else 'payload'}: {str(error).split(' - ')[0]}") from None
    except msgspec.DecodeError as error:
        raise ValueError(f"payload: {error}") from None


def _check(scene: str, payload: str) -> str:
    """A short sum over what could be mistyped."""
    return hashlib.blake2b(f"{scene}.{payload}".encode(), digest_size=4).hexdigest()
