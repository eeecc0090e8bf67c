"""Every form that a name, type or QoS takes in real code: the linker against what the comments promise."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.render.json import document
from form_entities import FormEntity, read_forms

FORMS = Path(__file__).parents[2] / "fixtures" / "forms"
PLURAL = {
    "publisher": "publishers",
    "subscriber": "subscribers",
    "service": "services",
    "client": "clients",
    "action_server": "action_servers",
    "action_client": "action_clients",
}


@pytest.fixture(scope="module")
def found():
    """What archlint finds in the folder of forms, by file and line."""
    request = pipeline.Request((str(FORMS),), Settings(), cached=False)
    graph = document(pipeline.graph(request))
    rows = defaultdict(list)
    for node in graph["nodes"]:
        for kind, plural in PLURAL.items():
            for endpoint in node[plural]:
                rows[key(endpoint["file"], endpoint["line"])].append({"kind": kind, **endpoint})
        for timer in node["timers"]:
            rows[key(timer["file"], timer["line"])].append({"kind": "timer", **timer})
    return rows


def key(file: str, line: int) -> tuple[str, int]:
    path = Path(file)
    absolute = path if path.is_absolute() else Path.cwd() / path
    return absolute.resolve().relative_to(FORMS.resolve()).as_posix(), line


def described(row: dict) -> tuple:
    if row["kind"] == "timer":
        return ("timer", f"{row['period_s']:g}" if row["period_s"] is not None else "?", "")
    return (row["kind"], row["name"] or "?", row["type"] or "?", row["resolution"])


def promised(entity: FormEntity) -> tuple:
    if entity.kind == "timer":
        return ("timer", f"{float(entity.name):g}" if entity.name != "?" else "?", "")
    return (entity.kind, entity.name, entity.type, entity.resolution)


def by_line() -> dict[tuple[str, int], list[FormEntity]]:
    rows = defaultdict(list)
    for entity in read_forms(FORMS):
        rows[entity.file, entity.line].append(entity)
    return rows


LINES = by_line()


@pytest.mark.parametrize("place", sorted(LINES), ids=lambda place: f"{place[0]}:{place[1]}")
def test_a_form_resolves(place, found):
    want = sorted({promised(entity) for entity in LINES[place]})
    have = sorted({described(row) for row in found.get(place, [])})

    assert have == want


QOS = [entity for entity in read_forms(FORMS) if {"reliability", "durability", "depth", "history"} & entity.keys.keys()]


@pytest.mark.parametrize("entity", QOS, ids=lambda e: f"{e.file}:{e.line} {e.name}")
def test_a_profile_resolves(entity, found):
    rows = [row for row in found[entity.file, entity.line] if row["name"] == entity.name]
    wanted = {k: entity.keys[k] for k in ("reliability", "durability", "history") if k in entity.keys}
    if "depth" in entity.keys:
        wanted["depth"] = int(entity.keys["depth"]) if entity.keys["depth"].isdigit() else entity.keys["depth"]

    assert any(row["qos"] is not None and wanted.items() <= row["qos"].items() for row in rows), rows


def test_nothing_is_found_where_nothing_is_created(found):
    assert sorted(set(found) - set(LINES)) == []
