"""How readable the pictures are, next to rqt_graph's form of the same graph.

    python -m benchmarks.pictures checkouts/stretch_ros2 checkouts/smarc2

Needs ``archlint[pictures]``.  Services and actions are left out where both sides are shown: rqt_graph draws none.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace

from archlint.render.drawing import layout
from archlint.render.errors import CannotDraw
from benchmarks.pictures import rqt
from benchmarks.pictures.measure import measure

_VIEWS = (("full", False), ("topics", False), ("topics", True), ("nodes", True))
_HEAD = "| | who | shapes | lines | inches | area | crossings | covered | letters on A3 | on A4 |"


def main(paths: Sequence[str]) -> None:
    print(_HEAD)
    print("|---|---|---|---|---|---|---|---|---|---|")
    for path in paths:
        graph = json.loads(_graph(path, "--format", "json"))
        for style, matched in _VIEWS:
            ends = ["--ends"] if matched and style == "topics" else []
            ours = _graph(path, "--format", "dot", "--style", style, *ends)
            name = f"{path.rstrip('/').rpartition('/')[2]} `{' '.join(['--style', style, *ends])}`"
            if style != "full":
                print(
                    "|", " | ".join([name, "rqt_graph", *_figures(rqt.write(graph, style, matched))]), "|", flush=True
                )
            size = _size(_graph(path, "--format", "svg", "--style", style, *ends))
            print("|", " | ".join([name, "archlint", *_figures(ours, size)]), "|", flush=True)


def _size(svg: str) -> tuple[float, float]:
    """Inches.  Graphviz' own layout of the text for ``dot`` has the same lines, but other places for its parts."""
    width, height = re.findall(r'viewBox="[\d.]+ [\d.]+ ([\d.]+) ([\d.]+)"', svg)[0]
    return float(width) / 72, float(height) / 72


def _figures(source: str, size: tuple[float, float] | None = None) -> Iterator[str]:
    try:
        measured = measure(layout(source, "json0"))
    except CannotDraw as error:
        yield str(error)
        return
    if size is not None:
        measured = replace(measured, width=size[0], height=size[1])
    yield from (str(measured.shapes), str(measured.lines), f"{measured.width:.0f} × {measured.height:.0f}")
    yield from (f"{measured.area:.0f}", str(measured.crossings), str(measured.covered), f"{measured.points:.1f} pt")
    yield f"{measured.points / 2**0.5:.1f} pt"


def _graph(path: str, *options: str) -> str:
    command = [sys.executable, "-m", "archlint", "graph", path, "--isolated", "--quiet", *options]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


if __name__ == "__main__":
    main(sys.argv[1:])
