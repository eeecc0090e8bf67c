"""Members of C++ that are objects of classes of other files, which the list of a constructor may make."""

from __future__ import annotations

from typing import Any

import pytest
from tests.cpp_nodes import graph

HEADER = """
#pragma once
#include "rclcpp/rclcpp.hpp"
struct Config {
  std::string topic = "state";
  int depth{3};
};
enum class Mode { idle, busy };
class Wheel {
public:
  Wheel(rclcpp::Node * node, const std::string & name);
private:
  std::shared_ptr<rclcpp::Publisher<std_msgs::msg::Float64>> speed_;
};
"""
ROBOT = """
#pragma once
#include "wheel.hpp"
class Robot : public rclcpp::Node {
public:
  Robot();
private:
  Config read();
  Wheel left_;
  Wheel right_;
  Config config_;
  Config plain_;
  Mode mode_;
  rclcpp::QoS qos_;
};
"""
SOURCE = """
#include "robot.hpp"
Wheel::Wheel(rclcpp::Node * node, const std::string & name) {
  speed_ = node->create_publisher<std_msgs::msg::Float64>(name + "/speed", 1);
}
Robot::Robot() : Node("robot"), left_(this, "left"), right_{this, "right"}, %s { %s }
Config Robot::read() {
  Config config;
  config.topic = "read";
  return config;
}
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def publishers(made: str, body: str = "") -> dict[str, Any]:
    """What the robot publishes, by name, beside what its wheels do."""
    files = {"src/wheel.hpp": HEADER, "src/robot.hpp": ROBOT, "src/robot.cpp": SOURCE % (made, body)}
    [node] = graph(files)["nodes"]
    ends = {end["name"]: end for end in node["publishers"]}
    assert ends.pop("/left/speed")["type"] == ends.pop("/right/speed")["type"] == "std_msgs/msg/Float64"
    return ends


def publishes(topic: str, qos: str = "1") -> str:
    return f"create_publisher<std_msgs::msg::String>({topic}, {qos});"


def test_a_member_is_made_with_what_the_list_of_a_constructor_gives_it() -> None:
    assert publishers("mode_(Mode::idle)") == {}


def test_a_member_that_nothing_makes_has_the_first_values_of_its_class() -> None:
    [end] = publishers("mode_(Mode::idle)", publishes("plain_.topic", "plain_.depth")).values()
    assert (end["name"], end["qos"]["depth"]) == ("/state", 3)


def test_a_member_that_is_copied_has_what_the_other_has() -> None:
    assert list(publishers("config_(read())", publishes("config_.topic"))) == ["/read"]
    assert list(publishers("plain_(read()), config_(plain_)", publishes("config_.topic"))) == ["/read"]


def test_a_profile_is_made_of_a_depth() -> None:
    [end] = publishers("config_(), qos_(config_.depth)", publishes('"a"', "qos_")).values()
    assert (end["qos"]["depth"], end["qos"]["reliability"]) == (3, "reliable")


def test_a_member_of_an_enum_has_no_value_of_its_own() -> None:
    body = 'if (mode_ == Mode::busy) { create_publisher<std_msgs::msg::String>("busy", 1); }'
    assert list(publishers("config_()", body)) == ["/busy"]


ALONE = """
#pragma once
#include "controller_interface/controller_interface.hpp"
namespace arm {
class Controller : public controller_interface::ControllerInterface {
public:
  CallbackReturn on_init() override;
  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override;
private:
  using State = control_msgs::msg::MultiDOFStateStamped;
  std::string topic_ = "~/reference";
};
}
"""
METHODS = """
#include "controller.hpp"
namespace arm {
CallbackReturn Controller::on_init() { topic_ = chosen(); return CallbackReturn::SUCCESS; }
CallbackReturn Controller::on_configure(const rclcpp_lifecycle::State &) {
  get_node()->create_publisher<State>("~/status", rclcpp::SystemDefaultsQoS());
  get_node()->create_subscription<std_msgs::msg::Float64>(topic_, 1, nullptr);
  return CallbackReturn::SUCCESS;
}
}
"""


def test_a_method_that_nothing_calls_knows_the_types_of_its_class_but_not_its_fields() -> None:
    nodes = graph({"src/controller.hpp": ALONE, "src/controller.cpp": METHODS})["nodes"]
    [status] = [end for node in nodes for end in node["publishers"]]
    assert (status["written"], status["type"]) == ("~/status", "control_msgs/msg/MultiDOFStateStamped")
    [reference] = [end for node in nodes for end in node["subscribers"]]
    assert reference["name"] is None


PORT = """
#pragma once
#include "rclcpp/rclcpp.hpp"
class Port {
public:
  using Trigger = std_srvs::srv::Trigger;
  Port(rclcpp::Node::SharedPtr node, std::string name);
  void ask() { client_->async_send_request(nullptr); }
  std::string name_;
  rclcpp::Client<Trigger>::SharedPtr client_;
};
"""


def test_a_constructor_is_not_followed_beside_its_class() -> None:
    source = """
    #include "port.hpp"
    Port::Port(rclcpp::Node::SharedPtr node, std::string name)
    : name_(name), client_(node->create_client<Trigger>(name_)) {}
    """
    nodes = graph({"src/port.hpp": PORT, "src/port.cpp": source})["nodes"]
    assert [client["type"] for node in nodes for client in node["clients"]] == ["std_srvs/srv/Trigger"]


OUTER = """
#pragma once
#include "rclcpp/rclcpp.hpp"
class Robot : public rclcpp::Node {
public:
  Robot();
private:
  struct Topics { std::string first = "first"; std::string second = "second"; };
  struct Row { std::string name; int depth; };
  struct Channel {
    Channel(Robot * robot, const std::string & name);
    rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher;
  };
  enum class Mode { idle, busy };
  Topics topics_;
  std::vector<Row> rows_;
  std::unique_ptr<Channel> channel_;
  Mode mode_{Mode::idle};
};
"""
INNER = """
#include "robot.hpp"
Robot::Channel::Channel(Robot * robot, const std::string & name) {
  publisher = robot->create_publisher<std_msgs::msg::String>(name, 1);
}
Robot::Robot() : Node("robot") {
  topics_.second = "changed";
  create_publisher<std_msgs::msg::String>(topics_.first, 1);
  create_publisher<std_msgs::msg::String>(topics_.second, 1);
  rows_.push_back({"row", 3});
  rows_.push_back({.name = "other", .depth = 4});
  for (const auto & row : rows_) { create_publisher<std_msgs::msg::String>(row.name, row.depth); }
  channel_ = std::make_unique<Channel>(this, "channel");
  if (mode_ == Mode::busy) { create_publisher<std_msgs::msg::String>("busy", 1); }
}
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def test_classes_in_a_class() -> None:
    [node] = graph({"src/robot.hpp": OUTER, "src/robot.cpp": INNER})["nodes"]
    depths = {end["name"]: end["qos"]["depth"] for end in node["publishers"]}
    assert depths == {"/first": 1, "/changed": 1, "/row": 3, "/other": 4, "/channel": 1}


