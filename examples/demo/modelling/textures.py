"""The painted surfaces: tank shells, the floor, the sign."""

from .picture import Picture

YELLOW, BLACK, WHITE = (244, 190, 24), (32, 33, 36), (236, 238, 240)
SHELL = (232, 235, 238)  # also the tank's plain material: they must meet unseen
INK = (38, 44, 52)
TANKS = [("T1", "WATER", (38, 118, 196)), ("T2", "BRINE", (30, 148, 106)),
         ("T3", "ETHANOL", (208, 66, 48)), ("T4", "SODA", (236, 166, 26))]

# The floor is painted for this much ground, metres: x to the right, y up in the picture.
FLOOR_LOW, FLOOR_HIGH = (-4.4, -3.1), (4.4, 3.1)


def tank_shells():
    """One strip of 256 rows a tank, wrapped once round its shell; the middle of a strip looks
    out to the front, another label to the back."""
    picture = Picture(1024, 1024, SHELL)
    for index, (name, liquid, color) in enumerate(TANKS):
        top = 256 * index
        picture.rectangle(0, top + 176, 1024, top + 220, color)
        picture.rectangle(0, top + 226, 1024, top + 231, color)
        for middle in (0, 512, 1024):
            # A pixel is 3.56 mm wide and 4.3 mm high on the shell.
            picture.text(name, middle, top + 112, 84, INK, stretch=1.2, weight=0.17)
            picture.text(liquid, middle, top + 160, 26, INK, stretch=1.15, weight=0.17)
            picture.rectangle(middle - 90, top + 126, middle + 90, top + 129, color)
        for seam in (256, 768):
            picture.rectangle(seam, top, seam + 1, top + 256, (206, 210, 214))
    return picture


def floor():
    picture = Picture(1024, 720, (108, 114, 120))
    width = FLOOR_HIGH[0] - FLOOR_LOW[0]
    height = FLOOR_HIGH[1] - FLOOR_LOW[1]

    def column(x):
        return round((x - FLOOR_LOW[0]) / width * 1024)

    def row(y):
        return round((FLOOR_HIGH[1] - y) / height * 720)

    picture.grain(3, 4)
    for x in (-2.2, 0.0, 2.2):
        picture.rectangle(column(x), 0, column(x) + 2, 720, (88, 93, 99))
    for y in (-1.0, 1.0):
        picture.rectangle(0, row(y), 1024, row(y) + 2, (88, 93, 99))

    def hazard(left, top, right, bottom):
        picture.stripes(left, top, right, bottom, (BLACK, YELLOW), 10)

    def yellow(left, top, right, bottom):
        picture.rectangle(left, top, right, bottom, YELLOW)

    # The bund round the tanks, the arm's reach, the pallet's place, a walkway along the front.
    picture.rectangle(column(-3.45), row(2.35), column(3.45), row(0.55), (92, 104, 118))
    picture.frame(column(-3.45), row(2.35), column(3.45), row(0.55), 7, yellow)
    picture.rectangle(column(0.6), row(0.1), column(3.15), row(-2.1), (94, 98, 103))
    picture.frame(column(0.5), row(0.2), column(3.25), row(-2.2), 12, hazard)
    picture.frame(column(-3.2), row(-0.5), column(-1.6), row(-2.14), 7, yellow)
    picture.rectangle(column(-4.4), row(-2.52), column(4.4), row(-2.56), WHITE)
    picture.text("ROCINANTE", column(-0.1), row(-2.98), 36, (196, 201, 206), stretch=1.1)
    picture.text("PICK", column(-2.4), row(-2.05), 22, YELLOW, stretch=1.1)
    picture.text("INSPECT", column(1.55), row(-1.98), 24, YELLOW, stretch=1.1)
    return picture


def sign():
    picture = Picture(512, 128, (30, 78, 140))
    picture.frame(8, 8, 504, 120, 5,
                  lambda l, t, r, b: picture.rectangle(l, t, r, b, WHITE))
    picture.text("TANK FARM", 256, 94, 60, WHITE, stretch=0.82, weight=0.17)
    return picture
