"""The gantry, assembled with all joints at zero: bridge over x = 0, hoist up, fingers open.

Groups runway, bridge, trolley, hoist, gripper, finger_left, finger_right. The gripper's palm is at
z = 2.30; the fingers' pads fit a canister of radius 0.15 when each has closed by 0.06.
"""

from .mesh import Mesh, rounded_rectangle

MATERIALS = {
    "frame": ((0.27, 0.34, 0.42), 0.25, 40),
    "beam": ((0.80, 0.82, 0.84), 0.35, 60),
    "rail": ((0.58, 0.60, 0.63), 0.70, 100),
    "dark": ((0.17, 0.18, 0.20), 0.25, 40),
    "yellow": ((0.96, 0.76, 0.08), 0.30, 50),
    "chrome": ((0.74, 0.77, 0.80), 0.85, 120),
    "motor": ((0.16, 0.37, 0.58), 0.35, 50),
    "rubber": ((0.09, 0.09, 0.10), 0.10, 10),
}

SIDE = 2.35  # the runways' distance from the middle
END = 3.70


def i_beam_x(mesh, y, low, high, left, right, width):
    mesh.box((left, y - width / 2, high - 0.03), (right, y + width / 2, high), 0.004)
    mesh.box((left, y - width / 2, low), (right, y + width / 2, low + 0.03), 0.004)
    mesh.box((left, y - 0.012, low + 0.03), (right, y + 0.012, high - 0.03))


def runway(mesh):
    mesh.use("frame", "runway")
    for y in (-SIDE, SIDE):
        for x in (-END, END):
            mesh.plate(rounded_rectangle((x - 0.10, y - 0.10), (x + 0.10, y + 0.10), 0.025, 3),
                       0.03, 2.48)
            mesh.box((x - 0.19, y - 0.19, 0.0), (x + 0.19, y + 0.19, 0.03), 0.006)
            mesh.box((x - 0.14, y - 0.14, 2.46), (x + 0.14, y + 0.14, 2.50), 0.006)
            inwards = -1 if x > 0 else 1  # a brace from column to runway
            mesh.pipe([(x + inwards * 0.08, y, 1.95), (x + inwards * 0.58, y, 2.50)], 0.035,
                      segments=10)
        i_beam_x(mesh, y, 2.50, 2.74, -END - 0.15, END + 0.15, 0.18)
        for x in (-2.2, -0.75, 0.75, 2.2):  # stiffeners
            for side in (-1, 1):
                mesh.box((x - 0.008, min(y, y + side * 0.08), 2.53),
                         (x + 0.008, max(y, y + side * 0.08), 2.71))
    for x in (-END, END):
        mesh.box((x - 0.06, -SIDE, 2.34), (x + 0.06, SIDE, 2.46), 0.008)
    mesh.use("yellow")
    for y in (-SIDE, SIDE):
        for x in (-END, END):
            mesh.plate(rounded_rectangle((x - 0.105, y - 0.105), (x + 0.105, y + 0.105), 0.025, 3),
                       0.03, 0.55)
        for x in (-END - 0.10, END + 0.10):
            mesh.block((x, y, 2.82), (0.08, 0.12, 0.15), 0.01)
    mesh.use("rail")
    for y in (-SIDE, SIDE):
        mesh.box((-END - 0.05, y - 0.025, 2.74), (END + 0.05, y + 0.025, 2.775), 0.006)


def bridge(mesh):
    mesh.use("frame", "bridge")
    for y in (-SIDE, SIDE):
        mesh.plate(rounded_rectangle((-0.50, 2.80), (0.50, 2.96), 0.035), y - 0.085, y + 0.085, "y",
                   bevel=0.010)
    mesh.use("dark")
    for y in (-SIDE, SIDE):
        for x in (-0.38, 0.38):
            mesh.cylinder(0.062, -0.030, 0.030, (x, y, 2.837), "y", 24, 0.008)
        for x in (-0.53, 0.53):
            mesh.cylinder(0.032, -0.035, 0.035, (x, y, 2.88), "x", 16, 0.006)
    mesh.use("motor")
    for y, side in ((-SIDE, -1), (SIDE, 1)):
        low, high = sorted((side * 0.085, side * 0.27))
        mesh.cylinder(0.055, low, high, (0.38, y, 2.88), "y", 24, 0.008)
    mesh.use("beam")
    for x in (-0.24, 0.24):
        mesh.plate(rounded_rectangle((x - 0.075, 2.87), (x + 0.075, 3.12), 0.018), -SIDE - 0.02,
                   SIDE + 0.02, "y", bevel=0.006)
    mesh.use("yellow")
    for y in (-SIDE - 0.026, SIDE + 0.021):
        for x in (-0.24, 0.24):
            mesh.box((x - 0.06, y, 2.89), (x + 0.06, y + 0.005, 3.10))
    mesh.use("rail")
    for x in (-0.24, 0.24):
        mesh.box((x - 0.02, -SIDE + 0.1, 3.12), (x + 0.02, SIDE - 0.1, 3.145), 0.005)


