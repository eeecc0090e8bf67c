"""Which types of ROS and of Gazebo the bridge between them knows as each other.

Source: ros_gz_bridge, ``ros_gz_bridge/mappings.py`` of humble, iron, jazzy and rolling, and the same of ros_ign_bridge
in galactic, taken together.  ``get_factory`` compares the names as they are written.
"""

from __future__ import annotations

from functools import cache

_PAIRS = """
actuator_msgs Actuators=Actuators
builtin_interfaces Time=Time
geometry_msgs Point=Vector3d Pose=Pose PoseArray=Pose_V PoseStamped=Pose PoseWithCovariance=PoseWithCovariance
geometry_msgs PoseWithCovarianceStamped=PoseWithCovariance Quaternion=Quaternion Transform=Pose TransformStamped=Pose
geometry_msgs Twist=Twist TwistStamped=Twist TwistWithCovariance=TwistWithCovariance
geometry_msgs TwistWithCovarianceStamped=TwistWithCovariance Vector3=Vector3d Wrench=Wrench WrenchStamped=Wrench
gps_msgs GPSFix=NavSat
nav_msgs Odometry=Odometry Odometry=OdometryWithCovariance
rcl_interfaces ParameterValue=Any
ros_gz_interfaces Altimeter=Altimeter Contact=Contact Contacts=Contacts Dataframe=Dataframe Entity=Entity
ros_gz_interfaces EntityWrench=EntityWrench Float32Array=Float_V GuiCamera=GUICamera JointWrench=JointWrench Light=Light
ros_gz_interfaces MaterialColor=MaterialColor ParamVec=Param ParamVec=Param_V SensorNoise=SensorNoise
ros_gz_interfaces StringVec=StringMsg_V TrackVisual=TrackVisual VideoRecord=VideoRecord
ros_ign_interfaces Contact=Contact Contacts=Contacts Dataframe=Dataframe Entity=Entity GuiCamera=GUICamera
ros_ign_interfaces JointWrench=JointWrench Light=Light ParamVec=Param ParamVec=Param_V StringVec=StringMsg_V
ros_ign_interfaces TrackVisual=TrackVisual VideoRecord=VideoRecord
rosgraph_msgs Clock=Clock
sensor_msgs BatteryState=BatteryState CameraInfo=CameraInfo FluidPressure=FluidPressure Image=Image Imu=IMU
sensor_msgs JointState=Model Joy=Joy LaserScan=LaserScan MagneticField=Magnetometer NavSatFix=NavSat
sensor_msgs PointCloud2=PointCloudPacked
std_msgs Bool=Boolean ColorRGBA=Color Empty=Empty Float32=Float Float64=Double Header=Header Int32=Int32
std_msgs String=StringMsg UInt32=UInt32
tf2_msgs TFMessage=Pose_V
trajectory_msgs JointTrajectory=JointTrajectory
vision_msgs Detection2D=AnnotatedAxisAligned2DBox Detection2DArray=AnnotatedAxisAligned2DBox_V
vision_msgs Detection3D=AnnotatedOriented3DBox Detection3DArray=AnnotatedOriented3DBox_V
"""


@cache
def pairs() -> dict[str, frozenset[str]]:
    """The types of Gazebo, without their package, that each type of ROS may stand for."""
    gathered: dict[str, set[str]] = {}
    for line in _PAIRS.split("\n"):
        package, *rows = line.split() or [""]
        for row in rows:
            name, _, other = row.partition("=")
            gathered.setdefault(f"{package}/msg/{name}", set()).add(other)
    return {name: frozenset(others) for name, others in gathered.items()}


__all__ = ["pairs"]
