"""What a billiard ball looks like: colours, markings, lamps, digits. Shared by the kernel and its plain twin.

Frames: the screen's is x right, y up, z towards the viewer. In the ball's own, z runs through both numbers
and y is up as one reads them; the stripe of 9 to 15 lies round the y axis.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pygame

from game.ui.look.assets import asset
from game.ui.look.theme import (
    BALL_COLORS,
    BALL_WHITE,
    CAROM_COLORS,
    CAROM_SPOT,
    CUE_BALL_SPOT,
    SNOOKER_COLORS,
)

STRIPE = 0.60  # of the radius: beyond this height a striped ball is white
DISC = 0.55  # radius of the number disc, of the ball's
DISC_IN_TEXTURE = 0.54  # radius of the number disc, of its texture's side: the rim lies just outside
SPOT = 0.28  # radius of the cue ball's six spots, of the ball's
RIM = 0.998  # beyond this the normal is that of the rim
SOFTEST = 0.35  # least cosine by which edges of markings are softened

# Two long lamps over the table, in metres from its middle: (x, y), half its sides, height, strength.
LAMPS = np.array(((0.0, 0.62, 0.95, 0.11, 1.05, 0.80), (0.0, -0.95, 0.80, 0.07, 1.25, 0.26)))
AMBIENT = 0.16
FROM_ABOVE = 0.14
DIFFUSE = 0.92
WRAP = 0.25  # light reaches a little past the terminator
BOUNCE = 0.41  # of the felt's colour, on the lower half
FRESNEL = 0.045  # of glossy resin, seen straight on (Schlick 1994)
GLARE = 11.0  # radiance of a lamp, strength 1, as white is 1
KNEE, SHOULDER = 0.70, 0.56  # light above the knee is compressed, so that white keeps its shape

# Shadows: full up to the inner, gone from the outer radius, in radii of the ball; opacity.
CONTACT_INNER, CONTACT_OUTER, CONTACT_SHADE = 0.42, 1.02, 0.45
CAST_INNER, CAST_OUTER, CAST_SHADE = 0.15, 1.30, 0.48
CAST_SHIFT = 1.1  # radii for each height of the lamp that it is off to the side

INK_STRENGTH = 1.3  # digits a few pixels high are printed bolder than they are
SMALLEST_TEXTURE, LARGEST_TEXTURE = 5, 256
NUMBERS = 16  # 0 is the cue ball
CAROM_WHITE, CAROM_YELLOW, CAROM_RED = range(16, 19)  # balls of carom, with spots and without a number
SNOOKER_RED = 19  # then yellow, green, brown, blue, pink and black: plain balls
KINDS = 26  # of balls


def _linear(color: pygame.Color) -> tuple[float, float, float]:
    """A colour squared: a cheap linear light."""
    return (color.r / 255.0) ** 2, (color.g / 255.0) ** 2, (color.b / 255.0) ** 2


BASE = np.array([_linear(color) for color in (*BALL_COLORS, *CAROM_COLORS, *SNOOKER_COLORS)])  # (26, 3)
WHITE = np.array(_linear(BALL_WHITE))
SPOT_INK = np.array(_linear(CUE_BALL_SPOT))
RED_BALL_INK = np.array(_linear(CAROM_SPOT))  # of the spots of the red ball
INK = np.array(_linear(pygame.Color("#15191E")))


def _tone(light: np.ndarray) -> np.ndarray:
    """Channels 0 to 255 of linear light: a soft shoulder, then the square root."""
    over = np.maximum(0.0, light - KNEE)
    soft = np.where(over > 0.0, KNEE + over / (1.0 + over / SHOULDER), np.maximum(light, 0.0))
    return np.rint(255.0 * np.sqrt(np.minimum(soft, 1.0)))


TONE_STEPS = 1600  # entries of the table for one unit of light
BRIGHTEST = 2.0
TONES = _tone((np.arange(int(BRIGHTEST * TONE_STEPS) + 1) + 0.5) / TONE_STEPS).astype(np.int64)


def toned(light: np.ndarray) -> np.ndarray:
    """Channels 0 to 255 (uint8) of linear light."""
    steps = np.clip(light, 0.0, BRIGHTEST) * TONE_STEPS
    return TONES[steps.astype(np.int64)].astype(np.uint8)


def texture_side(radius: float) -> int:
    """Side of the digit texture for a ball of that radius in px."""
    return min(LARGEST_TEXTURE, max(SMALLEST_TEXTURE, int(2.2 * radius + 0.5)))


@lru_cache(maxsize=64)
def digit_texture(number: int, side: int) -> np.ndarray:
    """Coverage (side, side) uint8 of a ball's number, [row, column], 6 and 9 underlined; 0 is empty."""
    if number == 0:
        return np.zeros((side, side), np.uint8)
    if not pygame.font.get_init():
        pygame.font.init()
    # drawn large and reduced, so that each size has its own best pixels; a zoom asks for many of them
    large = max(96, min(4 * side, 256), 2 * side)
    size = round(large * (0.92 if number < 10 else 0.74))
    font = pygame.font.Font(asset("fonts", "CaromDisplay-Bold.otf"), size)
    white = pygame.Color("white")
    ink = font.render(str(number), True, white)
    box = ink.get_bounding_rect()
    paper = pygame.Surface((large, large), pygame.SRCALPHA, 32)
    paper.fill((255, 255, 255, 0))
    lift = 0.05 * large if number in (6, 9) else 0.0
    left, top = round(0.5 * (large - box.w)), round(0.5 * (large - box.h) - lift)
    paper.blit(ink, (left - box.x, top - box.y))
    if number in (6, 9):
        width, height = round(0.42 * large), max(1, round(0.07 * large))
        paper.fill(white, (round(0.5 * (large - width)), top + box.h + round(0.05 * large), width, height))
    small = pygame.transform.smoothscale(paper, (side, side))
    coverage = pygame.surfarray.array_alpha(small).T.astype(float)
    return np.ascontiguousarray(np.minimum(255.0, INK_STRENGTH * coverage).astype(np.uint8))
