"""Report pages in headless Chromium, at desktop and phone width: browser_test.py FISSURE MAKE_SWEEP [--keep FOLDER]

No message on the console, nothing wider than the window, every plot drawn, and one time for plots, frames and keys. Of a
sweep: a brush on one axis shows in all views, keys walk over the maps, and lists of runs can be chosen. Of a history of
benchmarks: steps, machines and counters. Of studies: a click on a cell or a setting shows its class or errors and the
command that repeats it.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

EVIL = "</script><img src=x onerror=\"document.title='evil'\"><b>bold</b>"

# A blade pressed into a soft sphere: two runs with frames, two force laws; text that would like to be markup.
SCENARIO = """
format: 1
name: press
description: '""" + EVIL.replace("'", "''") + """'
time: {step_s: 0.001, settle_s: 0.005, duration_s: 0.04}
ground: {height_m: 0}
bodies:
  - name: sphere
    shape: {type: sphere, radius_m: 0.03, subdivisions: 1}
    position_m: [0, 0.03, 0]
    mass_kg: 0.1
    material: {linear_stiffness: 0.5}
    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}
tools:
  - name: spatula
    shape: {type: box, size_m: [0.04, 0.002, 0.015]}
    nodes: {resolution: [4, 4]}
    motion: {type: script, start_m: [0, 0.062, 0], segments: [{move_to_m: [0, 0.052, 0], speed_m_s: 0.5}]}
