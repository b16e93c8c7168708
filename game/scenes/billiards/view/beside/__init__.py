"""What stands beside the table: log, map, practice record; and the map on the cloth."""
