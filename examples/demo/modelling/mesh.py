"""Wavefront OBJ from a few machine-like shapes: chamfered boxes, turned parts, plates, pipes.

Metres, z up. Faces wind counter-clockwise seen from outside. Round parts carry smooth normals,
edges sharper than CREASE_DEG stay hard.
"""

import math

CREASE_DEG = 35.0


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a, factor):
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return scaled(a, 1.0 / length)


def along(axis, point):
    """The local z axis laid along `axis`, without mirroring: 'z' itself, 'x' or 'y'."""
    x, y, z = point
    return {"z": (x, y, z), "x": (z, x, y), "y": (y, z, x)}[axis]


class Mesh:
    """Faces by group and material, each corner a position, a normal and perhaps a texture place."""

    def __init__(self):
        self.faces = {}  # group -> material -> faces, in order of first use
        self.group = "base"
        self.material = "default"

    def use(self, material=None, group=None):
        self.material = material or self.material
        self.group = group or self.group

    def face(self, points, normals, places=None):
        corners = list(zip(points, normals, places or [None] * len(points)))
        self.faces.setdefault(self.group, {}).setdefault(self.material, []).append(corners)

    def flat(self, points, places=None):
        normal = unit(cross(subtract(points[1], points[0]), subtract(points[2], points[0])))
        self.face(points, [normal] * len(points), places)

    # --- boxes ---------------------------------------------------------------------------

    def box(self, low, high, chamfer=0.0):
        """From corner `low` to corner `high`, every edge broken by `chamfer`."""
        c = chamfer

        def corner(signs, inset_axes):
            """A corner, moved inwards by the chamfer along each of `inset_axes`."""
            return tuple(
                (high[i] - (c if i in inset_axes else 0.0)) if signs[i] > 0
                else (low[i] + (c if i in inset_axes else 0.0))
                for i in range(3))

        def outward(points, direction):
            normal = cross(subtract(points[1], points[0]), subtract(points[2], points[0]))
            self.flat(points if dot(normal, direction) > 0 else points[::-1])

        for axis in range(3):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            for side in (-1, 1):
                points = []
                for sa, sb in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                    signs = [0, 0, 0]
                    signs[axis], signs[a], signs[b] = side, sa, sb
                    points.append(corner(signs, (a, b)))
                direction = [0, 0, 0]
                direction[axis] = side
                outward(points, direction)
        if not c:
            return
        for axis in range(3):  # the edges along each axis
            a, b = (axis + 1) % 3, (axis + 2) % 3
            for sa in (-1, 1):
                for sb in (-1, 1):
                    points = []
                    for end, inset in ((-1, a), (1, a), (1, b), (-1, b)):
                        signs = [0, 0, 0]
                        signs[axis], signs[a], signs[b] = end, sa, sb
                        points.append(corner(signs, (axis, inset)))
                    direction = [0, 0, 0]
                    direction[a], direction[b] = sa, sb
                    outward(points, direction)
        for sx in (-1, 1):
            for sy in (-1, 1):
                for sz in (-1, 1):
                    signs = (sx, sy, sz)
                    outward([corner(signs, pair) for pair in ((1, 2), (0, 2), (0, 1))], signs)

    def block(self, centre, size, chamfer=0.0):
        half = scaled(size, 0.5)
        self.box(subtract(centre, half), add(centre, half), chamfer)

    # --- turned parts --------------------------------------------------------------------

    def lathe(self, profile, centre=(0, 0, 0), axis="z", segments=32, first_deg=0.0, span_deg=360.0,
              places=None):
        """Turns (radius, height) points, given upwards along the outside, about `axis`.

        `places` gives v of the texture for each point of the profile; u runs once round.
        """
        edge_normals = []
        for (r0, h0), (r1, h1) in zip(profile, profile[1:]):
            length = math.hypot(r1 - r0, h1 - h0)
            edge_normals.append(((h1 - h0) / length, -(r1 - r0) / length))
        crease = math.cos(math.radians(CREASE_DEG))

        def at_end(edge, other):
            if not 0 <= other < len(edge_normals):
                return edge_normals[edge]
            a, b = edge_normals[edge], edge_normals[other]
            if a[0] * b[0] + a[1] * b[1] < crease:
                return a
            total = (a[0] + b[0], a[1] + b[1])
            length = math.hypot(*total)
            return (total[0] / length, total[1] / length)

        def around(step, radius, height):
            angle = math.radians(first_deg + span_deg * step / segments)
            return along(axis, (radius * math.cos(angle), radius * math.sin(angle), height))

        for edge in range(len(edge_normals)):
            (r0, h0), (r1, h1) = profile[edge], profile[edge + 1]
            n0, n1 = at_end(edge, edge - 1), at_end(edge, edge + 1)
            for step in range(segments):
                corners = [(step, r0, h0, n0, edge), (step + 1, r0, h0, n0, edge),
                           (step + 1, r1, h1, n1, edge + 1), (step, r1, h1, n1, edge + 1)]
                if r0 == 0:
                    del corners[1]
                elif r1 == 0:
                    del corners[2]
                points = [add(centre, around(s, r, h)) for s, r, h, _, _ in corners]
                normals = [around(s, n[0], n[1]) for s, _, _, n, _ in corners]
                where = [(s / segments, places[i]) for s, _, _, _, i in corners] if places else None
                self.face(points, normals, where)

    def cylinder(self, radius, low, high, centre=(0, 0, 0), axis="z", segments=24, bevel=0.0):
        """A closed cylinder between two heights along `axis`, its rims broken by `bevel`."""
        profile = [(0, low), (radius - bevel, low), (radius, low + bevel), (radius, high - bevel),
                   (radius - bevel, high), (0, high)]
        if not bevel:
            profile = [(0, low), (radius, low), (radius, high), (0, high)]
        self.lathe(profile, centre, axis, segments)

    def ball(self, radius, centre, segments=16, rings=8):
        profile = [(radius * math.sin(math.pi * i / rings), -radius * math.cos(math.pi * i / rings))
                   for i in range(rings + 1)]
        profile[0], profile[-1] = (0, -radius), (0, radius)
        self.lathe(profile, centre, "z", segments)

    # --- plates --------------------------------------------------------------------------

    def plate(self, outline, low, high, axis="z", centre=(0, 0, 0), bevel=0.0):
        """A convex outline in the two axes after `axis` (for 'y': x and z), between two heights
        along it, the rims broken by `bevel`."""
        if axis == "y":
            outline = [(b, a) for a, b in outline]
        area = sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(outline, outline[1:] + outline[:1]))
        if area < 0:
            outline = outline[::-1]
        count = len(outline)
        edges = []
        for i in range(count):
            p, q = outline[i], outline[(i + 1) % count]
            length = math.hypot(q[0] - p[0], q[1] - p[1])
            edges.append(((q[1] - p[1]) / length, -(q[0] - p[0]) / length))
        inner = []
        for i, p in enumerate(outline):
            a, b = edges[i - 1], edges[i]
            factor = bevel / (1 + a[0] * b[0] + a[1] * b[1])
            inner.append((p[0] - (a[0] + b[0]) * factor, p[1] - (a[1] + b[1]) * factor))
        crease = math.cos(math.radians(CREASE_DEG))

        def side_normal(edge, other):
            a, b = edges[edge % count], edges[other % count]
            if a[0] * b[0] + a[1] * b[1] < crease:
                return (a[0], a[1], 0)
            return unit((a[0] + b[0], a[1] + b[1], 0))

        def put(points, normals):
            self.face([add(centre, along(axis, p)) for p in points],
                      [along(axis, n) for n in normals])

        for i in range(count):
            j = (i + 1) % count
            n0, n1 = side_normal(i, i - 1), side_normal(i, i + 1)
            p, q, pi, qi = outline[i], outline[j], inner[i], inner[j]
            put([(*p, low + bevel), (*q, low + bevel), (*q, high - bevel), (*p, high - bevel)],
                [n0, n1, n1, n0])
            if bevel:
                u0, u1 = unit(add(n0, (0, 0, 1))), unit(add(n1, (0, 0, 1)))
                d0, d1 = unit(add(n0, (0, 0, -1))), unit(add(n1, (0, 0, -1)))
                put([(*p, high - bevel), (*q, high - bevel), (*qi, high), (*pi, high)],
                    [u0, u1, u1, u0])
                put([(*pi, low), (*qi, low), (*q, low + bevel), (*p, low + bevel)],
                    [d0, d1, d1, d0])
        put([(*p, high) for p in inner], [(0, 0, 1)] * count)
        put([(*p, low) for p in inner[::-1]], [(0, 0, -1)] * count)

    # --- pipes ---------------------------------------------------------------------------

    def pipe(self, points, radius, bend=0.0, segments=12, steps=5):
        """A round pipe along a polyline whose corners are bent with radius `bend`."""
        line = [points[0]]
        for before, corner, after in zip(points, points[1:], points[2:]):
            line += bent(before, corner, after, bend, steps) if bend else [corner]
        line.append(points[-1])
        directions = [unit(subtract(b, a)) for a, b in zip(line, line[1:])]
        tangents = [directions[0]]
        tangents += [unit(add(a, b)) for a, b in zip(directions, directions[1:])]
        tangents.append(directions[-1])
        helper = (0, 0, 1) if abs(tangents[0][2]) < 0.9 else (1, 0, 0)
        side = unit(cross(helper, tangents[0]))
        rings = []
        for centre, tangent in zip(line, tangents):
            side = unit(subtract(side, scaled(tangent, dot(side, tangent))))
            other = cross(tangent, side)
            ring = []
            for step in range(segments):
                angle = 2 * math.pi * step / segments
                normal = add(scaled(side, math.cos(angle)), scaled(other, math.sin(angle)))
                ring.append((add(centre, scaled(normal, radius)), normal))
            rings.append(ring)
        for low, high in zip(rings, rings[1:]):
            for i in range(segments):
                j = (i + 1) % segments
                corners = [low[i], low[j], high[j], high[i]]
                self.face([c[0] for c in corners], [c[1] for c in corners])
        self.flat([c[0] for c in rings[0][::-1]])
        self.flat([c[0] for c in rings[-1]])


