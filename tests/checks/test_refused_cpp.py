"""API007: C++ code that a compiler refuses."""

from __future__ import annotations

import re

import pytest

from robot_package import CMAKE, TALKER_OF_CPP

SOURCE = """\
#include <rclcpp/rclcpp.hpp>

using namespace std::chrono_literals;
using std::placeholders::_1;
using std::placeholders::_2;
using Twist = geometry_msgs::msg::Twist;

class Talker : public rclcpp::Node
{{
public:
  Talker() : Node("talker")
  {{
    {made}
  }}

private:
  void talk()
  {{
    {talked}
  }}
  void listen(const std_msgs::msg::String::SharedPtr message) {{ {heard} }}
  void two(const std_msgs::msg::String & message, int times) {{}}
  bool answer(std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr);

  std_msgs::msg::String last_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  {main}
}}
"""
SPUN = "rclcpp::spin(std::make_shared<Talker>());"


@pytest.fixture
def refused(findings):
    """What is found in a node of C++, as messages without their end."""

    def run(talked: str = "", *, made: str = "", heard: str = "", main: str = SPUN, **files: str) -> list[str]:
        source = SOURCE.format(made=made, talked=talked, heard=heard, main=main)
        written = {"package.xml": CMAKE, "CMakeLists.txt": TALKER_OF_CPP, "src/talker.cpp": source}
        return [re.split(": this does not|: GCC", row.message)[0] for row in findings("API007", **{**written, **files})]

    return run


