"""What scenes are made of beside their tale and picture: members that step, entries of levels, tools of the
hand, painting. A thing comes here when a second scene uses it.
"""
