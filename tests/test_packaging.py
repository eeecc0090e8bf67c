"""What is published: the wheel has all that runs, the source archive all that the wheel and the tests need."""

from __future__ import annotations

import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FIXTURES = ROOT / "fixtures"
RUN = "import sys; sys.path.insert(0, sys.argv.pop(1)); from archlint.cli import main; main()"


def build(source: Path, kind: str, target: Path) -> Path:
    command = [sys.executable, "-m", "hatchling", "build", "-t", kind, "-d", str(target)]
    subprocess.run(command, cwd=source, check=True, capture_output=True)
    [built] = target.iterdir()
    return built


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(ROOT, "wheel", tmp_path_factory.mktemp("wheel"))


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The source archive, unpacked."""
    packed = build(ROOT, "sdist", tmp_path_factory.mktemp("sdist"))
    folder = tmp_path_factory.mktemp("unpacked")
    with tarfile.open(packed) as members:
        if hasattr(tarfile, "data_filter"):
            members.extractall(folder, filter="data")
        else:  # Python before 3.10.12 and 3.11.4
            members.extractall(folder)
    [unpacked] = folder.iterdir()
    return unpacked


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel's files; what they depend on is that of the environment."""
    folder = tmp_path_factory.mktemp("installed")
    with zipfile.ZipFile(wheel) as members:
        members.extractall(folder)
    return folder


def archlint(installed: Path, *arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", "-c", RUN, str(installed), *arguments]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)


def names(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as members:
        return set(members.namelist())


def test_the_wheel_holds_the_package_and_a_page_for_each_rule(wheel: Path):
    package = ROOT / "src" / "archlint"
    files = {
        f"archlint/{path.relative_to(package).as_posix()}"
        for path in package.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    rules = ROOT / "rules"
    shipped = [*rules.glob("*.md"), *(path for path in (rules / "scaffold").rglob("*.*") if path.suffix != ".pyc")]
    pages = {f"archlint/rulebook_pages/{page.relative_to(rules).as_posix()}" for page in shipped}
    published = {name for name in names(wheel) if ".dist-info/" not in name}
    assert len(pages) > 20
    assert published == files | pages


def test_the_source_archive_gives_the_same_wheel(archive: Path, wheel: Path, tmp_path: Path):
    assert names(build(archive, "wheel", tmp_path)) == names(wheel)


@pytest.mark.parametrize("name", ["tests", "fixtures", "benchmarks", "scripts", "rules", "docs", "Makefile"])
def test_the_source_archive_holds_what_its_tests_need(archive: Path, name: str):
    assert (archive / name).exists()


def test_nothing_that_a_run_leaves_behind_is_published(archive: Path):
    left = {".archlint_cache", "__pycache__", ".venv", "demo-output"}
    assert not [path for path in archive.rglob("*") if left & set(path.relative_to(archive).parts)]


def test_the_wheel_runs_anywhere(installed: Path, tmp_path: Path):
    where = "import sys; sys.path.insert(0, sys.argv[1]); import archlint; print(archlint.__file__)"
    command = [sys.executable, "-I", "-c", where, str(installed)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert Path(done.stdout.strip()).is_relative_to(installed)
    assert archlint(installed, "--version", cwd=tmp_path).stdout.startswith("archlint ")
    assert "SRV003" in archlint(installed, "rules", cwd=tmp_path).stdout
    assert "nested-service-call" in archlint(installed, "explain", "SRV003", cwd=tmp_path).stdout


@pytest.mark.parametrize(("fixture", "status"), [("lesson", 0), ("broken_system", 1), ("missing", 2)])
def test_the_wheel_judges(installed: Path, tmp_path: Path, fixture: str, status: int):
    done = archlint(installed, "check", "--no-cache", "--isolated", str(FIXTURES / fixture), cwd=tmp_path)
    assert done.returncode == status, done.stderr
