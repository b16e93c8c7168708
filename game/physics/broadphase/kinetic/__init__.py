"""A kinetic sweep over velocity-aligned discrete oriented polytopes."""
