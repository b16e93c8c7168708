"""The table as geometry: cushions, pockets, racks, what a straight path meets."""
