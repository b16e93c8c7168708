"""What the V-Clip and GJK scenes compute: two polygons that move, and the query between them."""
