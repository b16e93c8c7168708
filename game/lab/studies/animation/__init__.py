"""Studies of animation: key-frames, skinning, inverse kinematics."""
