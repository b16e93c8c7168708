"""Shots whose impacts meet a given beat: what is heard of a shot, and a search for one that is heard on time."""
