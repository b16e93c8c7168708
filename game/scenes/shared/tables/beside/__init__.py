"""What stands beside the table: figures of a stroke, rows, the coach."""
