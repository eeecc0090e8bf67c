"""Nodes in C++: what rclcpp offers, called rightly and wrongly, in code of every shape."""

from __future__ import annotations

from benchmarks.fuzz.grammar import Grammar
from benchmarks.fuzz.pick import NUMBERS, Pick

CMAKE = b"""\
project(robot)
add_executable(driver src/driver.cpp)
add_library(parts SHARED src/driver.cpp)
rclcpp_components_register_node(parts PLUGIN "robot::Driver" EXECUTABLE driver_node)
install(TARGETS driver DESTINATION lib/robot)
"""
"""What builds the file, beside a Python node."""

_FILE = """\
#include <chrono>
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "«include»"

«directive»
«outside»

namespace robot
{
«class»
«outside»
}  // namespace robot

RCLCPP_COMPONENTS_REGISTER_NODE(robot::«name_of_class»)

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  «made»
  «block»
  «spin»
  rclcpp::shutdown();
}
"""
_CLASS = """\
«template»
class «macro» «name_of_class» : «bases»
{
public:
  explicit «name_of_class»(const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : «base_call»
  {
    «block»
    «block»
  }

  «method»

private:
  void on_timer() { «statement» }
  void on_message(std_msgs::msg::String::SharedPtr message)
  {
    «block»
  }
  void on_request(std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr response)
  {
    «block»
  }
  rclcpp::Publisher<«type»>::SharedPtr publisher_ = «value»;
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client_{«value»};
  std::vector<std::string> names_{«list»};
  «declaration»
};"""

