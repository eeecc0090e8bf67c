"""LCH007: substitutions in XML and YAML launch files.

What launch says of each text was tried with its own parser, of Jazzy.
"""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

import pytest

from archlint.finding import Severity
from robot_package import TALKER, node


def _args(text: str) -> str:
    return f'<arg name="x" default="1"/><node pkg="robot" exec="talker" args={quoteattr(text)}/>'


BAD = {
    "${var x}": ("is no substitution", "write '$(var x)'"),
    "--x ${var x)": ("'${var x)' is no substitution", "write '$(var x)'"),
    "${x}": ("is no substitution", "write '$(var x)'"),
    "${find-pkg-share robot}/a": ("is no substitution", "write '$(find-pkg-share robot)'"),
    "(find-pkg-share robot)/a": ("is no substitution", "write '$(find-pkg-share robot)'"),
    "$ (var x)": ("is no substitution", "write '$(var x)'"),
    "$(var x": ("has no closing parenthesis", "add the ')'"),
    "$(var x)/$(find-pkg-share robot": ("'$(find-pkg-share robot' has no closing parenthesis", "add the ')'"),
    "$( var x )": ("no name of a substitution follows", "write '$(var name)'"),
    "$()": ("no name of a substitution follows", "write '$(var name)'"),
    "$(find robot)/$(var x)": ("there is no substitution 'find'", "write '$(find-pkg-share …)'"),
    "$(arg x) $(var x)": ("there is no substitution 'arg'", "write '$(var …)'"),
    "$(find_pkg_share robot)": ("there is no substitution 'find_pkg_share'", "write '$(find-pkg-share …)'"),
    "$(find-pkg-shar robot)": ("there is no substitution 'find-pkg-shar'", "write '$(find-pkg-share …)'"),
    "$(Var x)": ("there is no substitution 'Var'", "write '$(var …)'"),
    "$(find-pkg-share my robot)": ("has too few words, or too many", "takes one word"),
    "$(find-pkg-share)": ("has too few words, or too many", "takes one word"),
    "$(var x 5 6)": ("has too few words, or too many", "takes one word, or two"),
    "$(dirname x)": ("has too few words, or too many", "write $(dirname)"),
    "$(eval 1 + 2)": ("has too few words, or too many", "in quotes"),
    "$(command xacro robot.urdf)": ("has too few words, or too many", "in quotes"),
    "$(not $(find robot))": ("there is no substitution 'find'", "write '$(find-pkg-share …)'"),
}


@pytest.mark.parametrize("text", BAD)
def test_a_text_that_launch_refuses_or_takes_as_it_stands(findings, text):
    message, help = BAD[text]
    (told,) = findings("LCH007", _args(text))
    assert message in told.message and help in told.help
    assert told.place.file == "launch/it.launch.xml"


@pytest.mark.parametrize(
    "text",
    [
        "$(var x)",
        "$(var 'x')",
        "$(var x 5)",
        "'$(var x)'",
        "$(var x))",
        "costs 5$ (five)",
        "$HOME ${HOME}",
        "\\$(var x)",
        "$(env HOME /root)",
        "$(eval '1 + 2')",
        "$(eval \"'$(var x)' == 'a'\")",
        '$(eval \'"$(var x)" == "("\')',
        "$(command 'xacro $(find-pkg-share robot)/robot.urdf')",
        "$(command 'xacro robot.urdf' warn)",
        "$(if $(var x) a b)",
        "$(equals $(var x) a)",
        "$(launch_log_dir)",
        "$(of-another-package x)",
        "(see the manual)",
    ],
)
def test_a_text_that_launch_parses(findings, text):
    assert findings("LCH007", _args(text)) == []


def test_what_is_for_a_shell_and_for_people(findings):
    launch = """\
        <arg name="x" default="1" description="as in ${x}, (var x) or $(var x"/>
        <executable cmd="echo ${x}" shell="true"/>
    """
    assert findings("LCH007", launch) == []


