"""x"""

reaching_study = None
