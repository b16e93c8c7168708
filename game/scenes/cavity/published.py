"""What is known of the flow in a cavity, by Reynolds number and by Rayleigh number.

GHIA: tables I and II of Ghia, Ghia and Shin (1982, J. Comput. Phys. 48, 387), as printed: u on the vertical
centre line at HEIGHTS, v on the horizontal one at PLACES. Their extremes are grid values, 0.4 to 1.5 % low.
EXTREMES: least u, most v, least v on those lines by two discretisations, each extrapolated; at Re 100 and
1000 they agree with Botella and Peyret (1998, Computers & Fluids 27, 421): -0.2140424, -0.3885698. NUSSELT:
mean number on the hot wall, de Vahl Davis (1983), by two discretisations again.
"""

from __future__ import annotations

HEIGHTS = (
    0.0, 0.0547, 0.0625, 0.0703, 0.1016, 0.1719, 0.2813, 0.4531, 0.5, 0.6172, 0.7344, 0.8516, 0.9531, 0.9609,
    0.9688, 0.9766, 1.0,
)  # fmt: skip
GHIA_U = {
    100: (0.0, -0.03717, -0.04192, -0.04775, -0.06434, -0.10150, -0.15662, -0.21090, -0.20581, -0.13641,
          0.00332, 0.23151, 0.68717, 0.73722, 0.78871, 0.84123, 1.0),
    400: (0.0, -0.08186, -0.09266, -0.10338, -0.14612, -0.24299, -0.32726, -0.17119, -0.11477, 0.02135,
          0.16256, 0.29093, 0.55892, 0.61756, 0.68439, 0.75837, 1.0),
    1000: (0.0, -0.18109, -0.20196, -0.22220, -0.29730, -0.38289, -0.27805, -0.10648, -0.06080, 0.05702,
           0.18719, 0.33304, 0.46604, 0.51117, 0.57492, 0.65928, 1.0),
}  # fmt: skip
PLACES = (
    0.0, 0.0625, 0.0703, 0.0781, 0.0938, 0.1563, 0.2266, 0.2344, 0.5, 0.8047, 0.8594, 0.9063, 0.9453, 0.9531,
    0.9609, 0.9688, 1.0,
)  # fmt: skip
GHIA_V = {
    100: (0.0, 0.09233, 0.10091, 0.10890, 0.12317, 0.16077, 0.17507, 0.17527, 0.05454, -0.24533, -0.22445,
          -0.16914, -0.10313, -0.08864, -0.07391, -0.05906, 0.0),
    400: (0.0, 0.18360, 0.19713, 0.20920, 0.22965, 0.28124, 0.30203, 0.30174, 0.05186, -0.38598, -0.44993,
          -0.23827, -0.22847, -0.19254, -0.15663, -0.12146, 0.0),
    1000: (0.0, 0.27485, 0.29012, 0.30353, 0.32627, 0.37095, 0.33075, 0.32235, 0.02526, -0.31966, -0.42665,
           -0.51550, -0.39188, -0.33714, -0.27669, -0.21388, 0.0),
}  # fmt: skip
EXTREMES = {
    100: (-0.21404412, 0.17957535, -0.25380594),
    400: (-0.32873362, 0.30383682, -0.45406939),
    1000: (-0.38858877, 0.37697252, -0.52709346),
}
WHERE = {  # heights of least u, places of most and least v
    100: (0.45808521, 0.23697872, 0.81042966),
    400: (0.28002337, 0.2253048, 0.86221441),
    1000: (0.17169693, 0.15782565, 0.90924607),
}
NUSSELT = {1_000: 1.1177897, 10_000: 2.2448157}


def known_number(value: float, table: dict) -> int | None:
    """The number of a table that a value is, to 1e-6 of it; None for others."""
    return next((number for number in table if abs(value - number) <= 1e-6 * number), None)
