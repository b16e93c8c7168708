"""Colours, polygons, rails, smoke and flames, as several scenes paint them."""
