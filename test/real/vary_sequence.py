#!/usr/bin/env python3
"""Writes a sequence in KITTI's layout changed in a way that a filter should not care about:

    vary_sequence.py SEQUENCE OUTPUT VARIATION

mirrored   left is right
reversed   the last scan comes first
half       every second laser
dark       no intensities
fewer      every second scan
"""
import array
import pathlib
import sys


def multiply(a, b):
    """Product of two rows of 12, 3x4 over 0 0 0 1."""
    return [sum(a[4 * r + k] * b[4 * k + c] for k in range(3)) + (a[4 * r + 3] if c == 3 else 0.0)
            for r in range(3) for c in range(4)]


def inverse(a):
    rotation = [a[4 * c + r] for r in range(3) for c in range(3)]
    shift = [-sum(rotation[3 * r + k] * a[4 * k + 3] for k in range(3)) for r in range(3)]
    return [x for r in range(3) for x in rotation[3 * r:3 * r + 3] + [shift[r]]]


def read_rows(file):
    return [[float(word) for word in line.split()] for line in file.read_text().splitlines() if line]


def lidar_poses(sequence):
    """Sensor to map, as poses_lidar.txt has them; poses.txt has the camera's."""
    if (sequence / "poses_lidar.txt").exists():
        return read_rows(sequence / "poses_lidar.txt")
    lines = dict(line.split(":", 1) for line in (sequence / "calib.txt").read_text().splitlines() if ":" in line)
    calibration = [float(word) for word in lines["Tr"].split()]
    back = inverse(calibration)
    return [multiply(multiply(back, pose), calibration) for pose in read_rows(sequence / "poses.txt")]


def mirrored(pose):
    """With y negated on both sides."""
    return [-x if (k // 4 == 1) != (k % 4 == 1) else x for k, x in enumerate(pose)]


def every_second_laser(points):
    """Which points to keep: a laser ends where the scan passes the x axis."""
    keep, laser, before = [], 0, 0.0
    for x, y in zip(points[0::4], points[1::4]):
        laser += before < 0.0 <= y and x > 0.0
        before = y
        keep.append(laser % 2 == 0)
    return keep


def vary(points, labels, variation):
    if variation == "mirrored":
        points[1::4] = array.array("f", [-y for y in points[1::4]])
    if variation == "dark":
        points[3::4] = array.array("f", bytes(4 * len(labels)))
    if variation != "half":
        return points, labels
    keep = every_second_laser(points)
    return (array.array("f", [v for k, v in enumerate(points) if keep[k // 4]]),
            array.array("I", [v for k, v in enumerate(labels) if keep[k]]))


def main(sequence, output, variation):
    if variation not in ("mirrored", "reversed", "half", "dark", "fewer"):
        sys.exit(f"no variation {variation}")
    poses = lidar_poses(sequence)
    scans = sorted((sequence / "velodyne").glob("*.bin"))
    order = list(range(len(scans)))[::{"reversed": -1, "fewer": 2}.get(variation, 1)]
    for folder in ("velodyne", "labels"):
        (output / folder).mkdir(parents=True, exist_ok=True)
    rows = []
    for number, k in enumerate(order):
        points = array.array("f", scans[k].read_bytes())
        labels = array.array("I", (sequence / "labels" / f"{scans[k].stem}.label").read_bytes())
        points, labels = vary(points, labels, variation)
        (output / "velodyne" / f"{number:06}.bin").write_bytes(points.tobytes())
        (output / "labels" / f"{number:06}.label").write_bytes(labels.tobytes())
        pose = mirrored(poses[k]) if variation == "mirrored" else poses[k]
        rows.append(" ".join(repr(x) for x in pose))
    (output / "poses_lidar.txt").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3])
