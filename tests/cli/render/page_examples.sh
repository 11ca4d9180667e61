# Every example of docs/programs/render.md is taken as it stands, but small, and makes the files that it names.
cp "$SRC"/examples/demo/*.* . && cp -r "$SRC/examples/demo/arm" "$SRC/examples/demo/textures" .
mv demo.cell.toml cell.toml && cp arm.urdf panda.urdf && cp session.mcap today.mcap && cp session.mcap accepted.mcap
mkdir bin && printf '#!/bin/sh\nfor last; do :; done\ncat >"${last#file:}"\n' >bin/ffmpeg && chmod +x bin/ffmpeg
# What examples of backdrops name; the video is a picture here (tests/cli/render/backdrop.sh has videos).
rocinante render cell.toml session.mcap --at 0 --samples 1 --size 64x48 -o photo.png
printf '\n[[camera]]\nname = "bench-camera"\neye = [1.9, -1.4, 1.25]\ntarget = [0.2, 0.1, 0.3]\n%s\n' \
  'intrinsics = { fx = 45.0, fy = 45.0, cx = 31.5, cy = 23.5, width = 64, height = 48 }' >>cell.toml
cat >run.py <<'PY'
import os, re, shlex, subprocess
page = open(os.environ["SRC"] + "/docs/programs/render.md", encoding="utf-8").read()
blocks = re.findall(r"^```\n(.*?)^```", page, re.M | re.S)
commands = [line for block in blocks for line in block.splitlines() if line.startswith("rocinante render ")]
commands = [line for line in commands if "[" not in line]  # but for the synopsis
ran = 0
for command in commands:
    command = command.replace("take3.mp4", "photo.png")
    small = " --samples 1 --shading plain" + ("" if "--size" in command else " --size 32x24")
    if "--video" in command:
        small += " --from 2s --until 2200ms"
    made = re.findall(r"(?:-o|--sheet|--frames|--video|--identity|--depth) (\S+)", command)
    said = subprocess.run(shlex.split(command + small), capture_output=True, text=True)
    ran += 1
    missing = [name for name in made if not os.path.exists(name)]
    if said.returncode != 0 or missing or not made:
        print(f"$ {command}\nexit {said.returncode}, not made: {missing}\n{said.stderr}")
print("all are taken" if ran >= 8 else f"only {ran} examples")
PY
PATH=$PWD/bin:$PATH python3 run.py