TWIST = "geometry_msgs::msg::Twist twist; "


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (TWIST + "twist.linear.w = 1.0;", "geometry_msgs::msg::Vector3 has no member 'w'"),
        (TWIST + "twist.header.stamp = now();", "geometry_msgs::msg::Twist has no member 'header'"),
        ("Twist twist; twist.liner.x = 1.0;", "geometry_msgs::msg::Twist has no member 'liner'"),
        ("auto twist = Twist(); twist.liner.x = 1.0;", "geometry_msgs::msg::Twist has no member 'liner'"),
        ("auto twist = Twist{}; twist.liner.x = 1.0;", "geometry_msgs::msg::Twist has no member 'liner'"),
        ("Twist twist; auto & way = twist.linear; way.w = 1;", "geometry_msgs::msg::Vector3 has no member 'w'"),
        (
            "nav_msgs::msg::Path path; path.poses[0].position.x = 1;",
            "geometry_msgs::msg::PoseStamped has no member 'position'",
        ),
        ("nav_msgs::msg::Path path; path.poses.at(0).x = 1;", "geometry_msgs::msg::PoseStamped has no member 'x'"),
        (
            "nav_msgs::msg::Path path; for (const auto & pose : path.poses) { use(pose.position); }",
            "geometry_msgs::msg::PoseStamped has no member 'position'",
        ),
        ("std::vector<Twist> all; all[0].x = 1;", "geometry_msgs::msg::Twist has no member 'x'"),
        (
            "std_srvs::srv::Trigger::Request request; request.data = 1;",
            "std_srvs::srv::Trigger::Request has no member 'data'",
        ),
        (
            "auto answer = std::make_shared<std_srvs::srv::Trigger::Response>(); answer->sucess = true;",
            "std_srvs::srv::Trigger::Response has no member 'sucess'",
        ),
        (
            "std_msgs::msg::Header header; use(header.stamp.toSec());",
            "builtin_interfaces::msg::Time has no method 'toSec'",
        ),
        (TWIST + "use(twist.linear.x.value);", "a float64 has no member 'value'"),
        ("last_.date = 1;", "std_msgs::msg::String has no member 'date'"),
        ("this->last_.date = 1;", "std_msgs::msg::String has no member 'date'"),
        (
            "auto twist = std::make_shared<Twist>(); twist.linear.x = 1;",
            "'linear' is asked of a pointer to a message with a '.'",
        ),
        (TWIST + "twist->linear.x = 1;", "'linear' is asked of a message with '->', and it is no pointer"),
        ("auto f = [](const Twist & twist) { use(twist.liner); };", "geometry_msgs::msg::Twist has no member 'liner'"),
        ("publisher_.publish(last_);", "'publish' is asked of the pointer 'publisher_' with a '.'"),
        (
            TWIST + "publisher_->publish(twist);",
            "a publisher of std_msgs::msg::String is given geometry_msgs::msg::Twist",
        ),
        ("std::string text; RCLCPP_INFO(get_logger(), text);", "RCLCPP_INFO() is given a std::string for its format"),
        (
            'std::string text; RCLCPP_WARN(get_logger(), ("at " + text));',
            "RCLCPP_WARN() is given a std::string for its format",
        ),
        ("RCLCPP_INFO(get_logger(), std::to_string(3));", "RCLCPP_INFO() is given a std::string for its format"),
        (
            "std::stringstream text; RCLCPP_INFO(get_logger(), text.str());",
            "RCLCPP_INFO() is given a std::string for its format",
        ),
        (
            "RCLCPP_INFO(get_logger(), last_.data);",
            "a logging macro is given the text 'data' of a message for its format",
        ),
        ('RCLCPP_INFO("ready");', "RCLCPP_INFO() lacks its first argument, a logger"),
        ('RCLCPP_INFO_STREAM("at " << 3);', "RCLCPP_INFO_STREAM() lacks its first argument, a logger"),
        ('RCLCPP_INFO_THROTTLE(get_logger(), 0.5, "at");', "RCLCPP_INFO_THROTTLE() lacks the clock behind its logger"),
        (
            'RCLCPP_ERROR_STREAM_THROTTLE(get_logger(), this->get_clock(), 500, "at");',
            "RCLCPP_ERROR_STREAM_THROTTLE() is given a pointer to a clock, and takes the clock",
        ),
        (
            'double rate = get_parameter("rate");',
            "get_parameter() gives an rclcpp::Parameter, and 'rate' is of the type double",
        ),
        (
            'std::string text; RCLCPP_INFO(get_logger(), "%s", text);',
            "RCLCPP_INFO() is given the std::string text as it is",
        ),
        (
            'RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 500, "%s", last_.data);',
            "a logging macro is given the text 'data' of a message as it is",
        ),
        (
            "rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client; "
            "auto answer = client->async_send_request(request); use(answer.get()->sucess);",
            "std_srvs::srv::Trigger::Response has no member 'sucess'",
        ),
        (
            "auto f = [](rclcpp::Client<std_srvs::srv::Trigger>::SharedFuture answer) { use(answer.get()->sucess); };",
            "std_srvs::srv::Trigger::Response has no member 'sucess'",
        ),
        (
            "std::shared_ptr<rclcpp_action::ServerGoalHandle<example_interfaces::action::Fibonacci>> handle; "
            "use(handle->get_goal()->steps);",
            "example_interfaces::action::Fibonacci::Goal has no member 'steps'",
        ),
        (
            "rclcpp_action::ClientGoalHandle<example_interfaces::action::Fibonacci>::WrappedResult result; "
            "use(result.code, result.result->order);",
            "example_interfaces::action::Fibonacci::Result has no member 'order'",
        ),
        (
            "rclcpp::Publisher<std_msgs::msg::String>::SharePtr publisher;",
            "rclcpp::Publisher has no 'SharePtr'",
        ),
        ("std_msgs::msg::String::SharedPointer text;", "std_msgs::msg::String has no 'SharedPointer'"),
    ],
)
def test_in_a_method(refused, line, message):
    assert refused(line) == [message]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            'publisher_ = create_publisher<std_msgs::msg::String>("a");',
            "create_publisher() lacks an argument: it takes a topic and a QoS",
        ),
        (
            'sub_ = create_subscription<std_msgs::msg::String>("a", std::bind(&Talker::listen, this, _1));',
            "create_subscription() is given its callback where the QoS belongs",
        ),
        ('service_ = create_service<std_srvs::srv::Trigger>("a");', "create_service() is given no callback"),
        (
            "timer_ = create_wall_timer(0.5, std::bind(&Talker::talk, this));",
            "create_wall_timer() is given the number 0.5 for its period",
        ),
        (
            "double rate = 1; timer_ = create_wall_timer(rate, [this]() {});",
            "create_wall_timer() is given the number rate for its period",
        ),
        (
            "timer_ = create_wall_timer(1s, [this](int a, int b) {});",
            "create_wall_timer() is given a callback with 2 parameters",
        ),
        (
            'sub_ = create_subscription<std_msgs::msg::String>("a", 1, []() {});',
            "create_subscription() is given a callback with 0 parameters",
        ),
        ("run(std::bind(&Talker::lisen, this, _1));", "class 'Talker' has no method 'lisen'"),
        (
            "run(std::bind(&Talker::listen, this));",
            "std::bind() gives 'listen' no arguments besides the object, and it takes 1",
        ),
        (
            "run(std::bind(&Talker::talk, this, _1));",
            "std::bind() gives 'talk' one argument besides the object, and it takes 0",
        ),
        (
            'sub_ = create_subscription<Twist>("a", 1, std::bind(&Talker::listen, this, _1));',
            "the callback takes std_msgs::msg::String, and is called with geometry_msgs::msg::Twist",
        ),
        (
            'sub_ = this->create_subscription<Twist>("a", 1, [](std_msgs::msg::String::UniquePtr m) {});',
            "the callback takes std_msgs::msg::String, and is called with geometry_msgs::msg::Twist",
        ),
        (
            'publisher_ = create_publisher<Twist>("a", 1);',
            "what is made for geometry_msgs::msg::Twist is kept in a pointer for std_msgs::msg::String",
        ),
    ],
)
def test_in_a_constructor(refused, line, message):
    assert refused(made=line) == [message]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("Talker talker; rclcpp::spin(talker);", "spin() is given 'talker', and takes a shared pointer to a node"),
        ("Talker talker; rclcpp::spin(&talker);", "spin() is given '&talker', and takes a shared pointer to a node"),
        (
            "auto node = std::make_shared<Talker>(); rclcpp::spin_some(*node);",
            "spin_some() is given '*node', and takes a shared pointer to a node",
        ),
        (
            "auto node = std::make_unique<Talker>(); rclcpp::spin(node);",
            "spin() is given a std::unique_ptr, and takes a shared pointer",
        ),
        (
            'auto node = std::make_shared<rclcpp_lifecycle::LifecycleNode>("a"); rclcpp::spin(node);',
            "spin() takes no shared pointer to a LifecycleNode",
        ),
        ('rclcpp::Node node("a"); rclcpp::spin(node);', "spin() is given 'node', and takes a shared pointer to a node"),
    ],
)
def test_what_is_spun(refused, line, message):
    assert refused(main=line) == [message]


