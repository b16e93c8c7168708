"""When, on what and with which versions something was measured."""

from __future__ import annotations

import contextlib
import os
import platform
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

PACKAGES = ("numpy", "numba", "scipy", "shapely", "pymunk")


def about() -> dict[str, Any]:
    """``date``, ``machine``, and ``versions`` of Python and of the packages that are installed."""
    versions = {"Python": platform.python_version()}
    for name in PACKAGES:
        with contextlib.suppress(PackageNotFoundError):
            versions[name] = version(name)
    return {"date": date.today().isoformat(), "machine": _machine(), "versions": versions}


def about_words(values: dict[str, Any]) -> str:
    """The same in a sentence."""
    versions = ", ".join(f"{name} {number}" for name, number in values["versions"].items())
    return f"{values['date']}, {values['machine']}; {versions}."


def _machine() -> str:
    """Processor and system, as far as they say."""
    name = platform.processor() or platform.machine()
    with contextlib.suppress(OSError):
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        models = (line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
        name = next(models, name)
    return f"{name}, {os.cpu_count()} cores, {platform.system()}"
