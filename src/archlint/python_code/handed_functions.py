"""Functions that are handed to what is not followed here, such as ``connect()`` of a signal of Qt: whoever has them may
call them with something else than the message of a subscription.
"""

from __future__ import annotations

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

_OF_ROS = ("create_", "add_", "register", "send_goal", "Action", "MessageFilter", "SimpleAction", "Subscri", "partial")
"""How the calls begin that hand a callback to ROS, or with more arguments to another call: what ROS calls it with is
known."""


@kept_for_each_file
def handed_elsewhere(file_facts: facts.Facts) -> frozenset[str]:
    """The names of the functions of a file that it gives as arguments to calls which are neither of its own functions
    nor of ROS."""
    defined = {function.name for function in everything_in(file_facts.body, facts.Function)}
    return frozenset(
        argument.value.last_name
        for call in everything_in(file_facts.body, facts.Call)
        if not called_name(call).startswith(_OF_ROS) and called_name(call) not in defined
        for argument in call.args
        if argument.value.last_name in defined and _may_be_function(call, argument.value)
    )


def _may_be_function(call: facts.Call, value: facts.Expr) -> bool:
    """Whether an argument may be a function of the file: ``message.state`` is a field mostly, whatever is defined."""
    match value:
        case facts.Name():
            return True
        case facts.Attribute(value=facts.Name(id=owner)):
            return owner == "self" or called_name(call) == "connect"
    return False


__all__ = ["handed_elsewhere"]
