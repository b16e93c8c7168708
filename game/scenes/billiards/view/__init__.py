"""How the billiard game is drawn: the table, the stroke that is aimed, and the instruments round them."""
