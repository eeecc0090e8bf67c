"""The options of ``archlint graph`` that choose what of a system is shown, and how."""

from __future__ import annotations

import argparse
from typing import get_args

from archlint.cli.options import positive
from archlint.render.view import GroupBy, Style, View


def add_view(parser: argparse.ArgumentParser) -> None:
    shown = parser.add_argument_group("what is shown (GLOB and NAME are for full names, such as '/arm/*')")
    shown.add_argument(
        "--style",
        choices=get_args(Style),
        metavar="STYLE",
        default="full",
        help="nodes: nodes alone; topics: nodes and topics; full: services and actions, too (default: full)",
    )
    shown.add_argument(
        "--focus", action="append", metavar="NAME", help="what is near this node, topic, service or action; repeatable"
    )
    shown.add_argument(
        "--depth", type=positive, metavar="N", default=1, help="near is at most N nodes away (default: 1)"
    )
    shown.add_argument("--only", action="append", metavar="GLOB", help="nothing but these and their ends; repeatable")
    shown.add_argument("--hide", action="append", metavar="GLOB", help="all but these; repeatable")
    shown.add_argument("--ends", action="store_true", help="leave out what nothing in the workspace uses")
    shown.add_argument(
        "--group",
        choices=get_args(GroupBy),
        metavar="BY",
        help="frame nodes by namespace, package, folder (of packages), launch file or process (default: by namespace, "
        "else by package)",
    )
    shown.add_argument(
        "--collapse", action="append", metavar="GLOB", help="draw the groups with such a title as one box; repeatable"
    )
    shown.add_argument(
        "--expand",
        action="append",
        metavar="GLOB",
        help="of more than 60 nodes, draw those of the groups with such a title, '*' for all; repeatable",
    )
    shown.add_argument(
        "--all-lines",
        action="store_true",
        help="of more than 40 lines, draw each: else names at the nodes and lists stand for some",
    )
    shown.add_argument(
        "--all", action="store_true", help="include what ROS gives every node, such as /rosout and parameter services"
    )


def view_of(arguments: argparse.Namespace) -> View:
    return View(
        style=arguments.style,
        focus=tuple(arguments.focus or ()),
        depth=arguments.depth,
        only=tuple(arguments.only or ()),
        hide=tuple(arguments.hide or ()),
        group=arguments.group,
        collapse=tuple(arguments.collapse or ()),
        expand=tuple(arguments.expand or ()),
        matched=arguments.ends,
        every_line=arguments.all_lines,
        everything=arguments.all,
    )


__all__ = ["add_view", "view_of"]
