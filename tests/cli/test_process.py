"""archlint as a process: pipes, signals, and how little is imported."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

SRC = Path(__file__).parents[2] / "src"
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, '/bad name', 10)
"""
HEAVY = {"libcst", "networkx", "rich", "msgspec", "graphviz", "pygraphviz", "yaml"}


def environment(**more: str) -> dict[str, str]:
    kept = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "FORCE_COLOR")}
    return {**kept, "PYTHONPATH": str(SRC), **more}


def python(*arguments: str, cwd: Path, **more: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, *arguments]
    return subprocess.run(command, cwd=cwd, env=environment(**more), capture_output=True, text=True, check=False)


def imported(cwd: Path, *arguments: str) -> set[str]:
    """The packages that a command imports."""
    code = (
        "import sys; from archlint.cli import main; status = main(sys.argv[1:]); sys.stdout.flush(); "
        "print(' '.join({name.partition('.')[0] for name in sys.modules}), file=sys.stderr); sys.exit(status)"
    )
    done = python("-c", code, *arguments, cwd=cwd)
    assert done.returncode in (0, 1), done.stderr
    return set(done.stderr.splitlines()[-1].split())


@pytest.fixture
def node(tmp_path: Path) -> Path:
    path = tmp_path / "talker.py"
    path.write_text(NODE)
    past = path.stat().st_mtime_ns - 100 * 10**9  # old enough that its time can be trusted
    os.utime(path, ns=(past, past))
    return path


@pytest.mark.parametrize("arguments", [["--version"], ["--help"], ["explain", "SRV003"], ["rules"], ["config"]])
def test_small_commands_import_nothing_heavy(tmp_path: Path, arguments: list[str]):
    assert not HEAVY & imported(tmp_path, *arguments)


def test_a_run_on_an_unchanged_workspace_imports_nothing_heavy(node: Path):
    assert "libcst" in imported(node.parent, "check")
    for format in ("text", "concise", "json", "sarif"):
        # msgspec reads the result that was kept: 10 ms, for findings whose types are checked.
        assert HEAVY & imported(node.parent, "check", "--format", format) <= {"msgspec"}, format


@pytest.mark.skipif(os.name == "nt", reason="answers are kept where the time of a status change is one")
@pytest.mark.parametrize("arguments", [["check"], ["graph", "--format", "json"]], ids=" ".join)
def test_what_was_answered_before_is_answered_before_anything_is_imported(node: Path, arguments: list[str]):
    trusting = "import archlint.engine.keeper as keeper; keeper.RACY_NS = -10**18\n"  # all here has just been made
    python("-c", f"{trusting}from archlint.cli import main; main({arguments})", cwd=node.parent)
    allowed = {"errno", "archlint", "gc"}
    assert imported(node.parent, *arguments) - imported_by_nothing(node.parent) <= allowed


def imported_by_nothing(cwd: Path) -> set[str]:
    """The packages that Python imports by itself, and those of the interpreter itself."""
    done = python("-c", "import sys; print(*{name.partition('.')[0] for name in sys.modules})", cwd=cwd)
    return {*done.stdout.split(), *sys.builtin_module_names, "_blake2", "__future__"}


def test_no_check_imports_what_only_drawings_need(node: Path):
    assert not {"networkx", "graphviz", "pygraphviz"} & imported(node.parent, "check", "--no-cache")


def test_it_runs_as_a_module(node: Path):
    done = python("-m", "archlint", "--format", "json", cwd=node.parent)
    assert (done.returncode, done.stderr) == (1, "")
    assert {one["file"] for one in json.loads(done.stdout)["diagnostics"]} == {"talker.py"}


def test_as_a_module_it_runs_nothing_of_the_folder_that_it_checks(node: Path):
    for module in ("yaml", "msgspec", "json", "tomllib", "argparse"):
        (node.parent / f"{module}.py").write_text("import os; os._exit(77)\n")
    (node.parent / "system.launch.yaml").write_text("launch: []\n")
    assert python("-m", "archlint", "check", "--no-cache", cwd=node.parent).returncode == 1


def test_a_pipe_gets_no_colours_and_no_cursor_control(node: Path):
    assert "\x1b" not in python("-m", "archlint", "check", cwd=node.parent).stdout


def test_a_reader_that_goes_away_ends_it_quietly(tmp_path: Path):
    command = [sys.executable, "-m", "archlint", "rules", "--format", "json"]
    process = subprocess.Popen(command, cwd=tmp_path, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None and process.stderr is not None
    process.stdout.close()
    told = process.stderr.read()
    process.stderr.close()
    assert (process.wait(timeout=30), told) == (141, b"")


def _children(process: int) -> str:
    """The processes that a process has started, as Linux tells them."""
    try:
        return Path(f"/proc/{process}/task/{process}/children").read_text()
    except OSError:
        return ""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="asks /proc for the worker processes")
def test_ctrl_c_ends_it_quietly(tmp_path: Path):
    # Every file is another, and takes long to parse: the run is far from its end when the signal comes.
    for number in range(400):
        (tmp_path / f"node_{number}.py").write_text(NODE + f"x = [{f'{number}, ' * 3000}]\n")
    process = subprocess.Popen(
        [sys.executable, "-m", "archlint", "check", "--no-cache", "--jobs", "2"],
        cwd=tmp_path,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
        # A job in the background may have been started with the signal ignored, and its children with it.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509
    )
    while not _children(process.pid) and process.poll() is None:
        time.sleep(0.05)  # until it compiles: Python that is still starting up answers a signal itself
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to all of its processes
    out, told = process.communicate(timeout=30)
    assert (process.returncode, out, told) == (130, b"", b"")


def test_results_do_not_depend_on_the_order_of_hashes(node: Path):
    (node.parent / "other.py").write_text(NODE.replace("talker", "other"))
    outputs = {
        python("-m", "archlint", "--no-cache", cwd=node.parent, PYTHONHASHSEED=seed).stdout for seed in ("0", "1", "2")
    }
    assert len(outputs) == 1
