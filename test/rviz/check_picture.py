#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does a picture of rviz show the static map by instance, the trails of what was removed, and boxes with labels?
check_picture.py PICTURE.png; one line with what it shows, exit 1 if any of it is missing."""
import colorsys
import sys

from PIL import Image

# Pixels, each some five times less than the small drive of the test gives and as many times more than there are when
# the display in question is switched off in rviz.
GROUND = 12000
HUES = 8  # of 24, with 100 pixels each: the instances of the map, spread over two thirds of the circle
PIXELS_OF_A_HUE = 100
TRAIL = 5000
BOX = 3000
LABEL = 150


def is_near(colour, wanted):
    return all(abs(a - b) <= 1 for a, b in zip(colour, wanted))


def count(picture):
    """Points and texts have their colours as they are sent (src/ros/colours.cpp, markers.cpp); boxes are transparent
    green on a dark background."""
    seen = dict(ground=0, trail=0, box=0, label=0)
    hues = [0] * 24
    for number, colour in picture.getcolors(picture.width * picture.height):
        hue, saturation, value = colorsys.rgb_to_hsv(*(channel / 255 for channel in colour))
        seen["ground"] += number * is_near(colour, (120, 120, 120))
        seen["trail"] += number * is_near(colour, (230, 25, 25))
        seen["label"] += number * is_near(colour, (25, 204, 25))
        seen["box"] += number * (abs(hue - 1 / 3) < 0.03 and saturation > 0.5 and 0.15 < value < 0.5)
        hues[int(hue * 24) % 24] += number * (saturation > 0.99 and value > 0.99)
    seen["hues"] = sum(number >= PIXELS_OF_A_HUE for number in hues)
    return seen


def main(path):
    seen = count(Image.open(path).convert("RGB"))
    least = dict(ground=GROUND, hues=HUES, trail=TRAIL, box=BOX, label=LABEL)
    print(", ".join(f"{name} {seen[name]} of {least[name]}" for name in least))
    return 0 if all(seen[name] >= least[name] for name in least) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
