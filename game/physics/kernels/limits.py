"""What a method has no space for, said before memory or patience is gone."""

from __future__ import annotations


class LimitError(ValueError):
    """More is asked for than a declared limit allows; the message names the limit in one line."""
