"""A C++ source is lowered to what the same node is with rclpy."""

from __future__ import annotations

from textwrap import dedent

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.syntax.cpp.in_python import in_python

from archlint.syntax import facts
from archlint.syntax.cpp.lowering import lower


def in_a_method(statement: str) -> str:
    """What a statement inside a method of a node is lowered to."""
    lines = in_python(f"void Talker::start() {{ {statement} }}").splitlines()
    assert lines[0] == "def Talker::start(self):"
    assert lines[-1] == "Talker.start = Talker::start"
    return "\n".join(line.removeprefix("    ") for line in lines[1:-1])


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("turn(-0.1);", "?turn(-0.1)"),
        ("turn(-5);", "?turn(-5)"),
        ("turn(+2);", "?turn(2)"),
        ("turn(-2.5f, -0x10, -1'000);", "?turn(-2.5, -16, -1000)"),
        ("turn(2 -1);", "?turn(2 - 1)"),
    ],
)
def test_a_number_with_a_sign(written: str, expected: str) -> None:
    assert in_a_method(written) == expected


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        (
            'create_publisher<std_msgs::msg::String>("chatter", 10);',
            "self.create_publisher(msg_type=std_msgs::msg::String, topic='chatter', qos_profile=10)",
        ),
        (
            'sub_ = this->create_subscription<std_msgs::msg::Bool>("a" "b", qos, std::bind(&Talker::on, this, _1));',
            "?sub_ = self.create_subscription(msg_type=std_msgs::msg::Bool, topic='ab', qos_profile=?qos, "
            "callback=self.on)",
        ),
        (
            'node_->create_service<std_srvs::srv::Trigger>("~/go", std::bind(&Talker::go, this, _1, _2));',
            "?node_.create_service(srv_type=std_srvs::srv::Trigger, srv_name='~/go', callback=self.go)",
        ),
        (
            "timer_ = create_wall_timer(std::chrono::milliseconds(500), std::bind(&Talker::tick, this));",
            "?timer_ = self.create_timer(timer_period_sec=0.5, callback=self.tick)",
        ),
        ("t_ = std::thread(&Talker::run, this);", "?t_ = std.thread(self.run)"),
        ("t_ = new std::thread(run, 5);", "?t_ = std.thread(functools.partial(?run, 5))"),
        (
            "t_ = std::make_unique<std::thread>(&Talker::run, this, 5);",
            "?t_ = std.thread(functools.partial(self.run, 5))",
        ),
        (
            "create_wall_timer(std::chrono::milliseconds{500}, f);",
            "self.create_timer(timer_period_sec=0.5, callback=?f)",
        ),
        (
            "create_wall_timer(std::chrono::duration<double, std::milli>(20), f);",
            "self.create_timer(timer_period_sec=0.02, callback=?f)",
        ),
        (
            "create_wall_timer(std::chrono::duration<int, std::ratio<1, 30>>(1), f);",
            "self.create_timer(timer_period_sec=<a duration>, callback=?f)",
        ),
        (
            "rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(0.1), f);",
            "self.create_timer(timer_period_sec=0.1, callback=?f)",
        ),
        (
            'rclcpp::create_publisher<std_msgs::msg::Bool>(parameters_, topics_, "a", 1);',
            "?topics_.create_publisher(msg_type=std_msgs::msg::Bool, topic='a', qos_profile=1)",
        ),
        (
            "rclcpp::create_client<std_srvs::srv::Trigger>(get_node_base_interface(), get_node_graph_interface(), "
            'get_node_services_interface(), "go", rclcpp::ServicesQoS(), group_);',
            "self.create_client(srv_type=std_srvs::srv::Trigger, srv_name='go', qos_profile=rclcpp.ServicesQoS(), "
            "callback_group=?group_)",
        ),
        (
            "rclcpp::create_publisher<std_msgs::msg::Bool>(node_, topic_, qos_);",
            "?node_.create_publisher(msg_type=std_msgs::msg::Bool, topic=?topic_, qos_profile=?qos_)",
        ),
        ("rclcpp::create_timer(this, get_clock(), 100ms, f);", "self.create_timer(timer_period_sec=0.1, callback=?f)"),
        (
            'rclcpp_action::create_client<nav2_msgs::action::Spin>(shared_from_this(), "spin");',
            "rclcpp_action::create_client(node=self, action_type=nav2_msgs::action::Spin, action_name='spin')",
        ),
        (
            "s_ = std::make_shared<message_filters::Subscriber<sensor_msgs::msg::Imu>>(this, t);",
            "?s_ = message_filters::Subscriber(node=self, topic=?t, msg_type=sensor_msgs::msg::Imu)",
        ),
    ],
)
def test_what_creates_an_endpoint_has_the_arguments_of_rclpy(written: str, expected: str) -> None:
    assert in_a_method(written) == expected


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ('auto t = declare_parameter<std::string>("t", "x");', "t = self.declare_parameter('t', 'x').value"),
        ('declare_parameter<double>("rate", 10);', "self.declare_parameter('rate', 10.0).value"),
        ('declare_parameter<bool>("on", 0);', "self.declare_parameter('on', False).value"),
        ('declare_parameter<double>("rate", {10});', "self.declare_parameter('rate', 10.0).value"),
        ('declare_parameter<std::string>("t", {"x"});', "self.declare_parameter('t', 'x').value"),
        (
            'auto t = get_parameter_or<std::string>("t", {"x"});',
            "t = self.get_parameter_or('t', rclcpp::Parameter(name='t', value='x')).value",
        ),
        ('declare_parameter<std::string>("t", {});', "self.declare_parameter('t', <a value>).value"),
        ('declare_parameter<std::vector<std::string>>("t", {"x"});', "self.declare_parameter('t', ['x']).value"),
        ('declare_parameter<std::vector<double>>("t", {0, 1});', "self.declare_parameter('t', [0.0, 1.0]).value"),
        ('declare_parameter<std::vector< float >>("t", {0});', "self.declare_parameter('t', [0.0]).value"),
        ('declare_parameter<std::vector<int64_t>>("t", {0});', "self.declare_parameter('t', [0]).value"),
        ('declare_parameter("t", std::vector<double>{0, 1});', "self.declare_parameter('t', [0.0, 1.0]).value"),
        ('declare_parameter("t", std::vector<int>{0, 1});', "self.declare_parameter('t', [0, 1]).value"),
        ('declare_parameter<int>("n");', "self.declare_parameter('n', rclcpp::Parameter.Type.INTEGER).value"),
        ('auto t = get_parameter("t").as_string();', "t = self.get_parameter('t').value"),
        ('auto t = get_parameter("t").get_value<std::string>();', "t = self.get_parameter('t').value"),
        ('this->get_parameter("t", topic_);', "?topic_ = self.get_parameter('t').value"),
        (
            'get_parameter_or("t", topic_, std::string("x"));',
            "?topic_ = self.get_parameter_or('t', rclcpp::Parameter(name='t', value='x')).value",
        ),
    ],
)
def test_parameters_are_declared_and_read_by_value(written: str, expected: str) -> None:
    assert in_a_method(written) == expected


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ('std::string name = "a"; name += "/b";', "name = 'a'\nname += '/b'"),
        ('auto s = prefix_ + "/" + std::to_string(3);', "s = ?prefix_ + '/' + str(3)"),
        ('auto s = fmt::format("{}/x", ns_);', "s = '{}/x'.format(?ns_)"),
        ('std::stringstream ss; ss << "a" << n_; auto s = ss.str();', "ss = ''\nss += a{?n_}\ns = ss"),
        (
            "std::stringstream ss; (ss << ... << n_); auto s = ss.str();",
            "ss = ''\nss = <a text that is changed in place>\ns = ss",
        ),
        ('std::string s = ""; s.push_back(n_);', "s = ''\ns += ?n_"),
        ('std::string s = "a"; s.size();', "s = 'a'\nlen(s)"),
        ("for (int i = 0; i < 3; ++i) { go(i); }", "for i in range(0, 3):\n    ?go(i)"),
        ("for (size_t i{1}; i < 3; ++i) { go(i); }", "for i in range(1, 3):\n    ?go(i)"),
        ('for (const auto & n : {"a", "b"}) { go(n); }', "for n in ['a', 'b']:\n    ?go(n)"),
        ('names_.push_back("a");', "?names_.append('a')"),
        ("if (auto p = find()) { p->go(); }", "p = ?find()\nif p:\n    p.go()"),
        ("switch (m) { case 1: a(); break; default: b(); }", "if ?m == 1:\n    ?a()\nelse:\n    ?b()"),
        ("auto p = std::make_unique<Arm>(2); p->move();", "p = ?Arm(2)\np.move()"),
        ("rclcpp::Rate rate(hz_);", "rate = rclcpp.Rate(?hz_)"),
        ('std::map<std::string, int> m{{"a", 1}};', "m = {'a': 1}"),
        ('RCLCPP_INFO(get_logger(), "%s", x());', ""),
    ],
)
def test_ordinary_code(written: str, expected: str) -> None:
    assert in_a_method(written) == expected


