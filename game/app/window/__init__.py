"""The window itself: frames, keys, gamepad, pictures, settings, how it ends."""
