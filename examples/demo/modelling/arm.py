"""The six-axis arm, one mesh a link, each in its link's own space (see arm.urdf)."""

from .mesh import Mesh, rounded_rectangle, two_circles

MATERIALS = {
    "orange": ((0.93, 0.42, 0.07), 0.35, 60),
    "orange_dark": ((0.76, 0.32, 0.05), 0.25, 40),
    "graphite": ((0.20, 0.21, 0.23), 0.25, 30),
    "black": ((0.10, 0.10, 0.11), 0.30, 50),
    "steel": ((0.72, 0.74, 0.77), 0.75, 110),
    "white": ((0.92, 0.93, 0.94), 0.25, 40),
    "signal": ((0.96, 0.79, 0.10), 0.35, 50),
    "ruby": ((0.80, 0.08, 0.12), 0.90, 150),
}


def cheeks(mesh, outline, inner, outer, bevel):
    """A fork: one plate each side of the middle, across y."""
    mesh.plate(outline, inner, outer, "y", bevel=bevel)
    mesh.plate(outline, -outer, -inner, "y", bevel=bevel)


def caps(mesh, radius, inner, outer, centre=(0, 0, 0)):
    """Gear covers on both ends of a joint across y."""
    for low, high, rim in ((inner, outer, 1), (-outer, -inner, -1)):
        end = outer * rim
        mesh.use("graphite")
        mesh.cylinder(radius, low, high, centre, "y", 28, 0.008)
        mesh.use("steel")
        mesh.cylinder(radius * 0.42, min(end, end + 0.004 * rim), max(end, end + 0.004 * rim),
                      centre, "y", 20)


def base():
    mesh = Mesh()
    mesh.use("graphite", "base")
    mesh.plate(rounded_rectangle((-0.27, -0.27), (0.27, 0.27), 0.04), 0.0, 0.03, bevel=0.005)
    mesh.lathe([(0.215, 0.03), (0.195, 0.06), (0.18, 0.12), (0.175, 0.26), (0.19, 0.28),
                (0.19, 0.33), (0.0, 0.33)], segments=40)
    mesh.use("signal")
    mesh.lathe([(0.1775, 0.17), (0.1785, 0.17), (0.1785, 0.21), (0.1765, 0.21)], segments=40)
    mesh.use("orange")
    mesh.lathe([(0.165, 0.33), (0.165, 0.37), (0.155, 0.385), (0.0, 0.385)], segments=40)
    mesh.use("steel")
    for x in (-0.22, 0.22):
        for y in (-0.22, 0.22):
            mesh.cylinder(0.020, 0.03, 0.05, (x, y, 0), segments=6)
    # Cables come in at the back.
    mesh.use("black")
    mesh.block((-0.215, 0, 0.16), (0.09, 0.16, 0.12), 0.01)
    for y in (-0.04, 0.04):
        mesh.pipe([(-0.25, y, 0.16), (-0.37, y, 0.16), (-0.40, y, 0.02), (-0.56, y, 0.02)],
                  0.016, 0.05, 10)
    mesh.use("signal")  # and go into the floor under a cover
    mesh.box((-0.68, -0.09, 0.0), (-0.50, 0.09, 0.05), 0.015)
    return mesh


def turret():
    mesh = Mesh()
    mesh.use("graphite", "turret")
    mesh.lathe([(0.0, -0.045), (0.175, -0.045), (0.185, -0.035), (0.185, 0.0), (0.175, 0.012),
                (0.0, 0.012)], segments=40)
    mesh.use("orange")
    mesh.plate(two_circles((0.0, 0.075), 0.125, (0.11, 0.13), 0.10), -0.165, 0.165, "y", bevel=0.02)
    cheeks(mesh, two_circles((0.05, 0.10), 0.13, (0.15, 0.30), 0.128), 0.083, 0.165, 0.018)
    caps(mesh, 0.098, 0.165, 0.21, (0.15, 0, 0.30))
    mesh.use("graphite")  # the motor of the first joint stands behind
    mesh.lathe([(0.0, 0.02), (0.06, 0.02), (0.06, 0.19), (0.052, 0.20), (0.0, 0.20)],
               (-0.115, 0, 0), segments=24)
    mesh.use("black")
    mesh.block((-0.115, 0, 0.215), (0.07, 0.07, 0.03), 0.008)
    return mesh


