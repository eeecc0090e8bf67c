"""The gate: what gets through to the parser, and what is said of the rest."""

from __future__ import annotations

import os
import warnings
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.syntax.python import gate
from archlint.syntax.python.gate import (
    Refusal,
    compile_refusal,
    decode,
    inspect,
    nesting,
    read_bytes,
    read_source,
)

NODE = "import rclpy\n\n\nclass Größe(Node):\n    pass\n"


def refusal(answer: object) -> Refusal:
    assert isinstance(answer, Refusal)
    return answer


# --- the file


def test_a_good_file_comes_through_as_it_is(tmp_path):
    path = tmp_path / "node.py"
    path.write_bytes(NODE.encode())
    source = read_source(str(path))
    assert isinstance(source, gate.SourceText)
    assert (source.text, source.data) == (NODE, NODE.encode())


def test_a_file_that_is_gone_is_told(tmp_path):
    assert refusal(read_bytes(str(tmp_path / "gone.py"))).message == "cannot read this file: No such file or directory"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read every file")
def test_a_file_that_may_not_be_read_is_told(tmp_path):
    path = tmp_path / "closed.py"
    path.touch(mode=0)
    assert refusal(read_bytes(str(path))).message == "cannot read this file: Permission denied"


def test_nothing_waits_for_a_pipe_or_reads_a_device(tmp_path):
    os.mkfifo(tmp_path / "pipe.py")
    for path in (str(tmp_path / "pipe.py"), "/dev/zero", str(tmp_path)):
        assert refusal(read_bytes(path)).message == "not a regular file"


def test_a_large_file_is_told_with_its_size(tmp_path):
    path = tmp_path / "table.py"
    path.write_bytes(b"x" * 5_000)
    assert read_bytes(str(path), limit=5_000) == b"x" * 5_000
    assert refusal(read_bytes(str(path), limit=4_000)).message == (
        "the file is too large to analyse: 5 kB, the limit is 4 kB"
    )


# --- the encoding


@pytest.mark.parametrize(
    ("data", "text"),
    [
        ("name = 'Größe'\n".encode(), "name = 'Größe'\n"),
        (b"\xef\xbb\xbfx = 1\n", "x = 1\n"),
        ("# coding: latin-1\nname = 'Größe'\n".encode("latin-1"), "# coding: latin-1\nname = 'Größe'\n"),
        (b"#!/usr/bin/python3\n# vim: set fileencoding=cp1252 :\ncost = '5 \x80'\n", None),
        (b"x = 1\r\ny = 2\r\n", "x = 1\r\ny = 2\r\n"),
        (b"", ""),
        # Python skips comments before it decodes them, where a module is imported.
        (b"x = 1\ny = 2\nz = '#'  # \xb2\xce\n# \xff\n", "x = 1\ny = 2\nz = '#'  # ??\n# ?\n"),
    ],
    ids=["utf-8", "byte order mark", "cookie", "cookie on the second line", "line ends", "empty", "comment"],
)
def test_text_is_decoded_as_python_does(data, text):
    decoded = decode(data)
    assert decoded == (text if text is not None else data.decode("cp1252"))


@pytest.mark.parametrize(
    ("data", "place", "message"),
    [
        ("x = 1\nö = 'Gr\xff'\n".encode("latin-1"), (2, 1), "byte 0xf6 is not valid utf-8: save the file as UTF-8"),
        (
            b"x = 1\n\xc3\xb6 = '\xff'\n",
            (2, 6),
            "byte 0xff is not valid utf-8: save the file as UTF-8 or name its encoding",
        ),
        (b"x = 1\ny = 2\nz = '# \xff'  # \xff\n", (3, 8), "byte 0xff is not valid utf-8"),
        (b"# coding: ascii\nx = '\xff'\n", (2, 6), "byte 0xff is not valid ascii"),
        (b"# coding: klingon\n", (1, 1), "the encoding of this file is not known: unknown encoding: klingon"),
        (b"# coding: hex\n", (1, 1), "the encoding of this file cannot be used"),
        (b"# coding: punycode\n" + b"a" * 900_000, (1, 1), "the encoding of this file cannot be used: punycode"),
        (b"x = 1\ny = '\xc3\xb6\0'\n", (2, 7), "the file contains a NUL byte, so it is not Python source"),
        ("import rclpy\n".encode("utf-16"), (1, 1), "the file is UTF-16, which Python does not read"),
        (rb"# coding: unicode_escape" + b"\nx = '\\ud800'\n", (1, 1), "the file is not text in unicode_escape"),
        (rb"# coding: raw_unicode_escape" + b"\nx = '\\u0000'\n", (1, 1), "the file is not text in raw_unicode_escape"),
    ],
)
def test_what_is_no_text_is_told_with_its_place(data, place, message):
    answer = refusal(decode(data))
    assert (answer.line, answer.column) == place
    assert answer.message.startswith(message)


@given(st.binary())
def test_any_bytes_are_answered(data):
    answer = decode(data)
    if isinstance(answer, str):
        answer.encode("utf-8")


# --- depth and length


def test_brackets_in_strings_and_comments_do_not_nest():
    text = """x = '(((' # (((
y = [(1, {2: 3}), '''
((((
''']
"""
    assert nesting(text) == (3, 2)


