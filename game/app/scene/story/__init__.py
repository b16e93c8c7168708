"""A story in the window: time bar, camera, words, take over and go on."""
