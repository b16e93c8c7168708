"""``python -m game``: the menu, or a command (``python -m game --help``)."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; the exit status."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    try:
        from game.app.window.deadline import say_stopped
        from game.app.window.ending import ends_tidily, status_of
    except KeyboardInterrupt:  # an impatient hand, before anybody listens to signals
        print("carom: stopped", file=sys.stderr)
        return 130

    with ends_tidily(to_the_end=arguments is None):
        try:
            from game.app.commands import run_command_line
        except KeyboardInterrupt as why:  # and while modules are read
            say_stopped()
            return status_of(why)

        return run_command_line(sys.argv[1:] if arguments is None else arguments)


if __name__ == "__main__":
    sys.exit(main())
