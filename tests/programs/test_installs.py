"""What a package installs by CMake, and what is left open."""

from __future__ import annotations

import pytest

from archlint.programs.installs import read_cmake
from archlint.workspace.installed import Installs
from builds import Build


def installs(text: str, **files: str) -> Installs:
    found = Installs("robot", "robot")
    texts = {"CMakeLists.txt": f"project(robot)\n{text}"}
    texts |= files
    read_cmake(found, "robot/CMakeLists.txt", Build({f"robot/{name}": text for name, text in texts.items()}))
    return found


def test_the_block_that_every_python_package_copies_leaves_nothing_open():
    found = installs(
        """
        ament_python_install_package(${PROJECT_NAME})
        install(PROGRAMS scripts/talk.py DESTINATION lib/${PROJECT_NAME})
        install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
        if(BUILD_TESTING)
          find_package(ament_cmake_pytest REQUIRED)
          set(_pytest_tests test/test_a.py test/test_b.py)
          foreach(_test_path ${_pytest_tests})
            get_filename_component(_test_name ${_test_path} NAME_WE)
            ament_add_pytest_test(${_test_name} ${_test_path} TIMEOUT 60)
          endforeach()
        endif()
        ament_package()
        """
    )
    assert list(found.executables) == ["talk.py"]
    assert not found.open_executables and not found.open_files and not found.mentioned


def test_a_project_is_no_executable_and_what_an_unknown_command_makes_may_be_one():
    found = installs("find_package(arm)\nadd_library(hand hand.cpp)\nmake_driver(driver)\n")
    assert not found.executables
    assert found.mentioned == {"driver"}


@pytest.mark.parametrize(
    ("text", "open_"),
    [
        ("ament_python_install_package(robot SCRIPTS_DESTINATION lib/robot)", False),  # setup.cfg is read anyway
        ("ament_python_install_package(tools PACKAGE_DIR src/tools SCRIPTS_DESTINATION lib/robot)", False),
        ("ament_python_install_package(gone PACKAGE_DIR gone/tools SCRIPTS_DESTINATION lib/robot)", True),
        ("ament_python_install_package(robot SETUP_CFG ${X} SCRIPTS_DESTINATION lib/robot)", True),
        ("install(PROGRAMS ${CMAKE_CURRENT_BINARY_DIR}/made.py DESTINATION lib/robot)", True),
        ("install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/scripts/ DESTINATION lib/robot)", False),
        ("install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})", False),
        ("install(FILES a.cmake DESTINATION ${CMAKE_INSTALL_FULL_LIBDIR}/cmake/robot)", False),
        ("install(DIRECTORY include/ DESTINATION include/${VERSION})", False),
        ("install(DIRECTORY scripts/ DESTINATION ${SOMEWHERE})", True),
        ("install(DIRECTORY scripts/ DESTINATION lib/${SOMEWHERE})", True),
    ],
)
def test_what_leaves_the_executables_open(text: str, open_: bool):
    scripts = "[options.entry_points]\nconsole_scripts =\n  go = tools:go\n"
    tables = {"setup.cfg": "[metadata]\n", "src/setup.cfg": scripts}
    found = installs(text, **tables)
    assert found.open_executables is open_
    assert ("go" in found.executables) is ("src/tools" in text)


def test_a_command_that_is_given_nothing_may_make_the_executables():
    assert installs("find_package(acme_auto_package)\nacme_auto_package()").open_executables
    assert not installs("add_executable(talker talker.cpp)\ninstall(TARGETS talker)\nacme_package()").open_executables
    assert not installs("enable_testing()\nament_package()").open_executables


def test_a_list_in_quotes_is_several_interfaces():
    built = installs('set(files "msg/A.msg" "msg/B.msg")\nrosidl_generate_interfaces(${PROJECT_NAME} "${files}")\n')
    assert built.generated == {"robot", "msg/A.msg", "msg/B.msg"}
    assert [needed.path for needed in built.needed] == ["robot/msg/A.msg", "robot/msg/B.msg"]
