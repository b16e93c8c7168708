"""``replay``: a recording played again, as fast as it goes, and compared with what was recorded."""

from __future__ import annotations

import argparse
import time
from typing import Any

from game.app.commands import given, output, run
from game.app.window.mistake import MistakeError


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("replay", help="play a recording again and compare", allow_abbrev=False)
    parser.add_argument("file", metavar="FILE", help="recording (made by run --record, or Ctrl+S in a scene)")
    parser.add_argument("--json", metavar="FILE", help="write what was measured; - is standard output")
    parser.add_argument("--screenshot", metavar="FILE.png", help="write a picture of the end")
    parser.add_argument("--text", metavar="FILE", help="write the run as a text (see open); - is output")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="size of the picture (1280x720)")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Replay; a MistakeError names the first step whose digest differs."""
    size = given.read_size(options.size)
    for option in ("screenshot", "json", "text"):
        output.check_writable(getattr(options, option), f"--{option}")
    recording = given.read_recording(options.file)
    from game.scenes import CATALOGUE
    from game.stage import RecordingError, replay

    began = time.process_time()
    try:
        stage = replay(recording, CATALOGUE)
    except RecordingError as error:
        raise MistakeError(f"{options.file[:80]}: {error.field}: {error.reason}") from None
    report = run.describe(stage, time.process_time() - began) | {"same": True}
    if options.screenshot:
        run.write_screenshot(stage, options.screenshot, size, "dark")
    if options.json:
        output.write_json(report, options.json)
    if options.text:
        from game.stage.records.run_text import text_of

        output.write_text(text_of(recording) + "\n", options.text, "--text")
    if output.STANDARD_OUTPUT not in (options.json, options.text):
        run.print_report(report)
        print("  the same digests as recorded")
    return 0
