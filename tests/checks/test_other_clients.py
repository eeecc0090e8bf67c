"""TMO005: waits for the server of one client, where another client is meant."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODES = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import SetBool, Trigger


    class Lamp(Node):
        def __init__(self):
            super().__init__('lamp')
            self.create_service(SetBool, 'lamp', self.switch)

        def switch(self, request, response):
            response.success = True
            return response


    class Horn(Node):
        def __init__(self):
            super().__init__('horn')
            self.create_service(Trigger, '{horn}', self.sound)

        def sound(self, request, response):
            response.success = True
            return response


    def lamp():
        rclpy.init()
        rclpy.spin(Lamp())


    def horn():
        rclpy.init()
        rclpy.spin(Horn())
"""
DRIVER = """
    import rclpy
    from node import Horn, Lamp
    from rclpy.node import Node
    from std_srvs.srv import SetBool, Trigger


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.lamp = self.create_client(SetBool, 'lamp')
            self.horn = self.create_client(Trigger, 'horn')
            {made}
            self.create_timer(5.0, self.tick)

        def tick(self):
            {tick}

        def warn(self, future):
            {warn}


    def main():
        rclpy.init()
        rclpy.spin(Driver())


    if __name__ == '__main__':
        main()
"""
MAINS = """
    from node import {name}


    if __name__ == '__main__':
        {name}()
"""
INDENT = "\n            "
SWITCH = "self.lamp.call_async(SetBool.Request(data=True))"
SOUND = "self.horn.call_async(Trigger.Request())"
RETURNS = "if not self.{}.wait_for_service(timeout_sec=1.0):{}\n                return"


def unless(client: str, mark: str = "") -> str:
    return RETURNS.format(client, mark)


def driver(*tick: str, made: str = "pass", warn: str = "pass") -> str:
    return DRIVER.format(tick=INDENT.join(tick), made=made, warn=warn)


def robot(source: str, horn: str = "horn") -> tuple[str, ...]:
    """The driver, and a program for each of the two that serve it."""
    return NODES.format(horn=horn), source, MAINS.format(name="lamp"), MAINS.format(name="horn")


class TestTheRequestGoesToAnother:
    @pytest.mark.parametrize(
        "source",
        [
            driver(unless("lamp", "  # here"), SOUND),
            driver("self.lamp.wait_for_service()  # here", SOUND),
            driver("while not self.lamp.wait_for_service(timeout_sec=1.0):  # here", "    pass", SOUND),
            driver("self.lamp.wait_for_service(timeout_sec=1.0)  # here", SOUND),
            driver(unless("lamp", "  # here"), f"{SOUND}.add_done_callback(print)"),
        ],
        ids=["returns", "forever", "loop", "result ignored", "goes on in a callback"],
    )
    def test_nothing_waits_for_what_is_asked(self, judge: Judge, source: str):
        [finding] = judge("TMO005", *robot(source))
        assert finding.message == (
            "this waits for the service 'lamp', and the request goes to the service 'horn', for which nothing waits"
        )
        assert finding.help == "wait with the other client: self.horn.wait_for_service(…)"
        assert [row.message for row in finding.related] == [
            "the request is sent here",
            "the other client is created here",
        ]

    @pytest.mark.parametrize(
        "source",
        [
            driver(unless("horn"), SOUND),
            driver(unless("lamp"), SWITCH),
            driver(unless("lamp"), SWITCH, SOUND),
            driver(unless("lamp"), unless("horn"), SOUND),
            driver(unless("lamp"), "if self.horn.service_is_ready():", f"    {SOUND}"),
            driver(unless("lamp"), SOUND, made="found = self.horn.wait_for_service(timeout_sec=1.0); print(found)"),
            driver(unless("lamp"), f"{SOUND}.add_done_callback(self.warn)", warn=SWITCH),
            driver(SOUND, made="self.lamp.wait_for_service()", warn=SWITCH),
            driver(SWITCH, made=f"self.lamp.wait_for_service(); {SOUND}"),
            driver("print(self.count_services('horn'))", "self.lamp.wait_for_service()", SOUND),
            driver(
                "for client in (self.lamp, self.horn):",
                "    if not client.wait_for_service(timeout_sec=1.0):",
                "        return",
                SOUND,
            ),
            driver("if self.executor:", "    self.lamp.wait_for_service()", SOUND),
        ],
        ids=[
            *(
                "the same",
                "the same lamp",
                "both are asked",
                "both are waited for",
                "asked before",
                "found at the start",
            ),
            *(
                "goes on with the lamp",
                "needed later",
                "at the start",
                "asked otherwise",
                "in a loop",
                "only sometimes",
            ),
        ],
    )
    def test_code_that_looks_like_it(self, judge: Judge, source: str):
        judge("TMO005", *robot(source))

    def test_a_server_that_is_not_here_may_be_in_the_same_node(self, judge: Judge):
        judge("TMO005", *robot(driver(unless("lamp"), SOUND), horn="siren"))

    def test_one_program_that_serves_both(self, judge: Judge):
        both = """
            import rclpy
            from node import Horn, Lamp
            from rclpy.executors import SingleThreadedExecutor


            if __name__ == '__main__':
                rclpy.init()
                executor = SingleThreadedExecutor()
                executor.add_node(Lamp())
                executor.add_node(Horn())
                executor.spin()
        """
        judge("TMO005", NODES.format(horn="horn"), driver(unless("lamp"), SOUND), both)


WARNS = "if not self.{}.wait_for_service(timeout_sec={}):{}\n                print('not there')"


class TestTheSameWaitAgain:
    @pytest.mark.parametrize(
        "made",
        [
            (WARNS.format("lamp", 1.0, ""), WARNS.format("lamp", 1.0, "  # here")),
            ("self.lamp.wait_for_service()", "self.lamp.wait_for_service()  # here"),
            (
                "while not self.lamp.wait_for_service(timeout_sec=1.0):",
                "    print('no lamp')",
                "while not self.lamp.wait_for_service(timeout_sec=1.0):  # here",
                "    print('no horn')",
            ),
        ],
    )
    def test_nothing_waits_for_the_other_client(self, judge: Judge, made: tuple[str, ...]):
        [finding] = judge("TMO005", driver("pass", made=INDENT.join(made)))
        assert finding.message == (
            "this waits for the service 'lamp' once more, and nothing waits for the service 'horn'"
        )
        assert finding.related[0].message == "here it waits for it first"

    @pytest.mark.parametrize(
        "made",
        [
            (WARNS.format("lamp", 1.0, ""), WARNS.format("horn", 1.0, "")),
            (WARNS.format("lamp", 1.0, ""), WARNS.format("lamp", 10.0, "")),  # a second try, which takes longer
            (unless("lamp"), WARNS.format("lamp", 1.0, "")),
            (
                "if not self.lamp.wait_for_service(timeout_sec=1.0):",
                "    if not self.lamp.wait_for_service(timeout_sec=1.0):",
                "        raise RuntimeError",
            ),
            (WARNS.format("lamp", 1.0, ""), SWITCH, WARNS.format("lamp", 1.0, "")),
            (WARNS.format("lamp", 1.0, ""), WARNS.format("lamp", 1.0, ""), WARNS.format("horn", 1.0, "")),
        ],
        ids=["each once", "longer", "another way on", "nested", "between requests", "all are waited for"],
    )
    def test_code_that_looks_like_it(self, judge: Judge, made: tuple[str, ...]):
        judge("TMO005", driver("pass", made=INDENT.join(made)))
