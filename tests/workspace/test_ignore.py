"""What git ignores is left out, and git itself is the judge."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from workspace.trees import found, look, manifest, plant

GIT = shutil.which("git")


def test_each_gitignore_holds_for_its_folder_and_the_nearest_decides(tmp_path):
    plant(
        tmp_path,
        {
            ".gitignore": "*_generated.py\n/top.py\ncache/\n",
            "a_generated.py": "",
            "top.py": "",
            "pkg/.gitignore": "!kept_generated.py\nlocal.py\r\n",
            "pkg/kept_generated.py": "",
            "pkg/other_generated.py": "",
            "pkg/top.py": "",
            "pkg/local.py": "",
            "pkg/cache/x.py": "",
            "local.py": "",
        },
    )
    assert found(tmp_path) == ["local.py", "pkg/kept_generated.py", "pkg/top.py"]


def test_patterns_of_the_repository_hold_in_its_folders(tmp_path):
    plant(
        tmp_path,
        {
            ".gitignore": "outside.py\n",
            "repo/.git/info/exclude": "# private\nmine.py\n",
            "repo/.gitignore": "skipped.py\n",
            "repo/pkg/skipped.py": "",
            "repo/pkg/mine.py": "",
            "repo/pkg/outside.py": "",
        },
    )
    assert found(tmp_path, "repo/pkg") == ["repo/pkg/outside.py"]
    assert found(tmp_path) == ["repo/pkg/outside.py"]


def test_what_is_asked_for_is_taken_though_ignored(tmp_path):
    plant(tmp_path, {".git/": "", ".gitignore": "old/\n*.tmp.py\n", "old/pkg/a.py": "", "b.tmp.py": ""})
    assert found(tmp_path) == []
    assert found(tmp_path, "old/pkg") == ["old/pkg/a.py"]
    assert found(tmp_path, "b.tmp.py") == ["b.tmp.py"]


@pytest.mark.parametrize("pattern", ["src/", "src/*", "src/org/"])
def test_repositories_cloned_into_an_ignored_src_are_checked(tmp_path, pattern):
    plant(
        tmp_path,
        {
            ".git/": "",
            ".gitignore": f"{pattern}\n",
            "src/robot/.git/": "",
            "src/robot/.gitignore": "scratch.py\n",
            "src/robot/node.py": "",
            "src/robot/scratch.py": "",
            "src/org/arm/.git": "gitdir: elsewhere\n",
            "src/org/arm/node.py": "",
        },
    )
    assert found(tmp_path) == ["src/org/arm/node.py", "src/robot/node.py"]


@pytest.mark.parametrize("pattern", ["!", "\\", "[z-a]", "//", "a[", "\udce9".encode("utf-8", "surrogateescape")])
def test_a_pattern_that_git_would_not_take_does_not_spoil_the_others(tmp_path, pattern):
    line = pattern if isinstance(pattern, bytes) else pattern.encode()
    plant(tmp_path, {"a.py": "", "b.py": ""})
    (tmp_path / ".gitignore").write_bytes(line + b"\nb.py\n")
    assert found(tmp_path) == ["a.py"]


def test_a_gitignore_that_is_no_file_is_passed_over(tmp_path):
    plant(tmp_path, {".gitignore/x": "", "a.py": ""})
    assert found(tmp_path) == ["a.py"]


def test_many_looks_at_the_same_patterns_answer_alike(tmp_path):
    names = [f"{kind}_{number}.py" for kind in ("kept", "dropped") for number in range(300)]
    plant(tmp_path, {".gitignore": "dropped_*\n!dropped_7.py\n/sub/\n", **dict.fromkeys(names, ""), "sub/x.py": ""})
    expected = sorted(name for name in names if name.startswith("kept") or name == "dropped_7.py")
    assert found(tmp_path) == expected


@pytest.mark.skipif(GIT is None, reason="needs git")
def test_git_finds_the_same_files(tmp_path):
    plant(
        tmp_path,
        {
            ".gitignore": "# comment\n*.gen.py\n!keep.gen.py\n/anchored\nmid/dle.py\n**/deep/**/leaf.py\nfolder/\n"
            "trailing \\ \n\\#hash.py\nq?.py\nr[0-9].py\nfoo/*\n!foo/bar/\nout/**\n!out/keep.py\nunder/**/\n",
            "out/keep.py": "",
            "out/gone.py": "",
            "under/kept.py": "",
            "under/in/gone.py": "",
            "a.gen.py": "",
            "keep.gen.py": "",
            "anchored/x.py": "",
            "sub/anchored/x.py": "",
            "mid/dle.py": "",
            "sub/mid/dle.py": "",
            "deep/leaf.py": "",
            "sub/deep/er/leaf.py": "",
            "folder/x.py": "",
            "sub/folder/x.py": "",
            "folder.py": "",
            "#hash.py": "",
            "q1.py": "",
            "q12.py": "",
            "r1.py": "",
            "rx.py": "",
            "foo/gone.py": "",
            "foo/bar/kept.py": "",
            "foo/baz/gone.py": "",
            "nested/.gitignore": "*\n!*/\n!only.py\n!.gitignore\n",
            "nested/gone.py": "",
            "nested/only.py": "",
            "nested/in/only.py": "",
        },
    )
    assert GIT is not None
    run = [GIT, "-c", "core.excludesFile=/dev/null", "-C", str(tmp_path)]
    subprocess.run([*run, "init", "-q"], check=True)
    listing = subprocess.run(
        [*run, "ls-files", "-coz", "--exclude-standard"], check=True, capture_output=True, text=True
    )
    expected = sorted(path for path in listing.stdout.split("\0") if path.endswith(".py"))
    assert {"foo/bar/kept.py", "out/keep.py", "under/kept.py"} < set(expected)
    assert found(tmp_path) == expected


def test_pathspec_is_imported_only_where_there_is_a_pattern(tmp_path: Path):
    plant(tmp_path, {"pkg/package.xml": manifest("pkg"), "pkg/pkg/a.py": "", ".gitignore": "# nothing\n\n"})
    code = (
        "import sys; from archlint.workspace.discovery import find; find(['.']); "
        "print([name for name in ('pathspec', 'pathlib', 'libcst', 'networkx') if name in sys.modules])"
    )
    source = Path(__file__).parents[2] / "src"
    environment = {"PYTHONPATH": str(source), "PATH": ""}
    command = [sys.executable, "-S", "-c", code]
    result = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "[]"
    assert look(tmp_path).packages[0].name == "pkg"


def test_a_pattern_that_is_longer_than_any_path_is_left_out(tmp_path):
    endless = "/**" * 5_000 + "x"
    plant(tmp_path, {".gitignore": f"{endless}\n{chr(0) * 100_000}\nleft.py\n", "left.py": "", "kept.py": ""})
    assert found(tmp_path) == ["kept.py"]


def git(folder: Path, *arguments: str) -> None:
    assert GIT is not None
    author = ["-c", "user.name=a", "-c", "user.email=a@b.org", "-c", "protocol.file.allow=always"]
    subprocess.run([GIT, *author, "-C", str(folder), *arguments], check=True, capture_output=True)


@pytest.mark.skipif(GIT is None, reason="needs git")
@pytest.mark.parametrize("version", ["2", "3", "4"])
def test_what_git_tracks_is_never_ignored(tmp_path, version):
    plant(
        tmp_path,
        {
            ".gitignore": "src/*\n*_local.py\nbuild/\n",
            "src/robot/robot/node.py": "",
            "src/robot/robot/a_rather_long_name_of_a_module.py": "",
            "src/robot/setup_local.py": "",
            "src/arm/arm/node.py": "",
            "build/robot/left.py": "",
        },
    )
    git(tmp_path, "init", "-q")
    git(tmp_path, "add", "--force", ".")
    git(tmp_path, "update-index", "--index-version", version)
    plant(tmp_path, {"src/robot/robot/new.py": "", "src/base/node.py": "", "other_local.py": "", "top.py": ""})
    git(tmp_path, "rm", "--cached", "-q", "src/arm/arm/node.py")
    assert found(tmp_path) == [
        "src/robot/robot/a_rather_long_name_of_a_module.py",
        "src/robot/robot/node.py",
        "src/robot/setup_local.py",
        "top.py",
    ]


@pytest.mark.skipif(GIT is None, reason="needs git")
def test_a_submodule_and_a_linked_worktree_have_an_index_of_their_own(tmp_path):
    plant(tmp_path / "arm", {".gitignore": "node.py\n", "node.py": "", "arm.py": ""})
    git(tmp_path / "arm", "init", "-q")
    git(tmp_path / "arm", "add", "--force", ".")
    git(tmp_path / "arm", "commit", "-q", "-m", "arm")
    plant(tmp_path / "robot", {".gitignore": "src/\n", "src/base.py": ""})
    git(tmp_path / "robot", "init", "-q")
    git(tmp_path / "robot", "submodule", "add", "--force", "-q", str(tmp_path / "arm"), "src/arm")
    git(tmp_path / "robot", "commit", "-q", "-m", "robot")
    plant(tmp_path / "robot", {"src/arm/other/node.py": ""})
    assert found(tmp_path / "robot") == ["src/arm/arm.py", "src/arm/node.py"]
    git(tmp_path / "arm", "worktree", "add", "-q", str(tmp_path / "beside"))
    assert found(tmp_path / "beside") == ["arm.py", "node.py"]


@pytest.mark.parametrize("index", [b"", b"DIRC", b"DIRC\0\0\0\x02\0\0\xff\xff" + bytes(90), b"\xff" * 300])
def test_an_index_that_cannot_be_read_tracks_nothing(tmp_path, index):
    plant(tmp_path, {".git/": "", ".gitignore": "node.py\n", "node.py": "", "base.py": ""})
    (tmp_path / ".git" / "index").write_bytes(index)
    assert found(tmp_path) == ["base.py"]


def test_an_index_is_looked_at_only_where_something_is_ignored(tmp_path):
    plant(tmp_path, {".git/": "", ".gitignore": "node.py\nbuild/\n", "base.py": "", "build/x.py": ""})
    index = str(tmp_path / ".git" / "index")
    assert index not in look(tmp_path).looked_at
    plant(tmp_path, {"pkg/node.py": ""})
    assert index in look(tmp_path).looked_at