def upper_arm():
    mesh = Mesh()
    mesh.use("orange", "upper_arm")
    mesh.plate(two_circles((0, 0), 0.118, (0, 0.65), 0.092), -0.078, 0.078, "y", bevel=0.016)
    mesh.use("orange_dark")  # a raised panel each side, and the maker's plate
    panel = two_circles((0, 0.17), 0.062, (0, 0.50), 0.052)
    mesh.plate(panel, 0.078, 0.083, "y", bevel=0.002)
    mesh.plate(panel, -0.083, -0.078, "y", bevel=0.002)
    mesh.use("white")
    plate = rounded_rectangle((-0.020, 0.24), (0.020, 0.44), 0.012)
    mesh.plate(plate, 0.083, 0.0845, "y")
    mesh.plate(plate, -0.0845, -0.083, "y")
    # The cable along the back, held by two clips.
    mesh.use("black")
    mesh.pipe([(-0.095, 0, 0.10), (-0.135, 0, 0.16), (-0.125, 0, 0.46), (-0.085, 0, 0.54)], 0.017,
              0.06, 10)
    mesh.use("graphite")
    for z in (0.20, 0.42):
        mesh.block((-0.118, 0, z), (0.065, 0.05, 0.03), 0.006)
    return mesh


def elbow():
    mesh = Mesh()
    mesh.use("orange", "elbow")
    cheeks(mesh, two_circles((0, 0), 0.094, (0.10, 0.12), 0.088), 0.083, 0.135, 0.014)
    mesh.plate(two_circles((0.075, 0.145), 0.075, (0.135, 0.12), 0.085), -0.135, 0.135, "y",
               bevel=0.016)
    mesh.lathe([(0.0, 0.10), (0.098, 0.12), (0.098, 0.185), (0.090, 0.195), (0.0, 0.195)],
               (0, 0, 0.12), "x", 36)
    caps(mesh, 0.074, 0.135, 0.17)
    # Motors of the wrist, behind the elbow.
    for y in (-0.055, 0.055):
        mesh.use("graphite")
        mesh.cylinder(0.044, -0.11, 0.06, (0, y, 0.175), "x", 24, 0.006)
        mesh.use("black")
        mesh.cylinder(0.036, -0.135, -0.11, (0, y, 0.175), "x", 20, 0.005)
    return mesh


def forearm():
    mesh = Mesh()
    mesh.use("graphite", "forearm")
    mesh.lathe([(0.0, -0.025), (0.082, -0.025), (0.086, -0.02), (0.086, 0.012), (0.080, 0.02),
                (0.0, 0.02)], axis="x", segments=36)
    mesh.use("orange")
    mesh.lathe([(0.077, 0.02), (0.077, 0.06), (0.070, 0.10), (0.056, 0.33), (0.050, 0.345),
                (0.0, 0.345)], axis="x", segments=36)
    mesh.use("orange")
    cheeks(mesh, two_circles((0.335, 0), 0.050, (0.46, 0), 0.046), 0.043, 0.066, 0.008)
    mesh.plate(rounded_rectangle((0.32, -0.050), (0.375, 0.050), 0.012), -0.066, 0.066, "y",
               bevel=0.008)
    mesh.use("white")
    mesh.lathe([(0.0665, 0.165), (0.0675, 0.165), (0.0645, 0.20), (0.0635, 0.20)], axis="x",
               segments=36)
    return mesh


def wrist():
    mesh = Mesh()
    mesh.use("graphite", "wrist")
    mesh.cylinder(0.043, -0.041, 0.041, (0, 0, 0), "y", 28, 0.004)
    mesh.lathe([(0.0, 0.0), (0.037, 0.0), (0.037, 0.095), (0.033, 0.10), (0.0, 0.10)], axis="x",
               segments=28)
    caps(mesh, 0.034, 0.066, 0.078)
    return mesh


def flange():
    mesh = Mesh()
    mesh.use("steel", "flange")
    mesh.lathe([(0.0, -0.012), (0.034, -0.012), (0.036, -0.010), (0.036, 0.012), (0.034, 0.014),
                (0.0, 0.014)], axis="x", segments=28)
    return mesh


def probe():
    """An inspection probe: its ball of 8 mm ends 0.20 m out of the flange."""
    mesh = Mesh()
    mesh.use("black", "probe")
    mesh.lathe([(0.0, 0.014), (0.030, 0.014), (0.030, 0.028), (0.024, 0.032), (0.024, 0.088),
                (0.020, 0.094), (0.0, 0.094)], axis="x", segments=24)
    mesh.use("signal")
    mesh.lathe([(0.0243, 0.046), (0.0255, 0.047), (0.0255, 0.061), (0.0243, 0.062)], axis="x",
               segments=24)
    mesh.use("steel")
    mesh.lathe([(0.013, 0.094), (0.011, 0.130), (0.0045, 0.142), (0.0035, 0.195)], axis="x",
               segments=18)
    mesh.use("ruby")
    mesh.ball(0.008, (0.20, 0, 0), 16, 10)
    return mesh


LINKS = {"base": base, "turret": turret, "upper_arm": upper_arm, "elbow": elbow,
         "forearm": forearm, "wrist": wrist, "flange": flange, "probe": probe}
