"""What a reader does with the page, in a real Chromium."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from benchmarks.page.chromium import Chromium

from archlint.finding import Finding, Related, Severity
from archlint.render.page.document import page_text
from archlint.render.page.model import PageContents, PageSystem, SourceLink
from archlint.ros.qos import Qos
from archlint.systems.model import System
from render.hostile import NAMES, hostile
from render.lesson import lesson
from systems.builders import client, node, publisher, service, subscriber, system


def robot() -> System:
    """Two arms that are alike, a camera whose QoS no subscriber takes, and a node that nothing connects."""
    offered = replace(Qos(), reliability="best_effort")
    arms = [
        part
        for side in ("left", "right")
        for part in (
            node(f"/{side}/driver", publisher("state"), service("stop"), package="arm"),
            node(f"/{side}/planner", subscriber("state"), client("stop"), publisher("/goal"), package="planning"),
        )
    ]
    camera = node("/camera", publisher("/image", "sensor_msgs/msg/Image", offered), package="vision")
    viewer = node("/viewer", subscriber("/image", "sensor_msgs/msg/Image"), subscriber("/goal"), package="vision")
    return system(*arms, camera, viewer)


def finding_about(shown: System, name: str) -> Finding:
    [end] = [end for node in shown.nodes for end in node.endpoints if node.name == name and end.name == "/image"]
    return Finding("QOS001", "incompatible-qos", Severity.ERROR, "no image arrives", end.place, node=name)


class Reader:
    """Somebody in front of a page."""

    def __init__(self, browser: Chromium, file: Path) -> None:
        self.browser = browser
        self.file = file

    def opens(
        self,
        *systems: PageSystem,
        findings: tuple[Finding, ...] = (),
        fragment: str = "",
        link: SourceLink | None = None,
        collapse: tuple[str, ...] = (),
    ) -> Reader:
        self.file.write_text(page_text(PageContents(systems, findings, link, collapse=collapse)), encoding="utf-8")
        self.browser.open(self.file, fragment)
        return self

    def presses_button(self, id: str) -> None:
        self.clicks(f"document.getElementById({id!r})")

    def clicks(self, element: str) -> None:
        """With the mouse, at the middle of an element."""
        self.browser.run(f"{element}.scrollIntoView({{block: 'center'}})")
        box = self.browser.run(f"{element}.getBoundingClientRect().toJSON()")
        self.browser.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)

    def clicks_picture(self, name: str, times: int = 1) -> None:
        """On what the picture shows under a name: its place is that of the page's data and of the zoom."""
        point = self.browser.run(f"({_PLACE})({name!r})")
        self.browser.click(point["x"], point["y"], times)

    def chooses(self, id: str, value: str) -> None:
        """One of the choices of a list."""
        select = f"document.getElementById({id!r})"
        self.browser.run(f"{select}.value = {value!r}; {select}.dispatchEvent(new Event('change'))")

    def searches(self, words: str) -> None:
        self.clicks("document.getElementById('search')")
        self.browser.type(words)

    def listed(self) -> list[str]:
        rows = self.browser.run("[...document.querySelectorAll('#list .entry')].map((entry) => entry.textContent)")
        return [re.sub(r"( topic| service)?( 1 finding)?$", "", row) for row in rows]

    def text(self, id: str) -> str:
        return str(self.browser.run(f"document.getElementById({id!r}).innerText"))

    def waits_until(self, condition: str) -> bool:
        """Whether a condition of the page comes true; on a busy machine a drawing may take seconds."""
        for _ in range(200):
            if self.browser.run(condition):
                return True
            self.browser.run("new Promise((done) => setTimeout(done, 50))")
        return False

    def hears(self, words: str) -> bool:
        """Whether the browser complains in these words; what it logs may come after the answer to a command."""
        for _ in range(200):
            if any(words in complaint for complaint in self.browser.complaints()):
                return True
            self.browser.run("new Promise((done) => setTimeout(done, 50))")
        return False

    def pixels(self) -> str:
        """A picture of the canvas, to say whether something has changed."""
        self.browser.settle()
        return str(self.browser.run("document.getElementById('canvas').toDataURL()"))


_PLACE = """(name) => {
  const [system] = JSON.parse(document.getElementById('data').textContent).systems;
  const [x, y, w, h] = system.drawing.boxes[system.vertices.findIndex((vertex) => vertex.name === name)];
  const canvas = document.getElementById('canvas'), box = canvas.getBoundingClientRect();
  const [left, top] = d3.zoomTransform(canvas).apply([x + w / 2, y + h / 2]);
  return { x: box.x + left, y: box.y + top };
}"""


@pytest.fixture
def reader(chromium: Chromium, tmp_path: Path) -> Reader:
    return Reader(chromium, tmp_path / "robot.html")


