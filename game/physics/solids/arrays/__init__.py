"""What the world of solids lies in: bodies, shapes, contacts, rows, joints and the plan of their solve."""
