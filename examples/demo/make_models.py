#!/usr/bin/env python3
"""Writes the geometry and textures of the demo cell: OBJ, MTL and PNG files.

    python3 make_models.py [FOLDER]

FOLDER is this file's own by default. Plain Python 3, no packages; the same bytes every time.
"""

import pathlib
import sys

sys.dont_write_bytecode = True

from modelling import arm, canister, farm, gantry, hall, pipes, textures  # noqa: E402
from modelling.wavefront import mtl_text, obj_text  # noqa: E402


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    if len(sys.argv) < 2:
        folder = folder.parent

    def write(name, content):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode("ascii"))

    def write_model(name, mesh, material_file, materials, what):
        write(name, obj_text(mesh, pathlib.PurePath(material_file).name, what))
        write(material_file, mtl_text(materials))

    for link, make in arm.LINKS.items():
        write_model(f"arm/{link}.obj", make(), "arm/arm.mtl", arm.MATERIALS,
                    f"The demo arm: {link}")
    write_model("gantry.obj", gantry.gantry(), "gantry.mtl", gantry.MATERIALS,
                "The demo gantry at zero joints")
    write_model("canister.obj", canister.canister(), "canister.mtl", canister.MATERIALS,
                "A canister")
    write_model("tank_farm.obj", farm.tank_farm(), "tank_farm.mtl", farm.MATERIALS,
                "Four tanks")
    write_model("pipes.obj", pipes.pipes(), "pipes.mtl", pipes.MATERIALS, "The tanks' pipes")
    write_model("hall.obj", hall.hall(), "hall.mtl", hall.MATERIALS,
                "Floor, railings, pallet, station, cabinet")
    write_model("signs.obj", hall.signs(), "signs.mtl", hall.SIGN_MATERIALS, "A sign")
    write("textures/tank_shells.png", textures.tank_shells().png())
    write("textures/floor.png", textures.floor().png())
    write("textures/sign.png", textures.sign().png())


if __name__ == "__main__":
    main()
