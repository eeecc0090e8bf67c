"""Programs are plain data: written as MessagePack and read again, they are judged as before."""

from __future__ import annotations

import collections.abc
import re
from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from types import UnionType
from typing import Any, ForwardRef, Literal, Union, get_args, get_origin

import msgspec
import pytest

from archlint import branches, finding, origins, place, reasons
from archlint.branches import ChoiceOfCallee, CodeBranch
from archlint.cli import main
from archlint.finding import Place
from archlint.model import (
    ApiCall,
    Blueprint,
    Callback,
    Creation,
    EntityKind,
    ExecutorKind,
    ExecutorUse,
    Program,
    Role,
    Spell,
    SpinDuration,
    Text,
    absent_reads,
    calls,
    encoding,
    executors,
    futures,
    given,
    kinds,
    messages,
    nodes,
    programs,
    refused,
    texts,
    transforms,
)
from archlint.model.encoding import NotEncodable, NotPrograms, decode, encode
from archlint.programs.entry import EntryPoint
from archlint.programs.linker import Linker
from archlint.reasons import NotPassed
from archlint.ros import interfaces, parameter_types, qos

FIXTURES = Path(__file__).parents[2] / "fixtures"
PLACE = Place("robot/node.py", 3, 5, 3, 9)


def program() -> Program:
    """A node with a timer whose callback calls something, all of which refer to one another."""
    name = Text("robot", "exact")
    unknown = Text(None, "unknown", reason=NotPassed.as_parameter("namespace"))
    node = Blueprint("Robot", name, unknown, PLACE, "robot", executables=("robot",))
    callback = Callback(Role.TIMER, "Robot.tick", PLACE, None, node)
    timer = Creation(EntityKind.TIMER, "an.api", node, PLACE, name, None, callbacks={"timer": callback})
    timer.branch_arms = frozenset({(ChoiceOfCallee(PLACE.file, 3, 5), 1)})
    callback.creation = timer
    node.creations.append(timer)
    spell = Spell(PLACE, SpinDuration.A_WHILE, False, False, 1)
    use = ExecutorUse(ExecutorKind.SINGLE_THREADED, 1, [node], PLACE, spells={node: [spell]})
    arguments = {
        "callback": given.Entity((timer,)),
        "executor": given.Executor(use),
        "count": given.OneOf((given.Constant(2**900), given.Constant(True), given.Constant(1))),
        "data": given.Constant(b"\xff", frozenset({"b", "a"}), PLACE),
        "other": given.UNKNOWN,
    }
    call = ApiCall("an.api", PLACE, callback, (), arguments, {"callback": PLACE}, node=node, limits=(None, 1.5))
    return Program("robot", "robot", PLACE.file, [node], [call], [callback], [use], refused={PLACE})


def test_what_is_one_object_stays_one_and_circles_are_closed():
    [again] = decode(encode([program()]))
    [node], [call], [use] = again.nodes, again.calls, again.executors
    [timer] = node.creations
    assert timer.node is node is call.node is call.context.node is use.nodes[0]
    assert timer.callbacks["timer"] is call.context is again.callbacks[0]
    assert call.context.creation is timer and call.arguments["callback"].creations == (timer,)
    assert call.arguments["executor"].executor is use
    assert use.lasts_for(node) is SpinDuration.A_WHILE


def test_values_keep_their_types():
    before, [after] = program(), decode(encode([program()]))
    assert after.refused == {PLACE} and after.nodes[0].executables == ("robot",)
    assert after.calls[0].limits == (None, 1.5)
    assert after.calls[0].context.role is Role.TIMER
    counted, said = (one.calls[0].arguments for one in (before, after))
    for name in ("count", "data", "other"):
        assert said[name] == counted[name]
        assert repr(getattr(said[name], "value", None)) == repr(getattr(counted[name], "value", None))
    [(branch, _)] = after.nodes[0].creations[0].branch_arms
    assert type(branch) is ChoiceOfCallee and branch == ChoiceOfCallee(PLACE.file, 3, 5)
    assert type(after.nodes[0].namespace.reason) is NotPassed