def test_spinning_this(refused):
    assert refused("rclcpp::spin(this);") == ["spin() is given 'this', and takes a shared pointer to a node"]


@pytest.mark.parametrize(
    "line",
    [
        TWIST + 'twist.linear.x = 1.0; last_.data = "a"; last_.set__data("b");',
        "last_.data.size(); use(last_.data[0], last_.data.c_str());",
        "auto twist = std::make_shared<Twist>(); twist->linear.x = 1; twist.reset(); use(twist.get()->linear);",
        "auto path = nav_msgs::msg::Path(); path.poses.push_back(pose); use(path.poses.back().pose);",
        "for (auto & [name, pose] : poses) { use(pose.anything); }",
        "auto twist = make_twist(); use(twist.anything);",
        TWIST + "{ Other twist; twist.anything = 1; }",
        TWIST + "auto f = [twist = other()]() { use(twist.anything); };",
        TWIST + "for (const auto & twist : others) { use(twist.anything); }",
        "#if FOXY\n    last_.anything = 1;\n#endif",
        "auto header = last_.data; use(header.anything);",
        'RCLCPP_INFO(get_logger(), "%s", last_.data.c_str()); RCLCPP_INFO(get_logger(), "a");',
        'const char * text = "a"; RCLCPP_INFO(get_logger(), text);',
        "std::string text; RCLCPP_INFO(get_logger(), text.c_str()); RCLCPP_INFO_STREAM(get_logger(), text << 1);",
        'std::string text; RCLCPP_INFO_EXPRESSION(get_logger(), text == "a", "b");',
        'RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 500, "at"); RCLCPP_INFO_THROTTLE(log_, clock_, 1, "a");',
        "publisher_->publish(last_); publisher_.reset(); use(publisher_.get());",
        'double rate = get_parameter("rate").as_double(); bool there = get_parameter("rate", rate);',
        'auto rate = get_parameter("rate"); rclcpp::Parameter other = get_parameter("rate");',
        "rclcpp::spin(shared_from_this()); rclcpp::spin(get_node_base_interface());",
        'RCLCPP_INFO(get_logger(), "%s %d", last_.data.c_str(), count_);',
        "rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client; auto answer = client->async_send_request(request);"
        " answer.wait(); use(answer.get()->success);",
        "std_msgs::msg::String::ConstSharedPtr text; std_msgs::msg::String::UniquePtr other;",
        "rclcpp_action::Client<example_interfaces::action::Fibonacci>::SharedPtr client; use(client->anything);",
    ],
)
def test_what_compiles_in_a_method(refused, line):
    assert refused(line) == []


