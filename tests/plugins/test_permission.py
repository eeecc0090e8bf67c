"""Code of the checked repository runs only where the one who starts archlint says so."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import archlint
from archlint.cli import COMMANDS, main
from archlint.plugins.permission import belongs_to

WITHOUT_FILES = [["check"], ["graph"], ["config"], ["config", "--schema"], ["rules"], ["explain", "XRT001"]]
ASKED = "is Python code of this repository, and archlint runs it only where you say so"


@pytest.mark.parametrize("command", WITHOUT_FILES, ids=" ".join)
@pytest.mark.parametrize("leaving", [[], ["--no-plugins"]], ids=["", "no-plugins"])
def test_no_command_runs_it_by_itself(command: list[str], leaving: list[str], marked: Path):
    assert command[0] in COMMANDS
    main([*command, *([] if command == ["graph"] else leaving)])
    assert not marked.exists()


def test_a_configuration_cannot_allow_itself(marked: Path):
    text = Path("archlint.toml").read_text()
    for key in ("run-plugins = true", 'plugins = ["--plugins"]'):
        Path("archlint.toml").write_text(f"{key}\n{text}")
        assert main(["check"]) == 2
    assert not marked.exists()


def test_a_check_asks_and_says_how_to_answer(marked: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["check"]) == 2
    said = capsys.readouterr().err
    assert f"archlint.toml:1: the plugin tools/our_rules.py {ASKED}" in said
    for answer in ("`--plugins`", "ARCHLINT_PLUGINS=1", "`--no-plugins`"):
        assert answer in said
    assert '1 | plugins = ["tools/our_rules.py"]' in said
    assert not marked.exists()


@pytest.mark.parametrize(
    ("options", "variable", "status", "runs"),
    [
        (["--plugins"], None, 1, True),
        (["--plugins"], "0", 1, True),
        ([], "1", 1, True),
        (["--no-plugins"], "1", 0, False),
        ([], "0", 0, False),
        ([], "", 2, False),
        ([], "yes", 2, False),
        (["--isolated", "--plugins"], "1", 0, False),
    ],
)
def test_the_command_line_and_then_the_environment_decide(
    options: list[str], variable: str | None, status: int, runs: bool, marked: Path, monkeypatch: pytest.MonkeyPatch
):
    if variable is not None:
        monkeypatch.setenv("ARCHLINT_PLUGINS", variable)
    assert main(["check", *options]) == status
    assert marked.exists() is runs


def test_what_is_left_out_is_said_and_its_codes_are_no_mistakes(repository: Path, capsys: pytest.CaptureFixture[str]):
    node = repository / "wheels.py"
    text = node.read_text().replace("self.turn)", "self.turn)  # archlint: ignore[XRT001] it is fast")
    node.write_text(text.replace("debug", "info"))
    Path("archlint.toml").write_text(
        'plugins = ["tools/our_rules.py"]\nextend-select = ["fast-timer"]\n'
        '[severity]\nXRT = "error"\n[rules.XRT001]\nmax-rate = 5\n'
    )
    assert main(["check", "--no-plugins", "--ignore", "XRT001"]) == 0
    said = capsys.readouterr()
    assert said.out == ""
    assert "archlint.toml:1: the rules of tools/our_rules.py are left out; --plugins runs them" in said.err


@pytest.mark.parametrize("name", ["../evil.py", "/tmp/evil.py", "tools/link.py", "tools/pipe.py", "tools/none.py"])
def test_what_is_not_a_file_of_the_repository_never_runs(name: str, repository: Path, tmp_path: Path):
    evil = tmp_path / "evil.py"
    evil.write_text(f"open({str(tmp_path / 'ran')!r}, 'w')\n")
    (repository / "tools" / "link.py").symlink_to(evil)
    (repository / "tools" / "pipe.py").mkdir()
    Path("archlint.toml").write_text(f'plugins = ["{name}"]\n')
    assert main(["check", "--plugins"]) == 2
    assert not (tmp_path / "ran").exists()


def test_the_answer_of_a_run_with_plugins_is_not_given_to_one_without(repository: Path, capsys):
    assert main(["check", "--plugins", "--quiet"]) == 1
    assert main(["check", "--no-plugins", "--quiet"]) == 0
    assert main(["check", "--plugins", "--quiet"]) == 1
    assert capsys.readouterr().out.count("XRT001") == 2


def test_the_api_asks_too(marked: Path, repository: Path):
    with pytest.raises(archlint.ArchlintError, match=ASKED) as raised:
        archlint.load(repository)
    assert raised.value.line == 1
    assert not archlint.load(repository, plugins=False).check().fails()
    assert not marked.exists()
    assert archlint.load(repository, plugins=True).check().fails()


def test_what_is_installed_is_the_users_even_inside_of_the_repository(tmp_path: Path):
    installed = Path(next(path for path in sys.path if path.endswith("site-packages")))
    assert not belongs_to([str(installed / "rules.py")], installed.parents[3])
    assert belongs_to([str(tmp_path / "install" / "rules.py")], tmp_path)
    assert not belongs_to([str(tmp_path / "rules.py")], tmp_path / "robot")


def test_nothing_of_plugins_is_imported_without_any(tmp_path: Path):
    (tmp_path / "node.py").write_text("import rclpy\n")
    (tmp_path / "archlint.toml").write_text('ignore = ["TMO"]\n')
    code = (
        "import sys; from archlint.cli import main; main(['check', '--no-cache'])\n"
        "sys.exit(any(name.startswith('archlint.plugins') or name == 'importlib.metadata' for name in sys.modules))"
    )
    environment = {"PYTHONPATH": str(Path(archlint.__file__).parents[1]), "PATH": ""}
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=environment, capture_output=True, check=False)
    assert done.returncode == 0
