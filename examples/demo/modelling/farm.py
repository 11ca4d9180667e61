"""The tank farm: four tanks on legs with painted shells, gauges, manways."""

import math

from .mesh import Mesh
from .textures import SHELL, TANKS

MATERIALS = {
    "shell": ((1.0, 1.0, 1.0), 0.20, 40, "textures/tank_shells.png"),
    "white": (tuple(c / 255 for c in SHELL), 0.20, 40),
    "steel": ((0.66, 0.69, 0.72), 0.75, 100),
    "legs": ((0.38, 0.42, 0.46), 0.25, 40),
    "dark": ((0.20, 0.21, 0.23), 0.25, 40),
    **{name: (tuple(c / 255 for c in color), 0.25, 40) for name, _, color in TANKS},
}

TANK_X = (-2.55, -0.85, 0.85, 2.55)
TANK_Y = 1.45
RADIUS = 0.58
LOW, HIGH = 0.46, 1.52  # the shell


def arc(radius, middle, first_deg, last_deg, steps):
    """Profile points on a circle about (middle radius, middle height)."""
    points = []
    for i in range(steps + 1):
        angle = math.radians(first_deg + (last_deg - first_deg) * i / steps)
        points.append((max(0.0, middle[0] + radius * math.cos(angle)),
                       middle[1] + radius * math.sin(angle)))
    return points


def tank(mesh, index, x):
    name = TANKS[index][0]
    centre = (x, TANK_Y, 0)
    mesh.use("shell", f"tank_{name}")
    # Of each strip the middle half is used up to the seams; v counts from the picture's bottom.
    top, bottom = 1 - (256 * index + 1) / 1024, 1 - (256 * index + 255) / 1024
    # u = 0.5, the strip's middle, faces the front.
    mesh.lathe([(RADIUS, LOW), (RADIUS, HIGH)], centre, segments=44, first_deg=90,
               places=[bottom, top])
    mesh.use("white")
    # Torispherical head: a knuckle, then a wide crown.
    knuckle = arc(0.14, (RADIUS - 0.14, HIGH), 0, 62, 5)
    crown_radius = knuckle[-1][0] / math.cos(math.radians(62))
    crown = arc(crown_radius, (0.0, knuckle[-1][1] - crown_radius * math.sin(math.radians(62))),
                62, 90, 4)
    mesh.lathe(knuckle + crown[1:], centre, segments=44)
    cone = arc(0.10, (RADIUS - 0.10, LOW), -70, 0, 4)
    mesh.lathe([(0.07, 0.30), *cone], centre, segments=44)
    mesh.use(name)  # the coloured ring where shell and head meet
    mesh.lathe([(RADIUS, HIGH - 0.022), (RADIUS + 0.006, HIGH - 0.016), (RADIUS + 0.006, HIGH + 0.004),
                (RADIUS, HIGH + 0.010)], centre, segments=44)
    mesh.use("steel")
    mesh.lathe([(0.07, 0.31), (0.07, 0.24), (0.0, 0.24)][::-1], centre, segments=20)
    # Manway and vent on the head.
    mesh.lathe([(0.15, 1.62), (0.15, 1.735), (0.175, 1.735), (0.18, 1.74), (0.18, 1.765),
                (0.172, 1.772), (0.0, 1.772)], (x + 0.12, TANK_Y - 0.16, 0), segments=28)
    mesh.use("legs")
    for angle_deg in (45, 135, 225, 315):
        angle = math.radians(angle_deg)
        leg = (x + 0.50 * math.cos(angle), TANK_Y + 0.50 * math.sin(angle), 0)
        mesh.lathe([(0.09, 0.0), (0.09, 0.015), (0.042, 0.018), (0.042, 0.56)], leg, segments=12)
    gauge(mesh, x)


def gauge(mesh, x):
    """A sight glass on the shell, right of the label."""
    angle = math.radians(-90 + 52)
    foot = (x + (RADIUS + 0.05) * math.cos(angle), TANK_Y + (RADIUS + 0.05) * math.sin(angle), 0)
    mesh.use("dark")
    for z in (0.62, 1.40):
        mesh.ball(0.026, (foot[0], foot[1], z), 12, 6)
        inner = (x + (RADIUS - 0.01) * math.cos(angle), TANK_Y + (RADIUS - 0.01) * math.sin(angle), z)
        mesh.pipe([inner, (foot[0], foot[1], z)], 0.012, segments=8)
    mesh.use("steel")
    mesh.cylinder(0.014, 0.62, 1.40, foot, segments=10)


def tank_farm():
    mesh = Mesh()
    for index, x in enumerate(TANK_X):
        tank(mesh, index, x)
    return mesh
