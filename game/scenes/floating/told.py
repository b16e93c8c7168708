"""What is measured of a body that floats, by hydrostatics and in the liquid; what is saved and heard."""

from __future__ import annotations

import math

import msgspec

from game.physics.hydrostatics import exact, pose_at
from game.physics.hydrostatics.motion import HEAVE, ROLL, TURN, X, Y
from game.scenes.floating.level import FloatingContent
from game.scenes.floating.shapes import PLANK
from game.scenes.floating.world import FloatingWorld
from game.stage import Hearing, Readout, Steady
from game.worlds.members.water import DENSITY

LOUDEST = 1500.0  # W/m of flow at which water is as loud as can be
TURNING, HEAVING = 0, 1  # rows of the swings


def readouts(model: FloatingWorld) -> list[Readout]:
    """The pose by both, what statics says of it, periods, prices."""
    body, floater = model.law.body, model.floater
    angle = float(body.pose[TURN])
    pose, both = pose_at(floater, angle, DENSITY), bool(model.parameters.both)
    level = model.law_level()
    area, draft = model.under((float(body.pose[X]), float(body.pose[Y])), angle, level)
    found = [
        Readout("angle", _degrees(angle), "°"), Readout("draft", max(draft, 0.0), "m"),
        Readout("level", level, "m"), Readout("displaced", area, "m²"),
        Readout("at rest", min(floater.mass / DENSITY, floater.area), "m²"),
        Readout("righting arm", pose.arm, "m"), Readout("GM", pose.height, "m"),
        Readout("stable angle", _degrees(nearest_stable(model, angle)), "°"),
        Readout("stable poses", sum(one.stable for one in model.curve.poses)),
        Readout("roll period", model.swings.period(TURNING), "s"),
        Readout("roll, reckoned", roll_reckoned(model, pose.height), "s"),
        Readout("heave period", model.swings.period(HEAVING), "s"),
        Readout("heave, reckoned", heave_reckoned(model, pose.width), "s"),
        Readout("energy", body.energy(), "J/m"),
        Readout("a step, hydrostatics", model.law.watch.median("step"), "s"),
    ]  # fmt: skip
    model.water.measure()
    centre, turned = model.liquid_pose()
    level = model.liquid_level() if both else math.nan
    area, draft = model.under(centre, turned, level) if both else (math.nan, math.nan)
    return [
        *found,
        Readout("angle, liquid", _degrees(turned) if both else math.nan, "°"),
        Readout("draft, liquid", draft, "m"), Readout("level, liquid", level, "m"),
        Readout("displaced, liquid", area, "m²"),
        Readout("roll, liquid", model.swings.period(TURNING + 2) if both else math.nan, "s"),
        Readout("heave, liquid", model.swings.period(HEAVING + 2) if both else math.nan, "s"),
        Readout("fastest", model.fastest(), "m/s"),
        Readout("a step, liquid", model.water.watch.median("step") if both else math.nan, "s"),
    ]  # fmt: skip


def _degrees(angle: float) -> float:
    """-180 to 180; NaN stays NaN."""
    turned = math.degrees(angle)
    return turned - 360.0 * math.floor(turned / 360.0 + 0.5) if math.isfinite(turned) else math.nan


def nearest_stable(model: FloatingWorld, angle: float) -> float:
    """rad, of the stable pose next to an angle; NaN where there is none."""
    if model.pinned():
        lean = exact.hinged_plank_angle(
            PLANK, min(float(model.parameters.weight), 0.999), model.hinge_depth()
        )
        return math.copysign(lean, angle)
    gaps = [abs(_degrees(one.angle - angle)) for one in model.curve.poses if one.stable]
    stable = [one.angle for one in model.curve.poses if one.stable]
    return stable[gaps.index(min(gaps))] if gaps else math.nan


def roll_reckoned(model: FloatingWorld, height: float) -> float:
    """s: 2 pi sqrt((I + added)/(m g GM)), of a small roll; NaN where it does not float upright."""
    floater = model.floater
    if height <= 0.0 or model.pinned() or floater.mass >= DENSITY * floater.area:
        return math.nan
    inertia = floater.inertia + float(model.law.body.pose[ROLL])
    return math.tau * math.sqrt(inertia / (floater.mass * float(model.parameters.gravity) * height))


def heave_reckoned(model: FloatingWorld, width: float) -> float:
    """s: 2 pi sqrt((m + added)/k), k = rho g b W/(W - b) in a tank of width W."""
    tank = model.content.tank[0]
    if not 0.0 < width < tank or model.pinned():
        return math.nan
    mass = model.floater.mass + float(model.law.body.pose[HEAVE])
    return exact.tank_heave_period(width, tank, mass, DENSITY, float(model.parameters.gravity))


def saved(model: FloatingWorld) -> FloatingContent:
    """As it is now: the outline, and where ballast lies."""
    outline = tuple((float(x), float(y)) for x, y in model.drawn)
    given, x, y = model.lead_at.tolist()
    changed: FloatingContent = msgspec.structs.replace(
        model.content, outline=outline, ballast_at=(x, y) if given else None
    )
    return changed


def hearing(model: FloatingWorld) -> Hearing | None:
    """Water in motion rushes."""
    if not model.parameters.both:
        return None
    moving, _ = model.water.liquid.energy()
    loud = math.sqrt(min(moving / LOUDEST, 1.0))
    return Hearing("liquid", model.time, (), (Steady("hiss", 0.25 * loud),)) if loud > 0.02 else None
