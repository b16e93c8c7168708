"""Names of the numbers that the exact table's kernels work on.

A shot is packed into plain float64 arrays, so that a kernel takes few arguments and a whole batch of shots
is one call. The names below are the columns of those arrays.
"""

from __future__ import annotations

# motion of a ball
STATIONARY, SPINNING, SLIDING, ROLLING, POCKETED, OFF_TABLE, AIRBORNE = range(7)
MOTIONS = ("stationary", "spinning", "sliding", "rolling", "pocketed", "off the table", "airborne")

# events
BALL_BALL, BALL_CUSHION, BALL_JAW, BALL_POCKET = range(4)
SLIDING_ROLLING, ROLLING_STATIONARY, ROLLING_SPINNING, SPINNING_STATIONARY = range(4, 8)
BALL_SLATE, BALL_RAIL_TOP, BALL_OFF = range(8, 11)  # a bounce, on the bed or the rails; the table left
EVENTS = (
    "ball-ball",
    "ball-cushion",
    "ball-jaw",
    "ball-pocket",
    "sliding-rolling",
    "rolling-stationary",
    "rolling-spinning",
    "spinning-stationary",
    "ball-slate",
    "ball-rail-top",
    "ball-off-table",
)
NO_EVENT = -1

# a ball as it comes in and goes out: columns of balls (n, 11)
IN_X, IN_Y, IN_VX, IN_VY, IN_WX, IN_WY, IN_WZ, IN_RADIUS, IN_MASS, IN_MOTION = range(10)
IN_CLEAR = 10  # 1: within the free rectangle, inset by its radius, only the rails can be reached; 0: not so
IN_COLUMNS = 11
# of a shot in which balls may leave the slate: how high the ball is above where it lies on it, m, and its
# vertical speed, m/s; columns of balls (n, 13)
IN_Z, IN_VZ = range(11, 13)
FLIGHT_IN_COLUMNS = 13

# what holds for the whole shot: physics (22,)
GRAVITY, SLIDING_FRICTION, ROLLING_FRICTION, SPINNING_FRICTION = range(4)
BALL_RESTITUTION, BALL_LAW, BALL_FRICTION, BALL_LIMIT = range(
    4, 8
)  # limit: share of the impulse, see `contacts`
CUSHION_LAW, CUSHION_RESTITUTION, CUSHION_FRICTION, CUSHION_HEIGHT = range(8, 12)
FREE_LEFT, FREE_RIGHT, FREE_LOWER, FREE_UPPER = range(12, 16)  # m; the straight rails' noses
MIDDLE_X, MIDDLE_Y = range(
    16, 18
)  # m; the table's middle, which is the kernels' origin, in the table's frame
RESTITUTION_FALL, CUSHION_COMPLIANCE = range(18, 20)  # s/m; share, see `cushion_stronge_2000`
SLATE_RESTITUTION, CUSHION_HOP = range(20, 22)  # see `flight`
PHYSICS_COLUMNS = 22

# cushions as kernels see them (c, 7): the table's six columns, and which free edge the nose lies on
FROM_X, FROM_Y, TO_X, TO_Y, NORMAL_X, NORMAL_Y, EDGE = range(7)
NO_EDGE = -1.0

# rows of the working array of floats, state (rows, n): the state at the ball's last event, and what it plans
TIME, X, Y, VX, VY, WX, WY, WZ, AX, AY = range(10)
RADIUS, MASS, PHASE_END, OWN_TIME, PAIR_TIME, NEXT_TIME, RAIL_TIME, CLEAR = range(10, 18)
PUSH_X, PUSH_Y, TURN_X, TURN_Y, TURN_Z, VALENCE, INVERSE_MASS = range(18, 25)  # scratch of `cluster`
Z, VZ = range(25, 27)  # of `flight` only: height above where the ball lies on the slate, vertical speed
FLOAT_ROWS = 27

# rows of the working array of integers, modes (rows, n)
MOTION, OWN_EVENT, OWN_ELEMENT, PARTNER, RAIL_COUNT = range(5)
MEMBER, MARK = range(5, 7)  # balls that an event changes; space for `cluster`
AIR_COUNT = 7  # of `flight` only: contacts since the ball was on the slate last
INTEGER_ROWS = 8

# planes of the working array of pairs, pairs (planes, n, n): when two balls meet next and met last (s), and
# how often they have met in quick succession
MEET, MET, REPEATS = range(3)
PAIR_PLANES = 3

# contacts of one moment: rows of ends (rows, m), the balls, and of forces (rows, m)
FIRST, SECOND = range(2)
IMPULSE, RUBBED, PX, PY, PZ, RESTITUTION, JOINT_IMPULSE = range(7)
END_ROWS, FORCE_ROWS = 2, 7

# a stretch of one ball's path between two of its events: columns of segments (s, 12)
SEG_TIME, SEG_X, SEG_Y, SEG_VX, SEG_VY, SEG_WX, SEG_WY, SEG_WZ, SEG_AX, SEG_AY, SEG_BALL, SEG_MOTION = range(
    12
)
SEGMENT_COLUMNS = 12
SEG_Z, SEG_VZ = range(12, 14)  # of a shot in which balls may leave the slate: (s, 14)
FLIGHT_SEGMENT_COLUMNS = 14

# how a shot went: columns of the log's ends (m, 6), and what STATUS says
EVENTS_START, EVENTS_END, SEGMENTS_START, SEGMENTS_END, STATUS, END_TIME = range(6)
FINISHED, EVENT_LIMIT, BUFFER_FULL, NOT_FINITE = range(4)

CLOSING_SPEED = 1e-12  # m/s; slower approaches are rounding. Over 20 s they amount to 2e-11 m, under 1e-9 R
LANDING_SPEED = 0.02  # m/s; a ball that would rise more slowly stays down: it would hop 20 micrometres
CONTACT_GAP = 1e-13  # m; balls so near are in contact, for the joint solution of simultaneous contacts
NEVER = 1e308  # s; later than any event
AT_REST = 1e300  # s; in a table of contact times: in contact, but not about to collide