pipelines: [{pipeline: default}, {pipeline: fukuhara}]
force: [{name: hc, model: hunt_crossley}, {name: linear, model: linear_elastic}]
record: {frames: {every_s: 0.01, size_px: [160, 120]}}
"""

# Of each plot's canvas: how many of its pixels are not white.
INK = """
return [...document.querySelectorAll('.plot')].map(plot => {
  const canvas = plot.querySelector('canvas');
  if (!canvas) return [plot.dataset.plot, -1];
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  let ink = 0;
  for (let i = 3; i < pixels.length; i += 4) ink += pixels[i] > 0;
  return [plot.dataset.plot, ink];
});
"""
SHOWN = """
const depth = document.querySelector('[data-plot=penetration_depth]');
return {
  time: document.querySelector('.controls output').textContent,
  slider: Number(document.getElementById('time').value),
  frames: [...document.querySelectorAll('.frames img')].map(one => Number(one.dataset.frame)),
  loaded: [...document.querySelectorAll('.frames img')].every(one => one.complete && one.naturalWidth === 160),
  cursors: [...document.querySelectorAll('.plot:not([data-plot=step_time]) .u-cursor-x')].map(one => one.style.transform),
  values: [...depth.querySelectorAll('.u-value')].map(one => one.textContent),
  title: document.title,
};
"""
SET_SLIDER = "const s = document.getElementById('time'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));"
PRESS = """document.body.dispatchEvent(new KeyboardEvent('keydown',
  {key: arguments[0], shiftKey: arguments[1], bubbles: true, cancelable: true}));"""

problems = []


def check(holds, what):
    if not holds:
        problems.append(what)


def browser():
    options = Options()
    for argument in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def open_at(driver, page, width):
    metrics = {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": width < 600}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    driver.get(page.as_uri())
    time.sleep(0.3)  # the page draws when it has its first frame


def check_width_and_console(driver, where):
    wide, window = driver.execute_script("return [document.documentElement.scrollWidth, innerWidth]")
    check(wide <= window, f"{where}: {wide} px wide in a window of {window} px")
    for entry in driver.get_log("browser"):
        problems.append(f"{where}: console: {entry['level']} {entry['message']}")


def check_moves(driver, where):
    """0.04 s of steps of 1 ms, frames at 0, 10, 20, 30, 40 ms."""
    driver.execute_script(SET_SLIDER, 0.012)
    early = driver.execute_script(SHOWN)
    check(early["time"] == "0.012 s" and early["frames"] == [1, 1], f"{where}: slider: {early}")
    driver.execute_script(PRESS, "ArrowRight", False)
    late = driver.execute_script(SHOWN)
    check(late["time"] == "0.020 s" and late["frames"] == [2, 2], f"{where}: arrow: {late}")
    check(late["loaded"], f"{where}: pictures not loaded")
    check(all(a != b for a, b in zip(early["cursors"], late["cursors"])), f"{where}: cursors stay: {late['cursors']}")
    check(late["values"] != early["values"] and all(" mm" in v for v in late["values"][1:]), f"{where}: values {late}")
    driver.execute_script(PRESS, "ArrowLeft", True)
    check(driver.execute_script(SHOWN)["time"] == "0.019 s", f"{where}: shift and arrow")


def check_mouse(driver, where):
    """A pointer over one plot moves the time of all."""
    before = driver.execute_script(SHOWN)
    over = driver.execute_script(
        "const o = document.querySelector('[data-plot=contact_count] .u-over'); o.scrollIntoView({block: 'center'});"
        "const r = o.getBoundingClientRect(); return [r.left + r.width * 0.75, r.top + r.height / 2]")
    driver.execute_cdp_cmd("Input.dispatchMouseEvent", {"type": "mouseMoved", "x": over[0], "y": over[1]})
    time.sleep(0.2)
    after = driver.execute_script(SHOWN)
    check(abs(after["slider"] - 0.03) < 0.0015 and after["frames"] != before["frames"], f"{where}: mouse: {after}")


def check_laws(driver, where):
    texts = []
    for law in (1, 0):
        driver.execute_script("const s = document.querySelector('select[data-select=law]'); s.selectedIndex = arguments[0];"
                              "s.dispatchEvent(new Event('change'));", law)
        time.sleep(0.2)
        texts.append(driver.execute_script("return document.querySelector('[data-plot=force]').innerText"))
    check("linear" in texts[0] and "hc" in texts[1] and texts[0] != texts[1], f"{where}: laws: {texts}")


def check_result_page(driver, page, width, keep):
    where = f"{page.name} at {width} px"
    open_at(driver, page, width)
    ink = driver.execute_script(INK)
    check(len(ink) >= 8, f"{where}: plots {ink}")
    for plot, pixels in ink:
        check(pixels > 1000, f"{where}: plot {plot} is empty: {pixels}")
    check_moves(driver, where)
    check_laws(driver, where)
    if width > 600:
        check_mouse(driver, where)
    text = driver.execute_script("return document.body.innerText")
    check(EVIL in text, f"{where}: the description is not shown as text")
    check(driver.title == "press – fissure", f"{where}: title {driver.title}")
    check_width_and_console(driver, where)
    if keep:
        driver.save_screenshot(str(pathlib.Path(keep) / f"{page.stem}_{width}.png"))


def check_folder_page(driver, page, width):
    where = f"{page.name} at {width} px"
    open_at(driver, page, width)
    links = driver.execute_script("return [...document.querySelectorAll('a')].map(a => [a.textContent, a.href])")
    check([text for text, _ in links] == ["press.h5"], f"{where}: links {links}")
    text = driver.execute_script("return document.body.innerText")
    check("not an HDF5 file" in text, f"{where}: the damaged file is not named")
    check_width_and_console(driver, where)
    driver.get(links[0][1])
    check(driver.title == "press – fissure", f"{where}: the link leads to {driver.title}")


# Ink of each canvas of a sweep's page, by what it shows, and what the texts say.
SWEEP_INK = """
const ink = canvas => {
  const copy = Object.assign(document.createElement('canvas'), {width: canvas.width, height: canvas.height});
  const context = copy.getContext('2d', {willReadFrequently: true});
  context.drawImage(canvas, 0, 0);
  const pixels = context.getImageData(0, 0, copy.width, copy.height).data;
  let sum = 0, hash = 0;
  for (let i = 0; i < pixels.length; i += 4) { sum += pixels[i + 3] > 0; hash = (hash * 31 + pixels[i] + pixels[i + 1] + pixels[i + 3]) | 0; }
  return [sum, hash];
};
const one = selector => [...document.querySelectorAll(selector)].map(ink);
return {
  maps: one('.maps canvas'), bar: one('canvas.bar'), lines: one('canvas.lines'), curves: one('[data-plot=sweep_curves] canvas'),
  chosen: document.querySelector('.chosen').textContent,
  readout: document.querySelector('.readout').textContent,
  note: [...document.querySelectorAll('.curve-legend ~ p')].map(p => p.textContent).join(),
  holds: document.querySelector('.holds').innerText,
  looked: document.body.innerText.includes('The run that is looked at'),
};
"""
BRUSH = """
const handle = document.querySelector('.handle[data-dimension="' + arguments[0] + '"]'), box = handle.getBoundingClientRect();
handle.setPointerCapture = () => {};
const send = (kind, y) => handle.dispatchEvent(new PointerEvent(kind, {clientX: box.left + 20, clientY: box.top + y, pointerId: 1, bubbles: true}));
send('pointerdown', 0); send('pointermove', 100); send('pointerup', 100);
"""


def sweep_shown(driver):
    time.sleep(0.5)  # lines and curves are drawn a little later
    return driver.execute_script(SWEEP_INK)


def check_brush(driver, where):
    before = sweep_shown(driver)
    for view, least in (("maps", 3000), ("bar", 3000), ("lines", 1500), ("curves", 1000)):
        check(before[view] and all(ink > least for ink, _ in before[view]), f"{where}: {view} empty: {before[view]}")
    check("all chosen" in before["chosen"], f"{where}: {before['chosen']}")
    driver.execute_script(BRUSH, "k")
    after = sweep_shown(driver)
    check(" runs of " in after["chosen"] and "Thin: " in after["note"], f"{where}: brush: {after['chosen']}, {after['note']}")
    for view in ("maps", "lines", "curves"):
        check(before[view] != after[view], f"{where}: the brush does not show in {view}")
    driver.execute_script("document.querySelector('.controls button').click()")
    again = sweep_shown(driver)
    check(again["chosen"] == before["chosen"] and again["maps"] == before["maps"], f"{where}: all runs: {again['chosen']}")


def check_keys_and_lists(driver, where):
    driver.execute_script("for (const key of ['ArrowRight', 'ArrowRight']) document.querySelector('.maps canvas').dispatchEvent("
                          "new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}))")
    shown = sweep_shown(driver)
    check("default_tuned, k " in shown["readout"] and ": misfit " in shown["readout"], f"{where}: keys: {shown['readout']}")
    check(shown["looked"] and "looking at run" in shown["chosen"], f"{where}: nothing is looked at")
    driver.execute_script("document.querySelector('.failures button').click()")
    shown = sweep_shown(driver)
    check("at step #" in shown["chosen"], f"{where}: failures: {shown['chosen']}")
    driver.execute_script("const b = document.getElementById('bound'); b.value = 1000; b.dispatchEvent(new Event('input'))")
    wide = sweep_shown(driver)
    check("1000 mm" in wide["holds"] and wide["holds"] != shown["holds"], f"{where}: bound: {wide['holds']}")


# The first map, of a pipeline whose runs have no value of the chosen quantity: its share of ink, and what is read out.
NO_VALUE = """
const select = document.querySelector('select[aria-label=Colour]');
select.selectedIndex = [...select.options].findIndex(option => option.text === 'node switch rate, Hz');
select.dispatchEvent(new Event('change'));
const canvas = document.querySelector('.maps canvas');
canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: true, cancelable: true}));
const pixels = canvas.getContext('2d').getImageData(64, 8, canvas.width - 76, canvas.height - 52).data;
let ink = 0;
for (let i = 3; i < pixels.length; i += 4) ink += pixels[i] > 0;
return {ink: 4 * ink / pixels.length, readout: document.querySelector('.readout').textContent,
  legend: document.querySelector('.legend').innerText};
