#!/usr/bin/env python3
"""Writes the COLLADA models of this folder, one or a few for each core feature, and their pictures.
usage: make_models.py [FOLDER]"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from model_pictures import quarters, stripes

SHORT = "http://www.collada.org/2005/11/COLLADASchema", "1.4.1"
LONG = "http://www.collada.org/2008/03/COLLADASchema", "1.5.0"


def text(values):
    return " ".join(f"{v:g}" for value in values for v in (value if isinstance(value, tuple) else (value,)))


class Model:
    """A file whose parts are added in any order."""

    def __init__(self, asset="<unit meter=\"1\"/><up_axis>Z_UP</up_axis>", schema=SHORT):
        self.asset, self.schema = asset, schema
        self.libraries = {}
        self.scene = []

    def add(self, library, element):
        self.libraries.setdefault(library, []).append(element)
        return len(self.libraries[library])

    def image(self, file, name):
        inner = f"<ref>{file}</ref>" if self.schema == LONG else file
        self.add("images", f'<image id="{name}"><init_from>{inner}</init_from></image>')

    def paint(self, shader, name=None, parameters=""):
        """A material of this shader; its id."""
        number = self.add("effects", "") - 1
        name = name or f"paint{number}"
        self.libraries["effects"][number] = (
            f'<effect id="{name}-fx"><profile_COMMON>{parameters}<technique sid="common">{shader}'
            "</technique></profile_COMMON></effect>")
        self.add("materials", f'<material id="{name}" name="{name}">'
                              f'<instance_effect url="#{name}-fx"/></material>')
        return name

    def textured(self, image, wraps=("WRAP", "WRAP"), places="UV", more="", extra=""):
        modes = f"<wrap_s>{wraps[0]}</wrap_s><wrap_t>{wraps[1]}</wrap_t>"
        if self.schema == LONG:
            parameters = (f'<newparam sid="seen"><sampler2D><instance_image url="#{image}"/>{modes}'
                          "</sampler2D></newparam>")
        else:
            parameters = (f'<newparam sid="held"><surface type="2D"><init_from>{image}</init_from></surface>'
                          f'</newparam><newparam sid="seen"><sampler2D><source>held</source>{modes}'
                          "</sampler2D></newparam>")
        texture = f'<texture texture="seen" texcoord="{places}">{extra}</texture>'
        return self.paint(f"<lambert><diffuse>{texture}</diffuse>{more}</lambert>",
                          parameters=parameters)

    def mesh(self, points, primitives, name=None, **sources):
        """A geometry with its points and other sources: (semantic letters, values)."""
        name = name or f"mesh{len(self.libraries.get('geometries', []))}"
        content = ""
        for key, (letters, values) in {"p": ("XYZ", points), **sources}.items():
            count = len(values) * len(letters)
            params = "".join(f'<param name="{letter}" type="float"/>' for letter in letters)
            content += (
                f'<source id="{name}-{key}"><float_array id="{name}-{key}-a" count="{count}">'
                f'{text(values)}</float_array><technique_common><accessor source="#{name}-{key}-a" '
                f'count="{len(values)}" stride="{len(letters)}">{params}</accessor></technique_common>'
                "</source>")
        content += (f'<vertices id="{name}-v"><input semantic="POSITION" source="#{name}-p"/></vertices>')
        self.add("geometries", f'<geometry id="{name}"><mesh>{content}'
                               f'{primitives.replace("@", "#" + name)}</mesh></geometry>')
        return name

    def show(self, mesh, materials=None, at=(0, 0, 0), transform="", bind=""):
        """A node with the mesh; `materials`: by symbol."""
        if isinstance(materials, str):
            materials = {"M": materials}
        bound = "".join(f'<instance_material symbol="{symbol}" target="#{material}">{bind}'
                        "</instance_material>" for symbol, material in (materials or {}).items())
        if bound:
            bound = f"<bind_material><technique_common>{bound}</technique_common></bind_material>"
        self.node(f'<instance_geometry url="#{mesh}">{bound}</instance_geometry>', at, transform)

    def node(self, content, at=(0, 0, 0), transform="", **attributes):
        named = "".join(f' {key}="{value}"' for key, value in attributes.items())
        moved = f"<translate>{text(at)}</translate>" if at != (0, 0, 0) else ""
        self.scene.append(f"<node{named}>{moved}{transform}{content}</node>")

    def quad(self, places=None, size=1.0, depth=0.0, name=None, **sources):
        """Upright, its front towards -y."""
        points = [(0, depth, 0), (size, depth, 0), (size, depth, size), (0, depth, size)]
        inputs = VERTEX
        for number, places in enumerate(places or []):
            sources[f"t{number}"] = ("ST", places)
            inputs += f'<input semantic="TEXCOORD" source="@-t{number}" offset="0" set="{number}"/>'
        if "c" in sources:
            inputs += '<input semantic="COLOR" source="@-c" offset="0"/>'
        return self.mesh(points, f'<triangles material="M" count="2">{inputs}<p>0 1 2 0 2 3</p></triangles>',
                         name, **sources)

    def content(self):
        result = (f'<?xml version="1.0" encoding="utf-8"?>\n<COLLADA xmlns="{self.schema[0]}" '
                  f'version="{self.schema[1]}">\n<asset>{self.asset}</asset>\n')
        for library, elements in self.libraries.items():
            lines = "\n".join(elements)
            result += f"<library_{library}>\n{lines}\n</library_{library}>\n"
        nodes = "\n".join(self.scene)
        return (result + f'<library_visual_scenes><visual_scene id="scene">\n{nodes}\n</visual_scene>'
                "</library_visual_scenes>\n"
                '<scene><instance_visual_scene url="#scene"/></scene>\n</COLLADA>\n')


VERTEX = '<input semantic="VERTEX" source="@-v" offset="0"/>'
WHOLE = [(0, 0), (1, 0), (1, 1), (0, 1)]
WIDE = [(-0.75, -0.75), (1.75, -0.75), (1.75, 1.75), (-0.75, 1.75)]

# A wedge that is neither its own mirror image nor its own turn, x right, z up.
WEDGE = [(0, 0, 0), (0.8, 0, 0), (0.8, 0, 0.3), (0, 0, 0.7), (0, -0.5, 0), (0.8, -0.5, 0)]
WEDGE_FACES = "0 3 2 1 4 5 2 3 0 4 3 1 2 5 0 1 5 4"
WEDGE_SIZES = "4 4 3 3 4"


def wedge(model, points=WEDGE, name="wedge"):
    return model.mesh(points, f'<polylist material="M" count="5">{VERTEX}<vcount>{WEDGE_SIZES}</vcount>'
                              f"<p>{WEDGE_FACES}</p></polylist>", name)


def color(*parts):
    return f"<color>{text(parts)}</color>"


def lambert(*parts, more=""):
    return f"<lambert><diffuse>{color(*parts, 1)}</diffuse>{more}</lambert>"


def place(number, columns=3):
    return (1.1 * (number % columns), 0, 1.1 * (1 - number // columns))


def materials():
    """<diffuse>, <emission>, a surface that only shines, a parameter, gloss, and no material."""
    model = Model()
    quad = model.quad()
    emission = f"<emission>{color(0, 0.4, 0.1, 1)}</emission>"
    paints = [
        model.paint(lambert(0.8, 0.1, 0.1)),
        model.paint(f"<lambert>{emission}<diffuse>{color(0.2, 0.1, 0.1, 1)}</diffuse></lambert>"),
        model.paint(f"<constant>{emission}</constant>"),
        model.paint("<blinn><diffuse><param ref=\"tint\"/></diffuse></blinn>",
                    parameters='<newparam sid="tint"><float3>0.2 0.3 0.9</float3></newparam>')]
    for number, paint in enumerate(paints):
        model.show(quad, paint, place(number))
    model.show(quad, None, place(4))
    gloss = model.paint(f"<phong><diffuse>{color(0.3, 0.1, 0.4, 1)}</diffuse>"
                        f"<specular>{color(1, 1, 1, 1)}</specular><shininess><float>20</float></shininess></phong>")
    points = [(x, 0, z) for z in (0, 1) for x in (0, 0.5, 1)]
    bent = model.mesh(points, f'<polylist material="M" count="2">{VERTEX}'
                      '<input semantic="NORMAL" source="@-n" offset="1"/><vcount>4 4</vcount>'
                      "<p>0 0 1 1 4 1 3 0 1 1 2 2 5 2 4 1</p></polylist>",
                      n=("XYZ", [(-0.2, -1, 0), (0.3, -1, 0.3), (0.6, -0.8, 0)]))
    model.show(bent, gloss, place(5))
    return model


def transparency():
    """Over a dark back: <transparent> in all four modes, by colour and by the picture's own alpha."""
    model = Model()
    model.image("stripes.png", "stripes")
    model.show(model.quad(size=4.6, depth=0.4), model.paint(lambert(0.05, 0.1, 0.6)), (-0.1, 0, -1.2))
    quad = model.quad()

    def seen(mode, *parts, amount=None):
        opaque = f' opaque="{mode}"' if mode else ""
        more = f"<transparent{opaque}>{color(*parts)}</transparent>" if parts else ""
        if amount is not None:
            more += f"<transparency><float>{amount}</float></transparency>"
        return model.paint(lambert(0.9, 0.8, 0.1, more=more))

    # Opaque; half; half; a quarter.
    for number, paint in enumerate([
            seen("", 1, 1, 1, 1, amount=1), seen("A_ONE", 1, 1, 1, 0.5), seen("", amount=0.5),
            seen("A_ONE", 1, 1, 1, 0.5, amount=0.5),
            # Opaque; half; three quarters.
            seen("RGB_ZERO", 0, 0, 0, 1), seen("RGB_ZERO", 1, 1, 1, 1, amount=0.5),
            seen("RGB_ZERO", 0.5, 0.5, 0.5, 1, amount=0.5),
            # A quarter; half; what exporters write for an opaque one.
            seen("A_ZERO", 1, 1, 1, 0.75), seen("RGB_ONE", 0.5, 0.5, 0.5, 1), seen("", amount=0)]):
        model.show(quad, paint, place(number, 4))
    image = model.textured("stripes", ("CLAMP", "CLAMP"), more='<transparent opaque="A_ONE">'
                           '<texture texture="seen" texcoord="UV"/></transparent>')
    model.show(model.quad([WHOLE]), image, place(10, 4))
    return model


