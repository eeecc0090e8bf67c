"""Configuration: which file counts, what it may say, and how it is told that it is wrong."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from archlint import rulebook
from archlint.checks.registry import rule
from archlint.checks.scope import Scope
from archlint.config.schema import ConfigurationFile
from archlint.config.selection import Layer, resolve
from archlint.config.settings import ConfigurationError, Glob, Settings, load
from archlint.finding import Severity
from archlint.rulebook import Rule
from registering import only


def a_rule(code: str, name: str, default: str = "on") -> Rule:
    return Rule(code, name, Severity.WARNING, default, "", "0.1.0", "", "")


BOOK = [
    a_rule("LNT002", "unreadable-file"),
    a_rule("LNT003", "internal-error"),
    a_rule("NME003", "name-convention", "off"),
    a_rule("SRV001", "client-without-server", "closed-world"),
    a_rule("SRV003", "nested-service-call"),
    a_rule("SRV004", "service-for-continuous-data"),
    a_rule("TMO001", "wait-without-timeout"),
]


@pytest.fixture(autouse=True)
def small_rule_book(monkeypatch: pytest.MonkeyPatch) -> None:
    book = {rule.code: rule for rule in BOOK}
    monkeypatch.setattr(rulebook, "rules", lambda: book)
    monkeypatch.setattr("archlint.config.selection.rules", lambda: book)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def write(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")
    return path


def complaint(folder: Path, text: str, name: str = "archlint.toml") -> str:
    write(folder, name, text)
    with pytest.raises(ConfigurationError) as caught:
        load(folder)
    return str(caught.value)


# --- which file counts


def test_without_a_file_everything_is_at_its_default(folder: Path):
    assert load(folder) == Settings()


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("archlint.toml", "closed-world = true"),
        (".archlint.toml", "closed-world = true"),
        ("pyproject.toml", "[tool.archlint]\nclosed-world = true"),
    ],
)
def test_three_names(folder: Path, name: str, text: str):
    write(folder, name, text)
    assert load(folder).closed_world


def test_the_nearest_file_upwards_wins_and_nothing_is_merged(folder: Path):
    write(folder, "archlint.toml", "closed-world = true\ndistro = 'humble'")
    write(folder, "src/pkg/archlint.toml", "distro = 'jazzy'")
    settings = load(folder / "src" / "pkg" / "pkg")
    assert (settings.distro, settings.closed_world) == ("jazzy", False)


def test_a_pyproject_without_the_table_is_passed_over(folder: Path):
    write(folder, "archlint.toml", "distro = 'humble'")
    write(folder, "pkg/pyproject.toml", "[tool.ruff]\n# not for archlint\n")
    assert load(folder / "pkg").distro == "humble"


def test_a_broken_pyproject_that_does_not_speak_of_archlint_is_not_our_business(folder: Path):
    write(folder, "pyproject.toml", "[tool.ruff\n")
    assert load(folder) == Settings()


def test_a_named_file_is_the_only_one_read(folder: Path):
    write(folder, "archlint.toml", "no such = key")
    other = write(folder, "ci.toml", "distro = 'rolling'")
    assert load(folder, other).distro == "rolling"


# --- what it may say


def test_every_key(folder: Path):
    write(
        folder,
        "archlint.toml",
        """
        select = ["SRV"]
        extend-select = ["name-convention"]
        ignore = ["SRV004"]
        exclude = ["vendor/**"]
        distro = "jazzy"
        closed-world = true
        external = ["/joint_states"]
        shared-topics = ["/battery/*"]
        cache-dir = "out/cache"
        [severity]
        SRV003 = "info"
        [per-file-ignores]
        "**/test_*.py" = ["ALL"]
        [per-package-ignores]
        "demo_*" = ["TMO"]
        """,
    )
    settings = load(folder)
    here = folder.as_posix()
    assert settings.layers == (Layer(("SRV",), ("name-convention",), ("SRV004",)),)
    assert settings.exclude == (Glob("vendor/**", here),)
    assert settings.distros == ("jazzy",)
    assert settings.closed_world
    assert settings.external == ("/joint_states",)
    assert settings.shared_topics == ("/battery/*",)
    assert settings.cache_dir == f"{here}/out/cache"
    assert settings.severity == {"SRV003": Severity.INFO}
    assert settings.per_file_ignores == {Glob("**/test_*.py", here): ("ALL",)}
    assert settings.per_package_ignores == {"demo_*": ("TMO",)}


def test_every_key_has_a_field():
    # `layers` of the settings are those of configuration; the key `layers` is about nodes.
    names = dict.fromkeys(("layers", "origins", "file", "read", "running_plugins"), None) | {"node_layers": "layers"}
    fields = {names.get(field, field.replace("_", "-")) for field in Settings.__dataclass_fields__} - {None}
    assert set(ConfigurationFile.__struct_encode_fields__) - {"extend", "select", "extend-select", "ignore"} == fields


def test_unset_distro_means_all_supported(folder: Path):
    assert load(folder).distros == ("humble", "jazzy", "kilted", "lyrical", "rolling")


def test_where_each_value_came_from(folder: Path):
    write(folder, "pyproject.toml", "[tool.archlint]\nextend = 'base.toml'\ndistro = 'jazzy'")
    write(folder, "base.toml", "\n\nclosed-world = true\ndistro = 'humble'")
    assert load(folder).origins == {"closed-world": "base.toml:3", "distro": "pyproject.toml:3"}


def test_extend_inherits_tables_key_by_key_and_everything_else_whole(folder: Path):
    write(
        folder,
        "base/archlint.toml",
        'exclude = ["a", "b"]\nignore = ["TMO"]\n[severity]\nSRV = "info"\nTMO = "info"',
    )
    write(folder, "archlint.toml", 'extend = "base/archlint.toml"\nexclude = ["c"]\n[severity]\nSRV = "error"')
    settings = load(folder)
    assert settings.exclude == (Glob("c", folder.as_posix()),)
    assert settings.severity == {"SRV": Severity.ERROR, "TMO": Severity.INFO}
    assert settings.layers == (Layer(ignore=("TMO",)), Layer())


def test_globs_are_relative_to_the_file_that_they_stand_in(folder: Path):
    write(folder, "base/archlint.toml", 'exclude = ["vendor/**"]')
    write(folder, "archlint.toml", 'extend = "base/archlint.toml"')
    assert load(folder).exclude == (Glob("vendor/**", f"{folder.as_posix()}/base"),)


@pytest.fixture
def rule_with_options(monkeypatch: pytest.MonkeyPatch) -> None:
    own = rule("SRV004", scope=Scope.CODE, min_rate=1.0, allowed=("/ping",), strict=False, unit="hertz")
    only(monkeypatch, own(lambda *_: iter(())))


@pytest.mark.usefixtures("rule_with_options")
def test_options_of_a_rule(folder: Path):
    write(
        folder,
        "archlint.toml",
        """
        [rules.service-for-continuous-data]
        min-rate = 5
        allowed = ["/a"]
        strict = true
        unit = "per minute"
        """,
    )
    expected = {"min-rate": 5, "allowed": ("/a",), "strict": True, "unit": "per minute"}
    assert load(folder).rules == {"SRV004": expected}


# --- how it is told wrong


@pytest.mark.parametrize(
    ("text", "message", "line"),
    [
        ("selct = ['SRV']", "unknown key `selct`; did you mean `select`?", 1),
        ("\nclosed_world = true", "unknown key `closed_world`; did you mean `closed-world`?", 2),
        ("nothing-like-it = 1", "unknown key `nothing-like-it`", 1),
        ("[tool.archlint]\ndistro = 'humble'", "unknown key `tool`", 1),
        ("[ruls.x]\ny = 1", "unknown key `ruls`; did you mean `rules`?", 1),
        ("select = 'SRV'", "`select` must be a list of strings, not a string", 1),
        ("select = ['SRV', 3]", "`select` must be a list of strings, not a list with a number", 1),
        ("closed-world = 'yes'", "`closed-world` must be true or false, not a string", 1),
        ("cache-dir = 1979-05-27", "`cache-dir` must be a string, not a date or time", 1),
        ("severity = ['SRV']", "`severity` must be a table, not a list with a string", 1),
        (
            "distro = 'jazy'",
            "`distro` must be one of humble, jazzy, kilted, lyrical, rolling; did you mean jazzy?",
            1,
        ),
        ("select = ['SRV3']", "unknown rule `SRV3`; did you mean SRV003?", 1),
        ("ignore = [\n  'TMO001',  # x\n  'TMO01',\n]", "unknown rule `TMO01`; did you mean TMO001?", 3),
        ("[severity]\nTMO001 = 'error'\nTMO9 = 'info'", "unknown rule `TMO9`", 3),
        ("[severity]\nTMO001 = 'eror'", "must be one of info, warning, error; did you mean error?", 2),
        ("severity = { TMO9 = 'info' }", "unknown rule `TMO9`", 1),
        (
            "[per-file-ignores]\n'a/*' = ['nested-servce-call']",
            "did you mean nested-service-call (SRV003)?",
            2,
        ),
        ("[rules.nested-call]\nx = 1", "unknown rule `nested-call`", 1),
        ("[rules.nested-service-call]\nx = 1", "SRV003 nested-service-call has no option `x`", 2),
        ("[per-package-ignores]\na = ['TMO001']\nb = 3", "`per-package-ignores.b` must be a list of strings", 3),
        ("[severity]\nTMO001 = 3", "`severity.TMO001` must be one of info, warning, error", 2),
        ("layers = { order = 'a' }", "`layers.order` must be a list of strings, not a string", 1),
        ("rules = { SRV003 = [] }", "`rules.SRV003` must be a table, not a list", 1),
        ("[rules]\nSRV003 = 1", "`rules.SRV003` must be a table, not a number", 2),
        ("contracts = [3]", "`contracts` must be a list of tables, each headed by [[contracts]]", 1),
        ("select = [", "not valid TOML", 1),
        ("extend = 'no.toml'", "`extend` names a file that does not exist: no.toml", 1),
    ],
)
def test_a_mistake_is_shown_with_its_line_and_what_was_meant(folder: Path, text: str, message: str, line: int):
    told = complaint(folder, text)
    assert message in told
    assert told.startswith(f"archlint.toml:{line}: ")
    assert f"\n{line} | {text.splitlines()[line - 1]}\n" in told


def test_the_frame_underlines_what_is_wrong(folder: Path):
    assert complaint(folder, "distro = 'humble'\nselect = ['SRV', 'TMO01']") == (
        "archlint.toml:2: unknown rule `TMO01`; did you mean TMO001?\n"
        "  |\n"
        "2 | select = ['SRV', 'TMO01']\n"
        "  |                  ^^^^^^^"
    )


def test_lines_are_those_of_the_table_in_pyproject(folder: Path):
    text = "[tool.ruff]\nselct = []\n\n[tool.archlint]\nselct = []\n"
    assert complaint(folder, text, "pyproject.toml").startswith("pyproject.toml:5: unknown key `selct`")


@pytest.mark.usefixtures("rule_with_options")
def test_the_type_of_a_rules_option_is_that_of_its_default(folder: Path):
    table = "[rules.service-for-continuous-data]\n"
    assert "did you mean `min-rate`?" in complaint(folder, table + "min_rate = 3")
    assert "must be a number, not a boolean" in complaint(folder, table + "min-rate = true")
    assert "must be a list of strings, not a string" in complaint(folder, table + "allowed = '/ping'")


def test_extend_in_a_circle(folder: Path):
    write(folder, "base.toml", "extend = 'archlint.toml'")
    assert "`extend` forms a circle: archlint.toml -> base.toml -> archlint.toml" in complaint(
        folder, "extend = 'base.toml'"
    )


def test_a_file_that_is_not_text(folder: Path):
    (folder / "archlint.toml").write_bytes(b"distro = '\xff'")
    with pytest.raises(ConfigurationError, match=r"archlint\.toml: is not UTF-8"):
        load(folder)


def test_a_named_file_that_is_not_there(folder: Path):
    with pytest.raises(ConfigurationError, match=r"ci\.toml: cannot be read: No such file"):
        load(folder, folder / "ci.toml")


# --- which rules run

ALWAYS = {"LNT002", "LNT003"}


@pytest.mark.parametrize(
    ("layers", "always"),
    [
        ([], {"SRV003", "SRV004", "TMO001"}),
        ([Layer(select=("SRV",))], {"SRV001", "SRV003", "SRV004"}),
        ([Layer(select=("ALL",))], {"NME003", "SRV001", "SRV003", "SRV004", "TMO001"}),
        ([Layer(select=())], set()),
        ([Layer(extend_select=("NME003",))], {"NME003", "SRV003", "SRV004", "TMO001"}),
        ([Layer(ignore=("SRV",))], {"TMO001"}),
        ([Layer(select=("SRV003",), ignore=("SRV",))], {"SRV003"}),
        ([Layer(select=("SRV",), ignore=("SRV003",))], {"SRV001", "SRV004"}),
        ([Layer(select=("SRV003",), ignore=("nested-service-call",))], set()),
        ([Layer(ignore=("SRV003",)), Layer(select=("SRV003",))], {"SRV003"}),
        ([Layer(select=("SRV003",)), Layer(ignore=("SRV",))], set()),
        ([Layer(select=("TMO",)), Layer(extend_select=("SRV003",))], {"SRV003", "TMO001"}),
    ],
)
def test_selection(layers: list[Layer], always: set[str]):
    assert resolve(layers).always == always | ALWAYS


def test_rules_of_the_closed_world_run_in_an_open_one_only_when_asked_for():
    assert not resolve([]).runs("SRV001", closed=False)
    assert resolve([]).runs("SRV001", closed=True)
    assert resolve([Layer(select=("SRV001",))]).runs("SRV001", closed=False)
    assert not resolve([Layer(ignore=("SRV001",))]).runs("SRV001", closed=True)


def test_unreadable_files_can_be_ignored_by_name_but_a_failure_of_ours_cannot():
    assert resolve([Layer(ignore=("LNT",))]).always & ALWAYS == {"LNT003"}


# --- what a repository may not have read


SECRET = "TOKEN=hunter2\n"


@pytest.fixture
def repository(folder: Path) -> Path:
    (folder / "repository/.git").mkdir(parents=True)
    write(folder, "secret", SECRET)
    return folder / "repository"


@pytest.mark.parametrize("extend", ["../secret", "{folder}/secret", "/proc/self/environ", "link"])
def test_a_repository_cannot_have_another_file_of_the_machine_shown(folder: Path, repository: Path, extend: str):
    (repository / "link").symlink_to(folder / "secret")
    told = complaint(repository, f"extend = '{extend.format(folder=folder)}'")
    assert "`extend` leads out of the repository" in told
    assert "hunter2" not in told


@pytest.mark.parametrize(
    "cache", ["../cache", "{folder}/cache", "~/cache", "/proc/self", "link/cache", "a/../../cache"]
)
def test_a_repository_cannot_have_its_cache_written_elsewhere(folder: Path, repository: Path, cache: str):
    (repository / "link").symlink_to(folder)
    written = f'cache-dir = "{cache.format(folder=folder)}"'
    told = complaint(repository, written)
    assert "archlint.toml:1: `cache-dir` leads out of the repository" in told
    assert "name such a folder with --cache-dir" in told
    assert load(repository, repository / "archlint.toml").cache_dir is not None  # as --config names it


def test_a_package_may_have_its_cache_elsewhere_in_the_repository(folder: Path, repository: Path):
    write(repository, "package/archlint.toml", "cache-dir = '../build/cache'")
    assert Path(load(repository / "package").cache_folder).resolve() == repository / "build/cache"


def test_without_a_repository_the_cache_stays_below_the_configuration(folder: Path):
    assert "`cache-dir` leads out of the repository" in complaint(folder, "cache-dir = '../cache'")


def test_a_configuration_that_is_a_link_out_of_the_repository_is_not_shown(folder: Path, repository: Path):
    (repository / "archlint.toml").symlink_to(folder / "secret")
    with pytest.raises(ConfigurationError) as caught:
        load(repository)
    assert "hunter2" not in str(caught.value)


def test_a_configuration_that_the_user_names_may_build_on_any_file_which_is_not_shown(folder: Path, repository: Path):
    own = write(repository, "archlint.toml", "extend = '../secret'")
    with pytest.raises(ConfigurationError) as caught:
        load(repository, own)
    assert "hunter2" not in str(caught.value)
    assert "not valid TOML" in str(caught.value)

    write(folder, "secret", "distro = 'jazzy'")
    assert load(repository, own).distro == "jazzy"
    write(folder, "secret", "distro = 'hunter2'")
    with pytest.raises(ConfigurationError) as caught:
        load(repository, own)
    assert "secret:1" in str(caught.value)
    assert " | " not in str(caught.value)


def test_inside_the_repository_a_configuration_may_lie_above_the_package(folder: Path, repository: Path):
    write(repository, "common.toml", "distro = 'humble'")
    write(repository, "package/archlint.toml", "extend = '../common.toml'")
    assert load(repository / "package").distro == "humble"


def test_a_pipe_is_no_configuration(folder: Path):
    os.mkfifo(folder / "base.toml")
    assert "names a file that does not exist" in complaint(folder, "extend = 'base.toml'")


@pytest.mark.parametrize("key", ["extend", "cache-dir"])
def test_a_path_that_is_none_is_told(folder: Path, key: str):
    assert f"`{key}` contains a character that is not allowed in a path" in complaint(folder, f'{key} = "a\\u0000b"')
    assert f"`{key}` names a user whose home is not known" in complaint(folder, f'{key} = "~no-such-user/x"')


def test_a_file_that_is_too_large_is_no_configuration(folder: Path):
    assert "the file is too large: the limit is 1000 kB" in complaint(folder, "#" * 1_000_001)


# --- contracts: a table of several with one name


def test_the_line_is_that_of_the_contract_which_is_wrong(folder: Path):
    first = "[[contracts]]\nname = 'a'\nkind = 'forbid'\nfrom = '/a'\nto = '/b'\n"
    assert complaint(folder, f"{first}\n[[contracts]]\nname = 'b'\nkind = 'forbid'\nfrom = 3\n").startswith(
        "archlint.toml:10: `contracts.from` must be a string or a list of strings, not a number"
    )
    assert complaint(folder, f"{first}[[contracts]]\nname = 'b'\n").startswith(
        "archlint.toml:6: this contract has no `kind`"
    )
    depth = "kind = 'qos'\ntopic = '/a'\ndepth = [1, -2]\n"
    assert complaint(folder, f"{first}[[contracts]]\nname = 'b'\n{depth}").startswith(
        "archlint.toml:10: `contracts.depth` must be a number of messages, or a list of numbers"
    )


@pytest.mark.parametrize("nodes", ["[]", "'/a'", "['/a']"])
def test_independence_is_between_two_groups_or_more(folder: Path, nodes: str):
    contract = f"[[contracts]]\nname = 'a'\nkind = 'independent'\nnodes = {nodes}\n"
    assert "`contracts.nodes` must be a list of two groups or more" in complaint(folder, contract)
