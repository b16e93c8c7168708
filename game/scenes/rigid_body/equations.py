"""The equations on the help page of the rigid body."""

from __future__ import annotations

from game.stage import Equation

EQUATIONS = (
    Equation(
        "Motion",
        r"\dot{\v{x}} = \v{P} / m,  \dot{\v{P}} = \v{f},  \dot{\v{L}} = \v{\tau}",
        "Newton, Euler",
    ),
    Equation("Quaternion", r"\dot{q} = \frac{1}{2} (0, \v{\omega}) q", "Hamilton"),
    Equation("Spin", r"\v{\omega} = J^{-1} \v{L},  J = R I R^T", "Baraff 1997"),
    Equation(
        "Offset theorem", r"I = \sum \frac{2}{5} m r^2 E + m (d^2 E - \v{d} \v{d}^T)", "Huygens, Steiner"
    ),
    Equation(
        "Accelerations",
        r"\v{a} = \v{f} / m,  \v{\alpha} = J^{-1} (\v{\tau} - \v{\omega} \times \v{L})",
        "",
    ),
    Equation("Explicit Euler", r"q_{n+1} = q_n + \frac{h}{2} (0, \v{\omega}_n) q_n", "L and P as well"),
    Equation(
        "Semi-implicit Euler",
        r"\v{L}_{n+1} = \v{L}_n + h\v{\tau},  \v{\omega} = J_n^{-1} \v{L}_{n+1}",
        "q as above",
    ),
    Equation(
        "Exponential map",
        r"q_{n+1} = (\cos \frac{h\omega}{2}, \sin \frac{h\omega}{2} \, \v{\omega}/\omega) \, q_n",
        "turns by all of h ω",
    ),
    Equation(
        "Midpoint",
        r"q_{n+1} = \exp(\frac{h}{2} \v{\omega}_{n+1/2}) \, q_n",
        "spin of half an exponential step",
    ),
    Equation("Runge-Kutta 4", r"q_{n+1} = q_n + \frac{h}{6} (k_1 + 2 k_2 + 2 k_3 + k_4)", "Kutta 1901"),
    Equation(
        "Implicit gyroscopic",
        r"I (\v{\omega}_{n+1} - \v{\omega}_n) + h \v{\omega}_{n+1} \times I \v{\omega}_{n+1} = 0",
        "one Newton step; Catto 2015",
    ),
    Equation(
        "Splitting",
        r"q_{n+1} = q_n R_1(\frac{h}{2}) R_2(\frac{h}{2}) R_3(h) R_2(\frac{h}{2}) R_1(\frac{h}{2})",
        "R about the body's axes; Reich 1994",
    ),
    Equation(
        "Exact (Jacobi)",
        r"I_1 \dot{\omega}_1 = (I_2 - I_3) \omega_2 \omega_3",
        "and cyclic; by cn, sn, dn",
    ),
    Equation(
        "Euler of ω, body frame",
        r"\v{\omega}_{n+1} = \v{\omega}_n + h I^{-1} (\v{\tau} - \v{\omega}_n \times I \v{\omega}_n)",
    ),
    Equation(
        "Euler of ω, world frame",
        r"\v{\omega}_{n+1} = \v{\omega}_n + h J^{-1} (\v{\tau} - \v{\omega}_n \times \v{L}_n)",
    ),
    Equation(
        "Energy of rotation",
        r"E = \frac{1}{2} \v{\omega} \cdot \v{L} \le \frac{L^2}{2 I_1}",
        "at equal L",
    ),
    Equation(
        "Wobble about the middle axis",
        r"\omega_2 \sqrt{\frac{(I_2 - I_1)(I_3 - I_2)}{I_1 I_3}}",
        "growth, 1/s",
    ),
)
