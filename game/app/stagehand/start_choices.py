"""What was chosen on the card before a game: the default next time, and a career's matches keep to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from game.stage.catalogue import Catalogue, Entry

if TYPE_CHECKING:
    from game.billiards.career.career import Player
    from game.billiards.career.prizes import Prize

# Of a person and its table; opponent, length and guide of a match are the career's own
PERSONAL = ("their_strokes", "stroke_by", "hand", "felt", "table", "cloth")
Chosen = Mapping[str, Mapping[str, str]]  # by scene and parameter


def locked_for(player: Player | None, family: str) -> dict[tuple[str, str], Prize]:
    """What a career has not unlocked yet. Imported here, since ratings bring the compiler with them."""
    from game.billiards.career.prizes import locked

    return locked(player, family)


def remembered(entry: Entry, chosen: Chosen, player: Player | None) -> dict[str, str]:
    """What a game is begun with: as chosen last where that is there still and unlocked, else the default.

    What is a person's own is as this person chose it, if it has.
    """
    mine = {} if player is None else player.choices.get(entry.name, {})
    shut, last = locked_for(player, entry.name), {**chosen.get(entry.name, {}), **mine}
    found = {}
    for line in entry.start_lines():
        value = last.get(line.parameter, line.default)
        there = value in dict(line.options) and (line.parameter, value) not in shut
        found[line.parameter] = value if there else line.default
    return found


def own_choices(catalogue: Catalogue, scene: str, chosen: Chosen, player: Player | None) -> dict[str, str]:
    """What a match of a career at a scene's table takes from them; empty where there is no such scene."""
    entry = next((one for one in catalogue if one.name == scene), None)
    if entry is None:
        return {}
    return {name: value for name, value in remembered(entry, chosen, player).items() if name in PERSONAL}


def keep_own(scene: str, chosen: Mapping[str, str]) -> str:
    """Keep what is a person's own of what was chosen, with its career, if there is one. What there is to
    complain of, in a line.
    """
    from game.app.stagehand.career_file import keep_career, load_career

    career, complaint = load_career()
    own = {name: value for name, value in chosen.items() if name in PERSONAL}
    if career.player is None or career.player.choices.get(scene) == own:
        return complaint
    choices = {**career.player.choices, scene: own}
    return keep_career(career.with_player(career.player.replace(choices=choices))) or complaint
