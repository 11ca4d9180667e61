#!/usr/bin/env python3
"""The table at the end of scripts/demo, from the files that the programs wrote.
usage: demo_table.py FOLDER. Exit 1 when the two logs do not hold the same datagrams in order."""
import json
import pathlib
import subprocess
import sys

folder = pathlib.Path(sys.argv[1])


def load(name):
    return json.loads((folder / name).read_text())


def payloads(log):
    """Captured datagrams in the log's order. The player's own restatements are none of them."""
    command = ["rocinante", "log", "cat", "--format", "json", str(folder / log)]
    lines = subprocess.run(command, check=True, capture_output=True).stdout.splitlines()
    found = []
    for line in lines:
        message = json.loads(line)
        if not message["channel"].startswith("/rocinante/"):
            found.append(message.get("text") or message.get("payload_base64"))
    return found


info, play, golden, check = (load(n) for n in ("info.json", "play.json", "golden.json", "check.json"))
live, replay = payloads("live.mcap"), payloads("replay.mcap")
same_order = live == replay
losses = info["losses"]
late = play["late_us"]
rows = [
    ("datagrams recorded live", f"{info['messages']}"),
    ("lost (kernel, queue, disk)", f"{losses['kernel']}, {losses['queue']}, {losses['disk']}"),
    ("gaps in the sources' sequences", f"{losses['source_gap']}"),
    ("replayed at 4x, recorded again", f"{play['sent']} sent, {len(replay)} recorded"),
    ("same datagrams in the same order", "yes" if same_order else "NO"),
    ("timing error p50 / p99 / max", f"{late['p50']} / {late['p99']} / {late['max']} us"),
    ("drift over the replay", f"{play['drift_us']} us"),
    ("frames judged", f"{len(golden['frames'])}"),
    ("golden verdict", golden["verdict"]),
    ("check verdict", check["verdict"]),
]
width = max(len(name) for name, _ in rows)
for name, value in rows:
    print(f"  {name:<{width}}  {value}")
sys.exit(0 if same_order else 1)
