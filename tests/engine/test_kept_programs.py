"""Programs are kept from run to run: what a run gives after any edit is what it gives without a cache."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import redirect_stdout
from io import StringIO
from itertools import pairwise
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.interpreter.machine import Machine
from archlint.launch.launches import Launches
from archlint.programs.follower import Follower
from archlint.programs.keys import EntryKey, ProgramKey
from archlint.workspace import words

FILES = {
    "interfaces/package.xml": """\
        <package format="3"><name>interfaces</name><version>1.0.0</version><description>d</description>
        <maintainer email="a@b.org">m</maintainer><license>MIT</license>
        <buildtool_depend>ament_cmake</buildtool_depend><buildtool_depend>rosidl_default_generators</buildtool_depend>
        <exec_depend>rosidl_default_runtime</exec_depend>
        <member_of_group>rosidl_interface_packages</member_of_group>
        <export><build_type>ament_cmake</build_type></export></package>
        """,
    "interfaces/CMakeLists.txt": 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg")\n',
    "interfaces/msg/Speed.msg": "float32 metres_per_second\n",
    "robot/package.xml": """\
        <package format="3"><name>robot</name><version>1.0.0</version><description>d</description>
        <maintainer email="a@b.org">m</maintainer><license>MIT</license>
        <exec_depend>rclpy</exec_depend><exec_depend>std_msgs</exec_depend><exec_depend>interfaces</exec_depend>
        <export><build_type>ament_python</build_type></export></package>
        """,
    "robot/resource/robot": "",
    "robot/setup.cfg": "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n",
    "robot/setup.py": """\
        from setuptools import find_packages, setup
        from glob import glob

        setup(
            name='robot',
            packages=find_packages(),
            data_files=[
                ('share/ament_index/resource_index/packages', ['resource/robot']),
                ('share/robot', ['package.xml']),
                ('share/robot/launch', glob('launch/*')),
            ],
            entry_points={'console_scripts': ['talker = robot.talker:main', 'listener = robot.listener:main']},
        )
        """,
    "robot/robot/__init__.py": "",
    "robot/robot/names.py": "from robot.prefix import PREFIX\n\nSPEED = PREFIX + 'speed'\n",
    "robot/robot/prefix.py": "PREFIX = 'drive/'\n",
    "robot/robot/registry.py": """\
        NODES = {}


        def register(cls):
            NODES[cls.__name__] = cls
            return cls
        """,
    "robot/robot/base.py": """\
        from rclpy.node import Node


        class Base(Node):
            def __init__(self, name):
                super().__init__(name)
                self.declare_parameter('rate', 10.0)

            def wait_for(self, client):
                client.wait_for_service()
        """,
    "robot/robot/talker.py": """\
        import rclpy
        from interfaces.msg import Speed
        from robot.base import Base
        from robot.names import SPEED


        class Talker(Base):
            def __init__(self):
                super().__init__('talker')
                self.publisher = self.create_publisher(Speed, SPEED, 10)
                self.create_timer(0.1, self.tick)

            def tick(self):
                self.publisher.publish(Speed(metres_per_second=1.0))


        def main():
            rclpy.init()
            rclpy.spin(Talker())


        if __name__ == '__main__':
            main()
        """,
    "robot/robot/listener.py": """\
        import rclpy
        from interfaces.msg import Speed
        from std_srvs.srv import Trigger
        from robot import extra
        from robot.base import Base
        from robot.names import SPEED
        from robot.registry import NODES, register


        @register
        class Listener(Base):
            def __init__(self):
                super().__init__('listener')
                self.create_subscription(Speed, SPEED, self.on_speed, 10)
                self.client = self.create_client(Trigger, '/stop')
                self.wait_for(self.client)

            def on_speed(self, message):
                self.get_logger().info(str(message.metres_per_second))


        def main():
            rclpy.init()
            node = NODES['Listener']()
            for cls in Base.__subclasses__():
                print(cls)
            rclpy.spin(node)
        """,
    "robot/robot/extra.py": """\
        from rclpy.node import Node
        from std_msgs.msg import String
        from robot.registry import register


        @register
        class Extra(Node):
            def __init__(self):
                super().__init__('extra')
                self.publisher = self.create_publisher(String, 'extra', 10)


        def publish_on(node, name='alone'):
            node.create_publisher(String, name, 10)
        """,
    "robot/robot/watcher.py": """\
        import rclpy
        from std_msgs.msg import String
        from robot.extra import publish_on
        from robot.registry import NODES


        class Watcher(rclpy.node.Node):
            def __init__(self):
                super().__init__('watcher')
                self.create_subscription(String, 'extra', print, 10)
                publish_on(self, 'watched')


        def main():
            rclpy.init()
            node = Watcher()
            for cls in NODES.values():
                cls()
            rclpy.spin(node)


        if __name__ == '__main__':
            main()
        """,
    "robot/launch/robot.launch.py": """\
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument
        from launch.substitutions import LaunchConfiguration
        from launch_ros.actions import Node


        def generate_launch_description():
            return LaunchDescription([
                DeclareLaunchArgument('rate', default_value='5.0'),
                Node(package='robot', executable='talker', parameters=[{'rate': LaunchConfiguration('rate')}]),
                Node(package='robot', executable='listener', remappings=[('drive/speed', 'speed')]),
            ])
        """,
    "robot/launch/all.launch.py": """\
        import os

        import yaml
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
        from launch.conditions import IfCondition
        from launch.launch_description_sources import PythonLaunchDescriptionSource
        from launch.substitutions import LaunchConfiguration
        from launch_ros.actions import Node
        from robot.shared import LOCAL, names

        SHARE = get_package_share_directory('robot')


        def generate_launch_description():
            with open(os.path.join(SHARE, 'launch', 'names.yaml')) as stream:
                named = yaml.safe_load(stream)
            entities = [
                DeclareLaunchArgument('watch'),
                IncludeLaunchDescription(
                    PythonLaunchDescriptionSource(os.path.join(SHARE, 'launch', 'robot.launch.py')),
                    launch_arguments={'rate': '7.0'}.items(),
                ),
                Node(
                    package='robot', executable='listener', name=named['listener'], namespace=names()[0],
                    parameters=[os.path.join(SHARE, 'launch', 'listener.yaml')],
                ),
                Node(
                    package='robot', executable='talker', name='watched',
                    condition=IfCondition(LaunchConfiguration('watch')),
                ),
            ]
            if LOCAL:
                entities.append(Node(package='robot', executable='talker', name='local'))
            return LaunchDescription(entities)
        """,
    "robot/robot/shared.py": """\
        import os

        from ament_index_python.packages import get_package_share_directory

        LOCAL = os.path.exists(os.path.join(get_package_share_directory('robot'), 'launch', 'local.yaml'))


        def names():
            return ['left', 'right']
        """,
    "robot/launch/again.launch.py": """\
        from launch import LaunchDescription
        from launch_ros.actions import Node
        from robot.shared import LOCAL, names


        def generate_launch_description():
            nodes = [Node(package='robot', executable='talker', namespace=name) for name in names()]
            return LaunchDescription(nodes if LOCAL else nodes[:1])
        """,
    "robot/launch/words.launch.py": """\
        import sys

        from launch import LaunchDescription
        from launch_ros.actions import Node

        NAME = sys.argv[2]


        def generate_launch_description():
            return LaunchDescription([Node(package='robot', executable='talker', name=NAME.replace('.', '_'))])
        """,
    "robot/launch/works.launch.py": """\
        import os

        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch.actions import IncludeLaunchDescription
        from launch_ros.actions import Node


        def generate_launch_description():
            words = os.path.join(get_package_share_directory('robot'), 'launch', 'words.launch.py')
            return LaunchDescription([
                Node(package='robot', executable='listener', name='worker'),
                IncludeLaunchDescription(words),
            ])
        """,
    "robot/launch/names.yaml": "listener: ear\n",
    "robot/launch/listener.yaml": "/**:\n  ros__parameters:\n    rate: 3.0\n",
    "robot/launch/whole.launch.xml": """\
        <launch>
          <arg name="side" default="left"/>
          <include file="$(find-pkg-share robot)/launch/again.launch.py"/>
          <node pkg="robot" exec="listener" namespace="$(var side)">
            <param from="$(find-pkg-share robot)/launch/listener.yaml"/>
          </node>
        </launch>
        """,
    ".gitignore": "ignored.yaml\n",
    "robot/launch/ignored.yaml": "/**:\n  ros__parameters:\n    rate: 4.0\n",
}

Edit = Callable[[Path], object]


def replaced(name: str, old: str, new: str) -> Edit:
    def edit(folder: Path) -> None:
        path = folder / name
        if path.exists():
            path.write_text(path.read_text("utf-8").replace(old, new), "utf-8")

    return edit


def written(name: str, text: str) -> Edit:
    def edit(folder: Path) -> None:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")

    return edit


def with_comment(name: str, text: str) -> Edit:
    """A comment at the end: no place of the code changes."""

    def edit(folder: Path) -> None:
        if (folder / name).exists():
            with (folder / name).open("a", encoding="utf-8") as stream:
                stream.write(f"# {text}\n")

    return edit


def removed(name: str) -> Edit:
    return lambda folder: (folder / name).unlink(missing_ok=True)


def restored(name: str) -> Edit:
    return written(name, FILES[name])


EDITS = {
    "a comment at the end": with_comment("robot/robot/names.py", "until then"),
    "a comment that names a parameter": with_comment("robot/robot/talker.py", "the rate of speed"),
    "a comment that names a topic": with_comment("robot/robot/extra.py", "drive/speed, extra"),
    "a comment that names a class": with_comment("robot/robot/watcher.py", "Talker wait_for publish_on"),
    "a comment that names a module": with_comment("robot/setup.py", "extra watcher.py robot.extra"),
    "a comment in a launch file": with_comment("robot/launch/robot.launch.py", "robot.watcher ROS_DISTRO rates"),
    "a comment that turns a rule off": with_comment("robot/robot/base.py", "archlint: ignore-file[TMO001]"),
    "a constant three modules away": replaced("robot/robot/prefix.py", "drive/", "wheels/"),
    "that constant again": replaced("robot/robot/prefix.py", "wheels/", "/absolute/"),
    "a comment": replaced("robot/robot/talker.py", "rclpy.spin(", "rclpy.spin(  # until Ctrl-C\n        "),
    "a module that nothing found before": written("robot/std_srvs/srv.py", "class Trigger:\n    pass\n"),
    "and its package": written("robot/std_srvs/__init__.py", ""),
    "a module disappears": removed("robot/robot/names.py"),
    "it comes back": restored("robot/robot/names.py"),
    "a package loses its __init__.py": removed("robot/robot/__init__.py"),
    "it gets one": restored("robot/robot/__init__.py"),
    "a class registers no more": replaced("robot/robot/extra.py", "@register\n", ""),
    "a class registers": replaced("robot/robot/extra.py", "class Extra", "@register\nclass Extra"),
    "a module is not imported": replaced("robot/robot/listener.py", "from robot import extra\n", ""),
    "a module is imported": replaced(
        "robot/robot/watcher.py", "import rclpy\n", "import rclpy\nimport robot.listener\n"
    ),
    "a field has another name": replaced("interfaces/msg/Speed.msg", "metres_per_second", "speed"),
    "another interface": replaced("interfaces/CMakeLists.txt", "msg/Speed.msg", "msg/Pace.msg"),
    "an executable less": replaced("robot/setup.py", ", 'listener = robot.listener:main'", ""),
    "an executable of another name": replaced("robot/setup.py", "talker =", "speaker ="),
    "a launch argument": replaced("robot/launch/robot.launch.py", "'5.0'", "'fast'"),
    "a remapping": replaced("robot/launch/robot.launch.py", "('drive/speed', 'speed')", "('extra', 'speed')"),
    "a launch file fails": replaced("robot/launch/again.launch.py", "nodes[:1]", "nodez"),
    "another namespace": replaced("robot/robot/shared.py", "'left'", "'front'"),
    "a file that a module of launches asks for": written("robot/launch/local.yaml", "{}\n"),
    "it goes": removed("robot/launch/local.yaml"),
    "a parameter has another type": replaced("robot/launch/listener.yaml", "3.0", "fast"),
    "a parameter file is broken": replaced("robot/launch/listener.yaml", "rate: 3.0", "rate: ["),
    "a parameter file disappears": removed("robot/launch/listener.yaml"),
    "and is there again": restored("robot/launch/listener.yaml"),
    "a name in a file that the launch opens": replaced("robot/launch/names.yaml", "ear", "Ear"),
    "that file disappears": removed("robot/launch/names.yaml"),
    "an included file disappears": removed("robot/launch/robot.launch.py"),
    "a launch file includes itself": replaced("robot/launch/whole.launch.xml", "again.launch.py", "whole.launch.xml"),
    "the default of an argument of XML": replaced("robot/launch/whole.launch.xml", "left", "//right"),
    "a launch file is no XML": replaced("robot/launch/whole.launch.xml", "</launch>", "<launch>"),
    "a parameter file that git ignores": replaced("robot/launch/whole.launch.xml", "listener.yaml", "ignored.yaml"),
    "that file has another type": replaced("robot/launch/ignored.yaml", "4.0", "fast"),
    "git ignores it no more": removed(".gitignore"),
    "launch files are not installed": replaced("robot/setup.py", "('share/robot/launch', glob('launch/*')),", ""),
    "an argument of an include": replaced("robot/launch/all.launch.py", "'7.0'", "'seven'"),
    "an argument with a default": replaced("robot/launch/all.launch.py", "('watch')", "('watch', default_value='0')"),
    "what includes a file that asks for the words": replaced("robot/launch/works.launch.py", "worker", "Worker"),
    "a file that asks for the words": replaced("robot/launch/words.launch.py", "argv[2]", "argv[1]"),
    "another base": replaced("robot/robot/base.py", "'rate', 10.0", "'rates', 10"),
    "a file that is no Python": written("robot/robot/prefix.py", "PREFIX = (\n"),
    "a test": written("robot/test/test_talker.py", "from robot.talker import Talker\n\n\ndef test():\n    Talker()\n"),
    "a name that starts with another case": replaced("robot/robot/talker.py", "'talker'", "'Talker'"),
}


def write_all(folder: Path, files: Mapping[str, str] = FILES) -> None:
    for name, text in files.items():
        lines = text.split("\n")
        indent = len(lines[0]) - len(lines[0].lstrip())
        written(name, "\n".join(line[indent:] if line[:indent].isspace() else line for line in lines))(folder)


def printed_by(*cache: str, options: tuple[str, ...] = ()) -> list[str]:
    """What `check` and `graph` print in the folder where they run."""
    printed = []
    for command in (["check", "--exit-zero", *options], ["graph"]):
        with redirect_stdout(StringIO()) as output:
            main([*command, ".", "--format", "json", "--jobs", "1", "--isolated", *cache])
        printed.append(re.sub(r'"elapsed_s": [\d.e-]+', "", output.getvalue()))
    return printed


Outputs = Callable[..., list[str]]
"""What `check` and `graph` print, with a cache or without one."""


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "ws"
    write_all(folder)
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def outputs(tmp_path: Path) -> Outputs:
    cache = "--cache-dir", str(tmp_path / "cache")
    return lambda cached, *options: printed_by(*(cache if cached else ("--no-cache",)), options=options)


@pytest.fixture(scope="module")
def known(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the workspace, the cache of a run over it, and a copy of both."""
    folder = tmp_path_factory.mktemp("known")
    write_all(folder / "ws")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder / "ws")
        printed_by("--cache-dir", str(folder / "cache"))
    for name in ("ws", "cache"):
        shutil.copytree(folder / name, folder / "copies" / name)
    return folder


