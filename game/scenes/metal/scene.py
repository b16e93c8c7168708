"""The marble run: a story, and a place to build tracks of one's own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from game.lab.studies.marbles import marble_study
from game.physics.fields import GRAVITY
from game.physics.solids.effects import CONTACTS, CONTINUOUS, FRICTION, JOINTS, RESTITUTION, SLEEP
from game.scenes.metal import A22
from game.scenes.metal.figure import draw_forces
from game.scenes.metal.hand import metal_hand
from game.scenes.metal.level import BallEntry, Box, FloorEntry, MetalContent
from game.scenes.metal.parameters import OF_PICTURE, OF_TOOLS, TOOLS, MetalParameters
from game.scenes.metal.told import hearing, names, readouts, saved, targets
from game.scenes.metal.view import MetalView
from game.scenes.metal.world import MetalWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.ui.painters.steel import warm_up_steel
from game.ui.painters.wall import warm_up_wall
from game.worlds.entries.tracks import TrackEntry
from game.worlds.hands.hand import hint_of, tool_keys
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import Parts, Told, WorldScene


class MetalBalls(WorldScene):
    """Steel balls on tracks, among blocks, a seesaw, a funnel and a cradle; all that falls ends in a basin.

    On a track a ball has one coordinate, the way of its centre: it rolls while friction holds, slips where
    the track presses too little for that, and leaves it where the track would have to pull. In a yard (where
    things stand, hang or pile up) it is a rigid body among others: contacts push and rub, rods hold. It goes
    from one to the other with its place, speed and spin unchanged. On tracks and in flight outside the yards
    balls do not touch one another. The balls of the loop and of the race never slip: so the formulas want it.

    A step is cut into substeps: with more of them the measured times come nearer to the exact ones, and a
    step costs more. All balls are discs of a plane: a third of what they gain in rolling down is spin.

    In the equations: g gravity, α slope, s way of the centre, R radius of the loop, r of a ball, a of the
    wheel that draws a cycloid, φ its angle, v speed, N force of the track, κ curvature, θ angle from upright.
    """

    name, task, title = A22.names
    parameters_type = MetalParameters
    parameters: MetalParameters
    model: MetalWorld
    parts = Parts(MetalWorld, metal_hand, MetalView)
    told = Told(readouts, saved, targets, hearing, names)
    tool_prefix = ""
    painters = (("polygons", warm_up_painter), ("wall", warm_up_wall), ("steel", warm_up_steel))
    effects = GRAVITY | CONTACTS | FRICTION | RESTITUTION | CONTINUOUS | SLEEP | JOINTS
    content_type = MetalContent
    not_of_model = (*OF_PICTURE, *OF_TOOLS)
    study = marble_study
    may_be_infinite = frozenset(("world.joints",))

    strips = (
        Strip("Fastest ball", "m/s", ("fastest",)),
        Strip("Solids computed", "", ("awake", "loose")),
        Strip("Riding on tracks", "", ("riding",)),
    )
    hints = (
        Hint(("N",), "open the next gate"),
        Hint(("Drag",), "move a ball"),
        Hint(("Right click",), "take away"),
        Hint(("2", "3", "4", "5"), "bend, draw, new ball, size"),
    )
    actions = (SceneAction("next", "open the next gate", "N"), *tool_keys(TOOLS))
    figure = staticmethod(draw_forces)
    equations = (
        Equation("Rolling down an incline", r"\ddot{s} = \frac{2}{3} g \sin \alpha", "a disc, no slip"),
        Equation("A loop is passed from", r"\frac{11}{4} (R - r)", "drop of the centre: Huygens 1673"),
        Equation("It stays on while", r"N = m (\kappa v^2 + g \cos\theta) \ge 0", "Huygens 1673"),
        Equation("Quickest way", r"x = a (\phi - \sin\phi),  y = a (\cos\phi - 1)", "Johann Bernoulli 1696"),
        Equation("Its time", r"t = \phi \sqrt{\frac{3 a}{2 g}}", "from rest, a rolling disc"),
        Equation("Two equal balls swap", r"v_1' = v_2,  v_2' = v_1", "Huygens 1669, elastic and head-on"),
    )
    try_this = (
        "Move the ball of the loop a hand's breadth up or down before its gate opens.",
        "Bend the cycloid of the race: any other form is slower.",
        "Make the big ball over the seesaw smaller, and see how high the small one still goes.",
        "Draw a track under the funnel that leads somewhere else.",
        "Choose Own and one substep, then sixteen: compare the times with the exact ones.",
    )
    default_content: ClassVar[MetalContent] = MetalContent(
        tracks=(
            TrackEntry(points=((0.0, 3.0), (0.6, 2.2), (1.6, 1.6), (2.8, 1.4), (3.6, 1.5))),
            TrackEntry(points=((6.4, 1.6), (5.6, 0.9), (4.6, 0.6), (3.6, 0.6))),
        ),
        balls=(BallEntry(at=(0.12, 3.1)), BallEntry(at=(6.2, 2.2))),
        floors=(FloorEntry(points=((-2.0, 1.0), (-2.0, 0.0), (9.0, 0.0), (9.0, 1.0))),),
        yards=(Box(left=-4.0, bottom=-2.0, right=11.0, top=0.5),),
    )

    def do(self, name: str) -> str:
        return "" if self.model.open_next() else "All gates are open."

    def hints_now(self) -> Sequence[Hint]:
        """What the tool in the hand does."""
        return (self.hints[0], *hint_of(TOOLS, self.parameters.tool), *self.hints[2:])
