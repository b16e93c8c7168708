"""The hand in the mass-spring scenes: moving, making, linking, pinning and cutting while it runs."""

from __future__ import annotations

import numpy as np

from game.physics.constraints.editing import (
    links_across,
    nearest_particle,
    with_link,
    with_particle,
    without_particle,
)
from game.physics.fields import GROUND
from game.scenes.springs.level import Point
from game.scenes.springs.model import SpringModel
from game.scenes.springs.network import NOT_OWN
from game.scenes.springs.parameters import SoftSpringParameters
from game.stage import Part, Pointer

REACH = 0.045  # of the height in view: how near to a particle the pointer takes it
FARTHEST = 1e4  # m
MOST_PARTICLES = 20_000  # that clicks can make
NOBODY = -1
NEXT_CLICK = {
    "particle": "click: a new particle",
    "link": "click one end of the link",
    "pin": "click: pin or free",
    "cut": "drag across links: cut",
}


class SpringHand(Part):
    """What is chosen (a particle or NOBODY), and the first end of a link (or NOBODY). Where a cut has come
    to, and where the pointer was last (m, or None). What it holds is in the system.

    Methods give what there is to say about what was done, or "".
    """

    def __init__(self, model: SpringModel):
        self.model = model
        self.parameters = model.parameters
        self.chosen = self.first = NOBODY
        self.knife: Point | None = None
        self.pointer: Point | None = None

    def next_click(self) -> str:
        """What the left button does next with the tool in the hand; "" where it takes hold of a thing."""
        tool = self.parameters.tool
        if tool == "link" and self.first != NOBODY:
            return "click the other end"
        return NEXT_CLICK.get(tool, "")

    def begin_again(self) -> None:
        """Forget what was begun; what is chosen stays."""
        self.first = NOBODY
        self.knife = None
        self.model.system.release()

    def take(self, event: Pointer) -> str:
        """A pointer event in world coordinates."""
        point = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)
        self.pointer = point
        if event.kind == "down" and event.button == 3:
            self.knife = point
        elif event.kind == "down" and event.button == 1:
            return self._press(point)
        elif event.kind == "move":
            if self.knife is not None:
                self._cut_from(self.knife, point)
            elif self.model.system.held != NOBODY:
                self.model.system.drag(self._between_walls(point))
        elif event.kind in ("up", "cancel"):
            return self._let_go(point, cancelled=event.kind == "cancel")
        return ""

    def _between_walls(self, point: Point) -> Point:
        """The nearest place (m) that can be reached without passing a wall."""
        left, right = self.model.walls if GROUND in self.model.active else (-FARTHEST, FARTHEST)
        return min(max(point[0], left), right), point[1]

    def _let_go(self, point: Point, cancelled: bool) -> str:
        words = ""
        if not cancelled and self.first != NOBODY:
            words = self._link_to(self._at(point), released=True)
        self.knife = None
        self.model.system.release()
        if cancelled:
            self.first = NOBODY
        return words

    def _at(self, point: Point) -> int:
        """The particle at a point, or NOBODY."""
        view = self.model.content.view
        return nearest_particle(self.model.system, point, REACH * (view.top - view.bottom))

    def _press(self, point: Point) -> str:
        index, tool = self._at(point), self.parameters.tool
        if tool == "cut":
            self.knife = point
        elif tool == "particle" and index == NOBODY:
            return self._make_particle(point)
        elif tool == "link":
            if self.first != NOBODY:
                return self._link_to(index, released=False)
            self.first = index
            self._choose(index)
        elif tool == "pin" and index != NOBODY:
            self._choose(index)
            self.parameters.fixed = not self.parameters.fixed
            self.apply_parameter("fixed")
        else:
            self._choose(index)
            if index != NOBODY:
                system = self.model.system
                system.grab(index, self.parameters.grip)
                system.drag(system.positions[index])
        return ""

    def _choose(self, index: int) -> None:
        """Let a particle be the chosen one (or none), and the parameters say what it is."""
        self.chosen, parameters = index, self.parameters
        if index == NOBODY:
            return
        weight = self.model.inverse_mass(index)
        parameters.fixed = weight == 0.0
        if weight > 0.0:
            parameters.mass = min(max(1.0 / weight, 1e-6), 1e6)
        if isinstance(parameters, SoftSpringParameters):
            own = self.model.own[np.any(self.model.system.links.pairs == index, axis=1)]
            if len(own):
                parameters.own_stiffness = float(own[0]) if own[0] != NOT_OWN else parameters.stiffness

    def apply_parameter(self, name: str) -> None:
        """Give what is chosen the mass, fixing or stiffness that the parameters say."""
        if self.chosen == NOBODY:
            return
        if name == "own_stiffness" and isinstance(self.parameters, SoftSpringParameters):
            self.model.give_own_stiffness(self.chosen, self.parameters.own_stiffness)
        else:
            self.model.give_inverse_mass(self.chosen, self._weight())

    def _weight(self) -> float:
        """The inverse mass (1/kg) that the parameters say."""
        return 0.0 if self.parameters.fixed else 1.0 / self.parameters.mass

    def _make_particle(self, point: Point) -> str:
        model = self.model
        if model.system.count >= MOST_PARTICLES:
            return f"There can be at most {MOST_PARTICLES} particles."
        model.take_system(with_particle(model.system, point, self._weight()), model.own)
        self.chosen = model.system.count - 1
        return ""

    def _link_to(self, index: int, released: bool) -> str:
        """End a link at a particle; a click that is released where it began waits for another one."""
        model, first = self.model, self.first
        if released and index == first:
            return ""
        self.first = NOBODY
        if index in (NOBODY, first):
            return ""
        try:
            system = with_link(model.system, first, index)
        except ValueError as error:
            return f"{str(error).capitalize()}."
        model.take_system(system, np.append(model.own, NOT_OWN))
        model.renew_links()
        self.chosen = index
        return ""

    def _cut_from(self, start: Point, point: Point) -> None:
        """Cut all links between where the knife was and where it is now."""
        for link in links_across(self.model.system, start, point):
            self.model.system.cut(link)
        self.knife = point

    def delete(self) -> str:
        """Take the chosen particle away, with its links."""
        model, index = self.model, self.chosen
        if index == NOBODY:
            return ""
        self.begin_again()
        kept = np.all(model.system.links.pairs != index, axis=1)
        try:
            system = without_particle(model.system, index)
        except ValueError as error:
            return f"{str(error).capitalize()}."
        model.take_system(system, model.own[kept])
        self.chosen = NOBODY
        return ""