def textures():
    """Every wrap mode, the two sets of coordinates, and Maya's repetition."""
    model = Model()
    model.image("quarters.png", "quarters")
    wide = model.quad([WIDE])
    for number, wraps in enumerate([("WRAP", "WRAP"), ("MIRROR", "MIRROR"), ("CLAMP", "CLAMP"),
                                    ("MIRROR", "CLAMP")]):
        model.show(wide, model.textured("quarters", wraps), place(number, 4))
    two = model.quad([WHOLE, [(0, 0), (0.5, 0), (0.5, 1), (0, 1)]])
    both = model.textured("quarters")
    for number in (0, 1):
        bind = f'<bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="{number}"/>'
        model.show(two, both, place(4 + number, 4), bind=bind)
    model.show(two, model.textured("quarters", places="UV1"), place(6, 4))
    maya = ('<extra><technique profile="MAYA"><repeatU>2</repeatU><repeatV>1</repeatV>'
            "<offsetU>0.25</offsetU><offsetV>0.5</offsetV></technique></extra>")
    model.show(model.quad([WHOLE]), model.textured("quarters", extra=maya), place(7, 4))
    return model


def primitives():
    """Triangles, strips, fans, polygons by count, concave ones, and one with two holes."""
    model = Model()
    paints = [model.paint(lambert(*c)) for c in
              ((0.8, 0.1, 0.1), (0.1, 0.6, 0.2), (0.1, 0.2, 0.8), (0.8, 0.7, 0.1))]
    grid = [(0.25 * x, 0, 0.25 * z) for z in range(5) for x in range(5)]

    def add(number, kind, lists, count):
        mesh = model.mesh(grid, f'<{kind} material="M" count="{count}">{VERTEX}{lists}</{kind}>')
        model.show(mesh, paints[number % 4], place(number))

    add(0, "triangles", "<p>0 4 12 24 20 12</p>", 2)
    add(1, "tristrips", "<p>20 15 21 16 22 17 23</p><p>5 0 6 1 7 2 8 3 9 4</p>", 2)
    add(2, "trifans", "<p>2 9 19 23 21 15 5</p>", 1)
    # An L, an arrow with a notch, and a triangle.
    add(3, "polylist", "<vcount>6 4 3</vcount><p>0 4 9 6 21 20 11 14 24 18 7 8 13</p>", 3)
    add(4, "polygons", "<ph><p>0 4 24 20</p><h>6 11 12 7</h><h>13 18 17</h></ph>", 1)
    # Indices of their own for the normals, which turn the light.
    normals = [(0, -1, 0), (0.8, -0.6, 0), (-0.8, -0.6, 0)]
    mesh = model.mesh(grid, f'<polygons material="M" count="2">{VERTEX}'
                      '<input semantic="NORMAL" source="@-n" offset="1"/>'
                      "<p>0 0 2 0 22 0 20 0</p><p>2 1 4 2 24 2 22 1</p></polygons>", n=("XYZ", normals))
    model.show(mesh, paints[1], place(5))
    return model


