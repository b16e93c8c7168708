"""Words and formulas: markup, formula layout, labels and where they find space."""