def test_a_class_with_its_fields_and_constructor() -> None:
    source = """
        namespace demo {
        class Talker : public rclcpp::Node {
        public:
          explicit Talker(const rclcpp::NodeOptions & options) : Node("talker", options), count_(0) {}
        private:
          std::string prefix_{"robot"};
          rclcpp::TimerBase::SharedPtr timer_;
          std::vector<std::string> names_;
          size_t count_;
        };
        }
    """
    assert in_python(source) == dedent("""\
        class Talker(rclcpp::Node):
            def __init__(self, options):
                Talker.__fields__(self)
                ?Node.__init__(self, node_name='talker', rclcpp_options=options)
                self.count_ = 0
            def __fields__(self):
                self.prefix_ = 'robot'
                self.timer_ = None
                self.names_ = []
                self.count_ = <a variable without a value>
            def __bases__(self):
                rclcpp::Node.__init__(self)
        demo::Talker = Talker""")


@pytest.mark.parametrize(
    ("member", "value"),
    [
        ("Helper helper_;", "?Helper(self)"),
        ("Helper<rclcpp::Node> helper_;", "?Helper(self, <0>=rclcpp::Node)"),
        ("Helper * helper_;", "std.__member__(self, 'helper_', self)"),
        ("", "std.__member__(self, 'helper_', self)"),
    ],
)
def test_a_member_that_is_given_its_node_is_another_object(member: str, value: str) -> None:
    source = f'class Arm : public rclcpp::Node {{\npublic:\n  Arm() : Node("arm"), helper_(this) {{}}\n  {member}\n}};'
    assert f"        self.helper_ = {value}\n" in in_python(source)


