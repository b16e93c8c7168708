"""What can be chosen about detection on a budget."""

from __future__ import annotations

from game.stage import Choice, Param, Parameters, Toggle

OF_PICTURE = ("circles", "horns", "queue", "budget", "grip", "first", "second")
CIRCLES = ("reached", "tree", "none")


class SpaceTimeParameters(Parameters):
    """The budget, the bound, the bodies, and what is shown."""

    budget = Param(1500, 0, 4000, whole=True, group="Detection", label="Tests per step",
                   help="after so many the answer is what is known by then")  # fmt: skip
    bound = Param(12.0, 0.0, 100.0, unit="m/s²", group="Detection", label="Bound of acceleration",
                  help="no body is accelerated by more between impacts, whatever pulls it")  # fmt: skip
    gravity = Param(0.0, 0.0, 20.0, unit="m/s²", group="Motion", help="downwards; within the bound")
    restitution = Param(0.9, 0.0, 1.0, group="Motion", help="of impacts with bodies and walls")
    grip = Param(60.0, 1.0, 1000.0, unit="1/s²", log=True, group="Motion", label="Hand",
                 help="how stiffly it pulls; it obeys the bound")  # fmt: skip
    count = Param(12, 2, 40, whole=True, group="Motion", rebuild=True, label="Bodies",
                  help="where a level has none of its own")  # fmt: skip
    step_length = Param(1.0 / 240.0, 1.0 / 2000.0, 1.0 / 30.0, unit="s", log=True, group="Motion",
                        label="Time step")  # fmt: skip
    first = Param(1, 1, 40, whole=True, group="Shown", label="First body", help="of the two looked at")
    second = Param(2, 1, 40, whole=True, group="Shown", label="Second body", help="of the two looked at")
    circles = Choice("reached", CIRCLES, labels=("That are left", "Of the two bodies", "None"),
                     group="Shown", help="at the end of the step's budget")  # fmt: skip
    horns = Toggle(True, group="Shown", help="space-time bounds of the two, up to when they may touch")
    queue = Toggle(True, group="Shown", help="the next possible times of contact")