_NODES = Grammar(
    {
        "file": [_FILE],
        "include": ["robot/driver.hpp", "driver.cpp", "missing.hpp", "robot/other.hpp"],
        "directive": [
            "",
            "",
            "#define TOPIC «literal»",
            "#ifdef A\n«outside»\n#else\n«outside»\n#endif",
            "#if 0\n{(\n#endif",
        ],
        "template": ["", "", "", "template <class T, int N = 3>", "template <>"],
        "macro": ["", "", "", "ROBOT_PUBLIC", "[[nodiscard]]"],
        "name_of_class": ["Driver", "Driver", "Driver", "Arm", "Other<int>"],
        "bases": [
            *["public rclcpp::Node"] * 4,
            "public rclcpp_lifecycle::LifecycleNode",
            "public Arm",
            "public Missing, rclcpp::Node",
            "public Driver",
            "public T",
        ],
        "base_call": [
            "Node(«text»)",
            "Node(«text», options)",
            "rclcpp::Node(«text», «text»)",
            "Arm(options)",
            "publisher_(create_publisher<«type»>(«text», «qos»))",
            "names_{«list»}, Node(«text»)",
        ],
        "class": [_CLASS, _CLASS, "«class»\n\n«class»"],
        "method": [
            "",
            "auto on_goal(int goal) -> int { «block» }",
            "template <class T> void make(T value, «type» * other) { «block» }",
            "Driver & operator=(const Driver &) = delete;",
            "static Driver * instance() { static Driver d; return &d; }",
            "using Message = «type»;",
            "void later();",
            "~Driver() override { «block» }",
        ],
        "outside": [
            "",
            "static const char * TABLE[] = {«list»};",
            "constexpr auto LIMIT = «number»;",
            "void Driver::later() { «block» }",
            "void free_one(rclcpp::Node & node, int x = «value») { «block» }",
            "using Alias = «type»;\nusing namespace std::chrono_literals;",
            "typedef Driver Base;",
            "enum class Mode { A = «number», B };",
            "struct Part { rclcpp::Node * node; Part(rclcpp::Node * n) : node(n) { «block» } };",
            "}",
            "{",
            'extern "C" { «outside» }',
        ],
        "made": [
            "auto node = std::make_shared<robot::Driver>();",
            "auto node = std::make_shared<robot::Driver>(rclcpp::NodeOptions().arguments({«list»}));",
            "rclcpp::Node::SharedPtr node = rclcpp::Node::make_shared(«text»);",
            "auto node = new robot::Driver; auto other = *node;",
            "robot::Driver node;",
            "for (int i = 0; i < «number»; ++i) { auto node = std::make_shared<robot::Driver>(); }",
            "auto node = «value»;",
        ],
        "spin": [
            "rclcpp::spin(node);",
            "rclcpp::executors::MultiThreadedExecutor e; e.add_node(node); e.spin();",
            "while (rclcpp::ok()) { rclcpp::spin_some(node); «statement» }",
            "rclcpp::spin_until_future_complete(node, «value»);",
        ],
        # ---- statements
        "block": ["«statement»", "«statement»\n«statement»", "«statement»\n«block»"],
        "statement": ["«create»", "«create»", "«create»", "«act»", "«simple»", "«simple»", "«compound»", ";"],
        "create": [
            "publisher_ = create_publisher<«type»>(«text», «qos»);",
            "auto s = this->create_subscription<«type»>(«text», «qos», «callback»);",
            "client_ = create_client<std_srvs::srv::Trigger>(«text»);",
            "auto v = node->create_service<«type»>(«text», «callback», «qos», «value»);",
            "auto t = create_wall_timer(«duration», «callback»);",
            "auto t = rclcpp::create_timer(this, get_clock(), «duration», «callback»);",
            "auto a = rclcpp_action::create_server<«type»>(this, «text», «callback», «callback», «callback»);",
            "auto a = rclcpp_action::create_client<«type»>(«value», «text»);",
            "create_generic_publisher(«text», «text», «qos»);",
            "declare_parameter<«type»>(«text», «value»);",
            "declare_parameters(«text», std::map<std::string, int>{{«text», «value»}});",
            "get_parameter(«text», names_);",
            "auto x = get_parameter(«text»).as_string();",
            "create_publisher <«type»(«text»;",
            "create_client(«list»);",
        ],
        "act": [
            "publisher_->publish(«value»);",
            "client_->async_send_request(«value», «callback»);",
            "while (!client_->wait_for_service(«duration»)) { «statement» }",
            "rclcpp::sleep_for(«duration»);",
            "RCLCPP_INFO(get_logger(), «text», «value»);",
            "names_.push_back(«text»);",
            "helper(*this); free_one(*this);",
            "rclcpp::spin(shared_from_this());",
        ],
        "simple": [
            "auto x = «value»;",
            "names_[«number»] = «text»;",
            "return;",
            "x += «value»;",
            "std::string name = «text»; name += name;",
            "throw «value»;",
            "delete this;",
            "«type» message; message.data = «value»;",
            "goto end; end:;",
            "auto [a, b] = «value»;",
        ],
        "compound": [
            "if («value») { «block» } else { «block» }",
            "if (auto x = «value»; x) «statement»",
            "for (const auto & name : names_) { «block» }",
            "for (auto name : {«list»}) «statement»",
            "for (int i = 0; i < «number»; i++) { «block» }",
            "while («value») { «block» break; }",
            "do { «block» } while («value»);",
            "switch («value») { case «number»: «block» break; default: «block» }",
            "try { «block» } catch (const std::exception & e) { «block» } catch (...) { «block» }",
            "{ «block» }",
            "#ifdef A\n«statement»\n#endif",
        ],
        "declaration": ["", "int x{«number»}", "std::map<std::string, std::vector<int>> m_;", "friend class Arm;"],
        # ---- values
        "callback": [
            "std::bind(&Driver::on_message, this, std::placeholders::_1)",
            "[this](std_msgs::msg::String::SharedPtr m) { «block» }",
            "[&, x = «value»]() mutable { «statement» }",
            "on_message",
            "&Driver::missing",
            "std::bind(std::bind(&Driver::on_timer, this))",
            "«value»",
        ],
        "type": [
            "std_msgs::msg::String",
            "std_srvs::srv::Trigger",
            "Message",
            "T",
            "Alias",
            "std::vector<«type»>",
            "int",
            "::a::b",
        ],
        "qos": [
            "10",
            "«number»",
            "rclcpp::QoS(«value»).reliable()",
            "rclcpp::SensorDataQoS()",
            "rclcpp::QoS(rclcpp::KeepLast(«number»)).«word»()",
            "«value»",
        ],
        "duration": [
            "500ms",
            "1s",
            "std::chrono::milliseconds(«value»)",
            "std::chrono::duration<double>(«number»)",
            "«value»",
            "0.1min",
        ],
        "list": ["", "«text»", "«text», «text»", "«value», «list»"],
        "text": [
            "«literal»",
            "«literal»",
            "«literal»",
            "TOPIC",
            'R"(«word»)"',
            "«literal» «literal»",
            "name + «text»",
            "std::string(«text») + «text»",
            "names_[0]",
            "«value»",
        ],
        "value": [
            "«number»",
            "«literal»",
            "x",
            "true",
            "nullptr",
            "'«word»'",
            "x ? «value» : «value»",
            "(«value») «operator» («value»)",
            "std::to_string(«value»)",
            "std::make_shared<«type»>(«list»)",
            "static_cast<int>(«value»)",
            "names_.at(«value»)",
            "fmt::format(«text», «value»)",
            "get_parameter(«text»).as_int()",
            "sizeof(int)",
            "{«list»}",
            "[]() { return «value»; }()",
            "std::string(«number», 'a')",
            "*this",
            "-«value»",
        ],
        "operator": ["+", "-", "*", "/", "%", "<<", ">>", "&&", "||", "==", "<", "<=>", ","],
    },
    {
        "number": lambda pick: pick.among(NUMBERS),
        "literal": lambda pick: '"' + pick.name().replace("\\", "\\\\").replace('"', '\\"') + '"',
        "word": Pick.word,
    },
)


def node(pick: Pick) -> str:
    """A source with the class of a node or more and a ``main``."""
    return _NODES.text(pick, "file")


def header(pick: Pick) -> str:
    """A header with a class or a function."""
    return f'#pragma once\n#include "rclcpp/rclcpp.hpp"\n{_NODES.text(pick, pick.one("class", "outside"))}\n'
