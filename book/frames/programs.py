"""Programs that students write on chains of frames."""

from book import things
from book.frames.exercises import (
    ONLY_HAND,
    POSE,
    T_bc_kept,
    no_inverse,
    numbers_of,
    same_order,
    shifted_back,
    unturned_shift,
)
from book.frames.formulas import (
    bc_turn,
    bc_x,
    bc_y,
    db_turn,
    db_x,
    db_y,
    de_turn,
    de_x,
    de_y,
)
from courseware.programs.program import Program
from robokin import frames

DB, BC, DE = (db_x, db_y, db_turn), (bc_x, bc_y, bc_turn), (de_x, de_y, de_turn)
AT_ONE_PLACE = {
    "the hand at the origin of b": dict.fromkeys(BC, 0.0),
    "the platform at the origin of d": dict.fromkeys(DB, 0.0),
    "nothing turned": {bc_turn: 0.0, db_turn: 0.0, de_turn: 0.0},
}


def of_matrices(formula):
    """Return a formula of poses as matrices as one of poses [x, y, turn], with such an answer."""
    return lambda *poses: numbers_of(formula(*(frames.se2(*pose) for pose in poses)))


def along_d(db, bc):
    """Return the poses added up, as if b were not turned."""
    return db + bc


def turned_backwards(db, bc):
    """Return c seen from d with b turned the wrong way."""
    x, y, _ = numbers_of(frames.compose(frames.se2(*db[:2], -db[2]), frames.se2(*bc)))
    return [x, y, db[2] + bc[2]]


def to_world(db):
    """Return d seen from b with −R p in place of −Rᵀp."""
    x, y = frames.transform(frames.se2(0, 0, db[2]), -db[:2])
    return [x, y, -db[2]]


def way_there(db):
    """Return d seen from b with Rᵀp in place of −Rᵀp."""
    x, y, turn = numbers_of(frames.inverse(frames.se2(*db)))
    return [-x, -y, turn]


def hand(pose, look=""):
    """Draw a gripper, whose x axis goes between its fingers."""
    return things.arm(pose, (0,), (0.25,), base="", look=look)


def draw_joined(right, answer, db, bc):
    given = things.camera_above((0, 0, 0), "ghost"), things.platform(db, look="ghost")
    return *given, hand(right), hand(answer, "wrong")


def draw_back(right, answer, db):
    return (
        things.platform((0, 0, 0), look="ghost"),
        things.camera_above(right),
        things.camera_above(answer, "wrong"),
    )


def draw_object(right, answer, bc, db, de):
    return hand((0, 0, 0), "ghost"), things.parcel(right), things.parcel(answer, look="wrong")


JOINED = '''\
def joined(db, bc):
    """Return the pose of c seen from d, [x, y, turn].

    db: b seen from d; bc: c seen from b. A pose is an array of x and y in m
    and the turn in rad.
    """
    ...
'''

frames_p1 = Program(
    "frames-p1",
    title="Two poses in a row",
    text="The frame b is seen from d, and c is seen from b. How is c seen from d? Try it without "
    "matrices: a sine and a cosine are enough. Whole turns in the answer do not matter.",
    starter=JOINED,
    symbols=(*DB, *BC),
    arguments=lambda *numbers: (numbers[:3], numbers[3:]),
    specials={
        "b not turned": {db_turn: 0.0},
        "b at the origin of d": {db_x: 0.0, db_y: 0.0},
        "c at the origin of b": {bc_x: 0.0, bc_y: 0.0},
        "beyond half a turn": {db_turn: 3.0, bc_turn: 2.0},
    },
    answer=POSE,
    right=of_matrices(frames.compose),
    picture=draw_joined,
    extent=0.3,
    likely_slips={
        "when x and y are added although the axes of b are turned": along_d,
        "with the two poses in the opposite order": of_matrices(lambda db, bc: bc @ db),
        "with the sine of the wrong sign: c is turned about b by minus its turn": turned_backwards,
    },
    hints=(
        "Draw it: from the origin of d to that of b, and on to c. Along which axes are the x and "
        "the y of the second pose measured?",
        "The second pose is measured along the axes of b. Turn its x and y by the turn of b, then "
        "add the place of b. The two turns add up.",
        "x = x_db + x_bc cos θ_db − y_bc sin θ_db. In y stand x_bc sin θ_db and y_bc cos θ_db.",
    ),
    solution="""\
def joined(db, bc):
    (x_db, y_db, turn_db), (x_bc, y_bc, turn_bc) = db, bc
    c, s = np.cos(turn_db), np.sin(turn_db)
    x, y = x_db + x_bc * c - y_bc * s, y_db + x_bc * s + y_bc * c
    return np.array([x, y, turn_db + turn_bc])
""",
)

