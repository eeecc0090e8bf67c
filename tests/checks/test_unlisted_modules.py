"""PKG005: the one module with a main() that no entry point names."""

from __future__ import annotations

PROGRAM = """import rclpy


def main():
    rclpy.init()
    rclpy.spin(rclpy.create_node('node'))


if __name__ == '__main__':
    main()
"""
SETUP = """from setuptools import setup

setup(name='robot', packages=['robot'],
      entry_points={'console_scripts': ['talker = robot.talker:main', 'driver = robot.driver:main']})
"""
FILES = {"setup.py": SETUP, "robot/__init__.py": "", "robot/talker.py": PROGRAM, "robot/driver.py": PROGRAM}


def test_a_module_that_was_forgotten(findings):
    (finding,) = findings("PKG005", **FILES, **{"robot/camera.py": PROGRAM})
    assert finding.help == "add 'camera = robot.camera:main' to console_scripts"
    assert (finding.place.file, finding.place.line) == ("robot/camera.py", 4)


def test_two_of_them_are_scripts(findings):
    assert findings("PKG005", **FILES, **{"robot/camera.py": PROGRAM, "robot/lidar.py": PROGRAM}) == []


def test_a_module_that_another_imports(findings):
    own = {**FILES, "robot/driver.py": f"from robot import camera\n{PROGRAM}"}
    assert findings("PKG005", **own, **{"robot/camera.py": PROGRAM}) == []


def test_a_module_without_ros_or_main(findings):
    assert findings("PKG005", **FILES, **{"robot/tool.py": "def main():\n    print('hello')\n"}) == []
    assert findings("PKG005", **FILES, **{"robot/tool.py": PROGRAM.replace("main", "run")}) == []
