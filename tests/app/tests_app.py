"""A program without a screen and without real time: posted events, a clock that the test sets."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

from game.app.fuzz import driver
from game.app.scene.screen import SceneScreen
from game.stage.catalogue import Catalogue, Entry
from tests.paths import TESTS

EXAMPLE = TESTS / "stage" / "example_scene.py"


def load_example() -> None:
    """Make the example scene importable under one name, however the tests are started."""
    if "example_scene" not in sys.modules:
        spec = importlib.util.spec_from_file_location("example_scene", EXAMPLE)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules["example_scene"] = module
        spec.loader.exec_module(module)


def example_entry(name: str = "example") -> Entry:
    """A catalogue row of the example scene, or of the same under another name."""
    load_example()
    module, class_name = sys.modules["example_scene"], "BouncingBall"
    if name != "example":
        class_name = f"BouncingBall_{name}"
        setattr(
            module,
            class_name,
            type(class_name, (module.BouncingBall,), {"name": name, "__doc__": "Another."}),
        )
    return Entry(
        name, "X00", "Bouncing ball", "one ball", "Examples", module.__name__, class_name, "gravity ground"
    )


CATALOGUE = Catalogue(
    (
        example_entry(),
        Entry("broken", "X01", "Broken scene", "cannot be opened", "Examples", "no_such_module", "Nothing"),
    )
)


class Driver(driver.Driver):
    """The driver with the catalogue of the tests."""

    def __init__(
        self,
        folder: Path,
        size: tuple[int, int] = (1280, 720),
        catalogue: Catalogue = CATALOGUE,
        **settings: Any,
    ):
        super().__init__(folder, size, catalogue, **settings)

    def open(self, name: str = "example") -> SceneScreen:
        return super().open(name)
