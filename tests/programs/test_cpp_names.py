"""What the names of C++ mean across functions and files: variables of a file, namespaces of a header."""

from __future__ import annotations

from typing import Any

import pytest
from tests.cpp_nodes import graph

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
using String = std_msgs::msg::String;
rclcpp::Node::SharedPtr node;
std::string topic = "before";
void create() {
  node->create_publisher<String>(topic, 10);
}
%s
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  node = std::make_shared<rclcpp::Node>("robot");
  %s
  create();
  rclcpp::spin(node);
}
"""


def publishers(definitions: str = "", statements: str = "") -> list[str | None]:
    [node] = graph({"src/robot.cpp": PROGRAM % (definitions, statements)})["nodes"]
    assert node["name"] == "/robot"
    return [end["name"] for end in node["publishers"]]


def test_a_node_in_a_variable_of_the_file() -> None:
    assert publishers() == ["/before"]


def test_a_function_assigns_a_variable_of_the_file() -> None:
    assert publishers(statements='topic = "after";') == ["/after"]
    assert publishers('void choose() { topic = "chosen"; }', "choose();") == ["/chosen"]
    assert publishers('void choose() { auto set = [&]() { topic = "in_lambda"; }; set(); }', "choose();") == [
        "/in_lambda"
    ]


def test_a_variable_of_the_same_name_is_another_one() -> None:
    assert publishers('void choose() { std::string topic = "own"; topic = "other"; }', "choose();") == ["/before"]
    assert publishers('void choose(std::string topic) { topic = "other"; }', 'choose("own");') == ["/before"]


def test_a_method_assigns_a_variable_of_the_file() -> None:
    of_file = 'struct Chooser { void choose() { topic = "of_file"; } };'
    assert publishers(of_file, "Chooser chooser; chooser.choose();") == ["/of_file"]
    of_object = 'struct Chooser { std::string topic; void choose() { topic = "of_object"; } };'
    assert publishers(of_object, "Chooser chooser; chooser.choose();") == ["/before"]


HEADER = """
#pragma once
#include "rclcpp/rclcpp.hpp"
namespace first = first_msgs::msg;
namespace second = second_msgs::msg;
using namespace third_msgs::msg;
namespace own { struct Text {}; }
class Robot : public rclcpp::Node { public: Robot(); };
"""


def types(statements: str) -> dict[str, Any]:
    source = f"""
    #include "robot.hpp"
    Robot::Robot() : Node("robot") {{ {statements} }}
    int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }}
    """
    [node] = graph({"src/robot.hpp": HEADER, "src/robot.cpp": source})["nodes"]
    return {end["name"]: end["type"] for end in node["publishers"]}


def test_a_header_gives_a_namespace_another_name() -> None:
    found = types("""
      create_publisher<first::Text>("a", 10);
      create_publisher<second::Text>("b", 10);
      create_publisher<own::Text>("c", 10);
      create_publisher<unknown::Text>("d", 10);
    """)
    assert found == {"/a": "first_msgs/msg/Text", "/b": "second_msgs/msg/Text", "/c": None, "/d": None}


def test_a_header_opens_the_namespace_of_an_interface() -> None:
    assert types('create_publisher<Note>("a", 10);') == {"/a": "third_msgs/msg/Note"}
    assert types('create_publisher<Text>("a", 10);') == {"/a": None}  # a class of the workspace


def test_what_reads_like_a_function_makes_an_object() -> None:
    found = types("""
      image_transport::ImageTransport transport(shared_from_this());
      transport.advertise("image", 1);
      image_transport::ImageTransport declared(image_transport::Kind);
    """)
    assert found == {"/image": "sensor_msgs/msg/Image"}


PANEL = """
#include "rclcpp/rclcpp.hpp"
#include "rviz_common/panel.hpp"
class Panel : public rviz_common::Panel {
  Q_OBJECT
public:
  explicit Panel(QWidget * parent = nullptr);
public Q_SLOTS:
  void press();
private:
  rclcpp::Node::SharedPtr node_;
};
"""


def test_methods_outside_of_their_class_share_its_object() -> None:
    source = """
    #include "panel.hpp"
    #include "std_srvs/srv/trigger.hpp"
    Panel::Panel(QWidget * parent) : rviz_common::Panel(parent) {
      node_ = std::make_shared<rclcpp::Node>("panel");
    }
    void Panel::press() { node_->create_client<std_srvs::srv::Trigger>("go"); }
    """
    [node] = graph({"src/panel.hpp": PANEL, "src/panel.cpp": source})["nodes"]
    assert (node["name"], [client["name"] for client in node["clients"]]) == ("/panel", ["/go"])


def test_the_name_of_a_base_is_that_class_whatever_else_is_called_so() -> None:
    graph_header = "#pragma once\nnamespace path { class Node { public: Node(int cost); }; }"
    source = """
    #include "path.hpp"
    #include "rclcpp/rclcpp.hpp"
    class Robot : public rclcpp::Node { public: Robot() : Node("robot"), start_(path::Node(1)) {} path::Node start_; };
    int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
    """
    [node] = graph({"src/path.hpp": graph_header, "src/robot.cpp": source})["nodes"]
    assert node["name"] == "/robot"


def test_parameters_that_fields_are_set_to() -> None:
    source = """
    #include "rclcpp/rclcpp.hpp"
    struct Limits { double low, high; };
    class Robot : public rclcpp::Node {
    public:
      Robot() : Node("robot") {
        Limits limits = {.low = declare_parameter("low", 0.1), .high = declare_parameter("high", 0.9)};
      }
    };
    int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
    """
    [node] = graph({"src/robot.cpp": source})["nodes"]
    assert {parameter["name"]: parameter["default"] for parameter in node["parameters"]} == {"low": 0.1, "high": 0.9}


OWN_MESSAGES = """
#include "rclcpp/rclcpp.hpp"
namespace patrol {
%s
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { create_publisher<msg::Alert>("alert", 10); }
};
}
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<patrol::Robot>()); }
"""


def test_the_namespace_of_a_file_is_the_package_of_its_own_messages() -> None:
    [node] = graph({"src/robot.cpp": OWN_MESSAGES % ""})["nodes"]
    assert node["publishers"][0]["type"] == "patrol/msg/Alert"
    [node] = graph({"src/robot.cpp": OWN_MESSAGES % "namespace detail { struct Row {}; }"})["nodes"]
    assert node["publishers"][0]["type"] is None


CHANGED = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Robot : public rclcpp::Node {
public:
  Robot();
  void enable();
  void offer();
  bool enabled_ = false;
  bool never_ = false;
};
Robot::Robot() : Node("robot") {}
void Robot::enable() { enabled_ = true; declare_parameter("on", true); }
void Robot::offer() {
  if (enabled_) create_publisher<std_msgs::msg::String>("offered", 10);
  if (never_) create_publisher<std_msgs::msg::String>("never", 10);
}
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def test_a_method_outside_of_its_class_changes_what_another_finds() -> None:
    [node] = graph({"src/robot.cpp": CHANGED})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/offered"]


PLUGIN = """
#include "rviz_common/display.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Display : public rviz_common::Display {
public:
  Display();
  void onInitialize() override;
  void subscribe();
  rclcpp::Node::SharedPtr node_;
};
Display::Display() {}
void Display::onInitialize() { node_ = context_->getRosNodeAbstraction().lock()->get_raw_node(); }
void Display::subscribe() { node_->create_subscription<std_msgs::msg::String>("in", 10, nullptr); }
"""


def test_a_method_uses_what_another_one_sets_from_elsewhere() -> None:
    [helper] = graph({"src/display.cpp": PLUGIN})["nodes"]
    assert [end["name"] for end in helper["subscribers"]] == ["/in"]


BEHAVIOUR = """
#include "behaviortree_cpp/action_node.h"
#include "rclcpp_action/rclcpp_action.hpp"
#include "nav2_msgs/action/navigate_to_pose.hpp"
class GoTo : public BT::StatefulActionNode {
public:
  GoTo(const std::string & name, const BT::NodeConfiguration & conf);
  rclcpp::Node::SharedPtr node_;
};
GoTo::GoTo(const std::string & name, const BT::NodeConfiguration & conf) : BT::StatefulActionNode(name, conf) {
  %s
  if (!node_) throw BT::RuntimeError("no node");
  rclcpp_action::create_client<nav2_msgs::action::NavigateToPose>(node_, "/navigate_to_pose");
}
"""


def test_a_behaviour_gets_its_node_from_a_port() -> None:
    nodes = graph({"src/go_to.cpp": BEHAVIOUR % 'getInput("node", node_);'})["nodes"]
    assert {client["name"] for node in nodes for client in node["action_clients"]} == {"/navigate_to_pose"}
    assert not any(node["is_node"] for node in nodes)


BASE = """
#include "rclcpp/rclcpp.hpp"
class Base : public rclcpp::Node {
public:
  Base(const std::string & name, int depth) : rclcpp::Node(name) {
    create_publisher<std_msgs::msg::String>("base", depth);
  }
};
"""
INHERITING = """
#include "rclcpp/rclcpp.hpp"
class Robot : public %s {
public:
  using %s;
  void start() { create_publisher<std_msgs::msg::String>(topic_, 1); }
  std::string topic_ = "news";
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto robot = std::make_shared<Robot>(%s);
  robot->start();
  rclcpp::spin(robot);
}
"""


@pytest.mark.parametrize(
    ("base", "constructors", "arguments", "name"),
    [
        ("rclcpp::Node", "rclcpp::Node::Node", '"robot"', "/robot"),
        ("rclcpp::Node", "Node::Node", '"robot", "left"', "/left/robot"),
        ("rclcpp::Node", "rclcpp::Node::Node", '"robot", rclcpp::NodeOptions()', "/robot"),
        ("rclcpp::Node", "rclcpp::Node::Node", '"robot", "left", rclcpp::NodeOptions()', "/left/robot"),
        ("Base", "Base::Base", '"robot", 3', "/robot"),
    ],
)
def test_a_class_takes_over_the_constructors_of_its_base(base: str, constructors: str, arguments: str, name: str):
    source = (BASE if base == "Base" else "") + INHERITING % (base, constructors, arguments)
    [node] = graph({"src/robot.cpp": source})["nodes"]
    ends = [(end["written"], end["qos"]["depth"]) for end in node["publishers"]]
    assert (node["name"], ends) == (name, [*([("base", 3)] if base == "Base" else []), ("news", 1)])


OPENED = """
#include "rclcpp/rclcpp.hpp"
using namespace std;
using namespace rclcpp;
class Robot : public Node {
public:
  Robot() : Node("robot") {
    string topic = string("scan") + "/" + to_string(2);
    publishers_.push_back(create_publisher<std_msgs::msg::String>(topic, QoS(KeepLast(3)).best_effort()));
    for (auto name : vector<string>{"a", "b"}) {
      publishers_.push_back(create_publisher<std_msgs::msg::String>(name, SensorDataQoS()));
    }
    init();
  }
  void init() { timer_ = create_wall_timer(chrono::milliseconds(20), bind(&Robot::tick, this)); }
  void tick() { helper_ = make_shared<Node>("helper"); }
  vector<Publisher<std_msgs::msg::String>::SharedPtr> publishers_;
  TimerBase::SharedPtr timer_;
  shared_ptr<Node> helper_;
};
int main(int argc, char ** argv) {
  init(argc, argv);
  spin(make_shared<Robot>());
}
"""


def test_names_of_libraries_whose_namespace_is_opened() -> None:
    nodes = {node["name"]: node for node in graph({"src/robot.cpp": OPENED})["nodes"]}
    assert sorted(nodes) == ["/helper", "/robot"]
    robot = nodes["/robot"]
    ends = [(end["name"], end["qos"]["depth"], end["qos"]["reliability"]) for end in robot["publishers"]]
    assert ends == [("/a", 5, "best_effort"), ("/b", 5, "best_effort"), ("/scan/2", 3, "best_effort")]
    assert [timer["period_s"] for timer in robot["timers"]] == [0.02]


def test_a_class_of_the_file_is_none_of_a_library_that_is_opened() -> None:
    own = "class QoS { public: QoS(int) {} };"
    source = own + OPENED.replace("KeepLast(3)", "3").replace(".best_effort()", "")
    [robot] = [node for node in graph({"src/robot.cpp": source})["nodes"] if node["name"] == "/robot"]
    assert (robot["publishers"][2]["name"], robot["publishers"][2]["qos"]["reliability"]) == ("/scan/2", None)


ASKED = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  bool images = false;
  int count = 0;
  std::istringstream(argv[1]) >> images >> count;
  if (images) node->create_publisher<std_msgs::msg::String>("images", 1);
  if (count > 3) node->create_publisher<std_msgs::msg::String>("many", 1);
  rclcpp::spin(node);
}
"""


