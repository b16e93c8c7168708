"""What broad phases do, retold step by step for pictures and tests; the searches themselves keep no record."""
