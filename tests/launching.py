"""Runs launch files of a small workspace."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from archlint.launch.launches import Launches as WorkspaceLaunches
from archlint.launch.model import Launched
from archlint.launch.started import Started
from archlint.programs.entry_points import read_installs
from archlint.syntax.compile import compile_python
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.syntax.workspace_files import WorkspaceFiles
from archlint.workspace.discovery import find
from archlint.workspace.model import SourceFile
from archlint.workspace.tree import SourceTree
from robot_package import SETUP_OF, manifest

PYTHON = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import *
from launch.actions import (DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, OpaqueFunction,
    TimerAction, RegisterEventHandler, ExecuteProcess, SetLaunchConfiguration)
from launch.conditions import IfCondition, UnlessCondition, LaunchConfigurationEquals
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource, AnyLaunchDescriptionSource
from launch.substitutions import (LaunchConfiguration, PathJoinSubstitution, PythonExpression, TextSubstitution,
    EnvironmentVariable, Command, ThisLaunchFileDir)
from launch_ros.actions import (Node, PushRosNamespace, SetRemap, SetParameter, ComposableNodeContainer,
    LoadComposableNodes)
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare
"""


class Launches:
    """``launches.python("[Node(…)]")`` and the like run one launch file of the package ``robot``."""

    knows_command_line = False

    def __init__(self, root: Path) -> None:
        self.root = root
        self.package("robot")

    def package(self, name: str) -> None:
        self.file(f"{name}/package.xml", manifest(name))
        self.file(f"{name}/setup.py", SETUP_OF.format(name=name))

    def file(self, path: str, text: str) -> None:
        target = self.root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")

    def python(self, actions: str, before: str = "", **arguments: str) -> Launched:
        """A launch file that returns these actions; ``before`` are statements of the function."""
        body = "".join(f"    {line}\n" for line in before.splitlines())
        text = f"{PYTHON}\ndef generate_launch_description():\n{body}    return LaunchDescription({actions})\n"
        self.file("robot/launch/it.launch.py", text)
        return self.run("robot/launch/it.launch.py", **arguments)

    def xml(self, content: str, **arguments: str) -> Launched:
        self.file("robot/launch/it.launch.xml", f"<launch>\n{content}\n</launch>\n")
        return self.run("robot/launch/it.launch.xml", **arguments)

    def yaml(self, content: str, **arguments: str) -> Launched:
        self.file("robot/launch/it.launch.yaml", content)
        return self.run("robot/launch/it.launch.yaml", **arguments)

    def of_workspace(
        self, distro: str | None = None, relevant: Callable[[SourceFile], bool] = lambda file: True
    ) -> WorkspaceLaunches:
        workspace = find(["."], working_directory=str(self.root))
        known = {}

        def facts_of(file):
            if file.path not in known:
                known[file.path] = compile_python(Path(file.path).read_text(encoding="utf-8"))
            return known[file.path]

        files = WorkspaceFiles(workspace.files, facts_of, relevant, SourceTree(self.root))
        return WorkspaceLaunches(files, read_installs(workspace.packages, files), distro=distro)

    def run(self, path: str, **arguments: str) -> Launched:
        launches = self.of_workspace()
        launches.knows_command_line = self.knows_command_line
        return call_with_deep_stack(lambda: launches.run(path, arguments))


def names(launched: Launched) -> list[str]:
    """``namespace/name`` of what is started by default; ``-`` for what the launch file leaves to the code."""
    return [full_name(started) for started in launched.started if not started.dormant]


def full_name(started: Started) -> str:
    name = "-" if started.name is None else started.name.text or "?"
    if started.namespace is None:
        return name
    return f"{(started.namespace.text or '?').rstrip('/')}/{name}"


def remaps(started: Started) -> list[tuple[str | None, str | None]]:
    return [(remap.source.text, remap.target.text) for remap in started.remaps]


def parameters(started: Started) -> dict[str | None, object]:
    return {p.name: p.value for p in started.parameters if hasattr(p, "name")}


def node(name: str, **keywords: str) -> str:
    """The Python that makes a node action."""
    more = "".join(f", {key}={value}" for key, value in keywords.items())
    return f"Node(package='robot', executable='talker', name={name!r}{more})"


def left_out(launched: Launched) -> list[tuple[str, str]]:
    """What is told of what could not be followed."""
    return [(gap.kind, gap.reason) for gap in launched.not_followed()]
