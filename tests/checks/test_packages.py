"""What packages declare and install: PKG001 to PKG003."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from robot_package import CMAKE, MANIFEST, SCRIPTS, SETUP, SETUP_CFG, TALKER, node

LEFT_OVER = "remove the entry: it has no module, and no launch file starts it"
NEAREST = "write '{} = robot.talker:main': of the modules that no entry names, this one has the nearest name"
TALKER_IS_LEFT = (
    "write '{} = robot.talker:main': of the modules that no entry names, only this one has a function 'main'"
)


@pytest.mark.parametrize(
    ("entries", "message", "help"),
    [
        ("'talker == robot.talker:main'", "it has '==' instead of '='", "write 'talker = robot.talker:main'"),
        (
            "'talker == robot.robot.talker:main'",
            "it has '==' instead of '=', and module 'robot.robot.talker' does not exist",
            "write 'talker = robot.talker:main'",
        ),
        (
            "'talker == robot.b:main'",
            "it has '==' instead of '=', and module 'robot.b' does not exist",
            "write 'talker = robot.talker:main'",
        ),
        (
            "'talker = robot.talker:main' 'other = robot.talker:main'",
            "a comma is missing between 'talker' and 'other'; newer setuptools stop the build here",
            "write 'talker = robot.talker:main',",
        ),
    ],
)
def test_an_entry_that_is_not_of_the_form_is_told_once(findings, entries, message, help):
    setup = SETUP.replace("'talker = robot.talker:main'", entries)
    (found,) = findings("PKG002", **{"setup.py": setup})
    assert found.message == f"this entry does not install an executable 'talker': {message}"
    assert (found.help, found.place.line) == (help, 6)
    assert findings("LCH001", node(exec="talker"), **{"setup.py": setup}) == []
    assert findings("LCH001", node(exec="listener"), **{"setup.py": setup}) != []


@pytest.mark.parametrize(
    ("target", "what"),
    [
        ("robot.talker", "'robot.talker' is a module, but the entry names no function in it"),
        ("robot.talker.main", "module 'robot.talker.main' does not exist; did you mean 'robot.talker:main'?"),
        ("robot.tatalker", "module 'robot.tatalker' does not exist; did you mean 'robot.talker'?"),
    ],
)
def test_an_entry_without_a_function(findings, target, what):
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace("robot.talker:main", target)})
    assert found.message == f"the executable 'talker' cannot start: {what}"


def test_an_entry_without_a_function_for_a_module_that_runs_when_it_is_imported(findings):
    files = {"setup.py": SETUP.replace("robot.talker:main", "robot.talker"), "robot/talker.py": TALKER + "\nmain()\n"}
    assert findings("PKG002", **files) == []


PACKAGED = SETUP.replace("robot.talker:main", "talker:main").replace("    name=", "    packages=['robot'],\n    name=")


def test_an_entry_without_the_package_around_its_module(findings):
    (found,) = findings("PKG002", **{"setup.py": PACKAGED, "robot/__init__.py": ""})
    assert found.message.endswith("module 'talker' does not exist; did you mean 'robot.talker'?")
    assert (found.help, found.place.line) == ("write 'talker = robot.talker:main'", 7)


@pytest.mark.parametrize("more", ["package_dir={'': 'robot'}", "py_modules=['talker']"])
def test_a_module_that_is_installed_without_its_package(findings, more):
    setup = PACKAGED.replace("    name=", f"    {more},\n    name=")
    assert findings("PKG002", **{"setup.py": setup, "robot/__init__.py": ""}) == []


def test_a_setup_py_that_nobody_runs_breaks_nothing(findings):
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE}
    assert findings("PKG002", **files, **{"setup.py": SETUP.replace("robot.talker", "robot.gone")}) == []


def test_entry_points_of_other_distributions(findings):
    setup = SETUP.replace("'talker = robot.talker:main'", "'talker = robot.talker:main', 'serve = uvicorn.main:run'")
    assert findings("PKG002", **{"setup.py": setup}) == []


def test_the_entry_of_a_package_that_was_renamed(findings):
    setup = SETUP.replace("robot.talker:main", "old_robot.talker:main")
    (found,) = findings("PKG002", **{"setup.py": setup})
    assert found.message.endswith("module 'old_robot.talker' does not exist; did you mean 'robot.talker'?")
    assert (found.help, found.place.line) == ("write 'talker = robot.talker:main'", 6)


@pytest.mark.parametrize(
    ("imported", "help"),
    [
        ("old_robot.words", "rename the folder 'robot' to 'old_robot', as which its own code imports it"),
        ("robot.words", "write 'talker = robot.talker:main'"),
        ("old_robot.msg", "write 'talker = robot.talker:main'"),  # no module of the folder
    ],
)
def test_a_folder_whose_code_has_the_name_of_the_entry(findings, imported: str, help: str):
    setup = SETUP.replace("robot.talker:main", "old_robot.talker:main")
    files = {"robot/talker.py": f"from {imported} import HELLO\n{TALKER}", "robot/words.py": "HELLO = 'hello'\n"}
    (found,) = findings("PKG002", **{"setup.py": setup, **files})
    assert found.help == help
    listed = setup.replace("    name='robot',\n", "    name='robot',\n    packages=['old_robot'],\n")
    told = findings("PKG002", **{"setup.py": listed, **files})
    assert len(told) == (0 if help.startswith("rename") else 1)  # PKG004 has it, then


@pytest.mark.parametrize(
    "target",
    [
        "old_robot.driver:main",  # no module of this package
        "old_robot.talker:run",  # nor a function of it
        "tf2_ros.talker:main",  # a package of ROS
        "serial.talker:main",  # a module that rosdep knows
        "email.talker:main",  # one of Python's own
    ],
)
def test_the_entry_of_a_module_that_may_be_elsewhere(findings, target):
    assert findings("PKG002", **{"setup.py": SETUP.replace("robot.talker:main", target)}) == []


def test_a_module_beside_the_python_package_is_not_in_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    setup = SETUP.replace("robot.talker:main", "robot.scripts.talker:main")
    texts = {"robot/__init__.py": "", "robot/driver.py": TALKER, "scripts/talker.py": TALKER, "setup.py": setup}
    texts["package.xml"] = MANIFEST.format(name="robot", type="ament_python", more="")
    for name, text in texts.items():  # scripts/talker.py ends like the module's name only with the package's folder
        (tmp_path / "src/robot" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "src/robot" / name).write_text(text)
    (tmp_path / "archlint.toml").write_text('select = ["PKG002"]')
    (found,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert "module 'robot.scripts.talker' does not exist" in found.message


@pytest.mark.parametrize(
    ("beside", "hint"),
    [
        ({"robot/planer.py": TALKER}, "; did you mean 'robot.planer'?"),
        ({"robot/planer.py": "from robot.planner import main\n"}, ""),  # it needs the missing one, too
        ({"scripts/planner.py": "from robot.planner import main\n"}, ""),
        ({"scripts/planner.py": TALKER}, ""),  # nothing installs it
    ],
)
def test_a_module_that_may_have_been_meant(findings, beside: dict[str, str], hint: str):
    entries = "'talker = robot.talker:main', 'planner = robot.planner:main'"
    setup = SETUP.replace("'talker = robot.talker:main'", entries)
    (found,) = findings("PKG002", **{"setup.py": setup}, **beside)
    assert found.message == f"the executable 'planner' cannot start: module 'robot.planner' does not exist{hint}"


def test_a_module_that_gitignore_hides_is_there(findings):
    files = {"setup.py": SETUP.replace("robot.talker", "robot.bags"), ".gitignore": "bags*\n", "robot/bags.py": TALKER}
    assert findings("PKG002", **files) == []
    (found,) = findings("PKG002", **files | {"setup.py": SETUP.replace("robot.talker", "robot.boxes")})
    assert "'robot.boxes' does not exist" in found.message


def test_a_module_of_a_submodule_that_is_not_checked_out_is_not_known(findings):
    missing = {"setup.py": SETUP.replace("robot.talker", "robot.vision.detector")}
    submodule = {".gitmodules": '[submodule "v"]\n\tpath = robot/vision\n\turl = https://example.org/v\n'}
    assert findings("PKG002", **missing, **submodule) == []
    (beside,) = findings("PKG002", **missing, **{key: v.replace("vision", "sound") for key, v in submodule.items()})
    assert "'robot.vision.detector' does not exist" in beside.message
    (checked_out,) = findings("PKG002", **missing, **submodule, **{"robot/vision/__init__.py": ""})
    assert "'robot.vision.detector' does not exist" in checked_out.message


@pytest.mark.parametrize(
    ("needs", "circles"),
    [
        ("<exec_depend>arm</exec_depend>", 1),
        ('<exec_depend condition="$ROS_VERSION == 1">arm</exec_depend>', 0),
        ('<exec_depend condition="$BUILD == hardware">arm</exec_depend>', 0),  # only the machine that builds knows
        ("<test_depend>arm</test_depend>", 0),
    ],
)
def test_what_makes_a_circle(tmp_path, monkeypatch, needs, circles):
    monkeypatch.chdir(tmp_path)
    for name, more in (("robot", needs), ("arm", "<exec_depend>robot</exec_depend>")):
        (tmp_path / name).mkdir()
        manifest = MANIFEST.format(name=name, type="ament_python", more=more)
        (tmp_path / name / "package.xml").write_text(manifest, encoding="utf-8")
    (tmp_path / "robot" / "talker.py").write_text(TALKER, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["PKG003"]', encoding="utf-8")
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == circles


@pytest.mark.parametrize(
    ("needs", "place", "message"),
    [
        pytest.param(
            {"arm": ["lib"], "leg": ["lib"], "lib": ["arm", "leg"]},
            "lib/package.xml",
            "'lib' and 2 others depend on each other in circles: arm, leg",
            id="all circles lead through one package",
        ),
        pytest.param(
            {"arm": ["lib"], "lib": ["leg"], "leg": ["arm"]},
            "leg/package.xml",
            "packages depend on each other in a circle: leg → arm → lib → leg",
            id="at what only running needs",
        ),
    ],
)
def test_one_finding_for_what_one_edit_mends(tmp_path, monkeypatch, needs, place, message):
    monkeypatch.chdir(tmp_path)
    for name, others in needs.items():
        (tmp_path / name).mkdir()
        kind = "exec_depend" if name == "leg" else "depend"
        more = "".join(f"\n  <{kind}>{other}</{kind}>" for other in others)
        manifest = MANIFEST.format(name=name, type="ament_python", more=more)
        (tmp_path / name / "package.xml").write_text(manifest, encoding="utf-8")
        (tmp_path / name / "talker.py").write_text(TALKER, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["PKG003"]', encoding="utf-8")
    [circle] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert (circle.place.file, circle.message) == (place, message)
    assert len(circle.related) == (3 if "lib" in circle.place.file else 2)


def test_a_circle_is_suppressed_where_a_manifest_closes_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("arm", "robot"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "talker.py").write_text(TALKER, encoding="utf-8")
    arm = MANIFEST.format(name="arm", type="ament_python", more="<depend>robot</depend>")
    (tmp_path / "arm" / "package.xml").write_text(arm, encoding="utf-8")
    more = "\n  <!-- archlint: ignore[PKG003] until June -->\n  <exec_depend>arm</exec_depend>"
    manifest = MANIFEST.format(name="robot", type="ament_python", more=more)
    (tmp_path / "robot" / "package.xml").write_text(manifest, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["PKG003", "LNT001"]', encoding="utf-8")
    assert check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings == []
    (tmp_path / "robot" / "package.xml").write_text(
        manifest.replace("<exec_depend>arm</exec_depend>", ""), encoding="utf-8"
    )
    unused = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [(one.code, one.place.file) for one in unused] == [("LNT001", "robot/package.xml")]


def test_a_node_action_without_a_package_needs_none(findings):
    assert findings("PKG001", '<node pkg="" exec="talker"/>') == []


@pytest.mark.parametrize(
    ("target", "words", "help"),
    [
        (
            "robot.tlker",
            "module 'robot.tlker' does not exist; did you mean 'robot.talker'?",
            "write 'tower = robot.talker:main'",
        ),
        ("robot.b", "module 'robot.b' does not exist", LEFT_OVER),
        (
            "robot.robot_arm_talker",
            "module 'robot.robot_arm_talker' does not exist; did you mean 'robot.talker'?",
            "write 'tower = robot.talker:main'",
        ),
        ("robot.robot_a", "module 'robot.robot_a' does not exist", LEFT_OVER),
        (
            "robt.talker",
            "module 'robt.talker' does not exist; did you mean 'robot.talker'?",
            "write 'tower = robot.talker:main'",
        ),
    ],
)
def test_a_module_that_is_not_there_is_named_with_the_near_one(findings, target, words, help):
    (found,) = findings(
        "PKG002", **{"setup.py": SETUP.replace("talker = robot.talker:", f"tower = {target}:"), "robot/a.py": ""}
    )
    assert found.message.endswith(f": {words}")
    assert found.help == help


@pytest.mark.parametrize(("text", "said"), [("", False), ("def main():\n    print('on')\n", True)])
def test_a_module_without_the_function_is_not_the_one_that_was_meant(findings, text: str, said: bool):
    entry = SETUP.replace("talker = robot.talker:main", "tower = robot.visualizer:main")
    (found,) = findings("PKG002", **{"setup.py": entry, "robot/visualiser.py": text})
    assert ("did you mean 'robot.visualiser'?" in found.message) == said
    assert found.help == ("write 'tower = robot.visualiser:main'" if said else LEFT_OVER)


@pytest.mark.parametrize(
    ("text", "said"), [("def main():\n    print(1)\n", True), ("def run():\n    main = 1\n", False)]
)
def test_the_module_with_the_name_of_the_executable_was_meant(findings, text: str, said: bool):
    """The entry is a copy of one of another program, with its own name alone put in."""
    entry = SETUP.replace("talker = robot.talker:main", "tuner = robot.publisher:main")
    (found,) = findings("PKG002", **{"setup.py": entry, "robot/tuner.py": text})
    assert ("did you mean 'robot.tuner'?" in found.message) == said
    assert found.help == ("write 'tuner = robot.tuner:main'" if said else LEFT_OVER)


WALKER = "def main():\n    print('on')\n"


@pytest.mark.parametrize(
    ("entry", "files", "entries", "help"),
    [
        ("tower = robot.gone_talker_of_may", {}, "", TALKER_IS_LEFT.format("tower")),
        ("talker_demo = robot.gone", {}, "", TALKER_IS_LEFT.format("talker_demo")),
        ("tower = robot.gone_since_may", {}, "", LEFT_OVER),
        ("tower = robot.gone_since_may", {"robot/talker.py": f"{WALKER}#tower\nTOWER = 'tower'\n"}, "", "tower"),
        ("tower = robot.gone_talker_of_may", {"robot/walker.py": WALKER}, "", NEAREST.format("tower")),
        ("tower = robot.gone_talker_of_may", {"robot/talker_of_june.py": WALKER}, "", LEFT_OVER),
        ("tower = robot.gone_talker_of_may", {}, ", 'talker = robot.talker:main'", LEFT_OVER),
        ("tower = robot.gone_talker_of_may", {"robot/talker.py": WALKER.replace("main", "talk")}, "", LEFT_OVER),
    ],
    ids=[
        "its module is like it",
        "its name is like it",
        "nothing is like it",
        "its code names it",
        "of two one is like it",
        "two are like it",
        "another entry names it",
        "it has no such function",
    ],
)
def test_the_module_left_that_has_the_function(findings, entry: str, files: dict[str, str], entries: str, help: str):
    name, module = entry.split(" = ")
    setup = SETUP.replace("'talker = robot.talker:main'", f"'{entry}:main'{entries}")
    (found,) = findings("PKG002", **{"setup.py": setup, **files})
    assert (found.message, found.help) == (
        f"the executable '{name}' cannot start: module '{module}' does not exist",
        TALKER_IS_LEFT.format(help) if help == name else help,
    )


def test_two_modules_are_left_for_two_entries(findings):
    entries = "'picture_maker = robot.picture_maker:main', 'camera_sender = robot.camera_sender:main'"
    setup = SETUP.replace("'talker = robot.talker:main'", entries)
    found = findings("PKG002", **{"setup.py": setup, "robot/picture_all.py": WALKER, "robot/camera_all.py": WALKER})
    assert [one.help for one in found] == [
        f"write '{name} = robot.{module}:main': of the modules that no entry names, this one has the nearest name"
        for name, module in (("picture_maker", "picture_all"), ("camera_sender", "camera_all"))
    ]
    same = {"robot/camera_all.py": WALKER, "robot/talker.py": ""}
    found = findings("PKG002", **{"setup.py": setup.replace("picture", "camera"), **same})
    assert not any("nearest name" in (one.help or "") or "only this one" in (one.help or "") for one in found)


def test_what_the_only_module_left_is_named_for_where_the_module_has_no_function_at_all(findings):
    setup = SETUP.replace("robot.talker:main", "robot.sizes:main")
    (found,) = findings("PKG002", **{"setup.py": setup, "robot/sizes.py": "WIDTH = 0.4\n"})
    assert found.message == "the executable 'talker' cannot start: 'robot.sizes' has no function 'main'"
    assert found.help == TALKER_IS_LEFT.format("talker")


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        ("def main():\n    print('on')\n", []),
        ("", ["the executable 'talker' cannot start: 'robot' has no function 'main'"]),
    ],
)
def test_an_entry_may_name_the_module_of_a_package_in_full(findings, text: str, messages: list[str]):
    """Python imports ``robot.__init__`` as a module of its own, made of the same file."""
    setup = SETUP.replace("robot.talker:main", "robot.__init__:main")
    found = findings("PKG002", **{"setup.py": setup, "robot/__init__.py": text})
    assert [one.message for one in found] == messages


def test_the_only_module_of_that_name_in_another_folder_was_meant(findings):
    """The folder has been renamed since: the entry is no leftover."""
    setup = SETUP.replace("talker = robot.talker:main", "bridge = robot.environments.utils.bridge:main")
    setup = setup.replace("['robot']", "['robot', 'robot.envs']")
    below = {f"robot/{path}": "" for path in ("envs/__init__.py", "envs/utils/__init__.py", "tools/__init__.py")}
    bridge = {"robot/envs/utils/bridge.py": "def main():\n    print('on')\n"}
    (found,) = findings("PKG002", **{"setup.py": setup}, **below, **bridge)
    assert found.message.endswith("; did you mean 'robot.envs.utils.bridge'?")
    assert found.help == "write 'bridge = robot.envs.utils.bridge:main'"
    (found,) = findings(
        "PKG002", **{"setup.py": setup}, **below, **bridge, **{"robot/tools/bridge.py": "def main(): 1"}
    )
    assert found.help == LEFT_OVER


def test_two_entries_are_not_said_to_mean_one_module(findings):
    entries = "'camera_goal = robot.camera_goal:main', '3_nav_to_goal = robot.3_nav_to_goal:main'"
    setup = SETUP.replace("'talker = robot.talker:main'", entries)
    near, left_over = findings("PKG002", **{"setup.py": setup, "robot/goal.py": "def main():\n    print('on')\n"})
    assert (near.identity[1], near.help) == ("camera_goal", "write 'camera_goal = robot.goal:main'")
    assert (left_over.identity[1], left_over.help) == ("3_nav_to_goal", LEFT_OVER)


def test_a_module_that_a_launch_file_wants_may_be_added(findings):
    setup = SETUP.replace("talker = robot.talker:", "tower = robot.b:")
    (found,) = findings("PKG002", node(exec="tower"), **{"setup.py": setup})
    assert found.help == "add the module, or remove the entry"


@pytest.mark.parametrize(("entry_points", "place"), [(True, ("setup.py", 6)), (False, ("setup.cfg", 7))])
def test_entries_of_setup_cfg_count_where_setup_is_given_none(findings, entry_points: bool, place):
    table = SETUP_CFG + "[options.entry_points]\nconsole_scripts =\n    talker = robot.b:main\n"
    setup = SETUP.replace("robot.talker", "robot.b") if entry_points else "from setuptools import setup\nsetup()\n"
    (found,) = findings("PKG002", **{"setup.py": setup, "setup.cfg": table})
    assert (found.place.file, found.place.line) == place


def test_a_module_that_another_entry_starts_is_not_the_one_that_was_meant(findings):
    entries = "'talker = robot.talker:main', 'second = robot.talkers:main'"
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace("'talker = robot.talker:main'", entries)})
    assert found.message == "the executable 'second' cannot start: module 'robot.talkers' does not exist"
    assert found.help == LEFT_OVER
    (alone,) = findings("PKG002", **{"setup.py": SETUP.replace("robot.talker:main", "robot.talkers:main")})
    assert alone.message.endswith("; did you mean 'robot.talker'?")


def test_a_function_that_is_not_there_is_to_be_written_or_another_named(findings):
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace(":main", ":mian")})
    assert found.help == "write 'talker = robot.talker:main'"
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace(":main", ":serve_all")})
    assert found.help == "define 'serve_all' in the module, or use a function that it has"


@pytest.mark.parametrize(
    "text",
    [
        "while True:\n    print()\n",
        "while True:\n    for key in 'ab':\n        break\n",
        "try:\n    while True:\n        print()\nfinally:\n    print()\n",
        "with open('a') as log:\n    while True:\n        log.flush()\n",
    ],
)
def test_a_module_that_never_comes_to_its_end_is_asked_for_no_function(findings, text):
    assert findings("PKG002", **{"robot/talker.py": text}) == []


LOOK = "import cv2\ncamera = cv2.VideoCapture(0)\nwhile True:\n    if cv2.waitKey(1) == 113:\n        break\n"


@pytest.mark.parametrize(
    "text",
    [
        LOOK,
        "import rclpy\nrclpy.init()\nrclpy.spin(rclpy.create_node('look'))\n",
        "try:\n    while True:\n        pass\nexcept KeyboardInterrupt:\n    pass\n",
        "while True:\n    for key in 'ab':\n        print()\n    else:\n        break\n",
        "import os\nfor name in ('a', 'b'):\n    os.system(name)\n",
        "import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()\n",
        "import tkinter\nroot = tkinter.Tk()\nroot.mainloop()\n",
        "import rclpy\nrclpy.init()\nrclpy.create_node('look').get_logger().info('here')\nrclpy.shutdown()\n",
    ],
    ids=[
        "a loop",
        "a spin",
        "a loop inside",
        "a loop that another one leaves",
        "a loop over what to start",
        "a plot",
        "a window",
        "all from the start of rclpy to its end",
    ],
)
def test_a_module_that_does_its_work_when_it_is_imported_fails_at_its_end(findings, text):
    (found,) = findings("PKG002", **{"robot/talker.py": text})
    assert found.message == (
        "the executable 'talker' fails when its work is done: 'robot.talker' runs when it is imported and has no "
        "function 'main'"
    )
    assert found.help == "move what the module runs into a function 'main'"
    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("from http.server import HTTPServer\nhttpd = HTTPServer(('', 8000), None)\nhttpd.serve_forever()\n", 0),
        ("from flask import Flask\napp = Flask('page')\napp.run(port=5000)\n", 0),
        ("from tasks import job\njob.run()\n", 1),
        ("from http.server import HTTPServer\ndef serve(httpd):\n    httpd.serve_forever()\n", 1),
        ("from flask import Flask\napp = Flask('page')\nif __name__ == '__main__':\n    app.run()\n", 1),
    ],
)
def test_a_module_that_serves_when_it_is_imported_does_start(findings, text: str, told: int):
    assert len(findings("PKG002", **{"robot/talker.py": text})) == told


@pytest.mark.parametrize(
    "text",
    [
        "import rclpy\nrclpy.init()\n",
        "import matplotlib.pyplot as plt\ndef look():\n    plt.show()\n",
        "from app import Look\nif __name__ == '__main__':\n    Look().mainloop()\n",
    ],
)
def test_a_module_that_does_nothing_of_its_work_when_it_is_imported_cannot_start(findings, text):
    (told,) = findings("PKG002", **{"robot/talker.py": text})
    assert told.message.startswith("the executable 'talker' cannot start: ")


DRIVER = "class Driver:\n    def init(self, webots_node, properties):\n        pass\n"
DESCRIPTION = '<robot name="r">\n  <webots>\n    {}\n  </webots>\n</robot>\n'


@pytest.mark.parametrize(
    ("line", "severity", "help"),
    [
        (
            '<plugin type="robot.talker.Driver"/>',
            Severity.INFO,
            "remove the entry: Webots loads 'robot.talker.Driver' by its class, without an executable",
        ),
        (
            '<plugin type="robot.other.Driver"/>',
            Severity.ERROR,
            "define 'main' in the module, or remove the entry: it has no function at all",
        ),
        (
            '<!-- <plugin type="robot.talker.Driver"/> -->',
            Severity.ERROR,
            "define 'main' in the module, or remove the entry: it has no function at all",
        ),
    ],
)
def test_a_plugin_of_webots_needs_no_entry(findings, line: str, severity: Severity, help: str):
    (found,) = findings("PKG002", **{"robot/talker.py": DRIVER, "resource/r.urdf": DESCRIPTION.format(line)})
    assert (found.severity, found.help) == (severity, help)
    places = [(row.place.file, row.place.line, row.place.column) for row in found.related]
    assert places == ([("resource/r.urdf", 3, 19)] if severity is Severity.INFO else [])


@pytest.mark.parametrize(
    "text",
    [
        "def look():\n    while True:\n        pass\n",
        "if __name__ == '__main__':\n    while True:\n        pass\n",
        "import logging\nlogging.basicConfig()\n",
        "names = []\nfor name in ('a', 'b'):\n    names += [name]\n",
    ],
    ids=["in a function", "as a script only", "a call that ends", "a loop that lists names"],
)
def test_a_module_that_does_nothing_when_it_is_imported_cannot_start(findings, text):
    (found,) = findings("PKG002", **{"robot/talker.py": text})
    assert found.message == "the executable 'talker' cannot start: 'robot.talker' has no function 'main'"
    assert found.severity is Severity.ERROR


@pytest.mark.parametrize(
    ("text", "help"),
    [
        ("RED = 1\nBLUE = 2\n", "remove the entry: 'robot.talker' defines no function"),
        ("def serve(): pass\n", "write 'talker = robot.talker:serve'"),
        ("def help(): pass\ndef main(): pass\n", "write 'talker = robot.talker:main'"),
        ("def open(): pass\ndef close(): pass\n", "write 'talker = robot.talker:function'"),
        ("from robot.driver import main\n", "write 'talker = robot.talker:main'"),
        ("from robot.driver import serve\n", "remove the entry: 'robot.talker' defines no function"),
        ("from robot.driver import *\n", "write 'talker = robot.talker:function'"),
    ],
)
def test_an_entry_without_a_function_gets_the_one_that_is_there(findings, text, help):
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace(":main", ""), "robot/talker.py": text})
    assert found.help == help


def test_entries_of_modules_without_any_function_are_one_finding(findings):
    setup = SETUP.replace("'talker = robot.talker:main'", "'talker = robot.talker', 'left = robot.left'")
    files = {"setup.py": setup, "robot/talker.py": "from abc import abstractmethod\nclass Talker: pass\n"}
    (found,) = findings("PKG002", **files, **{"robot/left.py": "class Left: pass\n"})
    assert found.message == "2 executables cannot start: their modules define no function at all: talker, left"
    assert found.help == "remove these entries"
    other = findings("PKG002", **files, **{"robot/left.py": "def main(): pass\n"})
    assert [one.help for one in other] == [
        "remove the entry: 'robot.talker' defines no function",
        "write 'left = robot.left:main'",
    ]


def test_entries_whose_modules_are_not_there_are_one_finding(findings):
    entries = "'talker = robot.talker:main', 'left = robot.arms.l:main', 'right = robot.arms.r:main'"
    files = {"setup.py": SETUP.replace("'talker = robot.talker:main'", entries)}
    (found,) = findings("PKG002", **files)
    assert found.message == "2 executables cannot start: their modules do not exist: left, right"
    assert (
        found.help == "remove the entries: they have no modules, and no launch file starts them"
        and len(found.related) == 1
    )
    (found,) = findings("PKG002", **files, **{"robot/arms/l.py": "def main():\n    pass\n"})
    assert "'robot.arms.r' does not exist" in found.message


def test_a_module_of_ros1_needs_more_than_a_function(findings):
    setup = SETUP.replace("'talker = robot.talker:main'", "'talker = robot.talker:main', 'left = robot.left:main'")
    files = {"setup.py": setup, "robot/talker.py": "import rospy\n", "robot/left.py": "import rospy\n"}
    (found,) = findings("PKG002", **files)
    assert found.message == "2 executables cannot start: their modules have no function 'main': talker, left"
    assert found.help == "port the module to ROS 2, which has no rospy, or remove the entry"


def test_entries_whose_modules_lack_one_function_are_one_finding(findings):
    entries = "'talker = robot.talker:main', 'left = robot.left:main', 'right = robot.right:main'"
    setup = SETUP.replace("'talker = robot.talker:main'", entries)
    files = {"setup.py": setup, "robot/left.py": "", "robot/right.py": ""}
    (found,) = findings("PKG002", **files)
    assert found.message == "2 executables cannot start: their modules have no function 'main': left, right"
    assert [one.message for one in found.related] == ["the entry of 'right'"]
    (found,) = findings("PKG002", **files | {"robot/right.py": "def main():\n    pass\n"})
    assert found.message == "the executable 'left' cannot start: 'robot.left' has no function 'main'"


ASYNC = TALKER.replace("def main():", "async def main():")


def test_a_console_script_that_is_an_async_def(findings):
    """The script says `sys.exit(main())`: what it exits with is a coroutine that never runs."""
    (told,) = findings(
        "PKG002", **{"robot/talker.py": ASYNC + "\nif __name__ == '__main__':\n    asyncio.run(main())\n"}
    )
    assert told.place.file == "setup.py"
    assert "'main' of 'robot.talker' is an async def" in told.message
    assert told.help == "name a function in the entry that calls asyncio.run(main())"
    assert [related.place.line for related in told.related] == [11]


@pytest.mark.parametrize(
    "talker",
    [
        ASYNC.replace("async def main", "@run\nasync def main"),
        ASYNC + "\n\nmain = sync(main)\n",
        ASYNC + "\n\ntry:\n    import asyncio\nexcept ImportError:\n    def main():\n        pass\n",
        ASYNC + "\n\ntry:\n    asyncio.run(main())\nexcept KeyboardInterrupt:\n    pass\n",
        ASYNC.replace("async def main", "async def run") + "\n\ndef main():\n    asyncio.run(run())\n",
    ],
)
def test_a_console_script_that_runs_its_coroutine(findings, talker: str):
    assert findings("PKG002", **{"robot/talker.py": talker}) == []
