"""The tutorial notebook and the examples run, and stubs and docstrings fit the package."""

import ast
import json
import os
import subprocess
import sys

import pytest
from conftest import ROOT

import asperity

FOLDER = os.path.join(ROOT, "app/python/examples")
PACKAGE = os.path.join(ROOT, "app/python/asperity")


def code_cells(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        notebook = json.load(file)
    assert notebook["nbformat"] == 4
    return ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def run_cell(source, names):
    """Runs a cell as a notebook does and returns the value that it shows."""
    tree = ast.parse(source)
    last = tree.body[-1] if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    if last is not None:
        tree.body.pop()
    exec(compile(tree, "cell", "exec"), names)
    return None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)


def test_the_tutorial_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names, shown, pictures = {}, 0, 0
    for source in code_cells("tutorial.ipynb"):
        value = run_cell(source, names)
        if value is None:
            continue
        shown += 1
        assert repr(value)
        for show in ("_repr_png_", "_repr_html_"):
            if hasattr(value, show):
                made = getattr(value, show)()
                pictures += isinstance(made, bytes) and made.startswith(b"\x89PNG")
    assert shown >= 5 and pictures >= 2


def test_the_tutorial_shows_every_function():
    text = "\n".join(code_cells("tutorial.ipynb"))
    for name in ("Scene", "curve", "friction", "map", "state", "march", "surface", "material", "fit",
                 "sensitivity", "InputError"):
        assert f"asperity.{name}" in text, name


@pytest.mark.parametrize("name, package", [("emcee_calibration.py", "emcee"), ("openturns_design.py", "openturns")])
def test_example(name, package, tmp_path):
    pytest.importorskip(package)
    path = os.path.join(FOLDER, name)
    with open(path, encoding="utf-8") as file:
        assert len(file.readlines()) < 40
    found = subprocess.run([sys.executable, "-B", path], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stderr
    assert len(found.stdout.splitlines()) >= 2
    if package == "emcee":
        # The rubber was made of 8 MPa and 2 ms: within the samples' reach, of some per cent.
        for line, true in zip(found.stdout.splitlines(), (8e6, 2e-3)):
            assert float(line.split()[1]) == pytest.approx(true, rel=0.2)


def members(tree):
    """Names of functions and classes, and of methods as Class.method."""
    found = set()
    for node in tree.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
            found.add(node.name)
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            found |= {f"{node.name}.{item.name}" for item in node.body
                      if isinstance(item, ast.FunctionDef) and not item.name.startswith("_")}
    return found


def parsed(name):
    with open(os.path.join(PACKAGE, name), encoding="utf-8") as file:
        return ast.parse(file.read())


def test_stubs_and_package_have_the_same_names_and_arguments():
    stub, package, tables = parsed("__init__.pyi"), parsed("__init__.py"), parsed("tables.py")
    ours = members(package) | {name for name in members(tables) if name.startswith("Table")}
    inherited = {"InputError"}
    assert members(stub) == ours | inherited
    arguments = {node.name: ast.unparse(node.args) for node in package.body if isinstance(node, ast.FunctionDef)}
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            for argument in [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs,
                             *filter(None, [node.args.kwarg])]:
                argument.annotation = None
            assert ast.unparse(node.args) == arguments[node.name], node.name


def test_every_public_name_is_described():
    for name in asperity.__all__:
        assert getattr(asperity, name).__doc__, name
    for name in ("curve", "march", "state", "friction", "surface"):
        text = getattr(asperity, name).__doc__ + getattr(
            asperity, {"state": "Contact", "surface": "Surface"}.get(name, "Table")).__doc__
        assert "shape" in text and "scene" in text
