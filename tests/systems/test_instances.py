from __future__ import annotations

from dataclasses import FrozenInstanceError, dataclass, fields, is_dataclass, replace
from types import ModuleType

import pytest

from archlint.model import Blueprint, Program, Text
from archlint.ros.remapping import RemapRule
from archlint.systems import model
from archlint.systems import nodes as nodes_of_systems
from archlint.systems.instances import assemble, dependencies_within, instantiate
from archlint.systems.model import System
from archlint.systems.nodes import Endpoint, Node
from archlint.workspace.model import Dependency, Package, SourceFile, Workspace
from systems.builders import (
    action_server,
    blueprint,
    client,
    exact,
    from_parameter,
    parameter,
    partial,
    place,
    programs,
    publisher,
    service,
    subscriber,
    timer,
    unknown,
)


def package(name: str, *dependencies: str, kind: str = "depend") -> Package:
    manifest = SourceFile(f"/{name}/package.xml", f"{name}/package.xml", "package_xml", name, None)
    needs = tuple(Dependency(kind=kind, name=other) for other in dependencies)
    return Package(name, f"/{name}", name, "ament_python", False, needs, manifest)


@dataclass
class FakeSettings:
    closed_world: bool = False
    distro: str | None = None


def load(*runs: Program, packages: tuple[Package, ...] = ()) -> System:
    [system] = assemble(runs, Workspace("/", (), packages, ()), FakeSettings())
    return system


def started(made: Blueprint, **options) -> Node:
    return instantiate(made, None, **options)


def only(node: Node) -> Endpoint:
    [endpoint] = node.endpoints
    return endpoint


def test_names_are_expanded_under_the_node() -> None:
    made = blueprint("talker", publisher("chatter"), publisher("/absolute"), publisher("~/private"), namespace="robot")
    node = started(made)
    assert node.name == "/robot/talker"
    assert [(e.written, e.name) for e in node.endpoints] == [
        ("/absolute", "/absolute"),
        ("chatter", "/robot/chatter"),
        ("~/private", "/robot/talker/private"),
    ]


def test_a_timer_is_no_endpoint() -> None:
    node = started(blueprint("talker", timer(0.5), publisher("chatter")))
    assert [e.kind for e in node.endpoints] == ["publisher"]
    assert [t.period for t in node.timers] == [0.5]


class TestPartKnowledge:
    """How far an endpoint's name is known depends on its own text and on the parts of the node it uses."""

    @pytest.mark.parametrize(
        ("name", "node_name", "namespace", "final", "resolution"),
        [
            ("/a", unknown(), unknown(), "/a", "exact"),
            ("a", unknown(), exact("/ns"), "/ns/a", "exact"),
            ("a", unknown(), unknown(), None, "unknown"),
            ("~/a", unknown(), exact("/ns"), None, "unknown"),
            ("/x/{node}", unknown(), exact("/ns"), None, "unknown"),
            ("~/a", exact("n"), unknown(), None, "unknown"),
            (from_parameter("topic", "a"), exact("n"), exact("/ns"), "/ns/a", "parameter"),
            ("a", exact("n"), from_parameter("ns", "robot"), "/robot/a", "parameter"),
            ("~/a", from_parameter("name", "n"), exact(""), "/n/a", "parameter"),
            ("a", from_parameter("name", "n"), exact(""), "/a", "exact"),
            (partial("*/cmd_vel"), exact("n"), exact(""), "/*/cmd_vel", "partial"),
            (partial("arm_*"), exact("n"), exact("/ns"), "/ns/arm_*", "partial"),
            ("~/a", partial("robot_*"), exact(""), "/robot_*/a", "partial"),
            ("a", exact("n"), partial("robot_*"), "/robot_*/a", "partial"),
            (from_parameter("topic", "a"), exact("n"), partial("robot_*"), "/robot_*/a", "partial"),
            (unknown(), exact("n"), exact(""), None, "unknown"),
        ],
    )
    def test_final_name(
        self, name: str | Text, node_name: Text, namespace: Text, final: str | None, resolution: str
    ) -> None:
        endpoint = only(started(blueprint(node_name, publisher(name), namespace=namespace, file="a.py")))
        assert (endpoint.name, endpoint.resolution) == (final, resolution)
        assert endpoint.resolved == (resolution in ("exact", "parameter"))

    def test_the_reason_names_the_part_that_is_not_known(self) -> None:
        made = blueprint(unknown("it comes from sys.argv"), publisher("~/a"), file="a.py")
        assert only(started(made)).reason == "the node's name is not known: it comes from sys.argv"

    def test_the_parameter_is_the_one_that_decides(self) -> None:
        made = blueprint("n", publisher("a"), namespace=from_parameter("ns", "robot"))
        assert only(started(made)).parameter == "ns"

    def test_a_node_without_a_known_name_has_none(self) -> None:
        assert started(blueprint(unknown(), file="a.py")).name is None
        assert started(blueprint("n", namespace=unknown())).name is None


