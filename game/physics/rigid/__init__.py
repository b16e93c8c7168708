"""One rigid body in three dimensions: quaternions, mass and inertia, integrators."""

from game.physics.rigid.body import RigidBody
from game.physics.rigid.effects import PUSHES, ROTATION, WINDOW
from game.physics.rigid.free_top import FreeTop
from game.physics.rigid.mass import inverse_moments, mass_properties, principal_axes, sphere_masses
from game.physics.rigid.motion import METHODS, ORDERS
from game.physics.rigid.quaternion import (
    quaternion_conjugate,
    quaternion_from_axis_angle,
    quaternion_from_matrix,
    quaternion_from_rotation_vector,
    quaternion_multiply,
    quaternion_normalized,
    quaternion_rotate,
    quaternion_to_matrix,
    quaternion_to_rotation_vector,
    turn_between,
)

__all__ = [
    "METHODS",
    "ORDERS",
    "PUSHES",
    "ROTATION",
    "WINDOW",
    "FreeTop",
    "RigidBody",
    "inverse_moments",
    "mass_properties",
    "principal_axes",
    "quaternion_conjugate",
    "quaternion_from_axis_angle",
    "quaternion_from_matrix",
    "quaternion_from_rotation_vector",
    "quaternion_multiply",
    "quaternion_normalized",
    "quaternion_rotate",
    "quaternion_to_matrix",
    "quaternion_to_rotation_vector",
    "sphere_masses",
    "turn_between",
]