@pytest.fixture
def at_robot(reader: Reader) -> Reader:
    shown = robot()
    return reader.opens(PageSystem(shown), findings=(finding_about(shown, "/camera"),))


def test_it_opens_with_everything_and_without_a_complaint(at_robot: Reader):
    assert at_robot.browser.complaints() == []
    assert len(at_robot.listed()) == 12
    assert "6 nodes, 4 topics, 2 services" in at_robot.text("status")


def test_it_asks_for_nothing_but_itself(at_robot: Reader):
    assert at_robot.browser.requests() == [at_robot.file.resolve().as_uri()]
    with pytest.raises(Exception, match="TypeError"):
        at_robot.browser.run("fetch('https://example.org/')")
    assert at_robot.hears("Content Security Policy")


def test_no_script_comes_from_a_name(reader: Reader):
    reader.opens(PageSystem(hostile()))
    reader.searches("alert")
    reader.clicks("document.querySelector('#list .entry')")
    assert reader.browser.complaints() == []
    assert "<script>alert(1)</script>" in reader.text("details")
    assert reader.browser.run("document.querySelectorAll('script').length") == 3
    assert len(NAMES) > 10


def test_a_search_leaves_what_it_finds(at_robot: Reader):
    before = at_robot.pixels()
    at_robot.searches("left planner")
    assert at_robot.listed() == ["/left/planner"]
    assert "1 match for “left planner”" in at_robot.text("status")
    assert at_robot.pixels() != before
    at_robot.browser.press("Escape")
    assert len(at_robot.listed()) == 12


def test_a_click_on_a_node_shows_its_interface(at_robot: Reader):
    at_robot.clicks_picture("/camera")
    details = at_robot.text("details")
    assert details.startswith("/camera\n")
    assert "publishes" in details
    assert "best effort, volatile, keep last 10" in details
    assert "✕ nothing gets through: best effort offered, reliable requested" in details
    assert "QOS001 error no image arrives" in details
    assert "src/vision/vision/camera.py" in details


def test_a_click_on_a_topic_shows_both_ends(at_robot: Reader):
    at_robot.clicks_picture("/goal")
    details = at_robot.text("details")
    published, subscribed = details.split("subscribed by")
    assert "/left/planner" in published
    assert "/right/planner" in published
    assert "/viewer" in subscribed
    assert "Viewer.on_message" in subscribed


def test_a_click_on_a_line_shows_both_ends(at_robot: Reader):
    point = at_robot.browser.run(_MIDDLE_OF_A_LINE)
    at_robot.browser.click(point["x"], point["y"])
    mine, other = at_robot.text("details").split("at the other end")
    assert "/camera publishes" in mine
    assert "/viewer subscribes" in other


_MIDDLE_OF_A_LINE = """(() => {
  const [system] = JSON.parse(document.getElementById('data').textContent).systems;
  const camera = system.vertices.findIndex((vertex) => vertex.name === '/camera');
  const path = system.drawing.paths[system.edges.findIndex((edge) => edge.tail === camera)];
  const canvas = document.getElementById('canvas'), box = canvas.getBoundingClientRect();
  const at = (index) => (path[index] + 3 * path[index + 2] + 3 * path[index + 4] + path[index + 6]) / 8;
  const [left, top] = d3.zoomTransform(canvas).apply([at(0), at(1)]);
  return { x: box.x + left, y: box.y + top };
})()"""


def test_a_filter_takes_away_a_package_and_what_only_it_has(at_robot: Reader):
    at_robot.clicks("[...document.querySelectorAll('#filters summary')].find((s) => s.innerText === 'Packages')")
    at_robot.clicks("[...document.querySelectorAll('#filters label')].find((l) => l.innerText.includes('vision'))")
    assert not {"/camera", "/viewer", "/image"} & set(at_robot.listed())
    assert "/goal" in at_robot.listed(), "planners publish it"
    assert "3 things hidden by filters" in at_robot.text("status")
    at_robot.presses_button("all")
    assert len(at_robot.listed()) == 12


def test_only_what_has_findings(at_robot: Reader):
    at_robot.clicks("[...document.querySelectorAll('#filters label')].find((l) => l.innerText.includes('findings'))")
    assert set(at_robot.listed()) == {"/camera", "/image", "/viewer"}


def test_groups_close_and_open(at_robot: Reader):
    before = at_robot.pixels()
    at_robot.presses_button("collapse")
    assert set(at_robot.listed()) == {"/camera", "/viewer", "/goal", "/image"}
    closed = at_robot.pixels()
    assert closed != before
    at_robot.clicks("document.querySelector('[aria-label=\"expand /left\"]')")
    assert {"/left/driver", "/left/planner", "/left/state"} <= set(at_robot.listed())
    assert at_robot.text("details").startswith("/left\n\n2 nodes")
    at_robot.presses_button("reset")
    assert len(at_robot.listed()) == 12
    assert at_robot.browser.complaints() == []


