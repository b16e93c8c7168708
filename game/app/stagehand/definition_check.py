"""What a scene declares, tried out without a window: equations, card, figure, keys, a picture, its strips."""

from __future__ import annotations

from game.app.stagehand.headless import picture_of_stage, prepare
from game.app.window.commands import COMMANDS
from game.definition import DefinitionError
from game.lab.study import PRESENT
from game.scenes import CATALOGUE
from game.stage import Scene, Stage
from game.stage.opening.definition import check_strips
from game.ui.canvas.pen import FIGURE, Pen
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.text.markup import parse

CARD, PICTURE = (320, 208), (640, 360)  # px


def check_definition(scene_type: type[Scene]) -> None:
    """Draw and read all that a scene's class declares; whatever is raised says what is wrong with it.

    DefinitionError for the key of an action that is taken, for a name that stands for two things. Also for a
    study that does not find the scene. Equations, card and figure are only looked at in a scene that has
    them; strips and a picture as it opens.
    """
    for equation in scene_type.equations:
        parse(equation.formula)
    own = {action.name for action in scene_type.actions}  # a scene may do what a command does in its own way
    keys = {command.key.lower(): command.label for command in COMMANDS if command.name not in own}
    for action in scene_type.actions:
        key = action.key.lower()
        if key in keys:
            raise DefinitionError(f"{scene_type.__name__}.actions: {action.key} is taken: {keys[key]}")
        keys[key] = action.label
    prepare()
    look = Look(DARK)
    entry = next((entry for entry in CATALOGUE if entry.name == scene_type.name), None)
    painter = entry.card_painter() if entry is not None else None
    if painter is not None:
        painter(Pen(CARD, look))
    if scene_type.figure is not None:
        scene_type.figure(Pen((round(2 * FIGURE[0]), round(2 * FIGURE[1])), look, FIGURE))
    stage = Stage(scene_type)
    stage.run(1)
    check_strips(stage.scene)
    check_studies(stage.scene)
    picture_of_stage(stage, PICTURE)


def check_studies(scene: Scene) -> None:
    """DefinitionError unless each study places the scene, with its own effects, at a method that there is.

    And for a figure of `standing` that has the name of a parameter or an effect.
    """
    name = type(scene).__name__
    taken = {*scene.declared_parameters(), *scene.effects.names}
    for figure in scene.standing():
        if figure in taken:
            raise DefinitionError(f"{name}.standing: {figure} is a parameter or an effect as well")
    for study in scene.study.family if scene.study is not None else ():
        setting, _ = study.place(scene.chosen())
        known = (*(method.name for method in study.methods), PRESENT)
        if setting is not None and setting.method not in known:
            raise DefinitionError(f"{name}.study: {study.name} has no method {setting.method!r}")
