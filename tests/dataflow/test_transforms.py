"""Which look-ups of transforms depend on which nodes that send some."""

from __future__ import annotations

from dataflow.tracing import Traced, links_of

SENDER = """
def __init__(self):
    super().__init__("{name}")
    self.broadcaster = TransformBroadcaster(self)
    self.create_timer(0.1, self.send)

def send(self):
    transform = TransformStamped()
    transform.header.frame_id = {parent}
    transform.child_frame_id = {child}
    self.broadcaster.sendTransform(transform)
"""
USER = """
def __init__(self):
    super().__init__("user")
    self.buffer = Buffer()
    self.listener = TransformListener(self.buffer, self)
    self.pub = self.create_publisher(String, "pose", 10)
    self.create_timer(0.1, self.look)

def look(self):
    self.buffer.{call}
    self.pub.publish(String())
"""
LOOK_UP = USER.format(call='lookup_transform("map", "base", rclpy.time.Time())')


def sender(name: str, parent: str, child: str) -> str:
    """A node that sends a transform; the frames are given as code."""
    return SENDER.format(name=name, parent=parent, child=child)


def test_a_look_up_depends_on_the_transforms_between_its_frames_and_on_no_others(traced: Traced) -> None:
    traced(
        odometry=sender("odometry", '"odom"', '"base"'),
        localization=sender("localization", '"map"', '"odom"'),
        georeference=sender("georeference", '"earth"', '"map"'),
        arm=sender("arm", '"base"', '"hand"'),
        unclear=sender("unclear", "input()", "input()"),
        user=LOOK_UP,
    )
    between = {"frame base", "Odometry.send", "frame odom", "Localization.send"}
    assert traced.before("/pose") == {"User.look", *between}
    assert all(not link.doubt for link in traced.flow.links if link.tail.kind == "frame")
    assert "User.look" in traced.after("odom")
    assert "User.look" not in traced.after("hand")
    assert "User.look" not in traced.after("map")


def test_two_frames_are_joined_where_both_hang_from_a_third(traced: Traced) -> None:
    traced(
        left=sender("left", '"base"', '"camera"'),
        right=sender("right", '"base"', '"laser"'),
        odometry=sender("odometry", '"odom"', '"base"'),
        user=USER.format(call='can_transform("camera", "laser", rclpy.time.Time())'),
    )
    assert traced.before("/pose") == {"User.look", "frame camera", "Left.send", "frame laser", "Right.send"}


def test_where_a_transform_is_missing_it_may_come_from_what_sends_unknown_frames(traced: Traced) -> None:
    traced(
        odometry=sender("odometry", '"odom"', '"base"'),
        arm=sender("arm", '"base"', '"hand"'),
        unclear=sender("unclear", "input()", "input()"),
        user=LOOK_UP,
    )
    before = traced.before("/pose")
    assert {"Odometry.send", "Unclear.send"} < before
    assert "Arm.send" not in before
    [link] = links_of(traced.flow, "frame base", "User.look")
    assert link.doubt == "not every transform between 'map' and 'base' is known"


def test_a_frame_that_is_sent_with_two_parents_is_in_doubt(traced: Traced) -> None:
    traced(
        odometry=sender("odometry", '"odom"', '"base"'),
        other=sender("other", '"map"', '"base"'),
        localization=sender("localization", '"map"', '"odom"'),
        user=LOOK_UP,
    )
    assert {"Odometry.send", "Other.send", "Localization.send"} < traced.before("/pose")
    assert all(link.doubt for link in traced.flow.links if link.tail.kind == "frame")


def test_a_look_up_of_unknown_frames_may_depend_on_all_that_is_sent(traced: Traced) -> None:
    traced(
        odometry=sender("odometry", '"odom"', '"base"'),
        user=USER.format(call='lookup_transform("map", input(), rclpy.time.Time())'),
    )
    assert traced.before("/pose") == {"User.look", "topic /tf", "topic /tf_static", "Odometry.send"}
    [link] = links_of(traced.flow, "topic /tf", "User.look")
    assert link.doubt == "which frames it is about is not known"


