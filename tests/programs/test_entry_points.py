"""What packages install: from setup.py, setup.cfg, pyproject.toml and CMakeLists.txt."""

from __future__ import annotations

import re

import pytest

from archlint.workspace.discovery import find
from archlint.workspace.installed import Installs
from archlint.workspace.tree import SourceTree
from installing import MANIFEST


def test_console_scripts_through_variables_and_comprehensions(installs_of):
    installs = installs_of(
        **{
            "setup.py": """\
from setuptools import setup
package_name = 'robot'
nodes = ['talker', 'listener']
setup(
    name=package_name,
    entry_points={
        'console_scripts': [f'{n} = {package_name}.{n}:main' for n in nodes] + ['odd = robot.a.b:run.go'],
    },
)
"""
        }
    )
    found = {e.name: (e.module, e.function) for e in installs.executables.values()}
    assert found == {
        "talker": ("robot.talker", "main"),
        "listener": ("robot.listener", "main"),
        "odd": ("robot.a.b", "run.go"),
    }
    assert not installs.open_executables


def test_a_console_script_shows_its_own_line(installs_of):
    installs = installs_of(
        **{
            "setup.py": """\
from setuptools import setup
setup(entry_points={
    'console_scripts': [
        'talker = robot.talker:main',
    ],
})
"""
        }
    )
    place = installs.executables["talker"].place
    assert (place.file, place.line, place.column) == ("robot/setup.py", 4, 9)


def test_setup_py_is_never_executed(installs_of, tmp_path):
    marker = tmp_path / "executed"
    text = f"open({str(marker)!r}, 'w')\nfrom setuptools import setup\nsetup()\n"
    installs = installs_of(**{"setup.py": text})
    assert not marker.exists()
    assert installs.executables == {}


def test_what_a_setup_py_hides_is_open(installs_of):
    hidden = (
        "from setuptools import setup\nfrom tools import scripts\nsetup(entry_points={'console_scripts': scripts()})\n"
    )
    assert installs_of(**{"setup.py": hidden}).open_executables


def test_setup_cfg_and_pyproject(installs_of):
    installs = installs_of(
        **{
            "setup.cfg": "[options.entry_points]\nconsole_scripts =\n    talker = robot.talker:main\n",
            "pyproject.toml": '[project.scripts]\nlistener = "robot.listener:main"\n',
        }
    )
    places = {e.name: (e.place.file, e.place.line) for e in installs.executables.values()}
    assert places == {"talker": ("robot/setup.cfg", 3), "listener": ("robot/pyproject.toml", 2)}


DATA_FILES = """\
[metadata]
name = robot

[options.data_files]
share/robot =
    package.xml
share/robot/Launch = launch/*.launch.py
share/robot/maps =
    maps/hall.yaml
    maps/hall.pgm
"""


@pytest.mark.parametrize("call", ["setup()", "setup(data_files=[('share/robot', ['README.md'])])"])
def test_data_files_of_setup_cfg(installs_of, call):
    installs = installs_of(**{"setup.cfg": DATA_FILES, "setup.py": f"from setuptools import setup\n{call}\n"})
    listed = [(file.destination, file.source, file.place and file.place.line) for file in installs.files]
    if call == "setup()":
        assert listed == [
            ("share/robot", "robot/package.xml", 6),
            ("share/robot/Launch", "robot/launch/*.launch.py", 7),
            ("share/robot/maps", "robot/maps/hall.yaml", 9),
            ("share/robot/maps", "robot/maps/hall.pgm", 10),
        ]
    else:  # what setup.py lists itself counts
        assert [row[:2] for row in listed] == [("share/robot", "robot/README.md")]
    assert not installs.open_files


