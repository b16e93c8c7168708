"""What the build hook makes of a file of machine code; `.ci/run` builds and installs the wheel itself."""

from __future__ import annotations

import importlib.util
import sys
from types import ModuleType
from typing import Any

import pytest

from game.compiler.prebuilt import file_name
from tests.paths import ROOT

HATCHLING = "hatchling.builders.hooks.plugin.interface"


@pytest.fixture
def hook(monkeypatch: pytest.MonkeyPatch) -> Any:
    """The hook's module, with as much of hatchling as it uses."""

    class Interface:
        target_name = "wheel"

    stub = ModuleType(HATCHLING)
    stub.BuildHookInterface = Interface  # type: ignore[attr-defined]
    for depth in range(1, 5):
        name = ".".join(HATCHLING.split(".")[:depth])
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    monkeypatch.setitem(sys.modules, HATCHLING, stub)
    spec = importlib.util.spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def build(hook: Any, version: str = "standard", target: str = "wheel") -> dict[str, Any]:
    data: dict[str, Any] = {"force_include": {}}
    made = hook.CustomBuildHook()
    made.target_name = target
    made.initialize(version, data)
    return data


@pytest.mark.parametrize(
    ("name", "tag"),
    [
        ("cpython-311-linux-x86_64.kernels", "cp311-none-manylinux_2_17_x86_64"),
        ("cpython-314-linux-aarch64.kernels", "cp314-none-manylinux_2_17_aarch64"),
        ("cpython-312-darwin-arm64.kernels", "cp312-none-macosx_11_0_arm64"),
        ("cpython-313-win32-amd64.kernels", "cp313-none-win_amd64"),
    ],
)
def test_the_wheel_is_for_what_the_file_is_for(hook, monkeypatch, name: str, tag: str):
    monkeypatch.setenv("CAROM_WHEEL_KERNELS", f"/somewhere/{name}")
    assert build(hook) == {
        "force_include": {f"/somewhere/{name}": f"game/data/kernels/{name}"},
        "tag": tag,
        "pure_python": False,
    }


def test_the_file_of_this_machine_has_a_tag(hook):
    assert hook.tag_of(file_name()).startswith(f"cp{sys.version_info[0]}{sys.version_info[1]}-none-")


@pytest.mark.parametrize("name", ["cpython-311-linux-x86_64", "pypy-311-linux-x86_64.kernels", "x.kernels"])
def test_other_files_are_refused(hook, monkeypatch, name: str):
    monkeypatch.setenv("CAROM_WHEEL_KERNELS", name)
    with pytest.raises(ValueError, match=name):
        build(hook)


@pytest.mark.parametrize(("version", "target"), [("editable", "wheel"), ("standard", "sdist")])
def test_only_wheels_carry_it(hook, monkeypatch, version: str, target: str):
    monkeypatch.setenv("CAROM_WHEEL_KERNELS", "cpython-311-linux-x86_64.kernels")
    assert build(hook, version, target) == {"force_include": {}}


def test_without_a_file_the_wheel_is_for_all(hook, monkeypatch):
    monkeypatch.delenv("CAROM_WHEEL_KERNELS", raising=False)
    assert build(hook) == {"force_include": {}}
