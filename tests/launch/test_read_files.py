"""Files of the workspace that a launch file reads."""

from __future__ import annotations

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
