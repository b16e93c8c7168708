"""x"""

skinning_study = None
