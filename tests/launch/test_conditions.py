"""Conditions of launch actions: what decides them, and which exclude each other."""

from __future__ import annotations

import pytest

from archlint.branches import ArgumentBranch
from launching import names, node


@pytest.mark.parametrize(("default", "expected"), [("true", ["yes"]), ("False", ["no"]), ("1", ["yes"])])
def test_a_default_decides_a_condition(launches, default, expected):
    launched = launches.python(
        f"[DeclareLaunchArgument('sim', default_value='{default}'), "
        f"{node('yes', condition='IfCondition(LaunchConfiguration(sim))')}, "
        f"{node('no', condition='UnlessCondition(LaunchConfiguration(sim))')}]",
        before="sim = 'sim'",
    )
    assert names(launched) == expected
    assert len(launched.started) == 2


def test_an_undecided_condition_gives_two_arms_that_exclude_each_other(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('sim'), "
        f"{node('yes', condition='IfCondition(LaunchConfiguration(sim))')}, "
        f"{node('no', condition='UnlessCondition(LaunchConfiguration(sim))')}]",
        before="sim = 'sim'",
    )
    yes, no = launched.started
    sim = ArgumentBranch("sim")
    assert (yes.branch_arms, no.branch_arms) == ({(sim, 1)}, {(sim, 0)})
    assert (launched.condition(yes.branch_arms), launched.condition(no.branch_arms)) == ("sim:=true", "sim:=false")


def test_values_of_one_argument_exclude_each_other(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('mode'), "
        + ", ".join(
            node(
                name, condition=f"IfCondition(PythonExpression([q, LaunchConfiguration('mode'), q, ' == ', {name!r}]))"
            )
            for name in ("'a'", "'b'")
        )
        + "]",
        before='q = "\'"',
    )
    one, other = (dict(started.branch_arms) for started in launched.started)
    assert one.keys() == other.keys() == {ArgumentBranch("mode")} and one != other


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("\"'$(var mode)' == 'fast'\"", ["n"]),
        ("\"'$(var mode)' in ['slow', 'still']\"", []),
        ('"not $(var flag)"', []),
        ("\"$(var flag) and '$(var mode)'.startswith('fa')\"", ["n"]),
        ('"$(var count) * 2 > 5"', ["n"]),
    ],
)
def test_python_expressions_on_known_values(launches, expression, expected):
    launched = launches.xml(
        '<arg name="mode" default="fast"/><arg name="flag" default="True"/><arg name="count" default="3"/>'
        f"<node pkg='robot' exec='talker' name='n' if='$(eval {expression.replace(chr(39), '&apos;')})'/>"
    )
    assert names(launched) == expected


@pytest.mark.parametrize(("arguments", "expected"), [({}, ["slow"]), ({"fast": "True"}, ["quick"])])
def test_eval_of_an_argument_decides_what_a_function_starts(launches, arguments, expected):
    launched = launches.python(
        """[DeclareLaunchArgument('fast', default_value='False'), OpaqueFunction(function=start)]""",
        before="""\
def start(context):
    fast = eval(LaunchConfiguration('fast').perform(context))
    return [Node(package='robot', executable='talker', name='quick' if fast else 'slow')]
""",
        **arguments,
    )
    assert names(launched) == expected


def test_eval_of_more_than_constants_stays_unknown(launches):
    launched = launches.python(
        "[Node(package='robot', executable='talker', name=eval('__import__(\"os\").getcwd()'))]",
    )
    assert names(launched) == ["?"]


def test_no_expression_is_executed(launches, tmp_path):
    marker = tmp_path / "executed"
    text = f"__import__(&apos;os&apos;).mkdir(&apos;{marker}&apos;)"
    launched = launches.xml(f"<node pkg='robot' exec='talker' name='n' if='$(eval \"{text}\")'/>")
    assert not marker.exists()
    assert launched.started[0].branch_arms


OWN = """\
from launch import Condition, Substitution
from launch.substitutions import (AndSubstitution, EqualsSubstitution, NotEqualsSubstitution, NotSubstitution)
from somewhere.launch import Foreign, is_real
class AsBool(Substitution):
    def __init__(self, name):
        super().__init__()
        self.config = LaunchConfiguration(name)
    def perform(self, context):
        return str(self.config.perform(context).lower() in ('yes', 'true'))
class Is(Condition):
    def __init__(self, name, value):
        self.name, self.value = name, value
        super().__init__(predicate=self.ask)
    def ask(self, context):
        return context.launch_configurations[self.name] == self.value
class Never(IfCondition):
    def __init__(self):
        super().__init__('false')
class Given(Condition):
    def evaluate(self, context):
        return 'x' in context.launch_configurations
"""


