"""SRV005: loops over clients that wait for each response before they send the next request."""

from __future__ import annotations

import textwrap

import pytest

from checks.callbacks import ON_SEVERAL_THREADS, Run, source

GROUPS = "self.create_timer(5.0, self.tick, callback_group=MutuallyExclusiveCallbackGroup())\n"
THREE = "self.parts = [self.create_client(Trigger, name) for name in ('arm', 'base', 'head')]\n"


def sequences(run: Run, setup: str, body: str, main: str = ON_SEVERAL_THREADS) -> list[str]:
    method = "def tick(self):\n" + "".join(f"    {line}\n" for line in body.strip("\n").splitlines())
    found = run(source(GROUPS + setup, method, main))
    return [finding.message.partition(" waits for ")[2] for finding in found if finding.code == "SRV005"]


ASK = "part.call(Trigger.Request(), timeout_sec=1.0)"
NEXT = "part.call(request, timeout_sec=1.0)"
SAID = "the responses of 3 servers, one in each round of a loop: the waits add up, and one slow server delays all"


@pytest.mark.parametrize(
    ("setup", "body"),
    [
        (THREE, f"for part in self.parts:\n    {ASK}"),
        (THREE, f"for number, part in enumerate(self.parts):\n    print(number, {ASK})"),
        (THREE.replace("[", "{name: ").replace("]", "}"), f"for name, part in self.parts.items():\n    {ASK}"),
        ("".join(f"self.{name} = self.create_client(Trigger, '{name}')\n" for name in ("arm", "base", "head")),
         f"for part in (self.arm, self.base, self.head):\n    {ASK}"),
    ],
    ids=["a list", "enumerated", "a dict", "written out"],
)  # fmt: skip
def test_each_round_waits_for_another_server(run: Run, setup: str, body: str):
    assert sequences(run, setup, body) == [SAID]


@pytest.mark.parametrize(
    ("setup", "body"),
    [
        (THREE.replace("'arm', 'base', 'head'", "'arm', 'base'"), f"for part in self.parts:\n    {ASK}"),
        (THREE, f"for part in self.parts:\n    if {ASK} is None:\n        return"),
        (THREE, f"for part in self.parts:\n    if part.service_is_ready() and wanted(part):\n        {ASK}"),
        (THREE, "for part in self.parts:\n    part.call_async(Trigger.Request())"),
        (THREE.replace("Trigger", "SetBool"), f"for part in self.parts:\n    {ASK.replace('Trigger', 'SetBool')}"),
        ("self.part = self.create_client(Trigger, 'arm')\n",
         f"for name in ('a', 'b', 'c'):\n    self.{ASK}"),
        (THREE, f"answer = None\nfor part in self.parts:\n    request = after(answer)\n    answer = {NEXT}"),
    ],
    ids=["two", "ends early", "under a condition", "does not wait", "commands", "one server", "needs the last answer"],
)  # fmt: skip
def test_loops_that_are_right(run: Run, setup: str, body: str):
    assert sequences(run, setup, body) == []


LOOP = """
def main():
    rclpy.init()
    robot = Robot()
    threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()
    while rclpy.ok():
        robot.work()
        time.sleep(5.0)


if __name__ == '__main__':
    main()
"""


def test_a_program_that_repeats_it_and_one_that_does_it_once(run: Run):
    method = f"def tick(self):\n    pass\n\n\ndef work(self):\n    for part in self.parts:\n        {ASK}\n"

    def codes(main: str) -> list[str]:
        return [finding.code for finding in run(source(THREE, method, main)) if finding.code == "SRV005"]

    assert codes(LOOP) == ["SRV005"]
    once = LOOP.replace("    while rclpy.ok():\n        robot.work()\n        time.sleep(5.0)\n", "    robot.work()\n")
    assert codes(once) == []


ASKED = (
    "def tick(self):\n    pass\n\n\ndef ask(self, part, scene):\n    part.call(Trigger.Request(), timeout_sec=1.0)\n"
)
SCENES = """
def main():
    rclpy.init()
    robot = Robot()
    threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()
{scenes}


if __name__ == '__main__':
    main()
"""
ONCE = "".join(f"robot.ask(robot.parts[{number}], 'once')\n" for number in range(3))
AGAIN = f"for _ in range(12):\n{textwrap.indent(ONCE.replace('once', 'again'), '    ')}    time.sleep(2.0)\n"


def scenes(run: Run, *parts: str) -> list[int]:
    """The lines of ``main()``, from the first scene on, that a finding names."""
    text = source(THREE, ASKED, SCENES.format(scenes=textwrap.indent("".join(parts), "    ").rstrip()))
    before = text[: text.index("daemon=True")].count("\n") + 1
    found = [finding for finding in run(text) if finding.code == "SRV005"]
    return [
        row.place.line - before for finding in found for row in finding.related if row.message.startswith("waits for")
    ]


def test_what_a_script_does_once_is_no_part_of_the_loop_after_it(run: Run):
    assert scenes(run, ONCE) == []
    assert scenes(run, AGAIN) == [2, 3, 4]
    assert scenes(run, ONCE, AGAIN) == [5, 6, 7]
    assert scenes(run, AGAIN, ONCE) == [2, 3, 4]


@pytest.mark.parametrize(("rounds", "lines"), [("range(2)", []), ("range(99)", [2, 3, 4]), ("count()", [2, 3, 4])])
def test_a_script_that_plays_a_few_rounds(run: Run, rounds: str, lines: list[int]):
    assert scenes(run, AGAIN.replace("range(12)", rounds)) == lines