def trolley(mesh):
    mesh.use("yellow", "trolley")
    mesh.plate(rounded_rectangle((-0.36, -0.34), (0.36, 0.34), 0.05), 3.19, 3.27, bevel=0.010)
    mesh.use("dark")
    for x in (-0.24, 0.24):
        for y in (-0.24, 0.24):
            mesh.cylinder(0.048, -0.028, 0.028, (x, y, 3.192), "x", 22, 0.006)
    # The sleeve in which the mast runs.
    mesh.use("beam")
    mesh.plate(rounded_rectangle((-0.105, -0.105), (0.105, 0.105), 0.02), 2.42, 4.22, bevel=0.008)
    mesh.use("yellow")
    mesh.plate(rounded_rectangle((-0.125, -0.125), (0.125, 0.125), 0.025), 2.41, 2.47, bevel=0.006)
    mesh.plate(rounded_rectangle((-0.125, -0.125), (0.125, 0.125), 0.025), 4.19, 4.25, bevel=0.006)
    mesh.use("frame")
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):  # struts to the sleeve
        mesh.pipe([(x * 0.28, y * 0.27, 3.26), (x * 0.10, y * 0.10, 3.85)], 0.018, segments=10)
    mesh.use("motor")
    mesh.cylinder(0.070, 0.10, 0.34, (0, -0.02, 3.42), "x", 24, 0.010)
    mesh.use("dark")
    mesh.block((0.13, -0.02, 3.36), (0.10, 0.20, 0.20), 0.015)
    mesh.use("beam")
    mesh.block((-0.24, 0.05, 3.40), (0.16, 0.36, 0.26), 0.012)
    mesh.use("dark")
    mesh.block((-0.3215, 0.05, 3.42), (0.005, 0.26, 0.14))


def hoist(mesh):
    mesh.use("chrome", "hoist")
    mesh.plate(rounded_rectangle((-0.07, -0.07), (0.07, 0.07), 0.014), 2.36, 4.18)
    mesh.use("dark")
    mesh.box((-0.018, -0.0755, 2.40), (0.018, -0.069, 4.16))
    mesh.box((-0.018, 0.069, 2.40), (0.018, 0.0755, 4.16))


def gripper(mesh):
    mesh.use("dark", "gripper")
    mesh.lathe([(0.0, 2.335), (0.10, 2.335), (0.105, 2.34), (0.105, 2.365), (0.085, 2.385),
                (0.0, 2.385)], segments=32)
    mesh.use("yellow")
    mesh.plate(rounded_rectangle((-0.065, -0.31), (0.065, 0.31), 0.02), 2.30, 2.34, bevel=0.005)
    mesh.use("chrome")
    for x in (-0.038, 0.038):
        mesh.cylinder(0.011, -0.29, 0.29, (x, 0, 2.285), "y", 12)
    mesh.use("dark")
    for y in (-0.30, 0.30):
        mesh.block((0, y, 2.285), (0.12, 0.022, 0.045), 0.005)


def finger(mesh, group, side):
    """`side` is 1 for the finger at +y, which closes towards -y."""
    mesh.use("dark", group)
    mesh.block((0, side * 0.232, 2.282), (0.115, 0.085, 0.036), 0.006)
    mesh.use("yellow")
    mesh.block((0, side * 0.2475, 2.175), (0.075, 0.024, 0.21), 0.006)
    mesh.use("rubber")  # the pad: an arc about the canister's axis as the finger will hold it
    arc = [(0.1505, 2.07), (0.172, 2.07), (0.176, 2.074), (0.176, 2.186), (0.172, 2.19),
           (0.1505, 2.19), (0.1505, 2.07)]
    first = 90 - 42 if side > 0 else 270 - 42
    mesh.lathe(arc, (0, side * 0.06, 0), "z", 14, first, 84)
    mesh.use("dark")
    mesh.block((0, side * 0.233, 2.13), (0.11, 0.022, 0.09), 0.005)
    cap_pad_ends(mesh, arc, side, first)


def cap_pad_ends(mesh, arc, side, first):
    import math
    mesh.use("rubber")
    for angle_deg, ends in ((first, False), (first + 84, True)):
        angle = math.radians(angle_deg)
        points = [(r * math.cos(angle), side * 0.06 + r * math.sin(angle), z) for r, z in arc[:-1]]
        mesh.flat(points[::-1] if ends else points)


def gantry():
    mesh = Mesh()
    for part in (runway, bridge, trolley, hoist, gripper):
        part(mesh)
    finger(mesh, "finger_left", 1)
    finger(mesh, "finger_right", -1)
    return mesh