POINTS = """
#include "rclcpp/rclcpp.hpp"
struct Point {
  PCL_ADD_POINT4D;
  double time;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW  // for vectors of them
} EIGEN_ALIGN16;
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { create_publisher<sensor_msgs::msg::PointCloud2>(topic_, 1); }
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
private:
  std::string topic_ = "scan";
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def test_types_of_points_are_written_with_macros() -> None:
    [node] = graph({"src/robot.cpp": POINTS})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/scan"]


SETTINGS = """
#include "rclcpp/rclcpp.hpp"
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    declare_parameter("name", "arm");
    read();
  }
  void read() {
    settings.name = get_parameter("name").as_string();
    state_ = create_publisher<std_msgs::msg::String>(settings.name + "/state", settings.depth);
  }
private:
  %s
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr state_;
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Talker>()); }
"""


@pytest.mark.parametrize(
    "member",
    [
        "struct { std::string name; int depth = 7; } settings;",
        "struct Settings { std::string name; int depth = 7; } settings;",
        "struct { std::string name; int depth{7}; } settings, others;",
        "class Settings { public: std::string name; int depth = 7; }; Settings settings;",
    ],
)
def test_a_member_whose_type_is_written_with_it(member: str) -> None:
    [node] = graph({"src/talker.cpp": SETTINGS % member})["nodes"]
    [end] = node["publishers"]
    assert (end["name"], end["qos"]["depth"]) == ("/arm/state", 7)


HELPER = """
#include "rclcpp/rclcpp.hpp"
class Helper {
public:
  void attach(rclcpp_lifecycle::LifecycleNode * node) { node_ = node; }
private:
  rclcpp_lifecycle::LifecycleNode * node_{%s};
};
class Robot : public rclcpp_lifecycle::LifecycleNode {
public:
  Robot() : LifecycleNode("robot"), helper_(std::make_shared<Helper>()) { helper_->attach(this); }
private:
  std::shared_ptr<Helper> helper_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>()->get_node_base_interface());
}
"""


@pytest.mark.parametrize("value", ["nullptr", ""])
def test_a_pointer_in_braces_makes_no_node(value: str) -> None:
    assert [node["name"] for node in graph({"src/robot.cpp": HELPER % value})["nodes"]] == ["/robot"]


FILTERS = """
#include "rclcpp/rclcpp.hpp"
#include "filters/filter_chain.hpp"
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot"), chain_("double") {
    chain_.configure("", get_node_logging_interface(), get_node_parameters_interface());
  }
  filters::FilterChain<double> chain_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def test_a_member_of_a_class_of_elsewhere_is_no_text_that_it_is_made_of() -> None:
    [node] = graph({"src/robot.cpp": FILTERS})["nodes"]
    assert not node["complete"]  # configure() declares what the parameters name