def test_frames_come_from_constants_parameters_lists_and_loops(traced: Traced) -> None:
    traced(
        odometry="""
        def __init__(self):
            super().__init__("odometry")
            self.base = self.declare_parameter("base_frame", "base").value
            self.broadcaster = TransformBroadcaster(self)
            self.create_timer(0.1, self.send)

        def send(self):
            self.broadcaster.sendTransform([self.stamped("odom", self.base), self.stamped(parent="map", child="odom")])

        def stamped(self, parent, child):
            transform = TransformStamped(child_frame_id=child)
            transform.header = Header(frame_id=parent)
            return transform
        """,
        user="""
        def __init__(self):
            super().__init__("user")
            self.buffer = Buffer()
            self.listener = TransformListener(self.buffer, self)
            self.pub = self.create_publisher(String, "pose", 10)
            self.create_timer(0.1, self.look)

        def look(self):
            for frame in ("base", "/odom"):
                self.buffer.lookup_transform("map", frame, rclpy.time.Time())
            self.pub.publish(String())
        """,
    )
    assert traced.before("/pose") == {"User.look", "frame base", "frame odom", "Odometry.send"}


def test_what_is_transformed_is_looked_up_from_its_own_frame(traced: Traced) -> None:
    traced(
        odometry=sender("odometry", '"map"', '"base"'),
        arm=sender("arm", '"base"', '"hand"'),
        user=USER.format(call='transform(PointStamped(header=Header(frame_id="hand")), "base")'),
    )
    assert traced.before("/pose") == {"User.look", "frame hand", "Arm.send"}


def test_a_frame_has_a_trace_of_its_own(traced: Traced) -> None:
    traced(odometry=sender("odometry", '"map"', '"base"'), user=LOOK_UP)
    trace = traced.trace("base")
    assert trace.subject.kind == "frame"
    assert traced.way("base", "/odometry", "/pose") == [
        (0.1, "Odometry.send of /odometry has its turn every 0.1 s"),
        (0.1, "User.look of /user reads it every 0.1 s"),
    ]


def test_cpp_nodes_send_and_look_up_transforms(traced: Traced) -> None:
    traced.file(
        "robot.cpp",
        """
        #include <rclcpp/rclcpp.hpp>

        class Robot : public rclcpp::Node {
        public:
          Robot() : Node("robot") {
            broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>(*this);
            buffer_ = std::make_unique<tf2_ros::Buffer>(get_clock());
            listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_);
            pub_ = create_publisher<std_msgs::msg::String>("pose", 10);
            send_timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&Robot::send, this));
            look_timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&Robot::look, this));
          }

        private:
          void send() {
            geometry_msgs::msg::TransformStamped transform;
            transform.header.frame_id = "map";
            transform.child_frame_id = "base";
            broadcaster_->sendTransform(transform);
          }

          void look() {
            auto found = buffer_->lookupTransform("map", "base", tf2::TimePointZero);
            pub_->publish(std_msgs::msg::String());
          }

          std::unique_ptr<tf2_ros::TransformBroadcaster> broadcaster_;
          std::unique_ptr<tf2_ros::Buffer> buffer_;
          std::shared_ptr<tf2_ros::TransformListener> listener_;
          rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
          rclcpp::TimerBase::SharedPtr send_timer_;
          rclcpp::TimerBase::SharedPtr look_timer_;
        };

        int main(int argc, char ** argv) {
          rclcpp::init(argc, argv);
          rclcpp::spin(std::make_shared<Robot>());
          rclcpp::shutdown();
        }
        """,
    )
    assert traced.before("/pose") == {"Robot.look", "frame base", "Robot.send"}
    [link] = links_of(traced.flow, "frame base", "Robot.look")
    assert not link.doubt
