"""Tracks as levels write them and views draw them."""
