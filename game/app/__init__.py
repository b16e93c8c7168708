"""The program around the scenes: window, main loop, screens, settings, command line."""
