"""How long the newcomers' cup takes: programs play its matches, one of them in the person's place."""

from __future__ import annotations

from game.billiards.career.career import Player, Result
from game.billiards.career.matches import cup_match, length_of, new_cup, with_result
from game.billiards.game.register import REGISTER
from game.levels import level_files, load_level
from game.scenes.shared.tables.course import AIMING
from game.stage import Stage
from tests.scenes.shared.evening import SCENES

THINKING_S = 15.0  # s that a newcomer looks at the table before each stroke
WHEN = "2026-01-02T03:04:05"
LONGEST = 600  # turns of a match


def match_s(game: str, person: str, opponent: str, seed: int) -> tuple[float, bool]:
    """How long a match of the newcomers' cup lasts, s, and whether the program in the person's place wins."""
    entry = REGISTER[game]
    scene_type, length = SCENES[entry.family], length_of(entry, short=True)
    path = next(path for path in level_files(entry.family) if path.stem == entry.level)
    level = load_level(path, entry.family, scene_type.content_type)
    chosen = {length.parameter: length.value, "first_player": person, "second_player": opponent}
    stage = Stage(scene_type, level=level, parameters=chosen, seed=seed)
    scene, thought_s = stage.scene, 0.0
    for _ in range(LONGEST):
        while scene.course.phase != AIMING:
            stage.run(25)
        if scene.model.frame.game.over:
            return stage.time_s + thought_s, scene.model.frame.game.winner == 0
        if scene.model.frame.game.turn == 0:
            thought_s += THINKING_S
        scene.course.rest_s = 10.0
        stage.listen(at_once=True)
        stage.run(1)
    raise AssertionError(f"no end after {LONGEST} turns")


def cup_s(game: str, person: str, seed: int) -> tuple[float, bool]:
    """How long a cup lasts for the person, s, and whether it is won."""
    player, total = new_cup(Player("Mia"), game, seed, newcomers=True), 0.0
    while (match := cup_match(player)) is not None:
        took, won = match_s(match.game, person, match.opponent, seed)
        total += took
        player = with_result(player, Result(match, WHEN, int(won), int(not won), won))
    return total, player.cups[-1].reached == 3
