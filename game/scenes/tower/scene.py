"""The controlled fall: a story, and a tower to cut down in one's own way."""

from __future__ import annotations

from typing import ClassVar

from game.lab.studies.collapse import collapse_study
from game.physics.fields import GRAVITY
from game.physics.solids.effects import CONTACTS, CONTINUOUS, FRICTION, JOINTS, RESTITUTION, SLEEP
from game.scenes.tower import A08
from game.scenes.tower.air import AIR
from game.scenes.tower.figure import draw_front
from game.scenes.tower.hand import tower_hand
from game.scenes.tower.level import TowerContent
from game.scenes.tower.parameters import OF_PICTURE, TOOLS, TowerParameters
from game.scenes.tower.told import hearing, names, readouts, saved, sizes, targets
from game.scenes.tower.view import TowerView
from game.scenes.tower.world import TowerWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import Parts, Told, WorldScene


class Tower(WorldScene):
    """An empty tower of floors and columns. Charges cut the columns of one storey. What is above falls upon
    the floor below, and takes it along. Both go on, slower than before but with more mass. So the front runs
    down from floor to floor: with nothing else to resist, an even row of floors falls with a third of
    gravity, and a mass at the start makes it faster.

    Columns become rubble that flies off to both sides; their momenta sum to nothing. Bays of a floor are
    welded: joints part beyond a load, and a bay that is stopped too fast breaks. So does all that loses more
    than one and a half times that speed within a twentieth of a second, and its pieces fly apart. Pieces and
    dust together keep the mass of what they were. Columns further down are cut by the scene the moment before
    the falling floor meets theirs: a rigid column would stop the fall for a whole step before its joints
    part. The clock of the fall and the law begin when the last column is cut. They start with the speed and
    the displacement that the floors have by then.

    The air flows on a coarse grid around floors that move with their true velocity: it is driven out from
    under them and carries the dust, whose mass is kept and which weighs on it. The air does not slow floors.

    In the equations: M the mass that falls, m that of a floor with its columns, v speed before and v' after
    it is struck, d the way from one to the next, g gravity, z the way of the front.
    """

    name, task, title = A08.names
    parameters_type = TowerParameters
    parameters: TowerParameters
    model: TowerWorld
    parts = Parts(TowerWorld, tower_hand, TowerView)
    told = Told(readouts, saved, targets, hearing, names, sizes)
    tool_prefix = "tool-"
    painters = (("polygons", warm_up_painter),)
    effects = GRAVITY | CONTACTS | FRICTION | RESTITUTION | CONTINUOUS | SLEEP | JOINTS | AIR
    content_type = TowerContent
    not_of_model = OF_PICTURE
    study = collapse_study
    may_be_infinite = frozenset(("world.joints",))

    strips = (
        Strip(
            "Front", "m/s²", ("front", "front by law", "a third of g"), sometimes=("front", "front by law")
        ),
        Strip("Storeys", "", ("storeys standing", "floors struck")),
        Strip("Pieces and awake", "", ("pieces", "awake")),
    )
    hints = (
        Hint(("U",), "fire the charges"),
        Hint(("Click",), "cut a column"),
        Hint(("Right click",), "break a floor"),
        Hint(("1", "2"), "cut, break"),
    )
    actions = (
        SceneAction("fire", "fire the charges", "U"),
        SceneAction("build", "build it again", "B"),
        *tool_keys(TOOLS, "tool-"),
    )
    figure = staticmethod(draw_front)
    equations = (
        Equation("A floor is struck", r"v' = v \frac{M}{M + m}", "momentum is kept"),
        Equation("To the next", r"v^2 = v'^2 + 2 g d", "free fall"),
        Equation("Many floors, no mass at the start", r"\ddot{z} = \frac{g}{3}", "Cayley 1857"),
    )
    try_this = (
        "Set First storey to 6: more mass falls at first, and the front is faster.",
        "Let columns not give way: how far does it come?",
        "Cut the columns of one side only, by hand.",
        "Make floors strong and joints weak, and the other way round.",
    )
    default_content: ClassVar[TowerContent] = TowerContent()

    def why_idle(self, name: str) -> str:
        if name == "joints":
            return "" if self.model.time == 0.0 else "Joints are as they were built; reset the tower."
        return super().why_idle(name)

    def do(self, name: str) -> str:
        (self.model.build if name == "build" else self.model.fire)()
        return ""
