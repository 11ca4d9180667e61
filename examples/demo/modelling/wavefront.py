"""Writes a Mesh as Wavefront OBJ and its materials as MTL, the same bytes every time."""


def number(value, decimals):
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


class Pool:
    """Lines of one kind, each written once and numbered from 1."""

    def __init__(self, keyword, decimals):
        self.keyword, self.decimals = keyword, decimals
        self.numbers = {}

    def of(self, values):
        line = " ".join([self.keyword, *(number(v, self.decimals) for v in values)])
        return self.numbers.setdefault(line, len(self.numbers) + 1)


def obj_text(mesh, material_file, what):
    positions, places, normals = Pool("v", 4), Pool("vt", 4), Pool("vn", 3)
    faces = []
    for group, by_material in mesh.faces.items():
        faces.append(f"g {group}")
        for material, polygons in by_material.items():
            faces.append(f"usemtl {material}")
            for corners in polygons:
                words, seen = [], []
                for position, normal, place in corners:
                    v = positions.of(position)
                    if v in seen:  # rounding brought two corners together
                        continue
                    seen.append(v)
                    vt = places.of(place) if place else ""
                    words.append(f"{v}/{vt}/{normals.of(normal)}")
                if len(words) > 2:
                    faces.append("f " + " ".join(words))
    head = [f"# {what}. Metres, z up. Written by make_models.py.", f"mtllib {material_file}"]
    return "\n".join([*head, *positions.numbers, *places.numbers, *normals.numbers, *faces]) + "\n"


def mtl_text(materials):
    """`materials`: name -> (diffuse rgb, specular grey, shininess[, picture])."""
    lines = ["# Written by make_models.py. Colours are display values."]
    for name, (diffuse, specular, shininess, *picture) in materials.items():
        lines += ["", f"newmtl {name}",
                  "Kd " + " ".join(number(c, 3) for c in diffuse),
                  "Ks " + " ".join([number(specular, 3)] * 3),
                  f"Ns {number(shininess, 1)}", "illum 2"]
        lines += [f"map_Kd {name}" for name in picture]
    return "\n".join(lines) + "\n"
