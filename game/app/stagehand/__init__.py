"""A scene without a window: opened, filled from level or recording, drawn off screen."""