def test_what_a_stream_reads_may_be_anything() -> None:
    [node] = graph({"src/robot.cpp": ASKED})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/images", "/many"]
    [node] = graph({"src/robot.cpp": ASKED.replace(" >> count", "")})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/images"]


FREE = """
#include "rclcpp/rclcpp.hpp"
#include "ends.hpp"
void ends::open(rclcpp::Node & node, const std::string & prefix) {
  node.create_publisher<std_msgs::msg::String>(prefix + "/open", 1);
}
std::string ends::names::base = "base";
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  ends::open(*node, ends::names::base);
  rclcpp::spin(node);
}
"""
ENDS = """
#pragma once
namespace ends {
void open(rclcpp::Node & node, const std::string & prefix);
namespace names { extern std::string base; }
}
"""


def test_a_function_may_be_defined_with_the_namespace_that_a_header_opens() -> None:
    [node] = graph({"src/robot.cpp": FREE, "src/ends.hpp": ENDS})["nodes"]
    assert (node["name"], [end["name"] for end in node["publishers"]]) == ("/robot", ["/base/open"])


SMALL = """
#include "rclcpp/rclcpp.hpp"
#include "driver.hpp"
driver::driver(rclcpp::Node * node) : node_(node) {}
void driver::open() { node_->create_publisher<std_msgs::msg::String>("driver", 1); }
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::Node node("robot");
  driver robot(&node);
  robot.open();
}
"""
DRIVER = "class driver { public: driver(rclcpp::Node * node); void open(); rclcpp::Node * node_; };"


