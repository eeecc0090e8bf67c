"""What a header of C++ declares and another source defines, and names that several namespaces have."""

from __future__ import annotations

from typing import Any

from tests.cpp_nodes import graph

ROBOT = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "robot/names.hpp"
using String = std_msgs::msg::String;
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { %s }
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def ends(header: str, source: str, statements: str, **more: str) -> list[dict[str, Any]]:
    """What the robot publishes, in the order of its statements."""
    files = {"include/robot/names.hpp": f"#pragma once\n{header}", "src/robot.cpp": ROBOT % statements}
    if source:
        files["src/names.cpp"] = f'#include "robot/names.hpp"\n{source}'
    [node] = graph({**files, **{f"src/{name}.cpp": text for name, text in more.items()}})["nodes"]
    return sorted(node["publishers"], key=lambda end: (end["line"], end["column"]))


def names(header: str, source: str, statements: str, **more: str) -> list[str | None]:
    return [end["name"] for end in ends(header, source, statements, **more)]


def publish(*topics: str) -> str:
    return " ".join(f"create_publisher<String>({topic}, 1);" for topic in topics)


def test_a_function_is_defined_by_another_source() -> None:
    header = "std::string topic_of(const std::string & part);"
    source = 'std::string topic_of(const std::string & part) { return "arm/" + part; }'
    assert names(header, source, publish('topic_of("joint")')) == ["/arm/joint"]


def test_default_arguments_stand_in_the_declaration_alone() -> None:
    header = 'namespace arm { std::string topic_of(int number, const std::string & prefix = "left", int more = 2); }'
    source = """
    namespace arm {
    std::string topic_of(int number, const std::string & prefix, int more) {
      return prefix + std::to_string(number + more);
    }
    }
    """
    assert names(header, source, publish("arm::topic_of(1)", 'arm::topic_of(1, "right")')) == ["/left3", "/right3"]


def test_a_function_is_defined_under_the_name_of_its_namespace() -> None:
    header = "namespace arm { namespace names { std::string of(int number); } }"
    source = 'std::string arm::names::of(int number) { return number == 1 ? "first" : "other"; }'
    assert names(header, source, "namespace n = arm::names; " + publish("n::of(1)")) == ["/first"]


def test_of_functions_of_one_name_the_one_that_takes_the_arguments() -> None:
    header = "std::string of(const std::string & part); std::string of(const std::string & part, int number);"
    source = """
    std::string of(const std::string & part) { return part; }
    std::string of(const std::string & part, int number) { return part + std::to_string(number); }
    """
    assert names(header, source, publish('of("a")', 'of("b", 2)')) == ["/a", "/b2"]


def test_a_static_method_knows_the_static_members_of_its_class() -> None:
    header = "class Topics { public: static std::string joint(int number = 7); static const std::string base; };"
    source = """
    const std::string Topics::base = "base";
    std::string Topics::joint(int number) { return base + "/" + std::to_string(number); }
    """
    assert names(header, source, publish("Topics::joint(3)", "Topics::joint()")) == ["/base/3", "/base/7"]


def test_a_constructor_has_the_default_of_its_declaration() -> None:
    header = """
    class Topics {
    public:
      explicit Topics(const std::string & prefix = "first");
      std::string joint(const std::string & suffix = "end") const;
    private:
      std::string prefix_;
    };
    """
    source = """
    Topics::Topics(const std::string & prefix) : prefix_(prefix) {}
    std::string Topics::joint(const std::string & suffix) const { return prefix_ + "/" + suffix; }
    """
    made = 'Topics topics; Topics others("second"); ' + publish("topics.joint()", 'others.joint("x")')
    assert names(header, source, made) == ["/first/end", "/second/x"]


def test_variables_and_profiles_are_defined_by_another_source() -> None:
    header = """
    namespace topics { extern const char * const map; extern const std::string pose; }
    rclcpp::QoS latched(size_t depth = 4);
    """
    source = """
    namespace topics { const char * const map = "map"; }
    const std::string topics::pose = "pose";
    rclcpp::QoS latched(size_t depth) { return rclcpp::QoS(depth).transient_local(); }
    """
    first, second = ends(
        header,
        source,
        "create_publisher<String>(topics::map, latched()); create_publisher<String>(topics::pose, 1);",
    )
    assert (first["name"], first["qos"]["durability"], first["qos"]["depth"]) == ("/map", "transient_local", 4)
    assert second["name"] == "/pose"


def test_what_two_sources_define_is_not_known() -> None:
    header = "std::string topic();"
    other = '#include "robot/names.hpp"\nstd::string topic() { return "b"; }'
    assert names(header, 'std::string topic() { return "a"; }', publish("topic()"), other=other) == [None]


def test_what_nothing_here_defines_is_not_known() -> None:
    header = 'std::string topic(const std::string & prefix = "a");'
    assert names(header, "", publish("topic()")) == [None]
    assert names(header, 'std::string other() { return "a"; }', publish("topic()")) == [None]


def test_functions_of_one_name_in_two_namespaces() -> None:
    header = "namespace left { std::string topic(); } namespace right { std::string topic(); }"
    source = """
    namespace left { std::string topic() { return "left"; } }
    namespace right { std::string topic() { return "right"; } }
    """
    assert names(header, source, publish("left::topic()", "right::topic()")) == ["/left", "/right"]
    only = 'namespace right { std::string topic() { return "right"; } }'
    assert names(header, only, publish("left::topic()", "right::topic()")) == [None, "/right"]


