"""What CMake files come to: variables, loops, functions and other files, and what is left open."""

from __future__ import annotations

from textwrap import dedent

import pytest

from archlint.programs.installs import read_cmake
from archlint.workspace.cmake import parse_cmake
from archlint.workspace.cmake_run import CMakeRun
from archlint.workspace.installed import Installs
from builds import Build


def path_of(name: str) -> str:
    return name.replace("__", "/").replace("_txt", ".txt").replace("_cmake", ".cmake")


def run(text: str, **files: str) -> CMakeRun:
    """The steps of ``robot/CMakeLists.txt``; ``src__CMakeLists_txt`` is the file src/CMakeLists.txt beside it."""
    texts = {"CMakeLists.txt": f"project(robot)\n{dedent(text)}"}
    texts |= {path_of(name): text for name, text in files.items()}
    build = Build({f"robot/{name}": text for name, text in texts.items()})
    done = CMakeRun(build.text, build.files_below)
    done.run("robot/CMakeLists.txt", "robot")
    return done


def calls(done: CMakeRun, name: str = "add_executable") -> list[list[str]]:
    return [step.command.texts for step in done.steps if step.command.name == name]


def test_comments_quotes_and_brackets():
    text = '#[[ set(A 1) ]]\nset(B "x;y z") # set(C 1)\nset(D [=[ a ) b ]=])\nfoo(${B} "${B}")\n'
    assert calls(run(text), "foo") == [["x", "y z", "x;y z"]]
    assert parse_cmake(text)[-1].line == 4


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("foreach(n a b)\nadd_executable(${n})\nendforeach()", ["a", "b"]),
        ("set(ALL a b)\nforeach(n IN LISTS ALL)\nadd_executable(${n})\nendforeach()", ["a", "b"]),
        ("set(ALL a)\nlist(APPEND ALL b)\nforeach(n ${ALL} c)\nadd_executable(${n})\nendforeach()", ["a", "b", "c"]),
        ("foreach(n IN ITEMS a b)\nadd_executable(${n}_node)\nendforeach()", ["a_node", "b_node"]),
        ("foreach(n RANGE 1 3)\nadd_executable(wheel_${n})\nendforeach()", ["wheel_1", "wheel_2", "wheel_3"]),
        ("foreach(n a)\nforeach(m x y)\nadd_executable(${n}_${m})\nendforeach()\nendforeach()", ["a_x", "a_y"]),
        ("foreach(f src/a.cpp)\nget_filename_component(n ${f} NAME_WE)\nadd_executable(${n})\nendforeach()", ["a"]),
        ("string(REPLACE .cpp _node n a.cpp)\nadd_executable(${n})", ["a_node"]),
        ("macro(make name)\nadd_executable(${name} ${ARGN})\nendmacro()\nmake(a)\nmake(b)", ["a", "b"]),
        ("function(make name)\nadd_executable(${name}_${PROJECT_NAME})\nendfunction()\nmake(a)", ["a_robot"]),
        ("foreach(n ${UNKNOWN})\nadd_executable(${n})\nendforeach()", ["${n}"]),
        ("if(A)\nset(n a)\nelse()\nset(n b)\nendif()\nadd_executable(${n})", ["${n}"]),  # one of the two
        ("set(n a)\nexecute_process(COMMAND git OUTPUT_VARIABLE n)\nadd_executable(${n})", ["${n}"]),
    ],
)
def test_variables_loops_and_functions(text: str, names: list[str]):
    assert [texts[0] for texts in calls(run(text))] == names


OF_EACH = """
    foreach(name talker listener)
      if({test})
        set(source src/talk/${{name}}.cpp)
      {other}
        set(source src/${{name}}.cpp)
      endif()
      add_executable(${{name}} ${{source}})
    endforeach()
"""


@pytest.mark.parametrize(
    "test", ['${name} STREQUAL "talker"', '"${name}" STREQUAL talker', "NOT ${name} STREQUAL listener"]
)
@pytest.mark.parametrize("other", ["else()", 'elseif(${name} STREQUAL "listener")'])
def test_a_branch_that_compares_the_value_of_a_loop_runs_for_this_value_alone(test: str, other: str):
    made = calls(run(OF_EACH.format(test=test, other=other)))
    assert made == [["talker", "src/talk/talker.cpp"], ["listener", "src/listener.cpp"]]


