"""What a story names, measures and marks on the billiard table."""
