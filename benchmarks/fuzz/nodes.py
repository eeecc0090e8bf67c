"""Nodes in Python: what rclpy offers, called rightly and wrongly, in code of every shape."""

from __future__ import annotations

from benchmarks.fuzz.grammar import Grammar
from benchmarks.fuzz.pick import NUMBERS, Pick

_MODULE = """\
import os
import time
import threading
import functools
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import *
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import Float64, String
from robot_interfaces.msg import State
from robot_interfaces.srv import SetMode

TOPIC = «text»
TABLE = «value»


«class»


def main():
    rclpy.init()
    node = «made»
    «spin»


if __name__ == '__main__':
    main()
"""
_CLASS = """\
class «name_of_class»(«bases»):
    def __init__(self, *names, **options):
        super().__init__(«text»)
        self.group = «group»
        self.names = «value»
        self.client = self.create_client(«type», «text»)
        self.publisher = self.create_publisher(«type», «text», «qos»)
        «block»
        «block»

    «method»

    «decorator»
    «def» on_timer(self):
        «block»

    def on_message(self, message):
        «block»

    «def» on_request(self, request, response):
        «block»
        return response

    def helper(self, goal=None):
        «block»
        return «expression»"""

_OPERATORS = "+ - * / // % ** << >> & | ^ @ == < in is and or !="
_FUNCTIONS = (
    "range sum list len str int abs min max sorted zip round dict set iter bytes hash ord chr bin divmod pow "
    "type vars super next reversed map slice getattr setattr filter isinstance enumerate any all tuple "
    "frozenset float bool format hasattr callable repr id print open eval input complex bytearray memoryview "
    "issubclass"
)
_TEXT_METHODS = (
    "split strip replace center zfill encode join expandtabs count startswith translate rjust splitlines "
    "partition title format format_map lower find index rsplit removeprefix"
)

