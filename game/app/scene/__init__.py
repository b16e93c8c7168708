"""The screen of a scene: loading, shell, pointer, files, study."""
