"""Teaching levels in the window: the task at work, and one made of what is in play."""