class TestErrors:
    def test_a_name_that_rcl_rejects(self) -> None:
        endpoint = only(started(blueprint("n", publisher("foo bar"))))
        assert endpoint.error is not None
        assert "must not contain characters other than" in endpoint.error

    def test_a_name_that_only_its_expansion_breaks(self) -> None:
        endpoint = only(started(blueprint("n", publisher("{ns}/x"))))
        assert endpoint.error == "topic name must not contain repeated '/'"

    def test_a_node_name_that_rmw_rejects_is_the_nodes_fault_alone(self) -> None:
        node = started(blueprint("my-node", publisher("~/x")))
        assert node.error == "node name must not contain characters other than alphanumerics or '_'"
        assert only(node).error is None

    def test_an_invalid_name_connects_nothing(self) -> None:
        system = load(*programs(blueprint("n", publisher("a b")), blueprint("m", subscriber("a b"))))
        assert system.topics == {}

    def test_a_hole_is_no_error(self) -> None:
        assert only(started(blueprint("n", publisher(partial("{*}/x"))))).error is None

    def test_what_no_hole_can_mend_is_an_error(self) -> None:
        assert only(started(blueprint("n", publisher(partial("robot *"))))).error is not None

    def test_a_node_name_known_in_part_is_not_held_against_an_endpoint_that_does_not_use_it(self) -> None:
        endpoint = only(started(blueprint(partial("connector_*"), publisher("/image"))))

        assert (endpoint.name, endpoint.error) == ("/image", None)


