"""The files around the code: parameters, manifests, setup files, CMake, interfaces, configuration."""

from __future__ import annotations

import json
from collections.abc import Sequence
from xml.sax.saxutils import escape

from msgspec.structs import fields

from archlint.config.schema import ConfigurationFile
from archlint.rulebook import rules
from benchmarks.fuzz.pick import ODD_NAMES, Pick

_YAML = (
    *(
        "1",
        "-1",
        "0x1F",
        "1e5",
        ".inf",
        "-.nan",
        "true",
        "off",
        "null",
        "~",
        "''",
        "0o17",
        "1_000",
        "12:30:45",
        "2001-01-01",
        "9" * 60,
    ),
    *(
        "[1, 2.0, 'a']",
        "[]",
        "{}",
        "{a: 1}",
        "[[1], [2]]",
        "*odd",
        "&odd 1",
        "!!binary aGVsbG8=",
        "!!python/object:os.system {}",
        "!",
        "|\n      text",
    ),
)


def parameter_file(pick: Pick) -> str:
    """A parameter file: nodes by name or by star, and what stands there by mistake."""

    def node() -> str:
        name = pick.one("robot", "/robot", "/**", "/*", "/**/robot", "'robot'", "?", json.dumps(pick.name()))
        section = pick.one("ros__parameters", "ros__parameters", "ros__parameters", "ros_parameters", "parameters")
        rows = [f"    {key(pick)}: {pick.among(_YAML)}" for _ in range(pick.number(0, 4))]
        if pick.rarely(3):
            rows += ["    deeper:", *(f"      {key(pick)}: {pick.among(_YAML)}" for _ in range(pick.number(0, 3)))]
        return f"{name}:\n  {section}:\n" + "\n".join(rows)

    return (
        pick.one("", "", "%TAG ! x:\n---\n", "\ufeff")
        + "\n".join(pick.some(node, 3))
        + pick.one("\n", "", "\n---\n", "\n\t- x\n")
    )


def key(pick: Pick) -> str:
    return pick.one("rate", "topic", "use_sim_time", "a.b", "gains", "names", "1", "<<", "? x", json.dumps(pick.name()))


def package_xml(pick: Pick) -> str:
    """A manifest; the package is called ``robot`` most of the time."""
    name = pick.one("robot", "robot", "robot", "robot", escape(pick.name()))
    kind = pick.one("ament_python", "ament_python", "ament_cmake", "catkin", "odd", "")
    tags = ("depend", "exec_depend", "build_depend", "test_depend", "member_of_group", "buildtool_depend", "odd")
    needs = [
        f"  <{tag}>{pick.one('rclpy', 'std_msgs', 'robot', escape(pick.name()))}</{tag}>"
        for tag in tags
        if pick.rarely(2)
    ]
    condition = pick.one("", "", ' condition="$ROS_VERSION == 2"', ' condition="(((("')
    export = f"  <export{condition}><build_type>{kind}</build_type></export>" if kind else ""
    head = pick.one("", "", '<?xml version="1.0"?>\n', '<!DOCTYPE p [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n')
    return "\n".join(
        [
            f'{head}<package format="{pick.one("3", "2", "9", "x")}">',
            f"  <name>{name}</name>",
            *needs,
            export,
            "</package>\n",
        ]
    )


def setup_py(pick: Pick) -> str:
    """A ``setup.py`` as it should be, but for some of its values."""
    scripts = ", ".join(repr(_entry(pick)) for _ in range(pick.number(0, 3)))
    data = pick.one(
        "[('share/robot/launch', glob('launch/*')), ('share/robot/config', ['config/robot.yaml'])]",
        "[(os.path.join('share', name, d), glob(d + '/**', recursive=True)) for d in os.listdir('.')]",
        "[('share/' + name)]",
        "files()",
        "[('share/robot', ['package.xml'] * 10**9)]",
    )
    packages = pick.one(
        "['robot']", "find_packages(exclude=['test'])", "find_packages(where='src')", "[name]", "None", "robot"
    )
    scripts = pick.one(
        f"{{'console_scripts': [{scripts}]}}",
        f"{{'console_scripts': [{scripts}]}}",
        f"'''[console_scripts]\n{scripts}'''",
        "dict(a=1)",
    )
    folder = pick.one("", "", ", package_dir={'': 'src'}", ", package_dir={'robot': '../..'}", ", **options")
    return (
        "import os\nfrom glob import glob\nfrom setuptools import find_packages, setup\n"
        f"name = {pick.name()!r}\n"
        f"setup(name='robot', packages={packages}, data_files={data},\n    entry_points={scripts}{folder})\n"
    )


def _entry(pick: Pick) -> str:
    return pick.one(
        "robot = robot.node:main",
        "robot=robot.node:main",
        "talker = robot.node:main [x]",
        "a = b",
        "= :",
        f"{pick.name()} = {pick.name()}:{pick.name()}",
    )


def setup_cfg(pick: Pick) -> str:
    """A ``setup.cfg``."""
    rows = "\n".join(f"    {_entry(pick)}" for _ in range(pick.number(0, 3)))
    section = pick.one("options.entry_points", "options.entry_points", "develop", "options.data_files", "[", "DEFAULT")
    rest = f"[develop]\nscript_dir=$base/lib/{pick.name()}\n%({pick.name()})s = %(a)s\n"
    return f"[{section}]\nconsole_scripts =\n{rows}\n{rest}"


