"""Puts the Ethernet frames of a capture (pcap, in microseconds) on an interface, five times as fast as
they were captured; of any length the interface takes.

usage: send_frames.py INTERFACE CAPTURE
"""
import socket
import struct
import sys
import time

interface, capture = sys.argv[1:]
with open(capture, "rb") as file:
    data = file.read()
order = "<" if data[:4] == b"\xd4\xc3\xb2\xa1" else ">"
wire = socket.socket(socket.AF_PACKET, socket.SOCK_RAW)
wire.bind((interface, 0))
begun, first, at = time.monotonic(), None, 24
while at < len(data):
    seconds, microseconds, length, whole = struct.unpack_from(order + "IIII", data, at)
    assert length == whole, "a frame was not captured whole"
    when = seconds + microseconds / 1e6
    first = when if first is None else first
    time.sleep(max(0, begun + (when - first) / 5 - time.monotonic()))
    wire.send(data[at + 16:at + 16 + length])
    at += 16 + length
