"""The reader of the rule book's examples."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.testing.pages import Example, PageError, front_matter, load_examples, read_page, split_marker

PAGE = """\
---
code: SRV003
name: nested-service-call
severity: error            # error | warning | info
since: "0.1"
---
# SRV003 nested-service-call

## Reported
```python
not_an_example()
```

## Bad
```python
import rclpy
client.call(request)  # expect: SRV003, TMO002
```

### Across two files
Prose between.

`pkg/handler.py`:

```python
call()  # expect: SRV003
```
`package.xml`:
```xml
<package/> <!-- expect: LNT002 -->
```

## Good
```console
$ archlint check
```
```python
future = client.call_async(request)
```
```toml
ignore = ["SRV003"]
```
"""


def test_each_section_is_one_workspace():
    assert [(example.section, example.title) for example in read_page("SRV003", PAGE)] == [
        ("bad", ""),
        ("bad", "Across two files"),
        ("good", ""),
    ]


def test_markers_become_expectations_and_leave_the_text():
    first = read_page("SRV003", PAGE)[0]
    assert first.files == {"node.py": "import rclpy\nclient.call(request)\n"}
    assert first.expected == [("node.py", 2, "SRV003"), ("node.py", 2, "TMO002")]


def test_a_line_in_backticks_names_the_file_that_follows():
    second = read_page("SRV003", PAGE)[1]
    assert second.files == {"pkg/handler.py": "call()\n", "package.xml": "<package/>\n"}
    assert second.expected == [("pkg/handler.py", 1, "SRV003"), ("package.xml", 1, "LNT002")]


def test_unnamed_blocks_take_the_usual_name_and_a_terminal_is_no_file():
    assert sorted(read_page("SRV003", PAGE)[2].files) == ["archlint.toml", "node.py"]


def test_a_rule_without_a_page_is_not_expected_yet(tmp_path: Path):
    (tmp_path / "SRV003-nested-service-call.md").write_text(PAGE, encoding="utf-8")
    (tmp_path / "README.md").write_text("# not a rule\n", encoding="utf-8")
    assert [example.expected for example in load_examples(tmp_path)] == [
        [("node.py", 2, "SRV003")],
        [("pkg/handler.py", 1, "SRV003")],
        [],
    ]


def test_files_are_laid_out_in_folders(tmp_path: Path):
    Example("SRV003", "bad", "", {"pkg/node.py": "import rclpy\n"}).write(tmp_path)
    assert (tmp_path / "pkg/node.py").read_text(encoding="utf-8") == "import rclpy\n"


def test_front_matter_drops_quotes_and_comments():
    assert front_matter(PAGE) == {
        "code": "SRV003",
        "name": "nested-service-call",
        "severity": "error",
        "since": "0.1",
    }


@pytest.mark.parametrize(
    ("line", "plain", "codes"),
    [
        ("x = 1", "x = 1", []),
        ("x = 1  # a comment", "x = 1  # a comment", []),
        ("x = 1  # expect: SRV003", "x = 1", ["SRV003"]),
        ("x = 1  # why  # expect: SRV003,TMO002", "x = 1  # why", ["SRV003", "TMO002"]),
        ("<a/> <!-- expect: LCH003 -->", "<a/>", ["LCH003"]),
    ],
)
def test_split_marker(line: str, plain: str, codes: list[str]):
    assert split_marker(line) == (plain, codes)


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("## Bad\n```python\nx  # expect: nested-service-call\n```\n", "not a marker"),
        ("## Bad\n```python\nx  # expect: SRV3\n```\n", "not a rule code"),
        ("## Good\n```python\nx  # expect: SRV003\n```\n", "cannot expect"),
        ("## Bad\n```python\na\n```\n```python\nb\n```\n", "two blocks"),
        ("## Bad\n```python\na\n", "never closed"),
    ],
)
def test_a_page_that_is_written_wrongly_is_refused(text: str, complaint: str):
    with pytest.raises(PageError, match=complaint):
        read_page("SRV003", text)


NODE = "from rclpy.node import Node\n\n\nclass Talker(Node):\n    pass\n"


def only_example(text: str) -> Example:
    (example,) = read_page("SRV003", text)
    return example


def test_a_heading_below_bad_starts_another_example():
    page = "## Bad\n```python\nx\n```\n\n### In a helper\n```python\ny\n```\n"
    assert [(one.title, one.files) for one in read_page("SRV003", page)] == [
        ("", {"node.py": "x\n"}),
        ("In a helper", {"node.py": "y\n"}),
    ]


def test_a_node_without_main_is_spun():
    text = only_example(f"## Good\n```python\n{NODE}```\n").files["node.py"]
    assert text.startswith(NODE)
    assert "    rclpy.spin(Talker())\n" in text


@pytest.mark.parametrize("extra", ["\n\nclass Listener(Node):\n    pass\n", "\n\ndef main():\n    pass\n"])
def test_main_is_left_to_a_page_with_several_nodes_or_its_own(extra: str):
    assert only_example(f"## Good\n```python\n{NODE}{extra}```\n").files == {"node.py": NODE + extra}


def test_files_of_a_package_get_the_rest_of_it():
    files = only_example("## Good\n`launch/robot.launch.py`:\n```python\nx\n```\n").files
    assert sorted(files) == ["launch/robot.launch.py", "package.xml", "robot/talker.py", "setup.cfg", "setup.py"]
    assert "rclpy.spin(Talker())" in files["robot/talker.py"]


def test_a_package_of_its_own_gets_nothing():
    page = "## Good\n`launch/a.launch.py`:\n```python\nx\n```\n`package.xml`:\n```xml\n<package/>\n```\n"
    assert sorted(only_example(page).files) == ["launch/a.launch.py", "package.xml"]


def test_a_setup_py_of_a_package_of_its_own_gets_a_setup_cfg():
    manifest = "`a/package.xml`:\n```xml\n<package><name>arm</name></package>\n```\n"
    files = only_example(f"## Good\n`a/setup.py`:\n```python\nx\n```\n{manifest}").files
    assert sorted(files) == ["a/package.xml", "a/setup.cfg", "a/setup.py"]
    assert "install_scripts=$base/lib/arm" in files["a/setup.cfg"]


def test_a_folded_block_is_a_file_too():
    page = "## Good\n<details><summary><code>tox.ini</code></summary>\n\n```ini\n[metadata]\n```\n\n</details>\n"
    assert only_example(page).files == {"tox.ini": "[metadata]\n"}
