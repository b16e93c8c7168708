"""The cloth and the yard behind it, as they are painted."""
