"""Parameter files that nav2_common's substitutions make of others."""

from __future__ import annotations

from archlint.systems.overrides import NotKnown, applied
from launching import Launches

IMPORT = "from nav2_common.launch import HasNodeParams, LaunchConfigAsBool, ReplaceString, RewrittenYaml"
FILE = "FindPackageShare('robot').find('robot') + '/config/nav2.yaml'"
YAML = """\
planner:
  ros__parameters:
    use_sim_time: false
    map: <robot>/map
    frame: "<robot>"
    plugins: [grid, '1e5']
    Grid:
      tolerance: 0.5
      use_sim_time: true
      costs: [1, 2, 3]
    Grid.speed: 2
    later: '1e5'
/**:
  ros__parameters:
    use_sim_time: false
    map: shared
costmap:
  costmap:
    ros__parameters:
      width: 3
"""


def given(launches: Launches, made: str, node: str = "/planner", **arguments: str) -> dict[str, object]:
    """What the one node of a launch file gets from a file that is made so."""
    launches.file("robot/config/nav2.yaml", YAML)
    before = f"{IMPORT}\nmade = {made}"
    declared = "".join(f"DeclareLaunchArgument({name!r}), " for name in arguments)
    actions = f"[{declared}Node(package='nav', executable='planner', parameters=[made])]"
    launched = launches.python(actions, before, **arguments)
    loaded = launches.of_workspace()
    (started,) = launched.started
    assert not launched.gaps
    return {one.name: one.value for one in applied(started, node, loaded.files.parameters)}


def test_a_file_that_is_not_rewritten_stays_as_it_is(launches):
    found = given(launches, FILE)
    assert found["use_sim_time"] is False and found["map"] == "shared" and found["later"] == "1e5"


def test_rewrites_that_are_an_empty_text_are_none(launches):
    found = given(launches, f"RewrittenYaml({FILE}, root_key='', param_rewrites='', convert_types=True)")
    assert found["use_sim_time"] is False and found["Grid.tolerance"] == 0.5


def test_a_parameter_is_rewritten_wherever_its_key_stands(launches):
    found = given(launches, f"RewrittenYaml({FILE}, {{'use_sim_time': 'True', 'speed': '9', 'absent': '1'}})")
    assert found["use_sim_time"] is True and found["Grid.use_sim_time"] is True
    assert found["Grid.speed"] == 2  # its key is 'Grid.speed'
    assert "absent" not in found and "speed" not in found


def test_texts_become_numbers_only_when_they_are_to(launches):
    rewrites = "{'tolerance': '0.25', 'map': 'yes', 'later': 'False'}"
    as_texts = given(launches, f"RewrittenYaml({FILE}, {rewrites})")
    assert (as_texts["Grid.tolerance"], as_texts["map"], as_texts["later"]) == ("0.25", "yes", False)
    as_numbers = given(launches, f"RewrittenYaml({FILE}, {rewrites}, convert_types=True)")
    assert (as_numbers["Grid.tolerance"], as_numbers["map"], as_numbers["later"]) == (0.25, "yes", False)


def test_what_is_dumped_without_quotes_may_be_read_as_a_number(launches):
    found = given(launches, f"RewrittenYaml({FILE}, {{}})")
    assert found["later"] == 100000.0 and found["plugins"] == ["grid", 100000.0]


def test_a_key_with_parameters_below_it_becomes_one_parameter(launches):
    found = given(launches, f"RewrittenYaml({FILE}, {{'Grid': 'none'}})")
    assert found["Grid"] == "none" and "Grid.tolerance" not in found and found["Grid.speed"] == 2


def test_whole_paths_are_set_and_added(launches):
    rewrites = (
        "{'planner.ros__parameters.Grid.tolerance': '1', 'planner.ros__parameters.Grid.costs.1': '7',"
        " 'planner.ros__parameters.new.depth': 'deep', 'planner.elsewhere': '1'}"
    )
    found = given(launches, f"RewrittenYaml({FILE}, {rewrites}, convert_types=True)")
    assert found["Grid.tolerance"] == 1 and found["Grid.costs"] == [1, 7, 3] and found["new.depth"] == "deep"
    assert not [name for name in found if "elsewhere" in name]
    other = given(launches, f"RewrittenYaml({FILE}, {{'extra.ros__parameters.rate': '5'}})", node="/extra")
    assert other["rate"] == "5"