def test_a_constructor_outside_of_its_class_makes_the_bases_that_it_does_not_name() -> None:
    assert in_python('Arm::Arm() : name_("arm") {}') == dedent("""\
        def Arm::Arm(self):
            Arm.__fields__(self)
            Arm.__bases__(self)
            self.name_ = 'arm'
        Arm.__init__ = Arm::Arm""")


def test_a_lambda_is_a_function_in_front_of_the_statement() -> None:
    written = "int n = 0; timer_ = create_wall_timer(1s, [this, &n]() { n = 1; go(); });"
    assert in_a_method(written) == dedent("""\
        n = 0
        def lambda_1_66():
            nonlocal n
            n = 1
            ?go()
        ?timer_ = self.create_timer(timer_period_sec=1.0, callback=lambda_1_66)""")


def test_main_is_what_a_main_guard_calls() -> None:
    source = "int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Talker>()); }"
    assert in_python(source) == dedent("""\
        def main(argc=<the command line>, argv=<the command line>):
            rclcpp::init(args=[] if argc == 0 else None)
            rclcpp::spin(Talker())
        if __name__ == '__main__':
            main()""")


@pytest.mark.parametrize(
    "names",
    [
        "using std_msgs::msg::String;",
        "using String = std_msgs::msg::String;",
        "typedef std_msgs::msg::String String;",
        "namespace m = std_msgs::msg; using String = m::String;",
    ],
)
def test_names_of_types_lead_to_the_interface(names: str) -> None:
    body = lower(f'{names} void f(rclcpp::Node * n) {{ n->create_publisher<String>("a", 1); }}'.encode()).body
    [imported] = [row for row in body if isinstance(row, facts.ImportFrom) and row.module == "std_msgs.msg"]
    assert imported.names == [("String", "std_msgs::msg::String")]
    assert "n.create_publisher(msg_type=std_msgs::msg::String" in in_python(
        f'{names} void f(rclcpp::Node * n) {{ n->create_publisher<String>("a", 1); }}'
    )


