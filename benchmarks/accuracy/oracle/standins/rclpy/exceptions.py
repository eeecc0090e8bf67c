"""Stand-in for rclpy.exceptions."""

from __future__ import annotations


class RCLError(RuntimeError):
    """What rcl or the middleware refuses."""


class RCLInvalidROSArgsError(RCLError):
    """A command line after --ros-args that rcl does not understand."""


class InvalidHandle(Exception):
    """A destroyed entity was used."""


class NotInitializedException(Exception):
    """rclpy.init was not called."""


class NameValidationException(Exception):
    """A name that rcl refuses."""


class InvalidNamespaceException(NameValidationException):
    """A namespace that rcl refuses."""


class InvalidNodeNameException(NameValidationException):
    """A node name that rcl refuses."""


class InvalidTopicNameException(NameValidationException):
    """A topic name that rcl refuses."""


class InvalidServiceNameException(NameValidationException):
    """A service name that rcl refuses."""


class ROSInterruptException(Exception):
    """ROS was shut down during an operation."""

    def __init__(self, *arguments: object) -> None:
        super().__init__("rclpy.shutdown() has been called" if not arguments else arguments[0])


class NoImplementationAvailableException(Exception):
    """No rmw implementation."""


class NoTypeSupportImportedException(Exception):
    """No type support."""


class ParameterException(Exception):
    """Base of the parameter errors."""

    def __init__(self, message: str = "", parameters: object = ()) -> None:
        super().__init__(f"{message}: {parameters}")


class ParameterNotDeclaredException(ParameterException):
    """The parameter was never declared."""

    def __init__(self, parameters: object = ()) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters)


class ParameterUninitializedException(ParameterException):
    """The parameter has no value."""

    def __init__(self, parameters: object = ()) -> None:
        super().__init__("The parameter is not initialized", parameters)


class ParameterAlreadyDeclaredException(ParameterException):
    """The parameter was declared before."""

    def __init__(self, parameters: object = ()) -> None:
        super().__init__("Parameter(s) already declared", parameters)


class InvalidParameterException(ParameterException):
    """The parameter's name is not valid."""

    def __init__(self, parameters: object = ()) -> None:
        super().__init__("Invalid parameter name", parameters)


class InvalidParameterTypeException(ParameterException):
    """The value does not fit the parameter's type."""


class InvalidParameterValueException(ParameterException):
    """The value was refused."""


class ParameterImmutableException(ParameterException):
    """The parameter is read-only."""


class ROSClockMismatchException(Exception):
    """Times of different clocks."""