def test_a_brace_that_no_argument_is_meant_by(findings):
    assert findings("LCH007", _args("${y}")) == []


def test_a_launch_file_for_ros1(findings):
    launch = '<arg name="x" default="$(find robot)/a"/><node pkg="robot" type="talker" args="$(arg x)"/>'
    assert findings("LCH007", launch) == []


def test_a_list_in_yaml(findings):
    text = "launch:\n- node:\n    pkg: robot\n    exec: talker\n    param:\n    - {name: a, value: ['$(var x', b]}\n"
    (told,) = findings("LCH007", **{"launch/it.launch.yaml": text})
    assert (told.place.file, told.place.line) == ("launch/it.launch.yaml", 6)


def test_a_file_is_one_finding(findings):
    (told,) = findings("LCH007", _args("$(find robot)") + _args("$(var x"))
    assert [row.message.partition(":")[0] for row in told.related] == ["'$(var x' has no closing parenthesis"]


@pytest.mark.parametrize("text", [r"$(command 'sh -c \'tr \'-\' \'_\'\'')", r"$(eval '\'$(var x)\' == \'a b\'')"])
def test_escaped_quotes_do_not_end_a_word(findings, text):
    assert findings("LCH007", _args(text)) == []


@pytest.mark.parametrize(
    "node",
    [
        '<node pkg="robot" exec="talker" name="${var x}"/>',
        '<node pkg="robot" exec="talker" namespace="${x}"/>',
        '<node pkg="robot" exec="talker" if="${var x}"/>',
        '<node pkg="robot" exec="talker"><param name="a" value="${find-pkg-share robot}/a"/></node>',
        '<node pkg="robot" exec="talker"><remap from="chatter" to="${x}/chatter"/></node>',
        '<include file="${find-pkg-share robot}/launch/other.launch.xml"/>',
    ],
)
def test_a_brace_in_any_attribute(findings, node):
    (told,) = findings("LCH007", f'<arg name="x" default="1"/>{node}')
    assert "is no substitution: launch takes it as it stands" in told.message


def test_a_template_is_no_launch_file(findings):
    filled_in = '<arg name="x" default="1"/><node pkg="robot" exec="talker" name="${robot_name}" namespace="${x}"/>'
    assert findings("LCH007", filled_in) == []
    assert findings("LCH007", '<arg name="x" default="${x}"/><node pkg="robot" exec="talker" name="$(var x)"/>') == []


PARAMETERS = "talker:\n  ros__parameters:\n    rate: 1.0\n    grid: {}\n"
FROM = '<param from="$(find-pkg-share robot)/config/p.yaml"{}/>'


def _given(findings, value: str, asked: str = "", also: str = "", **files: str):
    launch = f'<arg name="x" default="1"/>{node(FROM.format(asked))}{also}'
    return findings("LCH007", launch, **{"config/p.yaml": PARAMETERS.format(value), **files})


@pytest.mark.parametrize("text", ["$(find-pkg-share robot)/a.yaml", "$(var x)", "'$(env HOME)/a'", "$(dirname)/a"])
def test_a_parameter_file_that_launch_does_not_look_into(findings, text):
    (told,) = _given(findings, text)
    assert told.message.startswith("launch does not perform '$(")
    assert told.message.endswith(")' in this file: the parameter 'grid' is set to that text")
    assert told.help == 'write <param from="…" allow_substs="true"/>'
    assert (told.place.file, told.place.line) == ("config/p.yaml", 4)
    assert [row.place.file for row in told.related] == ["launch/it.launch.xml"]


def test_what_to_write_in_a_python_launch_file(findings):
    launch = (
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "from launch_ros.parameter_descriptions import ParameterFile\n\n\ndef generate_launch_description():\n"
        "    path = get_package_share_directory('robot') + '/config/p.yaml'\n"
        "    return LaunchDescription([Node(package='robot', executable='talker', parameters=[{}])])\n"
    )
    files = {"launch/it.launch.xml": "<launch/>", "config/p.yaml": PARAMETERS.format("$(find-pkg-share robot)/a")}
    (told,) = findings("LCH007", **files, **{"launch/py.launch.py": launch.format("path")})
    assert told.help == "write ParameterFile(…, allow_substs=True) where the file is given to a node"
    for allowed in ("True", "asked()"):
        given = launch.format(f"ParameterFile(path, allow_substs={allowed})")
        assert findings("LCH007", **files, **{"launch/py.launch.py": given}) == []