def test_programs_of_cmake(installs_of):
    installs = installs_of(
        **{
            "CMakeLists.txt": """\
project(robot)
set(SCRIPTS scripts/one.py scripts/two.py)  # both
install(PROGRAMS ${SCRIPTS} DESTINATION lib/${PROJECT_NAME})
install(PROGRAMS scripts/three.py
  DESTINATION lib/${PROJECT_NAME} RENAME three)
add_executable(driver src/driver.cpp)
install(TARGETS driver DESTINATION lib/${PROJECT_NAME})
""",
            "scripts/one.py": "#!/usr/bin/env python3\n",
        }
    )
    scripts = {e.name: e.script for e in installs.executables.values()}
    assert scripts == {
        "one.py": "robot/scripts/one.py",
        "two.py": "robot/scripts/two.py",
        "three": "robot/scripts/three.py",
        "driver": None,
    }
    assert not installs.open_executables


@pytest.mark.parametrize(
    ("properties", "names"),
    [
        ("set_target_properties(${PROJECT_NAME}_node PROPERTIES OUTPUT_NAME teleop PREFIX \"\")", {"teleop"}),
        ("set_target_properties(robot_node PROPERTIES CXX_STANDARD 17 OUTPUT_NAME teleop)", {"teleop"}),
        ("set_target_properties(robot_node other PROPERTIES OUTPUT_NAME a RUNTIME_OUTPUT_NAME b)", {"b"}),
        ("set_property(TARGET robot_node PROPERTY OUTPUT_NAME teleop)", {"teleop"}),
        ("set_property(TARGET robot_node APPEND PROPERTY LINK_FLAGS -s)", {"robot_node"}),
        ("set_property(TARGET robot_node PROPERTY SUFFIX .bin)", {"robot_node.bin"}),
        ("set_target_properties(robot_node PROPERTIES OUTPUT_NAME a)\nset_property(TARGET robot_node PROPERTY"
         " OUTPUT_NAME b)", {"b"}),
        ("if(WIN32)\nset_target_properties(robot_node PROPERTIES OUTPUT_NAME a)\nendif()", {"a", "robot_node"}),
        ("set_target_properties(robot_lib PROPERTIES OUTPUT_NAME teleop)", {"robot_node"}),
    ],
)  # fmt: skip
def test_a_target_may_have_a_file_of_another_name(installs_of, properties, names):
    build = f"project(robot)\nadd_executable(robot_node a.cpp)\n{properties}\n"
    installs = installs_of(**{"CMakeLists.txt": build + "install(TARGETS robot_node DESTINATION lib/robot)\n"})
    assert set(installs.executables) == names
    assert not installs.open_executables


def test_a_name_of_a_target_that_is_not_known(installs_of):
    build = "project(robot)\nadd_executable(node a.cpp)\nset_target_properties(node PROPERTIES OUTPUT_NAME ${NAME})\n"
    manifest = MANIFEST.replace("ament_python", "ament_cmake")
    assert installs_of(**{"package.xml": manifest, "CMakeLists.txt": build}).open_executables


def test_scripts_are_entry_points_of_their_file(installs_of):
    installs_of(
        **{
            "CMakeLists.txt": "project(robot)\ninstall(PROGRAMS scripts/one.py DESTINATION lib/robot)\n",
            "scripts/one.py": "",
        }
    )
    (entry,) = installs_of.entry_points
    assert (entry.executable, entry.function, entry.file.relative) == ("one.py", None, "robot/scripts/one.py")


@pytest.mark.parametrize(
    ("installed", "source"),
    [
        ("share/robot/launch/up.launch.py", "robot/launch/up.launch.py"),
        ("share/robot/config/deep/a.yaml", "robot/config/deep/a.yaml"),
        ("share/robot/maps/lab.yaml", "robot/worlds/lab.yaml"),
    ],
)
def test_where_an_installed_file_comes_from(installs_of, installed, source):
    installs = installs_of(
        **{
            "CMakeLists.txt": """\
project(robot)
install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME}/)
install(DIRECTORY worlds/ DESTINATION share/${PROJECT_NAME}/maps)
"""
        }
    )
    assert list(installs.source_of(installed)) == [source]


