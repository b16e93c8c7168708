"""Balls that leave the slate: jump shots and masse, in three dimensions, from event to event.

What is neglected: drag and lift of the air; that a ball in the air is pushed by two others at once (its
contacts are of two balls each, one after the other); that two balls which both lie on the slate lift each
other by friction.
"""
