"""What CMake refuses to parse."""

from __future__ import annotations

import pytest

from archlint.workspace.cmake_problems import malformed_cmake


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("project(a)\ninstall(FILES b\nament_package()\n", 2, "a '(' has no partner"),
        ("project(a)\ninstall(FILES b))\n", 2, "a ')' has no partner"),
        ("project(a)\nfoo bar\nament_package()\n", 2, "'foo' is no command: it has no parentheses behind it"),
        ("project(a)\nDEPENDENCIES\n", 2, "'DEPENDENCIES' is no command: it has no parentheses behind it"),
        ("project(a)\n(b)\n", 2, "a '(' without a command in front of it"),
        ('project(a)\n"b"\n', 2, "a text stands outside of every command"),
        ('project(a)\nmessage("b)\n', 2, "a quotation mark has no partner"),
        ("if(A)\nproject(a)\n", 1, "if() has no endif()"),
        ("if(A)\nforeach(x IN ITEMS b)\nendif()\nendforeach()\n", 3, "endif() without its if() inside of foreach()"),
        ("project(a)\nendif()\n", 2, "endif() without its if()"),
        ("project(a)\nelse()\n", 2, "else() without its if()"),
    ],
)
def test_what_cmake_stops_at(text: str, line: int, message: str):
    problem = malformed_cmake(text)
    assert problem is not None
    assert (problem.line, problem.message) == (line, message)


@pytest.mark.parametrize(
    "text",
    [
        "",
        '# a comment with a " and a (\nproject(a) # and another )\n',
        "#[[ a block\nwith ( ]]\nproject(a)\n",
        'message("a \\" b")\nmessage([[ "( ]])\nset(a \\()\n',
        "if((A AND B) OR NOT (C))\nelseif(D)\nelse()\nendif()\n",
        "function(f x)\n  foreach(y IN LISTS x)\n    if(y)\n    endif()\n  endforeach()\nendfunction()\n",
        "IF(A)\nENDIF(A)\nproject\n(a)\n",
        'target_compile_options(a PRIVATE $<$<CONFIG:Debug>:-g> -DNAME="b c")\n',
    ],
)
def test_what_cmake_reads(text: str):
    assert malformed_cmake(text) is None