class TestStartedByALaunchFile:
    def test_name_and_namespace_replace_those_of_the_code(self) -> None:
        node = started(blueprint("talker", publisher("~/x")), name="other", namespace="/robot")
        assert (node.name, only(node).name) == ("/robot/other", "/robot/other/x")

    def test_remaps_apply_to_the_final_name(self) -> None:
        rules = [RemapRule.parse("chatter:=/loud"), RemapRule.parse("/loud:=/louder")]
        node = started(blueprint("talker", publisher("chatter")), namespace="/robot", remaps=rules)
        assert only(node).name == "/loud"

    def test_a_service_rule_leaves_topics_alone(self) -> None:
        made = blueprint("n", publisher("x"), service("x"), client("x"))
        node = started(made, remaps=[RemapRule.parse("rosservice://x:=y")])
        assert sorted((e.kind, e.name) for e in node.endpoints) == [
            ("client", "/y"),
            ("publisher", "/x"),
            ("service", "/y"),
        ]

    def test_an_action_is_remapped_as_a_topic(self) -> None:
        made = blueprint("n", action_server("dock"))
        assert only(started(made, remaps=[RemapRule.parse("dock:=/base/dock")])).name == "/base/dock"

    def test_humble_does_not_remap_an_action(self) -> None:
        made = blueprint("n", action_server("dock"), publisher("dock"))
        node = started(made, remaps=[RemapRule.parse("dock:=/base/dock")], distro="humble")
        assert sorted((end.kind, end.name) for end in node.endpoints) == [
            ("action_server", "/dock"),
            ("publisher", "/base/dock"),
        ]

    def test_the_nodes_own_arguments_come_first(self) -> None:
        made = blueprint("n", publisher("x"), cli_arguments=("--ros-args", "-r", "x:=mine", "-r", "__node:=me"))
        node = started(made, name="launched", remaps=[RemapRule.parse("x:=yours")])
        assert (node.name, only(node).name) == ("/me", "/mine")

    def test_a_rule_that_may_match_makes_the_name_unknown(self) -> None:
        made = blueprint("n", publisher(partial("*/scan")))
        endpoint = only(started(made, remaps=[RemapRule.parse("/front/scan:=/scan")]))
        assert (endpoint.name, endpoint.resolution) == (None, "unknown")
        assert endpoint.reason == "the remap rule '/front/scan:=/scan' may apply to it"

    def test_a_rule_that_cannot_match_does_not(self) -> None:
        made = blueprint("n", publisher(partial("*/scan")))
        assert only(started(made, remaps=[RemapRule.parse("/odom:=/odometry")])).name == "/*/scan"

    def test_a_parameter_that_is_the_name(self) -> None:
        made = blueprint("n", parameter("topic", "x"), publisher(from_parameter("topic", "x")))
        endpoint = only(started(made, overrides={"topic": "/y"}))
        assert (endpoint.name, endpoint.resolution, endpoint.parameter) == ("/y", "parameter", "topic")

    def test_a_parameter_that_the_name_is_built_from(self) -> None:
        made = blueprint("n", parameter("prefix", "x"), publisher(from_parameter("prefix", "x/cmd")))
        assert only(started(made, overrides={"prefix": "y"})).resolution == "unknown"


class TestOneSystemOfAllNodes:
    def test_two_executables_of_one_class_are_one_node(self) -> None:
        first = blueprint("talker", publisher("a"), executables=("talk",))
        second = blueprint("talker", publisher("a"), publisher("b"), executables=("chat",))
        [node] = load(*programs(first, second)).nodes
        assert node.executables == ("chat", "talk")
        assert sorted(e.name or "" for e in node.endpoints) == ["/a", "/b"]
        assert all(e.node is node for e in node.endpoints)

    def test_two_names_of_one_class_are_two_nodes(self) -> None:
        one, other = (blueprint(name, file="a.py", class_name="Talker") for name in ("left", "right"))
        assert [n.name for n in load(*programs(one, other)).nodes] == ["/left", "/right"]

    def test_one_name_of_two_classes_is_two_nodes(self) -> None:
        one, other = blueprint("n", file="a.py", class_name="A"), blueprint("n", file="b.py", class_name="B")
        assert [n.blueprint.class_name for n in load(*programs(one, other)).nodes if n.blueprint] == [
            "A",
            "B",
        ]

    def test_a_create_call_that_is_reached_twice_is_one_endpoint(self) -> None:
        made = blueprint("n", publisher("a", conditional=True), publisher("a"))
        for creation in made.creations:
            creation.place = place("helper.py", 3)
        endpoint = only(load(*programs(made)).nodes[0])
        assert not endpoint.conditional

    def test_a_loop_over_names_gives_an_endpoint_for_each(self) -> None:
        made = blueprint("n", publisher("left"), publisher("right"))
        for creation in made.creations:
            creation.place = place("helper.py", 3)
        assert [e.name for e in load(*programs(made)).nodes[0].endpoints] == ["/left", "/right"]

    def test_executors_that_differ_are_unknown(self) -> None:
        def node_with(*executors: str) -> Node:
            made = [blueprint("n", executor=executor) for executor in executors]
            return load(*programs(*made)).nodes[0]

        assert node_with("single_threaded", "none").executor == "single_threaded"
        assert node_with("single_threaded", "multi_threaded").executor == "unknown"

    def test_a_test_adds_nothing_to_the_node_it_tests(self) -> None:
        real = blueprint("n", publisher("a"))
        tested = blueprint("n", publisher("a"), subscriber("probe"), test=True)
        [node] = load(*programs(tested, real)).nodes
        assert not node.test
        assert [e.name for e in node.endpoints] == ["/a"]

    def test_a_node_of_tests_alone_is_marked(self) -> None:
        [node] = load(*programs(blueprint("n", test=True))).nodes
        assert node.test

    def test_order_does_not_depend_on_the_order_of_programs(self) -> None:
        made = [blueprint(name, file=f"{name}.py") for name in ("c", "a", "b")]
        made.append(blueprint(unknown(), file="0.py"))
        names = [n.name for n in load(*programs(*made)).nodes]
        assert names == [n.name for n in load(*programs(*reversed(made))).nodes] == ["/a", "/b", "/c", None]

    def test_connections_join_by_final_name(self) -> None:
        talker = blueprint("talker", publisher("chatter"))
        listener = blueprint("listener", subscriber("/chatter"))
        connection = load(*programs(talker, listener)).topics["/chatter"]
        assert [e.node.name for e in connection.providers] == ["/talker"]
        assert [e.node.name for e in connection.users] == ["/listener"]


