#!/usr/bin/env python3
"""The upper part of the report page of a scenario, as headless Chromium shows it: the picture in src/main/README.md.

    /usr/bin/python3 scripts/report_picture.py configs/spatula_press.yaml -o results/spatula_press_report.png [--at 0.15]

Needs Chromium: scripts/setup tests.
"""
import argparse
import base64
import io
import pathlib
import subprocess
import tempfile
import time

from PIL import Image
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

WIDTH = 1180
# Down to the first row of plots.
BOTTOM = "return document.querySelector('[data-plot=penetration_depth]').getBoundingClientRect().bottom + scrollY + 15"


def browser():
    options = Options()
    for argument in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars"]:
        options.add_argument(argument)
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def photograph(page, at):
    driver = browser()
    try:
        window = {"width": WIDTH, "height": 3000, "deviceScaleFactor": 1, "mobile": False}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", window)
        driver.get(page.as_uri())
        time.sleep(0.5)
        driver.execute_script("const s = document.getElementById('time'); s.value = arguments[0];"
                              "s.dispatchEvent(new Event('input'));", at)
        time.sleep(0.3)
        clip = {"x": 0, "y": 0, "width": WIDTH, "height": driver.execute_script(BOTTOM), "scale": 1}
        shot = driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png", "clip": clip})
        return Image.open(io.BytesIO(base64.b64decode(shot["data"])))
    finally:
        driver.quit()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenario")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--at", type=float, default=0.15, help="time of the cursor, seconds")
    parser.add_argument("--program", default="build/release/fissure")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        result = pathlib.Path(name) / pathlib.Path(arguments.scenario).with_suffix(".h5").name
        page = result.with_suffix(".html")
        # One run at a time: the page shows step times.
        subprocess.run([arguments.program, "run", arguments.scenario, "-o", str(result), "-j", "1"], check=True)
        subprocess.run([arguments.program, "report", str(result)], check=True)
        picture = photograph(page, arguments.at)
    # 256 colours are enough for lines and text, and a third of the bytes.
    picture.convert("RGB").quantize(256).save(arguments.output, optimize=True)


if __name__ == "__main__":
    main()
