"""Whole workspaces: made by the grammars, or those of the fixtures and the rule book."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

from hypothesis import strategies as st

from archlint.testing.pages import load_examples
from benchmarks.fuzz import cpp_nodes, files, launches, nodes, python_launches
from benchmarks.fuzz.mangling import mangled
from benchmarks.fuzz.pick import Pick, strategy
from benchmarks.fuzz.runs import Files

ROOT = Path(__file__).parents[2]
LARGEST = 60_000
"""Bytes of a fixture; what is larger takes long and says no more."""

_PLAIN: Files = {
    "package.xml": b'<package format="3"><name>robot</name><depend>rclpy</depend>'
    b"<export><build_type>ament_python</build_type></export></package>\n",
    "setup.py": b"from setuptools import setup\nsetup(name='robot', packages=['robot'],\n"
    b"      entry_points={'console_scripts': ['robot = robot.node:main']})\n",
    "archlint.toml": b"closed-world = true\n",
    "driver/package.xml": b'<package format="3"><name>driver</name><depend>rclcpp</depend>'
    b"<export><build_type>ament_cmake</build_type></export></package>\n",
    "driver/CMakeLists.txt": cpp_nodes.CMAKE,
}
"""What stands where no grammar writes."""

_GRAMMARS: tuple[tuple[str, Callable[[Pick], str], int], ...] = (
    ("robot/node.py", nodes.node, 1),
    ("robot/other.py", nodes.node, 3),
    ("driver/src/driver.cpp", cpp_nodes.node, 2),
    ("driver/include/robot/driver.hpp", cpp_nodes.header, 4),
    ("launch/robot.launch.py", python_launches.python_launch, 2),
    ("launch/robot.launch.xml", launches.xml_launch, 2),
    ("launch/robot.launch.yaml", launches.yaml_launch, 2),
    ("config/robot.yaml", files.parameter_file, 2),
    ("package.xml", files.package_xml, 5),
    ("setup.py", files.setup_py, 4),
    ("setup.cfg", files.setup_cfg, 5),
    ("CMakeLists.txt", files.cmake, 4),
    ("msg/State.msg", lambda pick: files.interface(pick, 1), 3),
    ("srv/SetMode.srv", lambda pick: files.interface(pick, 2), 4),
    ("action/Fibonacci.action", lambda pick: files.interface(pick, 3), 5),
    ("archlint.toml", files.archlint_toml, 6),
    ("pyproject.toml", files.pyproject, 8),
    (".gitignore", lambda pick: pick.among(files.IGNORE_FILES), 12),
)
"""Path, grammar, and in one of how many workspaces the file is made by it."""


def _made_up(pick: Pick) -> dict[str, bytes]:
    made = dict(_PLAIN)
    for path, grammar, one_in in _GRAMMARS:
        if pick.rarely(one_in):
            made[path] = grammar(pick).encode("utf-8", "surrogatepass")
    return made


def _with_accidents(pick: Pick, whole: Files) -> dict[str, bytes]:
    """One to three files of a workspace after accidents."""
    changed, paths = dict(whole), sorted(whole)
    others = [text for _, text in sorted(pick.among(seeds()).items())]
    for path in {pick.among(paths) for _ in range(pick.number(1, 3))} if paths else ():
        changed[path] = mangled(pick, whole[path], others)
    return changed


@cache
def seeds() -> tuple[Files, ...]:
    """The fixtures that are small, and the examples of the rule book."""
    folders = sorted(path for path in (ROOT / "fixtures").iterdir() if path.is_dir())
    fixtures = [_read(folder) for folder in folders]
    small = [whole for whole in fixtures if sum(map(len, whole.values())) < LARGEST]
    pages = [example.files for example in load_examples(ROOT / "rules")]
    return *small, *({path: text.encode() for path, text in sorted(page.items())} for page in pages)


def _read(folder: Path) -> Files:
    paths = sorted(path for path in folder.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths if path.name != "expected.toml"}


def sound() -> st.SearchStrategy[Files]:
    """Workspaces that nothing has happened to."""
    return strategy(lambda pick: pick.among(seeds()) if pick.rarely(3) else _made_up(pick))


def any_workspace() -> st.SearchStrategy[Files]:
    """Workspaces of all kinds: half of them after accidents."""

    def workspace(pick: Pick) -> Files:
        whole = pick.among(seeds()) if pick.rarely(3) else _made_up(pick)
        return _with_accidents(pick, whole) if pick.rarely(2) else whole

    return strategy(workspace)


def edited() -> st.SearchStrategy[tuple[Files, ...]]:
    """A workspace before and after one to three files are changed."""

    def pair(pick: Pick) -> tuple[Files, ...]:
        before = pick.among(seeds()) if pick.rarely(3) else _made_up(pick)
        return before, _with_accidents(pick, before)

    return strategy(pair)


def states_for(name: str) -> st.SearchStrategy[tuple[Files, ...]]:
    """What a property of that name is tried with."""
    if name == "follows_an_edit":
        return edited()
    return st.tuples(any_workspace() if name in ("keeps_its_contract", "says_the_same_again") else sound())
