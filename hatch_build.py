"""What a wheel carries besides the sources: machine code that ``python -m game precompile --wheel`` made.

The file's name says for which Python and platform it is, and so does the wheel's: such a wheel goes before
the plain one where it fits, and several of them lie beside each other.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

PLATFORMS = {"linux": "manylinux_2_17", "darwin": "macosx_11_0", "win32": "win"}


def tag_of(name: str) -> str:
    """The wheel's tag for a file such as cpython-311-linux-x86_64.kernels; ValueError for another name."""
    found = re.fullmatch(r"cpython-(\d+)-(linux|darwin|win32)-(\w+)\.kernels", name)
    if found is None:
        raise ValueError(f"{name}: no name of a file of machine code for a wheel")
    version, system, machine = found.groups()
    return f"cp{version}-none-{PLATFORMS[system]}_{machine}"


class CustomBuildHook(BuildHookInterface):
    """Puts the file that ``CAROM_WHEEL_KERNELS`` names into the package, and its tag on the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        file = os.environ.get("CAROM_WHEEL_KERNELS", "")
        if self.target_name != "wheel" or version == "editable" or not file:
            return
        name = Path(file).name
        build_data["tag"] = tag_of(name)
        build_data["pure_python"] = False
        build_data["force_include"][file] = f"game/data/kernels/{name}"