def vertex_colours():
    """With and without opacity, times a material, and by face."""
    model = Model()
    corners = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
    three = model.quad(c=("RGB", corners))
    four = model.quad(c=("RGBA", [c + (1,) for c in corners]))
    half = model.paint(lambert(0.5, 0.5, 0.5))
    model.show(three, None, place(0, 2))
    model.show(four, model.paint(lambert(1, 1, 1)), place(1, 2))
    model.show(three, half, place(2, 2))
    points = [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]
    by_face = model.mesh(points, f'<triangles material="M" count="2">{VERTEX}'
                         '<input semantic="COLOR" source="@-c" offset="1"/>'
                         "<p>0 0 1 0 2 0 0 1 2 1 3 1</p></triangles>", c=("RGB", corners))
    model.show(by_face, None, place(3, 2))
    return model


def axis_model(asset, turned, metres):
    """The wedge as a file with this asset writes it, so that all stand alike."""
    model = Model(asset)
    points = [tuple(c / metres for c in turned(*p)) for p in WEDGE]
    model.show(wedge(model, points), model.paint(lambert(0.7, 0.3, 0.1)))
    return model


def up_x():
    return axis_model('<unit name="metre" meter="1"/><up_axis>X_UP</up_axis>', lambda x, y, z: (z, -x, -y), 1)


