"""The ROS 2 environments that ``scripts/ros_environment`` makes, and the interface packages that are built for them."""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OWN_INTERFACES = ROOT / "tests_ros" / "interfaces"
"""Packages without a wheel, with those of their interfaces that the fixtures use."""
OWN_CMAKE = ROOT / "tests_ros" / "cmake"
"""rosidl's generators, less those for C++, which takes half of the time and nothing here uses."""

_LOCAL = {
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
    "FASTDDS_BUILTIN_TRANSPORTS": "UDPv4",  # shared memory would be left behind by what is killed
    "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp",
}
_KEPT = ("PATH", "HOME", "LANG", "LC_ALL", "TMPDIR")


@dataclass(frozen=True)
class Environment:
    """One distribution's environment."""

    distro: str

    @property
    def folder(self) -> Path:
        return ROOT / f".venv-ros-{self.distro}"

    @property
    def python(self) -> Path:
        return self.folder / "bin" / "python"

    def ready(self) -> bool:
        return any(self.folder.glob(".installed-*"))

    def version(self, package: str) -> tuple[int, ...]:
        """What a ROS package says of itself; its wheel may count otherwise."""
        text = ElementTree.parse(self.folder / "share" / package / "package.xml").getroot().findtext("version", "")
        return tuple(map(int, text.split(".")))

    @property
    def remaps_actions(self) -> bool:
        """Whether a rule for an action's name does anything: rcl_action resolves it since 9.2.8, of October 2025."""
        return self.version("rcl_action") >= (9, 2, 8)

    def variables(self, prefixes: list[Path], domain: int, logs: Path) -> dict[str, str]:
        """What a ROS process gets: nothing of the caller's that ROS reads, and the installed ``prefixes``."""
        kept = {name: os.environ[name] for name in _KEPT if name in os.environ}
        return (
            kept
            | _LOCAL
            | {
                "ROS_DOMAIN_ID": str(domain),
                "ROS_LOG_DIR": str(logs),
                "AMENT_PREFIX_PATH": os.pathsep.join(map(str, [*prefixes, self.folder])),
                "LD_LIBRARY_PATH": os.pathsep.join(str(prefix / "lib") for prefix in prefixes),
                "PYTHONPATH": os.pathsep.join(
                    str(path) for prefix in prefixes for path in prefix.glob("lib/python3*/site-packages")
                ),
                "PYTHONDONTWRITEBYTECODE": "1",
            }
        )

    def interfaces(self, *folders: Path) -> list[Path]:
        """The install prefixes of all interface packages below ``folders``, built where that was not done before."""
        return [self._built(package) for package in packages_of_interfaces(*folders)]

    def _built(self, package: Path) -> Path:
        name = package.name
        prefix = self.folder / "interfaces" / f"{name}-{content_hash(package)}"
        with locked(self.folder / f"build-{name}.lock"):
            if not (prefix / "done").exists():
                shutil.rmtree(prefix, ignore_errors=True)
                self._build(package, prefix)
                (prefix / "done").touch()
        return prefix

    def _build(self, package: Path, prefix: Path) -> None:
        build = prefix / "build"
        variables = {"PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}", "HOME": os.environ.get("HOME", "/")}
        variables |= {"AMENT_PREFIX_PATH": str(self.folder), "CMAKE_PREFIX_PATH": str(self.folder)}
        options = [f"-DCMAKE_INSTALL_PREFIX={prefix}", f"-DPython3_EXECUTABLE={self.python}", "-DBUILD_TESTING=OFF"]
        options += [f"-Drosidl_default_generators_DIR={OWN_CMAKE}"]
        options += ["-DCMAKE_CXX_FLAGS=-O0 -w", "-DCMAKE_C_FLAGS=-O0 -w"]
        for command in (
            ["cmake", "-S", str(package), "-B", str(build), *options],
            ["cmake", "--build", str(build)],
            ["cmake", "--install", str(build)],
        ):
            done = subprocess.run(
                command,
                env=variables,
                text=True,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                timeout=600,
                check=False,
            )
            if done.returncode:
                raise RuntimeError(f"{package.name} cannot be built: {' '.join(command[:2])}\n{done.stdout[-3000:]}")
        shutil.rmtree(build)


def packages_of_interfaces(*folders: Path) -> list[Path]:
    """The folders of all packages of interfaces below ``folders``."""
    return [path.parent for folder in folders for path in sorted(folder.rglob("package.xml")) if is_interfaces(path)]


def is_interfaces(manifest: Path) -> bool:
    """Whether a package.xml is that of a package of interfaces; one that cannot be read is not."""
    try:
        root = ElementTree.parse(manifest).getroot()
    except ElementTree.ParseError:
        return False
    return any(group.text == "rosidl_interface_packages" for group in root.iter("member_of_group"))


def content_hash(package: Path) -> str:
    digest = hashlib.sha256()
    for path in sorted(one for one in package.rglob("*") if one.is_file()):
        digest.update(f"{path.relative_to(package)}\0".encode() + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Holds a lock file, so that two test runs do not build the same thing at the same time."""
    with path.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield
