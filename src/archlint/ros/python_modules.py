"""The keys under which rosdep knows the packages that modules of Python are in."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache

from archlint.ros import rosdep

_ALIASES: Mapping[str, str] = {
    "PIL": "python3-pil",
    "PyQt5": "python3-pyqt5",
    "RPi": "python-rpi.gpio-pip",
    "Jetson": "python-jetson-gpio-pip",
    "bluetooth": "python3-bluez",
    "bs4": "python3-bs4",
    "casadi": "casadi-pip",
    "control": "python-control-pip",
    "cv2": "python3-opencv",
    "dateutil": "python3-dateutil",
    "grpc": "python3-grpcio",
    "paho": "python3-paho-mqtt",
    "skimage": "python3-skimage",
    "speech_recognition": "python-speechrecognition-pip",
    "utm": "python3-utm",
}
"""Modules whose key does not follow from their name."""
_WITH_ROS = frozenset(
    {"argcomplete", "catkin_pkg", "colcon", "em", "importlib_metadata", "lark", "numpy", "packaging", "pkg_resources"}
    | {"psutil", "pytest", "setuptools", "typing_extensions", "yaml"}
)
"""What rclpy, messages, launch and the command line bring along, so that it is there wherever a node runs."""
_WITH_QT = frozenset({"python3-qt5-bindings", "python3-qt5-bindings-gl", "python3-qt5-bindings-webkit"})
_BRINGS: Mapping[str, frozenset[str]] = {
    "PIL": frozenset({"rosbridge_library", "rqt_bag", "rqt_image_view"}),
    "PyQt5": frozenset({"python_qt_binding"} | _WITH_QT),
    "PySide2": frozenset({"python3-qt5-bindings"}),
    "bson": frozenset({"rosbridge_library"}),
    "cv2": frozenset({"cv_bridge", "image_geometry", "camera_calibration"}),
    "matplotlib": frozenset({"rqt_plot", "slam_toolbox"}),
    "pydot": frozenset({"py_trees", "qt_dotgraph"}),
    "pymavlink": frozenset({"mavros"}),
    "tornado": frozenset({"rosbridge_server"}),
    "transforms3d": frozenset({"tf_transformations"}),
    "twisted": frozenset({"rosbridge_server"}),
}
"""The ROS packages and the keys of rosdep that bring a module along.  Source: ``rosdep/python.yaml`` of rosdistro."""
_WITH_TORCHVISION = frozenset({"easyocr", "facenet-pytorch", "rfdetr", "timm", "ultralytics", "yolov5"})
_WITH_TORCH = _WITH_TORCHVISION | {
    *("openai-whisper", "pytorch-lightning", "sentence-transformers", "stable-baselines3", "torchaudio", "torchvision"),
}
_WITH_CV2 = frozenset({"deepface", "easyocr", "insightface", "mediapipe", "roboflow", "ultralytics", "yolov5"})
_WITH_SCIPY = frozenset({"easyocr", "insightface", "sentence-transformers", "supervision", "ultralytics", "yolov5"})
_WITH_REQUESTS = frozenset({"deepface", "facenet-pytorch", "insightface", "rfdetr", "roboflow", "supervision"})
_BROUGHT_BY_PIP: Mapping[str, frozenset[str]] = {
    "PIL": _WITH_TORCHVISION - {"rfdetr", "timm"} | {"roboflow", "scikit-image", "supervision", "torchvision"},
    "cv2": _WITH_CV2,
    "joblib": frozenset({"scikit-learn"}),
    "matplotlib": frozenset({"mediapipe", "roboflow", "seaborn", "supervision", "ultralytics", "yolov5"}),
    "networkx": frozenset({"scikit-image"}),
    "pandas": frozenset({"deepface", "seaborn", "ultralytics", "yolov5"}),
    "requests": _WITH_REQUESTS | {"ultralytics", "yolov5"},
    "scipy": _WITH_SCIPY | {"scikit-image", "scikit-learn"},
    "seaborn": frozenset({"yolov5"}),
    "skimage": frozenset({"easyocr", "insightface"}),
    "sklearn": frozenset({"sentence-transformers"}),
    "torch": _WITH_TORCH,
    "torchvision": _WITH_TORCHVISION,
}
"""The packages of PyPI that a module comes with, because they need it.  Source: ``Requires-Dist`` of ultralytics 8.3
and 8.4, torchvision 0.29, easyocr 1.7, supervision 0.31, stable-baselines3 2.9, mediapipe 1.2, scikit-learn 1.9,
seaborn 0.13, scikit-image 0.26, deepface 0.0.103, facenet-pytorch 2.6, insightface 2.1, openai-whisper 20250625,
pytorch-lightning 2.6, rfdetr 1.11, roboflow 1.7, sentence-transformers 6.2, timm 1.0, torchaudio 2.11 and
yolov5 7.0."""


def key_of(module: str) -> str | None:
    """The key of rosdep for a top-level module; None where none is known, or every node has it."""
    if module in _WITH_ROS:
        return None
    plain = module.lower().replace("_", "-")
    spellings = (_ALIASES.get(module, ""), f"python3-{plain}", f"python3-{plain}-pip")
    known = rosdep.keys()
    return next((key for key in spellings if key in known), None)


_PARTS: Mapping[str, frozenset[str]] = {
    "PySide2": frozenset(
        {"QtCore", "QtGui", "QtHelp", "QtNetwork", "QtPrintSupport", "QtSvg", "QtTest", "QtWidgets", "QtXml"}
    ),
}
"""What the key of a module installs of it on Ubuntu.  Source: ``rosdep/python.yaml`` of rosdistro."""


def keys_of_parts(module: str, names: Sequence[str]) -> list[str | None]:
    """The keys for the parts of a module that an import takes, where it has parts that its key does not install; None
    for one without a key."""
    top, _, rest = module.partition(".")
    parts = _PARTS.get(top)
    if parts is None:
        return []
    key, known = key_of(top), rosdep.keys()
    asked_for = [rest.partition(".")[0]] if rest else [name for name in names if name.startswith("Qt")]
    return [
        key if part in parts else next(iter({f"{key}.{part.lower()}"} & known), None)
        for part in dict.fromkeys(asked_for)
    ]


@cache
def names() -> frozenset[str]:
    """The top-level modules that rosdep has keys for, as far as the keys have their names, and those that come with
    ROS."""
    known = rosdep.keys()
    of_keys = (re.fullmatch(r"python3-([a-z0-9-]+?)(?:-pip)?", key) for key in known)
    return _WITH_ROS.union(_ALIASES, (match[1].replace("-", "_") for match in of_keys if match is not None))


def is_known(module: str) -> bool:
    """Whether a top-level module comes with ROS, or rosdep knows its package."""
    return module in _WITH_ROS or key_of(module) is not None


def comes_with_ros(module: str) -> bool:
    """Whether a top-level module is there wherever a node runs."""
    return module in _WITH_ROS


def brought_along_by(module: str) -> frozenset[str]:
    """The ROS packages and the keys of rosdep that bring a module along."""
    return _BRINGS.get(module, frozenset())


def brought_by_pip(module: str) -> frozenset[str]:
    """The packages of PyPI that bring a module along for whoever installs them by pip."""
    return _BROUGHT_BY_PIP.get(module, frozenset())


__all__ = ["brought_along_by", "brought_by_pip", "comes_with_ros", "is_known", "key_of", "keys_of_parts", "names"]
