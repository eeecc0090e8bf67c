"""Running callbacks and the methods that nothing calls, each from the state that it would meet."""

from __future__ import annotations

from archlint import model
from archlint.interpreter import definitions, overloads
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.growing import open_up
from archlint.interpreter.limits import EXTRA_STEPS, FEW_STEPS, ROOTS, SELF_STARTS, STEPS
from archlint.interpreter.roots import enter_root, module_of
from archlint.interpreter.values import (
    NONE,
    BoundMethod,
    ClassValue,
    FunctionValue,
    Instance,
    Known,
    OneOf,
    Partial,
    Unknown,
    Value,
)
from archlint.libraries.interest import interesting
from archlint.libraries.rclpy import escapes, executors, mistaken_futures
from archlint.libraries.rclpy.callables import describe
from archlint.libraries.run import Run
from archlint.libraries.state import Pending
from archlint.libraries.uses import bare
from archlint.programs import left_behind
from archlint.programs.any_time import attributes_at_any_time
from archlint.programs.budget import LATE_STEPS
from archlint.reasons import NotPassed
from archlint.syntax import facts
from archlint.syntax.parts import names_in

INSTANCES = 8
"""On how many objects of one class the methods that nothing calls are tried."""
PASSES = 4
"""How often callbacks that register callbacks are followed."""
AGAIN = 2
"""How often callbacks run again on what others left in attributes; the last time what still changes is not known."""

LIFECYCLE = frozenset({"on_configure", "on_activate", "on_deactivate", "on_cleanup", "on_shutdown", "on_error"})


def run_callbacks(run: Run) -> None:
    """Run the registered callbacks, then the methods that nothing calls; again where they register more."""
    run.callbacks.ended = True
    for _ in range(PASSES):
        run_pending(run)
        _run_methods(run)
        if not run.callbacks.pending:
            break
    for number in range(AGAIN):
        if not run.callbacks.news or run.left <= 0:
            break
        _run_again(run, last=number > 0)


def _run_again(run: Run, last: bool) -> None:
    """What one callback leaves in an attribute, another may use: each that reads it sees the joined state."""
    news, run.callbacks.news = run.callbacks.news, {}
    if last:
        left_behind.forget(run, news)
    run.nodes.revisited = set()
    for pending in left_behind.readers(run, [*run.callbacks.started, *run.callbacks.tried], news):
        run_root(run, pending)
    run.nodes.revisited = None
    run_pending(run)


def run_pending(run: Run) -> None:
    """Run the callbacks that were registered so far, and those that they register."""
    open_up(run)
    while run.callbacks.pending:
        pending = run.callbacks.pending.pop(0)
        if pending.lineage.count(pending.callback.function) >= SELF_STARTS:
            run.program.exhausted = True
            continue
        run.callbacks.started.append(pending)
        run_root(run, pending)


def run_root(run: Run, pending: Pending) -> None:
    """Run one callback on the state so far."""
    callback, value = pending.callback, pending.value
    extra = LATE_STEPS if run.late else EXTRA_STEPS
    if run.callbacks.count >= ROOTS or run.left - run.steps <= -extra:
        run.program.exhausted = True
        return
    run.callbacks.count += 1
    pending.began = began = run.callbacks.count
    within = (*run.callbacks.within, *run.branch_arms)
    pending.within = within if within or not run.callbacks.ended else None
    kept_context, kept_activations, kept_lineage = run.context, run.activations, run.callbacks.lineage
    kept_within, run.callbacks.within = run.callbacks.within, (*within, began)
    kept_bounds = run.steps, run.repeats, run.runs, run.branch_arms
    kept_allowed = run.allowed_steps
    run.left -= run.steps
    run.allowed_steps = max(FEW_STEPS, min(STEPS, run.left))
    run.context = callback
    run.callbacks.lineage = (*pending.lineage, callback.function)
    run.steps = 0
    run.repeats = {}
    run.runs = {}
    run.branch_arms = []
    module = module_of(value) or kept_activations[0].module
    run.activations = []
    enter_root(run, module)
    depth, oldest = run.store.depth, run.store.new_key()
    before = attributes_at_any_time(run) if _is_called_from_elsewhere(callback) else {}
    if before:
        run.store.push()
        run.store.apply(before)
    run.store.push()
    try:
        with run.store.meeting(oldest) as pending.read:
            given = run.call(value, CallSite(_fit(value, pending.arguments)))
            mistaken_futures.note_response(run, callback, given)
            if callback.role == model.Role.METHOD and not isinstance(value, BoundMethod):
                escapes.escape(run, [given], f"{callback.name}() returns it to its caller")
    except Exception as error:
        run.note_fault(f"following {callback.name}", error, callback.place)
    finally:
        layer = {slot: value for slot, value in run.store.cut(depth).items() if before.get(slot) is not value}
        run.context, run.activations, run.callbacks.lineage = kept_context, kept_activations, kept_lineage
        run.callbacks.within = kept_within
        run.left -= run.steps
        _, run.repeats, run.runs, run.branch_arms = kept_bounds
        run.steps, run.allowed_steps = 0, max(FEW_STEPS, kept_allowed - kept_bounds[0])
    written = left_behind.written(run, layer)
    if run.store.merge([layer, {}]):
        left_behind.note(run, written, layer, pending, oldest)


