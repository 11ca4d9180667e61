"""The pipes of the tank farm: a collecting pipe with valves and a pump, and the vent pipe."""

from .farm import TANK_X, TANK_Y, arc
from .mesh import Mesh

MATERIALS = {
    "pipe": ((0.70, 0.73, 0.76), 0.65, 90),
    "steel": ((0.66, 0.69, 0.72), 0.75, 100),
    "legs": ((0.38, 0.42, 0.46), 0.25, 40),
    "wheel": ((0.78, 0.12, 0.10), 0.30, 40),
    "dark": ((0.20, 0.21, 0.23), 0.25, 40),
    "motor": ((0.16, 0.37, 0.58), 0.35, 50),
}


def valve(mesh, x, y, z):
    """On a pipe that runs along y: a body with flanges, a stem upwards and a handwheel."""
    mesh.use("dark")
    mesh.ball(0.060, (x, y, z), 14, 6)
    for low in (-0.085, 0.065):
        mesh.cylinder(0.062, low, low + 0.02, (x, y, z), "y", 14, 0.004)
    mesh.use("steel")
    mesh.cylinder(0.012, 0.04, 0.20, (x, y, z), segments=10)
    mesh.use("wheel")
    rim = arc(0.011, (0.075, 0.0), -180, 180, 6)
    mesh.lathe(rim, (x, y, z + 0.19), segments=16)
    for first in ((-0.075, 0.0), (0.0, -0.075)):
        a = (x + first[0], y + first[1], z + 0.19)
        b = (x - first[0], y - first[1], z + 0.19)
        mesh.pipe([a, b], 0.007, segments=6)


def flange(mesh, centre, axis, radius=0.058):
    mesh.use("steel")
    mesh.cylinder(radius, -0.022, -0.002, centre, axis, 14, 0.004)
    mesh.cylinder(radius, 0.002, 0.022, centre, axis, 14, 0.004)


def pipes():
    mesh = Mesh()
    mesh.use("pipe", "pipes")
    front = 0.66  # the collecting pipe along the front
    mesh.pipe([(-3.25, front, 0.16), (3.62, front, 0.16), (3.62, front, 0.95), (3.62, 1.85, 0.95),
               (3.62, 1.85, 0.0)],
              0.042, 0.12, 12)
    for x in TANK_X:
        mesh.use("pipe")
        mesh.pipe([(x, TANK_Y, 0.26), (x, TANK_Y, 0.16), (x, front, 0.16)], 0.036, 0.09, 12)
        valve(mesh, x, front + 0.22, 0.16)
        flange(mesh, (x - 0.85 + 0.25, front, 0.16), "x")
    back = 2.16  # the vent pipe behind the heads
    mesh.use("pipe")
    mesh.pipe([(-2.55, back, 1.86), (3.30, back, 1.86), (3.30, back, 0.0)], 0.036, 0.12, 12)
    for x in TANK_X:
        mesh.use("pipe")
        mesh.pipe([(x - 0.18, TANK_Y + 0.10, 1.60), (x - 0.18, TANK_Y + 0.10, 1.86),
                   (x - 0.18, back, 1.86)], 0.030, 0.09, 12)
        flange(mesh, (x - 0.18, TANK_Y + 0.10, 1.72), "z", 0.05)
    mesh.use("legs")
    for x in (-3.1, -1.7, 0.0, 1.7):  # feet of the collecting pipe
        mesh.box((x - 0.03, front - 0.05, 0.0), (x + 0.03, front + 0.05, 0.125), 0.005)
    # A pump at the end of the collecting pipe.
    mesh.use("legs")
    mesh.box((-3.72, front - 0.14, 0.0), (-3.06, front + 0.14, 0.05), 0.008)
    mesh.use("dark")
    mesh.cylinder(0.125, -0.06, 0.06, (-3.22, front, 0.18), "x", 28, 0.015)
    mesh.use("motor")
    mesh.cylinder(0.095, -0.16, 0.16, (-3.50, front, 0.18), "x", 28, 0.012)
    mesh.use("dark")
    mesh.block((-3.50, front, 0.30), (0.10, 0.12, 0.07), 0.01)
    return mesh
