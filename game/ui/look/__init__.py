"""The look of the house: themes, fonts, measures, colours, icons, motion."""
