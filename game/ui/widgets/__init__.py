"""Bars, pages, messages and buttons around a scene."""
