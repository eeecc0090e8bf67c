"""Rows of Python's own libraries: threads, what waits, what is outside of ROS, what names are made with."""

from __future__ import annotations

from archlint.libraries.tables.api import Api
from archlint.model import Role

ROWS = (
    # ---- threads
    Api(
        "threading.Thread",
        "group target name args kwargs * daemon",
        effect="thread",
        callbacks=(("target", Role.THREAD),),
    ),
    Api("threading.Timer", "interval function args kwargs", effect="thread", callbacks=(("function", Role.THREAD),)),
    Api(
        "concurrent.futures.ThreadPoolExecutor.submit",
        "fn",
        effect="submit",
        callbacks=(("fn", Role.THREAD),),
        watched=True,
    ),
    Api(
        "concurrent.futures.ThreadPoolExecutor.map",
        "fn",
        effect="submit_each",
        callbacks=(("fn", Role.THREAD),),
        watched=True,
    ),
    Api("concurrent.futures.ThreadPoolExecutor.shutdown", "wait * cancel_futures", watched=True),
    Api("concurrent.futures.wait", "fs timeout return_when", watched=True),
    Api("concurrent.futures.as_completed", "fs timeout", watched=True),
    Api("concurrent.futures.Future.add_done_callback", "fn", effect="submit", callbacks=(("fn", Role.THREAD),)),
    # ---- waiting
    Api("time.sleep", "seconds", watched=True),
    Api("threading.Event.wait", "timeout", watched=True),
    Api("threading.Event.set", watched=True),
    Api("threading.Thread.join", "timeout", watched=True),
    Api("threading.Timer.join", "timeout", watched=True),
    Api("concurrent.futures.Future.result", "timeout", watched=True),
    Api("builtins.input", "prompt", watched=True),
    # ---- what is outside of ROS
    *(
        Api(path, signature, waits_for_io=True, watched=True)
        for path, signature in (
            ("urllib.request.urlopen", "url data timeout"),
            ("urllib.request.urlretrieve", "url filename"),
            ("requests.get", "url params"),
            ("requests.post", "url data json"),
            ("requests.put", "url data"),
            ("requests.patch", "url data"),
            ("requests.delete", "url"),
            ("requests.head", "url"),
            ("requests.request", "method url"),
            ("requests.Session.get", "url"),
            ("requests.Session.post", "url data json"),
            ("requests.Session.put", "url data"),
            ("requests.Session.patch", "url data"),
            ("requests.Session.delete", "url"),
            ("requests.Session.head", "url"),
            ("requests.Session.request", "method url"),
            ("subprocess.run", "args"),
            ("subprocess.call", "args"),
            ("subprocess.check_call", "args"),
            ("subprocess.check_output", "args"),
            ("subprocess.getoutput", "cmd"),
            ("subprocess.getstatusoutput", "cmd"),
            ("subprocess.Popen.wait", "timeout"),
            ("subprocess.Popen.communicate", "input timeout"),
            ("os.system", "command"),
            ("socket.create_connection", "address timeout"),
            ("fcntl.flock", "fd operation"),
            ("fcntl.lockf", "fd cmd"),
        )
    ),
    # ---- Python's own that matter for names
    Api("importlib.import_module", "name package", effect="import_module"),
    Api("functools.partial", "function", effect="partial"),
    Api("os.path.join", "path", effect="path_join"),
    Api("os.path.exists", "path", effect="asks_for_file"),
    Api("os.path.isfile", "path", effect="asks_for_file"),
    Api("os.path.isdir", "path", effect="asks_for_file"),
    Api("os.getenv", "key default", effect="environment"),
    Api("os.environ.get", "key default", effect="environment"),
    Api("argparse.ArgumentParser", "prog", effect="argument_parser"),
)

__all__ = ["ROWS"]
