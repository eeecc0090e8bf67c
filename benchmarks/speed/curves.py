"""How time and memory grow with one thing alone: so many of it, twice, four and eight times as many.

Each axis makes the files of a workspace of so many parts.  What starts and ends costs the same for any number, so the
growth that counts is that of what is added: from four to eight times as many, held against from two to four.
"""

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.speed.processes import CHECK, Cost, run

Files = Mapping[str, str]

_MANIFEST = (
    "<package format='3'><name>pkg</name><version>0.0.1</version><description>d</description>"
    "<maintainer email='kim@example.com'>Kim</maintainer><license>MIT</license>{}"
    "<export><build_type>{}</build_type></export></package>"
)
_PYTHON = (
    "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Trigger\n"
)
_CPP = '#include "rclcpp/rclcpp.hpp"\n#include "std_msgs/msg/string.hpp"\n'
_MAIN = "int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<{}>()); }}\n"
_CMAKE = "project(pkg)\nadd_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/pkg)\n"


def _each(many: int, line: str) -> str:
    return "".join(line.format(number, number + 1) for number in range(many))


def _node(body: str, outside: str = "", methods: str = "") -> Files:
    """A class of a node whose constructor has these lines."""
    indented = "".join(f"        {line}\n" for line in body.splitlines())
    head = f"{_PYTHON}{outside}class Talker(Node):\n    def __init__(self):\n        super().__init__('talker')\n"
    return {"node.py": f"{head}{indented}{methods}\nrclpy.init()\nrclpy.spin(Talker())\n"}


def _cpp(body: str, outside: str = "", more: Files | None = None, cmake: str = "") -> Files:
    """A class of a node of C++ whose constructor has these lines."""
    node = f'class Talker : public rclcpp::Node {{ public: Talker() : Node("talker") {{\n{body}\n}} }};\n'
    return {
        "pkg/package.xml": _MANIFEST.format("", "ament_cmake"),
        "pkg/CMakeLists.txt": _CMAKE + cmake,
        "pkg/src/talker.cpp": f"{_CPP}{outside}{node}{_MAIN.format('Talker')}",
        **(more or {}),
    }


def _launch(lines: str, name: str = "a.launch.xml", **more: str) -> Files:
    files = {"pkg/package.xml": _MANIFEST.format("", "ament_python"), f"pkg/launch/{name}": lines}
    return {**files, "node.py": f"{_PYTHON}rclpy.init()\nNode('a')\n", **more}


def _configured(toml: str) -> Files:
    return {**_node(_each(50, "self.create_publisher(String, 't{0}', 1)\n")), "archlint.toml": toml}


_SERVE = "self.create_service(Trigger, 's{0}', self.on_{0})\nself.c{1} = self.create_client(Trigger, 's{1}')\n"
_HANDLE = "    def on_{0}(self, request, response):\n        self.c{1}.call(request)\n        return response\n"