def test_a_parameter_file_in_which_launch_or_the_node_performs_them(findings):
    text = "$(find-pkg-share robot)/a.yaml"
    assert _given(findings, text, ' allow_substs="true"') == []
    assert _given(findings, text, also=node(FROM.format(' allow_substs="true"'), name="talker2")) == []
    reads = TALKER + "\nPATTERN = '$(find-pkg-share '\n"
    assert _given(findings, text, **{"robot/talker.py": reads}) == []
    assert _given(findings, "costs 5$ (five)") == []
    assert _given(findings, "$(date)") == []


ROBOT = """<?xml version="1.0"?>
<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  {line}
</robot>
"""
DESCRIBED = (
    '<node pkg="robot" exec="talker"><param name="robot_description" '
    "value=\"$(command 'xacro $(find-pkg-share robot)/urdf/robot.urdf.xacro')\"/>{more}</node>"
)


def _described(findings, line, more=""):
    files = {"urdf/robot.urdf.xacro": ROBOT.format(line=line)}
    return findings("LCH007", DESCRIBED.format(more=more), **files)


@pytest.mark.parametrize(
    ("line", "written", "help"),
    [
        ("<a b='$(robot)/config/a.yaml'/>", "$(robot)", "write '$(find robot)'"),
        ("<a>$(robot)/config/a.yaml</a>", "$(robot)", "write '$(find robot)'"),
        ("<a b='$(findd robot)/a.yaml'/>", "$(findd robot)", "write '$(find …)'"),
        ("<a b='$(find-pkg-share robot)/a.yaml'/>", "$(find-pkg-share robot)", "write '$(find …)'"),
        ("<a b='$(var prefix)'/>", "$(var prefix)", "write '$(arg …)'"),
        (
            "<a b='$(share)'/>",
            "$(share)",
            "write one of those that it knows: find, arg, env, optenv, anon, dirname, eval, cwd",
        ),
        ("<xacro:property name='p' value='1'/><a b='$(share)'/>", "$(share)", None),
        ("<xacro:if value='1'><a/></xacro:if><a b='$(share)'/>", "$(share)", None),
    ],
)
def test_a_substitution_that_xacro_does_not_know(findings, line, written, help):
    (told,) = _described(findings, line)
    assert told.message == f"xacro knows no '{written}': xacro stops here, and the robot has no description"
    assert help is None or told.help == help
    assert (told.place.file, told.place.line) == ("urdf/robot.urdf.xacro", 3)


@pytest.mark.parametrize(
    "line",
    [
        "<a b='$(find robot)/a.yaml' c='$(arg prefix)' d='$(env HOME)' e='$(optenv X y)' f='$(dirname)' g='$(cwd)'/>",
        "<a b='$(eval 1 + 2)' c='${1 + 2}'/>",
        "<a b='$$(share)' c='(share)'/>",
        "<!-- <a b='$(share)'/> -->",
        "<a><![CDATA[$(share)]]></a>",
        "<xacro:property name='p' value='$(share)'/>",
        "<xacro:macro name='m'><a b='$(share)'/></xacro:macro>",
        "<xacro:if value='${False}'><xacro:if value='1'/><a b='$(share)'/></xacro:if>",
        "<a b='$(${command} robot)'/>",
    ],
)
def test_what_xacro_knows_or_may_never_come_to(findings, line):
    assert _described(findings, line) == []


