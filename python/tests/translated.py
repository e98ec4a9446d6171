"""Command lines as calls of Python's functions."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any, Callable

import numpy as np

import lacuna

NAMES = {"count": "n", "start": "mode", "class": "classes"}  # where they are not the option's
CALLS = {"mask": "threshold_mask"}
FLAGS = {"gaussian": 150}  # without a value, where that is not True
TEXTS = "crop dot_size pens pen paper_size margin plot_time inks paper_colour backend device".split()
Array = np.ndarray[Any, Any]


def number(word: str) -> Any:
    """An int or a float, or the word."""
    for kind in (int, float):
        try:
            return kind(word)
        except ValueError:
            pass
    return word


def sides(word: str) -> tuple[Any, ...]:
    """(width, height), or with a depth, or the corners of X0,Y0+WIDTHxHEIGHT."""
    corner, _, size = word.rpartition("+") if "," in word else ("", "", word)
    if size.count("x") == 2:
        return tuple(map(number, size.split("x")))
    width, height = map(number, size.split("x"))
    x, y = map(number, corner.split(",")) if corner else (0, 0)
    return (x, y, x + width, y + height) if corner else (width, height)


def picture(path: Path) -> Array:
    """The numbers of a .npy or of a picture in text, 0 to 1."""
    if path.suffix == ".npy":
        return np.asarray(np.load(path))
    columns, rows, most, *pixels = map(int, path.read_text().split()[1:])
    return np.reshape(pixels, (rows, columns)) / most


def columns_of(path: Path) -> dict[str, list[str]]:
    """The columns of a .csv by their names; of a .txt x and y."""
    with open(path, encoding="ascii") as file:
        if path.suffix == ".csv":
            names, *rows = csv.reader(file)
        else:
            names, rows = ["x", "y"], [line.split() for line in file]
    return dict(zip(names, map(list, zip(*rows))))


def points(path: Path) -> Array:
    columns = columns_of(path)
    return np.column_stack([columns["x"], columns["y"]]).astype(float)


def obstacles(word: str, folder: Path) -> list[Any]:
    """FILE:WIDTH, or a .csv whose points have radii."""
    name, _, width = word.partition(":")
    if width:
        return [(lacuna.read_lines(folder / name), number(width))]
    radii = map(float, columns_of(folder / name)["radius"])
    return [([[at]], radius) for at, radius in zip(points(folder / name), radii)]


OF_CLASSES = ("border", "mask", "inside", "outside")  # NAME:VALUE is that of one class


def given(name: str, word: str, folder: Path) -> dict[str, Any]:
    """The arguments for an option."""
    own, _, value = word.rpartition(":") if name in OF_CLASSES else ("", "", word)
    made: Any = word if name in TEXTS else number(value)
    if name in ("field", "mask", "ellipses"):
        made = picture(folder / value)
        made = 1 - made if name == "field" else made
    elif name in ("inside", "outside"):
        made = lacuna.read_polygons(folder / value)
    elif name in ("avoid", "near"):
        made = obstacles(word, folder)
    elif name in ("domain", "on_pixels"):
        made = sides(word)
    elif name in ("ink_counts", "chunk"):
        made = [number(one) for one in word.split(",")]
    elif name == "classes":
        own, *values = word.split(":")
        numbers = tuple(number(one) if one else None for one in values) or (None,)
        made = numbers[0] if len(numbers) == 1 else numbers
    elif name == "between" and word.endswith(".csv"):
        made = np.loadtxt(folder / word, delimiter=",")
    elif name == "sharpen" and ":" in word:
        return {"sharpen": number(word.split(":")[0]), "sharpen_amount": number(word.split(":")[1])}
    elif name == "keep":
        kinds = columns_of(folder / word).get("class")
        return {"keep": points(folder / word)} | ({"keep_classes": kinds} if kinds else {})
    return {name: {own: made} if own else made}


def call_of(request: str, folder: Path) -> Callable[[], Any]:
    """The call for a command line whose files lie in the folder."""
    command, *words = request.split()
    arguments: list[Any] = []
    named: dict[str, Any] = {} if command in ("order", "relax", "verify") else {"seed": 0}
    if command == "mask":
        arguments += map(int, words.pop(0).split("x"))
    while words:
        word = words.pop(0)
        name = word.removeprefix("--").replace("-", "_")
        name = NAMES.get(name, name)
        if word == "-o":
            words.pop(0)
        elif not word.startswith("--"):
            is_path = command == "stipple"
            read = (lambda path: path) if is_path else (points, picture)[len(arguments)]
            arguments.append(read(folder / word))
        elif name == "ellipse_columns":
            pass  # Python has and writes them always
        elif name.startswith("no_"):
            named[name.removeprefix("no_")] = False
        elif not words or words[0].startswith("--"):
            named[name] = FLAGS.get(name, True)
        else:
            for key, value in given(name, words.pop(0), folder).items():
                if isinstance(value, (dict, list)) and key in named:
                    value = named[key] + value if isinstance(value, list) else named[key] | value
                named[key] = value
    if len(named.get("domain", ())) == 3:
        command = "sample_volume"
    function = getattr(lacuna, CALLS.get(command, command))
    return lambda: function(*arguments, **named)
