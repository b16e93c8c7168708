"""``selftest``: each scene with each level steps, goes back, steps again, and must come to the same state.

Invariants are checked at the end. With ``--pure`` every level also makes a few steps with its kernels as
plain Python, in a process of its own: what a compiler may hide (an index out of range, a division by
nothing) shows there.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from game.app.commands import given, output
from game.app.compile.second_process import with_this_game
from game.app.stagehand.script import Script, demo_of
from game.app.window.children import start
from game.app.window.mistake import MistakeError
from game.app.window.words import say
from game.stage.opening.definition import check_strips

if TYPE_CHECKING:
    from game.stage import Scene, Stage

HALF_STEPS = 120  # of each run: that many, a restored state, that many again
STEPS_BACK = 3
GOLDEN_FILE = "scenes.json"
PURE_S = 3.0  # s of plain Python for a level
SLOWDOWN = 250.0  # of plain Python against compiled code, about
MOST_PURE_STEPS = 12


class Result(NamedTuple):
    """What came of one level: the digest at its end or what went wrong, s of a step, plain steps."""

    scene: str
    level: str
    digest: str
    trouble: str
    step_s: float = 0.0
    pure_steps: int = 0

    @property
    def name(self) -> str:
        """Key among the golden digests."""
        return f"{self.scene}/{self.level}"


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("selftest", help="test every scene and level", allow_abbrev=False)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="only these")
    parser.add_argument("--json", metavar="FILE", help="write the results; - is standard output")
    parser.add_argument("--golden", metavar="FILE", help="compare with the digests in this file: one each")
    parser.add_argument("--update-golden", metavar="FILE", nargs="?", const="", default=None,
                        help="write the digests, of the scenes named or of all (into this file, or that of "
                        "--golden, or tests/golden/scenes.json of a checkout)")  # fmt: skip
    parser.add_argument("--pure", action="store_true", help="also a few steps without the compiler")
    parser.add_argument("--plan", metavar="STEPS", help=argparse.SUPPRESS)
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Test and print a table; status 1 if anything failed."""
    output.check_writable(options.json, "--json")
    golden_file = _golden_file(options)
    golden = _read_golden(options.golden) if options.golden is not None else None
    updated = _read_golden(str(golden_file)) if golden_file is not None and golden_file.is_file() else {}
    if options.plan is not None:
        return _run_plan(json.loads(options.plan))
    quiet = options.json == output.STANDARD_OUTPUT
    results = []
    tested = check_scenes(options.scenes)
    compared = golden is not None and golden_file is None  # those that are written replace what is kept
    for result in against_golden(tested, golden or {}, options.scenes) if compared else tested:
        results.append(result)
        if not quiet:
            say(f"{result.scene:<16} {result.level:<28} {result.trouble or result.digest}", flush=True)
    if options.pure:
        results = _with_pure_steps(results, quiet)
    failed = [result for result in results if result.trouble]
    if options.json:
        output.write_json({"results": [r._asdict() for r in results], "failed": len(failed)}, options.json)
    if golden_file is not None and not failed:
        golden_file.parent.mkdir(parents=True, exist_ok=True)
        updated = with_results(updated, results, options.scenes)
        output.write_json(updated, str(golden_file), "--update-golden")
    if not quiet:
        print(f"{len(results)} levels, {len(failed)} failed")
    return 1 if failed else 0


def check_scenes(names: list[str]) -> Iterator[Result]:
    """Results of all levels of these scenes, or of all."""
    from game.levels import level_files
    from game.scenes import CATALOGUE

    types = [given.scene_type_named(name) for name in names] or [entry.load() for entry in CATALOGUE]
    for scene_type in types:
        yield from check_declared(scene_type)
        files = level_files(scene_type.name)
        if not any(file.stem == "default" for file in files):
            yield check_level(scene_type, None)
        for file in files:
            yield check_level(scene_type, file)


def check_declared(scene_type: type[Scene]) -> Iterator[Result]:
    """A result if something that a scene declares is wrong; none if all is well."""
    from game.app.stagehand.definition_check import check_definition

    try:
        check_definition(scene_type)
    except Exception as error:  # whatever a drawing raises is the answer; levels are tested all the same
        trouble = f"{type(error).__name__}: " + " ".join(str(error).split())
        yield Result(scene_type.name, "(definition)", "", trouble)


def against_golden(
    results: Iterable[Result], golden: Mapping[str, str], scenes: Collection[str]
) -> Iterator[Result]:
    """The results, with trouble where the kept digest is another or there is none. At the end comes one for
    each kept digest that no level came to, of these scenes or of all if none are named.
    """
    seen = set()
    for result in results:
        seen.add(result.name)
        kept = golden.get(result.name)
        if not result.trouble and kept != result.digest:
            words = f"the kept digest is {kept}" if kept else f"no digest is kept, it is {result.digest}"
            result = result._replace(trouble=words)
        yield result
    wanted = {name.lower() for name in scenes}
    for name in sorted(set(golden) - seen):
        scene, _, level = name.partition("/")
        if not wanted or scene in wanted:
            yield Result(scene, level, "", "a digest is kept, but there is no such level")


