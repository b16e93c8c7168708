"""The hand in the playground: moves, throws, makes, joins, cuts, copies and takes away while it runs."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.physics.kernels import elementary
from game.physics.solids.arrays.layout import MOUSE
from game.physics.solids.arrays.state import DYNAMIC
from game.physics.solids.outlines import signed_area
from game.scenes.solids.bodies import entry_of, whole_joints
from game.scenes.solids.cutting import cut_bodies
from game.scenes.solids.joint_card import OF_JOINT, give_joint, show_joint
from game.scenes.solids.level import MOST_BODIES, BodyEntry, JointEntry, Point, ShapeEntry
from game.scenes.solids.model import ANCHOR, SolidModel
from game.scenes.solids.picking import bodies_at, joint_at, joints_across
from game.stage import Part, Pointer
from game.worlds.hands.curves import simplified
from game.worlds.hands.grab import body_at, grip
from game.worlds.hands.hand import NOBODY

REACH = 0.02  # of the height in view: how near to something the pointer takes it
FARTHEST = 1e5  # m
THROW_RATE = 4.0  # 1/s: speed for each metre of a drag back
MAKERS = ("disc", "box", "polygon", "capsule")
LINKERS = ("rope", "spring")
LEAST = 0.01  # of the height in view, of a new body
NEW_COLOURS = ("chalk", "green", "pink", "violet", "yellow", "vermilion")


class SolidHand(Part):
    """held: body that is moved, by the joint ``grip``; chosen: touched last; inspected: whose own properties
    are shown; joint: whose card is open.

    start, point: of a drag, m, None when there is none; path: points of an outline that is drawn.
    ``verb`` is the tool of the drag.
    """

    def __init__(self, model: SolidModel):
        self.model, self.parameters = model, model.parameters
        self.held = self.grip = self.chosen = self.inspected = self.joint = NOBODY
        self.start: Point | None = None
        self.point: Point | None = None
        self.verb = ""
        self.path: list[Point] = []
        self.made = 0

    @property
    def reach(self) -> float:
        """How near, m."""
        view = self.model.content.view
        return REACH * (view.top - view.bottom)

    @property
    def holding(self) -> bool:
        """Whether a body hangs on the pointer."""
        kinds = self.model.world.joints.kinds
        return 0 <= self.grip < len(kinds) and bool(kinds[self.grip] == MOUSE)

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)
        if event.kind == "down" and event.button in (1, 3):
            return self._press(point, "cut" if event.button == 3 else self.parameters.tool)
        if event.kind == "move" and self.start is not None:
            self._move(point)
        elif event.kind == "up" and self.start is not None:
            self._move(point)
            return self._finish()
        elif event.kind == "cancel":
            self.let_go()
        return ""

    def let_go(self) -> None:
        """Let go, and forget what was begun."""
        if self.holding:
            self.model.world.remove_joint(self.grip)
        self.held = self.grip = NOBODY
        self.start = self.point = None
        self.path, self.verb = [], ""

    def at(self, point: Point) -> int:
        """The movable body at a point, or NOBODY."""
        return body_at(self.model.world, self.model.movable(), point, self.reach)

    # -- a drag ---------------------------------------------------------------------------------------

    def _press(self, point: Point, tool: str) -> str:
        self.let_go()
        self.start = self.point = point
        self.verb, self.path = tool, [point]
        body = self.at(point)
        if tool == "hand" and body != NOBODY:
            self.chosen = body
            self._grab(body, point)
        elif tool in ("throw", "duplicate"):
            self.chosen = self.held = body
        elif tool == "select":
            self._inspect_at(point)
        elif tool == "delete":
            return self._delete_at(point, body)
        elif tool in ("pin", "weld", "motor"):
            return self._fasten(point, tool)
        return ""

    def _grab(self, body: int, point: Point) -> None:
        world = self.model.world
        if not world.bodies.flags[body] & DYNAMIC:
            return
        self.held = body
        self.grip = grip(world, ANCHOR, body, point)

    def _move(self, point: Point) -> None:
        self.point = point
        if self.holding:
            self.model.world.drag_to(self.grip, point)
        elif self.verb == "outline" and elementary.dist(point, self.path[-1]) > 0.2 * self.reach:
            self.path.append(point)

    def _finish(self) -> str:
        start, point, verb, held, path = self.start, self.point, self.verb, self.held, self.path
        self.let_go()
        assert start is not None and point is not None
        try:
            if verb in MAKERS:
                return self._make(verb, start, point)
            if verb == "outline":
                return self._make_outline(path)
            if verb in LINKERS:
                return self._link(verb, start, point)
            if verb == "cut":
                return self._cut(start, point)
            if verb == "throw" and held != NOBODY:
                self._throw(held, start, point)
            if verb == "duplicate" and held != NOBODY:
                return self._copy(held, start, point)
        except ValueError as error:
            return f"{str(error)[:1].upper()}{str(error)[1:]}."
        return ""

    # -- what drags do ----------------------------------------------------------------------------------

    def _throw(self, body: int, start: Point, point: Point) -> None:
        """Off against the drag, as from a sling."""
        world = self.model.world
        if world.bodies.flags[body] & DYNAMIC:
            pull = np.array(start) - np.array(point)
            world.set_velocity(body, THROW_RATE * pull, float(world.bodies.spins[body]))

    def _new(self, shapes: tuple[ShapeEntry, ...], place: Point, angle: float = 0.0) -> str:
        if len(self.model.movable()) >= MOST_BODIES:
            return f"There can be at most {MOST_BODIES} bodies."
        colour = NEW_COLOURS[self.made % len(NEW_COLOURS)]
        entry = BodyEntry(
            shapes=shapes,
            position=place,
            angle=angle,
            density=self.parameters.density,
            colour=colour,  # type: ignore[arg-type]
        )
        self.chosen = self.model.add(entry)
        self.made += 1
        return ""

    def _make(self, verb: str, start: Point, point: Point) -> str:
        (x0, y0), (x1, y1) = start, point
        long, middle = elementary.dist(start, point), (0.5 * (x0 + x1), 0.5 * (y0 + y1))
        view = self.model.content.view
        if long < LEAST * (view.top - view.bottom):
            return "Drag to say how large it is."
        if verb == "disc":
            return self._new((ShapeEntry(disc=long),), start)
        if verb == "box":
            width, height = max(abs(x1 - x0), 0.02 * long), max(abs(y1 - y0), 0.02 * long)
            return self._new((ShapeEntry(box=(width, height)),), middle)
        if verb == "capsule":
            half = 0.5 * long
            shape = ShapeEntry(capsule=((-half, 0.0), (half, 0.0)), radius=0.12 * long)
            return self._new((shape,), middle, math.degrees(elementary.atan2(y1 - y0, x1 - x0)))
        count, first = int(self.parameters.sides), elementary.atan2(y1 - y0, x1 - x0)
        turns = [first + 2.0 * math.pi * k / count for k in range(count)]
        corners = tuple((long * elementary.cos(turn), long * elementary.sin(turn)) for turn in turns)
        return self._new((ShapeEntry(polygon=corners),), start)

    def _make_outline(self, path: list[Point]) -> str:
        """What was drawn, closed; cut into convex parts by the world."""
        outline = simplified(np.array(path), 0.15 * self.reach)
        if len(outline) < 3 or abs(signed_area(outline)) < self.reach * self.reach:
            return "Draw all around a body."
        middle = outline.mean(axis=0)
        corners = tuple((float(x), float(y)) for x, y in outline - middle)
        return self._new((ShapeEntry(polygon=corners),), (float(middle[0]), float(middle[1])))

    def _fasten(self, point: Point, kind: str) -> str:
        """Both bodies at a point, or the one there and the ground."""
        world = self.model.world
        found = bodies_at(world, self.model.movable(), point)[-2:]
        self.start = self.point = None
        if not found:
            return "Click a body, or where two lie over each other."
        ids = [ANCHOR, found[0]] if len(found) == 1 else found
        motor = {"speed": self.parameters.motor_speed, "most": 1e6} if kind == "motor" else {}
        try:
            entry = JointEntry(kind=kind, bodies=(0, 1), at=point, **motor)  # type: ignore[arg-type]
            self.model.join(entry, ids)
        except ValueError as error:
            return f"{str(error)[:1].upper()}{str(error)[1:]}."
        return ""

    def _link(self, kind: str, start: Point, point: Point) -> str:
        a, b = self.at(start), self.at(point)
        if a == b:
            return "Drag from one body to another, or to the ground."
        ids = [ANCHOR if k == NOBODY else k for k in (a, b)]
        hertz = self.parameters.spring_rate if kind == "spring" else 0.0
        self.model.join(
            JointEntry(
                kind=kind, bodies=(0, 1), at=start, other=point, hertz=hertz,  # type: ignore[arg-type]
                damping=0.05 if kind == "spring" else 1.0, colliding=True,
            ),
            ids,
        )  # fmt: skip
        return ""

    def _cut(self, start: Point, point: Point) -> str:
        if elementary.dist(start, point) < 0.2 * self.reach:
            self._inspect_at(start)
            return ""
        joints = joints_across(self.model.world, start, point, 0.5 * self.reach)
        for joint in joints:
            self.model.world.remove_joint(joint)
        bodies = cut_bodies(self.model, start, point)
        self.chosen = self.inspected = NOBODY
        if not joints and not bodies:
            return "Draw the line right through what is to be cut."
        return ""

    def _copy(self, body: int, start: Point, point: Point) -> str:
        entry = entry_of(self.model.world, body, int(self.model.tints.rows[body]))
        x, y = entry.position
        place = x + point[0] - start[0], y + point[1] - start[1]
        if elementary.dist(start, point) < self.reach:
            place = x, y + 2.0 * float(self.model.world.bodies.reaches[body]) + self.reach
        self.chosen = self.model.add(msgspec.structs.replace(entry, position=place))
        return ""

    def _delete_at(self, point: Point, body: int) -> str:
        world = self.model.world
        self.start = self.point = None
        joint = joint_at(world, point, 0.6 * self.reach)
        if joint != NOBODY:
            world.remove_joint(joint)
        elif body != NOBODY:
            self.model.remove(body)
        self.chosen = self.inspected = NOBODY
        return ""

    # -- what a body has of its own -------------------------------------------------------------------

    def inspect(self, body: int) -> None:
        """Show a body's own properties (NOBODY: no one's), so that the parameters of the card say them."""
        self.inspected, self.joint = body, NOBODY
        if body != NOBODY:
            self.chosen = body
            self.model.show_own(body)

    @property
    def shown_joint(self) -> int:
        """The joint whose card is open, as long as it is there and whole; NOBODY."""
        return self.joint if self.joint in whole_joints(self.model.world) else NOBODY

    def _inspect_at(self, point: Point) -> None:
        """The card of the joint that has an end there, or else of the body."""
        joint = joint_at(self.model.world, point, 0.6 * self.reach)
        self.inspect(NOBODY if joint != NOBODY else self.at(point))
        self.joint = joint
        if joint != NOBODY:
            show_joint(self.model.world, self.parameters, joint)

    def inspect_chosen(self) -> str:
        """Those of what was touched last, or put the card away."""
        if self.inspected != NOBODY or self.shown_joint != NOBODY:
            self.inspect(NOBODY)
        elif self.chosen in self.model.movable():
            self.inspect(self.chosen)
        else:
            return "Touch a body first."
        return ""

    def give(self, name: str) -> str:
        """Give what is on the card what the parameter of that name says; why it cannot have it, or ""."""
        if name in OF_JOINT:
            joint = self.shown_joint
            return give_joint(self.model.world, self.parameters, joint, name) if joint != NOBODY else ""
        if self.inspected not in self.model.movable():
            return ""
        return self.model.give_own(self.inspected, name)

    def delete_chosen(self) -> str:
        """Take away what was touched last."""
        self.let_go()
        if self.chosen in self.model.movable():
            self.model.remove(self.chosen)
            self.chosen = self.inspected = NOBODY
            return ""
        return "Touch a body first."
