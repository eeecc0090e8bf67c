"""EXE009 and EXE002: waits for threads that wait for a response themselves."""

from __future__ import annotations

import pytest

from checks.judging import Judge

WORKER = """
    import threading
    import time
    from concurrent.futures import ThreadPoolExecutor, as_completed, wait

    import rclpy
    from rclpy.callback_groups import ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Worker(Node):
        def __init__(self):
            super().__init__('worker')
            self.pool = ThreadPoolExecutor(max_workers=2)
            self.client = self.create_client(Trigger, 'compute'{group})
            self.thread = threading.Thread(target=self.ask)
            {made}
            self.create_timer(1.0, self.tick{group})

        def ask(self):
            return self.client.call(Trigger.Request())

        def ask_for(self, name):
            return self.ask()

        def ask_for_a_second(self):
            return self.client.call(Trigger.Request(), timeout_sec=1.0)

        def send(self):
            self.client.call_async(Trigger.Request())

        def loop(self):
            future = self.client.call_async(Trigger.Request())
            while not future.done():
                time.sleep(0.01)

        def ask_if(self):
            if self.executor:
                self.client.call(Trigger.Request())

        def tick(self):
            {tick}


    def main():
        rclpy.init()
        node = Worker()
        {main}


    if __name__ == '__main__':
        main()
"""
ONE = "rclpy.spin(node)"
SEVERAL = "executor = MultiThreadedExecutor(); executor.add_node(node); executor.spin()"
APART = ", callback_group=ReentrantCallbackGroup()"
BLOCKED = "the executor's only thread is blocked in this callback, so the response is never processed"


def worker(*tick: str, made: str = "pass", main: str = ONE, group: str = "") -> str:
    return WORKER.format(tick="\n            ".join(tick), made=made, main=main, group=group)


def started(target: str, *then: str) -> tuple[str, ...]:
    return (f"thread = threading.Thread(target={target})", "thread.start()", *then)


