"""The table as geometry: cushions, pockets, racks, what lies in the way."""
