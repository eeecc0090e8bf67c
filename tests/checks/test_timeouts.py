from __future__ import annotations

import pytest

from checks.judging import Judge

SCRIPT = """
    import rclpy
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.task import Future
    from rclpy.wait_for_message import wait_for_message
    from std_msgs.msg import String
    from std_srvs.srv import Trigger


    def main(timeout=None):
        rclpy.init()
        node = rclpy.create_node('script')
        executor = SingleThreadedExecutor()
        client = node.create_client(Trigger, 'far')
        action = ActionClient(node, Fibonacci, 'count')
        {line}


    if __name__ == '__main__':
        main()
"""
REQUEST = "Trigger.Request()"
FUTURE = f"client.call_async({REQUEST})"


def script(line: str) -> str:
    return SCRIPT.format(line=line)


class TestWaitWithoutTimeout:
    @pytest.mark.parametrize(
        "line",
        [
            "client.wait_for_service()",
            "client.wait_for_service(None)",
            "client.wait_for_service(timeout_sec=None)",
            "client.wait_for_service(timeout)",
            "found = client.wait_for_service()",
            "action.wait_for_server()",
            "wait_for_message(String, node, 'words')",
            "wait_for_message(String, node, 'words', time_to_wait=-1)",
        ],
    )
    def test_without_a_limit(self, judge: Judge, line: str):
        judge("TMO001", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            "client.wait_for_service(1.0)",
            "client.wait_for_service(timeout_sec=-1.0)",  # does not wait at all
            "client.wait_for_service(timeout_sec=float(input()))",
            "client.wait_for_service(**{'timeout_sec': 1.0})",
            "action.wait_for_server(timeout_sec=0.5)",
            "wait_for_message(String, node, 'words', time_to_wait=2)",
        ],
    )
    def test_with_a_limit(self, judge: Judge, line: str):
        judge("TMO001", script(line))

    def test_a_limit_that_is_a_parameter(self, judge: Judge):
        judge(
            "TMO001",
            script("client.wait_for_service(node.declare_parameter('patience', 2.0).value)"),
        )

    def test_a_helper_whose_callers_choose(self, judge: Judge):
        judge(
            "TMO001",
            """
            from std_srvs.srv import Trigger


            class Far:
                def __init__(self, node):
                    self.client = node.create_client(Trigger, 'far')

                def wait(self, timeout=None):
                    return self.client.wait_for_service(timeout_sec=timeout)
            """,
        )

    def test_a_helper_that_a_caller_gives_no_limit(self, judge: Judge):
        [found] = judge(
            "TMO001",
            script(
                "def wait(limit=None):\n            client.wait_for_service(timeout_sec=limit)  # here\n        wait()"
            ),
        )

        assert [related.message for related in found.related] == [
            "main calls main.wait here",
            "the client is created here",
        ]

    def test_a_test_may_wait(self, judge: Judge):
        (judge.folder / "test").mkdir()
        (judge.folder / "test" / "test_far.py").write_text(
            "import rclpy\n"
            "from std_srvs.srv import Trigger\n"
            "def test_far():\n"
            "    node = rclpy.create_node('far')\n"
            "    node.create_client(Trigger, 'far').wait_for_service()\n"
        )

        judge("TMO001")


