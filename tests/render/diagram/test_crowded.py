"""Pictures of many lines: named at nodes, listed together, and in boxes where there are very many nodes."""

from __future__ import annotations

from archlint.render.diagram.crowded import MANY_LINES, THINNED
from archlint.render.diagram.large import MOST_NODES, OPENED
from archlint.render.diagram.model import Diagram
from archlint.render.view import View
from archlint.ros.qos import Qos
from archlint.systems.model import System
from archlint.systems.nodes import Node
from render.pictures import diagram, dot, finding, lines, titles
from systems.builders import client, node, publisher, service, subscriber, system

PAIRS = 21


def pairs(number: int = PAIRS, package: str = "pairs") -> list[Node]:
    """Nodes that talk two by two: two lines a pair."""
    senders = [node(f"/from{n}", publisher(f"/data{n}"), package=package) for n in range(number)]
    return senders + [node(f"/to{n}", subscriber(f"/data{n}"), package=package) for n in range(number)]


def listeners(topic: str, number: int = 9) -> list[Node]:
    return [node(f"/listener{n}", subscriber(topic), package="listeners") for n in range(number)]


def named(of: System) -> dict[str, tuple[str, ...]]:
    return {shape.title: shape.named for shape in diagram(of).shapes.values() if shape.named}


def test_what_very_many_nodes_hear_is_named_at_each() -> None:
    talker = node("/tf_node", publisher("/tf"), subscriber("/data0"))
    drawn = diagram(system(talker, *listeners("/tf"), *pairs()))
    assert drawn.shapes["node", "/tf_node"].named == ("→ /tf",)
    [listed] = [shape for shape in drawn.shapes.values() if shape.kind == "ends"]
    assert listed.label == ("9 nodes, each with", *(f"/listener{n}" for n in range(9)), "← /tf")
    assert drawn.shapes["topic", "/tf"].lines[-1] == "from 1 node, to 9 nodes"
    assert not [line for line in drawn.lines if ("topic", "/tf") in line.ends]
    assert any(words.startswith("→ or ←") for words in drawn.caption)


def test_a_node_that_does_both_has_one_line_of_it() -> None:
    both = node("/both", publisher("/tf"), subscriber("/tf"))
    assert named(system(both, *listeners("/tf"), *pairs()))["/both"] == ("↔ /tf",)


def test_three_nodes_have_lines() -> None:
    assert named(system(node("/tf_node", publisher("/tf")), *listeners("/tf", 2), *pairs())) == {}


def test_what_several_nodes_use_is_named_where_nothing_else_can_give_way() -> None:
    drawn = named(system(node("/tf_node", publisher("/tf")), *listeners("/tf", 3), *pairs()))
    assert drawn["/tf_node"] == ("→ /tf",)


def test_several_nodes_have_lines_where_loose_ends_can_give_way() -> None:
    loose = [node(f"/loose{n}", publisher(f"/unheard{n}")) for n in range(10)]
    made = system(node("/tf_node", publisher("/tf")), *listeners("/tf", 7), *pairs(16), *loose)
    assert set(named(made)) == {f"/loose{n}" for n in range(10)}
    assert len(diagram(made).lines) == MANY_LINES


def test_a_picture_of_few_lines_has_them_all() -> None:
    few = [node("/tf_node", publisher("/tf")), *listeners("/tf", 12)]
    assert named(system(*few)) == {}
    assert len(diagram(system(*few)).lines) == 13


def test_a_broken_line_is_drawn_whoever_else_there_is() -> None:
    strict = node("/strict", subscriber("/tf", qos=Qos(reliability="reliable")))
    talker = node("/tf_node", publisher("/tf", qos=Qos(reliability="best_effort")))
    made = system(talker, strict, *listeners("/tf"), *pairs())
    assert [drawn.head for drawn in diagram(made).lines if drawn.broken] == [("node", "/strict")]
    assert "/strict" not in named(made)


def test_what_the_same_nodes_share_is_one_shape() -> None:
    made = system(
        node("/a", publisher("/x"), publisher("/y"), publisher("/z")),
        node("/b", subscriber("/x"), subscriber("/y")),
        node("/c", subscriber("/z")),
        *pairs(),
    )
    drawn = diagram(made)
    [ends] = [shape for shape in drawn.shapes.values() if shape.kind == "ends"]
    assert ends.label == ("2 topics", "/x", "/y")
    assert {("/a", "2 topics"), ("2 topics", "/b"), ("/a", "/z"), ("/z", "/c")} < lines(drawn)
    assert drawn.caption[0] == f"{3 + 2 * PAIRS} nodes, {3 + PAIRS} topics"


def test_in_a_small_picture_each_topic_has_its_shape() -> None:
    small = system(node("/a", publisher("/x"), publisher("/y")), node("/b", subscriber("/x"), subscriber("/y")))
    assert {"/x", "/y"} < titles(diagram(small))