AXES: Mapping[str, tuple[int, Callable[[int], Files]]] = {
    "nodes with a topic each": (
        100,
        lambda n: {
            "node.py": _PYTHON
            + "rclpy.init()\n"
            + _each(n, "a = Node('n{0}')\na.create_publisher(String, 't{0}', 1)\n")
        },
    ),
    "nodes on one topic": (
        50,
        lambda n: {
            "node.py": _PYTHON
            + "rclpy.init()\n"
            + _each(
                n,
                "a = Node('n{0}')\na.create_publisher(String, 't', 1)\na.create_subscription(String, 't', print, 1)\n",
            )
        },
    ),
    "endpoints of one node": (100, lambda n: _node(_each(n, "self.create_publisher(String, 't{0}', 1)\n"))),
    "branches before an endpoint": (
        100,
        lambda n: _node(_each(n, "if self.a{0}: self.b = {0}\n") + "self.create_publisher(String, 't', 1)\n"),
    ),
    "early returns before endpoints": (
        50,
        lambda n: _node(_each(n, "if self.a{0}: return\nself.create_publisher(String, 't{0}', 1)\n")),
    ),
    "services in a chain": (25, lambda n: _node(_each(n, _SERVE), methods=_each(n, _HANDLE))),
    "services in a circle": (
        25,
        lambda n: _node(_each(n, _SERVE) + f"self.c{n} = self.c0\n", methods=_each(n, _HANDLE)),
    ),
    "parameters": (
        100,
        lambda n: _node(_each(n, "self.declare_parameter('p{0}', {0})\nself.get_parameter('p{0}').value\n")),
    ),
    "misspelt names": (
        100,
        lambda n: _node(_each(n, "speed_of_{0} = 1\n") + _each(n, "print(sped_of_{0})\n")),
    ),
    "misspelt parameters": (
        100,
        lambda n: _node(_each(n, "self.declare_parameter('speed_{0}', 1)\nself.get_parameter('sped_{0}')\n")),
    ),
    "classes, each of the one before": (
        100,
        lambda n: {
            "node.py": f"{_PYTHON}class C0(Node):\n    pass\n"
            + "".join(f"class C{k}(C{k - 1}):\n    def go{k}(self):\n        pass\n" for k in range(1, n))
            + f"rclpy.init()\nC{n - 1}('a')\n"
        },
    ),
    "methods that call the next": (
        100,
        lambda n: _node(
            "self.m0()",
            methods=_each(
                n, "    def m{0}(self):\n        self.create_publisher(String, 't{0}', 1)\n        self.m{1}()\n"
            ),
        ),
    ),
    "calls inside each other": (20, lambda n: _node("x = " + "str(" * n + "1" + ")" * n + "\n" * 5)),
    "an f-string of parts": (100, lambda n: _node("a = 1\nx = f'" + "{a}/" * n + "'\n")),
    "entries of a dict": (1000, lambda n: _node("x = {" + _each(n, "'k{0}': {0}, ") + "}\n")),
    "numbers of a table": (10_000, lambda n: _node("", outside="T = [" + "1.5, " * n + "]\n") | {}),
    "modules that import the next": (
        50,
        lambda n: {
            "node.py": f"{_PYTHON}import m0\nrclpy.init()\nNode('a')\n",
            **{f"m{k}.py": f"import rclpy\nfrom m{k + 1} import *\nx{k} = 1\n" for k in range(n)},
            f"m{n}.py": "",
        },
    ),
    "elements of a launch file": (
        100,
        lambda n: _launch("<launch>" + _each(n, "<node pkg='pkg' exec='e{0}' name='n{0}'/>") + "</launch>"),
    ),
    "remappings of a node": (
        100,
        lambda n: _launch(
            "<launch><node pkg='pkg' exec='e'>" + _each(n, "<remap from='a{0}' to='b{0}'/>") + "</node></launch>"
        ),
    ),
    "launch files that include the next": (
        10,
        lambda n: _launch(
            "<launch/>",
            **{
                f"pkg/launch/f{k}.launch.xml": f"<launch><include file='$(dirname)/f{k + 1}.launch.xml'/></launch>"
                for k in range(n)
            },
            **{f"pkg/launch/f{n}.launch.xml": "<launch/>"},
        ),
    ),
    "values of a parameter file": (
        500,
        lambda n: _launch(
            "<launch><node pkg='pkg' exec='e'><param from='$(dirname)/../config/p.yaml'/></node></launch>",
            **{"pkg/config/p.yaml": "a:\n  ros__parameters:\n" + _each(n, "    p{0}: {0}\n")},
        ),
    ),
    "aliases in YAML": (
        500,
        lambda n: _launch(
            "<launch><node pkg='pkg' exec='e'><param from='$(dirname)/../config/p.yaml'/></node></launch>",
            **{"pkg/config/p.yaml": "a:\n  ros__parameters:\n    x: &x [1, 2]\n" + _each(n, "    p{0}: *x\n")},
        ),
    ),
    "dependencies in package.xml": (
        200,
        lambda n: {
            **_launch("<launch/>"),
            "pkg/package.xml": _MANIFEST.format(_each(n, "<depend>d{0}</depend>"), "ament_python"),
        },
    ),
    "lines of CMake": (500, lambda n: _cpp("", cmake=_each(n, "set(A{0} ${{A{1}}} b)\nfind_package(p{0})\n"))),
    "C++: endpoints of one node": (
        100,
        lambda n: _cpp(_each(n, 'create_publisher<std_msgs::msg::String>("t{0}", 1);\n')),
    ),
    "C++: headers that include the next": (
        25,
        lambda n: _cpp(
            "",
            '#include "pkg/h0.hpp"\n',
            {f"pkg/include/pkg/h{k}.hpp": f'{_CPP}#include "pkg/h{k + 1}.hpp"\nstruct A{k} {{}};\n' for k in range(n)},
        ),
    ),
    "C++: classes, each of the one before": (
        100,
        lambda n: _cpp(
            "", "class C0 : public rclcpp::Node {};\n" + _each(n, "class C{1} : public C{0} {{ int a; }};\n")
        ),
    ),
    "C++: functions of one name": (50, lambda n: _cpp(_each(n, "f({0});\n"), _each(n, "void f(int a{0}) {{}}\n"))),
    "C++: a class and a source each": (
        10,
        lambda n: _cpp(
            "",
            more={
                name: text
                for k in range(n)
                for name, text in (
                    (
                        f"pkg/include/pkg/c{k}.hpp",
                        f"{_CPP}class C{k} : public rclcpp::Node {{ C{k}(); }};\n",
                    ),
                    (f"pkg/src/c{k}.cpp", f'#include "pkg/c{k}.hpp"\n{_CPP}C{k}::C{k}() : Node("c{k}") {{}}\n'),
                )
            },
        ),
    ),
    "C++: instances of a template": (
        50,
        lambda n: _cpp(
            _each(n, "make<A{0}>(this);\n"),
            _each(n, "struct A{0} {{}};\n")
            + 'template <class T> void make(rclcpp::Node * n) {n->create_publisher<std_msgs::msg::String>("t", 1); }\n',
        ),
    ),
    "C++: numbers of a table": (10_000, lambda n: _cpp("", "int t[] = {" + "1, " * n + "};\n")),
    "findings in one file": (
        50,
        lambda n: _node(_each(n, "self.c{0} = self.create_client(Trigger, 's{0}')\nself.c{0}.wait_for_service()\n")),
    ),
    "suppressions": (
        100,
        lambda n: _node(_each(n, "self.create_publisher(String, '/t{0}', 1)  # archlint: ignore[NME001]\n")),
    ),
    "patterns of files to leave out": (50, lambda n: _configured("exclude = [" + _each(n, '"a{0}/**/b*", ') + "]\n")),
    "owners": (100, lambda n: _configured("[owners]\n" + _each(n, '"/t{0}*" = "/talker"\n'))),
    "contracts": (
        25,
        lambda n: _configured(_each(n, '[[contracts]]\nname = "c{0}"\nkind = "forbid"\nfrom = "/a{0}*"\nto = "/t*"\n')),
    ),
}


@dataclass(frozen=True)
class Curve:
    """What so many parts, and twice, four and eight times as many cost."""

    name: str
    first: int
    costs: Sequence[Cost]

    @property
    def growth(self) -> float:
        """How much more CPU the last doubling adds than the one before: 2 where it is linear, 4 for a square."""
        _, before, last = (after.cpu - cost.cpu for cost, after in itertools.pairwise(self.costs))
        return last / before if before > 0 else float("nan")


def curves(names: Sequence[str], command: Sequence[str] = CHECK) -> Iterator[Curve]:
    """The curve of each axis whose name has one of some words in it; of all without any."""
    for name, (first, files) in AXES.items():
        if not names or any(word in name for word in names):
            costs = [_cost(files(first * times), command) for times in (1, 2, 4, 8)]
            yield Curve(name, first, costs)


def _cost(files: Files, command: Sequence[str]) -> Cost:
    with tempfile.TemporaryDirectory() as temporary:
        for name, text in files.items():
            path = Path(temporary, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return run([*command, "--no-cache", "--jobs", "1"], Path(temporary))