def test_a_class_may_be_written_small() -> None:
    [node] = graph({"src/robot.cpp": SMALL, "src/driver.hpp": DRIVER})["nodes"]
    assert (node["name"], [end["name"] for end in node["publishers"]]) == ("/robot", ["/driver"])


OPTIONS = """
#include "rclcpp/rclcpp.hpp"
class Robot : public rclcpp::Node {
public:
  explicit Robot(%s) : rclcpp::Node("robot", given) { create_publisher<std_msgs::msg::String>("a", 1); }
};
"""


@pytest.mark.parametrize(
    ("parameter", "name"),
    [
        ("const rclcpp::NodeOptions & given", "/a"),
        ("rclcpp::NodeOptions given = rclcpp::NodeOptions()", "/a"),
        ("const std::string & given", None),  # it may be any namespace
    ],
)
def test_the_type_of_a_parameter_says_whether_it_is_options(parameter: str, name: str | None) -> None:
    [node] = graph({"src/robot.cpp": OPTIONS % parameter})["nodes"]
    assert [end["name"] for end in node["publishers"]] == [name]


def test_macros_may_be_made_of_others() -> None:
    source = """
    #include "rclcpp/rclcpp.hpp"
    #define PREFIX "arm"
    #define TOPIC PREFIX "/state"
    #define DEPTH (5)
    int main(int argc, char ** argv) {
      rclcpp::init(argc, argv);
      rclcpp::Node node("robot");
      auto publisher = node.create_publisher<std_msgs::msg::String>(TOPIC, DEPTH);
      rclcpp::spin(node.get_node_base_interface());
    }
    """
    [node] = graph({"src/robot.cpp": source})["nodes"]
    assert [(end["name"], end["qos"]["depth"]) for end in node["publishers"]] == [("/arm/state", 5)]


BOTH_ROS = """
#include "rclcpp/rclcpp.hpp"
%s
class Robot : public rclcpp::Node {
public:
  Robot() : rclcpp::Node("robot") { create_publisher<StringMsg>("a", 1); }
};
"""
ROS_1, ROS_2 = "using StringMsg = std_msgs::String;", "using StringMsg = std_msgs::msg::String;"


@pytest.mark.parametrize("branches", [("#if defined(FOR_ROS2)", ROS_2, ROS_1), ("#ifdef FOR_ROS1", ROS_1, ROS_2)])
def test_of_the_types_of_ros_1_and_ros_2_the_latter_is_meant(branches: tuple[str, str, str]) -> None:
    condition, first, second = branches
    aliases = f"{condition}\n{first}\n#else\n{second}\n#endif"
    [node] = graph({"src/robot.cpp": BOTH_ROS % aliases})["nodes"]
    assert [end["type"] for end in node["publishers"]] == ["std_msgs/msg/String"]
