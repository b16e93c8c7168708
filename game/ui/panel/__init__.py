"""The panel of parameters, effects and actions beside a scene."""
