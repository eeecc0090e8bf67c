"""What methods of rclpy's ``Node`` take, as far as all supported distributions agree.

A parameter with ``?`` may be left out; ``*`` starts those that are given by name, of which each distribution has
others.
"""

from __future__ import annotations

from collections.abc import Collection

_PUBLISHER = "msg_type topic qos_profile *"

NODE_METHODS = {
    "get_logger": "",
    "get_clock": "",
    "get_name": "",
    "get_namespace": "",
    "get_fully_qualified_name": "",
    "create_publisher": _PUBLISHER,
    "create_lifecycle_publisher": _PUBLISHER,
    "create_subscription": "msg_type topic callback qos_profile *",
    "create_client": "srv_type srv_name *",
    "create_service": "srv_type srv_name callback *",
    "create_timer": "timer_period_sec callback callback_group? clock? autostart? *",
    "create_rate": "frequency clock?",
    "get_parameter": "name",
    "has_parameter": "name",
    "undeclare_parameter": "name",
}


def refuses(method: str, given: int, keywords: Collection[str]) -> bool:
    """Whether Python refuses a call of a node's method with so many positional arguments and these keywords."""
    signature = NODE_METHODS.get(method)
    if signature is None:
        return False
    names = [name for name in signature.split() if name != "*"]
    taken, left = names[:given], names[given:]
    if given > len(names) or any(name.rstrip("?") in keywords for name in taken):
        return True
    if not names and keywords:
        return True
    return any(not name.endswith("?") and name not in keywords for name in left)
