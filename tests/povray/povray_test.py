#!/usr/bin/env python3
"""Light that bounces, held against the radiosity of POV-Ray 3.7 in pictures of three rooms.

usage: povray_test.py HEARTH [--closer]

Prints how far the pictures of each room are apart, and fails if that is more than it may be. With --closer it also
holds POV-Ray against itself with twice as close settings, which takes ten minutes: so far off is POV-Ray.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from PIL import Image

BOUNCES = 3
WIDTH, HEIGHT, FOV = 120, 75, 90
# The root of the mean of the squares of all differences, of the mean of all pixels.
MOST_APART = 0.03

# The border goes round its room as the hands of a clock where north is up, a pillar the other way. Each vertex has the
# colour of the wall that begins there: the part of light that it reflects. No light is above 255 levels anywhere.
ROOMS = {
    "box": {
        "height": 3, "floor": "#909090", "ceiling": "#c8c8c8", "eye": [0.7, 5.2, 1.45], "angle": 333.7,
        "light": [6.2, 1.9, 1.9], "intensity": 80,
        "loops": [[(0, 0, "#c8c8c8"), (8, 0, "#c83232"), (8, 6, "#c8c8c8"), (0, 6, "#3250c8")]],
    },
    "corner": {
        "height": 3, "floor": "#a0a0a0", "ceiling": "#b4b4b4", "eye": [8.5, 5.1, 1.35], "angle": 215.6,
        "light": [1.2, 1.1, 1.7], "intensity": 150,
        "loops": [[(0, 0, "#c8a064"), (9, 0, "#b4b4b4"), (9, 8, "#64c878"), (6, 8, "#b4b4b4"), (6, 3, "#d2d2d2"),
                   (0, 3, "#b4b4b4")]],
    },
    "pillar": {
        "height": 4, "floor": "#785a3c", "ceiling": "#c8c8c8", "eye": [9.3, 7.2, 1.57], "angle": 217.3,
        "light": [2, 4.2, 2], "intensity": 120,
        "loops": [[(0, 0, "#b4b4b4"), (10, 0, "#b4b4b4"), (10, 8, "#b4b4b4"), (0, 8, "#b4b4b4")],
                  [(4, 3, "#c89632"), (4, 5, "#c89632"), (6, 5, "#c89632"), (6, 3, "#c89632")]],
    },
}

# A gather has `count` rays, is used again for its surroundings as `error_bound` allows, but no nearer to another one
# than `minimum_reuse`, a part of the picture's width; `pretrace_end` is how closely gathers are placed beforehand.
SETTINGS = {"pretrace_end": 0.02, "count": 400, "error_bound": 0.5, "minimum_reuse": 0.01}
CLOSER = {"pretrace_end": 0.01, "count": 800, "error_bound": 0.25, "minimum_reuse": 0.005}


def hearth_picture(hearth, room, folder):
    loops = {name: {"v": [number for x, y, _ in loop for number in (x, y)],
                    "walls": [{"texture": colour} for _, _, colour in loop]}
             for name, loop in zip(["border", "pillar"], room["loops"])}
    level = folder / "room.json"
    level.write_text(json.dumps({"light": 0, "sectors": {"room": {
        "floor": {"texture": room["floor"]}, "ceiling": {"z": room["height"], "texture": room["ceiling"]},
        "loops": loops}}}))
    light = dict(zip("xyz", room["light"]), intensity=room["intensity"])
    bake = {"lambert": True, "bounces": BOUNCES, "texel": 0.0625}
    level.with_suffix(".lights.json").write_text(json.dumps({"version": 1, "lights": [light], "bake": bake}))
    picture = folder / "hearth.png"
    camera = ",".join(map(str, [*room["eye"], room["angle"]]))
    subprocess.run([hearth, "shot", level, "--no-cache", "-o", picture, "--size", f"{WIDTH}x{HEIGHT}",
                    "--fov", str(FOV), f"--camera={camera}"], check=True, stdout=subprocess.DEVNULL)
    return numpy.asarray(Image.open(picture).convert("RGB"), dtype=float)


def vector(x, y, z):
    """In POV-Ray y is up and z is ahead: here that is z, and, as one looks north, -y."""
    return f"<{x}, {z}, {-y}>"


def polygon(corners, colour):
    rgb = ", ".join(str(int(colour[i:i + 2], 16) / 255) for i in (1, 3, 5))
    return f"polygon {{ {len(corners)}, {', '.join(vector(*c) for c in corners)} pigment {{ rgb <{rgb}> }} }}"


def flat(room, z, colour):
    return polygon([(x, y, z) for loop in room["loops"] for x, y, _ in loop + loop[:1]], colour)


def walls(room):
    top = room["height"]
    for loop in room["loops"]:
        for (x0, y0, colour), (x1, y1, _) in zip(loop, loop[1:] + loop[:1]):
            yield polygon([(x0, y0, 0), (x1, y1, 0), (x1, y1, top), (x0, y0, top), (x0, y0, 0)], colour)


def scene(room, settings):
    cosine, sine = numpy.cos(numpy.radians(room["angle"])), numpy.sin(numpy.radians(room["angle"]))
    across = 2 * numpy.tan(numpy.radians(FOV / 2))
    return "\n".join([
        "#version 3.7;",
        "global_settings { assumed_gamma 1 radiosity {",
        *(f"  {name} {value}" for name, value in settings.items()),
        f"  recursion_limit {BOUNCES} brightness 1 nearest_count 10 low_error_factor 0.5 maximum_reuse 0.2",
        "  gray_threshold 0 always_sample off",
        "} }",
        "#default { finish { ambient 0 diffuse 1 } }",
        f"camera {{ location {vector(*room['eye'])} direction {vector(cosine, sine, 0)}",
        f"  right {across} * {vector(-sine, cosine, 0)} up {across * HEIGHT / WIDTH} * y }}",
        f"light_source {{ {vector(*room['light'])} rgb {room['intensity'] / 255} }}",
        flat(room, 0, room["floor"]),
        flat(room, room["height"], room["ceiling"]),
        *walls(room),
    ])


def povray_picture(room, settings, folder):
    """Of one thread: with more, the order of the gathers differs from run to run."""
    (folder / "room.pov").write_text(scene(room, settings))
    picture = folder / "povray.ppm"
    if not shutil.which("povray"):
        sys.exit("povray is missing: tools/setup test installs it")
    run = subprocess.run(["povray", "+Iroom.pov", f"+O{picture}", f"+W{WIDTH}", f"+H{HEIGHT}", "-D", "-A", "+FP16",
                          "File_Gamma=1.0", "+WT1"], cwd=folder, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(run.stderr)
    values = numpy.frombuffer(picture.read_bytes()[-2 * 3 * WIDTH * HEIGHT:], dtype=">u2")
    return values.reshape(HEIGHT, WIDTH, 3) / 65535 * 255


def apart(picture, other):
    return float(numpy.sqrt(numpy.mean((picture - other) ** 2)) / numpy.mean(other))


def main():
    hearth, *options = sys.argv[1:]
    failed = False
    for name, room in ROOMS.items():
        with tempfile.TemporaryDirectory() as folder:
            own = hearth_picture(Path(hearth).resolve(), room, Path(folder))
            if own.max() == 255:
                sys.exit(f"{name}: pixels of 255 levels cannot be compared")
            other = povray_picture(room, SETTINGS, Path(folder))
            failed |= apart(own, other) > MOST_APART
            line = f"{name}: {100 * apart(own, other):.1f} % apart, {own.mean():.2f} and {other.mean():.2f} levels " \
                   "in the mean"
            if "--closer" in options:
                closer = povray_picture(room, CLOSER, Path(folder))
                line += f"; from closer settings {100 * apart(own, closer):.1f} %, POV-Ray itself " \
                        f"{100 * apart(other, closer):.1f} %"
            print(line, flush=True)
    if failed:
        sys.exit(f"more than {100 * MOST_APART:.0f} % apart")


if __name__ == "__main__":
    main()