@pytest.mark.parametrize(
    "line",
    [
        "<xacro:if value='$(arg sim)'><a b='$(share)'/></xacro:if>",
        "<xacro:unless value='${sim}'><a b='$(share)'/></xacro:unless>",
        "<xacro:if value='true'><a b='$(share)'/></xacro:if>",
        "<xacro:macro name='m' params='x'><a b='$(share)'/></xacro:macro><xacro:m x='1'/>",
        "<xacro:macro name='xacro:m'><xacro:if value='${x}'><a>$(share)</a></xacro:if></xacro:macro><xacro:n.m/>",
    ],
)
def test_a_substitution_in_a_condition_or_in_a_macro_that_is_called(findings, line):
    (told,) = _described(findings, line)
    message = "xacro knows no '$(share)': where xacro comes to this, it stops, and the robot has no description"
    assert (told.message, told.severity) == (message, Severity.WARNING)


@pytest.mark.parametrize(
    "line",
    [
        "<xacro:unless value='1'><a b='$(share)'/></xacro:unless>",
        "<xacro:macro name='m' params='x:=$(share)'/><xacro:m x='1'/>",
        "<xacro:macro name='m'><xacro:if value='0'><a b='$(share)'/></xacro:if></xacro:macro><xacro:m/>",
        "<xacro:property name='p'><a b='$(share)'/></xacro:property>",
        "<xacro:macro name='m'><a b='$(share)'/></xacro:macro><xacro:macro name='other'/><xacro:other/>",
    ],
)
def test_a_condition_that_never_holds_and_a_macro_that_nobody_calls(findings, line):
    assert _described(findings, line) == []


@pytest.mark.parametrize(
    ("line", "written", "closing"),
    [
        ("<a b='${(1 + 2) * 3'/>", "${(1 + 2) * 3", "}"),
        ("<a b='${1} ${2'/>", "${2", "}"),
        ('<a b="$(arg prefix"/>', "$(arg prefix", ")"),
        ("<a b='$(dirname)/${name' c='}'/>", "${name", "}"),
    ],
)
def test_an_expression_that_nothing_closes(findings, line, written, closing):
    """Tried with xacro 2.1.1, which says "invalid expression"."""
    (told,) = _described(findings, line)
    message = f"nothing closes '{written}': xacro stops here, and the robot has no description"
    assert (told.message, told.help) == (message, f"add the '{closing}'")
    assert (told.place.line, told.severity) == (3, Severity.ERROR)
    (told,) = _described(findings, f"<xacro:if value='$(arg arm)'>{line}</xacro:if>")
    assert "where xacro comes to this, it stops" in told.message and told.severity is Severity.WARNING


@pytest.mark.parametrize(
    "line",
    [
        "<a b='$${x' c='$$(x' d='$ {x' e='a$' f='$a{' g='}{'/>",
        "<a b='${1}' c='$(eval 1 + (2 + 3))' d='$$${1}'/>",
        "<a b='${x\n}'/>",
        "<!-- <a b='${x'/> -->",
        "<xacro:property name='p' value='${x'/>",
        "<xacro:unless value='1'><a b='${x'/></xacro:unless>",
    ],
)
def test_expressions_that_xacro_reads_or_never_comes_to(findings, line):
    assert _described(findings, line) == []


def test_a_description_that_another_includes_where_a_condition_holds(findings):
    """The file with the wrong word is found by its path in the package, or beside the one that includes it."""
    includes = "<xacro:if value='{value}'><xacro:include filename='{file}'/></xacro:if>"
    control = {"urdf/control.xacro": ROBOT.format(line="<a b='$(robot)/a.yaml'/>")}
    for value, found in {"$(arg control)": 1, "0": 0}.items():
        for file in ("control.xacro", "$(find robot)/urdf/control.xacro"):
            robot = {"urdf/robot.urdf.xacro": ROBOT.format(line=includes.format(value=value, file=file))}
            told = findings("LCH007", DESCRIBED.format(more=""), **robot, **control)
            assert [(row.place.file, row.severity) for row in told] == [
                ("urdf/control.xacro", Severity.WARNING)
            ] * found