def test_the_keys_are_sorted_so_that_a_section_of_one_node_wins(launches):
    found = given(launches, f"RewrittenYaml({FILE}, {{}})")
    assert found["map"] == "<robot>/map"  # in the file as it is, '/**' comes last and wins


def test_everything_goes_below_the_root_key(launches):
    made = f"RewrittenYaml({FILE}, {{}}, root_key=LaunchConfiguration('ns'))"
    assert "Grid.tolerance" in given(launches, made, node="/left/planner", ns="left")
    assert not given(launches, made, ns="left")
    assert "Grid.tolerance" in given(launches, made, ns="")


def test_keys_and_values_get_others(launches):
    found = given(launches, f"RewrittenYaml({FILE}, {{}}, key_rewrites={{'planner': 'mine', 'Grid': 'Star'}})", "/mine")
    assert found["Star.tolerance"] == 0.5
    changed = given(launches, f"RewrittenYaml({FILE}, {{}}, value_rewrites={{'grid': 'star', '0.5': 'True'}})")
    assert changed["plugins"] == ["star", 100000.0] and changed["Grid.tolerance"] is True


def test_a_value_that_nobody_knows_is_not_known_and_the_others_are(launches):
    rewrites = "{'map': Command('date'), 'use_sim_time': 'true'}"
    found = given(launches, f"RewrittenYaml({FILE}, {rewrites})")
    assert found["map"] == NotKnown("the output of a command") and found["use_sim_time"] is True


def test_words_are_replaced_in_keys_and_values(launches):
    found = given(launches, f"ReplaceString({FILE}, {{'<robot>': ('/', 'left'), 'planner': 'mine'}})", "/mine")
    assert found["frame"] == "/left" and found["Grid.tolerance"] == 0.5


def test_a_word_may_stand_for_a_list_or_for_nothing(launches):
    found = given(launches, f"ReplaceString({FILE}, {{'shared': '[1.5e-3, 0.0]', '<robot>/': ''}})", "/elsewhere")
    assert found["map"] == [0.0015, 0.0]
    assert given(launches, f"ReplaceString({FILE}, {{'shared': 'a, b'}})", "/elsewhere")["map"] == NotKnown(
        "a string that YAML may read in several ways"
    )
    assert given(launches, f"ReplaceString({FILE}, {{'5': '1'}})")["Grid.tolerance"] == NotKnown(
        "a value that ReplaceString changes"
    )


def test_words_are_replaced_under_a_condition(launches):
    made = f"ReplaceString({FILE}, {{'<robot>': '5'}}, condition=IfCondition(LaunchConfiguration('go')))"
    assert given(launches, made, go="true")["frame"] == "5"
    assert given(launches, made, go="false")["frame"] == "<robot>"


def test_one_file_is_made_of_the_other_and_handed_on(launches):
    replaced = f"ReplaceString({FILE}, {{'<robot>': 'left'}})"
    made = f"RewrittenYaml({replaced}, {{'map': 'other'}})"
    found = given(launches, made)
    assert found["frame"] == "left" and found["map"] == "other"


def test_an_included_file_gets_the_made_one(launches):
    launches.file("robot/config/nav2.yaml", YAML)
    launches.file(
        "robot/launch/inner.launch.xml",
        '<launch><arg name="params"/><node pkg="nav" exec="planner"><param from="$(var params)"/></node></launch>',
    )
    launched = launches.python(
        "[IncludeLaunchDescription(AnyLaunchDescriptionSource(FindPackageShare('robot').find('robot')"
        " + '/launch/inner.launch.xml'), launch_arguments={'params': made}.items())]",
        f"{IMPORT}\nmade = RewrittenYaml({FILE}, {{'tolerance': '2.5'}}, convert_types=True)",
    )
    (started,) = launched.started
    found = {one.name: one.value for one in applied(started, "/planner", launches.of_workspace().files.parameters)}
    assert found["Grid.tolerance"] == 2.5


