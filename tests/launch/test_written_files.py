"""Parameter files that code of a launch file writes before it starts a node."""

from __future__ import annotations

import pytest

from archlint.systems.overrides import applied
from launching import Launches

IMPORTS = "import json, os, sys, tempfile, yaml\nfrom pathlib import Path\n"
PARAMETERS = """\
/talker:
  ros__parameters:
    rate: 1
    frame: map
"""
READ = "data = yaml.safe_load(open(get_package_share_directory('robot') + '/config/nav.yaml'))\n"


def given(launches: Launches, before: str, file: str) -> dict[str, object]:
    """What the one node gets of a file."""
    launches.file("robot/config/nav.yaml", PARAMETERS)
    launched = launches.python(
        f"[Node(package='robot', executable='talker', name='talker', namespace='/', parameters=[{file}])]",
        IMPORTS + before,
    )
    [started] = launched.started
    found = {one.name: one.value for one in applied(started, "/talker", launches.of_workspace().files.parameters)}
    return found if started.parameters[0].followed else {**found, "why": started.parameters[0].reference.reason}


@pytest.mark.parametrize(
    ("write", "file"),
    [
        (
            "with tempfile.NamedTemporaryFile('w', delete=False) as file:\n    yaml.safe_dump(data, file)\n",
            "file.name",
        ),
        ("file = tempfile.NamedTemporaryFile(mode='w', delete=False)\njson.dump(data, fp=file)\n", "Path(file.name)"),
        (
            "number, path = tempfile.mkstemp(suffix='.yaml')\n"
            "with os.fdopen(number, 'w') as file:\n    yaml.dump(data, stream=file)\n",
            "path",
        ),
        ("with open('/tmp/nav.yaml', 'w') as file:\n    file.write(yaml.dump(data))\n", "'/tmp/nav.yaml'"),
        (
            "path = os.path.join(tempfile.gettempdir(), 'nav.yaml')\n"
            "with open(path, 'w') as file:\n    yaml.dump(data, file)\n",
            "path",
        ),
    ],
)
def test_a_parameter_file_that_the_launch_writes(launches, write: str, file: str):
    change = "data['/talker']['ros__parameters']['rate'] = 5\n"
    assert given(launches, READ + change + write, file) == {"rate": 5, "frame": "map"}


def test_a_file_whose_content_is_not_known(launches):
    write = "with open('/tmp/nav.yaml', 'w') as file:\n    file.write(os.environ['NAV'])\n"
    assert given(launches, write, "'/tmp/nav.yaml'") == {"why": "the environment variable NAV"}


def test_a_file_that_may_be_written_in_two_ways(launches):
    write = "file = open('/tmp/nav.yaml', 'w')\nif sys.argv[1]:\n    file.write('a: 1')\n"
    assert "why" in given(launches, write, "'/tmp/nav.yaml'")


@pytest.mark.parametrize("text", ["open(path).read()", "Path(path).read_text(encoding='utf-8')"])
def test_yaml_in_the_text_of_a_file(launches, text: str):
    before = f"path = get_package_share_directory('robot') + '/config/nav.yaml'\ndata = yaml.safe_load({text})\n"
    launches.file("robot/config/nav.yaml", PARAMETERS)
    launched = launches.python(
        "[Node(package='robot', executable='talker', name=data['/talker']['ros__parameters']['frame'])]",
        IMPORTS + before,
    )
    assert [started.name.text for started in launched.started] == ["map"]


COPIED = (
    "with open(get_package_share_directory('robot') + '/config/nav.yaml', 'r', encoding='utf-8') as source:\n"
    "    text = source.read()\n"
    "target = tempfile.NamedTemporaryFile(delete=False, mode='w', suffix='.yaml')\n"
)


def test_words_that_are_replaced_in_the_text_of_a_file(launches):
    write = "target.write(text.replace('map', 'odom').replace('rate', 'frequency'))\ntarget.close()\n"
    assert given(launches, COPIED + write, "target.name") == {"frequency": 1, "frame": "odom"}


def test_a_word_that_is_not_known_makes_the_whole_text_unknown(launches):
    write = "target.write(text.replace('map', os.environ['FRAME']))\n"
    assert given(launches, COPIED + write, "target.name") == {"why": "the environment variable FRAME"}


def test_the_text_of_a_file_that_is_not_here(launches):
    write = "target.write(open('/opt/nav.yaml').read().replace('map', 'odom'))\n"
    assert given(launches, COPIED + write, "target.name") == {
        "why": "the content of a file that is not in this workspace"
    }
