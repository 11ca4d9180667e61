"""A small painter in plain Python: rectangles, stripes, strokes of text; and a PNG writer."""

import struct
import zlib

# Strokes on a grid four wide and six high, y up. A letter is a list of polylines.
GLYPHS = {
    "0": ["10 30 41 45 36 16 05 01 10"], "1": ["14 26 20", "10 30"],
    "2": ["05 16 36 45 44 00 40"], "3": ["05 16 36 45 44 33 13", "33 42 41 30 10 01"],
    "4": ["30 36 02 42"], "5": ["46 06 03 33 42 41 30 00"],
    "6": ["45 36 16 05 01 10 30 41 42 33 13 02"], "7": ["06 46 10"],
    "8": ["13 02 01 10 30 41 42 33 13 04 05 16 36 45 44 33"],
    "9": ["01 10 30 41 45 36 16 05 04 13 33 44"],
    "A": ["00 26 40", "12 32"], "B": ["00 06 36 45 44 33 03", "33 42 41 30 00"],
    "C": ["45 36 16 05 01 10 30 41"], "D": ["00 06 26 44 42 20 00"], "E": ["46 06 00 40", "03 33"],
    "F": ["46 06 00", "03 33"], "G": ["45 36 16 05 01 10 30 41 43 23"],
    "H": ["00 06", "40 46", "03 43"], "I": ["20 26", "10 30", "16 36"],
    "K": ["00 06", "46 03 40"], "L": ["06 00 40"], "M": ["00 06 23 46 40"], "N": ["00 06 40 46"],
    "O": ["10 30 41 45 36 16 05 01 10"], "P": ["00 06 36 45 44 33 03"],
    "R": ["00 06 36 45 44 33 03", "23 40"], "S": ["45 36 16 05 04 13 33 42 41 30 10 01"],
    "T": ["20 26", "06 46"], "U": ["06 01 10 30 41 46"], "V": ["06 20 46"],
    "W": ["06 10 23 30 46"], "X": ["00 46", "06 40"], "Y": ["20 23 06", "23 46"],
    "Z": ["06 46 00 40"], "-": ["13 33"], " ": [],
}


class Picture:
    """Eight-bit RGB rows; x to the right, y down."""

    def __init__(self, width, height, color):
        self.width, self.height = width, height
        self.rows = [bytearray(bytes(color) * width) for _ in range(height)]

    def blend(self, x, y, color, share):
        if not (0 <= x < self.width and 0 <= y < self.height) or share <= 0:
            return
        row, at = self.rows[y], 3 * x
        for i in range(3):
            row[at + i] = int(row[at + i] + (color[i] - row[at + i]) * min(share, 1.0) + 0.5)

    def rectangle(self, left, top, right, bottom, color):
        left, right = max(left, 0), min(right, self.width)
        if right <= left:
            return
        for y in range(max(top, 0), min(bottom, self.height)):
            self.rows[y][3 * left:3 * right] = bytes(color) * (right - left)

    def stripes(self, left, top, right, bottom, colors, pitch):
        """Hazard stripes at 45 degrees, two colours of equal width."""
        for y in range(max(top, 0), min(bottom, self.height)):
            for x in range(max(left, 0), min(right, self.width)):
                # Four samples across soften the slanting edges.
                share = sum((4 * (x + y) + i) % (8 * pitch) < 4 * pitch for i in range(4)) / 4
                self.blend(x, y, colors[0], 1)
                self.blend(x, y, colors[1], share)

    def frame(self, left, top, right, bottom, line, paint):
        """Calls `paint(left, top, right, bottom)` for the four sides of a frame."""
        paint(left, top, right, top + line)
        paint(left, bottom - line, right, bottom)
        paint(left, top + line, left + line, bottom - line)
        paint(right - line, top + line, right, bottom - line)

    def stroke(self, a, b, width, color):
        half = width / 2
        dx, dy = b[0] - a[0], b[1] - a[1]
        squared = dx * dx + dy * dy or 1e-9
        for y in range(int(min(a[1], b[1]) - half) - 1, int(max(a[1], b[1]) + half) + 2):
            for x in range(int(min(a[0], b[0]) - half) - 1, int(max(a[0], b[0]) + half) + 2):
                px, py = x + 0.5 - a[0], y + 0.5 - a[1]
                t = max(0.0, min(1.0, (px * dx + py * dy) / squared))
                ex, ey = px - t * dx, py - t * dy
                self.blend(x, y, color, half + 0.5 - (ex * ex + ey * ey) ** 0.5)

    def text(self, words, centre_x, baseline, height, color, stretch=1.0, weight=0.16):
        """Letters `height` pixels high, centred on `centre_x`; `stretch` widens them."""
        step = height / 6
        advance = 6 * step * stretch
        left = centre_x - (len(words) * advance - 2 * step * stretch) / 2
        for letter in words:
            for line in GLYPHS[letter]:
                points = [(left + int(p[0]) * step * stretch, baseline - int(p[1]) * step)
                          for p in line.split()]
                for a, b in zip(points, points[1:]):
                    self.stroke(a, b, height * weight, color)
            left += advance

    def grain(self, amount, cell):
        """Makes even ground look like poured concrete: squares a little lighter or darker."""
        for y, row in enumerate(self.rows):
            for first in range(0, self.width, cell):
                mixed = (first // cell * 0x9E3779B1 ^ y // cell * 0x85EBCA77) & 0xFFFFFFFF
                mixed = (mixed ^ mixed >> 15) * 0x2C1B3C6D & 0xFFFFFFFF
                shift = (mixed >> 16) % (2 * amount + 1) - amount
                for at in range(3 * first, min(3 * (first + cell), len(row))):
                    row[at] = max(0, min(255, row[at] + shift))

    def png(self):
        """The same bytes for the same picture: each row takes the filter of least magnitude."""
        previous = bytes(3 * self.width)
        out = bytearray()
        for row in self.rows:
            plain = bytes(row)
            left = bytes((b - a) & 255 for a, b in zip(b"\0\0\0" + plain, plain))
            up = bytes((b - a) & 255 for a, b in zip(previous, plain))
            kind, best = min(((0, plain), (1, left), (2, up)),
                             key=lambda c: sum(min(v, 256 - v) for v in c[1]))
            out += bytes([kind]) + best
            previous = plain

        def chunk(name, data):
            return (struct.pack(">I", len(data)) + name + data
                    + struct.pack(">I", zlib.crc32(name + data)))

        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head)
                + chunk(b"IDAT", zlib.compress(bytes(out), 9)) + chunk(b"IEND", b""))
