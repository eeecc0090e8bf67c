"""``archlint observe``: the recorder that writes down a running system, to run where ROS is."""

from __future__ import annotations

import argparse
from importlib.resources import files

from archlint.cli import console
from archlint.cli.exits import CLEAN, UsageError
from archlint.cli.parser import Parser

_EPILOG = """\
The script needs rclpy and nothing else. Run it where ROS 2 is sourced while the
system is running, then compare:

  archlint observe --print-script -o record.py
  python3 record.py -o robot.json
  archlint check --launch robot.launch.py --observed robot.json
"""


def parser() -> Parser:
    parser = Parser("observe", "Print the script that records the graph of a running ROS 2 system.")
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    parser.add_argument("--print-script", action="store_true", help="print the script")
    parser.add_argument("-o", metavar="FILE", dest="file", help="write it to FILE (default: standard output)")
    return parser


def run(arguments: argparse.Namespace) -> int:
    if not arguments.print_script:
        raise UsageError("archlint does not run ROS itself: `archlint observe --print-script` prints the script to run")
    console.write(files("archlint.observed").joinpath("recorder.py").read_text("utf-8"), arguments.file)
    return CLEAN