def test_what_is_empty_is_of_its_kind():
    before = program()
    before.calls[0].arguments["callback"] = given.Constant([(), frozenset(), [], {}, set(), ((),), ""])
    [after] = decode(encode([before]))
    value = after.calls[0].arguments["callback"].value
    assert repr(value) == repr([(), frozenset(), [], {}, set(), ((),), ""])


def test_what_can_be_added_to_is_nobody_elses():
    first, second = program(), program()
    one, other = decode(encode([first, second]))
    one.calls[0].arguments["new"] = given.UNKNOWN
    one.refused.add(Place("other.py", 1, 1, 1, 1))
    assert "new" not in other.calls[0].arguments and len(other.refused) == 1


def test_programs_may_share_what_they_refer_to():
    first, second = program(), program()
    second.nodes.append(first.nodes[0])
    one, other = decode(encode([first, second]))
    assert other.nodes[1] is one.nodes[0] is not other.nodes[0]


def test_objects_of_programs_that_are_read_one_by_one_stay_apart():
    programs = [program(), program()]
    for made in programs:
        made.calls[0].receiver = given.Object(7, "threading.Event", PLACE, made.process)
    first, second = (decode(encode([made]))[0] for made in programs)
    here, there = first.calls[0].receiver, second.calls[0].receiver
    assert isinstance(here, given.Object) and isinstance(there, given.Object)
    assert here.identity == (first.process, 7) != there.identity == (second.process, 7)


def test_what_is_no_plain_data_is_refused():
    @dataclass
    class Tree:
        branches: tuple[int, ...] = ()

    made = program()
    made.calls[0].arguments["callback"] = Tree()
    with pytest.raises(NotEncodable, match="Tree"):
        encode([made])


@pytest.mark.parametrize(
    "payload",
    [
        b"",
        b"\xc1",
        msgspec.msgpack.encode([{}, [], [], []]),
        encode([program()])[:-1],
        msgspec.msgpack.encode([encoding.PROGRAMS.layout, [[len(encoding.PROGRAMS.records), "no kind"]], [], []]),
        msgspec.msgpack.encode([encoding.PROGRAMS.layout, [[1000, "no class"]], [], []]),
        msgspec.msgpack.encode([encoding.PROGRAMS.layout, [[0]], [], []]),
        msgspec.msgpack.encode([encoding.PROGRAMS.layout, [], [], [[5]]]),
        msgspec.msgpack.encode([encoding.PROGRAMS.layout, [], [[1000]], []]),
    ],
)
def test_a_damaged_payload_is_refused(payload: bytes):
    with pytest.raises(NotPrograms):
        decode(payload)


def test_a_payload_of_other_fields_is_refused(monkeypatch: pytest.MonkeyPatch):
    written = encode([program()])
    monkeypatch.setitem(vars(encoding.PROGRAMS), "layout", encoding.PROGRAMS.layout + 1)
    with pytest.raises(NotPrograms, match="version"):
        decode(written)


MODULES = (
    *(absent_reads, calls, executors, futures, given, kinds, messages, nodes, programs, refused, texts, transforms),
    *(branches, finding, interfaces, origins, parameter_types, place, qos, reasons),
)
"""Where the classes of programs and what their fields are annotated with are defined."""
NAMES = {name: item for module in MODULES for name, item in vars(module).items()}
PLAIN = {bool, int, float, str, bytes, object, type(None), Any, Ellipsis}


def parts_of(annotation: object) -> Iterator[object]:
    """The classes and Literals that an annotation is made of; an alias counts as what it stands for."""
    if isinstance(annotation, str):
        annotation = ForwardRef(annotation)
    if isinstance(annotation, ForwardRef):
        annotation = eval(annotation.__forward_arg__, NAMES)
    if get_origin(annotation) in (None, Literal):
        yield annotation
    else:
        yield get_origin(annotation)
        for argument in get_args(annotation):
            yield from parts_of(argument)


def words_of(annotation: object) -> set[object] | None:
    """The texts that a field may have; None where its annotation does not name them all."""
    parts = [part for part in parts_of(annotation) if part not in (Union, UnionType, None, type(None))]
    literal = bool(parts) and all(get_origin(part) is Literal for part in parts)
    return {word for part in parts for word in get_args(part)} if literal else None