class TestACallbackThatWaitsForAThread:
    @pytest.mark.parametrize(
        ("tick", "what"),
        [
            (started("self.ask", "thread.join()  # here"), "join()"),
            (started("lambda: self.ask()", "thread.join()  # here"), "join()"),
            (started("self.loop", "thread.join()  # here"), "join()"),
            (
                (
                    "threads = [threading.Thread(target=self.ask) for _ in range(3)]",
                    "for thread in threads:",
                    "    thread.start()",
                    "for thread in threads:",
                    "    thread.join()  # here",
                ),
                "join()",
            ),
            (("print(self.pool.submit(self.ask).result())  # here",), "result()"),
            (("future = self.pool.submit(self.ask)", "print(future.result())  # here"), "result()"),
            (
                ("with ThreadPoolExecutor() as pool:", "    pool.submit(self.ask)  # here"),
                "the `with` of this pool waits for its threads and",
            ),
            (
                ("with ThreadPoolExecutor() as pool:", "    print(pool.submit(self.ask).result())  # here"),
                "result()",
            ),
            (("print(list(self.pool.map(self.ask_for, 'ab')))  # here",), "what goes through the results of map()"),
            (
                ("for answer in self.pool.map(self.ask_for, ['a', 'b']):  # here", "    print(answer)"),
                "what goes through the results of map()",
            ),
            (
                ("answers = self.pool.map(self.ask_for, ['a', 'b'])  # here", "print([str(each) for each in answers])"),
                "what goes through the results of map()",
            ),
            (("self.pool.submit(self.ask)", "self.pool.shutdown()  # here"), "shutdown()"),
            (("self.pool.submit(self.ask)", "self.pool.shutdown(wait=True)  # here"), "shutdown()"),
            (("futures = [self.pool.submit(self.ask) for _ in 'ab']", "wait(futures)  # here"), "wait()"),
            (("wait([self.pool.submit(self.ask)])  # here",), "wait()"),
            (
                (
                    "futures = [self.pool.submit(self.ask), self.pool.submit(self.ask)]",
                    "for done in as_completed(futures):  # here",
                    "    print(done)",
                ),
                "as_completed()",
            ),
        ],
        ids=[
            *("join", "lambda", "loop", "several", "submit", "later", "with", "with and result"),
            *(
                "map",
                "map in a loop",
                "map by name",
                "shutdown",
                "shutdown by name",
                "wait",
                "wait at once",
                "completed",
            ),
        ],
    )
    def test_nobody_takes_the_response_meanwhile(self, judge: Judge, tick: tuple[str, ...], what: str):
        [finding] = judge("EXE009", worker(*tick))
        assert finding.message == f"{what} never returns: the thread waits for the service 'compute', and {BLOCKED}"
        assert finding.help == "send the request with call_async(), return, and continue in a done callback"
        messages = [row.message for row in finding.related]
        assert messages[-3:] == [
            "the thread is made here",
            "it waits for the response here",
            "the client is created here",
        ]

    def test_several_threads_do_not_help_in_one_group(self, judge: Judge):
        [finding] = judge("EXE009", worker(*started("self.ask", "thread.join()  # here"), main=SEVERAL))
        assert "the client is in the mutually exclusive callback group of this callback" in finding.message

    @pytest.mark.parametrize(
        "source",
        [
            worker(*started("self.ask", "thread.join()"), main=SEVERAL, group=APART),
            worker(*started("self.ask")),
            worker(*started("self.send", "thread.join()")),
            worker(*started("self.ask_if", "thread.join()")),
            worker(*started("print", "thread.join()")),
            worker("self.pool.submit(self.ask)"),
            worker("self.pool.submit(self.ask).add_done_callback(print)"),
            worker("print(self.pool.submit(time.sleep, 0.1).result())"),
            worker("with ThreadPoolExecutor() as pool:", "    pool.submit(self.send)"),
            worker("self.thread.join()", made="self.thread.start()"),  # it may be over by then
            worker(*started("self.ask", "self.thread.join()")),
            worker("self.pool.map(self.ask_for, 'ab')"),
            worker("self.pool.submit(self.ask)", "self.pool.shutdown(wait=False)"),
            worker("ThreadPoolExecutor().submit(self.ask)", "self.pool.shutdown()"),
            worker("futures = [self.pool.submit(self.send)]", "wait(futures)"),
            worker("print(list(map(self.ask_for, [])))", "print(list(self.pool.map(str, 'ab')))"),
            worker("self.pool.submit(self.ask)", "self.pool.shutdown()", main=SEVERAL, group=APART),
        ],
        ids=[
            *("another group", "not waited for", "only sent", "on a condition", "not a call", "submitted"),
            *("goes on later", "a pause", "a pool that sends", "made before", "another one"),
            *("map is not waited for", "no wait", "another pool", "futures that send", "map of a text", "apart"),
        ],
    )
    def test_code_that_looks_like_it(self, judge: Judge, source: str):
        judge("EXE009", source)

    @pytest.mark.parametrize(
        ("tick", "words"),
        [
            (started("self.ask", "thread.join(timeout=2.0)  # here"), "always times out"),
            (started("self.ask_for_a_second", "thread.join()  # here"), "always times out and returns None"),
            (("future = self.pool.submit(self.ask)", "future.result(timeout=1.0)  # here"), "always times out"),
        ],
    )
    def test_a_timeout_that_always_expires(self, judge: Judge, tick: tuple[str, ...], words: str):
        [finding] = judge("EXE002", worker(*tick), config="distro = 'jazzy'")
        assert finding.message == (
            "the timer callback, Worker.tick, waits for a thread that waits for the service 'compute', and "
            f"{words}: {BLOCKED}"
        )

    def test_the_call_of_the_thread_is_not_told_too(self, judge: Judge):
        only = "if self.executor:\n                self.client.call(Trigger.Request())"
        joined = worker(*started("self.ask", "thread.join()")).replace(only, "pass")
        judge("TMO002", joined)
        judge("TMO002", joined.replace("thread.join()", "pass").replace("Request())", "Request())  # here", 1))


class TestBeforeAnybodySpins:
    def test_a_constructor_that_waits_for_its_thread(self, judge: Judge):
        made = "self.thread.start(); self.thread.join()  # here"
        [finding] = judge("EXE009", worker("pass", made=made))
        assert finding.message == (
            "join() never returns: the thread waits for the service 'compute', and nothing spins its node while this "
            "thread waits"
        )

    @pytest.mark.parametrize(
        "main",
        [
            "threading.Thread(target=rclpy.spin, args=(node,)).start(); "
            "thread = threading.Thread(target=node.ask); thread.start(); thread.join()",
            "thread = threading.Thread(target=node.ask, daemon=True); thread.start(); rclpy.spin(node); thread.join()",
            "thread = threading.Thread(target=rclpy.spin, args=(node,)); thread.start(); thread.join()",
        ],
        ids=["another thread spins", "it has spun", "the thread that spins"],
    )
    def test_a_main_that_spins(self, judge: Judge, main: str):
        judge("EXE009", worker("pass", main=main))
