"""What players of the ladder say at the table: a few words of each, by what has just happened."""

from __future__ import annotations

from typing import NamedTuple

# what a remark is about; "they": the person against whom it plays
RUN, OWN_RUN = "they score on", "scores on"
FOUL, MISSED = "they foul", "misses"
WON, LOST = "wins", "loses"
CAUSES = (RUN, OWN_RUN, FOUL, MISSED, WON, LOST)
# balls or points of a run from which on it is spoken of, and again after as many more
LONG_RUN = {"billiards": 4, "snooker": 20, "carom": 3}


class Happened(NamedTuple):
    """A stroke, as far as one speaks of it. by: who played it, 0 the person, 1 who speaks. run, run_before:
    of that player's visit. safe: nothing was to be scored. winner: of what has ended with it, else None.
    """

    by: int
    scored: bool
    foul: bool
    run: int
    run_before: int
    safe: bool = False
    winner: int | None = None


def cause_of(happened: Happened, family: str) -> str:
    """What a player says something about; empty if it keeps silent."""
    if happened.winner is not None:
        return WON if happened.winner == 1 else LOST
    if happened.foul:
        return FOUL if happened.by == 0 else ""
    if happened.scored:
        long = LONG_RUN[family]
        reached = happened.run // long > happened.run_before // long
        return ("", RUN if happened.by == 0 else OWN_RUN)[reached]
    return MISSED if happened.by == 1 and not happened.safe else ""


def remark_of(name: str, cause: str, number: int) -> str:
    """The words of a player of the ladder, in turn by the number of the stroke; empty for silence."""
    words = REMARKS.get(name, {}).get(cause, ())
    return words[number % len(words)] if words else ""


REMARKS: dict[str, dict[str, tuple[str, ...]]] = {
    "tom": {
        RUN: ("How do you do that?", "You make it look easy."),
        OWN_RUN: ("Did you see that? Another one!", "I should stop while it goes well."),
        FOUL: ("That happens to me all the time.", "So it is not only me."),
        MISSED: ("Oh. It was nearly in.", "My cue has a will of its own.", "Next time."),
        WON: ("I won? I won!",),
        LOST: ("Well played. Again?",),
    },
    "rocco": {
        RUN: ("I know luck when I see it.", "Bet you cannot do that again."),
        OWN_RUN: ("Fortune likes the brave.", "And no bet on it. Pity."),
        FOUL: ("Thank you kindly.", "I will take that."),
        MISSED: ("I would play it again.", "It was worth the try.", "Next time I bank it."),
        WON: ("Double or nothing?",),
        LOST: ("The next one is mine. I feel it.",),
    },
    "greta": {
        RUN: ("I should not have left you that.", "You see? I gave you too much."),
        OWN_RUN: ("Even I may score now and then.", "You left me no reason to play safe."),
        FOUL: ("Patience is a stroke, too.", "I can wait."),
        MISSED: ("I should have played safe.", "That is what comes of it."),
        WON: ("Slow, but sure.",),
        LOST: ("You waited longer than I did.",),
    },
    "ines": {
        RUN: ("Clean. I like that.", "You do not miss much today."),
        OWN_RUN: ("See it, play it.", "One more, and one more."),
        FOUL: ("Look where it goes afterwards.", "My turn, then."),
        MISSED: ("I had it. I really had it.", "The aim was good, I swear."),
        WON: ("One ball at a time, that is all.",),
        LOST: ("You missed less. That is the game.",),
    },
    "kenji": {
        RUN: ("You think of the next one. Good.", "One leads to the other."),
        OWN_RUN: ("The next one is the easy one.", "It is all in where it stops."),
        FOUL: ("Speed first, then the line.", "It happens."),
        MISSED: ("I was at the next ball already.", "Too far ahead in my mind."),
        WON: ("Each one led to the next.",),
        LOST: ("You left me nowhere to stand.",),
    },
    "marie": {
        RUN: ("Elegant.", "I could watch that all night."),
        OWN_RUN: ("Geometry, my friend.", "The table wants to help."),
        FOUL: ("Ask the cushions next time.", "A pity. It began well."),
        MISSED: ("The cushion had another opinion.", "A beautiful way to miss."),
        WON: ("The long way is the sure way.",),
        LOST: ("That was a pleasure to watch.",),
    },
    "sean": {
        RUN: ("Keep going. I would.", "Grand. Leave me something, will you?"),
        OWN_RUN: ("Sit down, this may take a while.", "Still in."),
        FOUL: ("You are letting me in.", "I will not say no."),
        MISSED: ("You are in. Make it count.", "Off the chair with you."),
        WON: ("One visit is all it takes.",),
        LOST: ("Grand playing. I never got back in.",),
    },
    "vera": {
        RUN: ("You have been practising.", "Go on. I want to see it."),
        OWN_RUN: ("Watch the cue ball, not the other.", "This is how it is done."),
        FOUL: ("I need no presents.", "That will cost you."),
        MISSED: ("Remember this. It is rare.", "Do not count on another."),
        WON: ("Come back when you have a plan.",),
        LOST: ("At last, somebody who can play.",),
    },
}