def test_a_group_that_is_closed_at_first(reader: Reader):
    reader.opens(PageSystem(robot()), collapse=("/left",))
    assert "/left/driver" not in reader.listed()
    assert "/right/driver" in reader.listed()
    reader.clicks("document.querySelector('[aria-label=\"expand /left\"]')")
    assert "/left/driver" in reader.listed()


def test_what_only_closed_groups_talk_over_is_a_line_between_them(reader: Reader):
    far = node("/base/driver", subscriber("/arm/state"))
    reader.opens(PageSystem(system(node("/arm/driver", publisher("state")), far)))
    reader.presses_button("collapse")
    reader.browser.pdf()
    words = reader.browser.run("[...document.querySelectorAll('#paper text')].map((text) => text.textContent)")
    assert words == ["/arm", "1 node", "/base", "1 node"]
    assert reader.browser.run("document.querySelectorAll('#paper path[transform]').length") == 1, "one arrow"


def test_a_large_picture_is_moved_as_it_is_and_then_painted_anew(reader: Reader):
    nodes = [node(f"/n{n}", *(publisher(f"/t{n}_{k}") for k in range(3)), package=f"p{n % 5}") for n in range(120)]
    reader.opens(PageSystem(system(*nodes)))
    before = reader.pixels()
    reader.browser.run("document.getElementById('canvas').focus()")
    reader.browser.press("ArrowLeft")
    assert reader.waits_until("document.querySelector('#moving canvas').style.transform.includes('translate(')")
    assert reader.waits_until("document.getElementById('moving').hidden"), "it is painted anew"
    assert reader.pixels() != before
    assert reader.browser.complaints() == []


def test_where_nothing_moves_nothing_is_painted(reader: Reader):
    nodes = [node(f"/n{n}", *(publisher(f"/t{n}_{k}") for k in range(3)), package=f"p{n % 5}") for n in range(120)]
    reader.opens(PageSystem(system(*nodes)))
    reader.browser.run("document.getElementById('canvas').focus()")
    reader.browser.press("ArrowLeft")
    assert reader.waits_until("document.getElementById('moving').hidden"), "it is painted anew"
    assert reader.browser.run(_WORK_WHILE_NOTHING_MOVES) == {"frames": 0, "painted": 0, "running": 0}


_WORK_WHILE_NOTHING_MOVES = """new Promise((done) => {
  const said = { frames: 0, painted: 0 }, ask = window.requestAnimationFrame;
  window.requestAnimationFrame = (work) => { said.frames += 1; return ask.call(window, work); };
  const context = CanvasRenderingContext2D.prototype, clear = context.setTransform;
  context.setTransform = function (...values) { said.painted += 1; return clear.apply(this, values); };
  setTimeout(() => done({ ...said, running: document.getAnimations().length }), 500);
})"""


@pytest.mark.parametrize("by", ["package", "none", "launched_by"])
def test_other_groups(at_robot: Reader, by: str):
    before = at_robot.pixels()
    at_robot.chooses("group", by)
    groups = at_robot.browser.run(
        "[...document.querySelectorAll('#list .group span:first-of-type')].map((e) => e.innerText)"
    )
    assert groups == (["arm", "planning", "vision"] if by == "package" else [])
    assert at_robot.pixels() != before
    assert at_robot.browser.complaints() == []


def test_a_path_goes_along_the_arrows_and_not_over_broken_connections(at_robot: Reader):
    at_robot.clicks("document.querySelector('#trace summary')")
    for field, name in (("from", "/left/driver"), ("to", "/viewer")):
        at_robot.clicks(f"document.getElementById({field!r})")
        at_robot.browser.type(name)
    at_robot.browser.press("Enter")
    steps = at_robot.browser.run("[...document.querySelectorAll('#details li')].map((step) => step.innerText)")
    assert steps == ["/left/driver", "/left/state", "/left/planner", "/goal", "/viewer"]
    at_robot.browser.run("document.getElementById('from').value = '/camera'")
    at_robot.clicks("document.querySelector('#form button')")
    assert "Nothing that the first sends gets to the second" in at_robot.text("details")


def test_only_what_is_near(at_robot: Reader):
    at_robot.clicks_picture("/camera")
    at_robot.clicks(
        "[...document.querySelectorAll('#details button')].find((b) => b.innerText === 'Only what is near')"
    )
    assert set(at_robot.listed()) == {"/camera", "/image", "/viewer"}


