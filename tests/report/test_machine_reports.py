"""JSON, SARIF, GitHub, GitLab and JUnit."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest
from reports import NESTED, UNREADABLE, report

from archlint import rulebook
from archlint.finding import Edit, Fix, Place, Severity
from archlint.report import FORMATS, render, sarif

HOSTILE = replace(
    UNREADABLE,
    message="50% off,\n::error::fake \x1b[31m <b>&\"'",
    place=Place("odd, name:\udcff\n&%.py", 3, 1, 3, 1),
)


# --- JSON


def test_json_is_the_contract():
    assert json.loads(render("json", report(NESTED))) == {
        "version": 1,
        "diagnostics": [
            {
                "code": "SRV003",
                "name": "nested-service-call",
                "severity": "error",
                "message": "the handler of /plan waits for /map",
                "help": "use call_async",
                "file": "pkg/node.py",
                "line": 8,
                "column": 18,
                "end_line": 8,
                "end_column": 49,
                "node": "/planner",
                "system": None,
                "condition": None,
                "related": [
                    {
                        "file": "pkg/node.py",
                        "line": 4,
                        "column": 20,
                        "end_line": 4,
                        "end_column": 53,
                        "message": "the client is created here",
                    },
                    {
                        "file": "pkg/main.py",
                        "line": 1,
                        "column": 1,
                        "end_line": 1,
                        "end_column": 17,
                        "message": "one thread spins the node",
                    },
                ],
                "fix": None,
            }
        ],
        "summary": {
            "files": 42,
            "nodes": 21,
            "errors": 1,
            "warnings": 0,
            "infos": 0,
            "suppressed": 1,
            "unresolved": 2,
            "elapsed_s": 0.412,
            "baselined": 0,
            "older": 0,
            "unused": 0,
            "unused_files": 0,
            "vendored": 0,
            "unreached": 0,
        },
    }


def test_json_carries_a_fix():
    fix = Fix("safe", (Edit(Place("pkg/node.py", 8, 48, 8, 48), ", timeout_sec=1.0"),))
    document = json.loads(render("json", report(replace(NESTED, fix=fix))))
    edit = {"file": "pkg/node.py", "start": [8, 48], "end": [8, 48], "text": ", timeout_sec=1.0"}
    assert document["diagnostics"][0]["fix"] == {"safety": "safe", "edits": [edit]}


# --- SARIF


def results(*findings):
    return json.loads(render("sarif", report(*findings)))["runs"][0]


def test_sarif_names_rule_level_and_place():
    [result] = results(NESTED)["results"]
    assert (result["ruleId"], result["level"]) == ("SRV003", "error")
    assert result["message"]["text"] == "the handler of /plan waits for /map\nuse call_async"
    assert result["locations"] == [
        {
            "physicalLocation": {
                "artifactLocation": {"uri": "pkg/node.py"},
                "region": {"startLine": 8, "startColumn": 18, "endLine": 8, "endColumn": 49},
            }
        }
    ]
    assert [one["message"]["text"] for one in result["relatedLocations"]] == [
        "the client is created here",
        "one thread spins the node",
    ]
    assert result["properties"] == {"node": "/planner"}


def test_sarif_carries_the_pages_of_the_rules_that_found_something():
    rules = results(NESTED, UNREADABLE)["tool"]["driver"]["rules"]
    assert [rule["id"] for rule in rules] == ["LNT002", "SRV003"]
    assert rules[1]["help"]["markdown"] == rulebook.rules()["SRV003"].page
    assert "expect:" not in rules[1]["help"]["markdown"]


def test_sarif_paths_are_relative_uris():
    [result] = results(HOSTILE)["results"]
    uri = result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
    assert uri == "odd%2C%20name%3A%FF%0A%26%25.py"


def test_a_fingerprint_does_not_know_lines():
    moved = replace(NESTED, place=Place("pkg/node.py", 80, 1, 80, 2))
    marks = [results(one)["results"][0]["partialFingerprints"] for one in (NESTED, moved)]
    assert marks[0] == marks[1]


def test_fingerprints_tell_findings_apart():
    elsewhere = replace(NESTED, place=Place("pkg/other.py", 8, 18, 8, 49))
    about_another = replace(NESTED, identity=("/planner", "/goal"))
    marks = {
        result["partialFingerprints"]["archlint/v1"]
        for result in results(NESTED, NESTED, elsewhere, about_another, UNREADABLE)["results"]
    }
    assert len(marks) == 5


def test_sarif_keeps_to_the_limits_of_code_scanning(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(sarif, "MAX_RESULTS", 2)
    monkeypatch.setattr(sarif, "MAX_LOCATIONS", 2)
    info = replace(UNREADABLE, severity=Severity.INFO)
    run = results(info, UNREADABLE, NESTED)
    assert [result["ruleId"] for result in run["results"]] == ["LNT002", "SRV003"]
    assert [result["level"] for result in run["results"]] == ["warning", "error"]
    assert len(run["results"][1]["relatedLocations"]) == 1
    assert "1 findings are left out" in run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"]


def test_sarif_says_when_archlint_itself_failed():
    failed = replace(UNREADABLE, code="LNT003", name="internal-error")
    assert results(UNREADABLE)["invocations"] == [{"executionSuccessful": True}]
    assert results(failed)["invocations"] == [{"executionSuccessful": False}]


# --- GitHub


def test_github_annotates_the_line():
    assert render("github", report(NESTED)) == (
        "::error file=pkg/node.py,line=8,endLine=8,title=SRV003 nested-service-call,col=18,endColumn=49::"
        "pkg/node.py:8:18: SRV003 the handler of /plan waits for /map%0Ause call_async\n"
    )


def test_github_commands_cannot_be_forged():
    [command] = render("github", report(HOSTILE)).splitlines()
    properties = command.partition("file=")[2].partition("::")[0]
    assert properties.startswith("odd%2C name%3A")
    assert "&%25.py,line=3," in properties
    assert "50%25 off" in command
    assert "\x1b" not in command


def test_github_leaves_out_the_columns_of_several_lines():
    finding = replace(NESTED, place=Place("pkg/node.py", 8, 18, 9, 3))
    assert "col" not in render("github", report(finding)).split("::")[1]


# --- GitLab and JUnit


def test_gitlab_lists_issues():
    [issue] = json.loads(render("gitlab", report(NESTED)))
    assert len(issue.pop("fingerprint")) == 32
    assert issue == {
        "check_name": "SRV003",
        "description": "SRV003 nested-service-call: the handler of /plan waits for /map",
        "severity": "major",
        "location": {"path": "pkg/node.py", "lines": {"begin": 8, "end": 8}},
    }


def test_junit_has_a_failed_test_for_each_finding():
    suite = ElementTree.fromstring(render("junit", report(NESTED, HOSTILE)))[0]
    assert (suite.get("tests"), suite.get("failures")) == ("2", "2")
    failure = suite[0][0]
    assert failure.get("message") == "the handler of /plan waits for /map"
    assert "pkg/main.py:1:1: one thread spins the node" in (failure.text or "")


def test_junit_counts_only_what_fails_the_run():
    information = replace(NESTED, severity=Severity.INFO)
    suite = ElementTree.fromstring(render("junit", report(information, UNREADABLE)))[0]
    assert (suite.get("tests"), suite.get("failures")) == ("2", "1")
    assert suite[0].find("failure") is None
    assert "the handler of /plan waits for /map" in (suite[0].findtext("system-out") or "")


def test_junit_agrees_with_the_severity_that_was_asked_for():
    made = replace(report(NESTED, UNREADABLE), failing=Severity.ERROR)
    assert ElementTree.fromstring(render("junit", made))[0].get("failures") == "1"


def test_junit_has_only_what_the_schema_of_jenkins_allows():
    """By the elements and attributes of ``junit-10.xsd`` of the xUnit plugin, which refuses a file with any other."""
    counts = {"name", "time", "tests", "failures", "errors"}
    allowed = {
        "testsuites": counts,
        "testsuite": counts | {"skipped"},
        "testcase": {"name", "time", "classname"},
        "failure": {"type", "message"},
        "system-out": set(),
    }
    information = replace(NESTED, severity=Severity.INFO)
    for findings in ([], [NESTED, HOSTILE, information]):
        for element in ElementTree.fromstring(render("junit", report(*findings))).iter():
            assert set(element.attrib) <= allowed[element.tag]
    assert 'name="SRV003 nested-service-call (pkg/' in render("junit", report(NESTED))


def test_junit_without_findings_is_a_test_that_passed():
    suite = ElementTree.fromstring(render("junit", report()))[0]
    assert (suite.get("tests"), suite.get("failures"), len(suite[0])) == ("1", "0", 0)


@pytest.mark.parametrize("format", FORMATS)
def test_every_format_can_be_written_whatever_a_file_is_called(format: str):
    assert render(format, report(HOSTILE)).encode("utf-8")


@pytest.mark.parametrize("format", FORMATS)
def test_every_format_is_the_same_on_every_run(format: str):
    assert render(format, report(NESTED, UNREADABLE)) == render(format, report(NESTED, UNREADABLE))


@pytest.mark.skipif("SARIF_SCHEMA" not in os.environ, reason="SARIF_SCHEMA names no copy of the official schema")
def test_sarif_is_valid_by_the_official_schema():
    import jsonschema

    schema = json.loads(Path(os.environ["SARIF_SCHEMA"]).read_text("utf-8"))
    failed = replace(UNREADABLE, code="LNT003", name="internal-error", system="launch/robot.launch.py")
    for findings in ([], [NESTED, UNREADABLE, HOSTILE, failed]):
        jsonschema.validate(json.loads(render("sarif", report(*findings))), schema)
