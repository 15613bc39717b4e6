#!/usr/bin/env python3
"""Measures each setting by itself, and prints the rows of tools/settings/measured_settings.cpp.

usage: tools/measure_settings.py [OPTION OF `hearth tradeoff`...]

Costs are geometric means, errors arithmetic ones, of the tutorial and the castle; of shadows of
middle textures, which these do not have, those of the gaol; of stages of movers those of the castle; of gather errors
those of the tutorial with three bounces. Bakes take one thread, so that costs are of work, and not of how threads share
it.
"""

import csv
import io
import math
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEARTH = ROOT / "build/release/hearth"
LEVELS = ["tutorial", "keep"]
LEVELS_OF = {"--middle-shadows": ["gaol"], "--mover-stages": ["keep"], "--gather-error": ["tutorial"]}
SAME = {"--texel 0.0625": "--quality high"}  # and named so


def tradeoff(*arguments):
    return subprocess.run([HEARTH, "tradeoff", *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def settings_of(text):
    """Name, default, and whether bakes take longer or shorter by it, of what `--list` prints."""
    for part in re.split(r"^(?=--)", text, flags=re.MULTILINE)[1:]:
        yield part.split()[0], re.search(r"\(default: ([^:)]*)", part)[1], "makes bakes" in part


def rows_of(text):
    rows = {row["settings"]: row for row in csv.DictReader(io.StringIO(text))}
    return rows | {name: rows[same] for name, same in SAME.items() if same in rows}


def values_of(name, default, levels):
    """Those that were tried by themselves, in their order, and the default first."""
    tried = [row.split() for level in levels for row in level]
    return list(dict.fromkeys([default] + [row[1] for row in tried if len(row) == 2 and row[0] == name]))


def figures(row, is_bake):
    if is_bake:
        return float(row["bake_cost"]), float(row["light_rms"])
    return float(row["frame_cost"]), float(row["over2_share"])


def printed(name, value, measured):
    cost = math.prod(cost for cost, _ in measured) ** (1 / len(measured))
    off = sum(off for _, off in measured) / len(measured)
    option = "".join(word.capitalize() for word in name.split("-"))
    return f'    MeasuredSetting{{Option::{option}, "{value}", {cost:.2g}, {off:.2g}}},'


def table(listed, rows):
    for name, default, is_bake in settings_of(listed):
        levels = [rows[level] for level in LEVELS_OF.get(name, LEVELS)]
        for value in values_of(name, default, levels):
            yield printed(name, value, [figures(level.get(f"{name} {value}", level[""]), is_bake) for level in levels])


def main():
    levels = sorted({*LEVELS, *sum(LEVELS_OF.values(), [])})
    rows = {level: rows_of(tradeoff(ROOT / f"levels/{level}.json", "--csv", "--threads", "1", *sys.argv[1:]))
            for level in levels}
    for level in LEVELS_OF["--mover-stages"]:
        rows[level] |= rows_of(tradeoff(ROOT / f"levels/{level}.json", "--csv", "--threads", "1", "--movers"))
    for level in LEVELS_OF["--gather-error"]:
        rows[level] |= rows_of(tradeoff(ROOT / f"levels/{level}.json", "--csv", "--threads", "1", "--areas",
                                        "--bounces", "3"))
    print("\n".join(table(tradeoff("--list"), rows)))


if __name__ == "__main__":
    main()