def test_dependencies_are_transitive_and_stay_in_the_workspace() -> None:
    packages = [
        package("bringup", "driver", "rclpy", kind="exec"),
        package("driver", "interfaces"),
        package("interfaces", "rosidl_default_generators"),
        package("loop", "loop", "loop_too"),
        package("loop_too", "loop"),
        package("tested", "driver", kind="test"),
    ]
    assert dependencies_within(packages) == {
        "bringup": {"driver", "interfaces"},
        "driver": {"interfaces"},
        "interfaces": frozenset(),
        "loop": {"loop_too"},
        "loop_too": {"loop"},
        "tested": frozenset(),
    }


def test_the_system_knows_which_packages_belong_together() -> None:
    system = load(packages=(package("a", "b"), package("b")))
    assert system.package_dependencies == {"a": {"b"}, "b": frozenset()}


@pytest.mark.parametrize("name", [field.name for field in fields(System)])
def test_a_system_does_not_change_once_it_is_built(name: str):
    judged = System(None, [instantiate(blueprint("driver"), None)], [])
    with pytest.raises(FrozenInstanceError):
        setattr(judged, name, None)


@pytest.mark.parametrize("module", [model, nodes_of_systems])
def test_what_rules_and_renderers_share_does_not_change(module: ModuleType):
    classes = [each for each in vars(module).values() if is_dataclass(each) and each.__module__ == module.__name__]
    assert classes and all(each.__dataclass_params__.frozen for each in classes)


def test_a_node_and_its_endpoints_refer_to_each_other():
    talker = instantiate(blueprint("talker", publisher("x"), subscriber("y")), None)
    renamed = replace(talker, name="/speaker")
    for node in (talker, renamed):
        assert [(end.name, end.node is node) for end in node.endpoints] == [("/x", True), ("/y", True)]
    assert talker.endpoints is talker.endpoints


def test_the_systems_of_a_workspace_know_it():
    alternative = System("robot.launch.py", [], [])
    index = model.WorkspaceIndex(systems=[System(None, [], [], alternatives=[({"sim": "true"}, alternative)])])
    [system] = index.systems
    [(_, other)] = system.alternatives
    assert system.workspace is other.workspace is index


def test_lists_that_a_system_was_built_of_are_not_its_own():
    nodes, programs_of_nodes = [instantiate(blueprint("driver"), None)], programs(blueprint("driver"))
    judged = System(None, nodes, programs_of_nodes)
    nodes.clear()
    programs_of_nodes.clear()
    assert len(judged.nodes) == len(judged.programs) == 1
    assert not any(hasattr(part, "append") for part in (judged.nodes, judged.programs, judged.unowned))
