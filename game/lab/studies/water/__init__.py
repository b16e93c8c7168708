"""Water: dams, rings on a pond, a tank that sloshes."""