DERIVED = """
#include "rclcpp/rclcpp.hpp"
class Base : public rclcpp::Node {
public:
  Base() : Node("base") { declare_parameter("rate", 1.0); }
};
class Robot : public Base {
public:
  Robot() : Base::Base() {}
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def test_a_constructor_of_a_base_may_be_called_by_its_whole_name() -> None:
    [node] = graph({"src/robot.cpp": DERIVED})["nodes"]
    assert (node["name"], [parameter["name"] for parameter in node["parameters"]]) == ("/base", ["rate"])


OWN_NODE = """
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
namespace robots {
class LifecycleNode : public rclcpp_lifecycle::LifecycleNode {
public:
  LifecycleNode(const std::string & name, const std::string & ns, const rclcpp::NodeOptions & options)
  : rclcpp_lifecycle::LifecycleNode(name, ns, options) { declare_parameter("bond", 1.0); }
  LifecycleNode(const std::string & name, const rclcpp::NodeOptions & options)
  : DELEGATED(name, "arm", options) {}
};
class Robot : public robots::LifecycleNode {
public:
  explicit Robot(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : robots::LifecycleNode("robot", options) {}
};
}
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<robots::Robot>()->get_node_base_interface());
}
"""


@pytest.mark.parametrize("written", ["LifecycleNode", "robots::LifecycleNode"])
def test_a_class_that_is_called_like_one_of_rclcpp_takes_what_its_own_constructors_take(written: str) -> None:
    [node] = graph({"src/robot.cpp": OWN_NODE.replace("DELEGATED", written)})["nodes"]
    assert (node["name"], [parameter["name"] for parameter in node["parameters"]]) == ("/arm/robot", ["bond"])
