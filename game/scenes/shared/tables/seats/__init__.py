"""Who sits at the table: the cue is handed from one person to the other."""
