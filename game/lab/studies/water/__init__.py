"""Water: dams, and rings on a pond."""
