"""The pages of the papers on fluids of particles."""