@pytest.mark.parametrize("test", ["WITH_TALK", '${CMAKE_BUILD_TYPE} STREQUAL "Debug"', "${name} MATCHES talk"])
def test_both_branches_of_any_other_condition_run(test: str):
    made = calls(run(OF_EACH.format(test=test, other="else()")))
    assert made == [["talker", "${source}"], ["listener", "${source}"]]


def test_a_branch_that_compares_what_a_call_is_given():
    text = """
        function(make name kind)
          if(kind STREQUAL "node")
            add_executable(unsure_${name})
          endif()
          if("${kind}" STREQUAL "node")
            add_executable(${name})
          else()
            add_library(${name})
          endif()
        endfunction()
        make(talker node)
        make(drivers library)
    """
    made = run(text)
    assert calls(made) == [["unsure_talker"], ["talker"], ["unsure_drivers"]]
    assert calls(made, "add_library") == [["drivers"]]


@pytest.mark.parametrize(
    ("of_ros1", "other"),
    [
        ('ROS_EDITION STREQUAL "ROS1"', "else()"),
        ('"${ROS_EDITION}" STREQUAL "ROS1"', 'elseif("${ROS_EDITION}" STREQUAL "ROS2")'),
        ('NOT ROS_EDITION STREQUAL "ROS2"', "else()"),
        ("$ENV{ROS_VERSION} EQUAL 1", "else()"),
        ('"$ENV{ROS_VERSION}" STREQUAL "1"', "elseif($ENV{ROS_VERSION} EQUAL 2)"),
    ],
)
def test_of_two_editions_of_ros_the_second_is_built(of_ros1: str, other: str):
    text = f"""
        if({of_ros1})
          add_executable(of_ros1)
        {other}
          add_executable(of_ros2)
        endif()
    """
    assert calls(run(text)) == [["of_ros2"]]


def test_what_a_build_may_be_configured_with_decides_no_branch():
    text = """
        set(BACKEND a CACHE STRING "which driver")
        function(make name)
          if("${name}" STREQUAL "a")
            add_executable(of_a)
          else()
            add_executable(of_others)
          endif()
        endfunction()
        make(${BACKEND})
    """
    assert calls(run(text)) == [["of_a"], ["of_others"]]


def test_other_files_run_in_their_own_folder():
    done = run(
        """
        set(WHO me)
        add_subdirectory(src)
        include(cmake/nodes.cmake)
        include(GNUInstallDirs)
        add_executable(${INNER})
        """,
        src__CMakeLists_txt="set(INNER x)\nadd_executable(${WHO} main.cpp)\n",
        cmake__nodes_cmake="add_executable(other)\n",
    )
    assert [(step.folder, step.command.texts[0]) for step in done.steps if step.command.name == "add_executable"] == [
        ("robot/src", "me"),
        ("robot", "other"),
        ("robot", "${INNER}"),  # a subdirectory's variables are its own
    ]
    assert done.files == ["robot/CMakeLists.txt", "robot/src/CMakeLists.txt", "robot/cmake/nodes.cmake"]
    assert not done.open


@pytest.mark.parametrize(
    "text", ["add_subdirectory(gone)", "include(gone.cmake)", "add_subdirectory(${WHERE})", "include(${X})"]
)
def test_what_cannot_be_read_is_open(text: str):
    assert run(text).open


@pytest.mark.parametrize(
    "text",
    [
        "macro(again)\nagain()\nagain()\nendmacro()\nagain()",
        "add_subdirectory(.)",
        "include(CMakeLists.txt)",
        "foreach(a RANGE 1900)\nforeach(b RANGE 1900)\nadd_executable(${a}${b})\nendforeach()\nendforeach()",
    ],
)
def test_what_does_not_end_is_cut(text: str):
    assert run(text).open


@pytest.mark.parametrize(
    ("other", "sources"),
    [
        ("src/real.cpp src/shared.cpp", ("robot/src/shared.cpp",)),  # which branch runs is not known
        ("src/fake.cpp src/shared.cpp", ("robot/src/fake.cpp", "robot/src/shared.cpp")),
    ],
)
def test_an_executable_of_two_branches_has_the_sources_that_both_have(other: str, sources: tuple[str, ...]):
    text = f"if(FAKE)\nadd_executable(it src/fake.cpp src/shared.cpp)\nelse()\nadd_executable(it {other})\nendif()\n"
    build = Build({"robot/CMakeLists.txt": f"project(robot)\n{text}install(TARGETS it DESTINATION lib/robot)\n"})
    installs = Installs("robot", "robot")
    read_cmake(installs, "robot/CMakeLists.txt", build)
    assert installs.executables["it"].sources == sources
