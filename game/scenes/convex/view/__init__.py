"""How the V-Clip and GJK scenes are drawn."""
