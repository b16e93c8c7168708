"""(In work by a colleague since 01:05: the stepped model and the lecture adapter, models "stepped" and "lecture" of simulate().)"""
