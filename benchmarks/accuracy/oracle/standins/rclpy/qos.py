"""Stand-in for rclpy.qos: profiles with the values of rmw's presets."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import Any

from benchmarks.accuracy.oracle.unknown import Unknown

from .duration import Duration
from .exceptions import RCLError


class InvalidQoSProfileException(Exception):
    """A profile that lacks history or depth."""

    def __init__(self, *arguments: object) -> None:
        super().__init__(f"Invalid QoSProfile: {arguments}")


class QoSPolicyEnum(IntEnum):
    """Base of the policies."""

    @classmethod
    def short_keys(cls) -> list[str]:
        """The names without a prefix."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> Any:
        """A policy by its lower-case name."""
        return cls[name.upper()]

    @property
    def short_key(self) -> str:
        """The lower-case name."""
        return self.name.lower()


class HistoryPolicy(QoSPolicyEnum):
    """How much is kept."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3
    RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_HISTORY_KEEP_LAST = 1
    RMW_QOS_POLICY_HISTORY_KEEP_ALL = 2
    RMW_QOS_POLICY_HISTORY_UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether delivery is guaranteed."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_RELIABILITY_RELIABLE = 1
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT = 2
    RMW_QOS_POLICY_RELIABILITY_UNKNOWN = 3


class DurabilityPolicy(QoSPolicyEnum):
    """Whether late joiners get what was sent before."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4
    RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL = 1
    RMW_QOS_POLICY_DURABILITY_VOLATILE = 2
    RMW_QOS_POLICY_DURABILITY_UNKNOWN = 3


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher shows that it lives."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5
    RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0
    RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1
    RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3
    RMW_QOS_POLICY_LIVELINESS_UNKNOWN = 4


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

_ORDER = (
    "history", "depth", "reliability", "durability", "lifespan", "deadline",
    "liveliness", "liveliness_lease_duration", "avoid_ros_namespace_conventions",
)  # fmt: skip
_POLICIES: dict[str, type[QoSPolicyEnum]] = {
    "history": HistoryPolicy,
    "reliability": ReliabilityPolicy,
    "durability": DurabilityPolicy,
    "liveliness": LivelinessPolicy,
}
_DEFAULTS: dict[str, Any] = {
    "depth": 10,
    "reliability": ReliabilityPolicy.RELIABLE,
    "durability": DurabilityPolicy.VOLATILE,
    "lifespan": None,
    "deadline": None,
    "liveliness": LivelinessPolicy.SYSTEM_DEFAULT,
    "liveliness_lease_duration": None,
    "avoid_ros_namespace_conventions": False,
}


class QoSProfile:
    """A profile; its policies may be assigned after construction."""

    def __init__(self, **policies: Any) -> None:
        unexpected = set(policies) - set(_ORDER)
        if unexpected:
            raise AssertionError(f"Invalid arguments passed to constructor: {sorted(unexpected)}")
        if "history" not in policies and "depth" not in policies:
            raise InvalidQoSProfileException("History and/or depth settings are required.")
        self.history = policies.get("history", HistoryPolicy.KEEP_LAST)
        if "depth" not in policies and self.history == HistoryPolicy.KEEP_LAST:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        for name, default in _DEFAULTS.items():
            setattr(self, name, policies.get(name, default))

    def __setattr__(self, name: str, value: Any) -> None:
        if isinstance(value, Unknown) or name not in _ORDER:
            object.__setattr__(self, name, value)
            return
        policy = _POLICIES.get(name)
        expected: Any = int if policy or name == "depth" else bool if name == _ORDER[-1] else Duration
        assert isinstance(value, expected) or (expected is Duration and value is None), f"{name} is {value!r}"
        object.__setattr__(self, name, policy(value) if policy else value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, QoSProfile) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def get_c_qos_profile(self) -> QoSProfile:
        """The profile itself."""
        return self


def normal_form(value: object, *, of_service: bool = False) -> dict[str, object]:
    """What rclpy makes of a `qos_profile` argument: an int is a depth, but not for services; any other is refused."""
    if isinstance(value, Unknown):
        return {"history": None, "depth": None, "reliability": None, "durability": None}
    if of_service and not isinstance(value, QoSProfile):
        raise AttributeError(f"{type(value).__name__!r} object has no attribute 'get_c_qos_profile'")
    if isinstance(value, int):
        if value < 0:
            raise ValueError("history depth must be greater than or equal to zero")
        value = QoSProfile(depth=value)
    if not isinstance(value, QoSProfile):
        raise TypeError(f"Expected QoSProfile or int, but received {type(value)!r}")
    words = {name: _word(_POLICIES[name], getattr(value, name)) for name in ("history", "reliability", "durability")}
    if "unknown" in words.values() or (isinstance(value.depth, int) and value.depth < 0):
        raise RCLError("the middleware has no such QoS")
    return {
        "history": words["history"],
        "depth": None if isinstance(value.depth, Unknown) else int(value.depth),
        "reliability": words["reliability"],
        "durability": words["durability"],
    }


def _word(kind: type[QoSPolicyEnum], value: Any) -> str | None:
    return None if isinstance(value, Unknown) else kind(value).name.lower()


def _sensor_data() -> QoSProfile:
    return QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)


def _system_default() -> QoSProfile:
    return QoSProfile(
        history=HistoryPolicy.SYSTEM_DEFAULT,
        depth=0,
        reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
        durability=DurabilityPolicy.SYSTEM_DEFAULT,
    )


def _transient(depth: int) -> QoSProfile:
    return QoSProfile(depth=depth, durability=DurabilityPolicy.TRANSIENT_LOCAL)


qos_profile_default = QoSProfile(depth=10)
qos_profile_unknown = QoSProfile(history=3, depth=0, reliability=3, durability=3, liveliness=4)
qos_profile_system_default = _system_default()
qos_profile_sensor_data = _sensor_data()
qos_profile_services_default = QoSProfile(depth=10)
qos_profile_parameters = QoSProfile(depth=1000)
qos_profile_parameter_events = QoSProfile(depth=1000)
qos_profile_action_status_default = _transient(1)
qos_profile_rosout_default = _transient(1000)
qos_profile_best_available = QoSProfile(
    depth=10, reliability=ReliabilityPolicy.BEST_AVAILABLE, durability=DurabilityPolicy.BEST_AVAILABLE
)


class QoSPresetProfiles(Enum):
    """The presets by name."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available

    @classmethod
    def short_keys(cls) -> list[str]:
        """The names in lower case."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """A preset by its lower-case name."""
        profile: QoSProfile = cls[name.upper()].value
        return profile


class QoSCompatibility(QoSPolicyEnum):
    """The verdict of `qos_check_compatible`."""

    OK = 0
    WARNING = 1
    ERROR = 2


class QoSPolicyKind(QoSPolicyEnum):
    """The policies."""

    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE_DURATION = 256
    AVOID_ROS_NAMESPACE_CONVENTIONS = 512


def qos_check_compatible(publisher: QoSProfile, subscription: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Always compatible here."""
    return QoSCompatibility.OK, ""