def up_y():
    return axis_model('<unit name="centimetre" meter=" 0.01"/><up_axis>Y_UP</up_axis>',
                      lambda x, y, z: (x, z, -y), 0.01)


def up_z():
    return axis_model('<unit name="foot" meter="0.25"/><up_axis>Z_UP</up_axis>', lambda x, y, z: (x, y, z), 0.25)


def up_comment():
    """What is commented out does not decide."""
    return axis_model("<!-- <up_axis>Y_UP</up_axis> --><up_axis>\n  <!-- X_UP -->\n  Z_UP </up_axis>",
                      lambda x, y, z: (x, y, z), 1)


def nodes():
    """By matrix, turned, aimed, skewed, mirrored, nested; instances of nodes of a library."""
    model = Model()
    paints = [model.paint(lambert(0.7, 0.3, 0.1)), model.paint(lambert(0.1, 0.5, 0.6))]
    mesh = wedge(model)
    matrix = "<matrix>0.5 0.3 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"
    for number, transform in enumerate([
            "", "<translate>0.3 0 -0.2</translate><rotate>0 1 0 -45</rotate>", "<scale>-1 1 1</scale><translate>-0.8 0 0</translate>", matrix,
            # Looks from there along its -z to the point; its y is up.
            "<lookat>0.4 -0.4 0.4 0.4 0 1 1 0 0</lookat><scale>0.5 0.5 0.5</scale>",
            # Points along z lean towards x.
            "<skew>30 0 0 1 1 0 0</skew><scale>0.7 1 1</scale>"]):
        model.show(mesh, paints[0], place(number), transform)
    bound = ('<bind_material><technique_common><instance_material symbol="M" target="#' + paints[1]
             + '"/></technique_common></bind_material>')
    shape = f'<instance_geometry url="#{mesh}">{bound}</instance_geometry>'
    model.add("nodes", f'<node id="leaf" name="leaf"><scale>0.4 0.4 0.4</scale>{shape}</node>')
    model.add("nodes", '<node id="pair" name="pair"><instance_node url="#leaf"/>'
                       '<node><translate>0.5 0 0</translate><instance_node url="#leaf"/></node></node>')
    model.node('<instance_node url="#pair"/>', (0, 0, -1))
    model.node('<instance_node url="#pair"/>', (1.1, 0, -1), "<rotate>0 1 0 -20</rotate>")
    model.node('<node><translate>1 0 0</translate><instance_node url="#pair"/></node>', (1.2, 0, -1),
               "<scale>1 1 1.5</scale>")
    return model