def started_under(launches, first: str, second: str, default: str | None = None) -> str:
    """How two nodes under two conditions run: ``both``, ``first``, ``second`` or ``none`` where that is known,
    ``alike`` or ``apart`` where it depends on the same thing, and ``either`` where nothing is known."""
    given = "" if default is None else f", default_value={default!r}"
    actions = f"[DeclareLaunchArgument('x'{given}), {node('a', condition=first)}, {node('b', condition=second)}]"
    one, other = launches.python(actions, before=OWN).started
    if not one.branch_arms and not other.branch_arms:
        running = [name for name, started in (("first", one), ("second", other)) if not started.dormant]
        return {0: "none", 1: running[0] if running else "", 2: "both"}[len(running)]
    if one.branch_arms == other.branch_arms:
        return "alike"
    (this,), (that,) = one.branch_arms, other.branch_arms
    return "apart" if this[0] == that[0] else "either"


@pytest.mark.parametrize(
    ("first", "second", "default", "expected"),
    [
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", "yes", "first"),
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", "no", "second"),
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", None, "apart"),
        ("IfCondition(AsBool('x'))", "IfCondition(AsBool('x'))", None, "alike"),
        ("IfCondition(AsBool('x'))", "IfCondition(AsBool('y'))", None, "either"),
        ("Is('x', 'a')", "Is('x', 'b')", "b", "second"),
        ("Is('x', 'a')", "Is('x', 'b')", None, "either"),
        ("Is('x', 'a')", "Is('x', 'a')", None, "alike"),
        ("Condition(predicate=lambda c: c.launch_configurations['x'] == '1')", "Never()", "1", "first"),
        ("Given()", "Never()", "1", "first"),
        ("IfCondition(Foreign('x'))", "UnlessCondition(Foreign('x'))", None, "apart"),
        ("IfCondition(Foreign('x'))", "IfCondition(Foreign('y'))", None, "either"),
        ("IfCondition(is_real())", "UnlessCondition(is_real())", None, "either"),
        ("IfCondition(Command('a'))", "UnlessCondition(Command('a'))", None, "apart"),
        ("Foreign('x')", "Foreign('y')", None, "either"),
        ("lambda c: True", "lambda c: False", None, "either"),
        ("LaunchConfiguration('x')", "'true'", "true", "either"),
    ],
)
def test_how_conditions_go_together(launches, first, second, default, expected):
    assert started_under(launches, first, second, default) == expected


def test_one_condition_in_a_variable_excludes_its_opposite(launches):
    before = f"{OWN}\nreal = is_real()\nother = is_real()"
    nodes = [
        node(name, condition=f"{kind}({what})")
        for name, kind, what in [
            ("a", "IfCondition", "real"),
            ("b", "UnlessCondition", "real"),
            ("c", "UnlessCondition", "other"),
        ]
    ]
    a, b, c = (dict(started.branch_arms) for started in launches.python(f"[{', '.join(nodes)}]", before=before).started)
    assert a.keys() == b.keys() and a != b
    assert a.keys() != c.keys()


@pytest.mark.parametrize(
    ("text", "runs"),
    [("'True'", True), ("' 1 '", True), ("'FALSE'", False), ("'yes'", None), ("''", None), ("'on'", None)],
)
def test_the_truth_of_a_text_is_launchs(launches, text, runs):
    (started,) = launches.python(f"[{node('n', condition=f'IfCondition({text})')}]").started
    assert (None if started.branch_arms else not started.dormant) is runs


@pytest.mark.parametrize(
    ("test", "runs"),
    [
        ("EqualsSubstitution('Sim', 'sim')", False),
        ("EqualsSubstitution('True', '1')", True),
        ("EqualsSubstitution('1.0', '1')", True),
        ("NotEqualsSubstitution('a', 'b')", True),
        ("NotSubstitution('off')", True),
        ("NotSubstitution('oFF')", None),
        ("AndSubstitution('yes', '1')", True),
        ("PythonExpression(['not ', 'False'])", True),
        ("PythonExpression(['not ', 'false'])", None),  # a NameError
    ],
)
def test_the_truth_of_a_substitution_is_launchs(launches, test, runs):
    (started,) = launches.python(f"[{node('n', condition=f'IfCondition({test})')}]", before=OWN).started
    assert (None if started.branch_arms else not started.dormant) is runs


