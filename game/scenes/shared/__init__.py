"""What two or more scenes use."""