@pytest.mark.parametrize(
    "line",
    [
        'publisher_ = create_publisher<std_msgs::msg::String>("a", 10);',
        'sub_ = create_subscription<std_msgs::msg::String>("a", 10, std::bind(&Talker::listen, this, _1));',
        'sub_ = create_subscription<std_msgs::msg::String>("a", qos(), [this](std_msgs::msg::String m) {});',
        'sub_ = create_subscription<Adapted>("a", 10, [this](const std_msgs::msg::String & m) {});',
        'sub_ = create_subscription<Twist>("a", 10, [this](std::shared_ptr<rclcpp::SerializedMessage> m) {});',
        'service_ = create_service<std_srvs::srv::Trigger>("a", std::bind(&Talker::answer, this, _1, _2));',
        "timer_ = create_wall_timer(500ms, [this]() {}); timer_ = create_wall_timer(period, [this]() {});",
        "timer_ = create_wall_timer(std::chrono::duration<double>(0.5), std::bind(&Talker::talk, this));",
        'other_->create_publisher<std_msgs::msg::String>("a"); run(std::bind(&Other::lisen, this, _1));',
        "run(std::bind(&Talker::two, this, _1, 3)); run(std::bind(&Talker::get_name, other, _1));",
    ],
)
def test_what_compiles_in_a_constructor(refused, line):
    assert refused(made=line) == []


def test_a_method_of_its_own_name_takes_what_it_likes(refused):
    own = SOURCE.replace("private:", "template <typename T> auto create_publisher(const std::string & name);\nprivate:")
    source = own.format(made='publisher_ = create_publisher<Twist>("a");', talked="", heard="", main=SPUN)
    assert refused(**{"src/talker.cpp": source}) == []


def test_a_class_with_another_base_may_have_more(refused):
    source = SOURCE.replace("public rclcpp::Node", "public Base").format(
        made='create_publisher<Twist>("a"); run(std::bind(&Talker::lisen, this, _1));', talked="", heard="", main=""
    )
    assert refused(**{"src/talker.cpp": source}) == []


INCLUDES = '#include "ear.hpp"\n#include <rclcpp/rclcpp.hpp>\n'


def test_a_field_of_a_class_in_a_header(refused):
    header = "#include <rclcpp/rclcpp.hpp>\nclass Ear { void hear(); std_msgs::msg::String::SharedPtr last_; };\n"
    source = INCLUDES + "void Ear::hear() { use(last_->date, last_->data, other_->date); }\nint main() {}\n"
    found = refused(**{"src/ear.hpp": header, "src/talker.cpp": source})
    assert found == ["std_msgs::msg::String has no member 'date'"]


def test_an_interface_of_the_workspace(refused):
    files = {
        "CMakeLists.txt": TALKER_OF_CPP.replace(
            "add_exe", "rosidl_generate_interfaces(${PROJECT_NAME} msg/Speed.msg)\nadd_exe"
        ),
        "msg/Speed.msg": "float64 value\nstd_msgs/Header header\n",
    }
    line = 'robot::msg::Speed speed; speed.value = 1; speed.header.frame_id = "a"; speed.velocity = 1;'
    assert refused(line, **files) == ["robot::msg::Speed has no member 'velocity'"]


def test_what_nothing_builds_may_say_what_it_likes(refused):
    assert refused("last_.date = 1;", **{"CMakeLists.txt": "project(robot)\nament_package()\n"}) == []


def test_foxy_took_a_string_for_a_format(refused):
    line = "std::string text; RCLCPP_INFO(get_logger(), text);"
    assert refused(line) != []
    assert refused(line, **{"Dockerfile": "FROM ros:foxy\n"}) == []


