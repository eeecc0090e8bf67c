"""The files of a commit's parent, taken from a clone without touching it."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

_EXECUTABLE, _PLAIN = "100755", "100644"


def clone_of(repository: str, folder: Path) -> Path | None:
    """The clone of ``owner/name`` in a folder of clones: ``name``, ``owner/name`` or ``owner+name``, bare or not."""
    names = (repository, repository.replace("/", "+"), repository.partition("/")[2])
    return next((folder / name for name in names if _is_repository(folder / name)), None)


def _is_repository(path: Path) -> bool:
    return (path / ".git").exists() or (path / "HEAD").is_file()


def export_parent(clone: Path, fix: str, target: Path) -> bool:
    """Write the files before a commit into a new folder; false if the clone does not have that commit.

    Links are left out, and so are files whose content the clone does not hold: a partial clone lacks large ones.
    """
    listing = subprocess.run(_git(clone, "ls-tree", "-r", "-z", f"{fix}^"), capture_output=True, check=False)
    if listing.returncode:
        return False
    target.mkdir(parents=True)
    rows = [row for row in listing.stdout.decode(errors="surrogateescape").split("\0") if row]
    files = [(*about.split()[::2], name) for about, _, name in (row.partition("\t") for row in rows)]
    wanted = [file for file in files if file[0] in (_EXECUTABLE, _PLAIN)]
    for (mode, _, name), content in zip(wanted, _contents(clone, [key for _, key, _ in wanted]), strict=True):
        path = target / name
        if content is not None and path.resolve().is_relative_to(target.resolve()):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            path.chmod(0o755 if mode == _EXECUTABLE else 0o644)
    return True


def _contents(clone: Path, keys: list[str]) -> Iterator[bytes | None]:
    """The content of each object; None where the clone does not hold it."""
    batch = subprocess.run(
        _git(clone, "cat-file", "--batch"), input="\n".join(keys).encode(), capture_output=True, check=True
    ).stdout
    at = 0
    for _ in keys:
        end = batch.index(b"\n", at)
        *_, size = batch[at:end].split()
        at = end + 1
        if size == b"missing":
            yield None
        else:
            yield batch[at : at + int(size)]
            at += int(size) + 1


def _git(clone: Path, *arguments: str) -> list[str]:
    return ["git", "-C", str(clone), *arguments]