class TestCallWithoutTimeout:
    @pytest.mark.parametrize(
        "line",
        [
            f"client.call({REQUEST})",
            f"client.call({REQUEST}, timeout_sec=None)",
            "action.send_goal(Fibonacci.Goal())",
        ],
    )
    def test_without_a_limit(self, judge: Judge, line: str):
        judge("TMO002", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            f"client.call({REQUEST}, timeout_sec=2.0)",
            f"client.call({REQUEST}, 2.0)",
            FUTURE,
            "action.send_goal_async(Fibonacci.Goal())",
        ],
    )
    def test_with_a_limit_or_without_a_wait(self, judge: Judge, line: str):
        judge("TMO002", script(line))

    def test_a_try_around_it_sets_no_limit(self, judge: Judge):
        judge(
            "TMO002",
            script(f"try:\n            client.call({REQUEST})  # here\n        except Exception:\n            pass"),
        )

    def test_humble_has_no_timeout_to_offer(self, judge: Judge):
        [found] = judge("TMO002", script(f"client.call({REQUEST})  # here"), config='distro = "humble"')

        assert "timeout_sec=2.0)" in found.help.partition("spin_until_future_complete")[2]
        assert "call(request, timeout_sec" not in found.help

    def test_later_distributions_have_one(self, judge: Judge):
        [found] = judge("TMO002", script(f"client.call({REQUEST})  # here"), config='distro = "jazzy"')

        assert "call(request, timeout_sec=2.0)" in found.help

    def test_a_callback_is_not_told_to_spin(self, judge: Judge):
        [found] = judge("TMO002", script(f"node.create_timer(1.0, lambda: client.call({REQUEST}))  # here"))

        assert "spin_until_future_complete" not in found.help


class TestSpinWithoutTimeout:
    @pytest.mark.parametrize(
        "line",
        [
            f"rclpy.spin_until_future_complete(node, {FUTURE})",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, executor)",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, timeout_sec=None)",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, timeout_sec=-1)",
            f"executor.spin_until_future_complete({FUTURE})",
        ],
    )
    def test_without_a_limit(self, judge: Judge, line: str):
        judge("TMO003", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            f"rclpy.spin_until_future_complete(node, {FUTURE}, timeout_sec=1.0)",
            f"rclpy.spin_until_future_complete(node, {FUTURE}, executor, 1.0)",
            f"executor.spin_until_future_complete({FUTURE}, 1.0)",
            "rclpy.spin_once(node)",
        ],
    )
    def test_with_a_limit(self, judge: Judge, line: str):
        judge("TMO003", script(line))

    def test_a_future_that_the_code_completes_itself_is_no_answer(self, judge: Judge):
        judge("TMO003", script("rclpy.spin_until_future_complete(node, Future())"))


class TestIgnoredWaitResult:
    @pytest.mark.parametrize(
        "line", ["client.wait_for_service(timeout_sec=1.0)", "action.wait_for_server(timeout_sec=1.0)"]
    )
    def test_thrown_away(self, judge: Judge, line: str):
        judge("TMO005", script(line + "  # here"))

    @pytest.mark.parametrize(
        "line",
        [
            "found = client.wait_for_service(timeout_sec=1.0)",
            "assert client.wait_for_service(timeout_sec=1.0)",
            "client.wait_for_service(timeout_sec=1.0) or print('no server')",
            "client.wait_for_service()",  # has no result to ignore: it ends when the server is there
        ],
    )
    def test_looked_at(self, judge: Judge, line: str):
        judge("TMO005", script(line))

    def test_a_later_question_about_the_same_client_counts(self, judge: Judge):
        judge(
            "TMO005",
            script("client.wait_for_service(timeout_sec=1.0)\n        print(client.service_is_ready())"),
        )

    def test_a_later_question_about_another_client_does_not(self, judge: Judge):
        judge(
            "TMO005",
            script("client.wait_for_service(timeout_sec=1.0)  # here\n        print(action.server_is_ready())"),
        )

    def test_two_programs_that_run_one_line_make_one_finding(self, judge: Judge):
        judge(
            "TMO005",
            """
            import rclpy
            from node1 import Far


            def main():
                rclpy.init()
                rclpy.spin(Far())


            if __name__ == '__main__':
                main()
            """,
            """
            import rclpy
            from rclpy.node import Node
            from std_srvs.srv import Trigger


            class Far(Node):
                def __init__(self):
                    super().__init__('far')
                    self.client = self.create_client(Trigger, 'far')
                    self.client.wait_for_service(timeout_sec=1.0)  # here


            def main():
                rclpy.init()
                rclpy.spin(Far())


            if __name__ == '__main__':
                main()
            """,
        )
