"""How much memory the process holds, and has held."""

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


def peak_bytes() -> int:
    """The most bytes that the process has had in memory at once; 0 where the system does not say.

    Linux tells it of the program that runs now. What `getrusage` tells there counts its parent's before.
    """
    try:
        for line in Path("/proc/self/status").read_text(encoding="ascii", errors="replace").splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) << 10
        import resource
    except (ImportError, OSError, ValueError, IndexError):
        return resident_bytes()
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else 1024 * most
