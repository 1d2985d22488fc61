#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does a picture of rviz show a map? check_picture.py PICTURE.png; exit 0 if it does, 1 and the reason if not."""
import sys

from PIL import Image

# Each is well below what the small drive of the test gives, and far above what the panels of an empty rviz give.
COLOURED = 0.02  # share of pixels: points and boxes on a dark background
RED = 300  # pixels: a removed car leaves a trail of some thousand points
HUES = 8  # of 24: the colours of the instances, which are spread over two thirds of the circle
PIXELS_OF_A_HUE = 50  # fewer are edges and icons


def main(path):
    hsv = Image.open(path).convert("RGB").convert("HSV")
    coloured = red = 0
    hues = [0] * 24
    for number, (hue, saturation, value) in hsv.getcolors(hsv.width * hsv.height):
        if saturation < 100 or value < 60:  # grey: background, panels, ground
            continue
        coloured += number
        hues[hue * 24 // 256] += number
        if (hue < 8 or hue > 248) and saturation > 150:
            red += number
    share = coloured / (hsv.width * hsv.height)
    many = sum(number >= PIXELS_OF_A_HUE for number in hues)
    print(f"{100 * share:.1f} % coloured, {red} red pixels, {many} of 24 hues")
    return 0 if share >= COLOURED and red >= RED and many >= HUES else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