def bindings():
    """One shape of two symbols, with other materials in each place; a third by the material's id."""
    model = Model()
    paints = [model.paint(lambert(*c)) for c in ((0.8, 0.1, 0.1), (0.1, 0.6, 0.2), (0.1, 0.2, 0.8))]
    named = model.paint(lambert(0.8, 0.7, 0.1), "named")
    grid = [(0.5 * x, 0, 0.5 * z) for z in range(3) for x in range(3)]

    def part(symbol, indices):
        material = f' material="{symbol}"' if symbol else ""
        return f'<polylist{material} count="1">{VERTEX}<vcount>4</vcount><p>{indices}</p></polylist>'

    mesh = model.mesh(grid, part("left", "0 1 4 3") + part("right", "1 2 5 4") + part(named, "3 5 8 6"))
    model.show(mesh, {"left": paints[0], "right": paints[1]}, place(0, 2))
    model.show(mesh, {"left": paints[1], "right": paints[2]}, place(1, 2))
    model.show(mesh, {"right": paints[0], "left": paints[2], named: paints[1]}, place(2, 2))
    alone = model.mesh(grid, part("", "0 2 8 6"))
    model.show(alone, {"anything": paints[2]}, place(3, 2))
    return model


def skin():
    """A bar bound to two joints, in its bind pose: where its bind shape puts it, and its node stands;
    a mesh with a morph target."""
    model = Model()
    points = [(x, 0, z) for z in range(5) for x in (0, 1)]
    faces = "".join(f"{2 * i} {2 * i + 1} {2 * i + 3} {2 * i + 2} " for i in range(4)).strip()
    bar = model.mesh(points, f'<polylist material="M" count="4">{VERTEX}<vcount>4 4 4 4</vcount>'
                             f"<p>{faces}</p></polylist>", "bar")
    identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
    upper = "1 0 0 0 0 1 0 0 0 0 1 -1 0 0 0 1"

    def source(name, kind, param, values, stride=1):
        words = values.split()
        array = "Name_array" if kind == "name" else "float_array"
        return (f'<source id="{name}"><{array} id="{name}-a" count="{len(words)}">{values}</{array}>'
                f'<technique_common><accessor source="#{name}-a" count="{len(words) // stride}" '
                f'stride="{stride}"><param name="{param}" type="{kind}"/></accessor></technique_common></source>')

    model.add("controllers", (
        f'<controller id="bent"><skin source="#{bar}">'
        "<bind_shape_matrix> 0.5 0 0 0.2 0 1 0 0 0 0 0.5 0.1 0 0 0 1</bind_shape_matrix>"
        + source("joints", "name", "JOINT", "lower upper")
        + source("binds", "float4x4", "TRANSFORM", identity + " " + upper, 16)
        + source("weights", "float", "WEIGHT", "1 0.5")
        + '<joints><input semantic="JOINT" source="#joints"/><input semantic="INV_BIND_MATRIX" source="#binds"/>'
        '</joints><vertex_weights count="10"><input semantic="JOINT" source="#joints" offset="0"/>'
        '<input semantic="WEIGHT" source="#weights" offset="1"/><vcount>1 1 1 1 2 2 1 1 1 1</vcount>'
        "<v> 0 0 0 0 0 0 0 0 0 1 1 1 0 1 1 1 1 0 1 0 1 0 1 0</v></vertex_weights></skin></controller>"))
    target = model.quad(name="target", size=0.2)
    base = model.quad(name="base")
    model.add("controllers", (
        f'<controller id="morphed"><morph source="#{base}" method="NORMALIZED">'
        + f'<source id="targets"><IDREF_array id="targets-a" count="1">{target}</IDREF_array><technique_common>'
        '<accessor source="#targets-a" count="1" stride="1"><param name="MORPH_TARGET" type="IDREF"/></accessor>'
        "</technique_common></source>" + source("amounts", "float", "MORPH_WEIGHT", "0.5")
        + '<targets><input semantic="MORPH_TARGET" source="#targets"/>'
        '<input semantic="MORPH_WEIGHT" source="#amounts"/></targets></morph></controller>'))
    paints = [model.paint(lambert(0.2, 0.5, 0.8)), model.paint(lambert(0.8, 0.5, 0.2))]
    for number, controller in enumerate(("bent", "morphed")):
        skeleton = "<skeleton>#hip</skeleton>" if controller == "bent" else ""
        model.node(f'<instance_controller url="#{controller}">{skeleton}<bind_material><technique_common>'
                   f'<instance_material symbol="M" target="#{paints[number]}"/></technique_common></bind_material>'
                   "</instance_controller>", (1.1 * number, 0, 0),
                   "" if number else "<matrix>0.5 0 0 0.2 0 1 0 0 0 0 0.5 0.1 0 0 0 1</matrix>")
    model.node('<node id="top" sid="upper" type="JOINT"><translate>0 0 1</translate></node>', id="hip",
               sid="lower", type="JOINT")
    return model


