"""Key-frames on a timeline (C01)."""