def with_results(
    kept: Mapping[str, str], results: Iterable[Result], scenes: Collection[str]
) -> dict[str, str]:
    """The digests to keep: of these scenes what they came to, in the place of what was kept of them.

    Without names all that was kept goes.
    """
    named = {name.lower() for name in scenes}
    new: dict[str, dict[str, str]] = {}
    for result in results:
        new.setdefault(result.scene, {})[result.name] = result.digest
    updated: dict[str, str] = {}
    for name, digest in kept.items():
        scene = name.partition("/")[0]
        if scene in named:
            updated.update(new.pop(scene, {}))
        elif named:
            updated[name] = digest
    for digests in new.values():
        updated.update(digests)
    return updated


def check_level(scene_type: type[Scene], file: Path | None) -> Result:
    """Run one level twice, the second time by way of steps back; compare the digests."""
    name = file.stem if file is not None else "(none)"
    try:
        first = _begin(scene_type, file)
        straight = _run(first, 2 * HALF_STEPS)
        other = _begin(scene_type, file)
        script = Script(other, demo_of(scene_type))
        script.run(HALF_STEPS)
        for _ in range(STEPS_BACK):
            other.step_back()
        other.resume()
        script.run(2 * HALF_STEPS - other.step_number)
        trouble = _compare(first, other, straight)
        if not trouble:
            other.scene.check()
            check_strips(other.scene)
    except Exception as error:  # whatever a scene raises is its result, and the next one is still tested
        return Result(scene_type.name, name, "", f"{type(error).__name__}: " + " ".join(str(error).split()))
    return Result(scene_type.name, name, straight, trouble, first.step_cost_s)


def _with_pure_steps(results: list[Result], quiet: bool) -> list[Result]:
    """The results, with the steps that each level has made in plain Python and what went wrong there."""
    plan = {}
    for result in results:
        steps = min(int(PURE_S / (SLOWDOWN * max(result.step_s, 1e-7))), MOST_PURE_STEPS)
        if steps > 0 and not result.trouble:
            plan[result.name] = steps
    environment = {**with_this_game(), "NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-m", "game", "selftest", "--plan", json.dumps(plan)]
    troubles: dict[str, str] = {}
    pipe = subprocess.PIPE
    with start(command, env=environment, stdout=pipe, text=True, encoding="utf-8") as process:
        assert process.stdout is not None
        for line in process.stdout:
            name, trouble = json.loads(line)
            troubles[name] = trouble
            if not quiet:
                say(f"{name:<45} {trouble or f'{plan[name]} steps in plain Python'}", flush=True)
    for name in plan:
        troubles.setdefault(name, "the process in plain Python ended")
    return [
        result._replace(
            trouble=result.trouble or troubles.get(result.name, ""), pure_steps=plan.get(result.name, 0)
        )
        for result in results
    ]


def _run_plan(plan: Mapping[str, int]) -> int:
    """Make so many steps of each level in this process, and say a line of each."""
    from game.levels import level_files

    for name, steps in plan.items():
        scene_name, _, level = name.partition("/")
        trouble = ""
        try:
            scene_type = given.scene_type_named(scene_name)
            file = next((file for file in level_files(scene_name) if file.stem == level), None)
            stage = _begin(scene_type, file)
            _run(stage, steps)
            trouble = stage.fault.message if stage.fault is not None else ""
            stage.scene.check()
        except Exception as error:
            trouble = f"{type(error).__name__}: " + " ".join(str(error).split())
        print(json.dumps([name, trouble]), flush=True)
    return 0


def _begin(scene_type: type[Scene], file: Path | None) -> Stage:
    from game.app.stagehand.opening import Opening

    return Opening(level=file).make_stage(scene_type)


def _run(stage: Stage, steps: int) -> str:
    Script(stage, demo_of(stage.scene_type)).run(steps)
    return stage.digest()


def _compare(first: Stage, other: Stage, straight: str) -> str:
    """What is wrong, empty if nothing is."""
    for stage in (first, other):
        if stage.fault is not None:
            return f"stopped at step {stage.fault.step}: {stage.fault.message}"
    if other.digest() != straight:
        return "after steps back it came to another state" + _left_out(first)
    return ""


def _left_out(stage: Stage) -> str:
    """Which fields state() leaves out, if that can be told."""
    from game.stage.checks.left_out import fields_left_out

    with suppress(Exception):  # the scene is at fault already; this only says more
        names = fields_left_out(stage.build_scene(stage.scene.values, stage.scene.active), stage.dt)
        if names:
            return f": state() leaves out {', '.join(names)}"
    return ""


def _golden_file(options: argparse.Namespace) -> Path | None:
    """Where digests are to be written, if they are."""
    if options.update_golden is None:
        return None
    file = options.update_golden or options.golden
    if file:
        output.check_writable(file, "--update-golden")
        return Path(file)
    folder = Path(__file__).resolve().parents[3] / "tests"
    if not folder.is_dir():
        raise MistakeError("--update-golden: there is no tests folder here; name a file")
    return folder / "golden" / GOLDEN_FILE


def _read_golden(word: str) -> dict[str, str]:
    """Kept digests by name."""
    import msgspec

    from game.files import FileProblem, read_text

    try:
        return msgspec.json.decode(read_text(Path(word), 1 << 20), type=dict[str, str])
    except (FileProblem, msgspec.MsgspecError) as error:
        raise MistakeError(f"--golden {word}: {error}") from None
