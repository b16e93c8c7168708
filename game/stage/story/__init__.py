"""Stories: a scene that plays itself by a script, which is data, and that a person may take over."""