def test_systems_and_their_arguments(reader: Reader):
    launched = replace(lesson(), name="robot.launch.py")
    reader.opens(PageSystem(robot()), PageSystem(launched, {"sim": "true"}))
    titles = reader.browser.run("[...document.getElementById('system').options].map((option) => option.text)")
    assert titles == ["all nodes", "robot.launch.py sim:=true"]
    reader.chooses("system", "1")
    assert "/sensor_node" in reader.listed()
    assert "/camera" not in reader.listed()


def test_an_address_opens_at_a_node(reader: Reader):
    launched = replace(lesson(), name="robot.launch.py")
    reader.opens(PageSystem(robot()), PageSystem(launched), fragment="#system=robot.launch.py&show=/motor_node")
    assert reader.text("details").startswith("/motor_node\n")


def test_everything_can_be_done_with_keys(at_robot: Reader):
    at_robot.browser.run("document.body.focus()")
    at_robot.browser.press("/")
    assert at_robot.browser.run("document.activeElement.id") == "search"
    at_robot.browser.type("driver")
    at_robot.browser.press("ArrowDown")
    at_robot.browser.press("ArrowDown")
    assert at_robot.browser.run("document.activeElement.textContent") == "/right/driver"
    at_robot.browser.press("Enter")
    assert at_robot.text("details").startswith("/right/driver\n")


def test_a_screen_reader_has_names_for_all_that_can_be_used(at_robot: Reader):
    nodes: list[dict[str, Any]] = at_robot.browser.send("Accessibility.getFullAXTree")["nodes"]
    used = [
        n for n in nodes if n.get("role", {}).get("value") in ("button", "checkbox", "combobox", "textbox", "searchbox")
    ]
    assert len(used) > 20
    assert [node for node in used if not node.get("name", {}).get("value")] == []
    regions = {node["role"]["value"] for node in nodes if node.get("role")}
    assert {"main", "navigation", "complementary", "status"} <= regions


def test_dark_and_light(at_robot: Reader):
    light = at_robot.pixels()
    at_robot.browser.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    at_robot.browser.settle()
    assert at_robot.browser.run("document.documentElement.dataset.theme") == "dark"
    assert at_robot.pixels() != light
    at_robot.presses_button("theme")
    assert at_robot.browser.run("document.documentElement.dataset.theme") == "light"
    at_robot.browser.send("Emulation.setEmulatedMedia", features=[])


def test_on_paper_the_picture_is_a_drawing_of_all_that_is_shown(at_robot: Reader):
    assert at_robot.browser.pdf().startswith(b"%PDF-")
    words = at_robot.browser.run("[...document.querySelectorAll('#paper text')].map((text) => text.textContent)")
    assert {"/left/driver", "/camera", "/image", "/left"} <= set(words)
    assert at_robot.browser.complaints() == []


def test_without_places_the_page_arranges_itself(reader: Reader, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("archlint.render.page.contents.place", lambda shapes, lines: None)
    reader.opens(PageSystem(robot()))
    assert len(reader.listed()) == 12
    assert reader.browser.complaints() == []


def test_nothing_to_show(reader: Reader):
    reader.opens(PageSystem(system()))
    assert reader.browser.complaints() == []
    assert "no nodes" in reader.text("status")


def test_related_places_are_listed(reader: Reader):
    shown = robot()
    found = finding_about(shown, "/camera")
    related = Related(finding_about(shown, "/viewer").place, "it is subscribed here")
    reader.opens(PageSystem(shown), findings=(replace(found, related=(related,)),), fragment="#show=/viewer")
    assert "it is subscribed here" in reader.text("details")


@pytest.mark.parametrize(
    ("address", "leads_to"),
    [
        ("vscode://file{path}:{line}:{column}", "vscode://file/home/me/my%20ws/src/vision/vision/camera.py:6:1"),
        ("file://{path}", "file:///home/me/my%20ws/src/vision/vision/camera.py"),
        ("https://example.org/{file}#L{line}", "https://example.org/robot/src/vision/vision/camera.py#L6"),
    ],
)
def test_places_lead_to_the_source(reader: Reader, address: str, leads_to: str):
    link = SourceLink(address, "/home/me/my ws", "robot")
    reader.opens(PageSystem(robot()), fragment="#show=/camera", link=link)
    assert reader.browser.run("document.querySelector('#details a').getAttribute('href')") == leads_to


def test_a_hub_is_called_one(reader: Reader):
    spokes = [node(f"/spoke{number}", subscriber(f"/to{number}")) for number in range(8)]
    hub = node("/hub", *(publisher(f"/to{number}") for number in range(8)))
    reader.opens(PageSystem(system(hub, *spokes)), fragment="#show=/hub")
    assert "hub: 0 in, 8 out" in reader.text("details")
