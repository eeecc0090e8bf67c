"""What the common interface packages hold: needed for `from std_msgs.msg import *`, where nothing else says it."""

from __future__ import annotations

_NAMES = {
    "actionlib_msgs/msg": "GoalID GoalStatus GoalStatusArray",
    "action_msgs/msg": "GoalInfo GoalStatus GoalStatusArray",
    "builtin_interfaces/msg": "Duration Time",
    "diagnostic_msgs/msg": "DiagnosticArray DiagnosticStatus KeyValue",
    "diagnostic_msgs/srv": "AddDiagnostics SelfTest",
    "example_interfaces/action": "Fibonacci",
    "example_interfaces/msg": """Bool Byte ByteMultiArray Char Empty Float32 Float32MultiArray Float64
        Float64MultiArray Int16 Int16MultiArray Int32 Int32MultiArray Int64 Int64MultiArray Int8 Int8MultiArray
        MultiArrayDimension MultiArrayLayout String UInt16 UInt16MultiArray UInt32 UInt32MultiArray UInt64
        UInt64MultiArray UInt8 UInt8MultiArray WString""",
    "example_interfaces/srv": "AddTwoInts SetBool Trigger",
    "geometry_msgs/msg": """Accel AccelStamped AccelWithCovariance AccelWithCovarianceStamped Inertia InertiaStamped
        Point Point32 PointStamped Polygon PolygonInstance PolygonInstanceStamped PolygonStamped Pose Pose2D PoseArray
        PoseStamped PoseWithCovariance PoseWithCovarianceStamped Quaternion QuaternionStamped Transform
        TransformStamped Twist TwistStamped TwistWithCovariance TwistWithCovarianceStamped Vector3 Vector3Stamped
        VelocityStamped Wrench WrenchStamped""",
    "nav_msgs/msg": "Goals GridCells MapMetaData OccupancyGrid Odometry Path Trajectory TrajectoryPoint",
    "nav_msgs/srv": "GetMap GetPlan LoadMap SetMap",
    "rosgraph_msgs/msg": "Clock",
    "sensor_msgs/msg": """BatteryState CameraInfo ChannelFloat32 CompressedImage FluidPressure Illuminance Image Imu
        JointState Joy JoyFeedback JoyFeedbackArray LaserEcho LaserScan MagneticField MultiDOFJointState
        MultiEchoLaserScan NavSatFix NavSatStatus PointCloud PointCloud2 PointField Range RegionOfInterest
        RelativeHumidity Temperature TimeReference""",
    "sensor_msgs/srv": "SetCameraInfo",
    "shape_msgs/msg": "Mesh MeshTriangle Plane SolidPrimitive",
    "std_msgs/msg": """Bool Byte ByteMultiArray Char ColorRGBA Empty Float32 Float32MultiArray Float64
        Float64MultiArray Header Int16 Int16MultiArray Int32 Int32MultiArray Int64 Int64MultiArray Int8
        Int8MultiArray MultiArrayDimension MultiArrayLayout String UInt16 UInt16MultiArray UInt32 UInt32MultiArray
        UInt64 UInt64MultiArray UInt8 UInt8MultiArray""",
    "std_srvs/srv": "Empty SetBool Trigger",
    "stereo_msgs/msg": "DisparityImage",
    "tf2_msgs/msg": "TF2Error TFMessage",
    "tf2_msgs/srv": "FrameGraph",
    "trajectory_msgs/msg": """JointTrajectory JointTrajectoryPoint MultiDOFJointTrajectory
        MultiDOFJointTrajectoryPoint""",
    "visualization_msgs/msg": """ImageMarker InteractiveMarker InteractiveMarkerControl InteractiveMarkerFeedback
        InteractiveMarkerInit InteractiveMarkerPose InteractiveMarkerUpdate Marker MarkerArray MenuEntry MeshFile
        UVCoordinate""",
}
STANDARD = {package: frozenset(names.split()) for package, names in _NAMES.items()}
"""The names of each package by kind, such as `std_msgs/msg`."""

EVERY_NAME = frozenset().union(*STANDARD.values())
