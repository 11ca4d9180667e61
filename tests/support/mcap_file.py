"""MCAP files by their bytes, as other writers make them: for cases on the command line.

    log = McapFile(profile='', library='someone')
    log.chunk([(channel, time_ns, payload), ...])       # channel: (id, topic, encoding, {metadata})
    log.save('x.mcap')                                  # with DataEnd, summary, Footer
"""
import struct
import zlib

MAGIC = b'\x89MCAP0\r\n'


def text(value):
    value = value if isinstance(value, bytes) else value.encode()
    return struct.pack('<I', len(value)) + value


def table(entries):
    packed = b''.join(text(k) + text(v) for k, v in entries.items())
    return struct.pack('<I', len(packed)) + packed


def record(opcode, content):
    return struct.pack('<BQ', opcode, len(content)) + content


def channel_record(channel):
    number, topic, encoding, metadata = channel
    return record(4, struct.pack('<HH', number, 0) + text(topic) + text(encoding) + table(metadata))


def message_record(number, sequence, time_ns, payload):
    return record(5, struct.pack('<HIQQ', number, sequence, time_ns, time_ns) + payload)


def zstd_of_one_byte(head, filler, count):
    """A zstd frame of `head`, then `count` times the byte `filler`, in as few bytes as zstd allows."""
    blocks = []
    if head:
        blocks.append((0, len(head), head))
    while count > 0:
        part = min(count, 128 << 10)
        blocks.append((1, part, filler))
        count -= part
    # No content size, a window of 128 KiB.
    frame = b'\x28\xb5\x2f\xfd\x00' + bytes([7 << 3])
    for i, (kind, size, data) in enumerate(blocks):
        last = i + 1 == len(blocks)
        frame += struct.pack('<I', (size << 3) | (kind << 1) | last)[:3] + data
    return frame


class McapFile:
    def __init__(self, profile='', library='test'):
        self.bytes = MAGIC + record(1, text(profile) + text(library))
        self.channels = {}
        self.counts = {}
        self.chunks = []  # (start, end, offset, length, index offsets, index bytes, compression, sizes)
        self.metadata_indexes = []
        self.sequence = 0

    def metadata(self, name, entries):
        stored = record(12, text(name) + table(entries))
        self.metadata_indexes.append((len(self.bytes), len(stored), name))
        self.bytes += stored
        return self

    def session(self, origin_ns, fmt='1'):
        return self.metadata('rocinante.session',
                             {'format': fmt, 'session_id': 's', 'origin_ns': str(origin_ns)})

    def chunk(self, messages, crc=True):
        """Uncompressed, with its message indexes."""
        records, indexes, defined = b'', {}, set()
        for channel, time_ns, payload in messages:
            if channel[0] not in defined:
                defined.add(channel[0])
                self.channels.setdefault(channel[0], channel)
                records += channel_record(channel)
            indexes.setdefault(channel[0], []).append((time_ns, len(records)))
            records += message_record(channel[0], self.sequence, time_ns, payload)
            self.sequence += 1
        times = [time_ns for _, time_ns, _ in messages]
        return self.raw_chunk(min(times), max(times), '', records, len(records),
                              zlib.crc32(records) if crc else 0, indexes)

    def bomb(self, channel, time_ns, size):
        """One message of zeros, `size` bytes, in a few thousand times fewer."""
        self.channels.setdefault(channel[0], channel)
        head = channel_record(channel)
        at = len(head)
        head += message_record(channel[0], self.sequence, time_ns, b'')[:1]
        head += struct.pack('<Q', 22 + size) + struct.pack('<HIQQ', channel[0], self.sequence, time_ns,
                                                           time_ns)
        self.sequence += 1
        return self.raw_chunk(time_ns, time_ns, 'zstd', zstd_of_one_byte(head, b'\0', size),
                              len(head) + size, 0, {channel[0]: [(time_ns, at)]})

    def raw_chunk(self, start, end, compression, stored, size, crc, indexes):
        offset = len(self.bytes)
        self.bytes += record(6, struct.pack('<QQQI', start, end, size, crc) + text(compression) +
                             struct.pack('<Q', len(stored)) + stored)
        length = len(self.bytes) - offset
        offsets = {}
        for number, entries in indexes.items():
            offsets[number] = len(self.bytes)
            self.counts[number] = self.counts.get(number, 0) + len(entries)
            packed = b''.join(struct.pack('<QQ', *entry) for entry in entries)
            self.bytes += record(7, struct.pack('<HI', number, len(packed)) + packed)
        self.chunks.append((start, end, offset, length, offsets,
                            len(self.bytes) - offset - length, compression, len(stored), size))
        return self

    def end(self, summary=True):
        self.bytes += record(15, struct.pack('<I', 0))
        start = len(self.bytes)
        out = b''
        if summary:
            for channel in self.channels.values():
                out += channel_record(channel)
            packed = b''.join(struct.pack('<HQ', k, v) for k, v in self.counts.items())
            starts = [c[0] for c in self.chunks] or [0]
            ends = [c[1] for c in self.chunks] or [0]
            out += record(11, struct.pack('<QHIIIIQQI', sum(self.counts.values()), 0,
                                          len(self.channels), 0, len(self.metadata_indexes),
                                          len(self.chunks), min(starts), max(ends), len(packed)) +
                          packed)
            for s, e, offset, length, offsets, index_bytes, compression, stored, size in self.chunks:
                packed = b''.join(struct.pack('<HQ', k, v) for k, v in offsets.items())
                out += record(8, struct.pack('<QQQQI', s, e, offset, length, len(packed)) + packed +
                              struct.pack('<Q', index_bytes) + text(compression) +
                              struct.pack('<QQ', stored, size))
            for offset, length, name in self.metadata_indexes:
                out += record(13, struct.pack('<QQ', offset, length) + text(name))
        footer = struct.pack('<BQQQ', 2, 20, start if summary else 0, 0)
        self.bytes += out + footer + struct.pack('<I', zlib.crc32(out + footer)) + MAGIC
        return self

    def save(self, path, summary=True):
        self.end(summary)
        with open(path, 'wb') as file:
            file.write(self.bytes)
