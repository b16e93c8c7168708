"""What a cue table is furnished with: the colour and speed of its cloth, and how tight its pockets are."""