_NODES = Grammar(
    {
        "module": [_MODULE],
        "class": [_CLASS, _CLASS, "«class»\n\n\n«class»"],
        "name_of_class": ["Robot", "Robot", "Arm", "Robot2"],
        "bases": [*["Node"] * 5, "rclpy.node.Node", "Node, threading.Thread", "object", "Robot", "Missing", "*BASES"],
        "method": ["", "«decorator»\n«def» on_goal(self, goal):\n    «block»", "«statement»", "on_goal = «callback»"],
        "decorator": ["", "", "", "", "@staticmethod", "@property", "@functools.lru_cache", "@missing(1)"],
        "def": ["def", "def", "def", "async def"],
        "made": ["Robot()", "Robot()", "Robot('a', *[1, 2])", "Arm()", "rclpy.create_node(«text»)", "«expression»"],
        "spin": [
            "rclpy.spin(node)",
            "rclpy.spin(node)",
            "executor = MultiThreadedExecutor(num_threads=4)\nexecutor.add_node(node)\nexecutor.spin()",
            "while rclpy.ok():\n    rclpy.spin_once(node, timeout_sec=0.1)",
            "threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()\nnode.on_timer()",
            "rclpy.spin_until_future_complete(node, node.future)",
            "«block»",
        ],
        # ---- statements
        "block": ["«statement»", "«statement»\n«statement»", "«statement»\n«block»"],
        "statement": [
            "pass",
            "«create»",
            "«create»",
            "«create»",
            "«act»",
            "«act»",
            "«wait»",
            "«simple»",
            "«simple»",
            "«compound»",
        ],
        "create": [
            "self.publisher = self.create_publisher(«type», «text», «qos»)",
            "self.create_subscription(«type», «text», «callback», «qos»)",
            "self.create_subscription(«type», «text», «callback», «qos», callback_group=«group»)",
            "self.client = self.create_client(«type», «text», callback_group=«group»)",
            "self.create_service(«type», «text», «callback»)",
            "self.timer = self.create_timer(«number», «callback»)",
            "self.create_timer(«number», «callback», «group»)",
            "self.action = ActionClient(self, «type», «text»)",
            "self.server = ActionServer(self, «type», «text», «callback»)",
            "self.declare_parameter(«text», «value»)",
            "self.declare_parameters('', [(«text», «value»), («text»,)])",
            "self.set_parameters([rclpy.parameter.Parameter(«text», value=«value»)])",
            "self.add_on_set_parameters_callback(«callback»)",
            "«local» = self.get_parameter(«text»).value",
            "[self.create_publisher(«type», n, «qos») for n in «value»]",
            "self.create_publisher(*«value»)",
            "self.create_publisher(«type» «text», «qos»)",
            "getattr(self, «text»)(«type», «text», «qos»)",
            "Robot(«text»)",
        ],
        "act": [
            "self.publisher.publish(«type»(data=«text»))",
            "self.publisher.publish(«expression»)",
            "self.future = self.client.call_async(«type».Request())",
            "self.client.call(«type».Request(a=«value»))",
            "self.future.add_done_callback(«callback»)",
            "self.get_logger().info(«text», throttle_duration_sec=«number»)",
            "self.«name_of_method»(«expression»)",
            "self.action.send_goal_async(«type».Goal(order=«number»), feedback_callback=«callback»)",
            "message.«word» = «expression»",
            "response.success = «expression»",
            "self.destroy_node()",
        ],
        "wait": [
            "rclpy.spin_until_future_complete(self, self.future)",
            "rclpy.spin_until_future_complete(self, self.future, timeout_sec=«number»)",
            "self.client.wait_for_service()",
            "self.client.wait_for_service(timeout_sec=«number»)",
            "while not self.client.wait_for_service(«number»):\n    «block»",
            "time.sleep(«number»)",
            "self.future.result()",
            "«local» = await self.future",
            "self.create_rate(«number»).sleep()",
            "rclpy.spin_once(self)",
            "self.lock.acquire()",
        ],
        "simple": [
            "pass",
            "return",
            "return «expression»",
            "raise ValueError(«expression»)",
            "«local» = «expression»",
            "«local» += «expression»",
            "self.«word» = «expression»",
            "self.names[«expression»] = «expression»",
            "self.names.append(«expression»)",
            "«local», *rest = «expression»",
            "del «local»",
            "break",
            "assert «expression», «text»",
            "import «word».«word»",
        ],
        "compound": [
            "if «expression»:\n    «block»",
            "if «expression»:\n    «block»\nelif «expression»:\n    «block»\nelse:\n    «block»",
            "for «local» in «expression»:\n    «block»",
            "for local_one, local_two in enumerate(«expression»):\n    «block»\nelse:\n    «block»",
            "while «expression»:\n    «block»",
            "while rclpy.ok() and not self.future.done():\n    «block»",
            "try:\n    «block»\nexcept «exception»:\n    «block»\nfinally:\n    «block»",
            "with self.lock:\n    «block»",
            "with «expression» as «local»:\n    «block»",
            "def inner(a=1, *b, **c):\n    «block»",
            "class Inner(Node):\n    def __init__(self):\n        «block»",
            "match «expression»:\n    case [«local», *_]:\n        «block»\n    case {'a': 1}:\n        «block»",
        ],
        "exception": ["Exception", "KeyError as error", "(A, B)", "TimeoutError"],
        # ---- expressions
        "type": [
            "String",
            "Float64",
            "State",
            "AddTwoInts",
            "SetMode",
            "Fibonacci",
            "'std_msgs/msg/String'",
            "Missing",
            "«expression»",
        ],
        "qos": [
            *(
                "10",
                "0",
                "-1",
                "qos_profile_sensor_data",
                "QoSProfile(depth=5)",
                "QoSProfile()",
                "QoSPresetProfiles.SERVICES_DEFAULT.value",
            ),
            "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)",
            "QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)",
            "QoSProfile(depth=«number», history=HistoryPolicy.KEEP_ALL, deadline=Duration(seconds=«number»))",
            "QoSProfile(«expression», lifespan=«expression»)",
            "«expression»",
        ],
        "group": ["None", "self.group", "MutuallyExclusiveCallbackGroup()", "ReentrantCallbackGroup()", "«expression»"],
        "callback": [
            *["self.«name_of_method»"] * 5,
            "lambda *given: self.«name_of_method»(*given)",
            "functools.partial(self.«name_of_method», «text»)",
            "«expression»",
        ],
        "name_of_method": ["on_timer", "on_message", "on_request", "on_goal", "helper"],
        "local": ["local_one", "local_two", "local_three"],
        "text": [
            *["«literal»"] * 8,
            "f'{TOPIC}/{«plain»!r:>8}'",
            "«literal» + «expression»",
            "«literal» % «expression»",
            "«literal».format(«expression», a=«expression»)",
            "'/'.join(«expression»)",
            "os.path.join(«literal», «expression»)",
            "«literal» * «number»",
            "«literal»[«expression»:«number»]",
            "self.get_parameter(«literal»).get_parameter_value().string_value",
            "«expression»",
        ],
        "plain": ["TOPIC", "self.names", "local_one", "1", "len(TABLE)", "TABLE[0]"],
        "value": ["«number»", "«literal»", "[«literal», «literal»]", "{«literal»: «value»}", "[]", "«expression»"],
        "expression": [
            *(
                "(«number»)",
                "«literal»",
                "self.names",
                "TABLE",
                "TOPIC",
                "«local»",
                "[]",
                "{}",
                "self",
                "options",
                "names",
                "self.«word»",
            ),
            "[«expression», «expression»]",
            "(«expression»,)",
            "{«text»: «expression»}",
            "{**«expression», 'a': «expression»}",
            "[*«expression», «expression»]",
            "[n for n in «expression» if «expression»]",
            "{n: m for n, m in «expression».items()}",
            "«function»(«expression»)",
            "«function»(«expression», «expression»)",
            "«function»(*«expression»)",
            "«text».«text_method»()",
            "«text».«text_method»(«expression»)",
            "«text».«text_method»(«expression», «expression»)",
            "(«expression» «operator» «expression»)",
            "(«expression» «operator» «expression»)",
            "(«sign»«expression»)",
            "(«expression» if «expression» else «expression»)",
            "(lambda a, *b, c=1: «expression»)",
            "«expression»[«expression»]",
            "«expression»[«expression»:«expression»]",
            "«expression».«list_method»",
            "(local_one := «expression»)",
            "f'{«plain»}{«plain»:«width»}'",
            "functools.partial(«callback», «expression»)",
            "functools.reduce(«callback», «expression»)",
            "os.environ.get(«expression»)",
            "os.listdir(«expression»)",
            "Duration(seconds=«number»)",
            "Duration(nanoseconds=«number»)",
            "self.get_parameter(«text»).value",
            "self.«name_of_method»(«expression»)",
            "(yield «expression»)",
            "(await «expression»)",
            "(a for a in «expression»)",
        ],
        "operator": _OPERATORS.split(),
        "sign": ["not ", "-", "~", "+"],
        "function": _FUNCTIONS.split(),
        "text_method": _TEXT_METHODS.split(),
        "list_method": [
            *(
                "items()",
                "append(self.names)",
                "pop()",
                "update(TABLE)",
                "get(0, self)",
                "sort()",
                "value",
                "extend(self.names)",
            ),
            *(
                "insert(10**20, 0)",
                "copy()",
                "values()",
                "setdefault(0, [])",
                "pop(«expression»)",
                "index(«expression»)",
                "count(1)",
            ),
        ],
        "width": [">10", ".3f", "08d", "x", "^99999999999", "{TOPIC}", "{len(TABLE)}"],
    },
    {
        "number": lambda pick: pick.among(NUMBERS),
        "literal": lambda pick: repr(pick.name()),
        "word": Pick.word,
    },
)


def node(pick: Pick) -> str:
    """A module with a node or more and a ``main``."""
    return _NODES.text(pick, "module")
