"""What all that stands in a level's [content] has in common."""

from __future__ import annotations

import msgspec


class LevelEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True, omit_defaults=True):
    """Strict: a field that it does not know is refused; what is as by default is not written."""
