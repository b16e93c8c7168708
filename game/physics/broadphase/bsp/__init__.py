"""A semi-adjusting BSP tree."""
