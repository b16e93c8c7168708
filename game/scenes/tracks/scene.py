"""Balls that roll, slide, fly and land on smooth tracks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from game.lab.studies.loops import loop_study
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.scenes.tracks import TRACKS
from game.scenes.tracks.figure import draw_rolling
from game.scenes.tracks.hand import track_hand
from game.scenes.tracks.level import BallEntry, TrackContent
from game.scenes.tracks.parameters import OF_CHOSEN, OF_PICTURE, OF_TOOLS, TOOLS, TrackParameters
from game.scenes.tracks.told import readouts, saved
from game.scenes.tracks.view import TrackView
from game.scenes.tracks.world import TracksWorld
from game.stage import Equation, Hint, Inspected, SceneAction, Strip
from game.worlds.entries.tracks import TrackEntry
from game.worlds.hands.hand import NOBODY, hint_of, tool_keys
from game.worlds.scene import Parts, Told, WorldScene


class Tracks(WorldScene):
    """A ball on a track has one coordinate, the way of its centre. The track is a smooth curve through its
    points, so it costs the ball nothing: a loop that is drawn by 50 chords is passed from the same height as
    one of 800. Every corner of chords takes some of the speed.

    While friction holds, the ball rolls, and its energy says how fast. Where the track presses too little for
    that, it slips. Where the track would have to pull, it leaves and flies, until it meets a track.

    Balls do not touch one another.

    In the equations: s way of the centre, κ its curvature, N force of the track, F friction, m mass, k m r²
    inertia, μ friction, R radius of a loop, a of a cycloid's wheel.
    """

    name, task, title = TRACKS.names
    parameters_type = TrackParameters
    parameters: TrackParameters
    model: TracksWorld
    parts = Parts(TracksWorld, track_hand, TrackView)
    told = Told(readouts, saved)
    tools = TOOLS
    tool_prefix = ""
    takes = frozenset(("right",))
    edits = frozenset(OF_CHOSEN)
    covers = False
    builds = True
    not_of_model = (*OF_PICTURE, *OF_TOOLS, *OF_CHOSEN)
    effects = EffectSet([GRAVITY])
    content_type = TrackContent
    study = loop_study

    hints = (
        Hint(("Drag",), "move a ball"),
        Hint(("Right click",), "its own properties"),
        Hint(("N", "D", "B"), "new ball, draw, bend"),
        Hint(("E",), "delete"),
    )
    actions = (*tool_keys(TOOLS), SceneAction("card", "put the card of a ball away", "Q"))
    strips = (
        Strip("Speed of the first", "m/s", ("speed", "exact"), exact=("exact",)),
        Strip("Energy", "J", ("moving", "turning", "height", "sum")),
        Strip("Lost to friction and impacts", "J", ("lost",)),
    )
    figure = staticmethod(draw_rolling)
    equations = (
        Equation("Rolling", r"\ddot{s} = \frac{g \sin\theta}{1 + k}", "k = ½ disc, ⅖ sphere"),
        Equation(
            "It holds while", r"\abs{F} = \frac{k}{1 + k} m g \abs{\sin\theta} \le \mu N", "Coulomb 1785"
        ),
        Equation("It stays on while", r"N = m (\kappa \dot{s}^2 + g \cos\theta) \ge 0", "Huygens 1673"),
        Equation("A loop is passed from", r"\frac{5 + k}{2} (R - r)", "drop of the centre, no slip"),
        Equation("Quickest way", r"x = a (\phi - \sin\phi),  y = a (\cos\phi - 1)", "Johann Bernoulli 1696"),
        Equation("Down a cycloid", r"t = \pi \sqrt{(1 + k) a / g}", "from wherever it starts: Huygens 1673"),
    )
    try_this = (
        "Set Chords to 20 and to 800: the loop's verdict is the same.",
        "Open the race: the cycloid wins though its way is longer than the line.",
        "Lower the friction in the loop: the ball slips near the top and needs more height.",
        "Draw a track under a flying ball, and bend it while the ball rolls.",
        "Give a new ball the form of a ring: it rolls slowest down every slope.",
    )
    default_content: ClassVar[TrackContent] = TrackContent(
        tracks=(TrackEntry(form="loop", size=(1.0, 2.75)),),
        balls=(BallEntry(position=(-4.1, 2.85)),),
    )

    def do(self, name: str) -> str:
        """Put the card away."""
        self.model.inspect(NOBODY)
        return ""

    def parameter_changed(self, name: str) -> None:
        if name not in OF_CHOSEN:
            super().parameter_changed(name)
        elif self.inspected() is not None:
            self.model.give_own(self.model.inspected, name)

    def why_idle(self, name: str) -> str:
        if name in OF_CHOSEN and self.inspected() is None:
            return "No ball is chosen."
        return super().why_idle(name)

    def inspected(self) -> Inspected | None:
        """The ball that was clicked, if it is still there."""
        ball = self.model.inspected
        return Inspected(f"Ball {ball + 1}", OF_CHOSEN, "card") if 0 <= ball < len(self.model.rows) else None

    def hints_now(self) -> Sequence[Hint]:
        """What the tool in the hand does."""
        return (*(hint_of(TOOLS, self.parameters.tool) or self.hints[:1]), *self.hints[1:])