"""


def check_no_value(driver, where):
    shown = driver.execute_script(NO_VALUE)
    check(": no node switch rate · run " in shown["readout"], f"{where}: no value: {shown['readout']}")
    if "grid" in where:
        check(0.01 < shown["ink"] < 0.15, f"{where}: cells without a value are no small circles: {shown['ink']}")
        places = driver.execute_script("return document.querySelector('.failures').innerText")
        check("rate = velocities (" in places and "nowhere" not in places, f"{where}: failures where: {places}")
        check("no value" in shown["legend"] and "not run" in shown["legend"], f"{where}: legend: {shown['legend']}")


# Labels of the first map's columns, the axis being one of long texts: what they say, their title, what sticks out.
TEXT_LABELS = """
const select = document.querySelector('select[aria-label=Across]');
select.selectedIndex = [...select.options].findIndex(option => option.text === 'segments_0');
select.dispatchEvent(new Event('change'));
const map = document.querySelector('.maps figure'), right = map.getBoundingClientRect().right;
return [...map.querySelectorAll('.label')].map(one => [one.textContent, one.title,
  one.getBoundingClientRect().width > 40 && one.getBoundingClientRect().right <= right]);
"""


def check_text_labels(driver, where):
    labels = driver.execute_script(TEXT_LABELS)
    hold = "{move_to_m: [0, 0.052, 0], hold_s: %d, at the end}"
    check(labels == [[f"…{i}, at the end}}", hold % i, True] for i in (0, 1, 2, 3)], f"{where}: text labels: {labels}")


def check_failed_page(driver, page, width, keep):
    where = f"{page.name} at {width} px"
    open_at(driver, page, width)
    text = driver.execute_script("return document.body.innerText")
    check("No run has ended well, so no pipeline holds." in text, f"{where}: which pipeline holds: {text[:500]}")
    check(text.count("No run has ended well, so there is nothing to draw.") == 2, f"{where}: maps and curves")
    check("Choose runs above" not in text and "before its first step" in text, f"{where}: curves or failures")
    check_width_and_console(driver, where)
    if keep:
        driver.save_screenshot(str(pathlib.Path(keep) / f"{page.stem}_{width}.png"))


def check_lost_page(driver, page, width):
    where = f"{page.name} at {width} px"
    open_at(driver, page, width)
    shown = sweep_shown(driver)
    check("No run has ended well. Thin: 11 of 11 runs" in shown["note"], f"{where}: note: {shown['note']}")
    check(shown["curves"] and shown["curves"][0][0] > 5000, f"{where}: curves empty: {shown['curves']}")
    check_width_and_console(driver, where)


def check_sweep_page(driver, page, width, keep):
    where = f"{page.name} at {width} px"
    open_at(driver, page, width)
    check_brush(driver, where)
    check_keys_and_lists(driver, where)
    check_no_value(driver, where)
    if "grid" in where:
        check_text_labels(driver, where)
    text = driver.execute_script("return document.body.innerText")
    for words in ("</script><b>which</b>", "Best fits", "Failures by reason", "tools.spatula.motion.speed_m_s", "not run",
                  "a grid without some combinations" if "grid" in where else "Sobol points"):
        check(words in text, f"{where}: does not say {words}")
    check_width_and_console(driver, where)
    if keep:
        driver.save_screenshot(str(pathlib.Path(keep) / f"{page.stem}_{width}.png"))


def check_history_page(driver, page, width, keep):
    """Ten commits on one machine, three on another; a step at the seventh; a file that is none."""
    open_at(driver, page, width)
    where = f"history at {width}"
    text = driver.execute_script("return document.body.innerText")
    for words in ("torn.json is not shown: no whole JSON", "2 machines", "10 commits", "+20", "</script><b>Cpu</b>",
                  "rays 64 \u2192 70", "p < 0.02"):
        check(words in text, f"{where}: does not say {words}")
    inks = driver.execute_script(INK)
    check(all(ink > 500 for _, ink in inks), f"{where}: empty plots: {inks}")
    check(len(driver.execute_script("return [...document.querySelectorAll('.steps tbody tr')]")) == 1, f"{where}: one step")
    check(driver.title.startswith("history"), f"{where}: title {driver.title}")
    shown = "return [...document.querySelectorAll('.plot')].filter(one => !one.hidden && !one.closest('section').hidden).length"
    check(driver.execute_script(shown) == 2, f"{where}: two plots")
    driver.execute_script("document.getElementById('only-steps').click()")
    check(driver.execute_script(shown) == 1, f"{where}: one plot with a step")
    over = driver.execute_script("const o = document.querySelector('.plot:not([hidden]) .u-over'); o.scrollIntoView({block: 'center'});"
                                 "const r = o.getBoundingClientRect(); return [r.left + 2, r.top + r.height / 2]")
    driver.execute_cdp_cmd("Input.dispatchMouseEvent", {"type": "mouseMoved", "x": over[0], "y": over[1]})
    time.sleep(0.2)
    read = driver.execute_script("return document.querySelector('.plot:not([hidden]) .read').innerText")
    check("2026-01-01" in read and "100 µs" in read, f"{where}: under the pointer {read}")
    check_width_and_console(driver, where)
    if keep:
        driver.save_screenshot(str(pathlib.Path(keep) / f"history_{width}.png"))


def make_history(program, folder):
    (folder / "history").mkdir()
    for day in range(1, 11):
        for cpu in ("</script><b>Cpu</b>", "Cpu B")[: 2 if day in (1, 5, 9) else 1]:
            step_us = 100 * (1.2 if day >= 7 else 1)
            benchmarks = [{"name": name, "time_us": [time_us * scale for scale in (0.99, 0.995, 1, 1.005, 1.01)],
                           "counters": {"rays": 70 if day >= 7 else 64}}
                          for name, time_us in (("step/press", step_us if cpu != "Cpu B" else 90), ("detect/128", 7))]
            found = {"format": "fissure-bench", "format_version": 1, "commit": f"{day:07x}" + 33 * "0", "modified": False,
                     "commit_date": f"2026-01-{day:02}T12:00:00Z", "machine": {"cpu": cpu, "cores": 2},
                     "build": {"type": "Release", "compiler": "c++ 12", "flags": "-O3"}, "benchmarks": benchmarks}
            (folder / f"history/{day}-{len(cpu)}.json").write_text(json.dumps(found))
    (folder / "history/torn.json").write_text("{")
    subprocess.run([program, "report", "history"], cwd=folder, check=True, stdout=subprocess.DEVNULL)


# The middle of a mark, once it is in sight.
MARK_AT = """
const mark = document.querySelector(arguments[0]);
mark.scrollIntoView({block: 'center'});
const box = mark.querySelector('polygon').getBoundingClientRect();
return [box.left + box.width / 2, box.top + box.height / 2];
"""


def click_on(driver, selector):
    x, y = driver.execute_script(MARK_AT, selector)
    for kind in ("mousePressed", "mouseReleased"):
        driver.execute_cdp_cmd("Input.dispatchMouseEvent", {"type": kind, "x": x, "y": y, "button": "left", "clickCount": 1})
    time.sleep(0.1)


def press_arrow(driver, key):
    for kind in ("keyDown", "keyUp"):
        driver.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": kind, "key": key, "code": key})
    time.sleep(0.1)


def readouts(driver, panel):
    return driver.execute_script("return [...document.querySelectorAll(arguments[0] + ' .readout')].map(one => one.innerText)", panel)


def check_stability(driver, where):
    marks = ("return [...document.querySelectorAll('.panel[data-map=steps] .map > .class-mark')]"
             ".map(mark => mark.querySelector('text') && mark.textContent[0])")
    check(sorted(driver.execute_script(marks), key=str) == ["C", "C", None, "S", "S"], f"{where}: letters of large marks alone")
    click_on(driver, ".panel[data-map=steps] .map > .class-mark[data-class=chattering]")
    shown = readouts(driver, ".details[data-map]")
    check(len(shown) == 1 and "chattering: the force swings" in shown[0] and "215.5 Hz" in shown[0], f"{where}: click: {shown}")
    check("fissure run 'ball.yaml' --set 'time.step_s=0.01'" in shown[0], f"{where}: command: {shown}")
    href = driver.execute_script("return document.querySelector('.readout a').getAttribute('href')")
    check(href == "./steps/swept/runs/a%20b.h5", f"{where}: link {href}")
    press_arrow(driver, "ArrowLeft")
    shown = readouts(driver, ".details[data-map]")
    check(len(shown) == 1 and "halving" in shown[0] and "step_s=0.001" in shown[0], f"{where}: arrow: {shown}")
    driver.execute_script("document.querySelector('.readout .copy').click()")
    time.sleep(0.2)
    check(driver.execute_script("return document.querySelector('.readout .copy').textContent") == "Copied", f"{where}: not copied")
    driver.execute_script("document.querySelector('input[data-class=chattering]').click()")
    check(len(driver.execute_script(marks)) == 3, f"{where}: a class that is not chosen is drawn")
    driver.execute_script("document.querySelector('input[data-class=chattering]').click()")
    driver.execute_script("const s = document.querySelector('select[aria-label=Pipeline]'); s.value = 'default';"
                          "s.dispatchEvent(new Event('change'))")
    shown = driver.execute_script("return [...document.querySelectorAll('.panel[data-map]:not([hidden])')].map(one => one.dataset.map)")
    check(shown == ["responses"], f"{where}: maps of a pipeline: {shown}")
    listed = driver.execute_script("return document.querySelector('.boundary-list').innerText")
    check("None between these" in listed, f"{where}: boundaries of a map without any: {listed}")


def check_tradeoff(driver, where):
    count = "return document.querySelectorAll('.panel[data-quantity=' + arguments[0] + '] ' + arguments[1]).length"
    check(driver.execute_script(count, "depth", ".setting-mark") == 2, f"{where}: marks of depth")
    check(driver.execute_script(count, "depth", ".front") == 1, f"{where}: front of depth")
    check(driver.execute_script(count, "reaction", "polygon[fill='#fff']") == 2, f"{where}: differences are open marks")
    check(driver.execute_script(count, "reaction", ".front") == 0, f"{where}: a front of differences")
    click_on(driver, ".panel[data-quantity=depth] .setting-mark[data-pipeline=swept]")
    shown = readouts(driver, ".details[data-quantity]")
    check(len(shown) == 1 and "--set 'time.step_s=0.001'" in shown[0] and "300 mN\t–\t–\trefused" in shown[0],
          f"{where}: click on a setting: {shown}")
    rings = driver.execute_script("return document.querySelectorAll('.panel[data-quantity] .ring').length")
    check(rings == 3, f"{where}: the setting in all plots: {rings}")


def check_study_page(driver, page, width, keep):
    where = f"study at {width}"
    open_at(driver, page, width)
    text = driver.execute_script("return document.body.innerText")
    for words in ("</script><b>limits</b>, costs", "a study of stability and a study of accuracy and cost", "Where runs break",
                  "What accuracy costs", "refused: does not fall", "signal 11", "holds", "0.003162"):
        check(words in text, f"{where}: does not say {words}")
    check_stability(driver, where)
    if keep:
        driver.save_screenshot(str(pathlib.Path(keep) / f"study_{width}.png"))
    check_tradeoff(driver, where)
    check_width_and_console(driver, where)


def make_study(program, folder):
    def cell(values, kind, of_round=0):
        more = {"frequency_Hz": 215.5, "reason": "the force swings"} if kind == "chattering" else {"reason": "none"}
        return {"values": values, "round": of_round, "wall_s": 0.25, "class": kind, "result": "steps/swept/runs/a b.h5",
                "command": f"fissure run 'ball.yaml' --set 'time.step_s={values[-1]}'", **more}

    def axis(path, scale, grid):
        return {"path": path, "multiplies": [], "scale": scale, "grid": grid}

    def setting(pipeline, step_s, us, depth_m):
        us, known = {"low": us, "median": us, "high": us, "count": 2 if us else 0}, depth_m is not None
        costs = ("us_per_ms", "p99_us_per_ms", "us_per_step", "p99_us_per_step", "processor_s_per_s", "memory_mib")
        errors = {"depth": {"rms": depth_m, "worst": depth_m, "peak": depth_m, "counts": depth_m},
                  "reaction": {"rms": 0.3 if known else None, "worst": None, "peak": None, "counts": None}}
        return {"pipeline": pipeline, "values": {"time.step_s": step_s}, "status": "ok" if known else "crashed",
                "status_detail": "" if known else "signal 11", "cost": {name: us for name in costs}, "errors": errors,
                "weighed_error": depth_m and depth_m / 1e-4, "front": known,
                "command": f"fissure run 'press.yaml' --set 'time.step_s={step_s}'"}

    steps = {"map": "steps", "description": EVIL, "pipeline": "swept",
             "axes": [axis("speed", "values", ["1", "2"]), axis("time.step_s", "logarithmic", ["1e-4", "0.01"])],
             "cells": [cell(["1", "1e-4"], "stable"), cell(["1", "0.01"], "chattering"), cell(["2", "1e-4"], "stable"),
                       cell(["2", "0.01"], "chattering"), cell(["1", "0.001"], "stable", 1)],
             "boundaries": [{"others": ["1"], "below": 0.001, "above": 0.01, "class_below": "stable", "class_above": "chattering"}]}
    responses = {"map": "responses", "description": "", "pipeline": "default", "axes": [axis("response", "values", ["a", "b"])],
                 "cells": [cell(["a"], "stable"), cell(["b"], None)], "boundaries": []}
    study = {"format": "fissure-stability", "format_version": 1, "name": "</script><b>limits</b>", "description": "", "refine_to": 0.05,
             "criteria": {"force_N": 1000, "forces": []}, "panels": [steps, responses],
             "classes": [{"name": name, "means": name} for name in ("chattering", "stable")]}
    reference = {"pipeline": "swept", "units": "m", "measure": "rms", "order": 1.9, "own_error": 1e-6, "tolerance": 1e-4, "peak": 0.003,
                 "peak_at_size_zero": None, "differences_of_rungs": []}
    refused = {"quantity": "reaction", "units": "N", "refused": "does not fall", "own_error": None, "tolerance": None}
    answer = {"wish": "depth at most 50 um", "setting": 0, "nearest": None, "times_beyond": None, "scenario": "errors.yaml", "holds": True,
              "again": setting("swept", "0.001", 410, 1e-5)}
    tradeoff = {"format": "fissure-tradeoff", "format_version": 1, "study": "costs", "description": "", "cost": "us_per_ms",
                "references": [{**reference, "quantity": "depth", "refused": ""}, {**reference, **refused}], "orders": [],
                "settings": [setting("swept", "0.001", 400, 1e-5), setting("fukuhara", "0.001", 100, 2e-4),
                             setting("fukuhara", "0.002", None, None)], "answers": [answer]}
    (folder / "study").mkdir()
    (folder / "study/study.json").write_text(json.dumps(study))
    (folder / "study/tradeoff.json").write_text(json.dumps(tradeoff))
    subprocess.run([program, "report", "study"], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def make_sweeps(program, make_sweep, folder):
    for design, runs in (("grid", "378"), ("sobol", "240"), ("failed", "12"), ("lost", "12")):
        subprocess.run([make_sweep, f"{design}.h5", design, runs], cwd=folder, check=True)
        subprocess.run([program, "report", f"{design}.h5"], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def make_pages(program, folder):
    (folder / "press.yaml").write_text(SCENARIO)
    (folder / "out").mkdir()
    (folder / "out" / "broken.h5").write_text("no result")
    for words in [["run", "press.yaml", "-o", "out/press.h5"], ["report", "out/press.h5", "-o", "page.html"],
                  ["report", "out", "-o", "index.html"]]:
        subprocess.run([program, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("make_sweep")
    parser.add_argument("--keep", help="folder for screenshots")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program = str(pathlib.Path(arguments.program).resolve())
        make_pages(program, folder)
        make_history(program, folder)
        make_study(program, folder)
        make_sweeps(program, str(pathlib.Path(arguments.make_sweep).resolve()), folder)
        driver = browser()
        try:
            for width in (1280, 375):
                check_result_page(driver, folder / "page.html", width, arguments.keep)
                check_folder_page(driver, folder / "index.html", width)
                for design in ("grid", "sobol"):
                    check_sweep_page(driver, folder / f"{design}.html", width, arguments.keep)
                check_failed_page(driver, folder / "failed.html", width, arguments.keep)
                check_lost_page(driver, folder / "lost.html", width)
                check_history_page(driver, folder / "history/index.html", width, arguments.keep)
                check_study_page(driver, folder / "study/index.html", width, arguments.keep)
        finally:
            driver.quit()
    for problem in problems:
        print(problem)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
