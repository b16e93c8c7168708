"""``open``: a run or a stroke that somebody has pasted as a text, in the window or checked without one."""

from __future__ import annotations

import argparse
import sys
import time
from typing import TYPE_CHECKING, Any

from game.app.commands import given, output, play, run
from game.app.window.mistake import MistakeError

if TYPE_CHECKING:
    from game.stage import Recording


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("open", help="open a run from its text", allow_abbrev=False)
    parser.add_argument("text", metavar="TEXT", help="text of a run (Ctrl+Shift+C in a scene, or replay "
                        "--text), a recording's file, or - for standard input")  # fmt: skip
    parser.add_argument(
        "--json", metavar="FILE", help="no window: replay, compare the digest, write a report; - is output"
    )
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Watch it in the window; with ``--json`` replay it and compare its digest."""
    output.check_writable(options.json, "--json")
    recording = _given(options.text)
    scene_type = given.scene_type_named(recording.scene)
    if options.json is None:
        from game.app.stagehand.opening import Opening

        play.open_window(
            scene_type.name, Opening(recording=recording), "open --json checks it without a window"
        )
        return 0
    from game.stage import RecordingError, replay_scene

    began = time.process_time()
    try:
        stage = replay_scene(recording, scene_type)
    except RecordingError as error:
        raise MistakeError(f"text of a run: {error.field}: {error.reason}") from None
    report = run.describe(stage, time.process_time() - began) | {
        "same": True,
        "written_by": recording.version,
    }
    output.write_json(report, options.json)
    return 0


def _given(word: str) -> Recording:
    """The recording that is meant; MistakeError, in one line, if there is none."""
    from game.stage import RecordingError
    from game.stage.records.run_text import MOST_LETTERS, recording_in

    if word != output.STANDARD_OUTPUT:  # the same sign stands for standard input
        return given.read_recording(word)
    try:
        return recording_in(sys.stdin.read(MOST_LETTERS + 1))
    except RecordingError as error:
        raise MistakeError(str(error)) from None
    except UnicodeDecodeError:
        raise MistakeError("text of a run: not UTF-8 text") from None
