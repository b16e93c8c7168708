"""Bytes as a short text of letters, digits, ``-`` and ``_``: zlib (RFC 1950), then base64url without padding
(RFC 4648, section 5). What it unpacks to is bounded, however small it was packed.
"""

from __future__ import annotations

import base64
import zlib

LEVEL = 9  # of zlib, which packs a minute of play in some 20 ms


def pack(data: bytes, words: bytes = b"") -> str:
    """The text. words: a preset dictionary, the most frequent last, which the reader must have as well."""
    packer = zlib.compressobj(LEVEL, zdict=words) if words else zlib.compressobj(LEVEL)
    return base64.urlsafe_b64encode(packer.compress(data) + packer.flush()).decode("ascii").rstrip("=")


def unpack(text: str, most: int, words: bytes = b"") -> bytes:
    """The bytes, at most so many. ValueError, whose message is the bare reason, for what is no such text."""
    try:
        packed = base64.b64decode(text + "=" * (-len(text) % 4), altchars=b"-_", validate=True)
        unpacker = zlib.decompressobj(zdict=words) if words else zlib.decompressobj()
        data = unpacker.decompress(packed, most + 1)
    except (ValueError, zlib.error):
        raise ValueError("damaged: the packed part cannot be unpacked") from None
    if len(data) > most:
        raise ValueError(f"unpacks to more than {most} bytes")
    if not unpacker.eof:
        raise ValueError("damaged: its end is missing")
    if unpacker.unused_data:
        raise ValueError("damaged: there is more behind its end")
    return data
