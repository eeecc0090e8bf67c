"""The reader of the rule book's examples."""

from __future__ import annotations

from pathlib import Path

import pytest

from rule_examples import Example, PageError, front_matter, load_examples, read_page, split_marker

PAGE = """\
---
code: SRV003
name: nested-service-call
severity: error            # error | warning | info
since: "0.1"
seed: ""
---
# SRV003 nested-service-call

## What it does
```python
not_an_example()
```

## Bad
```python
import rclpy
client.call(request)  # expect: SRV003, TMO002
```

## Bad: across two files
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
        ("bad", "across two files"),
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
        "seed": "",
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
