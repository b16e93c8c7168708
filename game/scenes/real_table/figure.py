"""The help figure: samples, the computed path, and the residual between the two."""

from __future__ import annotations

from game.ui.canvas.pen import Pen

TRACK = ((28.0, 150.0), (64.0, 128.0), (102.0, 106.0), (142.0, 86.0), (184.0, 68.0), (228.0, 54.0))
PATH = ((28.0, 150.0), (64.0, 129.5), (102.0, 111.0), (142.0, 97.0), (184.0, 87.0), (228.0, 82.0))


def draw_residuals(pen: Pen) -> None:
    """Six samples, the path of the best stroke, and what is left between them."""
    pen.line(PATH, "text1", 1.6)
    for k, (seen, computed) in enumerate(zip(TRACK, PATH, strict=True)):
        if k > 1:
            pen.line((seen, computed), "amber", 1.4)
        pen.disc(*seen, 3.4, "chalk")
        pen.disc(*computed, 2.2, "text1")
    pen.words("seen", TRACK[3][0] - 8.0, TRACK[3][1] - 16.0, "chalk", align="right")
    pen.words("computed", PATH[4][0] - 4.0, PATH[4][1] + 20.0, "text1", align="left")
    pen.formula("r_i", TRACK[5][0] + 18.0, 68.0, "amber")
    pen.formula(r"\sqrt{\frac{1}{m} r_1^2 + ... + \frac{1}{m} r_m^2}", 150.0, 178.0)
