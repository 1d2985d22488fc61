#!/usr/bin/env python3
"""Prints one table of scores of scenes and says which seeds miss their pass marks (scene_marks.csv):

  scene_table.py FOLDER SCENE... [--no-marks]

FOLDER holds score.SCENE.SEED.json of segdf_evaluate. A mark is a floor of SA, DA, parked SA and the percentage of moving
instances removed, and the most standing instances that may be, on each seed. Exit 1 when a mark is missed.
"""

import csv
import glob
import json
import os
import sys


def mean_and_least(scores, key):
    values = [score[key] for score in scores if score.get(key) is not None]
    return f"{sum(values) / len(values):.2f}, {min(values):.2f}" if values else "-"


def removed(scores, kind):
    counts = [(score[kind + "_removed"], score[kind]) for score in scores]
    return " of ".join(str(sum(column)) for column in zip(*counts))


def missed(score, mark):
    """The marks that a drive misses, in words."""
    movers = 100 * score["instances_removed"] / score["instances"] if score["instances"] else None
    seen = {"SA": score["SA"], "DA": score.get("DA"), "parked_SA": score.get("parked_SA"), "movers": movers}
    low = [f"{name} {seen[name]:.4g} of {mark[name]}" for name in seen
           if mark[name] and seen[name] is not None and seen[name] < float(mark[name])]
    standing = score["static_instances_removed"]
    return low + ([f"{standing} standing removed"] if standing > int(mark["standing"]) else [])


def main():
    folder, *scenes = [argument for argument in sys.argv[1:] if argument != "--no-marks"]
    asked = "--no-marks" not in sys.argv
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "scene_marks.csv"), encoding="utf-8") as file:
        marks = {row["scene"]: row for row in csv.DictReader(file)}
    print("| scene | SA: mean, least | DA: mean, least | parked SA: mean, least | instances removed | standing ones removed |")
    print("|---|---|---|---|---|---|")
    below = []
    for scene in scenes:
        files = sorted(glob.glob(os.path.join(folder, f"score.{scene}.*.json")))
        scores = []
        for name in files:
            with open(name, encoding="utf-8") as file:
                scores.append(json.load(file))
        figures = [mean_and_least(scores, key) for key in ("SA", "DA", "parked_SA")]
        counts = [removed(scores, kind) for kind in ("instances", "static_instances")]
        print("| " + " | ".join([scene] + figures + counts) + " |")
        for name, score in zip(files, scores) if asked else []:
            below += [f"{scene}, seed {name.split('.')[-2]}: {words}" for words in missed(score, marks[scene])]
    for line in below:
        print("below its mark: " + line)
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main())
