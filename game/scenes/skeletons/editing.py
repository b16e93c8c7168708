"""Edits of a figure by the pointer and by keys: bones made and turned, skins drawn, chains picked.

Each event gives another bench, and the pose that the figure is to take: see bench.py.
"""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.physics.animation import Skeleton
from game.physics.animation.skeleton_editing import NOWHERE, SHORTEST, bone_at
from game.physics.kernels import elementary
from game.scenes.skeletons.bench import Bench, Turn, reach_of, remembered, with_message
from game.scenes.skeletons.level import (
    MOST_BONES,
    MOST_POINTS,
    BoneEntry,
    ChainEntry,
    FigureContent,
    Point,
    SkinEntry,
    fresh_name,
)
from game.scenes.skeletons.rig import Rig
from game.stage import Pointer

FARTHEST = 5_000.0  # m
DRAWN_FILL = "chalk"
PARENT = "click the parent bone; with Shift, where on it the new one begins"


def next_click(bench: Bench, tool: str) -> str:
    """What the next click with a tool is for, in words; "" where it takes hold of a thing."""
    if tool == "bone":
        return PARENT if bench.chosen == NOWHERE else "click where the new bone ends"
    if tool == "skin":
        if not bench.drawn:
            return "click the first corner"
        return "click the next corner" if len(bench.drawn) < 3 else "next corner; Enter closes"
    if tool == "chain":
        return "click one end of the chain" if bench.picked == NOWHERE else "click its other end"
    return ""


# -- the pointer ----------------------------------------------------------------------------------------


def take_pointer(bench: Bench, rig: Rig, event: Pointer, tool: str, limited: bool) -> Turn:
    """The bench after a pointer event in the figure's own coordinates, with one of the tools."""
    point = (min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST))
    bench = msgspec.structs.replace(bench, pointer=point, message="")
    if event.kind == "down" and event.button == 1:
        if tool == "bone":
            return _grow(bench, rig, point, event.shift)
        press = {"pose": _take, "skin": _draw, "chain": _pick}.get(tool)
        return press(bench, rig, point) if press is not None else Turn(bench)
    if event.kind == "move" and bench.held:
        return _drag(bench, rig, point, limited)
    if event.kind == "up" and bench.held:
        return Turn(_let_go(bench, rig))
    if event.kind == "cancel":
        return _take_back(bench)
    return Turn(bench)


def _take(bench: Bench, rig: Rig, point: Point) -> Turn:
    """Press: the root by its beginning, else a bone to be turned."""
    skeleton, reach = rig.skeleton, reach_of(bench.figure)
    root = int(np.argmax(skeleton.parents < 0))
    start = skeleton.bases[root].tolist()
    if elementary.dist(start, point) <= 0.6 * reach:
        grip = (point[0] - start[0], point[1] - start[1])
        return Turn(_hold(bench, rig, root, "root", grip))
    bone = bone_at(skeleton, point, reach)
    if bone == NOWHERE:
        return Turn(msgspec.structs.replace(bench, chosen=NOWHERE))
    x, y = skeleton.bases[bone].tolist()
    toward = elementary.atan2(point[1] - y, point[0] - x)
    return Turn(_hold(bench, rig, bone, "bone", (float(skeleton.angles[bone]) - toward, 0.0)))


def _hold(bench: Bench, rig: Rig, bone: int, held: str, grip: tuple[float, float]) -> Bench:
    return msgspec.structs.replace(remembered(bench, rig.now), chosen=bone, held=held, grip=grip)


def _drag(bench: Bench, rig: Rig, point: Point, limited: bool) -> Turn:
    pose, bone = rig.now, bench.chosen
    if bench.held == "root":
        base = rig.skeleton.bases[bone]
        pose[-2] += point[0] - bench.grip[0] - base[0]
        pose[-1] += point[1] - bench.grip[1] - base[1]
        return Turn(bench, pose)
    x, y = rig.skeleton.bases[bone].tolist()
    if elementary.dist((x, y), point) <= SHORTEST:
        return Turn(bench)
    angle = elementary.atan2(point[1] - y, point[0] - x) + bench.grip[0]
    before = float(pose[bone])
    angle = before + math.remainder(
        angle - before, 2.0 * math.pi
    )  # the nearest whole turn: no jump after many turns
    if limited:
        angle = min(max(angle, float(rig.skeleton.lower[bone])), float(rig.skeleton.upper[bone]))
    pose[bone] = angle
    return Turn(bench, pose)


def _let_go(bench: Bench, rig: Rig) -> Bench:
    """The end of a drag; one that changed nothing leaves nothing to undo."""
    unmoved = bool(bench.past) and bench.past[-1].pose == tuple(rig.now.tolist())
    past = bench.past[:-1] if unmoved else bench.past
    return msgspec.structs.replace(bench, held="", past=past)


