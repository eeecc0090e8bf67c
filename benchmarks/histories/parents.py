"""The files of a commit's parent, taken from a clone without touching it."""

from __future__ import annotations

import subprocess
import tarfile
from pathlib import Path


def clone_of(repository: str, folder: Path) -> Path | None:
    """The clone of ``owner/name`` in a folder of clones: ``name``, ``owner/name`` or ``owner+name``, bare or not."""
    names = (repository, repository.replace("/", "+"), repository.partition("/")[2])
    return next((folder / name for name in names if _is_repository(folder / name)), None)


def _is_repository(path: Path) -> bool:
    return (path / ".git").exists() or (path / "HEAD").is_file()


def export_parent(clone: Path, fix: str, target: Path) -> bool:
    """Write the files before a commit into a new folder; false if the clone does not have that commit.

    Links and names that would lead out of the folder are left out.
    """
    git = subprocess.Popen(
        ["git", "-C", str(clone), "archive", "--format=tar", f"{fix}^"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    target.mkdir(parents=True)
    try:
        with tarfile.open(fileobj=git.stdout, mode="r|", errorlevel=0) as archive:
            archive.extractall(target, filter="data")
    except tarfile.TarError:
        return False
    finally:
        git.communicate()
    return git.returncode == 0
