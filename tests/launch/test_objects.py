"""Launch's objects, and what they answer for."""

from __future__ import annotations

import pytest

from archlint.interpreter.heap import Store
from archlint.interpreter.interpreter import Interpreter
from archlint.interpreter.modules import ModuleIndex
from archlint.interpreter.values import NONE, External, Instance, Known, ListValue, Unknown, Value
from archlint.launch.objects import MADE_BY_BASE, argument, class_name, kind_of, known_text, launch_object, made_by_base
from archlint.launch.tables import LaunchClass

NODE = launch_object(1, LaunchClass.NODE, None, {"name": Known("a"), "package": NONE})


def test_an_argument_that_is_none_was_not_given():
    assert NODE.argument("name") == Known("a")
    assert NODE.argument("package") is None
    assert NODE.given("package") == NODE.given("executable") == NONE
    assert argument(NODE, "name") == Known("a")
    assert argument(Unknown("why"), "name") is argument(None, "name") is None


@pytest.mark.parametrize(
    ("value", "kind", "name"),
    [
        (NODE, LaunchClass.NODE, "Node"),
        (Instance(External("launch.Node"), 2), LaunchClass.NODE, "Node"),
        (Instance(External("launch.actions.Later"), 2), None, "actions.Later"),  # launch's, and in no table
        (Instance(External("other.Node"), 2), None, ""),
        (Known("Node"), None, ""),
        (None, None, ""),
    ],
)
def test_the_class_of_launch_that_an_object_is_of(value: Value | None, kind: LaunchClass | None, name: str):
    assert (kind_of(value), class_name(value)) == (kind, name)


def test_what_stands_for_a_text():
    assert launch_object(1, LaunchClass.LAUNCH_CONFIGURATION, None, {}).is_substitution
    assert not NODE.is_substitution


@pytest.mark.parametrize(("value", "text"), [(Known("a"), "a"), (Known(5), "5"), (Unknown("why"), None), (None, None)])
def test_the_text_of_a_constant(value: Value | None, text: str | None):
    assert known_text(value) == text


def test_an_object_whose_class_derives_from_one_of_launchs():
    machine = Interpreter(ModuleIndex([], lambda file: None), Store())
    own = Instance(External("robot.Talker"), machine.store.new_key())
    assert made_by_base(machine, own) is None
    machine.store.set(own.key, MADE_BY_BASE, NODE)
    assert made_by_base(machine, own) is NODE
    assert made_by_base(machine, ListValue(own.key)) is None


def test_the_name_of_a_declared_argument(launches):
    """As in launch files that hand all of their arguments to a node."""
    before = """
declared = [DeclareLaunchArgument('camera', default_value='left'), DeclareLaunchArgument('rate', default_value='5')]
parameters = [{argument.name: LaunchConfiguration(argument.name)} for argument in declared]
"""
    launched = launches.python("[*declared, Node(package='robot', executable='talker', parameters=parameters)]", before)
    assert [(row.name, row.value) for row in launched.started[0].parameters] == [("camera", "left"), ("rate", 5)]


def test_an_executable_that_something_unknown_may_replace_is_not_known(launches):
    before = """
import yaml
with open('/etc/robot.yaml') as stream:
    settings = yaml.safe_load(stream)
copied = {key: value for key, value in settings.items()}
executable = copied.get('talker', {}).get('executable', 'talker')
"""
    launched = launches.python("[Node(package='robot', executable=executable)]", before)
    assert [started.executable.text for started in launched.started] == [None]
    # What the environment may replace is named in the code: it is shown as the default that it is.
    before = "executable = os.environ.get('TALKER', 'talker')"
    launched = launches.python("[Node(package='robot', executable=executable)]", before)
    assert [started.executable.text for started in launched.started] == ["talker"]


def test_the_substitutions_of_nav2_where_its_sources_are_in_the_workspace(launches):
    launches.package("nav2_common")
    launches.file("nav2_common/nav2_common/__init__.py", "")
    launches.file("nav2_common/nav2_common/launch/__init__.py", "from .rewritten_yaml import RewrittenYaml\n")
    launches.file(
        "nav2_common/nav2_common/launch/rewritten_yaml.py",
        "import launch\nclass RewrittenYaml(launch.Substitution):\n"
        "    def __init__(self, source_file, param_rewrites, root_key=None):\n        self.__source = source_file\n"
        "    def perform(self, context):\n        return write_it(self.__source)\n",
    )
    launches.file("robot/config/talker.yaml", "talker:\n  ros__parameters: {rate: 5.0}\n")
    before = """
from nav2_common.launch import RewrittenYaml
file = os.path.join(get_package_share_directory('robot'), 'config', 'talker.yaml')
file = RewrittenYaml(source_file=file, param_rewrites={'rate': '7.0'})
"""
    launched = launches.python("[Node(package='robot', executable='talker', parameters=[file])]", before)
    (use,) = launched.started[0].parameters
    assert use.reference.source == "robot/config/talker.yaml"
    assert len(use.changes) == 1
