"""A sea that goes to the horizon: cuts through its waves, the tile of its short waves, its pixels."""
