"""What the tests share: the program to compare with, and small scenes that are quick."""

import csv
import json
import os
import subprocess

import pytest

PROGRAM = os.environ["ASPERITY_PROGRAM"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

SMALL = {"surface": {"elements": 400}, "ensemble": {"realizations": 3}, "sweep": {"points": 5}}
MOVING = {"surface": {"elements": 200}, "accuracy": {"oversampling": 1},
          "sliding": {"kind": "step", "velocity": 1.0, "velocity_after": 3.0, "duration": 2e-3}}


def run(*arguments, folder=None):
    """Standard output of the program; asserts that it succeeds."""
    found = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True, text=True,
                           stdin=subprocess.DEVNULL, check=False)
    assert found.returncode == 0, found.stderr
    return found.stdout


def complaint(*arguments, folder=None):
    """What the program says of bad input, without its own name."""
    found = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True, text=True,
                           stdin=subprocess.DEVNULL, check=False)
    assert found.returncode == 2, found
    return found.stderr.strip().removeprefix("asperity: ")


def table_of(text):
    """Columns of a table of the program as lists of texts."""
    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def assert_equal_columns(table, text):
    """Asserts that arrays have the very numbers of a table of the program."""
    columns = table_of(text)
    assert list(table) == list(columns)
    for name, cells in columns.items():
        if name == "notes":
            assert list(table[name]) == cells
            continue
        values = table[name].tolist()
        assert len(values) == len(cells)
        for value, cell in zip(values, cells):
            assert (value != value) if cell == "" else value == float(cell), name


@pytest.fixture
def scene_file(tmp_path):
    """Writes a scene and returns its path."""
    def write(values, name="scene.json"):
        path = tmp_path / name
        path.write_text(json.dumps(values))
        return path
    return write