def _take_back(bench: Bench) -> Turn:
    """What is held goes back; a skin or a chain that was begun is given up."""
    pose = None
    if bench.held and bench.past:
        pose = np.array(bench.past[-1].pose)
        bench = msgspec.structs.replace(bench, past=bench.past[:-1])
    return Turn(msgspec.structs.replace(bench, held="", drawn=(), picked=NOWHERE), pose)


# -- bones ----------------------------------------------------------------------------------------------


def joint_of(bench: Bench, skeleton: Skeleton) -> tuple[float, float]:
    """Where (m) a new bone of the chosen parent begins: at its end, or where it was clicked with Shift."""
    parent = bench.chosen
    if bench.socket is None:
        x, y = skeleton.ends[parent].tolist()
        return x, y
    (x, y), along = skeleton.bases[parent].tolist(), skeleton.world_angle(parent)
    return x + bench.socket * elementary.cos(along), y + bench.socket * elementary.sin(along)


def _socket_at(skeleton: Skeleton, bone: int, point: Point) -> float:
    """How far (m) along a bone a point is."""
    (x, y), along = skeleton.bases[bone].tolist(), skeleton.world_angle(bone)
    far = (point[0] - x) * elementary.cos(along) + (point[1] - y) * elementary.sin(along)
    return min(max(far, 0.0), float(skeleton.lengths[bone]))


def _grow(bench: Bench, rig: Rig, point: Point, on_it: bool) -> Turn:
    """A click on a bone chooses the parent. One beside all bones lays a new bone from its end, or from where
    on the parent it was clicked (``on_it``).
    """
    figure = bench.figure
    bone = bone_at(rig.skeleton, point, 0.6 * reach_of(figure))
    if bone != NOWHERE:
        socket = _socket_at(rig.skeleton, bone, point) if on_it else None
        return Turn(msgspec.structs.replace(bench, chosen=bone, socket=socket))
    parent = bench.chosen
    if parent == NOWHERE:
        return Turn(with_message(bench, "Click the parent bone first."))
    if len(figure.bones) >= MOST_BONES:
        return Turn(with_message(bench, f"There can be at most {MOST_BONES} bones."))
    x, y = joint_of(bench, rig.skeleton)
    dx, dy = point[0] - x, point[1] - y
    turn = math.degrees(elementary.atan2(dy, dx) - rig.skeleton.world_angle(parent))
    made = BoneEntry(
        name=fresh_name(figure), parent=figure.bones[parent].name, length=math.sqrt(dx * dx + dy * dy),
        angle=math.remainder(turn, 360.0), place=None if bench.socket is None else (bench.socket, 0.0),
    )  # fmt: skip
    longer = msgspec.structs.replace(figure, bones=(*figure.bones, made), skins=_widened(figure))
    pose = np.insert(rig.now, len(figure.bones), math.radians(made.angle))
    bench = remembered(bench, rig.now)
    return Turn(msgspec.structs.replace(bench, figure=longer, chosen=len(figure.bones), socket=None), pose)


def _widened(figure: FigureContent) -> tuple[SkinEntry, ...]:
    """Skins with weights given: nothing of them on the new bone."""
    return tuple(
        msgspec.structs.replace(skin, weights=tuple((*row, 0.0) for row in skin.weights))
        if skin.weights is not None
        else skin
        for skin in figure.skins
    )


def delete(bench: Bench, rig: Rig, tool: str) -> Turn:
    """Take away the last point drawn, with the pen the last skin, else the chosen bone with its children."""
    figure = bench.figure
    if bench.drawn:
        return Turn(msgspec.structs.replace(bench, drawn=bench.drawn[:-1]))
    if tool == "skin":
        if not figure.skins:
            return Turn(with_message(bench, "There is no skin."))
        fewer = msgspec.structs.replace(figure, skins=figure.skins[:-1])
        return Turn(msgspec.structs.replace(remembered(bench, rig.now), figure=fewer), rig.now)
    if bench.chosen == NOWHERE:
        return Turn(with_message(bench, "Choose a bone first."))
    return _without(bench, rig)


def _without(bench: Bench, rig: Rig) -> Turn:
    figure, gone = bench.figure, {figure_bone(bench).name}
    while True:
        more = {bone.name for bone in figure.bones if bone.parent in gone} - gone
        if not more:
            break
        gone |= more
    stays = np.array([bone.name not in gone for bone in figure.bones])
    if not stays.any():
        return Turn(with_message(bench, "The last bone stays."))
    if figure.chain is not None and gone & {figure.chain.start, figure.chain.end}:
        return Turn(with_message(bench, "The chain needs this bone; pick another chain first."))
    skins = []
    for skin in figure.skins:
        if skin.bones:
            left = tuple(name for name in skin.bones if name not in gone)
            if not left:
                continue
            skin = msgspec.structs.replace(skin, bones=left)
        if skin.weights is not None:
            rows = np.array(skin.weights)[:, stays]
            if np.any(rows.max(axis=1) <= 0.0):
                continue
            skin = msgspec.structs.replace(skin, weights=tuple(tuple(row) for row in rows.tolist()))
        skins.append(skin)
    bones = tuple(bone for bone in figure.bones if bone.name not in gone)
    fewer = msgspec.structs.replace(figure, bones=bones, skins=tuple(skins))
    pose = rig.now[np.append(stays, (True, True))]
    bench = remembered(bench, rig.now)
    return Turn(msgspec.structs.replace(bench, figure=fewer, chosen=NOWHERE, picked=NOWHERE), pose)


