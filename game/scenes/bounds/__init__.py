"""Trees of oriented boxes (C08) and of capsules (C09)."""