def test_a_guard_is_no_condition_and_another_one_is() -> None:
    source = '#ifndef A_HPP_\n#define A_HPP_\nconst char * a = "a";\n#ifdef B\nconst char * b = "b";\n#endif\n#endif\n'
    assert in_python(source) == "a = 'a'\nif <a condition of the preprocessor>:\n    b = 'b'"


def test_macros_of_a_library_hide_nothing() -> None:
    source = "class DEMO_PUBLIC Talker : public rclcpp::Node {\n  RCLCPP_SMART_PTR_DEFINITIONS(Talker)\n};"
    assert in_python(source).startswith("class Talker(rclcpp::Node):")


def test_spans_count_characters() -> None:
    [statement] = lower('const char * a = "ä"; '.encode() + b'const char * b = "b";').body[1:]
    assert statement.span == (1, 23, 1, 44)  # type: ignore[union-attr]


def test_a_suppression_covers_its_statement() -> None:
    source = """
        void f() {
          // archlint: ignore[NME001] a fixed name
          g(
            1);
          h();  // archlint: ignore[TOP001]
        }
    """
    rows = lower(dedent(source).lstrip().encode()).suppressions
    assert [(row.codes, row.applies_to, row.reason) for row in rows] == [
        (["NME001"], (3, 4), True),
        (["TOP001"], (5, 5), False),
    ]


PIECES = st.sampled_from(
    [
        *(
            "class A : public rclcpp::Node {",
            "};",
            "}",
            "{",
            "(",
            ")",
            ";",
            '"x',
            '"',
            "[this]",
            "<",
            ">",
            "::",
            "if",
            "for",
        ),
        *(
            "create_publisher<",
            "std_msgs::msg::String>(",
            "template<typename T>",
            "#if X\n",
            "#endif\n",
            "switch (a) {",
        ),
        *(
            "case 1:",
            "auto [a, b] = c;",
            "A::A() : B(1), c{2} {",
            "using a = ",
            "enum E { A, B = ",
            "\xff",
            "\x00",
            "//",
        ),
    ]
)


@settings(max_examples=150, deadline=None)
@given(st.lists(PIECES, max_size=30))
def test_whatever_is_written_it_is_lowered(pieces: list[str]) -> None:
    lower(" ".join(pieces).encode("latin-1"))


def test_deep_nesting_ends() -> None:
    assert lower(b"int f() { return " + b"(" * 3_000 + b"1" + b")" * 3_000 + b"; }").version
    assert lower(b"void f() {" + b"{" * 3_000 + b"}" * 3_000 + b"}").version


@pytest.mark.parametrize(
    "names",
    [
        "using A = B::A; using B = A::B;",
        "using A = B; using B = A;",
        "using Base::Base;",
        "namespace a = b; namespace b = a;",
    ],
)
def test_names_that_stand_for_each_other_end(names: str) -> None:
    assert in_python(f"{names} void f(A x) {{ A y; B z(1); g(Base::h); }}")


def test_constructors_of_a_base_are_no_alias_of_it() -> None:
    source = 'class Left : public Arm { using Arm::Arm; void go() { Arm::go("left"); } };'
    assert "Arm.go(std.__itself__(self, ?Arm), 'left')" in in_python(source)


def test_a_column_counts_characters_where_the_line_is_utf_8_and_bytes_where_it_is_not() -> None:
    rows = lower('const char * a = "ä"; int b = 1;\n'.encode() + 'const char * a = "ä"; int b = 1;'.encode("latin-1"))
    assert [row.span[:2] for row in rows.body if isinstance(row, facts.Assign)] == [(1, 1), (1, 23), (2, 1), (2, 23)]


def test_a_suppression_above_another_comment_covers_the_next_statement() -> None:
    source = "void f() {\n  // archlint: ignore[TOP001] why\n  // and more\n  g();\n}\n"
    [row] = lower(source.encode()).suppressions
    assert row.applies_to == (4, 4)


