"""A small workspace: one package, in which a talker and a listener agree on a topic."""

from __future__ import annotations

from pathlib import Path

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.words = self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""

LISTENER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.ears = self.create_subscription(String, 'chatter', self.on_word, 10)

    def on_word(self, message):
        self.get_logger().info(f'heard {message.data}')


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""

_MANIFEST = """\
<package format="3">
  <name>robot</name>
  <version>1.0.0</version>
  <description>two nodes</description>
  <maintainer email="nobody@example.org">nobody</maintainer>
  <license>MIT</license>
  <exec_depend>rclpy</exec_depend>
  <exec_depend>std_msgs</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""

_SETUP = """\
from glob import glob

from setuptools import setup

setup(
    name='robot',
    version='1.0.0',
    packages=['robot'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/robot']),
        ('share/robot', ['package.xml']),
        ('share/robot/launch', glob('launch/*')),
    ],
    entry_points={'console_scripts': ['talker = robot.talker:main', 'listener = robot.listener:main']},
)
"""

_SETUP_CFG = "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n"


class Robot:
    """The files of the workspace in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        package = folder / "src" / "robot"
        self.talker = self._write(package / "robot" / "talker.py", TALKER)
        self.listener = self._write(package / "robot" / "listener.py", LISTENER)
        self.manifest = self._write(package / "package.xml", _MANIFEST)
        self._write(package / "robot" / "__init__.py", "")
        self._write(package / "resource" / "robot", "")
        self._write(package / "setup.cfg", _SETUP_CFG)
        self._write(package / "setup.py", _SETUP)
        (folder / ".git").mkdir()

    def write(self, path: str, text: str) -> Path:
        """Write a file of the package."""
        return self._write(self.folder / "src" / "robot" / path, text)

    def configure(self, text: str) -> Path:
        return self._write(self.folder / "archlint.toml", text)

    def _write(self, file: Path, text: str) -> Path:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, "utf-8")
        return file
