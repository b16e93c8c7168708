"""The drawing kernels are compiled once, whoever asks for them, and however many at once."""

import threading

import pytest

import game.ui.raster
from game.app.compile.canvas_warming import CanvasWarming


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the kernels called; the real ones are left alone."""
    called: list[str] = []
    names = [f"kernel {i}" for i in range(5)]
    warm_ups = [(name, lambda name=name: called.append(name)) for name in names]
    monkeypatch.setattr(game.ui.raster, "WARM_UPS", warm_ups)
    return called


def test_many_threads_may_ask_at_once(calls: list[str]):
    warming = CanvasWarming()
    assert not warming.ready
    ends: list[bool] = []
    threads = [threading.Thread(target=lambda: ends.append(warming.wait(600.0))) for _ in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert ends == [True] * 16
    assert calls == [f"kernel {i}" for i in range(5)]
    assert (warming.done, warming.total, warming.error) == (5, 5, "")


def test_kernel_that_cannot_be_compiled_is_told(monkeypatch: pytest.MonkeyPatch):
    def fail() -> None:
        raise RuntimeError("no compiler")

    monkeypatch.setattr(game.ui.raster, "WARM_UPS", [("one", fail)])
    warming = CanvasWarming()
    assert warming.wait(600.0)
    assert warming.error == "no compiler"
