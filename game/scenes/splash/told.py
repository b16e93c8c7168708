"""What the splash tells: readouts beside theory, places for stories, names, sounds; its hand."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementary
from game.scenes.splash.measures import surface_length
from game.scenes.splash.parameters import HIGH, WIDE
from game.scenes.splash.world import APART, BUBBLE, MINNAERT, SPLASH, SplashWorld
from game.stage import Comparison, Hearing, Readout
from game.ui.sound import BUBBLES
from game.worlds.hands.hand import Hand, Use
from game.worlds.hearing import ROOM

TENSION = 0.0728  # N/m: of water with air, at 20 °C
GAUGE = 0.62  # m: where the height of ripples is read
LOUD = 1500.0  # W/m of blows that roar as loud as can be
HAND_RATE = 30.0  # 1/s: speed of stirred water for a move of the hand
FIVE = (0.55, 0.75, 1.0, 0.75, 0.55)  # radii of five drops, of the chosen one
THROW, FASTEST, DRAGGED = 10.0, 9.0, 0.03  # 1/s: speed for the way of a drag; m/s at most; m at least
NAMES = {SPLASH: "splash"} | {BUBBLE + k: kind for k, kind in enumerate(BUBBLES)}
MM = 1000.0


def readouts(model: SplashWorld) -> list[Readout]:
    """Of the last drop: touch, energy, crater, crown, jet; then ripples, air, volume, the method."""
    model.water.measure()
    now, liquid, nan = model.measures, model.liquid, math.nan
    touched = math.isfinite(now.touched)
    moving, height = now.energies()
    full = max(liquid.count * liquid.area, 1e-12)
    lost = 100.0 * (1.0 - (moving + height) / now.energy) if touched else nan
    largest = float(now.pockets[:, 2].max()) if len(now.pockets) else 0.0
    bubble = liquid.grid.cell * math.sqrt(largest / math.pi)
    law, at = now.foreseen(), int(GAUGE / liquid.grid.cell)
    off = 100.0 * abs(now.highest / now.flies - 1.0) if now.time > now.lands else nan
    kept = 100.0 * now.momentum_now() / now.momentum if abs(now.momentum) > 1.0 else nan
    limit, since = now.limit(), now.time - now.touched
    return [
        Readout("drop", now.number), Readout("falls", int(now.falling)), Readout("touched", int(touched)),
        Readout("since it touched", since, "s"), Readout("speed", now.speed, "m/s"),
        Readout("drop's energy", now.own, "J/m"), Readout("energy", now.energy, "J/m"),
        Readout("kinetic energy", moving, "J/m"), Readout("potential energy", height, "J/m"),
        Readout("lost", lost, "%"), Readout("lost at once", now.lost_at_once, "%"),
        Readout("lifted", 100.0 * height / now.energy if touched else nan, "%"),
        Readout("surface energy", TENSION * max(surface_length(liquid) - WIDE, 0.0), "J/m"),
        Readout("crater", 100.0 * now.crater(), "cm"), Readout("deepest", 100.0 * now.deepest, "cm"),
        Readout("closes", int(math.isfinite(now.closes))), Readout("limit", 100.0 * limit, "cm"),
        Readout("of the limit", 100.0 * now.deepest / limit if limit else nan, "%"),
        Readout("sinks", 100.0 * now.sinks(), "%"),
        Readout("highest water", 100.0 * now.highest, "cm"), Readout("can fly", 100.0 * now.flies, "cm"),
        Readout("free flight error", off, "%"),
        Readout("jet", 100.0 * now.jet(), "cm"), Readout("jet's height", 100.0 * now.jet_most, "cm"),
        Readout("momentum", now.momentum_now(), "N s/m"), Readout("momentum brought", now.momentum, "N s/m"),
        Readout("momentum kept", kept, "%"),
        Readout("ripple", MM * float(now.last[-1][at] - now.last[-1].mean()), "mm"),
        Readout("ripple by law", MM * float(law[at] - law.mean()) if law is not None else nan, "mm"),
        Readout("likeness", 100.0 * now.likeness(), "%"),
        Readout("pockets", len(now.pockets)), Readout("bubble", MM * bubble, "mm"),
        Readout("tone", MINNAERT / bubble if bubble > 0.0 else nan, "Hz"),
        Readout("volume error", 100.0 * (liquid.wet_area() / full - 1.0), "%"),
        Readout("worst volume error", 100.0 * now.worst, "%"),
        Readout("part steps", model.water.parts),
        Readout("a step", model.water.watch.median("step"), "s"),
    ]  # fmt: skip


def targets(model: SplashWorld) -> dict[str, Point]:
    """The drop while it falls, the place where it came down, crown, crater, jet."""
    now, nothing = model.measures, (0.5 * WIDE, float(model.parameters.depth))
    x = now.at if math.isfinite(now.at) else nothing[0]
    drop = model.liquid.places[now.first :]
    level = now.level if now.level > 0.0 else nothing[1]
    return {
        "drop": (float(drop[:, 0].mean()), float(drop[:, 1].mean())) if len(drop) else nothing,
        "place": (x, level), "crater": (x, level - 0.5 * max(now.deepest, 0.0)),
        "jet": (x, level + 0.5 * max(now.jet_most, 0.0)), "gauge": (GAUGE, level),
    }  # fmt: skip


def sizes(model: SplashWorld) -> dict[str, float]:
    """Of the drop, of the crater, of the jet, m."""
    now = model.measures
    return {
        "drop": 2.0 * now.radius if math.isfinite(now.radius) else 0.0,
        "crater": now.deepest, "jet": now.jet_most,
    }  # fmt: skip


def charts(model: SplashWorld) -> dict[str, Comparison]:
    """Depths of all craters in radii of their drops over the Froude number, beside the limit by energy."""
    points = np.array(model.measures.craters, dtype=np.float64).reshape(-1, 2)
    froude = np.linspace(0.0, max(35.0, float(points[:, 0].max(initial=0.0))), 60)
    law = np.stack([froude, np.cbrt(0.75 * math.pi * froude)], axis=1)
    both = ("measured", "limit")
    return {"craters": Comparison(points, law, both, "radii", "Froude number U² / (g a)", "", single=True)}


def names(model: SplashWorld) -> list[tuple[Point, str]]:
    """Crater, jet and pockets of air by what is measured."""
    now, places, cell = model.measures, targets(model), model.liquid.grid.cell
    found = []
    if math.isfinite(now.touched):
        found.append((places["crater"], f"crater {100.0 * now.crater():.0f} cm"))
    else:
        found.append((places["place"], f"water {100.0 * places['place'][1]:.0f} cm deep"))
    for x, y, size in now.pockets.tolist():
        tone = MINNAERT / (cell * math.sqrt(size / math.pi))
        found.append((((x + 0.5) * cell, (y + 0.5) * cell), f"air, {tone:.0f} Hz"))
    return found


def hearing(model: SplashWorld) -> Hearing:
    """Blows, bubbles as they close, and the roar of water that breaks."""
    half = 0.5 * WIDE
    steady = (ROOM, *model.roar.heard(LOUD, half, half))
    return Hearing("splash", model.time, model.heard.sounds(NAMES, half, half), steady)


def let_go(model: SplashWorld, name: str) -> str:
    """What a key does; why it could not, or ""."""
    middle, apart = 0.5 * WIDE, APART * float(model.parameters.size)
    if name == "calm":
        model.calm()
    elif name == "foresee":
        model.foresee()
    elif name == "five":
        return model.let_go([middle + k * min(1.1 * apart, 0.5) for k in range(-2, 3)], FIVE)
    else:
        return model.let_go([middle] if name == "drop" else [middle - apart, middle + apart])
    return ""


def thrown(hand: Hand) -> Point | None:
    """m/s that a drag gives to the drop in the hand; None: it is not dragged."""
    if hand.start is None or elementary.dist(hand.start, hand.at) < DRAGGED:
        return None
    along, up = THROW * (hand.at[0] - hand.start[0]), THROW * (hand.at[1] - hand.start[1])
    share = min(1.0, FASTEST / elementary.length(along, up))
    return share * along, share * up


def _let_fall(hand: Hand) -> str:
    """A drop from where the button went down: as the parameters say, or as it is thrown."""
    start, speed = hand.start or hand.at, thrown(hand)
    return str(hand.model.drop_at(start) if speed is None else hand.model.throw(start, speed))


def _stir(hand: Hand) -> str:
    fast = HAND_RATE * hand.moved[0], HAND_RATE * hand.moved[1]
    hand.model.water.stir(hand.at, fast, float(hand.parameters.size))
    return ""


def splash_hand(model: SplashWorld) -> Hand:
    """The left button uses the tool, the right one lets a drop go."""
    uses = {"drop": Use(release=_let_fall), "stir": Use(move=_stir)}
    return Hand(model, uses, (0.0, 0.0), (WIDE, HIGH), right="drop")