def _is_called_from_elsewhere(callback: model.Callback) -> bool:
    """Whether nothing here is seen to call it, at no certain time: a method, also ``on_configure`` of a plug-in that is
    no node itself."""
    of_plugin = callback.role == model.Role.LIFECYCLE and callback.node is None
    return callback.role == model.Role.METHOD or of_plugin


def _fit(value: Value, arguments: tuple[Value, ...]) -> list[Value]:
    """The arguments a callback takes: rclpy passes a subscription's callback the message, and the
    message's info where it takes two."""
    ir, bound = _function_and_bound(value)
    if ir is None:
        return list(arguments)
    positional = [p for p in ir.params if p.kind in ("positional_only", "normal")]
    room = max(0, len(positional) - bound)
    if any(p.kind == "star" for p in ir.params):
        return list(arguments)
    fitted = list(arguments[:room])
    while len(fitted) < room and positional[bound + len(fitted)].default is None:
        fitted.append(Unknown(f"the argument '{positional[bound + len(fitted)].name}' of a callback"))
    return fitted


def _function_and_bound(value: Value) -> tuple[facts.Function | facts.Lambda | None, int]:
    match value:
        case FunctionValue(ir=ir):
            return ir, 0
        case BoundMethod(function=function):
            inner, bound = _function_and_bound(function)
            return inner, bound + 1
        case Partial(function=function, args=given):
            inner, bound = _function_and_bound(function)
            return inner, bound + len(given)
    return None, 0


def _run_methods(run: Run) -> None:
    """Methods of the program's objects that nothing has called, if they can matter."""
    seen: dict[int, int] = {}
    for instance in list(run.instances.values()):
        cls = instance.own_class
        if cls is None:
            continue
        seen[id(cls)] = seen.get(id(cls), 0) + 1
        if seen[id(cls)] > INSTANCES:
            continue
        is_in_cpp = cls.scope.module.file.kind == "cpp"
        for function, owner in _methods(run, cls):
            ir = function.ir
            # What runs on the class, or on nothing, is the same for every object of it.
            on = 0 if {"classmethod", "staticmethod"}.intersection(function.decorators) else instance.key
            if (on, id(ir)) in run.executed or not isinstance(ir, facts.Function):
                continue
            special = ir.name.startswith("__") and ir.name != "__call__"
            if special or "abstract" in function.decorators:
                continue
            if not interesting(ir, in_cpp=is_in_cpp) and not _passes_node_on(run, instance, ir):
                continue
            bound = bind_quietly(function, instance, owner)
            is_transition = ir.name.rpartition("::")[2] in LIFECYCLE
            callback = describe(run, bound, model.Role.LIFECYCLE if is_transition else model.Role.METHOD)
            callback.node = run.nodes.by_object.get(instance.key)
            run.program.callbacks.append(callback)
            arguments = _uncalled_arguments(ir, callback.bound_arguments)
            pending = Pending(callback, bound, arguments)
            run.callbacks.tried.append(pending)
            run_root(run, pending)


