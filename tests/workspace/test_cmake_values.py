"""What CMake's commands make of lists, paths and ranges."""

from __future__ import annotations

import pytest

from archlint.workspace.cmake_values import changed_list, list_mode, numbers, path_component


@pytest.mark.parametrize(
    ("word", "arm", "archive"),
    [
        ("NAME", "arm.launch.py", "archive"),
        ("NAME_WE", "arm", "archive"),  # without its longest extension
        ("NAME_WLE", "arm.launch", "archive"),  # without its last
        ("EXT", ".launch.py", ""),
        ("LAST_EXT", ".py", ""),
        ("DIRECTORY", "launch", ""),
        ("PATH", "launch", ""),
    ],
)
def test_parts_of_a_path(word: str, arm: str, archive: str):
    assert path_component("launch/arm.launch.py", word) == [arm]
    assert path_component("archive", word) == [archive]


@pytest.mark.parametrize(("path", "word"), [("${FOLDER}/arm.py", "NAME"), ("arm.py", "REALPATH"), ("arm.py", "name")])
def test_a_part_that_is_not_known(path: str, word: str):
    assert path_component(path, word) is None


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["2"], ["0", "1", "2"]),
        (["2", "4"], ["2", "3", "4"]),
        (["1", "6", "2"], ["1", "3", "5"]),
        (["1", "3", "0"], ["1", "2", "3"]),
        (["9" * 18], ["0", "1", "2", "3"]),
        (["9" * 5_000], None),
        (["${N}"], None),
        ([], None),
    ],
)
def test_ranges(texts: list[str], expected: list[str] | None):
    assert numbers(texts, 4) == expected


@pytest.mark.parametrize(
    ("word", "texts", "expected"),
    [
        ("APPEND", ["c"], ["a", "b", "c"]),
        ("prepend", ["c"], ["c", "a", "b"]),
        ("REMOVE_ITEM", ["a"], ["b"]),
        ("SORT", ["COMPARE", "NATURAL"], ["a", "b"]),
        ("APPEND", ["${more}"], None),
    ],
)
def test_lists(word: str, texts: list[str], expected: list[str] | None):
    mode = list_mode(word)
    assert mode is not None
    assert changed_list(mode, ["a", "b"], texts) == expected
    assert changed_list(mode, None, texts) is None


def test_what_changes_no_list():
    assert list_mode("LENGTH") is None