WORDS = {
    (number, name): words
    for number, kind in enumerate(encoding.PROGRAMS.records)
    for name, words in ((row.name, words_of(row.type)) for row in fields(kind))
    if words is not None
}
"""What the fields may have that are Literals, by the number of the record and the name of the field."""


def odd_words(payload: bytes) -> list[tuple[str, str, object]]:
    """What stands in a field that is a Literal, and is none of its words."""
    written = msgspec.msgpack.decode(payload, type=encoding.Payload)
    return [
        (kind.__name__, name, word)
        for number, *row in (*written.values, *written.objects)
        for kind in encoding.PROGRAMS.records[number : number + 1]  # none for a word of an enumeration
        for name, word in zip(encoding.PROGRAMS.fields[kind], row, strict=True)
        if (number, name) in WORDS and word is not None and word not in WORDS[number, name]
    ]


def test_a_field_that_is_a_literal_has_one_of_its_words():
    profile = qos.Qos(history="keep_all", liveliness=None)
    [again] = decode(encode([profile]))
    assert again == profile and type(again.history) is str
    assert odd_words(encode([profile])) == []
    assert odd_words(encode([qos.Qos(history="keep_some")])) == [("Qos", "history", "keep_some")]


def test_every_class_of_the_model_is_known():
    """Each class that a field of a program names, and each kind of what a call is given."""
    records = set(encoding.PROGRAMS.records)
    known = {*records, *encoding.PROGRAMS.words, *PLAIN, list, tuple, set, frozenset, dict, Union, UnionType}
    known |= {collections.abc.Sequence, collections.abc.Mapping}
    for kind in encoding.PROGRAMS.records:
        for row in fields(kind):
            for part in parts_of(row.type):
                if get_origin(part) is Literal:
                    assert all(type(word) in (str, int, bool) for word in get_args(part)), row
                else:
                    bases = isinstance(part, type) and part is not object and any(issubclass(r, part) for r in records)
                    assert part in known or bases, f"{kind.__name__}.{row.name}: {part}"
    for base in (given.Given, CodeBranch):  # by name: a class with slots is made twice
        assert {kind.__name__ for kind in base.__subclasses__()} <= {kind.__name__ for kind in records}


# ------------------------------------------------------------------------------------------------ fixtures


@pytest.fixture
def through_bytes(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Every program of a run is written and read before anything else looks at it; how many there were."""
    run_all, run_entry, counted = Linker.run_all, Linker.run_entry, [0]

    def all_again(linker: Linker, entries: list[EntryPoint]) -> list[Program]:
        programs = run_all(linker, entries)
        every = list({id(one): one for one in (*programs, *linker.started.values())}.values())
        payload = encode(every)
        assert odd_words(payload) == []
        again = dict(zip(map(id, every), decode(payload), strict=True))
        linker.started = {key: again[id(one)] for key, one in linker.started.items()}
        counted[0] += len(programs)
        return [again[id(one)] for one in programs]

    def entry_again(linker: Linker, *arguments: object) -> Program:
        made = run_entry(linker, *arguments)
        return decode(encode([made]))[0] if linker._settled else made

    monkeypatch.setattr(Linker, "run_all", all_again)
    monkeypatch.setattr(Linker, "run_entry", entry_again)
    return counted


def output(command: str, capsys: pytest.CaptureFixture[str]) -> str:
    arguments = [command, ".", "--format", "json", "--no-cache", "--jobs", "1", "--isolated"]
    main(arguments)
    return re.sub(r'"elapsed_s": [\d.]+', "", capsys.readouterr().out)


@pytest.mark.parametrize("fixture", sorted(path.name for path in FIXTURES.iterdir() if any(path.rglob("*.py"))))
def test_programs_that_were_read_again_are_judged_as_before(
    fixture: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    request: pytest.FixtureRequest,
):
    monkeypatch.chdir(FIXTURES / fixture)
    before = [output(command, capsys) for command in ("check", "graph")]
    counted = request.getfixturevalue("through_bytes")
    assert [output(command, capsys) for command in ("check", "graph")] == before
    assert counted[0] > 0 or fixture == "bad_input"
