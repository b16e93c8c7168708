"""What levels say: entries that several scenes read and write."""