SEEN_BACK = '''\
def seen_back(db):
    """Return the pose of d seen from b, [x, y, turn].

    db: b seen from d. A pose is an array of x and y in m and the turn in rad.
    """
    ...
'''

frames_p2 = Program(
    "frames-p2",
    title="A pose, seen from the other end",
    text="The camera d sees the platform b. How does the platform see the camera? Return its "
    "place, along the axes of the platform, and its turn.",
    starter=SEEN_BACK,
    symbols=DB,
    arguments=lambda *db: (db,),
    specials={
        "not turned": {db_turn: 0.0},
        "at the same place": {db_x: 0.0, db_y: 0.0},
        "straight ahead": {db_y: 0.0, db_turn: 0.0},
    },
    answer=POSE,
    right=of_matrices(frames.inverse),
    picture=draw_back,
    extent=0.3,
    wrong={unturned_shift: of_matrices(shifted_back)},
    likely_slips={
        "with −R p in place of −Rᵀp": to_world,
        "with Rᵀp in place of −Rᵀp": way_there,
        "for b as d sees it: nothing is turned back": lambda db: db,
    },
    hints=(
        "In which direction is the platform turned, seen from the camera? And the camera, seen "
        "from the platform?",
        "The way back is −x and −y, but these are measured along the axes of the camera. Turn "
        "them to the axes of the platform, by −θ.",
        "Turned by −θ, the way back has the first number −x cos θ − y sin θ.",
    ),
    solution="""\
def seen_back(db):
    x, y, turn = db
    c, s = np.cos(turn), np.sin(turn)
    return np.array([-x * c - y * s, x * s - y * c, -turn])
""",
)

FOR_HAND = '''\
def for_hand(bc, db, de):
    """Return the pose of the object e seen from the hand c, [x, y, turn].

    bc: c seen from b; db: b seen from d; de: e seen from d. A pose is an
    array of x and y in m and the turn in rad.
    """

    def matrix(x, y, t):
        c, s = np.cos(t), np.sin(t)
        return np.array([[c, -s, x], [s, c, y], [0, 0, 1]])

    T_bc, T_db, T_de = matrix(*bc), matrix(*db), matrix(*de)
    T_dc_inverted = np.linalg.inv(T_db) @ np.linalg.inv(T_bc)
    T_ce = T_dc_inverted @ T_de
    return np.array([*T_ce[:2, 2], np.arctan2(T_ce[1, 0], T_ce[0, 0])])
'''

frames_p3 = Program(
    "frames-p3",
    title="Mend it: the object for the hand",
    text="The camera d sees the platform b and the object e, and the platform sees the hand c. "
    "This function is to return the object as the hand sees it. It is wrong. Find the mistake and "
    "mend it.",
    starter=FOR_HAND,
    symbols=(*BC, *DB, *DE),
    arguments=lambda *numbers: (numbers[:3], numbers[3:6], numbers[6:]),
    specials=AT_ONE_PLACE,
    answer=POSE,
    right=of_matrices(lambda bc, db, de: frames.inverse(bc) @ frames.inverse(db) @ de),
    picture=draw_object,
    extent=0.3,
    wrong={
        no_inverse: of_matrices(lambda bc, db, de: db @ bc @ de),
        unturned_shift: of_matrices(lambda bc, db, de: shifted_back(bc) @ shifted_back(db) @ de),
        same_order: of_matrices(lambda bc, db, de: frames.inverse(db) @ frames.inverse(bc) @ de),
        T_bc_kept: of_matrices(lambda bc, db, de: bc @ frames.inverse(db) @ de),
    },
    likely_slips={ONLY_HAND: of_matrices(lambda bc, db, de: frames.inverse(bc) @ db @ de)},
    hints=(
        "Read the letters of the product from left to right. Where do two that meet differ?",
        "T_ce must begin with c and end with e. Write the letters of each inverse below it: the "
        "inverse of T_db is T_bd.",
        "T_dc is T_db T_bc. To undo two steps, undo the last one first.",
    ),
    solution=FOR_HAND.replace(
        "np.linalg.inv(T_db) @ np.linalg.inv(T_bc)", "np.linalg.inv(T_bc) @ np.linalg.inv(T_db)"
    ),
)