def _passes_node_on(run: Run, instance: Instance, ir: facts.Function) -> bool:
    """Whether a method of a node, or of what holds one, does more with the node than use it."""
    if instance.key in run.nodes.by_object and ir.params and bare(ir, frozenset({ir.params[0].name})):
        return True
    attributes = names_in(ir).intersection(run.store.holds(instance.key))
    # What an attribute leads to takes far longer to find out than what the method does with it.
    return bool(attributes) and bare(ir, attributes) and bare(ir, escapes.holders(run, instance, attributes))


def _uncalled_arguments(ir: facts.Function, bound: int) -> tuple[Value, ...]:
    """Arguments of a method that nothing calls: unknown, flags included, since a caller may set them.  Defaults
    after the last of these stand."""
    given: list[Value] = []
    known = 0
    for param in ir.params[bound:]:
        if param.kind not in ("positional_only", "normal"):
            break
        if param.default is None or _flag(param) is not None:
            given.append(Unknown(NotPassed.as_parameter(param.name), name=param.name))
            known = len(given)
        else:
            given.append(NONE)
    if any(value is NONE for value in given[:known]):
        # A default stands before a flag: positional arguments would replace it.
        known = next(number for number, value in enumerate(given) if value is NONE)
    return tuple(given[:known])


def flags_of(function: Value | None) -> dict[str, Value]:
    """Arguments for what nothing calls: flags (parameters whose default is a truth value) are either way, since a
    caller may set them."""
    if not isinstance(function, FunctionValue):
        return {}
    return {
        param.name: OneOf((Known(flag), Known(not flag)))
        for param in function.ir.params
        if param.kind in ("normal", "keyword_only") and (flag := _flag(param)) is not None
    }


def _flag(param: facts.Param) -> bool | None:
    """The truth value that a parameter defaults to; None where its default is something else."""
    match param.default:
        case facts.Literal(bool(value)):
            return value
    return None


def bind_quietly(function: FunctionValue, instance: Instance, owner: ClassValue) -> Value:
    """Bind a method without running it, should it be a property."""
    if "staticmethod" in function.decorators:
        return function
    if "classmethod" in function.decorators:
        return BoundMethod(function, owner)
    return BoundMethod(function, instance)


def _methods(run: Run, cls: ClassValue) -> list[tuple[FunctionValue, ClassValue]]:
    """The methods an object of a class has, overridden ones left out."""
    methods: dict[str, tuple[FunctionValue, ClassValue]] = {}
    for base in cls.mro:
        if isinstance(base, ClassValue):
            names = [statement.name for statement in definitions.methods_of(base)]
            if base.scope.module.file.kind == "cpp":  # whose methods are mostly defined outside of the class
                names = [name for name, _ in run.store.variables(base.key) if not name.startswith("__")]
            for name in names:
                value = run.store.get(base.key, name)
                if isinstance(value, FunctionValue) and name not in methods:
                    for number, function in enumerate(overloads.all_of(run.index.overloads, value)):
                        methods[f"{name} {number}" if number else name] = function, cls
    return list(methods.values())


def finish(run: Run) -> None:
    """What is only known at the end: the executable's name, test code, an executor that never spun."""
    program, roles = run.program, run.index.roles
    from_test = roles.is_test(program.file)
    kept = []
    for blueprint in program.nodes:
        if from_test and not blueprint.test:
            continue  # a test makes an object of the real node: not a node of the system
        if from_test:
            # What a test makes the library create is no part of the system either.
            blueprint.creations = [c for c in blueprint.creations if roles.is_test(c.place.file)]
        if program.executable:
            blueprint.executables = (program.name,)
        if program.exhausted and not blueprint.test:
            blueprint.complete = False
            whose = "the workspace" if program.late else "its program"
            blueprint.gaps.append((blueprint.place, f"{whose} has too much code to follow all of it"))
        kept.append(blueprint)
    program.nodes[:] = kept
    cut_short = {None} if program.exhausted else set()
    for function, place in run.messages.passed_to.items():
        program.callers.setdefault(place, set()).update(run.callers.get(function, set()) | cut_short)
    executors.settle(program)
