"""Class templates and function templates of C++ whose argument is the type of a message."""

from __future__ import annotations

from typing import Any

from tests.cpp_nodes import graph, graph_of

CMAKE = """
project(robot)
add_executable(robot src/main.cpp)
install(TARGETS robot DESTINATION lib/${PROJECT_NAME})
"""
MAIN = """
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(%s);
}
"""
RELAY = """
#include "rclcpp/rclcpp.hpp"
template <typename MessageT, typename OutT = MessageT>
class Relay : public rclcpp::Node {
public:
  explicit Relay(const std::string & name) : rclcpp::Node(name) {
    pub_ = this->template create_publisher<OutT>("~/out", 10);
    open();
  }
  void open();
private:
  typename rclcpp::Publisher<OutT>::SharedPtr pub_;
  typename rclcpp::Subscription<MessageT>::SharedPtr sub_;
};
template <typename T, typename O>
void Relay<T, O>::open() {
  sub_ = this->template create_subscription<T>("~/in", 10, [this](typename T::SharedPtr m) { pub_->publish(*m); });
}
"""


def types(code: str) -> list[tuple[str, str | None]]:
    """The names and types of what a program publishes and subscribes to."""
    nodes = graph({"src/main.cpp": code, "CMakeLists.txt": CMAKE})["nodes"]
    ends = [end for node in nodes for kind in ("publishers", "subscribers") for end in node[kind]]
    return sorted((end["name"], end["type"]) for end in ends)


def test_an_object_knows_the_template_arguments_of_its_class() -> None:
    code = RELAY + MAIN % 'std::make_shared<Relay<sensor_msgs::msg::Imu>>("imu")'
    assert types(code) == [("/imu/in", "sensor_msgs/msg/Imu"), ("/imu/out", "sensor_msgs/msg/Imu")]


def test_two_objects_of_a_template_have_types_of_their_own() -> None:
    code = (
        RELAY
        + """
        using ScanRelay = Relay<sensor_msgs::msg::LaserScan, sensor_msgs::msg::PointCloud2>;
        int main(int argc, char ** argv) {
          rclcpp::init(argc, argv);
          auto imu = std::make_shared<Relay<sensor_msgs::msg::Imu>>("imu");
          auto scan = std::make_shared<ScanRelay>("scan");
          rclcpp::executors::SingleThreadedExecutor executor;
          executor.add_node(imu);
          executor.add_node(scan);
          executor.spin();
        }
    """
    )
    assert types(code) == [
        ("/imu/in", "sensor_msgs/msg/Imu"),
        ("/imu/out", "sensor_msgs/msg/Imu"),
        ("/scan/in", "sensor_msgs/msg/LaserScan"),
        ("/scan/out", "sensor_msgs/msg/PointCloud2"),
    ]


NAMED_IN_A_HEADER = """
#include "relay.hpp"
namespace shop { using ScanRelay = Relay<sensor_msgs::msg::LaserScan, sensor_msgs::msg::PointCloud2>; }
"""


def types_with_a_header(code: str) -> list[tuple[str, str | None]]:
    """The same where headers define the template, and give it a name with its arguments."""
    files = {"include/relay.hpp": RELAY, "include/relays.hpp": NAMED_IN_A_HEADER, "CMakeLists.txt": CMAKE}
    nodes = graph({**files, "src/main.cpp": '#include "relays.hpp"' + code})["nodes"]
    assert [node["executable"] for node in nodes] == ["robot"]
    ends = [end for node in nodes for kind in ("publishers", "subscribers") for end in node[kind]]
    return sorted((end["name"], end["type"]) for end in ends)


def test_a_header_names_a_template_with_its_arguments() -> None:
    assert types_with_a_header(MAIN % 'std::make_shared<shop::ScanRelay>("scan")') == [
        ("/scan/in", "sensor_msgs/msg/LaserScan"),
        ("/scan/out", "sensor_msgs/msg/PointCloud2"),
    ]


def test_a_class_derives_from_a_template_that_a_header_names() -> None:
    derived = """
        class Doors : public shop::ScanRelay {
        public:
          Doors() : ScanRelay("doors") { count_ = create_publisher<std_msgs::msg::Int32>("~/count", 10); }
          rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr count_;
        };
    """
    assert types_with_a_header(derived + MAIN % "std::make_shared<Doors>()") == [
        ("/doors/count", "std_msgs/msg/Int32"),
        ("/doors/in", "sensor_msgs/msg/LaserScan"),
        ("/doors/out", "sensor_msgs/msg/PointCloud2"),
    ]


def test_a_class_names_the_template_arguments_of_its_base() -> None:
    derived = """
        class Words : public Relay<std_msgs::msg::String> {
        public:
          Words() : Relay("words") {}
        };
    """
    code = RELAY + derived + MAIN % "std::make_shared<Words>()"
    assert types(code) == [("/words/in", "std_msgs/msg/String"), ("/words/out", "std_msgs/msg/String")]


def test_a_template_takes_names_from_its_argument() -> None:
    code = """
        #include "rclcpp/rclcpp.hpp"
        struct Text {
          using Message = std_msgs::msg::String;
          static constexpr const char * topic = "text";
        };
        template <class Traits>
        class Source : public rclcpp::Node {
        public:
          Source() : Node("source") { pub_ = create_publisher<typename Traits::Message>(Traits::topic, 10); }
          typename rclcpp::Publisher<typename Traits::Message>::SharedPtr pub_;
        };
    """
    assert types(code + MAIN % "std::make_shared<Source<Text>>()") == [("/text", "std_msgs/msg/String")]


def test_an_argument_that_nobody_writes_down_is_not_known() -> None:
    code = RELAY + MAIN % 'std::make_shared<Relay<Chosen<1>::Message>>("imu")'
    assert types(code) == [("/imu/in", None), ("/imu/out", None)]


def ends_of(body: str) -> list[dict[str, Any]]:
    code = """
        #include "rclcpp/rclcpp.hpp"
        class Robot : public rclcpp::Node {
        public:
          Robot() : Node("robot") { %s }
          template <typename M, typename Q = std_msgs::msg::Bool>
          void add(const std::string & topic) {
            first_ = create_publisher<M>(topic, 10);
            second_ = create_publisher<Q>(topic + "_state", 10);
          }
        };
    """
    nodes = graph({"src/main.cpp": code % body + MAIN % "std::make_shared<Robot>()", "CMakeLists.txt": CMAKE})["nodes"]
    return [end for node in nodes for end in node["publishers"]]


def test_a_method_template_of_a_class() -> None:
    rows = ends_of('add<std_msgs::msg::String>("a"); this->add<std_msgs::msg::String, std_msgs::msg::Int8>("b");')
    assert [(end["name"], end["type"]) for end in rows] == [
        ("/a", "std_msgs/msg/String"),
        ("/a_state", "std_msgs/msg/Bool"),
        ("/b", "std_msgs/msg/String"),
        ("/b_state", "std_msgs/msg/Int8"),
    ]


def test_what_is_no_template_parameter_stays_what_it_is() -> None:
    [node] = graph_of('using M = std_msgs::msg::String; create_publisher<M>("a", 10);')
    assert [end["type"] for end in node["publishers"]] == ["std_msgs/msg/String"]
