"""The readers of files under atheris, which looks for new branches: ``python -m benchmarks.fuzz.readers --minutes 10``.

The first byte of an input chooses the reader.  A reader may raise nothing for what is in a text.  atheris is no
requirement of the tests: ``scripts/fuzz_readers`` makes an environment that has it.
"""

from __future__ import annotations

import argparse
import importlib
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path

Reader = Callable[[bytes], object]
SECONDS = 10
"""What one input may take; atheris slows Python down by a factor of about five."""
LONGEST = 4096
"""Bytes of an input."""

SEEDS = {
    "launch_xml": '<launch><arg name="a" default="$(env A b)"/><node pkg="p" exec="e" if="$(eval 1)"><param name="x" '
    'value="1"/><remap from="a" to="b"/></node><!-- archlint: ignore[LCH001] --></launch>',
    "launch_yaml": "launch:\n- arg: {name: a, default: 'b'}\n- node: {pkg: p, param: [{name: x, value: 1}]}\n",
    "parameters": "/**:\n  ros__parameters:\n    b: [1]  # archlint: ignore\nn: {ros__parameters: {c: &x y, d: *x}}\n",
    "package_xml": '<package format="3"><name>p</name><depend condition="$ROS_VERSION == 2">rclpy</depend>'
    "<export><build_type>ament_python</build_type></export></package>",
    "setup_cfg": "[options.entry_points]\nconsole_scripts =\n    talker = p.talker:main\n",
    "pyproject": '[project.scripts]\ntalker = "p.talker:main"\n',
    "cmake": 'project(p)\nif(BUILD)\n  install(PROGRAMS [[a b]] "${A}/b" DESTINATION lib/p) # c\nendif()\n',
    "message": "# text\nint32<=5[] numbers [1, 2]\nstring<=3 NAME='a\\'b'\nstd_msgs/Header header\n",
    "service": "bool on\n---\nstring message 'x'\n",
    "python": "import rclpy\nclass A(Node):\n    def f(self):\n        self.t(1.0, lambda: [f'{x!r}' for x in ()])\n",
}
"""A text for each reader, from which the search starts."""


def readers() -> Mapping[str, Reader]:
    """Each reader by its name; they are imported here, for whoever instruments imports first."""
    from archlint.syntax.compile import compile_python
    from archlint.syntax.entry_point_tables import entries_of_pyproject, entries_of_setup_cfg
    from archlint.syntax.interfaces import parse_interface
    from archlint.syntax.launch_xml import read_launch_xml
    from archlint.syntax.launch_yaml import read_launch_yaml
    from archlint.syntax.parameter_files import read_parameters
    from archlint.syntax.python import gate
    from archlint.workspace.cmake import parse_cmake
    from archlint.workspace.manifest import read_manifest
    from archlint.workspace.model import SourceFile

    manifest = SourceFile("package.xml", "package.xml", "package_xml", None, None)

    def python(data: bytes) -> object:
        text = gate.decode(data)
        return text if isinstance(text, gate.Refusal) else compile_python(text)

    def of_text(read: Callable[[str], object]) -> Reader:
        return lambda data: read(data.decode("utf-8", "replace"))

    return {
        "launch_xml": of_text(read_launch_xml),
        "launch_yaml": of_text(read_launch_yaml),
        "parameters": of_text(read_parameters),
        "package_xml": lambda data: read_manifest(manifest, data, ".", "."),
        "setup_cfg": of_text(entries_of_setup_cfg),
        "pyproject": of_text(entries_of_pyproject),
        "cmake": of_text(parse_cmake),
        "message": of_text(lambda text: parse_interface(text, "msg")),
        "service": of_text(lambda text: parse_interface(text, "srv")),
        "python": python,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--corpus", type=Path, required=True, help="a folder for the inputs that reach new branches")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    atheris = importlib.import_module("atheris")
    with atheris.instrument_imports(include=["archlint"]):
        reads = list(readers().values())
    options.corpus.mkdir(parents=True, exist_ok=True)
    for number, (name, text) in enumerate(SEEDS.items()):
        (options.corpus / f"seed-{name}").write_bytes(bytes([number]) + text.encode())

    def judge(data: bytes) -> None:
        if data:
            reads[data[0] % len(reads)](data[1:])

    limits = (f"-max_total_time={int(60 * options.minutes)}", f"-timeout={SECONDS}", f"-max_len={LONGEST}")
    artifacts = f"-artifact_prefix={options.corpus.parent}/"
    atheris.Setup(["readers", *limits, artifacts, "-print_final_stats=1", str(options.corpus)], judge)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
