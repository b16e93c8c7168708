"""Shots whose impacts meet a given beat: what is heard of a shot, and the search for one on time."""
