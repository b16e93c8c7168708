"""``record``: a film of a scene, MP4 or GIF; of its demo, of its own players, or of a recording."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from game.app.commands import given
from game.app.window.mistake import MistakeError
from game.app.window.words import say

if TYPE_CHECKING:
    from game.stage import Scene

USUAL_S = 20.0


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("record", help="film a scene, as MP4 or GIF", allow_abbrev=False)
    given.add_scene_options(parser)
    parser.add_argument("--out", metavar="FILE", help="film to write, .mp4 or .gif (SCENE.mp4)")
    parser.add_argument(
        "--seconds",
        metavar="S",
        help=f"length ({USUAL_S:g}, or that of the recording)",
    )
    parser.add_argument("--size", default="1280x720", metavar="WxH", help="size of the film (1280x720)")
    parser.add_argument("--fps", default="30", metavar="N", help="pictures a second (30)")
    parser.add_argument("--theme", default="dark", metavar="NAME", help="dark or light")
    parser.add_argument("--replay", metavar="FILE.json", help="film a recording instead of the demo")
    parser.add_argument("--story", nargs="?", const="", metavar="NAME",
                        help="film a story, with captions, camera, sound, chapters, poster")  # fmt: skip
    parser.add_argument(
        "--quality", metavar="NAME", help="of a story: play, teach, film (if its scene has it)"
    )
    parser.add_argument("--from", default="0", metavar="S", dest="begin", help="begin there in the story (0)")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Film it and say where; status 1 if the scene had to be stopped."""
    seconds = given.read_seconds(options.seconds) if options.seconds is not None else USUAL_S
    if options.theme not in ("dark", "light"):
        raise MistakeError(f"--theme {options.theme}: expected dark or light")
    scene_type = given.scene_type_named(options.scene)
    recording = given.read_replay(options, scene_type.name)
    out = options.out if options.out is not None else f"{scene_type.name}.mp4"
    film = given.read_film(out, options.size, options.fps, "--out")
    if options.story is not None:
        return _film_story(options, scene_type, film)
    if options.begin != "0" or options.quality is not None:
        raise MistakeError("--from, --quality: go only with --story")
    from game.app.film.scene_film import write_scene_film
    from game.app.film.video import VideoError
    from game.app.stagehand.script import demo_of
    from game.stage import RecordingError, begin

    if recording is not None:
        try:
            stage, events = begin(recording, scene_type), recording.events
        except RecordingError as error:
            raise MistakeError(str(error)) from None
        if options.seconds is None:
            seconds = recording.steps * recording.dt
    else:
        stage = given.make_stage(options)
        events = [] if stage.scene.plays_alone else list(demo_of(scene_type))
    given.steps_in(seconds, stage.dt)
    try:
        count = write_scene_film(
            stage, events, Path(film.path), film.size, film.fps, seconds, options.theme, recording is None
        )
    except VideoError as error:
        raise MistakeError(str(error), status=1) from None
    say(f"{film.path}: {count / film.fps:.1f} s, {count} pictures")
    return 1 if stage.fault is not None else 0


def _film_story(options: argparse.Namespace, scene_type: type[Scene], film: given.Film) -> int:
    """Film a story and say where."""
    from game.app.commands import stories
    from game.app.film.story_film import Excerpt, StoryFilm, write_story_film
    from game.app.film.video import VideoError
    from game.app.stagehand.stories import rehearsal_of
    from game.app.window.settings import load_settings
    from game.folders import user_folder
    from game.levels import LevelError
    from game.stage.story.runner import StoryError

    if options.replay is not None:
        raise MistakeError("--replay: goes not with --story")
    given.refuse_beside_story(options)
    begin_s = given.read_seconds(options.begin, "--from")
    seconds = given.read_seconds(options.seconds) if options.seconds is not None else math.inf
    story = stories.at_quality(stories.named(scene_type, options.story), scene_type, options.quality)
    player = load_settings(user_folder()).settings.name
    try:
        found = rehearsal_of(story, scene_type)
        if begin_s >= found.film_s:
            raise MistakeError(f"--from {options.begin}: the story has ended by {found.film_s:.1f} s")
        drawn = StoryFilm(story, scene_type, film.size, options.theme, player)
        made = write_story_film(drawn, found, film.path, film.fps, Excerpt(begin_s, seconds))
    except (VideoError, StoryError, LevelError) as error:
        raise MistakeError(str(error), status=1) from None
    for path in (film.path, *made.beside):
        say(f"{path}: {made.length_s:.1f} s, {made.pictures} pictures" if path == film.path else f"{path}")
    return 0