def test_data_files_with_a_pattern(installs_of):
    installs = installs_of(
        **{
            "setup.py": """\
import os
from glob import glob
from setuptools import setup
package_name = 'robot'
setup(data_files=[
    ('share/' + package_name, ['package.xml']),
    (os.path.join('share', package_name, 'launch'), glob(os.path.join('launch', '*.launch.py'))),
])
"""
        }
    )
    assert list(installs.source_of("share/robot/launch/up.launch.py")) == ["robot/launch/up.launch.py"]
    assert list(installs.source_of("share/robot/launch/up.yaml")) == []
    assert not installs.open_files


def test_data_files_that_a_function_collects_folder_by_folder(installs_of):
    installs = installs_of(
        **{
            "config/arm.yaml": "",
            "config/sim/sky/flat.world": "",
            "setup.py": """\
from glob import glob
from setuptools import setup
data_files = [('share/robot', ['package.xml'])]

def collect(folder):
    data_files.append(('share/robot/' + folder, glob(folder + '*.*')))
    for below in glob(folder + '*/'):
        collect(below)

collect('config')
setup(data_files=data_files)
""",
        }
    )
    assert list(installs.places_of("robot/config/arm.yaml")) == ["share/robot/config/arm.yaml"]
    assert list(installs.places_of("robot/config/sim/sky/flat.world")) == ["share/robot/config/sim/sky/flat.world"]
    assert not installs.open_files


def test_data_files_that_a_function_collects_without_an_end_in_sight_are_open(installs_of):
    installs = installs_of(
        **{
            "setup.py": """\
import os
from setuptools import setup
data_files = [('share/robot', ['package.xml'])]

def collect(folder, depth=0):
    data_files.append((f'share/robot/{folder}', ['package.xml']))
    if os.environ.get('DEPTH', 0) > depth:
        collect(f'{folder}/x', depth + 1)

collect('config')
setup(data_files=data_files)
"""
        }
    )
    assert installs.open_files


def scripts_of(installs: Installs) -> dict[str, str | None]:
    return {executable.name: executable.script for executable in installs.executables.values()}


def test_a_folder_and_a_pattern_of_programs(installs_of):
    installs = installs_of(
        **{
            "CMakeLists.txt": """\
project(robot)
install(DIRECTORY scripts/ USE_SOURCE_PERMISSIONS DESTINATION lib/${PROJECT_NAME})
file(GLOB NODES nodes/*.py)
install(PROGRAMS ${NODES} DESTINATION lib/${PROJECT_NAME})
""",
            "scripts/talk": "#!/usr/bin/env python3\n",
            "scripts/run.sh": "",
            "scripts/deeper/other.py": "",
            "nodes/listen.py": "",
            "launch/it.launch.py": "",
        }
    )
    assert scripts_of(installs) == {
        "talk": "robot/scripts/talk",
        "run.sh": "robot/scripts/run.sh",
        "listen.py": "robot/nodes/listen.py",
    }
    assert installs.too_deep == {"other.py": "lib/robot/deeper"}  # ros2 run finds it, launch does not
    assert not installs.open_executables and not installs.open_files


def test_a_link_is_the_file_that_it_leads_to(installs_of, tmp_path):
    (tmp_path / "robot" / "scripts").mkdir(parents=True)
    (tmp_path / "robot" / "scripts" / "talk").symlink_to("../src/talk.py")
    installs = installs_of(
        **{
            "CMakeLists.txt": "install(PROGRAMS scripts/talk DESTINATION lib/robot RENAME speak)",
            "src/talk.py": "",
        }
    )
    assert scripts_of(installs) == {"speak": "robot/src/talk.py"}
    assert [entry.file.relative for entry in installs_of.entry_points] == ["robot/src/talk.py"]


