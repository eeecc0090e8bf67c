"""Parameters that launch files and parameter files set: PRM002 to PRM008."""

from __future__ import annotations

import pytest

from archlint.finding import Finding, Severity
from robot_package import CMAKE, SETUP, TALKER, node


def test_values_of_the_right_type(findings):
    assert findings("PRM002", node('<param name="rate" value="2.0"/>')) == []
    assert findings("PRM002", '<arg name="r"/>' + node('<param name="rate" value="$(var r)"/>')) == []


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("{'axis': 'y'}", ["set to True, of type bool: launch passes 'y' on without quotes"]),
        ("{'axis': '1e5'}", ["set to 100000.0, of type double: launch passes '1e5' on without quotes"]),
        ("{'axis': 'x'}", []),
        ("{'axis': 'yes'}", []),  # launch puts quotes around this
    ],
)
def test_a_text_that_launch_passes_on_without_quotes(findings, given: str, told: list[str]):
    launch_file = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        f"    return LaunchDescription([Node(package='robot', executable='talker', parameters=[{given}])])\n"
    )
    talker = TALKER.replace("('rate', 1.0)", "('axis', 'x')")
    other = {"robot/talker.py": talker, "launch/axis.launch.py": launch_file}
    reported = findings("PRM002", "", **other)
    assert [one.message.partition("declared as string and ")[2] for one in reported] == told
    assert [one.help for one in reported] == ["set it in a parameter file, where quotes keep it a string"] * len(told)


def test_values_of_a_launch_file_that_are_wrong_in_the_same_way_are_one_finding(findings):
    rate = '<param name="rate" value="{}"/>'
    [told] = findings("PRM002", node(rate.format(2), name="left") + node(rate.format(3), name="right"))
    assert told.message.startswith("parameter 'rate' of /left is declared as double and set to 2, of type integer; ")
    assert told.message.endswith("another value is of type integer instead of double, too")
    assert [row.message for row in told.related if "/right" in row.message] == [
        "parameter 'rate' of /right is declared as double and set to 3, of type integer"
    ]


def test_what_several_nodes_of_one_class_are_given_is_one_finding(findings):
    speed, frame = '<param name="speed" value="1.0"/>', '<param name="frame" value="map"/>'
    (same,) = findings("PRM004", node(speed, name="left") + node(speed, name="right"))
    assert same.message == "/left declares no parameter 'speed', so this value has no effect"
    assert [row.message for row in same.related] == ["it is set here, too", "the node is defined here"]
    (other,) = findings("PRM004", node(speed, name="left") + node(frame, name="right"))
    assert other.message == (
        "/left and another node of its class declare none of these 2 parameters, so their values have no effect: "
        "speed, frame"
    )


@pytest.mark.parametrize(
    ("readme", "declared", "given", "told"),
    [
        ("For ROS 2 Foxy.", "1.0", "2", 0),
        ("For ROS 2 Foxy and Humble.", "1.0", "2", 1),
        ("", "1.0", "2", 1),
        ("For ROS 2 Foxy.", "True", "'False'", 1),  # a text that is not empty is true
        ("For ROS 2 Foxy.", "True", "'True'", 0),
    ],
)
def test_foxy_takes_a_value_of_any_type(findings, readme: str, declared: str, given: str, told: int):
    files = {"robot/talker.py": TALKER.replace("1.0)", f"{declared})"), "README.md": readme}
    launch = node(f'<param name="rate" value="{given}"/>')
    assert len(findings("PRM002", launch, **files)) == told


