"""What broad phases do, retold step by step for pictures and tests; searches keep no record."""
