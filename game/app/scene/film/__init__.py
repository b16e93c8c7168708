"""Films made while a scene is in play: of what comes from now on, and of the last ten seconds."""
