from __future__ import annotations

from collections.abc import Iterable

from archlint.ros import qos
from archlint.ros.remapping import RemapRule
from archlint.systems.implicit import IMPLICIT, implicit_names, with_implicit
from archlint.systems.instances import instantiate
from archlint.systems.nodes import Endpoint, Node
from systems.builders import action_client, action_server, blueprint, exact, node, system, unknown


def implicit_endpoints(plain: Node, distro: str | None = None) -> list[Endpoint]:
    [made] = with_implicit(system(plain), distro).nodes
    return [endpoint for endpoint in made.endpoints if endpoint.creation.api == IMPLICIT]


def names(endpoints: Iterable[Endpoint], *kinds: str) -> list[str | None]:
    return [e.name for e in endpoints if not kinds or e.kind in kinds]


def test_every_node() -> None:
    made = implicit_endpoints(node("/ns/talker"))
    assert names(made, "publisher") == ["/rosout", "/parameter_events"]
    assert names(made, "service") == [
        "/ns/talker/describe_parameters",
        "/ns/talker/get_parameter_types",
        "/ns/talker/get_parameters",
        "/ns/talker/list_parameters",
        "/ns/talker/set_parameters",
        "/ns/talker/set_parameters_atomically",
        "/ns/talker/get_type_description",
    ]
    assert names(made, "subscriber") == []


def test_humble_has_no_type_descriptions() -> None:
    assert "/n/get_type_description" not in names(implicit_endpoints(node("/n"), "humble"))


def test_what_the_constructor_turns_off() -> None:
    quiet = node("/n", enable_rosout=False, start_parameter_services=False)
    assert names(implicit_endpoints(quiet, "humble")) == ["/parameter_events"]


def test_simulated_time_subscribes_to_the_clock() -> None:
    made = implicit_endpoints(instantiate(blueprint("n"), None, overrides={"use_sim_time": True}))
    assert names(made, "subscriber") == ["/clock"]


def test_a_lifecycle_node() -> None:
    made = names(implicit_endpoints(node("/n", lifecycle=True)))
    assert "/n/transition_event" in made
    assert "/n/change_state" in made
    assert "/n/get_transition_graph" in made


def test_a_node_without_a_known_name() -> None:
    made = implicit_endpoints(instantiate(blueprint(unknown(), namespace=exact("/ns"), file="a.py"), None))
    assert names(made, "publisher") == ["/rosout", "/parameter_events"]
    assert set(names(made, "service")) == {None}


def test_an_external_node_has_none_that_are_known() -> None:
    external = Node("/x", None, "other", "x", "unknown", external=True)
    assert implicit_endpoints(external) == []


def test_the_hidden_half_of_an_action() -> None:
    loaded = with_implicit(
        system(
            node("/server", action_server("dock", "p/action/Dock")),
            node("/client", action_client("dock", "p/action/Dock")),
        )
    )
    feedback, status = (loaded.topics[f"/dock/_action/{part}"] for part in ("feedback", "status"))
    assert names(feedback.providers) == names(feedback.users) == ["/dock/_action/feedback"]
    assert feedback.types == ["p/action/Dock_FeedbackMessage"]
    assert [e.qos for e in status.providers] == [qos.ACTION_STATUS]
    goal = loaded.services["/dock/_action/send_goal"]
    assert [e.node.name for e in goal.providers] == ["/server"]
    assert [e.node.name for e in goal.users] == ["/client"]
    assert goal.types == ["p/action/Dock_SendGoal"]
    assert loaded.services["/dock/_action/cancel_goal"].types == ["action_msgs/srv/CancelGoal"]


def test_what_rclpy_makes_is_remapped_like_what_the_code_makes() -> None:
    rules = [RemapRule.parse(text) for text in ("~/get_parameters:=/asked", "/clock:=/simulated", "rosout:=log")]
    started = instantiate(blueprint("n"), None, namespace="/ns", remaps=rules, overrides={"use_sim_time": True})
    made = names(implicit_endpoints(started))
    assert "/asked" in made
    assert "/ns/n/get_parameters" not in made
    assert "/simulated" in made
    assert "/rosout" in made, "the rule is for /ns/rosout"


def test_the_hidden_half_of_an_action_can_be_remapped_by_itself() -> None:
    rule = RemapRule.parse("dock/_action/status:=state")
    started = instantiate(blueprint("n", action_server("dock", "p/action/Dock")), None, remaps=[rule])
    made = names(implicit_endpoints(started), "publisher")
    assert "/state" in made
    assert "/dock/_action/feedback" in made


def test_what_a_node_may_serve_without_saying_so() -> None:
    found = implicit_names(system(node("/ns/n")))
    assert {"/ns/n/get_parameters", "/ns/n/set_logger_levels", "/clock", "/rosout"} <= found
    assert "/get_parameters" not in found


def test_the_system_itself_is_left_as_it_was() -> None:
    plain = system(node("/n"))
    everything = with_implicit(plain)
    assert plain.nodes[0].endpoints == ()
    assert all(e.node is everything.nodes[0] for e in everything.endpoints)
