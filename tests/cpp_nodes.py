"""Nodes of C++ in a workspace of one package, and the graph that is read of them."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from pathlib import Path
from textwrap import dedent
from typing import Any

from tests.robot_package import manifest

from archlint.cli import main

NODE = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    %s
  }
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def graph_of(statements: str) -> list[dict[str, Any]]:
    """The nodes of a program whose one node does this in its constructor."""
    return graph({"src/robot.cpp": NODE % statements})["nodes"]


def graph(files: Mapping[str, str], *arguments: str) -> dict[str, Any]:
    """The graph of a package ``robot`` with these files, as ``graph --format json`` has it."""
    here = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "graph.json"
        for path, text in {"package.xml": manifest(build_type="ament_cmake"), **files}.items():
            file = Path(folder) / "ws" / "robot" / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(dedent(text), encoding="utf-8")
        os.chdir(Path(folder) / "ws")
        try:
            main(["graph", "--format", "json", "--no-cache", "-o", str(target), *arguments])
        finally:
            os.chdir(here)
        loaded: dict[str, Any] = json.loads(target.read_text(encoding="utf-8"))
        return loaded