def test_only_the_variable_of_a_loop_is_a_pair() -> None:
    loop = in_a_method("for (auto & row : rows_) use(row.second, other.first);")
    assert loop == "for row in std.pairs(?rows_):\n    ?use(row[1], ?other.first)"
    assert in_a_method("for (auto & row : rows_) use(row.third);") == "for row in ?rows_:\n    ?use(row.third)"


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ('s.append("more");', "s += 'more'"),
        ("s.append(3, x);", "s.append(3, ?x)"),
        ('s.insert(0, "/");', "s.insert(0, '/')"),
        ('snprintf(buffer, sizeof(buffer), "cam_%zu", n);', "?buffer = 'cam_%u' % [?n]"),
        ('std::sprintf(buffer, "camera");', "?buffer = 'camera'"),
        ("snprintf(buffer, 3);", "?snprintf(?buffer, 3)"),
    ],
)
def test_texts_that_are_written_in_place(statement: str, expected: str) -> None:
    written = in_a_method(f'std::string s = "a"; {statement}')
    assert written.removeprefix("s = 'a'\n") == expected


@pytest.mark.parametrize(
    ("loop", "expected"),
    [
        ("for (auto it = names_.begin(); it != names_.end(); ++it) use(*it);", "for it in ?names_:\n    ?use(it)"),
        (
            "for (auto it = map->cbegin(); it != map->cend(); it++) use(it->second);",
            "for it in std.pairs(?map):\n    ?use(it[1])",
        ),
    ],
)
def test_an_iterator_is_what_it_points_to(loop: str, expected: str) -> None:
    assert in_a_method(loop) == expected


def test_a_loop_to_the_end_of_another_container_is_none_over_the_first() -> None:
    assert "in ?a_:" not in in_a_method("for (auto it = a_.begin(); it != b_.end(); ++it) use(*it);")


def test_a_member_is_made_with_what_its_class_elsewhere_takes() -> None:
    source = 'Robot::Robot() : Node("robot"), image_(this, "image"), helper_(this), rate_(10) {}'
    lines = in_python(source).splitlines()
    assert "    self.image_ = std.__member__(self, 'image_', self, 'image')" in lines
    assert "    self.helper_ = std.__member__(self, 'helper_', self)" in lines
    assert "    self.rate_ = 10" in lines


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ("Limits l = {.low = go(1), .high = go(2)};", "l = ?Limits(low=?go(1), high=?go(2))"),
        ("use({.low = go(1)});", "?use([?go(1)])"),
        ("go(1), go(2);", "?go(1)\n?go(2)"),
        (
            'if (getInput("node", node_)) go(1);',
            "?node_ = <a port of a behaviour tree>\nif <whether the port has a value>:\n    ?go(1)",
        ),
        ("co_await go(1);", "?go(1)"),
        ("if (x) [[likely]] { go(1); }", "if ?x:\n    ?go(1)"),
    ],
)
def test_a_call_stays_a_call_wherever_it_stands(statement: str, expected: str) -> None:
    assert in_a_method(statement) == expected


def test_a_profile_of_rmw_that_is_written_out() -> None:
    policies = "RMW_QOS_POLICY_HISTORY_KEEP_LAST, 5, RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, durability, false"
    assert in_a_method(f"rmw_qos_profile_t p = {{{policies}}};") == (
        "p = rclcpp.QoS(5).with_history(RMW_QOS_POLICY_HISTORY_KEEP_LAST)"
        ".with_reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT).with_durability(?durability)"
    )
    assert in_a_method("rmw_qos_profile_t p{rmw_qos_profile_sensor_data};") == (
        "p = copy.copy(rmw_qos_profile_sensor_data)"
    )
    assert in_a_method("rmw_qos_profile_t p{a, b};") == "p = <a profile>"


@pytest.mark.parametrize("space", ["{}", "namespace robot {{ {} }}"])
def test_a_function_whose_head_a_macro_writes_does_not_run_with_the_file(space: str) -> None:
    test_case = 'TEST_CASE("it turns", "[motor]")  // of Catch2\n{ auto node = std::make_shared<Motor>(); }'
    assert "def TEST_CASE():\n    node = Motor()" in in_python(space.format(test_case))