def test_what_a_condition_includes_may_not_be_there(findings):
    """LCH004 says nothing of a file that the description needs only where a condition holds."""
    for file in ("gone.xacro", "$(find robot)/urdf/gone.xacro"):
        line = f"<xacro:if value='$(arg control)'><xacro:include filename='{file}'/></xacro:if>"
        robot = {"urdf/robot.urdf.xacro": ROBOT.format(line=line)}
        assert not any("gone" in told.message for told in findings("LCH004", DESCRIBED.format(more=""), **robot))
        assert findings("LCH007", DESCRIBED.format(more=""), **robot) == []


FILLED_IN = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    share = get_package_share_directory('robot')
    with open(os.path.join(share, 'urdf', 'robot.urdf.xacro')) as file:
        text = file.read().replace('{replaced}', share)
    return LaunchDescription([
        Node(package='robot', executable='talker', parameters=[{{'robot_description': text}}]),
    ])
"""


def test_a_description_that_a_launch_file_fills_in_or_that_none_reads(findings):
    robot = {"urdf/robot.urdf.xacro": ROBOT.format(line="<a b='$(share)'/>")}
    assert findings("LCH007", **robot, **{"launch/it.launch.py": FILLED_IN.format(replaced="$(share)")}) == []
    assert findings("LCH007", node("talker"), **robot) == []
    assert len(findings("LCH007", **robot, **{"launch/it.launch.py": FILLED_IN.format(replaced="$(other)")})) == 1


MACRO = "<xacro:macro name='wheel' params='side radius:= 0.1 tyre:=${1 + 1} *origin'><link name='a'/></xacro:macro>"
STOPS = "xacro stops here, and the robot has no description"


@pytest.mark.parametrize(
    ("call", "message", "help"),
    [
        ("<xacro:inclue filename='a.xacro'/>", "there is no macro 'inclue'; did you mean 'include'?", None),
        ("<xacro:wheels side='left'/>", "there is no macro 'wheels'; did you mean 'wheel'?", "write <xacro:wheel>"),
        (
            "<xacro:gripper/>",
            "there is no macro 'gripper'",
            "define it, or include the file that does, in front of this",
        ),
        (
            "<xacro:wheel side='left' raduis='1'><origin/></xacro:wheel>",
            "the macro 'wheel' has no parameter 'raduis'; did you mean 'radius'?",
            "write 'radius'",
        ),
        (
            "<xacro:wheel side='left' mass='1'><origin/></xacro:wheel>",
            "the macro 'wheel' has no parameter 'mass'",
            "remove it, or add it to the params of the macro",
        ),
        (
            "<xacro:wheel><origin/></xacro:wheel>",
            "the macro 'wheel' is not given its parameter 'side'",
            "give it here, or a default in the params of the macro: side:=…",
        ),
    ],
)
def test_a_call_at_which_xacro_stops(findings, call, message, help):
    (told,) = _described(findings, MACRO + "\n" + call)
    assert told.message == f"{message}: {STOPS}"
    assert help is None or told.help == help
    assert (told.place.file, told.place.line) == ("urdf/robot.urdf.xacro", 4)


@pytest.mark.parametrize(
    "call",
    [
        "<xacro:wheel side='left'><origin/></xacro:wheel>",
        "<xacro:wheel side='left' radius='0.2' tyre='3'><origin/></xacro:wheel>",
        "<xacro:if value='$(arg gripper)'><xacro:gripper/></xacro:if>",
        "<xacro:include filename='$(find elsewhere)/gripper.xacro'/><xacro:gripper/><xacro:wheel mass='1'/>",
        "<xacro:include filename='$(find elsewhere)/gripper.xacro' ns='of'/><xacro:of.gripper/>",
        "<xacro:macro name='arm'><xacro:gripper/></xacro:macro>",
        "<xacro:call macro='wheel' side='left'><origin/></xacro:call>",
    ],
)
def test_a_call_that_xacro_follows_or_may_follow(findings, call):
    assert _described(findings, MACRO + call) == []