def picture_model(schema, blanks=False):
    model = Model(schema=schema)
    model.image("quarters.png", "quarters")
    model.show(model.quad([WHOLE]), model.textured("quarters", ("CLAMP", "MIRROR")))
    model.show(model.quad(), model.paint(lambert(0.1, 0.6, 0.2), "grün"), (0, 0, 1.1))
    return model


def version_1_5():
    return picture_model(LONG).content()


def blanks():
    """Blanks and line ends before, between and behind all numbers."""
    content = picture_model(SHORT).content()
    for name in ("color", "translate", "p", "up_axis", "init_from", "source", "wrap_s"):
        content = content.replace(f"<{name}>", f"<{name}>\n\t ").replace(f"</{name}>", f" \r\n</{name}>")
    return content.replace('">0 0 0 1', '">\n  0 0\n0  1').replace("0.1 0.6", "0.1\t\n0.6")


def utf_16():
    return picture_model(SHORT).content().replace("utf-8", "utf-16")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "quarters.png").write_bytes(quarters())
    (folder / "stripes.png").write_bytes(stripes())
    for make in (materials, transparency, textures, primitives, vertex_colours, up_x, up_y, up_z,
                 up_comment, nodes, bindings, skin, version_1_5, blanks, utf_16):
        made = make()
        content = made if isinstance(made, str) else made.content()
        encoded = b"\xff\xfe" + content.encode("utf-16-le") if make == utf_16 else content.encode()
        (folder / (make.__name__.replace("_", "-") + ".dae")).write_bytes(encoded)


main()