@pytest.mark.parametrize(
    ("header", "message"),
    [
        ("std_msgs/msg/String.hpp", "<std_msgs/msg/String.hpp> is a header that its package does not have"),
        (
            "arm_msgs/msg/StringStamped.hpp",
            "<arm_msgs/msg/StringStamped.hpp> is a header that its package does not have",
        ),
        ("std_msgs/msg/strin.hpp", "<std_msgs/msg/strin.hpp> is a header that its package does not have"),
        ("std_msgs/String.h", "<std_msgs/String.h> is one of ROS 1"),
        ("std_srvs/Trigger.h", "<std_srvs/Trigger.h> is one of ROS 1"),
        ("ros/ros.h", "<ros/ros.h> is one of ROS 1"),
    ],
)
def test_a_header_that_nobody_makes(refused, header, message):
    source = f"#include <{header}>\n{SOURCE.format(made='', talked='', heard='', main=SPUN)}"
    assert refused(**{"src/talker.cpp": source}) == [message]


@pytest.mark.parametrize(
    "header",
    [
        "std_msgs/msg/string.hpp",
        "std_srvs/srv/trigger.hpp",
        "std_msgs/msg/detail/string__struct.hpp",
        "std_msgs/msg/string__struct.hpp",
        "sensor_msgs/image_encodings.hpp",
        "arm_msgs/msg/speed.hpp",
        "robot/msg/Types.hpp",
        "arm/Solver.h",
    ],
)
def test_a_header_that_somebody_makes(refused, header):
    source = f"#include <{header}>\n{SOURCE.format(made='', talked='', heard='', main=SPUN)}"
    assert refused(**{"src/talker.cpp": source, "include/robot/msg/Types.hpp": "#include <rclcpp/rclcpp.hpp>\n"}) == []


def test_a_header_behind_a_condition(refused):
    source = f"#ifdef ROS1\n#include <ros/ros.h>\n#endif\n{SOURCE.format(made='', talked='', heard='', main=SPUN)}"
    assert refused(**{"src/talker.cpp": source}) == []


def test_a_bridge_has_the_headers_of_ros_1(refused):
    source = f"#include <ros/ros.h>\n{SOURCE.format(made='', talked='', heard='', main=SPUN)}"
    build = TALKER_OF_CPP.replace("add_exe", "include(cmake/find_ros1_package.cmake)\nadd_exe")
    files = {"src/talker.cpp": source, "CMakeLists.txt": build, "cmake/find_ros1_package.cmake": ""}
    assert refused(**files) == []


def test_a_node_without_a_name(refused):
    source = SOURCE.replace(' : Node("talker")', " : last_(), publisher_(nullptr)").format(
        made="", talked="", heard="", main=SPUN
    )
    assert refused(**{"src/talker.cpp": source}) == ["the constructor of 'Talker' gives rclcpp::Node no name"]
    plain = SOURCE.replace(' : Node("talker")', "").format(made="", talked="", heard="", main=SPUN)
    assert refused(**{"src/talker.cpp": plain}) == ["the constructor of 'Talker' gives rclcpp::Node no name"]


@pytest.mark.parametrize("base", ['rclcpp::Node("a")', "Talker(1)", "Base(1)"])
def test_a_node_that_gets_its_name(refused, base):
    source = SOURCE.replace('Node("talker")', base).format(made="", talked="", heard="", main=SPUN)
    assert refused(**{"src/talker.cpp": source}) == []


OPENED = "using namespace std::chrono_literals;\nusing std::placeholders::_1;\nusing std::placeholders::_2;\n"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("timer_ = create_wall_timer(500ms, [this]() {});", "nothing says what the unit in '500ms' is"),
        ("run(std::bind(&Talker::listen, this, _1));", "nothing says what '_1' is"),
    ],
)
def test_names_that_nothing_opens(refused, line, message):
    source = SOURCE.format(made=line, talked="", heard="", main=SPUN)
    bare = source.replace(OPENED, "")
    assert refused(**{"src/talker.cpp": bare}) == [message]
    assert refused(**{"src/talker.cpp": source}) == []
    assert refused(**{"src/talker.cpp": bare.replace("using Twist", "using namespace std;\nusing Twist")}) in (
        [],
        [message],
    )
    own = {
        "src/talker.hpp": f"#include <rclcpp/rclcpp.hpp>\n{OPENED}",
        "src/talker.cpp": f'#include "talker.hpp"\n{bare}',
    }
    assert refused(**own) == []
    assert refused(**{"src/talker.cpp": f"#include <acme/all.hpp>\n{bare}"}) == []