def figure_bone(bench: Bench) -> BoneEntry:
    """The chosen bone."""
    return bench.figure.bones[bench.chosen]


# -- skins ----------------------------------------------------------------------------------------------


def _draw(bench: Bench, rig: Rig, point: Point) -> Turn:
    """A click with the pen: another corner of the skin, or its end at the first one."""
    drawn = bench.drawn
    if len(drawn) >= 3 and elementary.dist(point, drawn[0]) <= 0.6 * reach_of(bench.figure):
        return finish(bench, rig)
    if drawn and elementary.dist(point, drawn[-1]) <= SHORTEST:
        return Turn(bench)
    if len(drawn) >= MOST_POINTS:
        return Turn(with_message(bench, f"A skin has {MOST_POINTS} points at most."))
    return Turn(msgspec.structs.replace(bench, drawn=(*drawn, point)))


def finish(bench: Bench, rig: Rig) -> Turn:
    """Close the skin being drawn."""
    if len(bench.drawn) < 3:
        return Turn(with_message(bench, "A skin needs three points."))
    figure = bench.figure
    made = SkinEntry(points=bench.drawn, fill=DRAWN_FILL, strength=0.35)
    more = msgspec.structs.replace(figure, skins=(*figure.skins, made))
    bench = msgspec.structs.replace(remembered(bench, rig.now), figure=more, drawn=())
    return Turn(bench, rig.now)


def rebind(bench: Bench, rig: Rig, blend: str) -> Turn:
    """Make the present pose the bind pose: the points of skins become what they look like now."""
    figure, now = bench.figure, rig.now
    rig.move(blend)
    bones = tuple(
        msgspec.structs.replace(
            bone, angle=math.degrees(angle), turn=0.0, limits=_shifted(bone, math.degrees(angle))
        )
        for bone, angle in zip(figure.bones, now[:-2].tolist(), strict=True)
    )
    bones = tuple(
        bone if bone.parent else msgspec.structs.replace(bone, place=tuple(rig.skeleton.offsets[i].tolist()))
        for i, bone in enumerate(bones)
    )
    skins = tuple(
        msgspec.structs.replace(
            skin, points=tuple((x, y) for x, y in rig.skinned[rig.outline(i)].tolist())
        )
        for i, skin in enumerate(figure.skins)
    )  # fmt: skip
    bound = msgspec.structs.replace(figure, bones=bones, skins=skins, shift=(0.0, 0.0))
    pose = now.copy()
    pose[-2:] = 0.0
    return Turn(msgspec.structs.replace(remembered(bench, now), figure=bound), pose)


def _shifted(bone: BoneEntry, angle: float) -> tuple[float, float] | None:
    """Limits against another bind pose, so that the joint's limits stay where they are."""
    if bone.limits is None:
        return None
    return bone.limits[0] + bone.angle - angle, bone.limits[1] + bone.angle - angle


# -- chains ---------------------------------------------------------------------------------------------


def _pick(bench: Bench, rig: Rig, point: Point) -> Turn:
    """Two clicks: the first and the last bone of the chain, in either order."""
    bone = bone_at(rig.skeleton, point, reach_of(bench.figure))
    if bone == NOWHERE:
        return Turn(with_message(bench, "Click a bone."))
    if bench.picked == NOWHERE:
        return Turn(msgspec.structs.replace(bench, picked=bone, chosen=bone))
    ends = (bench.picked, bone)
    bench = msgspec.structs.replace(bench, picked=NOWHERE, chosen=bone)
    for start, end in (ends, ends[::-1]):
        try:
            rig.skeleton.path(start, end)
        except ValueError:
            continue
        return _chained(bench, rig, start, end)
    return Turn(with_message(bench, "One of the two bones must hang on the other."))


def _chained(bench: Bench, rig: Rig, start: int, end: int) -> Turn:
    figure = bench.figure
    x, y = rig.skeleton.ends[end].tolist()
    chain = ChainEntry(start=figure.bones[start].name, end=figure.bones[end].name, target=(x, y))
    bench = remembered(bench, rig.now)
    return Turn(msgspec.structs.replace(bench, figure=msgspec.structs.replace(figure, chain=chain)), rig.now)
