"""Which folders a setup.py makes packages of, under another name than their own."""

from __future__ import annotations

import pytest

from archlint.workspace.package_folders import package_folders


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("setup(package_dir={'arm': 'scripts'})", {"scripts": "arm"}),
        (
            'name = "arm"\nsetup(name=name, package_dir={name: "src/python", "arm.tools": "tools"})',
            {"src/python": "arm", "tools": "arm.tools"},
        ),
        ("setup(package_dir={'': 'src'})", {}),
        ("setup(package_dir={\n    # 'arm': 'old',\n    'arm': 'new',\n})", {"new": "arm"}),
        ("setup(package_dir={arm(): 'scripts'})", {}),
        ("setup(package_dir=folders)", {}),
        ("setup(package_dir={'arm': 'code'})  # it was package_dir={'arm': 'old'}", {"code": "arm"}),
        ("help = \"package_dir={'arm': 'old'}\"\nsetup(package_dir={'arm': 'code'})", {"code": "arm"}),
        ("sign = '#'; setup(package_dir={'arm': 'a#b/c', 'tools': 'tools'})", {"tools": "tools"}),
        ("setup(package_dir={'arm': 'a' 'b', 'tools': join('a', 'b'), 'joints': 'joints'})", {"joints": "joints"}),
        ("def name():\n    name = 'arm'\nsetup(package_dir={name: 'code'})", {}),
        ("name = 'arm' + suffix\nsetup(package_dir={name: 'code'})", {}),
        ("print 'a Python of old'\nsetup(package_dir={'arm': 'code'})", {"code": "arm"}),
        ("setup(package_dir={'arm': 'code'}, name='not closed", {"code": "arm"}),
        ("(" * 5_000 + "package_dir", {}),
    ],
)
def test_folders_that_a_setup_py_names(text: str, expected: dict[str, str]):
    assert package_folders(f"from setuptools import setup\n{text}\n") == expected
