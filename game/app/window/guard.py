"""Nothing that a scene, an overlay, a study or a card raises ends the program: here it is caught, and kept.

Such code is called within `Guard.over`. The caller says in a line what was raised. The traceback is written
into a file in the user's folder, once for each place that fails. KeyboardInterrupt and SystemExit are no
failures: they pass.
"""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from game.folders import user_folder

NAME = "failures.txt"
MOST_KEPT = 20  # tracebacks that one run of the program writes
MOST_BYTES = 1 << 18  # of the file, after which it begins again
LONGEST = 160  # characters of what an exception says


class Failure(NamedTuple):
    """What was raised, while what was being done; ``file`` has the traceback, None if it has it not."""

    what: str
    error: Exception
    file: Path | None

    @property
    def words(self) -> str:
        """The exception in a line: its type, and what it says."""
        said = " ".join(str(self.error).split())[:LONGEST]
        return f"{type(self.error).__name__}: {said}" if said else type(self.error).__name__

    @property
    def where(self) -> str:
        """Where the traceback is to be found, in words; empty if it is nowhere."""
        return f"Details in {_from_home(self.file)}." if self.file is not None else ""

    @property
    def message(self) -> str:
        """Both, for a message of one line."""
        return " ".join(part for part in (self.where, self.words) if part)


class Guard:
    """Catches what others raise, and keeps it.

    ``forgiving``: False lets everything pass, for tests and for the fuzzer, who want to see it.
    """

    def __init__(self, forgiving: bool = True) -> None:
        self.forgiving = forgiving
        self._files: dict[tuple[object, ...], Path | None] = {}  # by what failed, and where in the code

    @contextmanager
    def over(self, what: str, failed: Callable[[Failure], object]) -> Iterator[None]:
        """While this goes on an exception is kept and handed to ``failed``, and the program goes on."""
        try:
            yield
        except Exception as error:
            if not self.forgiving:
                raise
            failed(self.keep(what, error))

    def keep(self, what: str, error: Exception) -> Failure:
        """Write the traceback down, if that of the same place has not been written yet."""
        place = (what, type(error), *_innermost(error))
        if place not in self._files:
            known = len(self._files) >= MOST_KEPT
            self._files[place] = _file() if known else _write(what, error)
        return Failure(what, error, self._files[place])


def method_of(error: Exception, owner: object) -> str:
    """The method of an object that the exception came out of; empty if it came out of none."""
    trace = error.__traceback__
    while trace is not None:
        code, values = trace.tb_frame.f_code, trace.tb_frame.f_locals
        if code.co_argcount and values.get(code.co_varnames[0]) is owner:
            return code.co_name
        trace = trace.tb_next
    return ""


def _innermost(error: Exception) -> tuple[object, ...]:
    """File and line that raised."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return (trace.tb_frame.f_code.co_filename, trace.tb_lineno) if trace is not None else ()


def _file() -> Path:
    return user_folder() / NAME


def _write(what: str, error: Exception) -> Path | None:
    """Add a traceback to the file; on a full or locked disk it goes to standard error."""
    lines = "".join(traceback.format_exception(error))
    text = f"{datetime.now():%Y-%m-%d %H:%M:%S} {what}\n{lines}\n"
    path = _file()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        full = path.is_file() and path.stat().st_size > MOST_BYTES
        with path.open("w" if full else "a", encoding="utf-8", errors="backslashreplace") as file:
            file.write(text[-MOST_BYTES:])
    except OSError:
        _print(text)
        return None
    return path


def _print(text: str) -> None:
    """To standard error, where there is one."""
    try:
        sys.stderr.write(text.encode("ascii", "backslashreplace").decode("ascii"))
    except (OSError, ValueError, AttributeError):  # closed, lost, or none (a program without a console)
        return


def _from_home(path: Path) -> str:
    """The path, from the user's home if it lies there."""
    try:
        return str(Path("~") / path.relative_to(Path.home()))
    except (ValueError, RuntimeError):  # it lies elsewhere, or there is no home
        return str(path)
