"""What all tests share: no screen, no sound, no files but temporary ones, kernels compiled once for all."""

from __future__ import annotations

import ctypes
import gc
import os
import sys
import tempfile
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any

import hypothesis
import pytest

from game.app.compile import precompile
from game.app.fuzz.memory import peak_bytes, resident_bytes
from game.trust import make_private_folder, reason_to_distrust  # it knows nothing of the variables below
from tests.shares import in_order, scheduler, share_of

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")
os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
os.environ.setdefault("MPLBACKEND", "Agg")

# Machine code is kept between sessions: its folders are named by the sources, so old code is never taken.
# In a checkout that belongs to another user (as in a container) nothing would be kept, so it lies elsewhere.
if not os.environ.get("CAROM_CACHE_DIR"):
    kept = Path(__file__).resolve().parents[1] / ".pytest_cache" / "carom"
    elsewhere = Path(tempfile.gettempdir()) / f"carom-tests-{os.geteuid() if hasattr(os, 'geteuid') else 0}"
    try:
        make_private_folder(kept)
        if reason_to_distrust(kept):
            make_private_folder(kept := elsewhere)
    except OSError:
        kept = Path(tempfile.mkdtemp(prefix="carom-tests-"))
    os.environ["CAROM_CACHE_DIR"] = str(kept)

# Set before anything of the game is imported, so that no test sees or writes the files of a person.
_home = tempfile.TemporaryDirectory(prefix="carom-home-")
os.environ["CAROM_HOME"] = _home.name

# Python looks through the young objects at every 700th new one, and the compiler's millions of old ones again
# and again: a twentieth of the time of tests that make many. Whoever wants it at once says gc.collect().
gc.set_threshold(20_000, 25, 25)
_WORKER = os.environ.get("PYTEST_XDIST_WORKER", "")  # "gw0", "gw1" and so on; none without pytest-xdist
_BACKWARDS = _WORKER[-1:] in tuple("13579")
_file: Path | None = None  # whose tests are run
_held = 0  # bytes in memory after the last search for garbage
_searched = 0  # and after the last one through all objects, however old
SHOULD_PEAK = 1_500_000_000  # bytes that a process should take at most
_peaks: dict[str, int] = {}  # bytes, by worker
GROWN, MUCH = 64 << 20, 1 << 30  # bytes: so much more, or so much at all, is looked through

# The same examples in every run, and none that fails because a machine is slow.
hypothesis.settings.register_profile(
    "carom",
    deadline=None,
    derandomize=True,
    database=None,
    suppress_health_check=[hypothesis.HealthCheck.too_slow],
)
hypothesis.settings.load_profile("carom")


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Generator[None, pytest.CollectReport, Any]:
    """Every other worker reads the files of tests from the last to the first.

    pytest rewrites the assertions of a file, which takes most of the time of collecting, and keeps what came
    of it. Of two workers that begin at both ends each finds the half of the other one.
    """
    report = yield
    if _BACKWARDS and isinstance(collector, pytest.Directory):
        report.result.reverse()
    return report


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """For workers share by share; without the compiler, without the few tests that take minutes each."""
    if _WORKER:
        places = in_order(item.nodeid for item in items)
        items.sort(key=lambda item: (places[share_of(item.nodeid)], item.path.parts))
    if os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0"):
        return
    for item in items:
        if item.get_closest_marker("compiled"):
            item.add_marker(pytest.mark.skip(reason="takes minutes without the compiler"))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Shares of tests that use the same kernels, where files would be handed out."""
    return scheduler(config, log) if config.getvalue("dist") == "loadfile" else None


@pytest.fixture(scope="session", autouse=True)
def one_process_compiles() -> Iterator[None]:
    """No second process compiles beside a scene that is opened, half of which is thrown away at its end.

    It halves the time that a person waits, and takes a core that another worker of the tests has.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(precompile, "start_quietly", lambda command: None)
        yield


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Before the first test of a file, take what is there out of the search for garbage: modules and kernels.

    A gc.collect() late in a session would take a second else, and a test that counts objects many of them.
    """
    global _file, _searched
    if item.path != _file:
        _file = item.path
        # Among what was taken out there may be what nobody needs any more.
        thorough = resident_bytes() > max(MUCH, _searched + GROWN)
        if thorough:
            gc.unfreeze()
        gc.collect()
        gc.freeze()
        give_back()
        if thorough:
            _searched = resident_bytes()


def give_back() -> None:
    """Hand freed memory back to the system, where its C library lets one ask for that.

    glibc keeps what is free below anything that lives: 100 MB after the pictures of one scene.
    """
    if _trim is not None:
        _trim(0)


_trim = getattr(ctypes.CDLL(None), "malloc_trim", None) if sys.platform.startswith("linux") else None


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """Let go of scenes that a test has left, where they are large: the search goes by numbers of objects.

    A scene is few objects that refer to each other, and may hold a hundred megabytes.
    """
    global _held
    done = yield
    if resident_bytes() > _held + GROWN:
        gc.collect()
        give_back()
        _held = resident_bytes()
    return done


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A worker of pytest-xdist tells how much memory it has taken at most."""
    told = getattr(session.config, "workeroutput", None)
    if told is not None:
        told["peak_bytes"] = peak_bytes()


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """The process that the workers report to hears of it."""
    _peaks[node.gateway.id] = getattr(node, "workeroutput", {}).get("peak_bytes", 0)


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """One line for each process that ran tests: its memory, and whether that is more than it should be."""
    for name, peak in sorted((_peaks or {"all tests": peak_bytes()}).items()):
        terminalreporter.write_line(peak_line(name, peak))


def peak_line(name: str, peak: int) -> str:
    """What is said of a process that has had so many bytes in memory. No failure: it depends on what ran."""
    more = f", more than the {SHOULD_PEAK / 1e9:.1f} GB of a worker" if peak > SHOULD_PEAK else ""
    return f"memory of {name}: {peak / 1e9:.2f} GB at most{more}"


def pytest_unconfigure() -> None:
    """Remove the temporary home."""
    _home.cleanup()
