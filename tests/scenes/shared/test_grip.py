"""What a hand at a table holds is a value that the stage's memory gives back as it was."""

from game.scenes.shared.tables import grip
from game.scenes.shared.tables.grip import NOTHING, Grip, Held
from game.stage import Part
from game.stage.states.memory import recall, remember


class Holder(Part):
    grip: Grip


def test_nothing_is_false_and_every_other_kind_is_true():
    assert not NOTHING
    assert all(bool(Grip(kind)) == (kind is not Held.NOTHING) for kind in Held)


def test_grips_of_one_kind_are_told_apart_by_name_and_number():
    held = [
        grip.button("undo"),
        grip.button("view"),
        grip.card(0),
        grip.card(1),
        grip.option(0),
        grip.ball(0),
    ]
    assert len(set(held)) == len(held)
    assert grip.option(2) == grip.option(2) and grip.option(2).number == 2


def test_what_is_held_comes_back_from_memory():
    for held in (NOTHING, grip.CUE, grip.ball(3), grip.button("replay")):
        holder = Holder()
        holder.grip = held
        memory = remember(holder)
        holder.grip = grip.ZONE
        recall(holder, memory)
        assert holder.grip == held and holder.grip.kind is held.kind and bool(holder.grip) == bool(held)