def test_nodes_that_nothing_ties_are_listed() -> None:
    drawn = diagram(system(*(node(f"/single{n}") for n in range(3)), *pairs(1)))
    [listed] = [shape for shape in drawn.shapes.values() if shape.kind == "ends"]
    assert listed.label == ("3 nodes, each alone", "/single0", "/single1", "/single2")
    assert drawn.caption[0] == "5 nodes, 1 topic"


def test_two_nodes_that_nothing_ties_stand_for_themselves() -> None:
    assert {"/single0", "/single1"} < titles(diagram(system(*(node(f"/single{n}") for n in range(2)), *pairs(1))))


def test_a_picture_that_is_thinned_says_so_and_how_to_see_each_line() -> None:
    crowded = system(node("/tf_node", publisher("/tf")), *listeners("/tf"), *pairs())
    assert THINNED in diagram(crowded).caption
    every = diagram(crowded, View(every_line=True))
    assert THINNED not in every.caption
    assert len(every.lines) == 10 + 2 * PAIRS
    assert every.shapes["node", "/tf_node"].named == ()


def test_a_crowded_picture_in_which_nothing_is_put_together_does_not_say_so() -> None:
    assert THINNED not in diagram(system(*pairs())).caption


def torn() -> System:
    """A package whose nodes talk to each other, and one whose nodes talk to nodes of other packages only."""
    outside = [node(f"/outside{n}", publisher(f"/o{n}"), package="torn") for n in range(3)]
    return system(
        *pairs(), *outside, *(node(f"/far{n}", subscriber(f"/o{n}"), package=f"far{n % 2}") for n in range(3))
    )


def test_a_frame_that_more_lines_leave_than_stay_in_is_not_drawn() -> None:
    assert {*diagram(torn()).frames.values()} == {"pairs"}


def test_frames_that_were_asked_for_are_drawn() -> None:
    assert {*diagram(torn(), View(group="package")).frames.values()} == {"pairs", "torn", "far0", "far1"}


def large() -> System:
    return system(
        *(node(f"/{name}{n}", publisher(f"/{name}"), package=name) for name in ("arm", "base") for n in range(40))
    )


def boxes(drawn: Diagram) -> set[str]:
    return {shape.title for shape in drawn.shapes.values() if shape.kind == "group"}


def test_of_very_many_nodes_as_many_groups_are_boxes_as_it_takes() -> None:
    drawn = diagram(large())
    assert boxes(drawn) == {"arm"}
    assert OPENED in drawn.caption
    assert boxes(diagram(large(), View(collapse=("*",)))) == {"arm", "base"}


def test_small_groups_are_boxes_first() -> None:
    groups = {"large": 40, "middle": 15, "small": 10}
    made = system(*(node(f"/{name}{n}", package=name) for name, number in groups.items() for n in range(number)))
    assert boxes(diagram(made)) == {"small", "middle"}
    assert boxes(diagram(made, View(expand=("small",)))) == {"middle"}


def test_of_very_many_nodes_what_is_no_node_is_one_box() -> None:
    helpers = [node(f"/helper{n}", publisher(f"/debug{n}"), caller_unknown=True, package="help") for n in range(4)]
    box = "used by an unknown node"
    assert boxes(diagram(system(*large().nodes, *helpers))) == {"arm", box}
    assert boxes(diagram(system(*large().nodes, *helpers), View(expand=("arm", "used*")))) == {"base"}
    assert box not in boxes(diagram(system(*large().nodes[:20], *helpers)))


def test_a_node_more_than_are_drawn_closes_few_groups() -> None:
    """Ten nodes' worth of the smallest, and nothing else."""
    most = [node(f"/n{n}", package=f"p{n // 4:02}") for n in range(MOST_NODES)]
    assert boxes(diagram(system(*most))) == set()
    more = [*most, node("/more", package="more")]
    assert boxes(diagram(system(*more))) == {"p00", "p01", "p02", "p03"}
    assert boxes(diagram(system(*more, node("/one_more", package="more2")))) == {"p00", "p01", "p02", "p03"}


def test_a_line_more_than_are_drawn_changes_little() -> None:
    """Ten lines' worth of what nobody takes is named in its nodes, and all else is drawn as it was."""
    talkers = [node(f"/talker{n}", publisher(f"/news{n}")) for n in range(MANY_LINES - 20)]
    few, many = diagram(system(*pairs(10), *talkers)), diagram(system(*pairs(11), *talkers))
    assert [shape.title for shape in few.shapes.values() if shape.named] == []
    assert len([shape.title for shape in many.shapes.values() if shape.named]) == 10
    assert lines(few) - lines(many) == {(f"/talker{n}", f"/news{n}") for n in (0, 1, *range(10, 18))}