def bent(before, corner, after, radius, steps):
    """The points of an arc that rounds a corner."""
    into, out = unit(subtract(before, corner)), unit(subtract(after, corner))
    half = math.acos(max(-1.0, min(1.0, dot(into, out)))) / 2
    if abs(half - math.pi / 2) < 1e-6:
        return [corner]
    reach = radius / math.tan(half)
    middle = add(corner, scaled(unit(add(into, out)), radius / math.sin(half)))
    first = subtract(add(corner, scaled(into, reach)), middle)
    last = subtract(add(corner, scaled(out, reach)), middle)
    sweep = math.pi - 2 * half
    return [add(middle, add(scaled(first, math.sin(sweep * (1 - i / steps)) / math.sin(sweep)),
                            scaled(last, math.sin(sweep * i / steps) / math.sin(sweep))))
            for i in range(steps + 1)]


def two_circles(first, first_radius, second, second_radius, steps=10):
    """The outline that a belt round two circles has."""
    dx, dy = second[0] - first[0], second[1] - first[1]
    heading = math.atan2(dy, dx)
    half = math.acos((first_radius - second_radius) / math.hypot(dx, dy))
    outline = []
    for centre, radius, start, sweep in ((second, second_radius, heading - half, 2 * half),
                                         (first, first_radius, heading + half,
                                          2 * math.pi - 2 * half)):
        for i in range(steps + 1):
            angle = start + sweep * i / steps
            outline.append((centre[0] + radius * math.cos(angle),
                            centre[1] + radius * math.sin(angle)))
    return outline


def rounded_rectangle(low, high, radius, steps=4):
    outline = []
    for x, y, start in ((high[0] - radius, low[1] + radius, -90),
                        (high[0] - radius, high[1] - radius, 0),
                        (low[0] + radius, high[1] - radius, 90),
                        (low[0] + radius, low[1] + radius, 180)):
        for i in range(steps + 1):
            angle = math.radians(start + 90 * i / steps)
            outline.append((x + radius * math.cos(angle), y + radius * math.sin(angle)))
    return outline
