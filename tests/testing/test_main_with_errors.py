"""archlint as a test of a ROS package."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.testing import main_with_errors
from robot_package import SETUP_CFG, TALKER, manifest, write_files

SETUP = """\
from setuptools import setup
setup(name='{0}', entry_points={{'console_scripts': ['talker = {0}.talker:main']}})
"""
LISTENER = TALKER.replace("Talker", "Listener").replace("'talker'", "'listener'")
LISTENER = LISTENER.replace("create_publisher(String, 'chatter', 10)", "create_subscription({}, 'chatter', print, 10)")


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two packages, the talker and the listener; a test of the listener runs in its folder."""
    monkeypatch.setenv("HOME", str(tmp_path))
    for name, needs in (("robot", ""), ("ears", "<exec_depend>robot</exec_depend>")):
        files = {"package.xml": manifest(name, more=needs), "setup.py": SETUP.format(name), f"{name}/__init__.py": ""}
        files["setup.cfg"] = SETUP_CFG.replace("robot", name)
        write_files(tmp_path / "src" / name, files)
    write_files(tmp_path / "src", {"robot/robot/talker.py": TALKER, "ears/ears/talker.py": LISTENER.format("String")})
    monkeypatch.chdir(tmp_path / "src" / "ears")
    return tmp_path


def test_nothing_is_wrong(capsys: pytest.CaptureFixture[str]):
    assert main_with_errors(argv=[]) == (0, [])
    assert "No findings in" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("package", "said"),
    [("ears", "/listener subscribes to '/chatter' as"), ("robot", "/talker publishes '/chatter' as")],
)
def test_what_is_wrong_between_two_packages_is_in_the_tests_of_both(
    package: str, said: str, workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    listener = LISTENER.format("Int32").replace("import String", "import Int32")
    write_files(workspace / "src" / "ears", {"ears/talker.py": listener})
    monkeypatch.chdir(workspace / "src" / package)
    rc, errors = main_with_errors(argv=[])
    assert rc == 1
    [error] = errors
    assert error.startswith(f"{package}/talker.py:9:9: TOP001 {said}")
    assert said in capsys.readouterr().out


@pytest.mark.parametrize(
    ("argv", "rc", "codes"),
    [
        (["--select", "NME001"], 1, ["NME001"]),
        (["--select", "NME001", "--severity", "error"], 0, []),
        (["--select", "NME001", "--exit-zero"], 0, []),
        (["--select", "TOP"], 0, []),
    ],
)
def test_only_what_fails_the_run_is_an_error(workspace: Path, argv: list[str], rc: int, codes: list[str]):
    write_files(
        workspace / "src" / "ears", {"ears/talker.py": LISTENER.format("String").replace("'chatter'", "'/chatter'")}
    )
    status, errors = main_with_errors(argv)
    assert (status, [error.split()[1] for error in errors]) == (rc, codes)


@pytest.mark.parametrize(
    ("argv", "said"),
    [
        (["nowhere"], "archlint: error: no such file or directory: nowhere"),
        (["--sever", "x"], "archlint: error: unrecognized arguments: --sever"),
    ],
)
def test_a_run_that_fails_says_why(argv: list[str], said: str):
    rc, errors = main_with_errors(argv)
    assert rc == 2
    assert said in "\n".join(errors)
