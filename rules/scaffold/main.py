

import rclpy


def main():
    rclpy.init()
    rclpy.spin(TheNode())


if __name__ == '__main__':
    main()
