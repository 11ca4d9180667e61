"""What stands still besides: the floor, railings, the pallet, the station and the control cabinet;
and the sign. The floor's surface is z = 0."""

from .mesh import Mesh, rounded_rectangle
from .textures import FLOOR_HIGH, FLOOR_LOW

MATERIALS = {
    "floor": ((1.0, 1.0, 1.0), 0.06, 10, "textures/floor.png"),
    "concrete": ((0.36, 0.38, 0.41), 0.05, 10),
    "railing": ((0.95, 0.75, 0.09), 0.35, 50),
    "wood": ((0.70, 0.54, 0.35), 0.05, 10),
    "steel": ((0.70, 0.72, 0.75), 0.75, 100),
    "dark": ((0.19, 0.20, 0.22), 0.25, 40),
    "cabinet": ((0.83, 0.84, 0.82), 0.20, 30),
    "screen": ((0.10, 0.36, 0.44), 0.80, 120),
    "red": ((0.86, 0.13, 0.10), 0.40, 60),
    "amber": ((0.98, 0.66, 0.08), 0.40, 60),
    "green": ((0.16, 0.68, 0.30), 0.40, 60),
}
SIGN_MATERIALS = {
    "board": ((1.0, 1.0, 1.0), 0.15, 30, "textures/sign.png"),
    "back": ((0.30, 0.33, 0.36), 0.20, 30),
}

PALLET = (-2.4, -1.27)
STATION = (1.25, -1.0)


def ground(mesh):
    (x0, y0), (x1, y1) = FLOOR_LOW, FLOOR_HIGH
    mesh.use("floor", "floor")
    mesh.flat([(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)],
              [(0, 0), (1, 0), (1, 1), (0, 1)])
    mesh.use("concrete")
    low = -0.1
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    for a, b in zip(corners, corners[1:] + corners[:1]):
        mesh.flat([(*a, low), (*b, low), (*b, 0), (*a, 0)])


def railing(mesh, points):
    """Posts with a hand rail, a knee rail and a toe board along a polyline on the floor."""
    mesh.use("railing", "railings")
    for height in (1.05, 0.55):
        mesh.pipe([(x, y, height) for x, y in points], 0.021, 0.10 if len(points) > 2 else 0, 10)
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        span = max(abs(bx - ax), abs(by - ay))
        count = round(span / 1.2)
        for i in range(count + 1):
            # The corners are bent: no post there.
            inset = 0.15
            t = (inset + (span - 2 * inset) * i / count) / span
            foot = (ax + (bx - ax) * t, ay + (by - ay) * t, 0)
            mesh.lathe([(0.05, 0.0), (0.05, 0.01), (0.019, 0.012), (0.019, 1.05)], foot, segments=10)
        low = (min(ax, bx) - 0.005, min(ay, by) - 0.005, 0.02)
        high = (max(ax, bx) + 0.005, max(ay, by) + 0.005, 0.12)
        mesh.box(low, high)


def pallet(mesh):
    x, y = PALLET
    mesh.use("wood", "pallet")
    for i in range(7):
        left = x - 0.60 + i * 0.1786
        mesh.box((left, y - 0.50, 0.128), (left + 0.128, y + 0.50, 0.15), 0.003)
    for dy in (-0.44, 0.0, 0.44):
        mesh.box((x - 0.60, y + dy - 0.05, 0.106), (x + 0.60, y + dy + 0.05, 0.128), 0.003)
        for dx in (-0.52, 0.0, 0.52):
            mesh.box((x + dx - 0.07, y + dy - 0.05, 0.022), (x + dx + 0.07, y + dy + 0.05, 0.106))
        mesh.box((x - 0.60, y + dy - 0.05, 0.0), (x + 0.60, y + dy + 0.05, 0.022), 0.003)


