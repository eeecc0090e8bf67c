"""The result of a run is kept whole, and a record with anything wrong is no answer."""

from __future__ import annotations

import json
from typing import Any

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.engine.result_cache import _digest
from archlint.finding import Finding
from archlint.syntax.cache import Store
from archlint.workspace.tree import TEXT_LIMIT

NODE = """\
from rclpy.node import Node
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = self.create_client(Trigger, '/robot/ask')
        self.client.wait_for_service()
"""


@pytest.fixture
def findings(tmp_path, monkeypatch):
    """Checks a node that waits without a limit, with a cache."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "home"))
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "node.py").write_text(NODE, "utf-8")
    monkeypatch.chdir(tmp_path / "src")

    def run() -> list[Finding]:
        return list(check(Request((".",), load(tmp_path / "src"), jobs=1)).findings)

    return run


@pytest.fixture
def kept(monkeypatch):
    """The records that runs read, each by way of a function that may change it."""
    read = Store.get_run
    seen: list[Any] = []
    changes: list[Any] = []

    def get_run(store: Store, key: str) -> bytes | None:
        payload = read(store, key)
        if payload is None or key.startswith("alike-"):
            return payload
        seen.append(json.loads(payload))
        for change in changes:
            change(seen[-1])
        return json.dumps(seen[-1]).encode()

    monkeypatch.setattr(Store, "get_run", get_run)
    return seen, changes


def test_a_second_run_is_answered_with_the_same_findings(findings, kept):
    first = findings()
    seen, _ = kept
    assert not seen
    assert findings() == first
    assert len(seen) == 1
    [waits] = [one for one in first if one.code == "TMO001"]
    assert waits.related and waits.identity
    assert [one.identity for one in findings()] == [one.identity for one in first]


def test_what_a_record_says_is_what_is_shown(findings, kept):
    findings()
    _, changes = kept
    changes.append(lambda record: record["result"]["findings"][0].update(message="from the record"))
    assert "from the record" in [one.message for one in findings()]


@pytest.mark.parametrize(
    "change",
    [
        lambda record: record.pop("result"),
        lambda record: record["result"].pop("summary"),
        lambda record: record["result"]["findings"][0].pop("place"),
        lambda record: record["result"]["findings"][0].update(severity=9),
        lambda record: record["result"]["findings"][0].update(message=["a list"]),
        lambda record: record["result"]["findings"][0]["place"].update(line="1"),
        lambda record: record["result"]["findings"][0].update(fix={"safety": "safe", "edits": [{}]}),
        lambda record: record["result"]["summary"].update(files="many"),
        lambda record: record.update(asked=[["content", "a.yaml"]]),
        lambda record: record.update(asked=[["content", "node.py", "another digest"]]),
    ],
)
def test_a_record_with_anything_wrong_is_a_miss(findings, kept, change):
    first = findings()
    seen, changes = kept
    changes.append(change)
    changes.append(lambda record: record.get("result", {}).update(remarks=["never shown"]))
    assert findings() == first
    assert seen


def test_fixes_are_made_where_they_are_asked_for_and_kept(tmp_path, findings, kept, monkeypatch):
    """A check without them leaves the sites, from which a later one makes them without linking anything."""
    settings = load(tmp_path / "src")
    without = check(Request((".",), settings, jobs=1, fixes=False)).findings
    assert [one.fix for one in without] == [None] * len(without) and any(one.sites for one in without)
    seen, _ = kept
    first = findings()
    assert len(seen) == 1 and {one.code for one in first if one.fix} == {"NME001"}
    monkeypatch.setattr("archlint.engine.mending.attach", None)
    assert findings() == first  # kept with what they edit
    uncached = check(Request((".",), settings, jobs=1, cached=False, fixes=False)).findings
    assert [(one.code, one.place, one.message) for one in uncached] == [(o.code, o.place, o.message) for o in first]


def test_of_a_large_file_only_as_much_counts_as_is_ever_read(tmp_path):
    def digest(first: bytes, last: bytes, size: int) -> str | None:
        path = tmp_path / "map.yaml"
        with path.open("wb") as stream:  # with a hole in it: nothing is written in between
            stream.write(first)
            stream.seek(size - len(last))
            stream.write(last)
        return _digest(path)

    size = 3 * TEXT_LIMIT
    known = digest(b"a", b"b", size)
    assert digest(b"a", b"c", size) == known
    assert digest(b"c", b"b", size) != known
    assert digest(b"a", b"b", size + 1) != known
    assert digest(b"a", b"b", 10) != digest(b"a", b"c", 10)
