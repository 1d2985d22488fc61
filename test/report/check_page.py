#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens a report in headless Chromium as a person would: check_page.py SIMULATE OFFLINE EVALUATE WORK_DIR

It switches a layer off and on and looks at the pixels of the view, changes the colours, and looks for errors,
for anything asked of a network and for overflow at the widths of a desktop and of a phone. Exit 77: skipped.
"""
import base64
import io
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

try:
    from PIL import Image
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
LEFT_IN = (214, 32, 40)  # colour of moving points that are left in, on the light page
LOADING = 60  # seconds, with software rendering on a busy machine


def make_report(simulate, offline, evaluate, work):
    """Two drives, so that the page has something to choose from."""
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    arguments = {"--kitti": [], "--labels": []}
    for seed in ("5", "6"):
        drive, run = work / f"drive{seed}", work / f"run{seed}"
        subprocess.run([simulate, "--output", drive, "--sensor", "vlp16", "--scans", "12", "--seed", seed],
                       check=True, capture_output=True)
        subprocess.run([offline, "--kitti", drive, "--output", run], check=True, capture_output=True)
        arguments["--kitti"].append(drive)
        arguments["--labels"].append(run / "labels")
    command = [evaluate, "--report", work]
    for name, values in arguments.items():
        command += [name, *values]
    subprocess.run(command, check=True, capture_output=True)
    return work / "report.html"


def open_browser(profile):
    options = Options()
    options.binary_location = CHROMIUM
    for flag in ("--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
                 "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader", f"--user-data-dir={profile}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


def resize(browser, width, height):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})


def settle(browser):
    """Waits until two frames have been drawn after whatever was done."""
    browser.execute_async_script("const done = arguments[0];"
                                 "requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)));")


def drawn(browser):
    return int(browser.execute_script("return document.documentElement.dataset.drawn || 0"))


def pixels(browser):
    settle(browser)
    url = browser.execute_script("return document.getElementById('canvas').toDataURL('image/png')")
    return Image.open(io.BytesIO(base64.b64decode(url.split(",", 1)[1]))).convert("RGB")


def count(image, colour):
    return sum(n for n, c in image.getcolors(1 << 24) if max(abs(a - b) for a, b in zip(c, colour)) <= 2)


def click(browser, selector):
    browser.execute_script("document.querySelector(arguments[0]).click()", selector)


def require(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def check_view(browser):
    all_points, before = drawn(browser), pixels(browser)
    red = count(before, LEFT_IN)
    require(red > 100, f"moving points are seen in the view ({red} red pixels)")
    click(browser, "[data-layer=left]")
    without = pixels(browser)
    require(count(without, LEFT_IN) == 0, "no red pixel with their layer off")
    require(0 < drawn(browser) < all_points, "fewer points are drawn with a layer off")
    click(browser, "[data-layer=left]")
    require(pixels(browser).tobytes() == before.tobytes(), "the layer on again gives the same picture")
    pictures = {before.tobytes()}
    for colour in ("class", "instance", "intensity", "height"):
        click(browser, f"[name=colour][value={colour}]")
        pictures.add(pixels(browser).tobytes())
    require(len(pictures) == 5, "every way to colour gives another picture")
    click(browser, "#from-above")
    require(pixels(browser).tobytes() not in pictures, "the view from above is another picture")


def check_page(browser):
    title = browser.execute_script("return document.getElementById('title').textContent")
    require(title == "drive5", f"the first drive is shown ({title})")
    require(len(browser.find_elements("css selector", "#protocols tbody tr")) == 4, "all protocols have a row")
    require(browser.find_elements("css selector", "#range-sa rect"), "the figures by range are drawn")
    require(browser.find_elements("css selector", "#recall path"), "the recall curves are drawn")
    require(browser.execute_script("return document.getElementById('map').naturalWidth") > 100, "the map is shown")
    browser.execute_script("const s = document.getElementById('scene'); s.value = '1'; s.onchange({target: s});")
    title = browser.execute_script("return document.getElementById('title').textContent")
    require(title == "drive6", f"the second drive is shown ({title})")
    unnamed = browser.execute_script(
        "return [...document.querySelectorAll('input,select,button,canvas')].filter(e => e.offsetParent !== null &&"
        " !(e.labels && e.labels.length) && !e.textContent.trim() && !e.getAttribute('aria-label')).length")
    require(unnamed == 0, f"{unnamed} controls have no name")


def check_width(browser, width, height):
    resize(browser, width, height)
    settle(browser)
    browser.execute_script("document.querySelectorAll('details').forEach(d => d.open = true)")
    for theme in range(2):
        page = browser.execute_script("return document.documentElement.scrollWidth")
        require(page <= width, f"the page is {page} px wide on a screen of {width} px")
        click(browser, "#theme")


def main():
    if not CHROMIUM or not DRIVER:
        print("skipped: no chromium or chromedriver")
        sys.exit(77)
    report = make_report(*sys.argv[1:4], pathlib.Path(sys.argv[4]))
    with tempfile.TemporaryDirectory() as profile:
        browser = open_browser(profile)
        try:
            resize(browser, 1280, 900)
            browser.get(report.as_uri())
            end = time.time() + LOADING
            while not drawn(browser) and time.time() < end:
                time.sleep(0.1)
            require(drawn(browser) > 1000, "points are drawn")
            check_view(browser)
            check_page(browser)
            check_width(browser, 1280, 900)
            check_width(browser, 390, 844)
            asked = browser.execute_script("return performance.getEntriesByType('resource').map(e => e.name)")
            asked = [name for name in asked if not name.startswith("data:")]
            require(not asked, f"the page asks for nothing outside itself: {asked}")
            # Reading pixels back, which only this test does, makes the driver complain of speed.
            log = [e["message"] for e in browser.get_log("browser") if "GPU stall" not in e["message"]]
            require(not log, f"the browser has nothing to say: {log}")
        finally:
            browser.quit()
    shutil.rmtree(sys.argv[4])
    print("the report's page holds")


main()
