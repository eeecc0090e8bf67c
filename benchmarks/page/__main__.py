"""How fast the HTML page of a large system is: ``python -m benchmarks.page [--nodes N] [--keep FILE]``.

Writes the page of a made-up system and opens it in a headless Chromium, which draws without a graphics card here.
Printed are seconds to write the page, its size, milliseconds from opening to the first picture, and milliseconds
between frames while the picture is moved and zoomed.  A busy machine makes all of them worse, and least of all the
processor time that a frame takes, of all processes and threads of the browser together.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

from archlint.render.html import render
from benchmarks.page.chromium import Chromium

_TESTS = Path(__file__).parents[2] / "tests"
_FRAMES = """((move) => new Promise((done) => {
  const canvas = d3.select('#canvas'), zoom = d3.zoom(), times = [];
  let before;
  const step = (now) => {
    if (before !== undefined) times.push(now - before);
    before = now;
    if (times.length === 90) return done(times.sort((a, b) => a - b));
    move(canvas, times.length);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}))"""
_WHEEL = """(canvas, count) => canvas.node().dispatchEvent(new WheelEvent('wheel',
  { deltaY: count < 45 ? -30 : 30, clientX: 600, clientY: 400, bubbles: true, cancelable: true, view: window }))"""
_ARROW = """(canvas, count) => canvas.node().dispatchEvent(new KeyboardEvent('keydown',
  { key: count % 30 < 15 ? 'ArrowLeft' : 'ArrowRight', bubbles: true, cancelable: true }))"""


def main() -> int:
    options = argparse.ArgumentParser("benchmarks.page", description=__doc__)
    options.add_argument("--nodes", type=int, default=1000)
    options.add_argument("--keep", type=Path, help="write the page here")
    chosen = options.parse_args()
    sys.path.insert(0, str(_TESTS))
    from benchmarks.page.large import large

    system = large(chosen.nodes)
    started = time.perf_counter()
    page = render(system)
    written = time.perf_counter() - started
    with tempfile.TemporaryDirectory() as folder:
        file = chosen.keep or Path(folder, "page.html")
        file.write_text(page, encoding="utf-8")
        print(f"{chosen.nodes} nodes, {len(system.topics)} topics, {len(system.services)} services")
        print(f"written in {written:.1f} s, {len(page) / 1e6:.1f} MB; load of this machine {os.getloadavg()[0]:.1f}")
        _measure(file)
    return 0


def _measure(file: Path) -> None:
    with Chromium(1600, 1000) as browser:
        browser.open(file)
        print(f"first picture after {browser.run(_FIRST):.0f} ms")
        _idle(browser)
        _frames(browser, "nothing moves, frames asked for", "() => 0")
        _frames(browser, "moved, all of it in view", _ARROW)
        _frames(browser, "zoomed in and out", _WHEEL)
        browser.run("[...Array(6)].forEach(() => document.getElementById('in').click())")
        _frames(browser, "moved, names in view", _ARROW)
        for complaint in browser.complaints():
            print(f"complaint: {complaint}")


_REST = 5.0
"""Seconds."""
_FIRST = "performance.getEntriesByName('drawn')[0].startTime"


def _idle(browser: Chromium) -> None:
    """What an open page takes that nobody touches, in which no script asks for a frame."""
    browser.settle()
    time.sleep(_REST)  # until what the browser does once after loading is done
    before = browser.processor_time()
    time.sleep(_REST)
    taken = 1000 * (browser.processor_time() - before) / _REST
    print(f"nobody touches it: {taken:.0f} ms of processor time a second")


def _frames(browser: Chromium, what: str, move: str) -> None:
    browser.settle()
    before = browser.processor_time()
    times = browser.run(f"{_FRAMES}({move})")
    taken = 1000 * (browser.processor_time() - before) / len(times)
    print(
        f"{what}: {times[len(times) // 2]:.0f} ms a frame, 95 of 100 within {times[int(len(times) * 0.95)]:.0f} ms; "
        f"{taken:.0f} ms of processor time"
    )


if __name__ == "__main__":
    raise SystemExit(main())