@pytest.mark.parametrize(
    "text",
    [
        "x = " + "(" * 150 + ")" * 150,
        "x = [" + "\n    -1, -2," * 20_000 + "\n]",
        "x = {" + ", ".join(f"'k{n}': {n} + {n}" for n in range(20_000)) + "}",
        "x = " + " + ".join("1" * 900),
        "x = (" + "\n    'abc'" * 2_000 + ")",
        "".join(f"if x == {n}: y = {n}\n" for n in range(10_000)),
        "".join(f"if a.b.c.d({n}):\n    a.b.c.e({n} + 1)\n" for n in range(10_000)),
        "if x: pass\n" + "elif x: pass\n" * 900,
        "".join("    " * n + "if x:\n" for n in range(95)) + "    " * 95 + "pass\n",
        "def f(: syntax is not the gate's business",
        "print 'hello'",
        "type Point = tuple[float, float]\n",
    ],
    ids=[
        "brackets", "list", "dict", "sum", "strings", "statements", "attributes", "elif", "blocks", "no Python",
        "Python 2", "newer Python",
    ],
)  # fmt: skip
def test_what_real_code_does_passes(text):
    assert inspect(text) is None


MANY = 200_000


@pytest.mark.parametrize(
    "text",
    [
        "x = " + "(" * 300 + ")" * 300,
        "x = " + "(" * MANY,
        "x = " + "[" * 300 + "]" * 300 + "\ntype X = int\n",
        "def f(:\n    pass\nx = " + "[" * 300 + "]" * 300,
        "x = " + "1+" * MANY + "1",
        "x = (\n" + "1 +\n" * MANY + "1)",
        "def f(:\n    pass\nx = " + "1+" * MANY + "1",
        "x" + ".b" * MANY,
        "x" + "()" * MANY,
        "x = " + "not " * MANY + "x",
        "x = " + "-" * MANY + "1",
        "x = " + "lambda: " * 50_000 + "1",
        "x = " + "1 if 1 else " * 50_000 + "1",
        "x = " + "2**" * MANY + "2",
        "x = (" + "'a'\n" * MANY + ")",
        "if x: pass\n" + "elif x: pass\n" * 50_000,
        "'" * MANY,
        "'''" * MANY,
        "'\\\n" * MANY,
    ],
    ids=range(19),
)
def test_what_would_kill_or_stall_the_parser_is_refused(text):
    answer = refusal(inspect(text))
    assert any(word in answer.message for word in ("nested", "too many"))


def test_a_refusal_for_depth_says_where():
    text = "type X = int\n\nx = " + "(\n" * 250 + ")" * 250
    answer = refusal(inspect("def f:\n" + text))
    assert answer.message == "brackets are nested 250 deep, more than Python's own limit of 200"
    assert answer.line == 4 + 249


# --- what Python does not compile


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("f(a=1, b=2, a=3)\n", (1, 13), "keyword argument repeated: a"),
        ("größe = f(a=1, a=3)\n", (1, 16), "keyword argument repeated: a"),
        ("x = 1\nreturn x\n", (2, 1), "'return' outside function"),
        ("def f(a, a):\n    pass\n", None, "duplicate argument 'a' in function definition"),
        ("def f():\n    await g()\n", (2, 5), "'await' outside async function"),
        ("from __future__ import telepathy\n", None, "future feature telepathy is not defined"),
    ],
)
def test_what_python_parses_but_does_not_compile_is_told(text, place, message):
    answer = refusal(compile_refusal(text))
    assert answer.message == f"Python refuses to compile this file: {message}"
    if place is not None:
        assert (answer.line, answer.column) == place


@pytest.mark.parametrize("text", ["", NODE, "def f(:", "print 'x'", "x = " + "(" * 300, "x = '\ud800'", "x = '\0'"])
def test_the_compiler_has_nothing_to_say_of_what_it_compiles_or_cannot_parse(text):
    assert compile_refusal(text) is None


def test_dubious_code_gives_no_warning():
    text = "x = '\\d'\nif x is 'y': pass\nassert (x, 'always')\n1 ()\n"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert inspect(text) is None
        assert compile_refusal(text) is None


def test_no_real_module_is_refused():
    names = ("typing.py", "argparse.py", "_pydecimal.py", "tarfile.py", "turtle.py", "encodings/cp037.py")
    library = Path(os.__file__).parent
    for name in names:
        source = read_source(str(library / name))
        assert isinstance(source, gate.SourceText), name
        assert compile_refusal(source.text) is None, name


@pytest.mark.parametrize(
    "source",
    [
        "import rospy",
        "import sys, rospy",
        "from dynamic_reconfigure.server import Server",
        "try:\n    import actionlib\nexcept ImportError:\n    pass",
        "print 'old'\nfrom rospy.numpy_msg import numpy_msg",
    ],
)
def test_what_imports_only_ros_1_is_for_ros_1(source):
    assert gate.is_ros1(source.encode())


@pytest.mark.parametrize(
    "source",
    [
        "try:\n    import rclpy\nexcept ImportError:\n    import rospy",
        "from actionlib_msgs.msg import GoalStatus",
        "# import rospy",
        "x = 'rospy'",
        "from rospy_message_converter import message_converter",
    ],
)
def test_what_is_for_both_or_only_sounds_like_it_is_not(source):
    assert not gate.is_ros1(source.encode())
