"""What CMake's commands make of lists, paths and ranges."""

from __future__ import annotations

import pytest

from archlint.workspace.cmake_values import changed_list, list_mode, numbers, parsed_arguments, path_component


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


WORDS = ["FORCE", "base", "NAME", "arm", "LINKS", "a", "b", "FILES", "c"]


@pytest.mark.parametrize(
    ("texts", "argv"),
    [
        (["P", "FORCE;DRY", "NAME;TYPE", "LINKS;FILES", *WORDS], []),
        (["PARSE_ARGV", "1", "P", "FORCE;DRY", "NAME;TYPE", "LINKS;FILES"], ["part", *WORDS]),
    ],
)
def test_arguments_under_keywords(texts: list[str], argv: list[str]):
    assert parsed_arguments(texts, argv) == {
        "P_FORCE": ["TRUE"],
        "P_DRY": ["FALSE"],
        "P_NAME": ["arm"],
        "P_TYPE": [],
        "P_LINKS": ["a", "b"],
        "P_FILES": ["c"],
        "P_UNPARSED_ARGUMENTS": ["base"],
    }


@pytest.mark.parametrize(
    ("texts", "argv"),
    [
        (["P", "${OPTIONS}", "", "LINKS", "LINKS", "a"], []),
        (["P", "", "LINKS"], []),
        (["PARSE_ARGV", "1", "P", "", "", "LINKS"], None),
        (["PARSE_ARGV", "${AT}", "P", "", "", "LINKS"], ["a"]),
    ],
)
def test_keywords_that_are_not_known(texts: list[str], argv: list[str] | None):
    assert parsed_arguments(texts, argv) is None