def station(mesh):
    x, y = STATION
    mesh.use("dark", "station")
    mesh.plate(rounded_rectangle((x - 0.24, y - 0.24), (x + 0.24, y + 0.24), 0.04), 0.0, 0.025,
               bevel=0.005)
    mesh.lathe([(0.13, 0.025), (0.095, 0.06), (0.085, 0.10), (0.085, 0.33), (0.13, 0.38), (0.20, 0.395)],
               (x, y, 0), segments=32)
    mesh.use("steel")
    mesh.lathe([(0.20, 0.395), (0.228, 0.395), (0.235, 0.402), (0.235, 0.443), (0.228, 0.45),
                (0.0, 0.45)], (x, y, 0), segments=40)
    mesh.use("railing")
    mesh.lathe([(0.235, 0.412), (0.2365, 0.412), (0.2365, 0.434), (0.235, 0.434)], (x, y, 0),
               segments=40)
    mesh.use("dark")  # three jaws centre the canister
    for dx, dy in ((0.173, 0.0), (-0.0865, 0.1498), (-0.0865, -0.1498)):
        mesh.lathe([(0.021, 0.45), (0.021, 0.49), (0.012, 0.51), (0.0, 0.51)], (x + dx, y + dy, 0),
                   segments=14)


def cabinet(mesh):
    x, y = 3.72, -0.05
    mesh.use("dark", "cabinet")
    mesh.box((x - 0.28, y - 0.40, 0.0), (x + 0.28, y + 0.40, 0.10), 0.008)
    mesh.use("cabinet")
    mesh.box((x - 0.30, y - 0.42, 0.10), (x + 0.30, y + 0.42, 1.55), 0.018)
    mesh.use("dark")
    mesh.box((x - 0.305, y - 0.002, 0.16), (x - 0.299, y + 0.002, 1.49))
    mesh.block((x, y - 0.424, 1.18), (0.36, 0.012, 0.27), 0.004)
    mesh.use("screen")
    mesh.block((x, y - 0.430, 1.20), (0.30, 0.006, 0.17))
    for index, name in enumerate(("red", "amber", "green")):
        mesh.use(name)
        mesh.cylinder(0.016, 0.0, 0.02, (x - 0.09 + 0.09 * index, -(y - 0.45) * -1, 1.075), "y", 14,
                      0.004)
    mesh.use("dark")
    for z in (0.35, 0.42, 0.49):
        mesh.block((x, y - 0.421, z), (0.34, 0.006, 0.03))
    mesh.cylinder(0.018, 1.55, 1.70, (x, y, 0), segments=12)
    for index, name in enumerate(("green", "amber", "red")):
        mesh.use(name)
        mesh.cylinder(0.042, 1.70 + 0.075 * index, 1.77 + 0.075 * index, (x, y, 0), segments=20,
                      bevel=0.004)
    mesh.use("dark")
    mesh.cylinder(0.042, 1.925, 1.945, (x, y, 0), segments=20, bevel=0.005)


def hall():
    mesh = Mesh()
    ground(mesh)
    railing(mesh, [(-4.25, -2.2), (-4.25, 2.95), (4.25, 2.95)])
    railing(mesh, [(4.25, 2.95), (4.25, 0.75)])
    pallet(mesh)
    station(mesh)
    cabinet(mesh)
    return mesh


def signs():
    """A board on the front runway."""
    mesh = Mesh()
    x, y, z, width = 0.0, -2.47, 2.62, 0.96
    height = width / 4
    mesh.use("back", "signs")
    mesh.box((x - width / 2, y, z - height / 2), (x + width / 2, y + 0.02, z + height / 2), 0.004)
    for dx in (-0.3 * width, 0.3 * width):
        mesh.box((x + dx - 0.02, y + 0.02, z - 0.06), (x + dx + 0.02, y + 0.07, z - 0.02))
    mesh.use("board")
    mesh.flat([(x - width / 2 + 0.004, y - 0.002, z - height / 2 + 0.004),
               (x + width / 2 - 0.004, y - 0.002, z - height / 2 + 0.004),
               (x + width / 2 - 0.004, y - 0.002, z + height / 2 - 0.004),
               (x - width / 2 + 0.004, y - 0.002, z + height / 2 - 0.004)],
              [(0, 0), (1, 0), (1, 1), (0, 1)])
    return mesh
