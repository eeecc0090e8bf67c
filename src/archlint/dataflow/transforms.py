"""Which look-ups of transforms depend on which callbacks that send some: by the tree of coordinate frames.

tf2 puts a transform together from those on the way between two frames, through the nearest that both hang from.  So a
look-up depends on the frames of that way, and on nothing else; where the way is not known in full, it may depend on all
that the two frames hang from, and on what sends transforms whose frames are not known.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.transforms import LOOK_UP, TRANSFORMS, Transform, static_transform, transforms_of
from archlint.dataflow.model import NOT_KNOWN, How, Step, StepKind
from archlint.dataflow.runs import SEND_TRANSFORMS
from archlint.execution.loop_paces import is_decided
from archlint.model import EntityKind
from archlint.records import dataclass
from archlint.ros.well_known import OF_TRANSFORMS

if TYPE_CHECKING:
    from archlint.dataflow.builder import Builder
    from archlint.dataflow.runs import Run
    from archlint.model import ApiCall
    from archlint.systems.nodes import Endpoint, Node

_ONE_OF_SEVERAL = "which of several frames it is, is not known"
_LISTENER = "tf2_ros.transform_listener.TransformListener"
_NO_LISTENER = "the listener that brings it is not known"


@dataclass(frozen=True)
class _Sent:
    """A transform that a step sends on a topic."""

    topic: str
    transform: Transform
    step: Step
    conditional: bool


@dataclass(frozen=True)
class _LookUp:
    """A transform that a step looks up among those of some topics."""

    topics: Sequence[str]
    transform: Transform
    step: Step
    conditional: bool
    doubt: str


def is_taken_by(run: Run) -> bool:
    """Whether something that runs looks up a transform of which not both frames are known."""
    return any(
        row.known is None for call in run.calls if call.api.startswith(LOOK_UP) for row in transforms_of(run.node, call)
    )


def link_transforms(builder: Builder) -> None:
    """Link what sends transforms with the frames, and the frames with what looks them up."""
    sent = [row for run in builder.runs for row in _sent_by(builder, run)]
    sent += [row for node in builder.system.nodes for row in _static(builder, node)]
    trees: dict[str, _Tree] = {}
    for row in sent:
        trees.setdefault(row.topic, _Tree()).add(row.transform)
        if row.transform.child is not None:
            doubt = "" if row.transform.certain else _ONE_OF_SEVERAL
            head = builder.frame(row.topic, row.transform.child)
            builder.link(row.step, head, How.SEND, row.transform.place, doubt, row.conditional)
    for row in sent:
        root = row.transform.parent
        if root is not None and not any(root in tree for tree in trees.values()):
            builder.frame(row.topic, root)
    look_ups = [row for run in builder.runs for row in _look_ups_of(builder, run, trees)]
    are_open = [_link_look_up(builder, row, trees) for row in look_ups]
    if any(are_open):
        _link_senders_not_known(builder, sent)


# ------------------------------------------------------------------------------------------------ what is sent


def _sent_by(builder: Builder, run: Run) -> Iterator[_Sent]:
    for call in run.calls:
        if call.api not in SEND_TRANSFORMS:
            continue
        creations = () if call.receiver is None else call.receiver.creations
        topics = {end.name: None for creation in creations for end in builder.ends(creation, run.node)}
        for topic in filter(None, topics):
            for transform in transforms_of(run.node, call):
                yield _Sent(topic, transform, builder.step_of(run), is_decided(call))


def _static(builder: Builder, node: Node) -> Iterator[_Sent]:
    transform = static_transform(node)
    if transform is not None:
        topics = [end.name for end in node.of_kind(EntityKind.PUBLISHER) if _is_of_transforms(end)]
        topic = topics[0] if topics and topics[0] else "/tf_static"
        yield _Sent(topic, transform, builder.stranger(node), node.condition is not None)


def _is_of_transforms(end: Endpoint) -> bool:
    return end.type == "tf2_msgs/msg/TFMessage"


# --------------------------------------------------------------------------------------------- what is looked up


def _look_ups_of(builder: Builder, run: Run, sent_on: Collection[str]) -> Iterator[_LookUp]:
    calls = [call for call in run.calls if call.api.startswith(LOOK_UP)]
    if not calls:
        return
    own = [end for end in run.node.of_kind(EntityKind.SUBSCRIBER) if end.creation.api.startswith(TRANSFORMS)]
    topics = [end.name for end in own if end.name] or sorted(OF_TRANSFORMS)
    is_known = bool(own) or (_has_listener(run) and OF_TRANSFORMS.issuperset(sent_on))
    for call in calls:
        yield from _look_ups(builder, run, call, topics, "" if is_known else _NO_LISTENER)


def _has_listener(run: Run) -> bool:
    """Whether its program makes a listener: one that gets no node makes a node for itself, as those of C++ often do."""
    return any(call.api == _LISTENER for call in run.program.calls)


def _look_ups(builder: Builder, run: Run, call: ApiCall, topics: Sequence[str], doubt: str) -> Iterator[_LookUp]:
    for transform in transforms_of(run.node, call):
        unsure = doubt or ("" if transform.certain else _ONE_OF_SEVERAL)
        yield _LookUp(topics, transform, builder.step_of(run), is_decided(call), unsure)


def _link_look_up(builder: Builder, row: _LookUp, trees: dict[str, _Tree]) -> bool:
    """Link the frames that a look-up depends on; True where these are not all known."""
    if row.transform.known is None:
        return False
    target, source = row.transform.known
    tree = _Tree.of([trees[topic] for topic in row.topics if topic in trees])
    between = tree.between(target, source)
    doubt = row.doubt if between is not None else f"not every transform between '{target}' and '{source}' is known"
    for frame in (*tree.above(target), *tree.above(source)) if between is None else between:
        for topic in row.topics:
            if topic in trees and frame in trees[topic]:
                step = builder.frame(topic, frame)
                builder.link(step, row.step, How.READ, row.transform.place, doubt, row.conditional)
    if between is not None:
        return False
    for frame in (target, source):
        if not any(topic in trees and frame in trees[topic] for topic in row.topics):
            step = builder.frame(row.topics[0], frame)
            builder.link(step, row.step, How.READ, row.transform.place, doubt, row.conditional)
    for topic in row.topics:
        step = builder.frame(topic, NOT_KNOWN)
        builder.link(step, row.step, How.READ, row.transform.place, doubt, row.conditional)
    return True


def _link_senders_not_known(builder: Builder, sent: Sequence[_Sent]) -> None:
    """Lead what may send any frame to those that are not known."""
    whole: dict[tuple[str, int], bool] = {}
    for row in sent:
        key = row.topic, id(row.step)
        whole[key] = whole.get(key, True) and row.transform.child is not None
    static = {id(row.step.node) for row in sent if row.step.kind == StepKind.STRANGER}
    for link in builder.links:
        topic = link.head
        if topic.kind != StepKind.TOPIC or not builder.has_frame(topic.name, NOT_KNOWN) or link.broken:
            continue
        if not whole.get((topic.name, id(link.tail))) and id(link.tail.node) not in static:
            head = builder.frame(topic.name, NOT_KNOWN)
            builder.link(link.tail, head, link.how, link.place, link.doubt, link.conditional)


# ------------------------------------------------------------------------------------------------ the tree


class _Tree:
    """The frames of some topics, each with those that it is seen to hang from."""

    def __init__(self) -> None:
        self._parents: dict[str, dict[str | None, None]] = {}

    @classmethod
    def of(cls, trees: Sequence[_Tree]) -> _Tree:
        """The tree that a listener puts together from several topics."""
        if len(trees) == 1:
            return trees[0]
        joined = cls()
        for tree in trees:
            for child, parents in tree._parents.items():
                joined._parents.setdefault(child, {}).update(parents)
        return joined

    def __contains__(self, frame: str) -> bool:
        return frame in self._parents

    def add(self, transform: Transform) -> None:
        """Note what a transform that is sent says of its child; one of several says nothing for certain."""
        if transform.child is not None:
            parents = self._parents.setdefault(transform.child, {})
            parents[transform.parent] = None
            if not transform.certain:
                parents[None] = None

    def between(self, target: str, source: str) -> Sequence[str] | None:
        """The frames whose transforms lead from one to the other; None where these are not known for certain."""
        up, down = self._chain(target), self._chain(source)
        common = next((frame for frame in down if frame in up), None)
        if common is None:
            return None
        ways = (chain[: chain.index(common)] for chain in (list(up), list(down)))
        return [frame for way in ways for frame in way]

    def _chain(self, frame: str) -> dict[str, None]:
        """A frame, and what it hangs from, as far as each hangs from one."""
        chain = {frame: None}
        while True:
            parents = list(self._parents.get(frame, ()))
            if len(parents) != 1 or parents[0] is None or parents[0] in chain:
                return chain
            frame = parents[0]
            chain[frame] = None

    def above(self, frame: str) -> Sequence[str]:
        """A frame, and all that it may hang from."""
        every = {frame: None}
        left = [frame]
        while left:
            for parent in self._parents.get(left.pop(), ()):
                if parent is not None and parent not in every:
                    every[parent] = None
                    left.append(parent)
        return list(every)


__all__ = ["is_taken_by", "link_transforms"]