def test_constants_of_one_name_in_two_namespaces() -> None:
    header = """
    namespace topics { constexpr char odom[] = "odometry"; constexpr char map[] = "the_map"; }
    namespace frames { constexpr char odom[] = "odom_frame"; }
    """
    assert names(header, "", publish("topics::odom", "frames::odom", "topics::map")) == [
        "/odometry",
        "/odom_frame",
        "/the_map",
    ]


def test_classes_of_one_name_in_two_namespaces() -> None:
    header = """
    namespace left {
    constexpr char topic[] = "l";
    class Relay { public: explicit Relay(rclcpp::Node * node) { node->create_publisher<String>(topic, 1); } };
    }
    namespace right {
    constexpr char topic[] = "r";
    class Relay { public: explicit Relay(rclcpp::Node * node); };
    }
    """
    source = "right::Relay::Relay(rclcpp::Node * node) { node->create_publisher<String>(topic, 1); }"
    made = "left::Relay first(this); right::Relay second(this);"
    assert sorted(map(str, names(header, source, made))) == ["/l", "/r"]


def test_a_class_that_is_called_like_its_namespace() -> None:
    """A source that only defines its methods does not say that the name is a class, too."""
    header = """
    namespace wheel {
    class wheel : public rclcpp::Node {
    public:
      wheel (const rclcpp::NodeOptions & options);
      void start();
    };
    }
    """
    source = """
    namespace wheel {
    wheel::wheel (const rclcpp::NodeOptions & options) : Node("left_wheel", options) { start(); }
    void wheel::start() { create_publisher<std_msgs::msg::String>("speed", 1); }
    }
    """
    headers = '#include "rclcpp/rclcpp.hpp"\n#include "std_msgs/msg/string.hpp"\n'
    files = {
        "include/robot/wheel.hpp": f"#pragma once\n{headers}{header}",
        "src/wheel.cpp": f'#include "robot/wheel.hpp"\n{source}',
    }
    nodes = graph(files)["nodes"]
    assert [(node["name"], [end["name"] for end in node["publishers"]]) for node in nodes] == [
        ("/left_wheel", ["/speed"])
    ]


def test_a_function_that_is_called_like_its_namespace() -> None:
    header = "namespace arm { std::string arm(int number); }"
    source = 'namespace arm { std::string arm(int number) { return number == 1 ? "first" : "other"; } }'
    assert names(header, source, publish("arm::arm(1)")) == ["/first"]


CORE = """
#include "robot/core.hpp"
Core::Core() : Node("{name}") {{ create_publisher<std_msgs::msg::String>(topic(), 1); }}
std::string Core::topic() {{ return "from_{name}"; }}
int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Core>()); }}
"""
CORE_DECLARED = """
#pragma once
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Core : public rclcpp::Node {
public:
  Core();
private:
  std::string topic();
};
"""


def test_each_program_has_the_methods_that_its_own_file_defines() -> None:
    sources = {f"src/{name}.cpp": CORE.format(name=name) for name in ("keys", "joy", "pad")}
    build = "".join(f"add_executable({name} src/{name}.cpp)\n" for name in ("keys", "joy", "pad"))
    build = f"{build}install(TARGETS keys joy pad DESTINATION lib/robot)\n"
    files = {"include/robot/core.hpp": CORE_DECLARED, "CMakeLists.txt": build, **sources}
    nodes = graph(files)["nodes"]
    ends = sorted((node["name"], [end["name"] for end in node["publishers"]], node["executables"]) for node in nodes)
    assert ends == [
        ("/joy", ["/from_joy"], ["joy"]),
        ("/keys", ["/from_keys"], ["keys"]),
        ("/pad", ["/from_pad"], ["pad"]),
    ]


MAIN = """
#include "robot/core.hpp"
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Core>()); }
"""


def test_each_program_has_the_methods_that_its_other_sources_define() -> None:
    cores = {f"src/{name}.cpp": CORE.format(name=name).partition("int main")[0] for name in ("keys", "joy", "pad")}
    cores["src/topics.cpp"] = '#include "robot/core.hpp"\nvoid Core::idle() {}\n'
    declared = CORE_DECLARED.replace("private:", "private:\n  void idle();")
    lines = [
        "add_executable(keys src/main.cpp src/keys.cpp src/topics.cpp)",
        "add_executable(joy src/joy.cpp src/topics.cpp src/main_of_joy.cpp)",
        "add_executable(pad src/main.cpp src/topics.cpp src/pad.cpp)",
        "install(TARGETS keys joy pad DESTINATION lib/robot)",
    ]
    mains = {"src/main.cpp": MAIN, "src/main_of_joy.cpp": MAIN}
    files = {"include/robot/core.hpp": declared, "CMakeLists.txt": "\n".join(lines), **cores, **mains}
    nodes = graph(files)["nodes"]
    ends = sorted((node["name"], [end["name"] for end in node["publishers"]], node["executables"]) for node in nodes)
    assert ends == [
        ("/joy", ["/from_joy"], ["joy"]),
        ("/keys", ["/from_keys"], ["keys"]),
        ("/pad", ["/from_pad"], ["pad"]),
    ]
