#!/usr/bin/env python3
"""Writes the OBJ and MTL models of this folder, one for each core feature, and their pictures.
usage: make_models.py [FOLDER]"""
import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from model_pictures import quarters, stripes

WHOLE = [(0, 0), (1, 0), (1, 1), (0, 1)]
WIDE = [(-0.75, -0.75), (1.75, -0.75), (1.75, 1.75), (-0.75, 1.75)]


def tell(*values):
    """Without what the last digits of a machine's sine would change."""
    return " ".join(f"{round(value, 5) + 0:g}" for value in values)


def place(number, columns=3):
    return 1.1 * (number % columns), 1.1 * (1 - number // columns)


class Model:
    """Upright shapes that face -y, z up."""

    def __init__(self, *lines):
        self.lines = list(lines)
        self.points = self.places = 0

    def add(self, *lines):
        self.lines += lines

    def put(self, points, x=0, z=0):
        """Their first number, from 1."""
        self.add(*("v " + tell(px + x, py, pz + z) for px, py, pz in points))
        self.points += len(points)
        return self.points - len(points) + 1

    def quad(self, x, z, places=None, size=1.0, depth=0.0):
        corners = [(0, depth, 0), (size, depth, 0), (size, depth, size), (0, depth, size)]
        first = self.put(corners, x, z)
        if places:
            self.add(*(f"vt {u:g} {v:g}" for u, v in places))
            self.places += 4
            self.add("f " + " ".join(f"{first + i}/{self.places - 3 + i}" for i in range(4)))
        else:
            self.add("f " + " ".join(str(first + i) for i in range(4)))

    def text(self):
        return "\n".join(self.lines) + "\n"


def materials():
    """Kd with three numbers and one, Ke, Ks with Ns, d, Tr, and no material; used before `mtllib`."""
    mtl = ["newmtl three", "Kd 0.8 0.1 0.1", "newmtl one", "Kd 0.3", "newmtl lit", "Kd 0.2 0.1 0.1",
           "Ke 0 0.4 0.1", "newmtl gloss", "Kd 0.3 0.1 0.4", "Ks 1 1 1", "Ns 20", "newmtl back",
           "Kd 0.05 0.1 0.6", "newmtl d", "Kd 0.9 0.8 0.1", "d 0.4", "newmtl Tr", "KD 0.9 0.8 0.1",
           "Tr 0.25", "newmtl both", "kd 0.9 0.8 0.1", "d 0.8", "Tr 0.8"]
    model = Model()
    for number, name in enumerate(["three", "one", "lit"]):
        model.add(f"usemtl {name}")
        model.quad(*place(number, 4))
    # An edge towards the viewer, so that both sides have the highlight of their own.
    model.add("usemtl gloss")
    x, z = place(3, 4)
    first = model.put([(0, 0, 0), (0.5, -0.2, 0), (1, 0, 0), (1, 0, 1), (0.5, -0.2, 1), (0, 0, 1)], x, z)
    model.add("vn -0.2 -1 0", "vn 0.3 -1 0.3", "vn 0.6 -0.8 0",
              "f " + " ".join(f"{first + i}//{n}" for i, n in ((0, 1), (1, 2), (4, 2), (5, 1))),
              "f " + " ".join(f"{first + i}//{n}" for i, n in ((1, 2), (2, 3), (3, 3), (4, 2))))
    model.add("usemtl back")
    model.put([(-0.1, 0.3, 0.4), (3.4, 0.3, 0.4), (3.4, 0.3, 0.9), (-0.1, 0.3, 0.9)])
    model.add("f -4 -3 -2 -1")
    for number, name in enumerate(["d", "Tr", "both"]):
        model.add(f"usemtl {name}")
        model.quad(*place(4 + number, 4))
    model.add("mtllib materials.mtl")
    alone = Model()
    alone.quad(*place(7, 4))
    return {"materials.obj": model.text(), "materials.mtl": "\n".join(mtl) + "\n", "grey.obj": alone.text()}


def maps():
    """map_Kd and its options before and behind the name; colour times picture; its opacity."""
    options = ["quarters.png", "-s 2 2 1 quarters.png", "-o 0.25 0.5 0 quarters.png",
               "-s 2 1 -o 0.5 0 quarters.png -clamp on", "-clamp on quarters.png",
               "-mm 0 1 -s 0.5 0.5 quarters.png", ".\\quarters.png"]
    mtl, model = [], Model("mtllib maps.mtl")
    for number, option in enumerate(options):
        # A black Kd counts as white.
        kd = {0: "Kd 1 1 1", 1: "Kd 0 0 0", 6: "Kd 1 0.3 0.3"}.get(number, "Kd 1 1 1")
        mtl += [f"newmtl m{number}", kd, f"map_{'KD' if number == 5 else 'Kd'} {option}"]
        model.add(f"usemtl m{number}")
        model.quad(*place(number, 4), WIDE if number in (0, 4) else WHOLE)
    mtl += ["newmtl seen", "Kd 1 1 1", "map_Kd -clamp on stripes.png", "newmtl behind", "Kd 0.05 0.1 0.6"]
    model.add("usemtl seen")
    model.quad(*place(7, 4), WHOLE)
    model.add("usemtl behind")
    x, z = place(7, 4)
    model.quad(x, z + 0.25, None, 0.5, 0.3)
    return {"maps.obj": model.text(), "maps.mtl": "\n".join(mtl) + "\n"}


def faces():
    """Polygons, convex and concave, tilted; corners of all four forms; indices from the end."""
    model = Model("mtllib paints.mtl", "usemtl red")
    circle = [(0.5 + 0.5 * math.cos(math.tau * i / 9), 0, 0.5 + 0.5 * math.sin(math.tau * i / 9)) for i in range(9)]
    first = model.put(circle, *place(0))
    model.add("f " + " ".join(str(first + i) for i in range(9)))
    star = [(0.5 + (0.5 if i % 2 else 0.2) * math.sin(math.tau * i / 10), 0,
             0.5 + (0.5 if i % 2 else 0.2) * math.cos(math.tau * i / 10)) for i in range(10)]
    model.add("usemtl green")
    model.put(star, *place(1))
    model.add("f " + " ".join(str(-1 - i) for i in range(10)))
    # A C that leans back.
    c = [(0, 0), (1, 0), (1, 0.3), (0.3, 0.3), (0.3, 0.7), (1, 0.7), (1, 1), (0, 1)]
    model.add("usemtl blue")
    first = model.put([(x, 0.5 * z, z) for x, z in c], *place(2))
    model.add("f " + " ".join(str(first + i) for i in range(8)))
    # V, V/T, V//N and V/T/N of one quarter each.
    x, z = place(3)
    first = model.put([(0.5 * i, 0, 0.5 * j) for j in range(3) for i in range(3)], x, z)
    model.add("vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1", "vn 0.7 -0.7 0")
    model.add("usemtl yellow", f"f {first} {first + 1} {first + 4} {first + 3}",
              f"f {first + 3}//1 {first + 4}//1 {first + 7}//1 {first + 6}//1",
              "usemtl picture", f"f {first + 1}/1 {first + 2}/2 {first + 5}/3 {first + 4}/4",
              "f -5/-4/-1 -4/-3/-1 -1/-2/-1 -2/-1/-1")
    # Two faces that share points which are numbered at the end.
    model.add("usemtl yellow")
    x, z = place(4)
    model.put([(0, 0, 0), (1, 0, 0), (0, 0, 1)], x, z)
    model.add("f -3 -2 -1")
    model.put([(1, 0, 1), (0.6, 0, 0.6)], x, z)
    model.add("f -4 -2 -3 -1")
    # A dart, from each of its corners.
    model.add("usemtl green")
    x, z = place(5)
    dart = [(0, 0), (0.45, 0), (0.45, 0.45), (0.3, 0.15)]
    for start in range(4):
        points = [(dart[(start + i) % 4][0], 0, dart[(start + i) % 4][1]) for i in range(4)]
        model.put(points, x + 0.5 * (start % 2), z + 0.5 * (start // 2))
        model.add("f -4 -3 -2 -1")
    return {"faces.obj": model.text()}


def normals():
    """Half pipes: without `s`, with it off, with a group, with two groups, with normals."""
    model = Model("mtllib paints.mtl", "usemtl green")
    arc = [(0.5 - 0.5 * math.cos(math.pi * i / 5), -0.5 * math.sin(math.pi * i / 5)) for i in range(6)]
    for number, kind in enumerate(["", "off", "1", "two", "given"]):
        x, z = place(number)
        first = model.put([(px, py, pz) for pz in (0, 1) for px, py in arc], x, z)
        if kind == "given":
            model.add(*("vn " + tell(px - 0.5, py, 0) for px, py in arc))
        for i in range(5):
            if kind in ("off", "1") and i == 0:
                model.add(f"s {kind}")
            if kind == "two":
                model.add(f"s {1 + i // 3}")
            corners = [(first + i, i), (first + i + 1, i + 1), (first + 7 + i, i + 1), (first + 6 + i, i)]
            model.add("f " + " ".join(f"{p}//{n + 1}" if kind == "given" else str(p) for p, n in corners))
    return {"normals.obj": model.text()}


def groups():
    """Objects and groups, materials across them, and several libraries, quoted and with blanks."""
    model = Model("mtllib paints.mtl left\\half.mtl", 'mtllib "right half.mtl"', "mtllib top half.mtl")
    names = [("o one", "red"), ("g two and three", "left"), ("o four", "right wing"), ("g", "top"),
             ("g five", '"quoted name"'), ("g", "red")]
    for number, (group, material) in enumerate(names):
        model.add(group, f"usemtl {material}")
        model.quad(*place(number), WHOLE)
    return {"groups.obj": model.text(), "left/half.mtl": "newmtl left\nKd 0.1 0.6 0.2\n",
            "right half.mtl": "newmtl right wing\nKd 0.1 0.2 0.8\nnewmtl \"quoted name\"\nKd 0.1 0.6 0.7\n",
            "top half.mtl": "newmtl top\nmap_Kd \"four quarters.png\"\nnewmtl red\nKd 0 0 0\n"}


def vertex_colours():
    """Behind the points, times a material, and beside points without one."""
    corners = [(0, 0, 1, 0, 0), (1, 0, 0, 1, 0), (1, 1, 0, 0, 1), (0, 1, 1, 1, 1)]
    model = Model("mtllib paints.mtl")
    for number in range(3):
        x, z = place(number, 2)
        for px, pz, r, g, b in corners:
            colour = "" if number == 2 and px == 1 else f" {r} {g} {b}"
            model.add(f"v {px + x:g} 0 {pz + z:g}{colour}")
        model.add("usemtl half" if number == 1 else "usemtl", "f -4 -3 -2 -1")
    # A weight is not a colour.
    model.points += 12
    x, z = place(3, 2)
    model.add(*(f"v {px + x:g} 0 {pz + z:g} 1.0" for px, pz, *_ in corners), "usemtl red", "f -4 -3 -2 -1")
    return {"vertex-colours.obj": model.text()}


def writing():
    """CR LF, a byte order mark, continued lines, tabs, comments, capital letters of the exponent."""
    lines = ["\ufeff# A quad, written in every way.", "mtllib  \t paints.mtl  ", "usemtl \\", "  red",
             "v\t0 0 0", "v 1E0 0 \\", " 0.0", "v +1. 0 100e-2", "v 0 -0 1 # not a colour", "",
             "f 1\t2 \\", "3\\", " 4   ", "usemtl blue", "v 0.2 -0.1 0.2", "v 0.8 -0.1 0.2",
             "v 0.5 -0.1 0.8", "f -3 -2 -1 # a comment"]
    old = ["mtllib paints.mtl", "usemtl green", "v 0 0 0", "v 1 0 0", "v 1 0 1", "v 0 0 1", "f 1 2 3 4"]
    return {"writing.obj": "\r\n".join(lines) + "\r\n", "old-mac.obj": "\r".join(old)}


def up():
    """A step in centimetres, y up."""
    model = Model("mtllib paints.mtl", "usemtl red")
    model.add("v 0 0 0", "v 80 0 0", "v 80 70 0", "v 0 30 0", "v 0 0 -50", "v 80 0 -50")
    model.add("f 1 2 3 4", "f 1 4 5", "f 2 6 3", "f 4 3 6 5", "f 1 5 6 2")
    return {"up.obj": model.text()}


PAINTS = "".join(f"newmtl {name}\nKd {kd}\n" for name, kd in (
    ("red", "0.8 0.1 0.1"), ("green", "0.1 0.6 0.2"), ("blue", "0.1 0.2 0.8"), ("yellow", "0.8 0.7 0.1"),
    ("half", "0.5 0.5 0.5"))) + "newmtl picture\nmap_Kd quarters.png\n"


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    files = {"paints.mtl": PAINTS, "quarters.png": quarters(), "four quarters.png": quarters(),
             "stripes.png": stripes()}
    for make in (materials, maps, faces, normals, groups, vertex_colours, writing, up):
        files.update(make())
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


main()
