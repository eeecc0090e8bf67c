"""``--new-only REV``: what a change brings in, on real repositories."""

from __future__ import annotations

import os
import subprocess
import tempfile
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.engine import new_only
from robot_package import SETUP_CFG, manifest, write_files

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool


class {name}(Node):
    def __init__(self):
        super().__init__('{name}')
        {body}
        self.motor = self.create_client(SetBool, 'enable_motor')
        self.motor.wait_for_service()

    def heard(self, message):
        self.motor.call_async(SetBool.Request(data=True))


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
TALKER = NODE.format(name="Talker", body="self.words = self.create_publisher(String, 'words', 10)")
LISTENER = NODE.format(name="Listener", body="self.create_subscription(String, 'words', self.heard, 10)")
FILES = {
    "package.xml": manifest(more="<exec_depend>std_srvs</exec_depend>"),
    "setup.cfg": SETUP_CFG,
    "setup.py": "from setuptools import setup\nsetup(name='robot', entry_points={'console_scripts': ["
    "'talker = robot.talker:main', 'listener = robot.listener:main']})\n",
    "robot/__init__.py": "",
    "robot/talker.py": TALKER,
    "robot/listener.py": LISTENER,
}


def git(*words: str, folder: str | Path = ".") -> str:
    settings = ["-c", "user.name=Kim", "-c", "user.email=kim@example.com", "-c", "protocol.file.allow=always"]
    run = subprocess.run(["git", *settings, *words], cwd=folder, capture_output=True, text=True, check=True)
    return run.stdout.strip()


def commit(folder: str | Path = ".") -> None:
    git("add", "-A", folder=folder)
    git("commit", "-qm", "more", folder=folder)


def edit(file: str, before: str, after: str) -> None:
    text = Path(file).read_text("utf-8")
    assert before in text
    Path(file).write_text(text.replace(before, after), "utf-8")


def change_type() -> None:
    edit("robot/talker.py", "create_publisher(String", "create_publisher(Int32")


@pytest.fixture(autouse=True)
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two nodes that wait for ever and are otherwise in order, committed."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", os.devnull)
    (tmp_path / "ws").mkdir()
    monkeypatch.chdir("ws")
    write_files(Path(), FILES)
    git("init", "-q", "-b", "main")
    commit()
    return tmp_path / "ws"


class Said:
    """What one command says."""

    def __init__(self, capsys: pytest.CaptureFixture[str], *words: str) -> None:
        self.status = main(["check", "--format", "concise", *words])
        out = capsys.readouterr()
        self.findings = sorted(line.partition(":")[0] + " " + line.split()[2] for line in out.out.splitlines())
        self.err = out.err


@pytest.fixture
def say(capsys: pytest.CaptureFixture[str]):
    return lambda *words: Said(capsys, *words)


# --- what is new


def test_a_change_of_one_file_breaks_another(say):
    assert say().findings == ["robot/listener.py TMO001", "robot/talker.py TMO001"]
    assert say("--new-only", "HEAD").findings == []
    change_type()
    changed = say("--new-only", "HEAD")
    assert (changed.status, len(changed.findings)) == (1, 1)
    assert changed.findings[0].endswith("TOP001")
    assert changed.err == "Found 1 error in 3 files with 2 nodes; 2 not new.\n"
    commit()
    assert say("--new-only", "HEAD").findings == []
    assert say("--new-only", "HEAD~1").findings == changed.findings


def test_lines_that_move_a_file_that_is_renamed_and_one_more_of_its_kind(say):
    edit("robot/listener.py", "import rclpy\n", "# Listens.\n\n\nimport rclpy\n")
    git("mv", "robot/talker.py", "robot/speaker.py")
    edit("setup.py", "robot.talker", "robot.speaker")
    assert say("--new-only", "HEAD").findings == []
    edit(
        "robot/listener.py",
        "    def heard",
        "        self.create_client(SetBool, 'enable_brake').wait_for_service()\n\n    def heard",
    )
    assert say("--new-only", "HEAD").findings == ["robot/listener.py TMO001"]


def test_a_file_that_git_does_not_know_yet_is_new(say):
    write_files(Path(), {"robot/third.py": TALKER.replace("Talker", "Third").replace("words", "more")})
    edit("setup.py", "'talker =", "'third = robot.third:main', 'talker =")
    assert say("--new-only", "HEAD").findings == ["robot/third.py TMO001"]


def test_a_tracked_file_that_a_pattern_names_counts_as_it_was(say):
    Path(".gitignore").write_text("robot/\n", "utf-8")
    git("add", "--force", ".")
    git("commit", "-qm", "a pattern too many")
    assert say("--new-only", "HEAD").findings == []
    change_type()
    [new] = say("--new-only", "HEAD").findings
    assert new.endswith("TOP001")


