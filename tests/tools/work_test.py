"""Holds the work that frames and bakes take against what they took when it was last looked at.

usage: work_test.py HEARTH SOURCE_DIR [--update WHY]

Neither chance nor the machine changes these counts. One that has grown by more than a twentieth
fails, and one that is not kept, or kept and no longer counted; if that is meant, --update WHY keeps
the new counts in work.json, with the reason in its "raised".
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

KEPT = Path(__file__).with_name("work.json")
LEVELS = ["levels/keep.json", "levels/tutorial.json"]
MORE = 1.05
# Of a frame: how large it is does not count as work.
MEASURES = {"width", "height", "threads", "milliseconds", "writeMilliseconds", "writes"}


def report(hearth, source, level, *options):
    command = [hearth, "bench", level, "--json", "--repeats", "1", "--threads", "1", *options]
    run = subprocess.run(command, cwd=source, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {run.stderr}")
    return json.loads(run.stdout)


def counts_of(hearth, source, level):
    """Of a level's largest frame, and of its bake with its lamps as they are and as points."""
    soft, points = report(hearth, source, level), report(hearth, source, level, "--soft-samples", "0")
    frame = max(soft["frames"], key=lambda frame: frame["width"])
    counts = {f"frame, {name}": count for name, count in frame.items() if name not in MEASURES}
    for name in ("texels", "texelLightTests", "rays", "bytes"):
        counts[f"bake, {name}"] = soft["bake"][name]
    counts["bake of points, rays"] = points["bake"]["rays"]
    return counts


def flat(counts):
    return {f"{level}: {name}": count for level, of_level in counts.items() for name, count in of_level.items()}


def changes(kept, counts):
    """What has grown, come or gone, in words."""
    kept, counts = flat(kept), flat(counts)
    grown = [f"{name}: {count}, was {kept[name]}" for name, count in counts.items()
             if name in kept and count > MORE * kept[name]]
    unlike = [f"{name}: is {'counted but not kept' if name in counts else 'kept but not counted'}"
              for name in sorted(kept.keys() ^ counts.keys())]
    return grown + unlike


def main():
    parser = argparse.ArgumentParser(description="Holds the work of frames and bakes against what it was.")
    parser.add_argument("hearth", type=lambda path: Path(path).resolve())
    parser.add_argument("source", type=Path)
    parser.add_argument("--update", metavar="WHY", help="keep the counts as they are, for a reason")
    arguments = parser.parse_args()
    if not KEPT.exists() and arguments.update is None:
        sys.exit(f"{KEPT}: error: there are no kept counts; restore the file, or write it with --update WHY")
    kept = json.loads(KEPT.read_text()) if KEPT.exists() else {"counts": {}, "raised": []}
    counts = {level: counts_of(arguments.hearth, arguments.source, level) for level in LEVELS}
    if arguments.update is not None:
        raised = kept["raised"] + [f"{change}: {arguments.update}" for change in changes(kept["counts"], counts)]
        KEPT.write_text(json.dumps({"counts": counts, "raised": raised}, indent=1) + "\n")
        return 0
    mistakes = changes(kept["counts"], counts)
    for mistake in mistakes:
        print(f"{mistake}; if that is meant, give --update WHY")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
