"""PKG004: files that an installed module looks for beside itself, where no build puts them."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, SETUP, TALKER

FILES = {"robot/__init__.py": "", "robot/words.json": "{}", "data/words.json": "{}"}
INSTALLED = SETUP.replace("    name='robot',\n", "    name='robot',\n    packages=['robot'],\n")
IMPORTS = "import json\nimport os\nfrom pathlib import Path\n"


def of_talker(lines: str, **files: str) -> dict[str, str]:
    return {"setup.py": INSTALLED, "robot/talker.py": IMPORTS + lines + "\n" + TALKER} | FILES | files


@pytest.mark.parametrize(
    ("lines", "line", "what"),
    [
        ("WORDS = open(os.path.join(os.path.dirname(__file__), 'words.json'))", 4, "file 'robot/words.json'"),
        ("WORDS = open(os.path.dirname(os.path.abspath(__file__)) + '/words.json')", 4, "file 'robot/words.json'"),
        ("HERE = os.path.dirname(__file__)\nWORDS = open(f'{HERE}/words.json')", 5, "file 'robot/words.json'"),
        (
            "WORDS = open(os.path.join(os.path.dirname(__file__), '..', 'data', 'words.json'))",
            4,
            "file 'data/words.json'",
        ),
        ("WORDS = (Path(__file__).resolve().parent / 'words.json').read_text()", 4, "file 'robot/words.json'"),
        ("DATA = Path(__file__).parents[1] / 'data'\nWORDS = DATA / 'words.json'", 5, "file 'data/words.json'"),
        ("WORDS = Path(__file__).with_name('words.json').read_text()", 4, "file 'robot/words.json'"),
        ("DATA = os.path.join(os.path.dirname(os.path.dirname(__file__)), 'data')", 4, "folder 'data'"),
    ],
)
def test_a_file_beside_an_installed_module(findings, lines: str, line: int, what: str):
    (told,) = findings("PKG004", **of_talker(lines))
    assert told.message == (
        f"robot/talker.py looks for the {what} by a path from its own file on, where a build without "
        "--symlink-install puts Python code alone"
    )
    assert (told.place.file, told.place.line) == ("robot/talker.py", line)


def test_a_module_that_a_program_imports(findings):
    helper = "import os\n\nWORDS = open(os.path.join(os.path.dirname(__file__), 'words.json'))\n"
    files = of_talker("from robot import helper", **{"robot/helper.py": helper})
    (told,) = findings("PKG004", **files)
    assert (told.place.file, told.place.line) == ("robot/helper.py", 3)


OPENS = "WORDS = open(os.path.join(os.path.dirname(__file__), 'words.json'))"


@pytest.mark.parametrize(
    ("lines", "files"),
    [
        ("WORDS = open(os.path.join(os.path.dirname(__file__), 'gone.json'))", {}),
        ("PATH = Path(__file__).parent / 'words.json'\nWORDS = PATH.read_text() if PATH.exists() else ''", {}),
        ("open(os.path.join(os.path.dirname(__file__), 'words.json'), 'w').write('x')", {}),
        (
            "import sqlite3\n"
            "WORDS = sqlite3.connect(Path(__file__).with_name('words.json'))\n"
            "WORDS.execute('CREATE TABLE IF NOT EXISTS words (word TEXT)')",
            {},
        ),
        (
            OPENS + "\nfrom robot import maker",
            {"robot/maker.py": "from pathlib import Path\nPath(__file__).with_name('words.json').write_text('{}')\n"},
        ),
        ("HERE = os.path.dirname(__file__)", {}),
        ("HELPER = os.path.join(os.path.dirname(__file__), 'helper.py')", {"robot/helper.py": ""}),
        ("WORDS = open(os.path.join(os.path.dirname(__file__), NAME))", {}),
        (
            OPENS,
            {"setup.py": INSTALLED.replace("    packages=", "    package_data={'robot': ['*.json']},\n    packages=")},
        ),
        (OPENS, {"setup.py": SETUP}),  # which code is installed is not known
        (OPENS, {"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\nament_package()\n"}),
    ],
)
def test_a_file_that_is_there_or_may_be(findings, lines: str, files: dict[str, str]):
    told = findings("PKG004", **of_talker(lines, **files))
    assert [row for row in told if row.place.file == "robot/talker.py"] == []


def test_a_database_or_a_file_that_nothing_here_makes(findings):
    reads = "import sqlite3\nWORDS = sqlite3.connect(Path(__file__).with_name('words.json'))\n"
    maker = "from pathlib import Path\nPath(__file__).with_name('other.json').write_text('{}')\n"
    (told,) = findings("PKG004", **of_talker(reads + "from robot import maker", **{"robot/maker.py": maker}))
    assert told.place.file == "robot/talker.py"


def test_a_module_that_no_program_runs(findings):
    helper = "import os\n\nWORDS = open(os.path.join(os.path.dirname(__file__), 'words.json'))\n"
    assert findings("PKG004", **of_talker("", **{"robot/tool.py": helper})) == []


INTO = "    data_files=[('lib/python3.8/site-packages/robot/' + 'words', ['robot/words/{}'])],\n    packages="


@pytest.mark.parametrize(
    ("installed", "readme", "told"),
    [
        ("en.json", "For ROS 2 Foxy.", 0),
        ("en.json", "", 0),
        ("*.json", "For ROS 2 Foxy.", 0),
        ("en.json", "For ROS 2 Humble.", 1),
        ("de.json", "For ROS 2 Foxy.", 1),
    ],
    ids=["its Python", "no distribution is named", "by a pattern", "another Python", "another file"],
)
def test_a_file_that_data_files_puts_beside_the_modules(findings, installed: str, readme: str, told: int):
    """The folder has the version of Python in its name, which is that of one release of Ubuntu."""
    setup = INSTALLED.replace("    data_files=", "    data=").replace("    packages=", INTO.format(installed))
    if "*" in installed:
        setup = "from glob import glob\n" + setup.replace("['robot/words/*.json']", "glob('robot/words/*.json')")
    files = {"setup.py": setup, "robot/words/en.json": "{}", "robot/words/de.json": "{}", "README.md": readme}
    opens = "WORDS = open(os.path.join(os.path.dirname(__file__), 'words/en.json'))"
    found = findings("PKG004", **of_talker(opens, **files))
    assert len([row for row in found if row.place.file == "robot/talker.py"]) == told