def test_what_others_have_done_meanwhile_is_not_new_here(say):
    git("checkout", "-qb", "feature")
    change_type()
    commit()
    git("checkout", "-q", "main")
    for file in ("talker", "listener"):
        edit(f"robot/{file}.py", "        self.motor.wait_for_service()\n", "")
    commit()
    git("checkout", "-q", "feature")
    [new] = say("--new-only", "main").findings
    assert new.endswith("TOP001")


def test_the_configuration_is_that_of_the_working_tree(say):
    write_files(Path(), {"archlint.toml": "ignore = ['TMO']\n"})
    commit()
    write_files(Path(), {"archlint.toml": "exclude = ['robot/talker.py']\n"})
    assert say("--new-only", "HEAD").findings == []


def test_a_baseline_goes_together_with_it(say):
    say("--baseline", "known.txt", "--write-baseline")
    edit("robot/talker.py", "        self.motor.wait_for_service()\n", "")
    change_type()
    both = say("--baseline", "known.txt", "--new-only", "HEAD")
    assert [line.split()[1] for line in both.findings] == ["LNT004", "TOP001"]


# --- where it is run


@pytest.mark.parametrize(
    ("folder", "path"), [("robot", "."), ("..", "ws"), (".", "robot/listener.py"), ("robot", "..")]
)
def test_the_folder_that_it_is_run_in_does_not_matter(say, monkeypatch: pytest.MonkeyPatch, folder: str, path: str):
    change_type()
    monkeypatch.chdir(folder)
    [new] = say(path, "--new-only", "HEAD").findings
    assert new.endswith("TOP001")


