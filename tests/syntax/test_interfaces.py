"""Interface files: what is read, and what ``rosidl`` would refuse."""

from __future__ import annotations

import pytest

from archlint.syntax.facts import FileProblem
from archlint.syntax.interfaces import FieldType, Interface, interface_problems, parse_interface, parse_type


def message(text: str):
    interface = parse_interface(text, "msg")
    assert interface.problems == []
    return interface.section("message")


def problems(text: str, kind: str = "msg") -> list[FileProblem]:
    return parse_interface(text, kind).problems


def test_a_message():
    section = message(
        "# A reading of one sensor.\n\nstd_msgs/Header header\nfloat64 value  # in m\nstring unit 'm'\nuint8 OK=0\n"
    )
    assert [(field.name, field.type.name, field.line) for field in section.fields] == [
        ("header", "std_msgs/msg/Header", 3),
        ("value", "float64", 4),
        ("unit", "string", 5),
    ]
    assert section.field("unit").default == "m"
    assert section.field("missing") is None
    assert [(constant.name, constant.value, constant.line) for constant in section.constants] == [("OK", 0, 6)]


def test_a_service():
    interface = parse_interface("int32 a\n---\nint32 sum\nbool ok\n", "srv")
    assert [field.name for field in interface.section("request").fields] == ["a"]
    assert [field.name for field in interface.section("response").fields] == ["sum", "ok"]
    assert interface.problems == []


def test_an_action():
    interface = parse_interface("float32 angle\n---\n# nothing\n---\nfloat32 left\n", "action")
    names = {section.name: [field.name for field in section.fields] for section in interface.sections}
    assert names == {"goal": ["angle"], "result": [], "feedback": ["left"]}


@pytest.mark.parametrize("kind", ["msg", "srv", "action"])
def test_an_interface_may_be_empty(kind):
    text = {"msg": "", "srv": "---\n", "action": "---\n---\n"}[kind]
    interface = parse_interface(text, kind)
    assert all(not section.fields for section in interface.sections)
    assert interface.problems == []


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("bool", FieldType("bool")),
        ("int32[]", FieldType("int32", "unbounded")),
        ("int32[3]", FieldType("int32", "fixed", 3)),
        ("int32[<=3]", FieldType("int32", "bounded", 3)),
        ("string<=10", FieldType("string", string_bound=10)),
        ("wstring<=10[<=5]", FieldType("wstring", "bounded", 5, 10)),
        ("geometry_msgs/Point[]", FieldType("geometry_msgs/msg/Point", "unbounded")),
        ("Point", FieldType("Point")),
    ],
)
def test_types(text, expected):
    assert parse_type(text) == expected


def test_a_bare_name_is_of_the_files_own_package():
    assert parse_type("Point").qualified("arm_msgs") == "arm_msgs/msg/Point"
    assert parse_type("geometry_msgs/Point").qualified("arm_msgs") == "geometry_msgs/msg/Point"
    assert parse_type("int8").qualified("arm_msgs") == "int8"


@pytest.mark.parametrize(
    ("line", "default"),
    [
        ("bool a true", True),
        ("bool a 0", False),
        ("uint8 a 0x1F", 31),
        ("int8 a -128", -128),
        ("float32 a -1.5e3", -1500.0),
        ("float32 a 1", 1.0),
        ('string a "it\'s"', "it's"),
        (r"string a 'it\'s'", "it's"),
        ("string a plain text", "plain text"),
        ("string a ''", ""),
        ("int32[] a [1, 2,3]", [1, 2, 3]),
        ("int32[<=3] a []", []),
        ("""string[] a ["x, y", 'z', w]""", ["x, y", "z", "w"]),
        ("wstring<=2 a 'ok'", "ok"),
        ("string a\t\t'tabs'", "tabs"),
        ("@optional int32 a", None),
    ],
)
def test_defaults(line, default):
    (field,) = message(line + "\n").fields
    assert field.default == default
    assert type(field.default) is type(default)