def test_what_has_nobody_at_its_other_end_is_named_in_its_node() -> None:
    made = system(
        node("/a", publisher("/x"), subscriber("/y"), service("/s"), client("/c"), publisher("/both")),
        node("/b", subscriber("/both")),
        *pairs(),
    )
    drawn = diagram(made)
    assert drawn.shapes["node", "/a"].named == (
        "← no client: /s",
        "← no publisher: /y",
        "→ no server: /c",
        "→ no subscriber: /x",
    )
    assert {("/a", "/both"), ("/both", "/b")} < lines(drawn)
    assert drawn.caption[0] == f"{2 + 2 * PAIRS} nodes, {3 + PAIRS} topics, 2 services"


def test_many_of_these_are_in_rows() -> None:
    topics = [publisher(f"/a_rather_long_name_{n}") for n in range(3)]
    assert diagram(system(node("/a", *topics), *pairs())).shapes["node", "/a"].named == (
        "→ no subscriber:",
        "/a_rather_long_name_0,",
        "/a_rather_long_name_1,",
        "/a_rather_long_name_2",
    )


def test_what_these_have_in_common_is_said_once() -> None:
    names = ["/left/scan", "/a", "/left/image", "/b/scan"]
    assert diagram(system(node("/n", *map(publisher, names)), *pairs())).shapes["node", "/n"].named == (
        "→ no subscriber: /a, /b/scan,",
        "/left/{image, scan}",
    )


def test_what_is_no_node_and_tied_to_nothing_is_listed() -> None:
    helpers = [
        node(f"/helper{n}", publisher(f"/debug{n}"), caller_unknown=True, class_name=f"Helper{n}") for n in range(3)
    ]
    drawn = diagram(system(node("/a"), *helpers, *pairs()))
    [listed] = [shape for shape in drawn.shapes.values() if shape.kind == "ends"]
    assert listed.label[:3] == ("3 that are no nodes, each alone", "Helper0", "   → no subscriber: /debug0")
    assert drawn.caption[0].startswith(f"{1 + 2 * PAIRS} nodes")


def test_what_nobody_takes_and_has_a_finding_keeps_its_shape() -> None:
    wrong = node("/a", publisher("/x"))
    drawn = diagram(system(wrong, *pairs()), findings=[finding("TOP001", wrong.endpoints[0].place, "/a")])
    assert ("/a", "/x") in lines(drawn)


def test_words_on_lines_go_first() -> None:
    """Of 42 lines, those of ten topics say no more what quality of service is asked for."""
    offered, asked = Qos(reliability="reliable"), Qos(reliability="best_effort")

    def talking(number: int) -> System:
        senders = [node(f"/from{n}", publisher(f"/data{n}", qos=offered)) for n in range(number)]
        return system(*senders, *(node(f"/to{n}", subscriber(f"/data{n}", qos=asked)) for n in range(number)))

    assert len([line for line in diagram(talking(20)).lines if line.labels]) == 20
    assert len([line for line in diagram(talking(21)).lines if line.labels]) == 11


def test_a_group_that_is_expanded_has_its_nodes() -> None:
    drawn = diagram(large(), View(expand=("arm",)))
    assert boxes(drawn) == {"base"}
    assert "/arm39" in titles(drawn)


def test_all_groups_expanded() -> None:
    drawn = diagram(large(), View(expand=("*",)))
    assert not boxes(drawn)
    assert OPENED not in drawn.caption


def test_up_to_sixty_nodes_each_is_drawn() -> None:
    made = system(*(node(f"/n{n}", publisher("/x"), package=f"p{n % 2}") for n in range(MOST_NODES)))
    assert not boxes(diagram(made))


def test_a_group_of_one_node_is_no_box() -> None:
    made = system(*(node(f"/n{n}", publisher("/x"), package=f"p{max(n, 1)}") for n in range(MOST_NODES + 1)))
    assert boxes(diagram(made)) == {"p1"}


def test_words_on_a_line_of_a_crowded_picture_are_a_shape_on_it() -> None:
    made = system(
        node("/cam", publisher("/scan", qos=Qos(reliability="best_effort"))),
        node("/map", subscriber("/scan", qos=Qos(reliability="reliable"))),
        *pairs(),
    )
    assert len(diagram(made).lines) > MANY_LINES
    written = dot(made)
    words = "words_node_cam_topic_scan"
    assert f"{words} [" in written
    assert "best effort offered" in written.partition(f"{words} [")[2].partition("];")[0]
    assert f"-> {words} [" in written
    assert f"{words} -> " in written


def in_folders(packages: int) -> System:
    """Two nodes in each package, and two folders of packages."""
    return system(
        *(
            node(f"/{side}{number}", publisher(f"/x{number % 2}"), package=f"p{number}", file=file)
            for number in range(packages)
            for side in ("a", "b")
            for file in [f"src/{'sensing' if number % 2 else 'planning'}/p{number}/src/{side}.py"]
        )
    )


def test_of_very_many_packages_their_folders_are_boxes() -> None:
    assert boxes(diagram(in_folders(MOST_NODES + 1))) == {"sensing", "planning"}


def test_frames_of_folders() -> None:
    assert {*diagram(in_folders(2), View(group="folder")).frames.values()} == {"sensing", "planning"}
