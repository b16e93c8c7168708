"""What the window can show: menu, scene, and the cards that lie over them."""
