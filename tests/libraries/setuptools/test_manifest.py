"""What a setup.py reads from its manifest."""

from __future__ import annotations

import pytest

from installing import modules_of


@pytest.mark.parametrize(
    "name",
    [
        "ET.parse('package.xml').getroot().find('name').text",
        "ET.parse(os.path.join(here, 'package.xml')).findtext('name')",
        "minidom.parse('package.xml').getElementsByTagName('name')[0].firstChild.data",
        "parse_package(here).name",
        "ET.parse(Path(__file__).parent / 'package.xml').find('name').text.strip()",
    ],
)
def test_a_setup_py_that_reads_its_name_from_the_manifest(installs_of, name):
    installs = installs_of(
        **{
            "setup.py": f"""\
import os
import xml.etree.ElementTree as ET
from pathlib import Path
from xml.dom import minidom
from catkin_pkg.package import parse_package
from setuptools import setup
here = os.path.dirname(os.path.abspath(__file__))
name = {name}
setup(
    name=name,
    data_files=[('share/' + name, ['package.xml'])],
    entry_points={{'console_scripts': [f'talk = {{name}}.talk:main']}},
)
"""
        }
    )
    assert modules_of(installs) == {"talk": ("robot.talk", "main")}
    assert not installs.open_executables and not installs.open_files


@pytest.mark.parametrize("name", ["ET.parse('other.xml').getroot().find('name').text", "read('package.xml')"])
def test_a_name_from_elsewhere_leaves_the_executables_open(installs_of, name):
    text = f"""\
import xml.etree.ElementTree as ET
from setuptools import setup
from tools import read
setup(entry_points={{'console_scripts': ['talk = ' + {name} + '.talk:main']}})
"""
    assert installs_of(**{"setup.py": text}).open_executables
