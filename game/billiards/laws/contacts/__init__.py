"""What happens in a contact: models that can be exchanged, each in its file with its source.

A model takes the working arrays of `game.billiards.laws.state`, changes velocity and spin of the balls in
contact, and nothing else. After a contact its balls slide.
"""

from __future__ import annotations

from typing import NamedTuple

# friction of ball on ball, as the kernels number it
NO_FRICTION, CONSTANT_FRICTION, ALCIATORE_FRICTION = range(3)


class BallModel(NamedTuple):
    """A ball-ball model: whether it restitutes fully, how it rubs, and what limits the friction.

    elastic: e = 1 whatever the table says. friction: number of the law. reference_limit: friction is limited
    by mu e |closing speed| instead of mu times the normal impulse, (1 + e)/2 |closing speed| for each unit.
    """

    elastic: bool
    friction: int
    reference_limit: bool

    def limit(self, restitution: float) -> float:
        """What friction takes for the normal impulse, as a share of that impulse."""
        return 2.0 * restitution / (1.0 + restitution) if self.reference_limit else 1.0


BALL_MODELS = {
    "elastic": BallModel(True, NO_FRICTION, False),
    "frictional": BallModel(False, CONSTANT_FRICTION, True),
    "frictional-alciatore": BallModel(False, ALCIATORE_FRICTION, True),
    "wallace-1988": BallModel(False, CONSTANT_FRICTION, False),
    "alciatore-2006": BallModel(False, ALCIATORE_FRICTION, False),
}

# ball on cushion or jaw, as the kernels number it; a mirror is restitution with e = 1
RESTITUTION, HAN_2005, MATHAVAN_2010, STRONGE_2000 = range(4)
CUSHION_MODELS = {
    "mirror": RESTITUTION,
    "restitution": RESTITUTION,
    "han-2005": HAN_2005,
    "mathavan-2010": MATHAVAN_2010,
    "stronge-2000": STRONGE_2000,
}
