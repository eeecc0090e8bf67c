import rclpy
from rclpy.node import Node


class Wheels(Node):
    def __init__(self):
        super().__init__("wheels")
        self.create_timer(0.01, self.turn)

    def turn(self):
        self.get_logger().debug("turning")


def main():
    rclpy.init()
    rclpy.spin(Wheels())


if __name__ == "__main__":
    main()
