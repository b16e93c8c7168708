"""Balls that leave the slate: jump shots and masse, in three dimensions, from event to event.

What is neglected: drag and lift of the air. A ball in the air is never pushed by two others at once: its
contacts are of two balls each, one after the other. Two balls which both lie on the slate do not lift each
other by friction.
"""
