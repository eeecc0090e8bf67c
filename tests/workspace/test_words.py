"""Words of files: what was asked of them is noted with the answers."""

from archlint.workspace.words import Words

TEXTS = {"a.py": "topic = 'front/scan'  # left", "b.py": "left.scan()"}


def test_a_word_stands_in_a_file_as_a_whole():
    words = Words(TEXTS.get)
    assert words.stand_in("a.py", "scan") and not words.stand_in("a.py", "sca")
    assert not words.stand_in("c.py", "scan")
    assert words.asked_of_one == {("a.py", "scan"): True, ("a.py", "sca"): False, ("c.py", "scan"): False}


def test_what_one_workspace_says_of_a_word_stays_when_another_is_asked():
    words = Words(TEXTS.get)
    assert words.note("scan", ["a.py"]) == ["a.py"]
    assert words.note("scan", ["b.py"]) == ["b.py"]
    assert words.asked_of_all == {"scan": {"a.py", "b.py"}}


def test_a_file_is_read_once():
    read = []
    words = Words(lambda path: [read.append(path), TEXTS[path]][1])
    assert words.of("b.py") == words.of("b.py") == {"left", "scan"}
    assert read == ["b.py"]
