"""Expected verdicts are those of ``qos_check_compatible`` in rmw_dds_common."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.ros import qos
from archlint.ros.qos import Qos, Verdict, compatible


def levels(offered: Qos, requested: Qos) -> dict[str, str]:
    return {verdict.policy: verdict.level for verdict in compatible(offered, requested)}


@pytest.mark.parametrize(
    ("policy", "weak", "strong"),
    [
        ("reliability", "best_effort", "reliable"),
        ("durability", "volatile", "transient_local"),
        ("liveliness", "automatic", "manual_by_topic"),
    ],
)
class TestPoliciesOfTwoStrengths:
    @pytest.fixture
    def verdict(self, policy: str):
        def of(offered: str | None, requested: str | None) -> str | None:
            one, other = (replace(qos.DEFAULT, **{policy: value}) for value in (offered, requested))
            return levels(one, other).get(policy)

        return of

    def test_a_weak_offer_does_not_serve_a_strong_request(self, verdict, weak: str, strong: str) -> None:
        assert verdict(weak, strong) == "error"
        assert verdict(strong, weak) is None
        assert verdict(weak, weak) is None
        assert verdict(strong, strong) is None

    def test_the_middleware_decides_what_the_system_default_is(self, verdict, weak: str, strong: str) -> None:
        assert verdict("system_default", strong) == "warning"
        assert verdict(weak, "system_default") == "warning"
        assert verdict(strong, "system_default") is None
        assert verdict("system_default", weak) is None

    def test_best_available_takes_what_there_is(self, verdict, weak: str, strong: str) -> None:
        assert verdict(weak, "best_available") is None
        assert verdict("best_available", strong) is None

    def test_what_the_code_does_not_tell_is_not_judged(self, verdict, weak: str, strong: str) -> None:
        assert verdict(None, strong) is None
        assert verdict(weak, None) is None


def test_two_system_defaults_depend_on_the_middleware() -> None:
    default = qos.PRESETS["qos_profile_system_default"]
    assert levels(default, default) == {"reliability": "warning", "durability": "warning"}


def test_warnings_are_left_out_beside_an_error() -> None:
    offered = Qos(reliability="best_effort", durability="system_default")
    requested = Qos(reliability="reliable", durability="transient_local")
    assert levels(offered, requested) == {"reliability": "error"}


@pytest.mark.parametrize("policy", ["deadline", "liveliness_lease"])
@pytest.mark.parametrize(
    ("offered", "requested", "level"),
    [
        (None, None, None),
        (1.0, None, None),
        (None, 1.0, "error"),
        (1.0, 0.5, "error"),
        (1.0, 1.0, None),
        (1.0, 2.0, None),
        (0.0, 1.0, "error"),
        (1.0, 0.0, None),
    ],
)
def test_durations(policy: str, offered: float | None, requested: float | None, level: str | None) -> None:
    one, other = (replace(qos.DEFAULT, **{policy: value}) for value in (offered, requested))
    assert levels(one, other).get(policy) == level


def test_a_duration_that_is_not_known_is_not_judged() -> None:
    unknown = Qos(unknown_durations=frozenset({"deadline"}))
    assert compatible(unknown, Qos(deadline=1.0)) == []
    assert compatible(Qos(), replace(unknown, deadline=1.0)) == []


def test_history_depth_and_lifespan_never_matter() -> None:
    assert compatible(Qos(history="keep_all", depth=0, lifespan=1.0), Qos(depth=1)) == []


def test_a_verdict_shows_both_sides() -> None:
    assert compatible(qos.SENSOR_DATA, qos.DEFAULT) == [Verdict("reliability", "error", "best_effort", "reliable")]


@pytest.mark.parametrize(
    ("member", "history", "depth", "reliability", "durability"),
    [
        ("DEFAULT", "keep_last", 10, "reliable", "volatile"),
        ("SENSOR_DATA", "keep_last", 5, "best_effort", "volatile"),
        ("SERVICES_DEFAULT", "keep_last", 10, "reliable", "volatile"),
        ("PARAMETERS", "keep_last", 1000, "reliable", "volatile"),
        ("PARAMETER_EVENTS", "keep_last", 1000, "reliable", "volatile"),
        ("ACTION_STATUS_DEFAULT", "keep_last", 1, "reliable", "transient_local"),
        ("ROSOUT_DEFAULT", "keep_last", 1000, "reliable", "transient_local"),
        ("SYSTEM_DEFAULT", "system_default", 0, "system_default", "system_default"),
        ("BEST_AVAILABLE", "keep_last", 10, "best_available", "best_available"),
    ],
)
def test_presets(member: str, history: str, depth: int, reliability: str, durability: str) -> None:
    preset = qos.PRESETS[qos.PRESET_MEMBERS[member] or ""]
    assert (preset.history, preset.depth) == (history, depth)
    assert (preset.reliability, preset.durability) == (reliability, durability)


def profiles(*extra: str | None) -> st.SearchStrategy[Qos]:
    durations = st.none() | st.floats(0.0, 10.0)
    return st.builds(
        Qos,
        history=st.sampled_from(["keep_last", "keep_all"]),
        depth=st.integers(0, 5),
        reliability=st.sampled_from(["reliable", "best_effort", *extra]),
        durability=st.sampled_from(["volatile", "transient_local", *extra]),
        deadline=durations,
        lifespan=durations,
        liveliness=st.sampled_from(["automatic", "manual_by_topic", "system_default", *extra]),
        liveliness_lease=durations,
    )


known = profiles()
any_profile = profiles("system_default", "best_available", "unknown", None)


@given(known)
def test_a_known_profile_talks_to_itself(profile: Qos) -> None:
    assert compatible(profile, profile) == []


@given(
    any_profile,
    any_profile,
    st.sampled_from(
        [
            {"reliability": "best_effort"},
            {"durability": "volatile"},
            {"liveliness": "automatic"},
            {"deadline": None},
            {"liveliness_lease": None},
        ]
    ),
)
def test_asking_for_less_never_makes_an_error(offered: Qos, requested: Qos, relaxed: dict[str, str | None]) -> None:
    def errors(request: Qos) -> set[str]:
        return {policy for policy, level in levels(offered, request).items() if level == "error"}

    assert errors(replace(requested, **relaxed)) <= errors(requested)


@given(any_profile, any_profile)
def test_errors_and_warnings_never_mix(offered: Qos, requested: Qos) -> None:
    assert len(set(levels(offered, requested).values())) <= 1


@pytest.mark.parametrize(
    ("profile", "policy", "values", "verdict"),
    [
        (qos.DEFAULT, "reliability", ("reliable",), True),
        (qos.DEFAULT, "reliability", ("best_effort",), False),
        (replace(qos.DEFAULT, reliability="system_default"), "reliability", ("reliable",), None),
        (replace(qos.DEFAULT, reliability="best_available"), "reliability", ("reliable",), None),
        (replace(qos.DEFAULT, reliability=None), "reliability", ("reliable",), None),
        (qos.DEFAULT, "depth", (10,), True),
        (qos.DEFAULT, "depth", (1, 5), False),
        (replace(qos.DEFAULT, history="keep_all"), "depth", (10,), None),
        (replace(qos.DEFAULT, deadline=0.5), "deadline", (0.5,), True),
        (replace(qos.DEFAULT, deadline=0.5), "deadline", (0,), False),
        (replace(qos.DEFAULT, deadline=None), "deadline", (0,), True),
        (replace(qos.DEFAULT, deadline=None), "deadline", (1,), False),
        (replace(qos.DEFAULT, deadline=0.5, unknown_durations=frozenset({"deadline"})), "deadline", (0.5,), None),
    ],
)
def test_whether_a_policy_has_one_of_some_values(
    profile: Qos, policy: qos.FieldName, values: tuple[str | float, ...], verdict: bool | None
) -> None:
    assert qos.allowed(profile, policy, values) is verdict


def test_a_verdict_says_what_both_sides_have() -> None:
    late = replace(qos.DEFAULT, deadline=2.0)
    assert compatible(late, replace(qos.DEFAULT, deadline=1.0)) == [Verdict("deadline", "error", 2.0, 1.0)]
    undecided = replace(qos.DEFAULT, reliability="system_default")
    wants = replace(qos.DEFAULT, reliability="reliable")
    assert compatible(undecided, wants) == [Verdict("reliability", "warning", "system_default", "reliable")]


def test_one_side_that_is_not_known_is_not_judged() -> None:
    known, unknown = (replace(qos.DEFAULT, reliability=value) for value in ("system_default", None))
    assert levels(unknown, known) == levels(known, unknown) == {}
