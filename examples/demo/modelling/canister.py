"""A steel canister of 32 litres: radius 0.15, height 0.50, standing on its bottom's middle."""

import math

from .mesh import Mesh

MATERIALS = {
    "paint": ((0.09, 0.33, 0.62), 0.45, 70),
    "band": ((0.93, 0.94, 0.95), 0.30, 40),
    "lid": ((0.78, 0.80, 0.82), 0.75, 100),
    "bung": ((0.93, 0.72, 0.10), 0.40, 60),
}


def canister():
    mesh = Mesh()
    mesh.use("paint", "canister")
    mesh.lathe([(0.0, 0.006), (0.138, 0.006), (0.138, 0.0), (0.148, 0.0), (0.150, 0.004),
                (0.150, 0.120)], segments=40)
    for hoop in (0.120, 0.255):  # rolling hoops
        profile = [(0.150 + 0.007 * math.sin(math.pi * i / 6), hoop + 0.020 * i / 6)
                   for i in range(7)]
        mesh.lathe(profile, segments=40)
    mesh.use("band")
    mesh.lathe([(0.150, 0.140), (0.150, 0.255)], segments=40)
    mesh.use("paint")
    mesh.lathe([(0.150, 0.275), (0.150, 0.476)], segments=40)
    # The chime stands 12 mm above the lid.
    mesh.lathe([(0.150, 0.476), (0.1525, 0.480), (0.1525, 0.496), (0.150, 0.500), (0.142, 0.500),
                (0.140, 0.497), (0.140, 0.488)], segments=40)
    mesh.use("lid")
    mesh.lathe([(0.140, 0.488), (0.0, 0.488)], segments=40)
    mesh.use("bung")
    mesh.lathe([(0.030, 0.488), (0.030, 0.494), (0.026, 0.497), (0.0, 0.497)], segments=20)
    return mesh