@pytest.fixture
def known_workspace(known: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The workspace, over which a run with the cache has been."""
    monkeypatch.chdir(known / "ws")
    yield known / "ws"
    monkeypatch.chdir(known)
    restore(known / "ws", known / "copies" / "ws")
    shutil.rmtree(known / "cache")
    shutil.copytree(known / "copies" / "cache", known / "cache")


def restore(folder: Path, copy: Path) -> None:
    """Make a folder what its copy is.  A file that is as it was stays the same file."""
    for path in sorted(folder.rglob("*"), reverse=True):
        kept = copy / path.relative_to(folder)
        if not kept.exists():
            path.rmdir() if path.is_dir() else path.unlink()
    for kept in copy.rglob("*"):
        path = folder / kept.relative_to(copy)
        if kept.is_file() and not (path.exists() and path.read_bytes() == kept.read_bytes()):
            path.parent.mkdir(exist_ok=True)
            shutil.copy2(kept, path)


@pytest.fixture
def known_outputs(known: Path) -> Outputs:
    return lambda cached: printed_by(*(("--cache-dir", str(known / "cache")) if cached else ("--no-cache",)))


@pytest.fixture
def followed(monkeypatch: pytest.MonkeyPatch) -> list[ProgramKey]:
    """The programs that are followed, and not known from an earlier run."""
    keys: list[ProgramKey] = []
    follow = Follower.follow

    def noting(self, key, act):
        return follow(self, key, lambda: [keys.append(key), act()][1])

    monkeypatch.setattr(Follower, "follow", noting)
    return keys


def test_only_what_an_edit_can_change_is_followed_again(workspace, outputs, followed):
    replaced("robot/robot/listener.py", "Base.__subclasses__()", "[]")(workspace)  # this asks for all modules
    outputs(cached=True)
    followed.clear()
    replaced("robot/robot/talker.py", "0.1", "0.2")(workspace)
    outputs(cached=True)
    assert {key.file for key in followed if isinstance(key, EntryKey)} == {"robot/robot/talker.py"}
    followed.clear()
    replaced("robot/robot/prefix.py", "drive", "wheels")(workspace)
    outputs(cached=True)
    files = {key.file for key in followed if isinstance(key, EntryKey)}
    assert files == {"robot/robot/talker.py", "robot/robot/listener.py"}


LOUD = """\
    import rclpy
    from rclpy.node import Node
    from rclpy.parameter import Parameter
    from std_msgs.msg import String


    class Talker(Node):
        def __init__(self):
            super().__init__('talker', allow_undeclared_parameters=True)
            if self.get_parameter_or('loud', Parameter('loud', value=False)).value:
                self.create_publisher(String, 'shout', 10)


    def main():
        rclpy.init()
        rclpy.spin(Talker())
    """
BLUE = """\
    <launch><node pkg="robot" exec="talker" namespace="blue"><param name="color" value="blue"/></node></launch>
    """


def test_a_program_of_a_launch_that_does_what_it_does_alone_is_known_afterwards(workspace, outputs, followed):
    write_all(workspace, {"robot/robot/talker.py": LOUD, "robot/launch/blue.launch.xml": BLUE})
    printed = outputs(cached=True)  # `check`, and then `graph`, which knows all programs
    assert [key.file for key in followed if isinstance(key, EntryKey)].count("robot/robot/talker.py") == 1
    assert printed == outputs(cached=False)


CPP = {
    "drive/package.xml": """\
        <package format="3"><name>drive</name><version>1.0.0</version><description>d</description>
        <maintainer email="a@b.org">m</maintainer><license>MIT</license>
        <buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend><depend>std_msgs</depend>
        <export><build_type>ament_cmake</build_type></export></package>
        """,
    "drive/CMakeLists.txt": """\
        project(drive)
        include_directories(include)
        add_executable(drive src/drive.cpp src/ramp.cpp src/names.cpp)
        install(TARGETS drive DESTINATION lib/${PROJECT_NAME})
        """,
    "drive/include/drive/names.hpp": """\
        #pragma once
        #include <string>
        struct Names {
          static std::string ramp();
        };
        """,
    "drive/src/names.cpp": '#include "drive/names.hpp"\nstd::string Names::ramp() { return "ramp"; }\n',
    "drive/include/drive/ramp.hpp": """\
        #pragma once
        #include <string>
        struct Ramp {
          static std::string topic();
        };
        """,
    "drive/src/ramp.cpp": """\
        #include "drive/ramp.hpp"
        #include "drive/names.hpp"
        std::string Ramp::topic() { return Names::ramp(); }
        """,
    "drive/src/drive.cpp": """\
        #include "rclcpp/rclcpp.hpp"
        #include "std_msgs/msg/string.hpp"
        #include "drive/ramp.hpp"
        class Drive : public rclcpp::Node {
         public:
          Drive() : Node("drive") {
            publisher_ = create_publisher<std_msgs::msg::String>(Ramp::topic(), 10);
          }
         private:
          rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
        };
        int main(int argc, char ** argv) {
          rclcpp::init(argc, argv);
          rclcpp::spin(std::make_shared<Drive>());
        }
        """,
}
"""A package of C++ whose node uses what two sources define, each with a header of its own."""


def test_cpp_is_followed_again_where_a_source_of_it_has_changed(workspace, outputs, followed):
    """Also one that only defines what a header declares."""
    write_all(workspace, CPP)
    assert '"/ramp"' in outputs(cached=True)[1]

    for edit, again in (
        (replaced("robot/robot/talker.py", "0.1", "0.2"), False),
        (replaced("drive/src/names.cpp", '"ramp"', '"slope"'), True),
        (replaced("drive/include/drive/ramp.hpp", "topic();", "topic();\n  static int steps();"), True),
        (written("drive/src/more.cpp", '#include "drive/ramp.hpp"\nint Ramp::steps() { return 1; }\n'), True),
        (replaced("robot/robot/talker.py", "0.2", "0.3"), False),
    ):
        edit(workspace)
        followed.clear()
        printed = outputs(cached=True)
        assert any(key.file == "drive/src/drive.cpp" for key in followed) is again
        assert printed == outputs(cached=False)


PARK = """\
    #include "rclcpp/rclcpp.hpp"
    #include "std_msgs/msg/string.hpp"
    #include "drive/names.hpp"
    #include "drive/ramp.hpp"
    int main(int argc, char ** argv) {
      rclcpp::init(argc, argv);
      auto node = std::make_shared<rclcpp::Node>("park");
      auto ends = node->create_subscription<std_msgs::msg::String>(Ramp::topic(), 10, [](std_msgs::msg::String) {});
      auto begins = node->create_publisher<std_msgs::msg::String>(Names::ramp() + "/parked", 10);
      rclcpp::spin(node);
    }
    """
"""Another program with the same headers."""


def test_sources_of_cpp_run_again_for_programs_of_cpp_alone(workspace, outputs, monkeypatch):
    """What a source defines of a header is known by all that include the header, also where that source is not followed
    again."""
    built = "add_executable(park src/park.cpp src/ramp.cpp src/names.cpp)\ninstall(TARGETS park "
    write_all(workspace, {**CPP, "drive/src/park.cpp": PARK})
    replaced("drive/CMakeLists.txt", "install(TARGETS ", built)(workspace)
    replaced("robot/robot/listener.py", "Base.__subclasses__()", "[]")(workspace)  # this asks for all modules
    ran: list[str] = []
    run = Machine._run_top_level
    monkeypatch.setattr(Machine, "_run_top_level", lambda self, module: [ran.append(module.path), run(self, module)][1])
    assert '"/ramp/parked"' in outputs(cached=True)[1]
    for edit, again in (
        (replaced("robot/robot/talker.py", "0.1", "0.2"), False),
        (replaced("drive/src/park.cpp", "parked", "stopped"), True),
        (replaced("robot/robot/talker.py", "0.2", "0.3"), False),
        (replaced("drive/src/drive.cpp", '"drive"', '"driver"'), True),
    ):
        edit(workspace)
        ran.clear()
        printed = outputs(cached=True)
        assert ("drive/src/names.cpp" in ran) is again
        assert printed == outputs(cached=False)


def test_only_the_launches_that_an_edit_can_change_run_again(workspace, outputs, monkeypatch):
    """One that asks for the words of its command line runs each time."""
    launched: list[str] = []
    asks = {"robot/launch/words.launch.py"}
    run = Launches._run
    monkeypatch.setattr(Launches, "_run", lambda self, path, given: [launched.append(path), run(self, path, given)][1])
    outputs(cached=True)
    assert set(launched) == {name for name in FILES if ".launch." in name}
    launched.clear()
    replaced("robot/robot/talker.py", "0.1", "0.2")(workspace)
    outputs(cached=True)
    assert set(launched) == asks
    launched.clear()
    replaced("robot/launch/robot.launch.py", "'5.0'", "'6.0'")(workspace)
    outputs(cached=True)
    assert set(launched) == {"robot/launch/robot.launch.py", "robot/launch/all.launch.py"} | asks
    launched.clear()
    written("robot/launch/local.yaml", "{}\n")(workspace)  # a file more: anything may be meant by it
    outputs(cached=True)
    assert set(launched) == {name for name in FILES if ".launch." in name}
    launched.clear()
    replaced("robot/launch/ignored.yaml", "4.0", "5.0")(workspace)
    replaced("robot/launch/names.yaml", "ear", "eye")(workspace)
    outputs(cached=True)
    assert set(launched) == {"robot/launch/all.launch.py"} | asks


LAUNCHES = """
import sys
from archlint.cli import main
from archlint.interpreter.machine import Machine
from archlint.launch.launches import Launches

run = Launches._run
Launches._run = lambda self, path, given: [print(path, file=sys.stderr), run(self, path, given)][1]
sys.exit(main(["check", ".", "--isolated", "--exit-zero", "--quiet", "--jobs", "1", "--cache-dir", "../cache"]))
"""
"""A run that says which launches it follows."""


def test_launches_are_known_to_another_process(workspace):
    """What a package installs holds sets, such as the folders of Python code, or what CMake gives a target, and each
    process has its own order of what is in a set."""
    write_all(workspace, CPP)
    given = "ament_target_dependencies(drive rclcpp std_msgs std_srvs nav_msgs sensor_msgs)\ninstall("
    replaced("drive/CMakeLists.txt", "install(", given)(workspace)
    for folder in ("maths", "words", "colours", "shapes"):
        written(f"robot/robot/{folder}/__init__.py", "")(workspace)
    launched: list[str] = []
    periods = ["0.1", "0.2", "0.3", "0.4", "0.5"]
    for seed, (period, other) in enumerate(pairwise(periods)):
        replaced("robot/robot/talker.py", period, other)(workspace)
        environment = {**os.environ, "PYTHONHASHSEED": str(seed)}
        command = [sys.executable, "-c", LAUNCHES]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        launched.append(done.stderr)
    assert len(launched[0].split()) > 2
    assert [said.split() for said in launched[1:]] == [["robot/launch/words.launch.py"]] * 3


def test_a_file_that_is_as_it_was_is_not_read_for_its_words(workspace, monkeypatch):
    printed_by("--cache-dir", "../cache")
    read: list[str] = []
    split = words._split
    monkeypatch.setattr(words, "_split", lambda path, text: [read.append(path), split(path, text)][1])
    replaced("robot/robot/talker.py", "0.1", "0.2")(workspace)
    printed = printed_by("--cache-dir", "../cache")
    assert "robot/robot/talker.py" in read
    assert "robot/robot/listener.py" not in read
    assert printed == printed_by("--no-cache")
    assert "robot/robot/listener.py" in read


def test_a_comment_at_the_end_is_no_reason_to_judge_again(workspace, outputs, monkeypatch):
    before = outputs(cached=True)
    with_comment("robot/robot/names.py", "no rule asks for such words")(workspace)
    monkeypatch.setattr("archlint.engine.findings.judged_in_parts", None)
    assert outputs(cached=True) == before
    assert outputs(cached=True) == before


def test_a_comment_is_a_reason_where_its_words_were_asked_for(workspace, outputs):
    """A parameter that is never read, and that no other file names, is one too many."""
    before = outputs(True, "--select", "PRM006")
    assert "'rate' is declared but never read" in before[0]
    with_comment("robot/robot/talker.py", "the rate of speed")(workspace)
    after = outputs(True, "--select", "PRM006")
    assert after == outputs(False, "--select", "PRM006")
    assert "PRM006" not in after[0]


@pytest.mark.parametrize("name", EDITS)
def test_an_edit_gives_what_a_run_without_a_cache_gives(known_workspace, known_outputs, name):
    EDITS[name](known_workspace)
    assert known_outputs(cached=True) == known_outputs(cached=False)


@pytest.mark.parametrize("seed", range(3))
def test_one_edit_after_another_gives_what_runs_without_a_cache_give(known_workspace, known_outputs, seed):
    chance = random.Random(seed)
    for name in chance.sample(sorted(EDITS), 8):
        EDITS[name](known_workspace)
        assert known_outputs(cached=True) == known_outputs(cached=False), name
