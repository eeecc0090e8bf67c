"""How archlint itself is built: ``python -m benchmarks.structure`` prints the figures as a table, and
``--draw FILE`` the imports between its packages, as ``.svg`` or ``.dot``."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from benchmarks.structure import imports
from benchmarks.structure.figures import HEADER, all_figures


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.structure", description=__doc__)
    parser.add_argument("--draw", metavar="FILE", type=Path, help="draw the imports between packages: .svg or .dot")
    arguments = parser.parse_args()
    if arguments.draw is not None:
        _draw(arguments.draw)
        return 0
    figures = list(all_figures())
    print(HEADER)
    for figure in figures:
        print(figure.row())
    return 0 if all(figure.holds for figure in figures) else 1


def _draw(file: Path) -> None:
    text = imports.dot(imports.package_graph(imports.module_graph()))
    if file.suffix == ".svg":
        from archlint.render.drawing import layout, tidy_svg

        text = tidy_svg(layout(text, "svg").decode("utf-8"))
    file.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
