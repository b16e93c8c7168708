"""Studies of air that flows past things."""
