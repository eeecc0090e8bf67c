"""Files of the workspace that a launch file reads."""

from __future__ import annotations

import pytest

from launching import names


def test_a_json_file_of_the_workspace_is_read(launches):
    launches.file("robot/config/team.json", '{"robots": [{"name": "left"}, {"name": "right"}]}')
    before = """
import json
from pathlib import Path
with Path(get_package_share_directory('robot'), 'config/team.json').open(encoding='utf-8') as stream:
    team = json.load(stream)
nodes = [Node(package='robot', executable='talker', name=robot['name']) for robot in team['robots']]
"""
    assert names(launches.python("nodes", before)) == ["left", "right"]
    launches.file("robot/config/team.json", '{"robots": [')
    assert launches.python("nodes", before).gaps != []


def test_the_suffix_of_a_path(launches):
    launches.file("robot/launch/it.launch.yaml", "name: left\n")
    before = """
import yaml
from pathlib import Path
with open(Path(__file__).with_suffix('.yaml')) as stream:
    name = yaml.safe_load(stream)['name']
"""
    assert names(launches.python("[Node(package='robot', executable='talker', name=name)]", before)) == ["left"]


def test_a_path_that_may_be_absolute(launches):
    launches.file("robot/config/team.json", '{"name": "left"}')
    before = """
import json
from pathlib import Path
def open_beside(name):
    path = Path(name)
    if not path.is_absolute():
        path = Path(get_package_share_directory('robot')) / 'config' / path
    return path.open()
"""
    for path in ("'team.json'", "Path(get_package_share_directory('robot'), 'config', 'team.json')"):
        node = f"Node(package='robot', executable='talker', name=json.load(open_beside({path}))['name'])"
        assert names(launches.python(f"[{node}]", before)) == ["left"]


def test_a_path_that_is_joined_unless_it_is_absolute(launches):
    launches.file("robot/config/team.json", '{"name": "left"}')
    before = """
import json
def beside(name):
    return name if os.path.isabs(name) else os.path.join(get_package_share_directory('robot'), 'config', name)
with open(beside({path})) as stream:
    name = json.load(stream)['name']
"""
    whole = "os.path.join(get_package_share_directory('robot'), 'config', 'team.json')"
    for path, expected in (("'team.json'", ["left"]), (whole, ["left"]), ("'/etc/team.json'", ["?"])):
        node = "Node(package='robot', executable='talker', name=name)"
        assert names(launches.python(f"[{node}]", before.format(path=path))) == expected


TALKER = "Node(package='robot', executable='talker', name=name)"


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("os.path.join(get_package_share_directory('robot'), 'config', 'team.json')", ["there"]),
        ("os.path.join(get_package_share_directory('robot'), 'config', 'none.json')", ["?"]),
        ("os.path.join(get_package_share_directory('elsewhere'), 'config', 'team.json')", ["?"]),
        ("'/etc/team.json'", ["?"]),
    ],
)
def test_whether_a_file_is_there(launches, path: str, expected: list[str]):
    launches.file("robot/config/team.json", "{}")
    launches.file(
        "robot/setup.py",
        "from setuptools import setup\n"
        "setup(name='robot', data_files=[('share/robot/config', ['config/team.json'])])\n",
    )
    before = f"name = 'there' if os.path.exists({path}) else 'gone'"
    assert names(launches.python(f"[{TALKER}]", before)) == expected
    method = f"from pathlib import Path\nname = 'there' if Path({path}).is_file() else 'gone'"
    assert names(launches.python(f"[{TALKER}]", method)) == expected


def test_a_file_that_is_read_in_a_try_is_expected_to_be_there(launches):
    launches.file("robot/config/team.yaml", "name: left\n")
    before = """
import yaml
name = 'nobody'
try:
    with open(os.path.join(get_package_share_directory({package!r}), 'config', 'team.yaml')) as stream:
        name = yaml.safe_load(stream)['name']
except OSError:
    name = 'lost'
"""
    assert names(launches.python(f"[{TALKER}]", before.format(package="robot"))) == ["left"]
    assert names(launches.python(f"[{TALKER}]", before.format(package="elsewhere"))) != ["left"]


def test_a_try_that_raises_or_imports_may_come_to_its_handler(launches):
    for statement in ("import left_hand", "if name == os.environ['NAME']:\n        raise ValueError"):
        before = f"name = 'left'\ntry:\n    {statement}\nexcept Exception:\n    name = 'right'\n"
        assert names(launches.python(f"[{TALKER}]", before)) == ["?"]


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        ("yaml.dump([[1.0, 2.0], [3.5]])", "- - 1.0\n  - 2.0\n- - 3.5\n"),
        ("yaml.safe_dump({'a': [True, None]}, default_flow_style=True)", "{a: [true, null]}\n"),
        ("json.dumps({'a': {'b': 1}}, sort_keys=True)", '{"a": {"b": 1}}'),
        ("yaml.dump([os.environ['NAME']])", "?"),
        ("yaml.dump([1], sys.stdout)", "-"),
        ("json.dumps([1], default=str)", "?"),
    ],
)
def test_data_as_a_text(launches, expression: str, text: str):
    before = f"import json, sys, yaml\nname = {expression}"
    assert names(launches.python(f"[{TALKER}]", before)) == [text]


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        ("str(round(math.pi, 2))", "3.14"),
        ("str(math.floor(math.radians(180.0)))", "3"),
        ("str(math.sqrt(-1.0))", "?"),
        ("str(math.sin(float(os.environ['ANGLE'])))", "?"),
    ],
)
def test_mathematics(launches, expression: str, text: str):
    assert names(launches.python(f"[{TALKER}]", f"import math\nname = {expression}")) == [text]


@pytest.mark.parametrize(
    ("paths", "expected"),
    [
        ("[path.stem for path in Path(config).glob('*.yaml')]", ["a", "b"]),
        ("[path.name for path in Path(config).iterdir() if path.suffix == '.txt']", ["c.txt"]),
        ("[os.path.basename(path) for path in glob.glob(os.path.join(config, '?.txt'))]", ["c.txt"]),
        ("[name for name in os.listdir(config) if name.endswith('.yaml')]", ["a.yaml", "b.yaml"]),
        ("os.listdir(get_package_share_directory('robot'))", ["config", "launch"]),
    ],
)
def test_the_files_of_an_installed_folder(launches, paths: str, expected: list[str]):
    for name in ("b.yaml", "a.yaml", "c.txt", "sub/d.yaml"):
        launches.file(f"robot/config/{name}", "")
    before = "import glob\nfrom pathlib import Path\n"
    before += "config = os.path.join(get_package_share_directory('robot'), 'config')"
    nodes = f"[Node(package='robot', executable='talker', name=name) for name in {paths}]"
    assert names(launches.python(nodes, before)) == expected


@pytest.mark.parametrize("folder", ["get_package_share_directory('elsewhere')", "'/etc'", "os.path.expanduser('~')"])
def test_the_files_of_a_folder_that_is_not_here(launches, folder: str):
    nodes = f"[Node(package='robot', executable='talker', name=name) for name in os.listdir({folder})]"
    assert names(launches.python(nodes)) == ["?"]


def test_json_in_the_text_of_a_file(launches):
    launches.file("robot/config/team.json", '{"name": "left"}')
    before = (
        "import json\nwith open(get_package_share_directory('robot') + '/config/team.json') as file:\n"
        "    team = json.loads(file.read().strip())\n"
    )
    launched = launches.python("[Node(package='robot', executable='talker', name=team['name'])]", before)
    assert names(launched) == ["left"]
