#!/usr/bin/env python3
"""Writes the glTF models of this folder: one for each core feature of glTF 2.0, with all data in
the file. usage: make_models.py [FOLDER]"""
import base64
import json
import math
import pathlib
import struct
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from model_pictures import quarters, stripes

FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
FLOAT, UBYTE, USHORT, BYTE, SHORT, UINT = 5126, 5121, 5123, 5120, 5122, 5125
REPEAT, MIRROR, CLAMP = 10497, 33648, 33071


def data_uri(kind, content):
    return f"data:{kind};base64," + base64.b64encode(content).decode()


class Model:
    def __init__(self):
        self.data = bytearray()
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}],
                     "nodes": [], "meshes": [], "accessors": [], "bufferViews": []}

    def add(self, array, item):
        self.json.setdefault(array, []).append(item)
        return len(self.json[array]) - 1

    def view(self, content, **more):
        while len(self.data) % 4:
            self.data += b"\0"
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content), **more}
        self.data += content
        return self.add("bufferViews", view)

    def accessor(self, kind, component, values, stride=0, **more):
        count = COMPONENTS[kind]
        content = b""
        for element in values:
            numbers = [element] if count == 1 else element
            packed = struct.pack("<" + FORMATS[component] * count, *numbers)
            content += packed.ljust(stride, b"\0")
        view = self.view(content, **({"byteStride": stride} if stride else {}))
        facts = {"bufferView": view, "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3" and component == FLOAT:
            facts["min"] = [min(v[i] for v in values) for i in range(3)]
            facts["max"] = [max(v[i] for v in values) for i in range(3)]
        return self.add("accessors", {**facts, **more})

    def image(self, content):
        return self.add("images", {"uri": data_uri("image/png", content)})

    def texture(self, image, wrap=None):
        texture = {"source": image}
        if wrap:
            texture["sampler"] = self.add("samplers", {"wrapS": wrap[0], "wrapT": wrap[1]})
        return self.add("textures", texture)

    def paint(self, color=None, texture=None, transform=None, **more):
        surface = {"metallicFactor": 0}
        if color:
            surface["baseColorFactor"] = color
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
            if transform:
                surface["baseColorTexture"]["extensions"] = {"KHR_texture_transform": transform}
                self.json["extensionsUsed"] = ["KHR_texture_transform"]
        return self.add("materials", {"pbrMetallicRoughness": surface, **more})

    def show(self, primitives, name, at=(0, 0, 0), **more):
        if not isinstance(primitives, list):
            primitives = [primitives]
        mesh = self.add("meshes", {"primitives": primitives})
        node = {"mesh": mesh, "name": name, **more}
        if at != (0, 0, 0):
            node["translation"] = list(at)
        self.json["scenes"][0]["nodes"].append(self.add("nodes", node))
        return mesh

    def quad(self, material, places=((0, 1), (1, 1), (1, 0), (0, 0)), size=1.0, depth=0.0,
             **attributes):
        """Upright, its front towards +z of the file (-y of ours); glTF's v counts down."""
        points = [(0, 0, depth), (size, 0, depth), (size, size, depth), (0, size, depth)]
        given = {"POSITION": self.accessor("VEC3", FLOAT, points)}
        if places:
            given["TEXCOORD_0"] = self.accessor("VEC2", FLOAT, places)
        given.update(attributes)
        primitive = {"attributes": given,
                     "indices": self.accessor("SCALAR", USHORT, [0, 1, 2, 0, 2, 3])}
        if material is not None:
            primitive["material"] = material
        return primitive

    def save(self, path):
        self.json["buffers"] = [{"byteLength": len(self.data), "uri": data_uri(
            "application/octet-stream", bytes(self.data))}]
        path.write_text(json.dumps(self.json, separators=(",", ":")) + "\n")


def alpha_modes():
    model = Model()
    texture = model.texture(model.image(stripes()), (CLAMP, CLAMP))
    back = model.paint([0.05, 0.1, 0.6, 1])
    model.show(model.quad(back, places=None, size=4.6, depth=-0.4), "back", (-0.1, -0.1, 0))
    kinds = [{}, {"alphaMode": "MASK"}, {"alphaMode": "MASK", "alphaCutoff": 0.2},
             {"alphaMode": "BLEND"}]
    for i, more in enumerate(kinds):
        model.show(model.quad(model.paint(texture=texture, **more)), f"textured {i}",
                   (1.1 * i, 1.6, 0))
        color = [0.9, 0.8, 0.1, 0.4]
        model.show(model.quad(model.paint(color, **more), places=None), f"plain {i}",
                   (1.1 * i, 0.4, 0))
    return model


def wraps():
    model = Model()
    image = model.image(quarters())
    places = ((-0.75, 1.75), (1.75, 1.75), (1.75, -0.75), (-0.75, -0.75))
    for i, wrap in enumerate([None, (MIRROR, MIRROR), (CLAMP, CLAMP), (REPEAT, CLAMP)]):
        material = model.paint(texture=model.texture(image, wrap))
        model.show(model.quad(material, places), f"wrap {i}", (1.1 * (i % 2), 1.1 * (1 - i // 2), 0))
    return model


def transforms():
    model = Model()
    texture = model.texture(model.image(quarters()), (CLAMP, CLAMP))
    for i, transform in enumerate([
            {"offset": [0.5, 0.25]}, {"rotation": math.pi / 6}, {"scale": [2, 1.5]},
            {"offset": [0.3, 0.1], "rotation": -math.pi / 4, "scale": [1.5, 0.75]}]):
        material = model.paint(texture=texture, transform=transform)
        model.show(model.quad(material), f"transform {i}", (1.1 * (i % 2), 1.1 * (1 - i // 2), 0))
    return model


def vertex_colours():
    model = Model()
    corners = [(150, 0, 0), (0, 150, 0), (0, 0, 150), (255, 255, 255)]
    deep = [tuple(c * 257 for c in corner) + (65535,) for corner in corners]
    linear = [tuple(c / 255 for c in corner) for corner in corners]
    colors = [model.accessor("VEC3", UBYTE, corners, stride=4, normalized=True),
              model.accessor("VEC4", UBYTE, [c + (255,) for c in corners], normalized=True),
              model.accessor("VEC4", USHORT, deep, normalized=True),
              model.accessor("VEC3", FLOAT, linear)]
    half = model.paint([0.5, 0.5, 0.5, 1])
    for i, color in enumerate(colors):
        material = half if i == 3 else None
        model.show(model.quad(material, places=None, COLOR_0=color), f"colours {i}",
                   (1.1 * (i % 2), 1.1 * (1 - i // 2), 0))
    return model


def quantised():
    """KHR_mesh_quantization: a block of shorts, its normals bytes, its texture places shorts."""
    model = Model()
    model.json["extensionsUsed"] = model.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    material = model.paint(texture=model.texture(model.image(quarters())))
    points, normals, places, indices = [], [], [], []
    for axis in range(3):
        for side in (0, 1):
            first = len(points)
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                point = [0, 0, 0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, u, v
                points.append([point[0] * 1000, point[1] * 700, point[2] * 400])
                normal = [0, 0, 0]
                normal[axis] = 127 if side else -127
                normals.append(normal)
                places.append([u * 65535, v * 65535])
            order = (0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2)
            indices += [first + i for i in order]
    primitive = {"attributes": {
        "POSITION": model.accessor("VEC3", SHORT, points, stride=8),
        "NORMAL": model.accessor("VEC3", BYTE, normals, stride=4, normalized=True),
        "TEXCOORD_0": model.accessor("VEC2", USHORT, places, normalized=True)},
        "indices": model.accessor("SCALAR", UBYTE, indices), "material": material}
    model.show(primitive, "block", scale=[0.001, 0.001, 0.001])
    return model


def shared():
    """One accessor of many points, used by parts of their own: lists, a strip, a fan, no indices; and
    a sparse accessor that lifts some of the points."""
    model = Model()
    points = [(x * 0.5, y * 0.5, 0) for y in range(5) for x in range(7)]
    grid = model.accessor("VEC3", FLOAT, points)
    lifted = [(x * 0.5, y * 0.5 + 0.25, 0.5) for y in (3, 4) for x in (5, 6)]
    changed = {"count": 4,
               "indices": {"bufferView": model.view(struct.pack("<4H", 26, 27, 33, 34)),
                           "componentType": USHORT},
               "values": {"bufferView": model.view(b"".join(struct.pack("<3f", *p) for p in lifted))}}
    moved = model.add("accessors", {**model.json["accessors"][grid], "sparse": changed})
    colors = [[0.8, 0.1, 0.1, 1], [0.1, 0.6, 0.1, 1], [0.1, 0.2, 0.8, 1], [0.8, 0.6, 0.1, 1]]
    paints = [model.paint(color) for color in colors]

    def part(mode, indices, paint, accessor):
        return {"attributes": {"POSITION": accessor}, "mode": mode, "material": paints[paint],
                "indices": model.accessor("SCALAR", UINT, indices)}

    parts = [part(4, [0, 1, 8, 0, 8, 7, 14, 15, 22], 0, grid),
             part(5, [9, 2, 10, 3, 11, 4, 12, 5], 1, grid),
             part(6, [24, 16, 17, 18, 25, 32, 31, 30, 23], 2, grid),
             part(4, [26, 27, 34, 26, 34, 33], 3, moved)]
    alone = [(0, 2.2, 0), (0.5, 2.2, 0), (0.25, 2.6, 0), (0.7, 2.2, 0), (1.2, 2.2, 0), (0.95, 2.6, 0)]
    parts.append({"attributes": {"POSITION": model.accessor("VEC3", FLOAT, alone)},
                  "material": paints[3]})
    model.show(parts, "parts")
    return model


def nodes():
    """Nested, mirrored, by matrix, instanced; and a second scene that is not drawn."""
    model = Model()
    # A wedge that is not its own mirror image, lit by its own normals.
    points = [(0, 0, 0), (0.8, 0, 0), (0.8, 0.3, 0), (0, 0.7, 0), (0, 0, 0.5), (0.8, 0, 0.5)]
    faces = [0, 2, 1, 0, 3, 2, 4, 5, 2, 4, 2, 3, 0, 1, 5, 0, 5, 4, 1, 2, 5, 0, 4, 3]
    wedge = {"attributes": {"POSITION": model.accessor("VEC3", FLOAT, points)},
             "indices": model.accessor("SCALAR", UBYTE, faces),
             "material": model.paint([0.7, 0.3, 0.1, 1])}
    mesh = model.show(wedge, "plain")
    turned = model.add("nodes", {"mesh": mesh, "name": "turned",
                                 "rotation": [0, 0, math.sin(math.pi / 8), math.cos(math.pi / 8)]})
    parent = model.add("nodes", {"translation": [1.6, 0, 0], "scale": [-1, 1, 1], "children": [turned]})
    matrix = model.add("nodes", {"mesh": mesh, "name": "by matrix",
                                 "matrix": [0.5, 0, 0, 0, 0.3, 1, 0, 0, 0, 0, 1, 0, 1.9, 0, 0, 1]})
    places = [(0, 1.0, 0), (0.7, 1.1, 0), (1.4, 1.2, 0)]
    scales = [(0.5, 0.5, 0.5), (0.5, 1, 0.5), (-0.5, 0.5, 0.5)]
    turns = [(0, 0, 0, 1), (0, math.sin(0.3), 0, math.cos(0.3)), (0, 0, 0, 1)]
    instanced = model.add("nodes", {"mesh": mesh, "name": "instances", "extensions": {
        "EXT_mesh_gpu_instancing": {"attributes": {
            "TRANSLATION": model.accessor("VEC3", FLOAT, places),
            "ROTATION": model.accessor("VEC4", FLOAT, turns),
            "SCALE": model.accessor("VEC3", FLOAT, scales)}}}})
    hidden = model.add("nodes", {"mesh": mesh, "name": "elsewhere", "translation": [0.9, 0.5, 0]})
    model.json["extensionsUsed"] = ["EXT_mesh_gpu_instancing"]
    model.json["scenes"][0]["nodes"] += [parent, matrix, instanced]
    model.json["scenes"].insert(0, {"name": "other", "nodes": [hidden]})
    model.json["scene"] = 1
    return model


def skin():
    """A bar of four sections bound to two joints, the upper one bent at rest; the armature is scaled
    by a hundredth, as FBX exporters write it, and its node, which does not count, is far away."""
    model = Model()
    points, joints, weights, indices = [], [], [], []
    for row in range(5):
        for column in (0, 1):
            points.append((column * 40 - 20, row * 50, 0))
            joints.append((0, 1, 0, 0))
            upper = max(0.0, min(1.0, (row - 1.5)))
            weights.append((1 - upper, upper, 0, 0))
    for row in range(4):
        at = row * 2
        indices += [at, at + 1, at + 3, at, at + 3, at + 2]
    bar = {"attributes": {"POSITION": model.accessor("VEC3", FLOAT, points),
                          "JOINTS_0": model.accessor("VEC4", UBYTE, joints),
                          "WEIGHTS_0": model.accessor("VEC4", FLOAT, weights)},
           "indices": model.accessor("SCALAR", USHORT, indices),
           "material": model.paint([0.2, 0.5, 0.8, 1])}
    binds = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
             [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -100, 0, 1]]
    model.show(bar, "bar", (50, 50, 50), skin=0)
    half = math.pi / 6
    upper = model.add("nodes", {"name": "upper", "translation": [0, 100, 0],
                                "rotation": [0, 0, math.sin(half), math.cos(half)]})
    lower = model.add("nodes", {"name": "lower", "children": [upper]})
    armature = model.add("nodes", {"name": "armature", "scale": [0.01] * 3, "children": [lower]})
    model.add("skins", {"joints": [lower, upper],
                        "inverseBindMatrices": model.accessor("MAT4", FLOAT, binds)})
    model.json["scenes"][0]["nodes"].append(armature)
    return model


def materials():
    """Colour times texture, emission, the default material, two sets of texture coordinates."""
    model = Model()
    texture = model.texture(model.image(quarters()))
    model.show(model.quad(model.paint([1, 0.2, 0.2, 1], texture)), "colour times texture",
               (0, 1.1, 0))
    model.show(model.quad(model.paint([0.1, 0.1, 0.1, 1], emissiveFactor=[0, 0.3, 0.05]),
                          places=None), "emission", (1.1, 1.1, 0))
    model.show(model.quad(None, places=None), "default")
    second = model.paint(texture=texture)
    model.json["materials"][second]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 1
    other = model.accessor("VEC2", FLOAT, [(0.5, 1), (1, 1), (1, 0), (0.5, 0)])
    model.show(model.quad(second, places=None, TEXCOORD_1=other), "second set", (1.1, 0, 0))
    return model


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    folder.mkdir(parents=True, exist_ok=True)
    for make in (alpha_modes, wraps, transforms, vertex_colours, quantised, shared, nodes, skin,
                 materials):
        make().save(folder / (make.__name__.replace("_", "-") + ".gltf"))


main()
