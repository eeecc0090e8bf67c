"""What the code that ``generate_parameter_library`` makes does with the node that its listener is given.

Source: the templates ``declare_parameter`` and ``parameter_library_header`` of generate_parameter_library_py, 1f74d68:
a parameter that the node has already is not declared again, and in C++ the prefix gets the dot that it lacks.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.values import NONE, TRUE, External, Known, Unknown, Value, join_texts
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import declarations, nodes
from archlint.libraries.rclpy.fields import PARAMETERS
from archlint.libraries.tables import TABLE
from archlint.ros.parameter_types import OF_PARAMETER_LIBRARY, ParameterType
from archlint.syntax.parameter_library import LIBRARY

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method, Plain
    from archlint.libraries.run import Run

_TYPES: dict[str, ParameterType] = {kind: kind for kind in OF_PARAMETER_LIBRARY}
_LOGGER = External("rclcpp.Logger")
_DECLARE = TABLE["rclpy.node.Node.declare_parameter"]


def _prefix(run: Run, site: CallSite) -> Value:
    """What stands before each name: the last argument of ``ParamListener(node, prefix)``,
    ``ParamListener(interface, logger)`` and ``ParamListener(interface, logger, prefix)``, which may be none."""
    first, last = site.args
    prefix = first if last == NONE else last
    if prefix.text is None:
        return (
            Known("") if prefix == _LOGGER else Unknown("what stands before the names of the parameters is not known")
        )
    return prefix if not prefix.text or prefix.text.endswith(".") else join_texts((prefix, Known(".")))


def _declare(run: Run, site: CallSite) -> Value:
    """Declare a parameter of a library on a node that has none of this name; returns its value."""
    node, name, default, kind, read_only, about = site.args
    text = name.text
    if text is not None:
        known = run.store.get(nodes.node_key(run, node), PARAMETERS[text])
        if known is not None:
            return known
    call = ApiUse(_DECLARE, node, {}, site.expression, False, [], {})
    description = model.ParameterDescription(about.text or "", "", read_only == TRUE)
    of_type = _TYPES.get(kind.text or "")
    parameter = declarations.declare_one(run, call, name, default, description=description, of_type=of_type)
    return get_attribute(run, parameter, "value")


def _logger(run: Run, site: CallSite) -> Value:
    return _LOGGER


def _logger_of_node(run: Run, node: Value, site: CallSite) -> Value:
    is_cpp = run.activation.module.file.kind == "cpp"
    return _LOGGER if is_cpp else Unknown("a logger is outside of this workspace")


PLAIN: dict[str, Plain] = {
    f"{LIBRARY}.prefix": _prefix,
    f"{LIBRARY}.declare": _declare,
    "rclcpp.get_logger": _logger,
}
METHODS: dict[str, Method] = {"rclpy.node.Node.get_logger": _logger_of_node}

__all__ = ["METHODS", "PLAIN"]
