"""Parameters: declared, asked for, set and given from outside, as they should be and as they should not."""

from __future__ import annotations

from outcomes import fresh, tell
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.parameter import Parameter

Type = Parameter.Type
DYNAMIC = ParameterDescriptor(dynamic_typing=True)


def declare(*arguments, **options):
    def call(node):
        one = node.declare_parameter(*arguments, **options)
        return one.type_.name, one.value

    return call


def with_parameter(*arguments):
    """A node that has a parameter p, which is declared as these say."""

    def node():
        one = fresh()
        one.declare_parameter("p", *arguments)
        return one

    return node


def overridden(value, *arguments, **options):
    """What p is in a node that is constructed with a value for it."""

    def call(_):
        node = fresh(parameter_overrides=[Parameter("p", value=value)])
        return node.declare_parameter("p", *arguments, **options).value

    return call


def refuse(parameters):
    return SetParametersResult(successful=False, reason="no")


def setting(value, *declared, callback=None):
    def call(_):
        node = with_parameter(*declared)()
        if callback:
            node.add_on_set_parameters_callback(callback)
        (result,) = node.set_parameters([Parameter("p", value=value)])
        return result.successful, node.get_parameter("p").value

    return call


CALLS = [
    # Parameters: declared
    declare("p"),
    declare("p", None),
    declare("p", None, ParameterDescriptor()),
    declare("p", None, DYNAMIC),
    declare("p", True),
    declare("p", 1),
    declare("p", 1.5),
    declare("p", "text"),
    declare("p", [True, False]),
    declare("p", [1, 2]),
    declare("p", [True, 2]),
    declare("p", [1, 2.0]),
    declare("p", [1.5, 2.0]),
    declare("p", ["a", "b"]),
    declare("p", ("a", "b")),
    declare("p", ["a", 1]),
    declare("p", []),
    declare("p", [b"a"]),
    declare("p", {"a": 1}),
    declare("p", {1}),
    declare("p", Type.NOT_SET),
    declare("p", 5, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=3, step=1)])),
    declare("p", 2.0, ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=3.0)])),
    declare("", 1),
    declare(5, 1),
    declare("with space", 1),
    declare("p", 1, "a description"),
    declare("use_sim_time", True),
    lambda node: (node.declare_parameter("p", 1), node.declare_parameter("p", 1)),
    lambda node: [one.name for one in node.declare_parameters("a", [("b", 1), ("c", "d")])],
    lambda node: [one.name for one in node.declare_parameters("", [("b", 1, ParameterDescriptor())])],
    lambda node: node.declare_parameters("", [("b", 1, ParameterDescriptor(), 2)]),
    lambda node: node.declare_parameters("", [()]),
    # Parameters: asked for
    lambda node: node.get_parameter("p"),
    lambda _: fresh(allow_undeclared_parameters=True).get_parameter("p").value,
    lambda node: node.get_parameter_or("p").value,
    lambda node: node.get_parameter_or("p", Parameter("p", value=3)).value,
    lambda node: node.has_parameter("p"),
    lambda node: node.has_parameter("use_sim_time"),
    lambda _: with_parameter(1)().get_parameter("p").get_parameter_value().integer_value,
    lambda _: with_parameter("a")().get_parameter("p").get_parameter_value().string_value,
    lambda _: with_parameter("a")().get_parameter("p").get_parameter_value().integer_value,
    lambda _: with_parameter("a")().get_parameter_type("p").name,
    lambda _: [one.value for one in with_parameter("a")().get_parameters(["p"])],
    lambda _: with_parameter("a")().get_parameters("p")[0].value,
    lambda _: sorted(with_parameter("a")().get_parameters_by_prefix("")),
    lambda _: with_parameter("a")().undeclare_parameter("p"),
    lambda node: node.undeclare_parameter("p"),
    # Parameters: set
    setting(2, 1),
    setting("two", 1),
    setting(2.0, 1),
    setting("two", 1, DYNAMIC),
    setting(2, 1, callback=refuse),
    setting(5, 1, ParameterDescriptor(read_only=True)),
    setting(5, 1, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=3, step=1)])),
    lambda node: node.set_parameters([Parameter("p", value=1)]),
    lambda _: fresh(allow_undeclared_parameters=True).set_parameters([Parameter("p", value=1)])[0].successful,
    lambda _: Parameter("p", Type.INTEGER, "1"),
    lambda _: Parameter("p", Type.DOUBLE, 1),
    lambda _: Parameter("p", Type.DOUBLE, 1.0).value,
    lambda _: Parameter("p", "integer", 1),
    lambda _: Parameter("p").type_.name,
    # Parameters: given from outside
    overridden("given", "default"),
    overridden(5, "default"),
    overridden(5, 1.5),
    overridden("given", Type.STRING),
    overridden("given", Type.INTEGER),
    overridden("given", "default", DYNAMIC),
    overridden("given", "default", ignore_override=True),
    overridden("given"),
    lambda _: fresh(
        parameter_overrides=[Parameter("p", value=4)], automatically_declare_parameters_from_overrides=True
    ).get_parameter("p").value,
    lambda _: fresh(parameter_overrides=[Parameter("p", value=4)]).get_parameter("p"),
    lambda _: fresh(parameter_overrides=[Parameter("p", value=4)], allow_undeclared_parameters=True)
    .get_parameter("p").value,
]  # fmt: skip


if __name__ == "__main__":
    tell("parameters", CALLS, fresh)
