"""Studies of gas on a grid."""
