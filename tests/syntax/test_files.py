"""Facts by file: what is parsed, what comes from the cache, and what is never kept there."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.syntax import files as syntax_files
from archlint.syntax import workers
from archlint.syntax.cache import NullStore, Store
from archlint.syntax.facts import FACTS_VERSION, Facts, encode
from archlint.syntax.files import FactsOfFiles
from archlint.syntax.python import gate, lowering
from archlint.workspace.model import SourceFile

WORDS = (b"rclpy",)
NODE = "import rclpy\nnode = rclpy.create_node('a')\n"


def source_file(path: Path, text: str, age: int = 3600) -> SourceFile:
    path.write_text(text)
    status = path.stat()
    # Older than the cache, or its time of change would not be trusted.
    return SourceFile(
        str(path),
        path.name,
        "python",
        None,
        path.stem,
        status.st_size,
        status.st_mtime_ns - age * 10**9,
        status.st_ino,
    )


@pytest.fixture
def cache(tmp_path):
    return lambda: Store(str(tmp_path / "cache"), "1", b"k" * 32)


def facts_of(files, store):
    found = FactsOfFiles(store, lambda: WORDS)
    found.prepare(files)
    facts = [found.facts_of(file) for file in files]
    store.close()
    return found, facts


def test_a_second_run_parses_nothing_and_reads_no_source(tmp_path, cache, monkeypatch):
    files = [source_file(tmp_path / "a.py", NODE), source_file(tmp_path / "b.py", NODE + "x = 1\n")]
    first, expected = facts_of(files, cache())
    monkeypatch.setattr(gate, "read_bytes", lambda path, limit=0: pytest.fail(f"read {path}"))
    second, facts = facts_of(files, cache())
    assert facts == expected
    assert (first.compiled, second.compiled) == (2, 0)


def test_a_changed_file_is_parsed_again_and_the_others_are_not(tmp_path, cache):
    files = [source_file(tmp_path / "a.py", NODE), source_file(tmp_path / "b.py", NODE + "x = 1\n")]
    facts_of(files, cache())
    files[1] = source_file(tmp_path / "b.py", NODE + "x = 2\n", age=3000)
    again, (_, changed) = facts_of(files, cache())
    assert again.compiled == 1
    assert changed.body[-1].value.value == 2


def test_a_file_that_moved_is_known_by_its_content(tmp_path, cache):
    facts_of([source_file(tmp_path / "a.py", NODE)], cache())
    moved, (facts,) = facts_of([source_file(tmp_path / "b.py", NODE)], cache())
    assert moved.compiled == 0
    assert len(facts.body) == 2


def test_the_screen_leaves_out_what_has_no_word_that_matters_until_it_is_asked_for(tmp_path, cache):
    file = source_file(tmp_path / "constants.py", "TOPIC = '/chatter'\n")
    found = FactsOfFiles(cache(), lambda: WORDS)
    found.prepare([file])
    assert not found.relevant(file)
    assert found.compiled == 0
    assert found.facts_of(file).body[0].value.value == "/chatter"
    assert found.compiled == 1


def test_what_a_compiled_file_imports_is_compiled_with_it_and_stays_screened_out(tmp_path):
    texts = {
        "node": NODE + "from helpers import TOPIC\n",
        "helpers": "from further import TOPIC\n",
        "further": "TOPIC = '/a'\n",
        "other": "",
    }
    files = [source_file(tmp_path / f"{name}.py", text) for name, text in texts.items()]
    found = FactsOfFiles(NullStore(), lambda: WORDS)
    found.prepare(files)
    assert found.compiled == 3
    assert [found.relevant(file) for file in files] == [True, False, False, False]
    assert all(found.facts_of(file) is not None for file in files[:3])
    assert found.compiled == 3


def test_what_imports_a_module_that_the_screen_kept_is_kept_too(tmp_path):
    base = source_file(tmp_path / "base.py", NODE)
    derived = source_file(tmp_path / "derived.py", "from base import Base\nclass A(Base): pass\n")
    other = source_file(tmp_path / "other.py", "import math\n")
    found = FactsOfFiles(NullStore(), lambda: WORDS)
    found.prepare([base, derived, other])
    assert [found.relevant(file) for file in (base, derived, other)] == [True, True, False]


def test_what_imports_a_kept_module_from_a_folder_that_it_puts_on_the_path_is_kept_too(tmp_path):
    """``sys.path.insert(0, …)`` and then the name below that folder, which only files of the same package can mean."""
    for folder in ("cell/simulation", "cell/training", "elsewhere"):
        (tmp_path / folder).mkdir(parents=True)
    caller = "from simulation.world import World\nWorld('trainer')\n"
    world = replace(source_file(tmp_path / "cell/simulation/world.py", NODE), package="cell")
    train = replace(source_file(tmp_path / "cell/training/train.py", caller), package="cell")
    other = replace(source_file(tmp_path / "elsewhere/train.py", caller), package="elsewhere")
    found = FactsOfFiles(NullStore(), lambda: WORDS)
    found.prepare([world, train, other])
    assert [found.relevant(file) for file in (world, train, other)] == [True, True, False]


def test_a_file_that_cannot_be_read_has_a_problem_and_is_tried_again(tmp_path, cache):
    file = source_file(tmp_path / "a.py", NODE)
    Path(file.path).unlink()
    _, (facts,) = facts_of([file], cache())
    assert facts.problems[0].message.startswith("cannot read this file")
    _, (facts,) = facts_of([source_file(tmp_path / "a.py", NODE)], cache())
    assert facts.problems == []


def test_a_syntax_error_is_cached_and_an_error_of_ours_is_not(tmp_path, cache, monkeypatch):
    monkeypatch.setattr(workers, "can_fork", lambda: False)
    files = [source_file(tmp_path / "wrong.py", "import rclpy\nx = (\n"), source_file(tmp_path / "a.py", NODE)]
    with monkeypatch.context() as broken:
        broken.setattr(lowering, "lower", lambda text: 1 // 0)
        found, (failed,) = facts_of(files[1:], cache())
        assert failed.problems[0].internal
        assert not found.lasting
    again, (wrong, right) = facts_of(files, cache())
    assert wrong.problems[0].message.startswith("syntax error")
    assert not wrong.problems[0].internal
    assert right.problems == []
    assert again.lasting
    assert facts_of(files, cache())[0].compiled == 0


def test_an_entry_of_another_archlint_is_compiled_once(tmp_path, cache, monkeypatch):
    files = [source_file(tmp_path / "a.py", NODE)]
    _, expected = facts_of(files, cache())
    store = cache()
    digest = store.lookup(files[0].path, files[0].stamp)
    store.put(digest, encode(Facts(FACTS_VERSION - 1)))
    assert facts_of(files, cache())[1] == expected
    monkeypatch.setattr(syntax_files, "compile_sources", None)
    assert facts_of(files, cache())[1] == expected


def test_a_damaged_entry_is_a_miss(tmp_path, cache):
    files = [source_file(tmp_path / "a.py", NODE)]
    _, expected = facts_of(files, cache())
    for entry in (tmp_path / "cache").rglob("facts/*/*"):
        entry.write_bytes(entry.read_bytes()[:-3])
    again, facts = facts_of(files, cache())
    assert facts == expected
    assert again.compiled == 1