def test_an_empty_list_is_a_byte_array_to_rclpy(findings):
    def told(declared: str, given: str) -> list[Finding]:
        talker = TALKER.replace("('rate', 1.0)", f"('names', {declared})")
        launch_file = (
            "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
            "def generate_launch_description():\n"
            f"    given = [{{'names': {given}}}]\n"
            "    return LaunchDescription([Node(package='robot', executable='talker', parameters=given)])\n"
        )
        return findings("PRM002", "", **{"robot/talker.py": talker, "launch/names.launch.py": launch_file})

    (reported,) = told("[]", "['left', 'right']")
    assert reported.message == (
        "parameter 'names' of /talker is declared with an empty list, which rclpy takes for a byte_array, and set to "
        "['left', 'right'], of type string_array"
    )
    assert reported.help == "declare it with rclpy.Parameter.Type.STRING_ARRAY instead of a value"

    (reported,) = told("'left'", "['left', 'right']")
    assert reported.help == "write one text, without brackets: rclpy takes no list for it"
    (reported,) = told("'left'", "5")
    assert reported.help == "put it in quotes, or in a launch file wrap it: ParameterValue(…, value_type=str)"

    assert told("['']", "['left', 'right']") == []
    assert told("rclpy.Parameter.Type.STRING_ARRAY", "['left', 'right']") == []
    assert told("[], ParameterDescriptor(dynamic_typing=True)", "['left', 'right']") == []
    assert told("[] if rclpy.ok() else ['left']", "['left', 'right']") == []


def test_dynamic_typing_takes_anything(findings):
    text = TALKER.replace("1.0)", "1.0, ParameterDescriptor(dynamic_typing=True))")
    assert findings("PRM002", node('<param name="rate" value="2"/>'), **{"robot/talker.py": text}) == []


@pytest.mark.parametrize(
    ("info", "told"),
    [
        ("{}", ["only_b"]),
        ("{'exe': 'talker'}", ["only_b"]),
        ("json.load(open(sys.argv[1]))", []),
        ("dict(json.load(open(sys.argv[1])))", []),
        ("{k: v for k, v in json.load(open(sys.argv[1])).items()}", []),
        ("{**json.load(open(sys.argv[1]))}", []),
    ],
)
def test_a_program_that_a_file_of_the_user_may_choose(findings, info: str, told: list[str]):
    launch_file = (
        "import json\nimport sys\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        f"def generate_launch_description():\n    info = {info}\n    exe = info.pop('exe', 'talker')\n"
        "    info['only_b'] = 1\n"
        "    return LaunchDescription([Node(package='robot', executable=exe, parameters=[info])])\n"
    )
    assert [one.identity[1] for one in findings("PRM004", "", **{"launch/chosen.launch.py": launch_file})] == told


NAMED_AFTER_IT = "self.declare_parameter(f'radios.{kind}.ip', '')"


@pytest.mark.parametrize(
    ("yaml", "told"),
    [
        ("talker: {ros__parameters: {radio: b, radios: {a: {ip: x}, b: {ip: y}}}}", []),  # each choice has its section
        ("talker: {ros__parameters: {radios: {a: {ip: x}, b: {ip: y}}}}", []),
        ("talker: {ros__parameters: {radios: {a: {port: x}}}}", ["radios.a.port"]),
        ("talker: {ros__parameters: {radoi: b}}", ["radoi"]),
    ],
)
def test_values_for_what_another_choice_would_declare(findings, yaml: str, told: list[str]):
    chosen = "kind = self.declare_parameter('radio', 'a').value"
    text = TALKER.replace("self.declare_parameter('rate', 1.0)", f"{chosen}\n        {NAMED_AFTER_IT}")
    files = {"config/p.yaml": yaml, "robot/talker.py": text}
    found = findings("PRM004", node('<param from="$(find-pkg-share robot)/config/p.yaml"/>'), **files)
    assert [one.identity[1] for one in found] == told


