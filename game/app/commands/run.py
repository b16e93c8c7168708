"""``run``: a scene without a window, as fast as it goes.

Its own players play; simulated time stands still while they think.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from game.app.commands import given, output
from game.app.window.mistake import MistakeError
from game.app.window.words import say

if TYPE_CHECKING:
    from game.stage import Stage

SMALLEST_WINDOW = (320, 240)  # px


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("run", help="run a scene without a window", allow_abbrev=False)
    given.add_scene_options(parser)
    parser.add_argument("--story", nargs="?", const="", metavar="NAME",
                        help="play a story of the scene to its end, and check what it expects")  # fmt: skip
    parser.add_argument(
        "--quality", metavar="NAME", help="of a story: play, teach, film (if its scene has it)"
    )
    parser.add_argument("--seconds", default="10", metavar="S", help="simulated time (10)")
    parser.add_argument("--screenshot", metavar="FILE.png", help="write a picture of the end")
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="size of the picture (1280x720)")
    parser.add_argument("--window", action="store_true",
                        help="the picture shows the whole window: panel, strips and bar as well")  # fmt: skip
    parser.add_argument("--theme", default="dark", metavar="NAME", help="dark or light")
    parser.add_argument("--json", metavar="FILE", help="write what was measured; - is standard output")
    parser.add_argument("--record", metavar="FILE.json", help="write a recording for replay")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Run and write; status 1 if the scene had to be stopped."""
    seconds, size = given.read_seconds(options.seconds), given.read_size(options.size)
    if options.theme not in ("dark", "light"):
        raise MistakeError(f"--theme {options.theme}: expected dark or light")
    for option in ("screenshot", "json", "record"):
        output.check_writable(getattr(options, option), f"--{option}")
    _check_window(options, size)
    if options.story is not None:
        return _run_story(options, size)
    if options.quality is not None:
        raise MistakeError("--quality: goes only with --story")
    stage = given.make_stage(options)
    steps = given.steps_in(seconds, stage.dt)
    for _, compile_kernel in stage.scene_type.warm_ups():
        compile_kernel()  # so that the time measured is that of the steps alone
    began = time.process_time()
    stage.run(steps, players=True)
    cpu_s = time.process_time() - began
    report = describe(stage, cpu_s)
    if options.screenshot:
        write_screenshot(stage, options.screenshot, size, options.theme, options.window)
    if options.record:
        write_recording(stage, options.record)
    if options.json:
        output.write_json(report, options.json)
    if options.json != output.STANDARD_OUTPUT:
        print_report(report)
    return 1 if stage.fault is not None else 0


def _run_story(options: argparse.Namespace, size: tuple[int, int]) -> int:
    """Play a story to its end; status 2 and a line if something is not as it says."""
    import msgspec

    from game.app.commands import stories
    from game.app.stagehand.stories import keep
    from game.levels import LevelError
    from game.stage.story.rehearsal import rehearse, stage_of
    from game.stage.story.runner import StoryError

    given.refuse_beside_story(options)
    scene_type = given.scene_type_named(options.scene)
    story = stories.at_quality(stories.named(scene_type, options.story), scene_type, options.quality)
    began = time.process_time()
    try:
        stage = stage_of(story, scene_type)
        found = rehearse(story, scene_type, stage=stage)
    except (LevelError, StoryError, ValueError) as error:
        raise MistakeError(f"{story.name}: {error}") from None
    report = describe(stage, time.process_time() - began)
    report["story"] = {**msgspec.to_builtins(found), "failures": found.failures}
    if found.ended:
        keep(story, found)
    if options.screenshot:
        write_screenshot(stage, options.screenshot, size, options.theme, options.window)
    if options.record:
        write_recording(stage, options.record)
    if options.json:
        output.write_json(report, options.json)
    if options.json != output.STANDARD_OUTPUT:
        print_report(report)
        for one in found.moments:
            say(f"  {one.film_s:7.2f} s  {one.chapter}")
    if stage.fault is not None:
        return 1
    if found.failures:
        raise MistakeError("; ".join(found.failures))
    return 0


def describe(stage: Stage, cpu_s: float) -> dict[str, Any]:
    """What a run comes to, for JSON."""
    scene = stage.scene
    report: dict[str, Any] = {
        "scene": scene.name,
        "title": scene.title,
        "level": scene.level.title if scene.level is not None else None,
        "steps": stage.step_number,
        "dt": stage.dt,
        "simulated_s": stage.time_s,
        "cpu_s": cpu_s,
        "step_cost_s": stage.step_cost_s,
        "digest": stage.digest(),
        "parameters": dict(scene.values),
        "effects": {effect.name: effect in scene.active for effect in scene.effects},
        "readouts": {r.name: {"value": float(r.value), "unit": r.unit} for r in stage.readouts()},
    }
    if stage.fault is not None:
        report["fault"] = {
            "quantity": stage.fault.quantity,
            "step": stage.fault.step,
            "message": stage.fault.message,
        }
    return report


def print_report(report: dict[str, Any]) -> None:
    """The same for people."""
    ratio = report["simulated_s"] / report["cpu_s"] if report["cpu_s"] > 0.0 else 0.0
    print(f"{report['scene']}: {report['steps']} steps, {report['simulated_s']:.6g} s simulated in "
          f"{report['cpu_s']:.3g} s of CPU time, {ratio:.3g} times real time")  # fmt: skip
    for name, readout in report["readouts"].items():
        print(f"  {name:<24} {readout['value']:.6g} {readout['unit']}".rstrip())
    print(f"  digest {report['digest']}")
    if "fault" in report:
        say(f"  stopped at step {report['fault']['step']}: {report['fault']['message']}")


def _check_window(options: argparse.Namespace, size: tuple[int, int]) -> None:
    """``--window`` belongs to a picture that a window can have."""
    if options.window and not options.screenshot:
        raise MistakeError("--window: says what the picture shows; name its file with --screenshot FILE.png")
    if options.window and (size[0] < SMALLEST_WINDOW[0] or size[1] < SMALLEST_WINDOW[1]):
        raise MistakeError("--size: a window is at least {}x{} pixels".format(*SMALLEST_WINDOW))


def write_screenshot(
    stage: Stage, word: str, size: tuple[int, int], theme: str, whole_window: bool = False
) -> None:
    """Draw the stage, or the whole window round it, into a PNG file."""
    from game.app.window.pictures import write_png

    if whole_window:
        from game.app.commands.window_picture import picture_of_window
        from game.scenes import CATALOGUE

        picture = picture_of_window(stage, CATALOGUE, size, theme)
    else:
        from game.app.stagehand.headless import picture_of_stage

        picture = picture_of_stage(stage, size, theme)
    try:
        write_png(picture, Path(word))
    except OSError as error:
        raise MistakeError(f"--screenshot {error}") from None


def write_recording(stage: Stage, word: str) -> None:
    """Save what was done to the stage."""
    from game.stage import RecordingError

    try:
        stage.recording.save(word)
    except RecordingError as error:
        raise MistakeError(f"--record {error}") from None