def test_what_cannot_be_known_stays_unknown(launches):
    launches.file("robot/config/nav2.yaml", YAML)
    for made in (
        f"RewrittenYaml({FILE}, rewrites_of_the_robot())",
        f"RewrittenYaml({FILE}, {{}}, root_key=Command('hostname'))",
        f"RewrittenYaml({FILE}, {{}}, key_rewrites={{'planner': Command('hostname')}})",
        "RewrittenYaml(Command('which nav2.yaml'), {})",
        f"ReplaceString({FILE}, {{'ros__parameters:': 'x'}})",
        f"ReplaceString({FILE}, {{'<robot>': Command('hostname')}})",
    ):
        before = f"{IMPORT}\nfrom of_another_package import rewrites_of_the_robot\nmade = {made}"
        launched = launches.python("[Node(package='nav', executable='planner', parameters=[made])]", before)
        (started,) = launched.started
        assert not applied(started, "/planner", launches.of_workspace().files.parameters), made
        assert all(getattr(one, "reason", None) or one.reference.source is None for one in started.parameters), made


def test_nodes_of_a_file_and_switches_decide_conditions(launches):
    launches.file("robot/config/nav2.yaml", YAML)
    conditions = [
        f"IfCondition(HasNodeParams({FILE}, 'planner'))",
        f"IfCondition(HasNodeParams({FILE}, 'controller'))",
        "IfCondition(LaunchConfigAsBool('on'))",
        "IfCondition(LaunchConfigAsBool('off'))",
    ]
    nodes = ", ".join(f"Node(package='p', executable='e{n}', condition={c})" for n, c in enumerate(conditions))
    launched = launches.python(
        f"[DeclareLaunchArgument('on', default_value='Yes'), DeclareLaunchArgument('off', default_value='2'), {nodes}]",
        IMPORT,
    )
    assert [one.executable.text for one in launched.started if not one.dormant] == ["e0", "e2"]


def test_a_path_that_is_put_in_is_not_substituted_again(launches):
    launches.file("robot/config/nav2.yaml", YAML)
    made = f"RewrittenYaml({FILE}, {{'map': FindPackageShare('robot').find('robot') + '/maps/hall.yaml'}})"
    launched = launches.python(
        "[Node(package='nav', executable='planner', parameters=[ParameterFile(made, allow_substs=True)])]",
        f"{IMPORT}\nfrom launch_ros.descriptions import ParameterFile\nmade = {made}",
    )
    (started,) = launched.started
    found = {one.name: one.value for one in applied(started, "/planner", launches.of_workspace().files.parameters)}
    assert found["map"] == "$(find-pkg-share robot)/maps/hall.yaml"


def test_of_two_keys_that_are_alike_the_second_is_kept(launches, monkeypatch):
    """PyYAML makes one dict of them, and what is dumped has nothing of the first; rcl itself reads both."""
    twice = "planner:\n  ros__parameters:\n    first: 1\n  ros__parameters:\n    second: 2\n"
    monkeypatch.setattr(f"{__name__}.YAML", twice)
    assert given(launches, f"RewrittenYaml({FILE}, {{}})") == {"second": 2}
    assert given(launches, FILE) == {"first": 1, "second": 2}


def test_a_value_that_is_left_out_is_dumped_as_null_which_rcl_takes_for_a_text(launches, monkeypatch):
    empty = "planner:\n  ros__parameters:\n    layer:\n    none: ~\n    text: '~'\n    both: [~, 'x']\n"
    monkeypatch.setattr(f"{__name__}.YAML", empty)
    dumped = given(launches, f"RewrittenYaml({FILE}, {{}})")
    assert dumped == {"layer": "null", "none": "null", "text": "~", "both": ["null", "x"]}
    assert given(launches, FILE) == {"layer": None, "none": "~", "text": "~", "both": ["~", "x"]}