@pytest.mark.parametrize(
    ("line", "name", "value"),
    [
        ("uint8 MODE_AUTO=2", "MODE_AUTO", 2),
        ("int32 LOW = -5  # why", "LOW", -5),
        ("string FRAME=\"map\"", "FRAME", "map"),
        ("string FRAME=a = b", "FRAME", "a = b"),
        ("float64 PI=3.14", "PI", 3.14),
        ("bool ON=TRUE", "ON", True),
        ("byte B=255", "B", 255),
        ("char C=65", "C", 65),
        ("uint64 MOST=18446744073709551615", "MOST", 2**64 - 1),
    ],
)  # fmt: skip
def test_constants(line, name, value):
    (constant,) = message(line + "\n").constants
    assert (constant.name, constant.value) == (name, value)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("int32", "expected a type and a name"),
        ("int32 camelCase", "not a valid field name"),
        ("int32 a__b", "not a valid field name"),
        ("int32 a_", "not a valid field name"),
        ("int32 a=1", "not a valid constant name"),
        ("int33 a", "is not a type"),
        ("a/b/C c", "is not a type"),
        ("geometry_msgs/point a", "is not a type"),
        ("int32[0] a", "greater than 0"),
        ("string<=0 a", "greater than 0"),
        ("int32[x] a", "is not a type"),
        ("int32[" + "9" * 5000 + "] a", "is not a type"),
        ("Point A=1", "must have a primitive type"),
        ("Point a 1", "cannot have a default"),
        ("uint8 a 256", "does not fit uint8: expected 0 to 255"),
        ("int8 A=-129", "does not fit int8"),
        ("int32 a 1.5", "is not an integer"),
        ("float32 a 1,5", "is not a number"),
        ("bool a yes", "is not a bool"),
        ("int32[2] a [1]", "expected exactly 2 values, found 1"),
        ("int32[<=2] a [1, 2, 3]", "expected at most 2 values, found 3"),
        ("int32[] a 1, 2", "in brackets"),
        ("string<=2 a 'abc'", "at most 2"),
        ("string a 'it's'", "must be written as"),
        ("---", "without any white space"),
    ],
)
def test_a_line_that_rosidl_refuses(line, words):
    interface = parse_interface(f"int32 before\n  {line}\nint32 after\n", "msg")
    (problem,) = interface.problems
    assert words in problem.message
    assert (problem.line, problem.column) == (2, 3)
    assert [field.name for field in interface.section("message").fields] == ["before", "after"]


@pytest.mark.parametrize("text", ["int32 a\nint32 a\n", "int8 A=1\nint8 A=2\n"])
def test_a_name_defined_twice(text):
    (problem,) = problems(text)
    assert problem.line == 2
    assert "defined twice" in problem.message


@pytest.mark.parametrize(
    ("text", "kind", "words"),
    [
        ("int32 a\n", "srv", "expected 1 '---' in a .srv file, found 0"),
        ("int32 a\n---\n", "action", "expected 2 '---' in a .action file, found 1"),
        ("---\n---\n", "srv", "one '---' too many"),
    ],
)
def test_the_number_of_sections(text, kind, words):
    (problem,) = problems(text, kind)
    assert words in problem.message


def test_a_comment_begins_even_inside_a_string_as_in_rosidl():
    (constant,) = message("string COLOUR='#fff'\n").constants
    assert constant.value == "'"


def test_a_long_invalid_name_is_refused_at_once():
    (problem,) = problems("int32 " + "A" * 5000 + "a=1\n")
    assert "not a valid constant name" in problem.message


def test_an_interface_is_data():
    import msgspec

    interface = parse_interface("float64[3] a [1.0, 2.0, 3.0]\nstring A='x'\n---\nint8 ok\n", "srv")
    payload = msgspec.msgpack.encode(interface)
    assert msgspec.msgpack.decode(payload, type=Interface) == interface


@pytest.mark.parametrize(
    ("name", "refused"),
    [
        ("Speed.msg", False),
        ("Speed2.srv", False),
        ("Sample_Speed.msg", False),
        ("Speed_Request.msg", False),
        ("Turn_Goal_Request.msg", False),
        ("speed.msg", True),
        ("Motor_Speed.msg", True),
        ("2Speed.msg", True),
    ],
)
def test_the_name_of_a_file(tmp_path, name: str, refused: bool):
    """rosidl makes a class of it, and takes nothing but capitals first, letters and digits."""
    text = b"float64 a\n---\n" if name.endswith(".srv") else b"float64 a\n"
    problems = interface_problems(str(tmp_path / name), text)
    stem = name.partition(".")[0]
    words = f"{stem!r} is not a valid name for an interface: a capital letter first, then letters and digits"
    assert problems == ([(1, 1, words)] if refused else [])