def test_a_link_out_of_the_workspace_is_not_followed(tmp_path):
    outside = tmp_path / "elsewhere.py"
    outside.write_text("")
    workspace = tmp_path / "workspace"
    (workspace / "robot").mkdir(parents=True)
    (workspace / "robot" / "package.xml").write_text(MANIFEST)
    (workspace / "robot" / "CMakeLists.txt").write_text("install(PROGRAMS talk DESTINATION lib/robot)")
    (workspace / "robot" / "talk").symlink_to(outside)
    files = [*find(["."], working_directory=str(workspace)).files, *find([str(outside)]).files]
    assert SourceTree(tmp_path).same_file("workspace/robot/talk", files) is not None
    assert SourceTree(workspace).same_file("robot/talk", files) is None


@pytest.mark.parametrize(
    ("written", "found"),
    [
        ("'talk == robot.talk:main'", {"talk": "it has '==' instead of '='"}),
        ("'talk = robot.talk:main,'", {"talk": "it ends in ','"}),
        ("'talk = robot/talk:main'", {"talk": "it is not 'name = package.module:function'"}),
        ("'talk = robot.talk:main' 'hear = robot.hear:main'", {"talk": "a comma is missing …", "hear": ""}),
        ("'talk = robot.talk:main'\n  'hear = robot.hear:main',", {"talk": "a comma is missing …", "hear": ""}),
        ("'talk = robot.'\n  'talk:main'", {"talk": ""}),  # one entry, written in two parts
        ("'talk = robot.talk:main [extra]'", {"talk": ""}),
        ("'talk to me = robot.talk:main'", {"talk to me": ""}),
    ],
)
def test_entries_that_are_not_of_the_form(installs_of, written, found):
    text = f"from setuptools import setup\nsetup(entry_points={{'console_scripts': [\n  {written}\n]}})\n"
    installs = installs_of(**{"setup.py": text})
    wrong = {name: re.sub("missing between.*", "missing …", one.wrong) for name, one in installs.executables.items()}
    assert wrong == found
    assert not installs.open_executables
    assert installs.executables[next(iter(found))].place.line == 3


def test_entries_of_tables_that_are_not_of_the_form(installs_of):
    installs = installs_of(
        **{
            "setup.cfg": """\
[options.entry_points]
console_scripts =
    talk == robot.talk:main
    hear = robot.hear:main  # listens
    look
""",
            "pyproject.toml": '[project.scripts]\nwalk = "robot/walk:main"\n',
        }
    )
    assert {name: (one.place.line, bool(one.wrong)) for name, one in installs.executables.items()} == {
        "talk": (3, True),
        "hear": (4, False),
        "look": (5, True),
        "walk": (2, True),
    }


@pytest.mark.parametrize(
    ("kind", "executables"),
    [("ament_python", {"talker"}), ("ament_cmake", {"one.py"})],
)
def test_a_package_is_built_by_setup_py_or_by_cmake(installs_of, kind: str, executables: set[str]):
    scripts = "entry_points={'console_scripts': ['talker = robot.talker:main']}"
    installs = installs_of(
        **{
            "package.xml": MANIFEST.replace("ament_python", kind),
            "setup.py": f"from setuptools import setup\nsetup(name='robot', {scripts})\n",
            "CMakeLists.txt": "project(robot)\ninstall(PROGRAMS scripts/one.py DESTINATION lib/robot)\n",
            "scripts/one.py": "",
        }
    )
    assert {name for name in installs.executables if name in executables} == executables
    assert ("one.py" in installs.executables) == (kind == "ament_cmake")


def test_scripts_of_any_language_that_data_files_install_where_launch_looks(installs_of):
    setup = """\
import os
from glob import glob
from setuptools import setup
name = 'robot'
setup(name=name, data_files=[
    (os.path.join('lib', name), glob('scripts/*.bash')),
    (os.path.join('share', name), glob('scripts/*.txt')),
])
"""
    installs = installs_of(**{"setup.py": setup, "scripts/lights.bash": "#!/bin/bash\n", "scripts/notes.txt": "on"})
    assert [(name, found.script) for name, found in installs.executables.items()] == [
        ("lights.bash", "robot/scripts/lights.bash")
    ]
