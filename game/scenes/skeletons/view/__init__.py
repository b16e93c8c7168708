"""How figures, skins and chains are drawn."""