def test_a_workspace_may_be_a_folder_of_the_repository(say, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    os.rename("ws/.git", ".git")
    commit()
    monkeypatch.chdir("ws")
    change_type()
    [new] = say("--new-only", "HEAD").findings
    assert new.endswith("TOP001")


def test_a_submodule_counts_as_it_was(say, tmp_path: Path):
    library = {name.replace("robot", "vendor"): text.replace("robot", "vendor") for name, text in FILES.items()}
    write_files(tmp_path / "vendor", library)
    git("init", "-q", "-b", "main", folder=tmp_path / "vendor")
    commit(tmp_path / "vendor")
    git("submodule", "add", "-q", str(tmp_path / "vendor"), "src/vendor")
    commit()
    old = say().findings
    assert old == ["robot/listener.py TMO001", "robot/talker.py TMO001"]  # the second one tells those of the submodule
    assert say("--new-only", "HEAD").findings == []
    edit("src/vendor/vendor/talker.py", "create_publisher(String", "create_publisher(Int32")
    new = say("--new-only", "HEAD", "--all-files").findings  # colcon sees no package inside another
    assert [line.split()[1] for line in new] == ["TOP001"]


def test_a_shallow_clone_says_what_it_lacks(say, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    change_type()
    commit()
    git("clone", "-q", "--depth", "1", f"file://{tmp_path}/ws", str(tmp_path / "clone"))
    monkeypatch.chdir(tmp_path / "clone")
    assert say("--new-only", "HEAD").findings == []
    lacking = say("--new-only", "HEAD~1")
    assert lacking.status == 2
    assert lacking.err == (
        "archlint: error: --new-only: HEAD~1 is not in this clone, which is shallow; "
        "`git fetch --unshallow origin '+refs/heads/*:refs/remotes/origin/*'` brings it\n"
    )
    git("fetch", "-q", "--unshallow", "origin", "+refs/heads/*:refs/remotes/origin/*")
    [new] = say("--new-only", "HEAD~1").findings
    assert new.endswith("TOP001")


def test_where_the_fork_is_not_in_the_clone_the_revision_itself_counts(say, tmp_path: Path, monkeypatch):
    git("checkout", "-qb", "feature")
    change_type()
    commit()
    git("clone", "-q", "--depth", "1", "-b", "feature", f"file://{tmp_path}/ws", str(tmp_path / "clone"))
    monkeypatch.chdir(tmp_path / "clone")
    git("fetch", "-q", "--depth", "1", "origin", "main")
    result = say("--new-only", "FETCH_HEAD")
    assert [line.split()[1] for line in result.findings] == ["TOP001"]
    assert "(this clone is shallow), so it is compared with FETCH_HEAD" in result.err


def test_a_partial_clone_fetches_nothing_and_says_what_it_lacks(say, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    write_files(Path(), {"docs/arm.dae": "a mesh\n", "docs/notes.md": "notes\n"})
    commit()
    git("rm", "-qr", "docs")
    commit()
    git("config", "uploadpack.allowFilter", "true")
    git("clone", "-q", "--filter=blob:none", f"file://{tmp_path}/ws", str(tmp_path / "clone"))
    monkeypatch.chdir(tmp_path / "clone")
    assert say("--new-only", "HEAD~1").status == 0, "of these files only the names count"
    monkeypatch.chdir(tmp_path / "ws")
    change_type()
    commit()
    git("clone", "-q", "--filter=blob:none", f"file://{tmp_path}/ws", str(tmp_path / "other"))
    monkeypatch.chdir(tmp_path / "other")
    lacking = say("--new-only", "HEAD~1")
    assert lacking.status == 2
    assert "the content of robot/talker.py is not in this partial clone; `git archive" in lacking.err
    git(*lacking.err.split("`git ")[1].split("`")[0].split())
    [new] = say("--new-only", "HEAD~1").findings
    assert new.endswith("TOP001")


def test_a_hook_may_run_it(say, monkeypatch: pytest.MonkeyPatch):
    change_type()
    for name, value in (("GIT_DIR", "elsewhere"), ("GIT_INDEX_FILE", "no-index"), ("GIT_WORK_TREE", "/")):
        monkeypatch.setenv(name, value)
    assert len(say("--new-only", "HEAD").findings) == 1


@pytest.mark.parametrize(
    ("revision", "said"),
    [
        ("mian", "git knows no revision mian in .; did you mean main?"),
        ("--output=x", "expected one argument"),
        ("HEAD:setup.py", "git knows no revision HEAD:setup.py"),
        ("no\nsuch", "git knows no revision"),
    ],
)
def test_a_revision_that_is_none(say, revision: str, said: str):
    result = say("--new-only", revision)
    assert result.status == 2
    assert said in result.err


def test_no_repository_and_no_git(say, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    os.rename(".git", "../elsewhere")
    assert say("--new-only", "HEAD").err == (
        "archlint: error: --new-only: this folder lies in no git repository; name a folder that does\n"
    )
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "it needs git" in say("--new-only", "HEAD").err


@pytest.mark.parametrize("words", [["--write-baseline", "--baseline", "b.txt"], ["--facts", "facts"]])
def test_what_does_not_go_together(say, words: list[str]):
    assert say("--new-only", "HEAD", *words).status == 2


# --- what it leaves alone


def test_nothing_in_the_repository_is_changed_or_run(say, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    trap = tmp_path / "trap"
    trap.write_text(f"#!/bin/sh\ntouch {tmp_path}/sprung\ncat\n", "utf-8")
    trap.chmod(0o755)
    write_files(Path(), {".gitattributes": "*.py filter=trap diff=trap export-subst\n"})
    commit()
    for key in ("filter.trap.smudge", "filter.trap.clean", "diff.trap.textconv", "core.fsmonitor", "core.pager"):
        git("config", key, str(trap))
    for hook in ("post-checkout", "post-index-change", "reference-transaction"):
        path = Path(".git/hooks") / hook
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(trap.read_bytes())
        path.chmod(0o755)
    change_type()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    (tmp_path / "temporary").mkdir()
    before = {path: path.stat().st_mtime_ns for path in Path().rglob("*") if ".archlint_cache" not in path.parts}
    assert len(say("--new-only", "HEAD").findings) == 1
    assert before == {path: path.stat().st_mtime_ns for path in before}
    assert not (tmp_path / "sprung").exists()
    git("diff", "--textconv", "HEAD")
    assert (tmp_path / "sprung").exists(), "the trap works"
    assert list((tmp_path / "temporary").iterdir()) == []


def test_a_link_of_the_revision_leads_nowhere_else(tmp_path: Path):
    (tmp_path / "secret").mkdir()
    (tmp_path / "secret" / "node.py").write_text(TALKER, "utf-8")
    Path("deep/er").mkdir(parents=True)
    os.symlink("../..", "deep/er/top")
    os.symlink("deep/er/top/../secret", "out")
    os.symlink(tmp_path / "secret", "absolute")
    os.symlink("robot", "inside")
    commit()
    with new_only.old_tree() as tree:
        repository = new_only.repository_of(["."])
        tree.write(repository, repository.commit("HEAD") or "")
        top = Path(tree.place("."))
        links = sorted(path.relative_to(top).as_posix() for path in top.rglob("*") if path.is_symlink())
    assert links == ["deep/er/top", "inside"]
    assert not top.exists()


def test_a_revision_is_judged_once(say, monkeypatch: pytest.MonkeyPatch):
    change_type()
    first = say("--new-only", "HEAD").findings
    monkeypatch.setattr(new_only, "old_tree", lambda: pytest.fail("it is known"))
    assert say("--new-only", "HEAD").findings == first
    edit("robot/talker.py", "create_publisher(Int32", "create_publisher(String")
    assert say("--new-only", "HEAD").findings == []