_COMMANDS = (
    "install(PROGRAMS robot/node.py DESTINATION lib/${PROJECT_NAME})",
    "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})",
    "ament_python_install_package(${PROJECT_NAME} PACKAGE_DIR src)",
    'rosidl_generate_interfaces(${PROJECT_NAME} ${files} "msg/State.msg" DEPENDENCIES std_msgs)',
    'set(A "${A}${A}") set(A ${A};${A})',
    "foreach(x IN LISTS A) install(FILES ${x} DESTINATION ${${x}}) endforeach()",
    'if(A AND (NOT B OR ("${C}" STREQUAL "x"))) else() endif()',
    'file(GLOB files RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} "msg/*.msg" "../../*")',
    "macro(m a) set(${a} ${ARGN} PARENT_SCOPE) m(${a}) endmacro() m(x)",
    "function(f) f() endfunction() f()",
    "include(other.cmake) add_subdirectory(..)",
    "#[==[ open",
    "install(TARGETS",
    'message([=[a]=] "\\${x}" $ENV{HOME} $<TARGET:x>)',
    "string(REPEAT a 1000000000 A)",
    "list(APPEND A ${A} ${A})",
)


def cmake(pick: Pick) -> str:
    """A ``CMakeLists.txt``."""
    lines = [pick.among(_COMMANDS) for _ in range(pick.number(0, 6))]
    return (
        "\n".join(
            [
                f"project({pick.one('robot', 'robot', json.dumps(pick.name()))})",
                *lines,
                pick.one("ament_package()", "", ")", "\\"),
            ]
        )
        + "\n"
    )


_FIELDS = (
    *(
        "int32 a",
        "string b",
        "float64[] c",
        "float64[3] d",
        "string<=5[<=2] e",
        "std_msgs/Header header",
        "State nested",
        "Odd/Type f",
        "byte g 300",
    ),
    *(
        "int32 A=1",
        "string TEXT='x",
        "uint8 BIG=99999999999999999999",
        "int8[] h [1, 2",
        "bool i maybe",
        "float32 NAN=nan",
        'wstring j "\\u1234"',
    ),
    *(
        "int32 a",
        "int32[<=] k",
        "int32[99999999999999999999] l",
        "string m 'a\\'b' # c",
        '@verbatim (language="x", text=',
        "# archlint: ignore[TYP001]",
    ),
    *("int32 1st", "int32 ", "= 1", "----", "uint8 n {1: 2}", "duration o"),
)


def interface(pick: Pick, parts: int) -> str:
    """A message, service or action: so many parts, now and then another number."""
    parts += pick.one(-1, 1) if pick.rarely() else 0
    texts = ["\n".join(pick.among(_FIELDS) for _ in range(pick.number(0, 4))) for _ in range(max(1, parts))]
    return "\n---\n".join(texts) + "\n"


_TOML = (
    *(
        "true",
        "1",
        "-1",
        "1.5",
        "nan",
        '"x"',
        '["SRV", "TOP002"]',
        '["ALL"]',
        "[]",
        "{}",
        '{a = "b"}',
        '[["a"]]',
        "1979-05-27",
        '"""a',
        "[1",
        "''",
    ),
    *(
        '"jazzy"',
        '"strict"',
        '"/etc/passwd"',
        '"../.."',
        '["/cmd_vel", "/**"]',
        '["launch/robot.launch.py"]',
        '["launch/*"]',
        '["**/[", "{a,b"]',
    ),
)


def archlint_toml(pick: Pick, prefix: str = "") -> str:
    """A configuration; ``prefix`` is the table that holds it."""
    rows = [f"{name} = {pick.among(_TOML)}" for name in pick.some(lambda: _key(pick), 3)]
    tables = pick.some(lambda: _table(pick, prefix), 2)
    return "\n".join([*([f"[{prefix[:-1]}]"] if prefix else []), *rows, *tables]) + "\n"


def _key(pick: Pick) -> str:
    return (
        pick.among([field.encode_name for field in fields(ConfigurationFile)])
        if not pick.rarely(10)
        else json.dumps(pick.name())
    )


def _table(pick: Pick, prefix: str) -> str:
    names = [rule.name for rule in rules().values()]
    option = pick.one("most", "at-least", "seconds", "depth")
    kind = pick.one("forbid", "require", "qos", "odd")
    patterns = json.dumps(pick.one(["/robot"], ["/**"], ["*"], [], list(ODD_NAMES[:9])))
    return pick.one(
        f"[{prefix}rules.{pick.among(names)}]\n{option} = {pick.among(_TOML)}",
        f"[{prefix}layers]\norder = {patterns}\n{pick.one('mission', 'control', '1')} = {patterns}",
        f'[{prefix}owners]\n"/cmd_vel" = {pick.among(_TOML)}',
        f'[[{prefix}contracts]]\nname = "a"\nkind = "{kind}"\nfrom = {patterns}\nto = {pick.among(_TOML)}',
        f'[{prefix}severity]\n"{pick.one("SRV003", "ALL", "odd", "TOP")}" = "{pick.one("error", "info", "fatal")}"',
        f'[{prefix}per-file-ignores]\n{json.dumps(pick.name())} = ["{pick.one("ALL", "NME", "x")}"]',
    )


def pyproject(pick: Pick) -> str:
    """A ``pyproject.toml`` with a configuration and scripts."""
    scripts = f"[project.scripts]\nrobot = {json.dumps(_entry(pick))}\n" if pick.rarely(2) else ""
    return scripts + archlint_toml(pick, "tool.archlint.")


IGNORE_FILES: Sequence[str] = ("build/\n", "*\n!*.py\n", "**/**/x\n", "[a-\n", "\\\n", "/robot/*\n", "!\n", "\ufeff#\n")
