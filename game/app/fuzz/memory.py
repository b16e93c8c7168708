"""How much memory the process holds."""

from __future__ import annotations

import sys
from pathlib import Path


def resident_bytes() -> int:
    """Bytes in memory now on Linux; elsewhere the most so far, or 0 where it is unknown."""
    try:
        import resource
    except ImportError:
        return 0
    try:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
        return pages * resource.getpagesize()
    except (OSError, ValueError, IndexError):
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        return most if sys.platform == "darwin" else 1024 * most
