"""Which file an ``#include`` means."""

from __future__ import annotations

import pytest

from archlint.workspace.includes import SOURCE, Includes
from archlint.workspace.model import SourceFile

FILES = (
    "arm/include/arm/joint.hpp",
    "arm/src/joint.hpp",
    "arm/src/joint.cpp",
    "leg/include/leg/joint.hpp",
    "leg/src/leg.cpp",
)


def of(path: str) -> SourceFile:
    return SourceFile(f"/ws/{path}", path, "cpp", path.partition("/")[0], None)


@pytest.mark.parametrize(
    ("importer", "written", "meant"),
    [
        ("arm/src/joint.cpp", "arm/joint.hpp", "arm/include/arm/joint.hpp"),
        ("arm/src/joint.cpp", "joint.hpp", "arm/src/joint.hpp"),  # beside the includer
        ("leg/src/leg.cpp", "joint.hpp", "leg/include/leg/joint.hpp"),  # of the own package
        ("leg/src/leg.cpp", "arm/joint.hpp", "arm/include/arm/joint.hpp"),
        ("leg/src/leg.cpp", "hand/joint.hpp", None),
        ("leg/src/leg.cpp", "rclcpp/rclcpp.hpp", None),
    ],
)
def test_an_include_is_found_by_the_end_of_its_path(importer: str, written: str, meant: str | None) -> None:
    includes = Includes()
    for path in FILES:
        includes.add(of(path))
    file = includes.find(of(importer), written)
    assert (None if file is None else file.relative) == meant


@pytest.mark.parametrize("number", ["x", "-1", "²", "٣", "99", "9" * 5000, "", "0/joint.hpp"])
def test_a_file_that_writes_the_name_of_a_source_itself_includes_nothing(number: str) -> None:
    includes = Includes()
    for path in FILES:
        includes.add(of(path))
    assert includes.find(of("arm/src/joint.cpp"), f"{SOURCE}{number}") is None
    assert includes.find(of("arm/src/joint.cpp"), f"{SOURCE}0") is not None  # as we write it