def test_a_shared_section_is_for_whichever_node_declares_the_name(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "/**: {ros__parameters: {rat: 1.0}}"
    assert findings("PRM004", node(load_it), **{"config/p.yaml": yaml})[0].place.file == "config/p.yaml"
    external = node(pkg="nav2_amcl", exec="amcl", name="amcl")
    assert findings("PRM004", node(load_it) + external, **{"config/p.yaml": yaml}) == []


def test_a_shared_section_may_be_for_the_nodes_of_another_launch_file(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "/**: {ros__parameters: {mass: 1.0}}"
    amcl = f"<launch>{node(load_it, pkg='nav2_amcl', exec='amcl', name='amcl')}</launch>"
    alone = "<launch></launch>"

    both = {"config/p.yaml": yaml, "launch/other.launch.xml": amcl}
    assert findings("PRM004", node(load_it), **both) == []
    assert len(findings("PRM004", node(load_it), **both | {"launch/other.launch.xml": alone})) == 1


def test_a_section_may_be_for_another_node_of_that_name(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {mass: 1.0}}"
    files = {"config/p.yaml": yaml, "robot/heavy.py": TALKER.replace("'rate'", "'mass'")}
    files["setup.py"] = SETUP.replace("robot.talker:main'", "robot.talker:main', 'heavy = robot.heavy:main'")
    heavy = f"<launch>{node(load_it, exec='heavy')}</launch>"

    assert len(findings("PRM004", node(load_it), **files)) == 1
    either = TALKER.replace("Talker())", "Talker() if len(found()) else Talker())")
    assert len(findings("PRM004", node(load_it), **files | {"robot/talker.py": either})) == 1
    files["robot/talker.py"] = TALKER
    assert findings("PRM004", node(load_it), **files, **{"launch/other.launch.xml": heavy}) == []


def test_a_node_that_allows_undeclared_parameters_takes_anything(findings):
    text = TALKER.replace("('talker')", "('talker', allow_undeclared_parameters=True)")
    assert findings("PRM004", node('<param name="rat" value="1.0"/>'), **{"robot/talker.py": text}) == []


def test_a_section_without_its_namespace(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {rate: 1.0}}"
    (found,) = findings("PRM005", node(load_it, namespace="left"), **{"config/p.yaml": yaml})
    assert found.message.endswith("did you mean '/left/talker'?")
    assert findings("PRM005", node(load_it), **{"config/p.yaml": yaml}) == []


def test_a_section_for_a_node_in_another_namespace_than_that_of_its_twin(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    right = "right:\n  talker: {ros__parameters: {rate: 1.0}}\n"
    left = "left:\n  talker: {ros__parameters: {rate: 1.0}}\n"
    assert findings("PRM005", node(load_it, namespace="left"), **{"config/p.yaml": left + right}) == []
    assert len(findings("PRM005", node(load_it, namespace="left"), **{"config/p.yaml": right})) == 1


@pytest.mark.parametrize(
    ("source", "told"),
    [
        ('#include <rclcpp/rclcpp.hpp>\nOther() : rclcpp::Node("other_base") {}', 0),
        ('#include <rclcpp/rclcpp.hpp>\nOther() : rclcpp::Node("other") {}', 1),
        ('std::string name = "other_base";', 1),  # no program of ROS
    ],
)
def test_a_section_for_another_program_of_the_package(findings, source: str, told: int):
    """One file for two programs, of which the launch file starts one."""
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {rate: 1.0}}\nother_base: {ros__parameters: {speed: 1.0}}"
    assert len(findings("PRM005", node(load_it), **{"config/p.yaml": yaml, "src/other.cpp": source})) == told


CPP = """
#include <rclcpp/rclcpp.hpp>
#include "lidar.hpp"

Lidar::Lidar() : rclcpp::Node("lidar"), range_(20) {{
  {declaration};
}}

int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Lidar>());
}}
"""
LIDAR_HPP = """
class Lidar : public rclcpp::Node {
public:
  Lidar();
private:
  double range_;
};
"""
LIDAR_CMAKE = """
project(robot)
add_executable(lidar src/lidar.cpp)
install(TARGETS lidar DESTINATION lib/${PROJECT_NAME})
"""


@pytest.mark.parametrize(
    ("declaration", "told"),
    [
        ('declare_parameter("range", range_)', 0),  # a double that is given a whole number
        ('declare_parameter("range", 20)', 1),
        ('declare_parameter<int>("range", range_)', 1),
        ('declare_parameter<double>("range", 20)', 0),
        ('declare_parameter<std::vector<double>>("range", {20, 30})', 1),  # an array all the same
    ],
)
def test_a_type_that_cpp_takes_from_a_variable(findings, declaration: str, told: int):
    start = '<node pkg="robot" exec="lidar"><param name="range" value="-1.0"/></node>'
    files = {"src/lidar.cpp": CPP.format(declaration=declaration), "src/lidar.hpp": LIDAR_HPP}
    files |= {"CMakeLists.txt": LIDAR_CMAKE, "package.xml": CMAKE, "setup.py": ""}
    assert len(findings("PRM002", start, **files)) == told


def test_a_section_for_a_node_inside_a_process_that_is_not_here(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "local_costmap:\n  local_costmap: {ros__parameters: {rate: 1.0}}"
    server = f'<node pkg="nav2_controller" exec="controller_server" name="controller_server">{load_it}</node>'
    assert findings("PRM005", node(load_it) + server, **{"config/p.yaml": yaml}) == []
    misspelt = {"config/p.yaml": "controller_sever: {ros__parameters: {rate: 1.0}}"}
    assert len(findings("PRM005", node(load_it) + server, **misspelt)) == 1
    assert len(findings("PRM005", node(load_it), **{"config/p.yaml": yaml})) == 1


REWRITTEN = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from nav2_common.launch import RewrittenYaml
FILE = [FindPackageShare('robot'), '/config/p.yaml']

def generate_launch_description():
    return LaunchDescription([
        Node(package='robot', executable='talker', namespace='left', parameters=[
            RewrittenYaml(FILE, {%s}, %s)
        ])
    ])
"""


def test_a_file_that_the_launch_rewrites_is_judged_as_it_is_then(findings):
    def told(code: str, yaml: str, rewrites: str = "", more: str = "root_key='left'") -> list[Finding]:
        files = {"config/p.yaml": yaml, "launch/more.launch.py": REWRITTEN % (rewrites, more)}
        return findings(code, **files)

    yaml = "talker:\n  ros__parameters:\n    rate: 1.0\n"
    assert told("PRM005", yaml) == []  # '/talker' in the file, '/left/talker' in the one that the launch makes
    assert told("PRM002", yaml) == []
    assert told("PRM002", yaml, "'rate': '2.5'", "root_key='left', convert_types=True") == []
    (found,) = told("PRM002", yaml, "'rate': '2.5'")  # without convert_types a text stays one
    assert (found.place.file, found.place.line) == ("launch/more.launch.py", 10)
    (found,) = told("PRM004", yaml.replace("rate", "rat"))
    assert (found.place.file, found.place.line) == ("config/p.yaml", 3)
    assert told("PRM004", yaml.replace("rate", "rat"), more="root_key='right'") == []
    (found,) = told("PRM004", yaml, "'talker.ros__parameters.rat': '1'")
    assert found.place.file == "launch/more.launch.py"
    assert told("PRM004", yaml, "'/**.ros__parameters.rat': '1'") == []


@pytest.mark.parametrize(
    ("around", "given", "told"),
    [
        ("", "", 1),
        ("", '<arg name="camera" value="front"/>', 1),
        ("", '<arg name="params" value="$(find-pkg-share robot)/config/p.yaml"/>', 0),
        ("", '<arg name="folder" value="$(find-pkg-share robot)/config"/>', 0),
        ("", '<arg name="params" value="$(env PARAMS)"/>', 0),
        ('<arg name="params" default="$(find-pkg-share robot)/config/p.yaml"/>', "", 0),
    ],
)
def test_an_include_that_is_not_here_and_a_file_that_it_is_or_is_not_given(findings, around, given, told):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    files = {"config/p.yaml": "tlaker: {ros__parameters: {rate: 1.0}}"}
    include = f'<include file="$(find-pkg-share zed_wrapper)/launch/zed.launch.py">{given}</include>'
    assert len(findings("PRM005", around + node(load_it) + include, **files)) == told


def test_an_include_of_a_file_that_is_not_known_may_load_anything(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    files = {"config/p.yaml": "tlaker: {ros__parameters: {rate: 1.0}}"}
    assert findings("PRM005", node(load_it) + '<include file="$(env MORE)"/>', **files) == []


def test_a_section_for_a_node_that_other_arguments_start(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {rate: 1.0}}\nother: {ros__parameters: {rate: 1.0}}"
    other = '<arg name="more" default="false"/>' + node(load_it, name="other", **{"if": "$(var more)"})
    assert findings("PRM005", node(load_it) + other, **{"config/p.yaml": yaml}) == []


@pytest.mark.parametrize(
    "second",
    [
        "if not self.has_parameter('rate'):\n            self.declare_parameter('rate', 2.0)",
        "try:\n            self.declare_parameter('rate', 2.0)\n        except Exception:\n            pass",
        "self.undeclare_parameter('rate')\n        self.declare_parameter('rate', 2.0)",
    ],
)
def test_declarations_that_ask_first(findings, second):
    text = TALKER.replace("        self.create_publisher", f"        {second}\n        self.create_publisher")
    assert findings("PRM008", **{"robot/talker.py": text}) == []


def test_reads_that_may_find_nothing(findings):
    text = TALKER.replace(
        "        self.create_publisher",
        "        if self.has_parameter('other'):\n            self.get_parameter('other')\n"
        "        self.get_parameter_or('third')\n        self.get_parameter('use_sim_time')\n"
        "        self.create_publisher",
    )
    assert findings("PRM003", **{"robot/talker.py": text}) == []


def test_a_parameter_that_nobody_reads(findings):
    (found,) = findings("PRM006")
    assert found.message == "parameter 'rate' is declared but never read"


@pytest.mark.parametrize(
    "declaration",
    [
        "for name in ['rate', 'other']:\n            self.declare_parameter(name, 1.0)",
        "self.port = find_port()\n        self.declare_parameter('rate', self.port)",
    ],
)
def test_declarations_that_say_nothing_of_who_reads(findings, declaration):
    text = TALKER.replace("self.declare_parameter('rate', 1.0)", declaration)
    assert findings("PRM006", **{"robot/talker.py": text}) == []


@pytest.mark.parametrize(("first", "told"), [("from robot.talker import Talker", 0), ("import math", 1)])
def test_a_parameter_that_a_subclass_in_another_file_reads(findings, first, told):
    reader = f"{first}\n\ndef rate_of(node):\n    return node.get_parameter('rate').value\n"
    assert len(findings("PRM006", **{"robot/reader.py": reader})) == told


def test_one_entry_of_a_list_that_nobody_reads(findings):
    text = TALKER.replace(
        "self.declare_parameter('rate', 1.0)",
        "self.declare_parameters('', [\n            ('rate', 1.0),\n            ('name', 'a'),\n        ])\n"
        "        self.declare_parameters('arm', [('speed', 1.0), ('reach', 2.0)])\n"
        "        self.get_parameter('name'), self.get_parameter('arm.reach')",
    )
    found = findings("PRM006", **{"robot/talker.py": text})
    assert [(one.place.line, one.message) for one in found] == [
        (9, "parameter 'rate' is declared but never read"),
        (12, "parameter 'arm.speed' is declared but never read"),
    ]


HELPER = """
    def p(self, name):
        return self.get_parameter(name).value

    def again(self, name='rat'):
        return self.p(name)

def of(node, name):
    return node.get_parameter(name).get_parameter_value().double_value

NAME = 'constant'
"""


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (["self.p('rate')", "self.p('rat')", "self.p('speed')", "self.p(name='a')"], {2: "rat", 3: "speed a"}),
        (["self.rate, self.kind = of(self, 'rate'), of(self, 'kind')"], {1: "kind"}),
        (["self.p('on_start')", "self.create_timer(1.0, lambda: self.p('on_timer'))"], {1: "on_start on_timer"}),
        (["self.all = [self.p(n) for n in ('rate', 'one', 'two')]"], {1: "one two"}),
        (["if self.has_parameter('rat'):", "    self.p('rat')"], {}),
        (["try:", "    self.p('rat')", "except Exception:", "    pass"], {}),
        (["self.p(NAME)", "self.get_parameter(NAME)"], {1: "constant"}),  # one cause, told at the first read
        (["self.p(input())"], {}),
        (["self.get_parameters(['rate', 'rat'])", "self.get_parameters([", "    'speed'])"], {1: "rat", 3: "speed"}),
        (["self.get_parameters(['rate'])", "self.get_parameters(input())", "self.get_parameters([NAME])"], {}),
        (["try:", "    self.get_parameters(['rat'])", "except Exception:", "    pass"], {}),
    ],
)
def test_names_that_a_helper_reads(findings, lines, told):
    body = "".join(f"        {line}\n" for line in lines)
    text = TALKER.replace("        self.create_publisher", body + "        self.create_publisher")
    text = text.replace("\ndef main", HELPER + "\ndef main")
    found = findings("PRM003", **{"robot/talker.py": text})
    assert {one.place.line - 8: " ".join(one.identity[1:]) for one in reversed(found)} == told


def test_what_a_node_reads_and_does_not_declare_is_one_finding(findings):
    reads = "".join(f"        self.get_parameter('{name}')\n" for name in ("speed", "rat", "frame", "speed"))
    text = TALKER.replace("        self.create_publisher", reads + "        self.create_publisher")
    all_names, slip = findings("PRM003", **{"robot/talker.py": text})

    assert all_names.message == "Talker reads 2 parameters that it never declares: speed, frame"
    assert [related.message for related in all_names.related] == ["'frame' is read here", "'speed' is read here"]
    assert "'rat'" in slip.message and "did you mean 'rate'" in slip.message


DECLARATIVE = """\
import rclpy
from rclpy.node import Node

class Field:
    def __init__(self, default):
        self.default = default

    def start(self, node):
        node.declare_parameter(self.name, self.default)

class Talker(Node):
    speed = Field(1.0)

    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_what_declares_parameters_on_a_node_that_is_not_known_may_do_so_on_this_one(findings):
    """Also where the program runs again with the parameters of the launch file, of which one decides a name."""
    given = node('<param name="rate" value="2.0"/><param name="speed" value="2.0"/>')
    fields, talker = DECLARATIVE.split("class Talker(Node)")
    talker = "from robot.fields import Field\nimport rclpy\nfrom rclpy.node import Node\n\nclass Talker(Node)" + talker
    named = talker.replace(
        "('rate', 1.0)", "('rate', 1.0)\n        self.create_timer(self.get_parameter('rate').value, print)"
    )
    for text in (talker, named):
        assert findings("PRM004", given, **{"robot/talker.py": text, "robot/fields.py": fields}) == []
        plain = text.replace("    speed = Field(1.0)\n", "").replace("import Field", "import rclpy")
        (found,) = findings("PRM004", given, **{"robot/talker.py": plain, "robot/fields.py": fields})
        assert "'speed'" in found.message


@pytest.mark.parametrize(
    ("uses", "severity"), [("self.gain", "error"), ("print('no gain')", "info")], ids=["a property", "nobody reads it"]
)
def test_an_undeclared_parameter_in_a_property(findings, uses: str, severity: str):
    prop = "    @property\n    def gain(self):\n        return self.get_parameter('gain').value\n\n"
    tick = f"    def tick(self):\n        {uses}\n\n"
    text = TALKER.replace(
        "        self.create_publisher", "        self.create_timer(1.0, self.tick)\n        self.create_publisher"
    )
    (found,) = findings("PRM003", **{"robot/talker.py": text.replace("def main", f"{prop}{tick}def main")})
    assert found.severity.label == severity


FOUR = TALKER.replace(
    "        self.declare_parameter('rate', 1.0)\n",
    "".join(
        f"        self.declare_parameter('{name}', {default})\n"
        for name, default in (("rate", "1.0"), ("gain", "2.0"), ("label", "'none'"), ("steps", "3"))
    ),
)


def _of_file(findings, *lines: str) -> list[Finding]:
    loaded = node('<param from="$(find-pkg-share robot)/config/a.yaml"/>')
    yaml = "".join(("talker:\n", "  ros__parameters:\n", *(f"    {line}\n" for line in lines)))
    given = {"robot/talker.py": FOUR, "config/a.yaml": yaml, "launch/other.launch.xml": f"<launch>{loaded}</launch>"}
    return findings("PRM002", loaded, **given)


def test_values_of_a_file_that_are_wrong_in_the_same_way_are_one_finding(findings):
    (one,) = _of_file(findings, "rate: 5", "gain: 1")
    assert one.place.line == 3 and "'rate'" in one.message
    assert one.message.endswith("; another value is of type integer instead of double, too")
    assert [row.place.line for row in one.related if row.place.file == one.place.file] == [4]


def test_values_of_a_file_that_are_wrong_in_different_ways(findings):
    both = _of_file(findings, "rate: 5", "steps: 3.5")
    assert [row.place.line for row in both] == [3, 4] and not any("too" in row.message for row in both)


@pytest.mark.parametrize(
    "written", ["__RATE__", "'@RATE@'", "<RATE>", "${RATE}", "'{{ rate }}'", "'{{ robots[0].rate | float }}'"]
)
def test_a_parameter_file_with_placeholders_gives_one_information(findings, written: str):
    (one,) = _of_file(findings, f"rate: {written}", "gain: __GAIN__", "label: __LABEL__", "steps: '@STEPS@'")
    assert one.severity is Severity.INFO and one.place.line == 3
    assert f"'{written.strip(chr(39))}' is a placeholder" in one.message
    assert one.message.endswith("; 2 more values are placeholders, too")


@pytest.mark.parametrize("written", ["'5'", "fast", "'<rate>'", "__rate__", "__RATE__s"])
def test_a_text_that_is_no_placeholder(findings, written: str):
    (one,) = _of_file(findings, f"rate: {written}")
    assert one.severity is Severity.ERROR and "of type string" in one.message


@pytest.mark.parametrize(("namespace", "told"), [("second", 1), ("2nd", 0)])
def test_nothing_is_set_on_a_node_that_ros_refuses_to_start(findings, namespace: str, told: int):
    assert len(findings("PRM004", node('<param name="volume" value="2.0"/>', namespace=namespace))) == told
    publisher = node('<param name="volume" value="2.0"/>', pkg="robot_state_publisher", exec="robot_state_publisher")
    launch = publisher.replace("<node ", f"<node namespace='{namespace}' ")
    assert len(findings("PRM004", launch)) == told


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("shown = settings['output']", []),
        ("shown = settings.get('output')", []),
        ("settings['output'] = 'there'", ["output"]),
        ("shown = settings['rate']", ["output"]),
    ],
)
def test_a_value_that_the_launch_file_takes_out_of_the_dict_itself(findings, line: str, told: list[str]):
    launch_file = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        f"    settings = {{'rate': 2.0, 'output': 'here'}}\n    {line}\n"
        "    return LaunchDescription([Node(package='robot', executable='talker', parameters=[settings])])\n"
    )
    reported = findings("PRM004", "", **{"launch/it2.launch.py": launch_file})
    assert [one.message.split("'")[1] for one in reported] == told