def test_an_argument_set_anew_is_another_condition(launches):
    launched = launches.xml(
        '<arg name="x"/><node pkg="robot" exec="talker" name="a" if="$(var x)"/>'
        '<let name="x" value="$(command \'id\')"/><node pkg="robot" exec="talker" name="b" unless="$(var x)"/>'
    )
    first, second = (dict(started.branch_arms) for started in launched.started)
    assert first.keys() != second.keys()
    assert launched.undecided == {"x": ["true", "false"]}


def test_an_argument_keeps_its_condition_under_another_name(launches):
    launches.file(
        "robot/launch/inner.launch.xml",
        '<launch><arg name="sim"/><node pkg="robot" exec="talker" name="b" unless="$(var sim)"/></launch>',
    )
    launched = launches.xml(
        '<arg name="x"/><node pkg="robot" exec="talker" name="a" if="$(var x)"/>'
        '<include file="$(find-pkg-share robot)/launch/inner.launch.xml"><arg name="sim" value="$(var x)"/></include>'
    )
    assert [launched.condition(started.branch_arms) for started in launched.started] == ["x:=true", "x:=false"]


ONE_OR_OTHER = f"one, other = {node('one')}, {node('other')}\nreal = os.path.exists('/dev/robot')\n"


@pytest.mark.parametrize(
    ("actions", "before"),
    [
        ("[one if real else other]", ""),
        ("[one] if real else [other]", ""),
        ("[GroupAction([one] if real else [other])]", ""),
        ("[chosen]", "if real:\n    chosen = one\nelse:\n    chosen = other"),
        ("chosen", "if real:\n    chosen = [one]\nelse:\n    chosen = [other]"),
        ("[OpaqueFunction(function=lambda context: [one if real else other])]", ""),
    ],
)
def test_one_of_two_actions_excludes_the_other(launches, actions, before):
    one, other = (
        dict(started.branch_arms) for started in launches.python(actions, before=ONE_OR_OTHER + before).started
    )
    assert one.keys() == other.keys() and one != other


def test_what_is_in_both_lists_runs_always(launches):
    before = ONE_OR_OTHER + f"both = {node('both')}\nchosen = [both, one] if real else [both, other]"
    conditional = {s.name.text: bool(s.branch_arms) for s in launches.python("chosen", before=before).started}
    assert conditional == {"both": False, "one": True, "other": True}


@pytest.mark.parametrize(
    ("code", "why"),
    [
        ("if os.environ['ROBOT'] == 'arm':\n    description.append({0})", "the environment variable ROBOT"),
        ("description += [{0}] if os.getenv('ROBOT') else []", "the environment variable ROBOT"),
        ("if 'arm' in get_search_paths():\n    description.append({0})", "the environment variable AMENT_PREFIX_PATH"),
        (
            "if 'arm' in [path.split('/')[-1] for path in get_search_paths()]:\n    description.append({0})",
            "the environment variable AMENT_PREFIX_PATH",
        ),
        (
            "if has_resource('packages', 'image_view'):\n    description.append({0})",
            "the environment variable AMENT_PREFIX_PATH",
        ),
        ("if os.path.exists('/dev/robot'):\n    description.append({0})", "which files the machine has"),
        (
            "if os.path.exists(get_package_share_directory('other') + '/p.yaml'):\n    description.append({0})",
            "which files the machine has",
        ),
    ],
)
def test_why_nobody_knows_whether_a_node_is_started(launches, code, why):
    imported = (
        "from ament_index_python.packages import get_search_paths\n"
        "from ament_index_python.resources import has_resource\n"
    )
    before = f"{imported}\ndescription = []\n{code.format(node('talker'))}"
    launched = launches.python("description", before)
    [started] = launched.started
    assert launched.reasons(started.branch_arms) == [why]
    assert launched.condition(started.branch_arms) == f"a condition ({why})"


def test_a_package_of_the_workspace_is_there(launches):
    before = (
        "from ament_index_python import has_resource\ndescription = []\n"
        f"if has_resource('packages', 'robot'):\n    description.append({node('talker')})"
    )
    [started] = launches.python("description", before).started
    assert not started.branch_arms


def test_why_a_condition_is_open(launches):
    condition = "IfCondition(EnvironmentVariable('ROBOT'))"
    launched = launches.python(f"[{node('talker', condition=condition)}]")
    [started] = launched.started
    assert launched.reasons(started.branch_arms) == ["the environment variable ROBOT"]
