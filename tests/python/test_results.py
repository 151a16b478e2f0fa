"""Curve, motion, surface, material and fit: the very numbers of the program."""

import json
import os

import numpy as np
import pytest
from conftest import MOVING, ROOT, SMALL, assert_equal_columns, complaint, run

import asperity

SCENES = {
    "self_affine": {},
    "indentation": {"load": {"kind": "indentation", "depth": 1e-6}},
    "pressure": {"load": {"kind": "pressure", "nominal_pressure": 1e4}},
    "nodal": {"accuracy": {"scheme": "nodal"}},
    "arms": {"elastomer": {"rheology": "standard_solid", "equilibrium_modulus": 1e6,
                           "arms": [{"modulus": 1e7, "relaxation_time": 1e-3}]}},
    "interface": {"interface": {"friction_coefficient": 0.1}},
    "target": {"accuracy": {"target_relative_error": 0.1}},
    "sine": {"surface": {"kind": "sine", "elements": 400}},
    "material": {"elastomer": {"material": "epdm_70"}},
}


def remade(file, *options):
    """Asserts that the program makes a file again from itself, byte for byte."""
    again = file.with_name("again" + file.suffix)
    run("open", file, "--remake", "-o", again, "--quiet", *options)
    assert again.read_bytes() == file.read_bytes()


def test_a_realization_that_the_program_does_not_write_is_not_remade(tmp_path):
    asperity.surface({}, realization=2).save(tmp_path / "s.csv")
    assert "does not say the options" in complaint("open", tmp_path / "s.csv", "--remake")


@pytest.mark.parametrize("name", SCENES)
def test_curve(name, scene_file, tmp_path):
    values = {**SMALL, **SCENES[name]}
    file = scene_file(values)
    curve = asperity.curve(values, threads=1)
    assert_equal_columns(curve, run("curve", file))
    run("curve", file, "--quiet", "-o", tmp_path / "a.csv", "-o", tmp_path / "a.json")
    assert curve.to_csv() == (tmp_path / "a.csv").read_text()
    assert curve.to_json() == (tmp_path / "a.json").read_text()
    remade(tmp_path / "a.csv")
    curve.save(tmp_path / "b.csv")
    assert (tmp_path / "b.csv").read_text() == curve.to_csv()
    assert curve.scene == asperity.Scene(values)


@pytest.mark.parametrize("sweep", [{"key": "load.normal_force", "from": 1e-3, "to": 1},
                                   {"key": "surface.hurst", "from": 0.9, "to": 0.3, "scale": "linear"}])
def test_curve_over_another_key(sweep, scene_file, tmp_path):
    values = {**SMALL, "sweep": {**sweep, "points": 4}}
    file = scene_file(values)
    curve = asperity.curve(values)
    assert_equal_columns(curve, run("curve", file))
    assert list(curve)[0] == sweep["key"].rpartition(".")[2]
    run("curve", file, "--quiet", "-o", tmp_path / "a.csv", "-o", tmp_path / "a.json")
    assert curve.to_csv() == (tmp_path / "a.csv").read_text()
    assert curve.to_json() == (tmp_path / "a.json").read_text()


def test_curve_of_a_motion_is_refused_as_by_the_program(scene_file):
    with pytest.raises(asperity.InputError, match="steady") as caught:
        asperity.curve(MOVING)
    assert caught.value.key == "sliding.kind"


@pytest.mark.parametrize("options", [{}, {"every": 7}, {"lines": 2}])
def test_motion(options, scene_file, tmp_path):
    file = scene_file(MOVING)
    words = [word for name, value in options.items() for word in ("--" + name, value)]
    motion = asperity.march(MOVING, **options)
    assert_equal_columns(motion, run("motion", file, *words))
    run("motion", file, *words, "--quiet", "-o", tmp_path / "m.csv", "-o", tmp_path / "m.json")
    assert motion.to_csv() == (tmp_path / "m.csv").read_text()
    assert motion.to_json() == (tmp_path / "m.json").read_text()
    for name in ("p.csv", "p.json", "p.svg"):
        motion.save(tmp_path / name)
        remade(tmp_path / name)


def test_motion_of_steady_sliding_is_refused(scene_file):
    said = complaint("motion", scene_file({}))
    with pytest.raises(asperity.InputError) as caught:
        asperity.march({})
    assert said.endswith(str(caught.value))


@pytest.mark.parametrize("values", [{}, {"surface": {"kind": "wedge"}}, {"surface": {"hurst": 0.9, "seed": 4}}])
def test_surface_of_a_scene(values, scene_file, tmp_path):
    file = scene_file(values)
    surface = asperity.surface(values)
    run("surface", file, "-o", tmp_path / "s.csv", "-o", tmp_path / "s.json", "--quiet")
    assert_equal_columns(surface, (tmp_path / "s.csv").read_text())
    assert surface.to_csv() == (tmp_path / "s.csv").read_text()
    assert surface.data == {**json.loads((tmp_path / "s.json").read_text())}
    assert surface.statistics["points"] == len(surface.height) == len(surface.slope)
    for name in ("p.csv", "p.json", "p.png"):
        surface.save(tmp_path / name)
        remade(tmp_path / name)


def test_surface_of_a_measured_file(tmp_path):
    x = np.arange(400) * 1e-6
    z = 1e-6 * np.sin(2 * np.pi * x / 1e-4) + 2e-7 * np.cos(2 * np.pi * x / 2.3e-5)
    file = tmp_path / "profile.csv"
    file.write_text("position,height\n" + "".join(f"{a!r},{b!r}\n" for a, b in zip(x.tolist(), z.tolist())))
    surface = asperity.surface(file)
    run("surface", file, "-o", tmp_path / "s.csv", "-o", tmp_path / "s.json", "--quiet")
    assert_equal_columns(surface, (tmp_path / "s.csv").read_text())
    assert surface.to_json() == (tmp_path / "s.json").read_text()
    assert surface.facts
    surface.save(tmp_path / "p.csv")
    remade(tmp_path / "p.csv")
    changed = asperity.surface(file, surface={"form": "parabola"})
    assert changed.scene["surface.form"] == "parabola"


def test_a_line_that_the_program_wrote_is_not_processed_again(tmp_path):
    x = np.arange(400) * 1e-6
    file = tmp_path / "profile.csv"
    file.write_text("position,height\n" + "".join(
        f"{a!r},{b!r}\n" for a, b in zip(x.tolist(), (1e-6 * np.sin(x / 1e-5) + x / 50).tolist())))
    run("surface", file, "-o", tmp_path / "line.csv", "--quiet")
    line, again = asperity.surface(file), asperity.surface(tmp_path / "line.csv")
    assert again.scene["surface.kind"] == "profile"
    assert again.shape == line.shape == (800,)
    np.testing.assert_allclose(again.height, line.height, atol=1e-15)
    run("surface", tmp_path / "line.csv", "-o", tmp_path / "again.csv", "--quiet")
    assert again.to_csv() == (tmp_path / "again.csv").read_text()


def test_surface_of_a_broken_file_says_what_the_program_says(tmp_path):
    file = tmp_path / "broken.csv"
    file.write_text("position,height\n0,1\n1,x\n2,3\n3,4\n")
    with pytest.raises(asperity.InputError) as caught:
        asperity.surface(file)
    assert str(caught.value) == complaint("surface", file)
    assert caught.value.file == str(file)


@pytest.mark.parametrize("options", [{}, {"reference_temperature": "20C", "terms": 12},
                                     {"shift": "table", "leave_out": ["-10C"], "name": "My rubber"},
                                     {"liquid": True, "vertical_shifts": True, "terms": 8, "source": "x"}])
def test_material(options, tmp_path):
    file = os.path.join(ROOT, "resources/materials/measurements/epdm_70.csv")
    words = []
    for name, value in options.items():
        for one in value if isinstance(value, list) else [value]:
            words += ["--" + name.replace("_", "-")] + ([] if one is True else [one])
    run("material", file, "-o", tmp_path / "out", "--quiet", *words)
    material = asperity.material(file, **options)
    assert material.to_json() == (tmp_path / "out/material.json").read_text()
    for name in ("prony", "isotherms", "shifts"):
        assert_equal_columns(getattr(material, name), (tmp_path / f"out/{name}.csv").read_text())
    material.save(tmp_path / "m.json")
    said = complaint("open", tmp_path / "m.json", "--remake", folder=tmp_path)
    assert "epdm_70.csv, from which it was made, is not there" in said
    remade(tmp_path / "m.json", "--from", os.path.dirname(file))
    scene = asperity.Scene(elastomer={"material": str(tmp_path / "m.json")})
    assert scene["elastomer.equilibrium_modulus"] == material.data["equilibrium_modulus"]


@pytest.mark.parametrize("options", [{"terms": 0}, {"terms": "many"}, {"shift": "vogel"},
                                     {"reference_temperature": "warm"}, {"storage_column": "nothing"}])
def test_wrong_options_of_a_material(options, tmp_path):
    file = os.path.join(ROOT, "resources/materials/measurements/epdm_70.csv")
    with pytest.raises(asperity.InputError) as caught:
        asperity.material(file, **options)
    (name, value), = options.items()
    said = complaint("material", file, "-o", tmp_path / "out", "--" + name.replace("_", "-"), value)
    assert "--" + caught.value.key.replace("_", "-") in said
    if "shift" in options or "reference_temperature" in options:
        assert caught.value.message in said


def test_an_unknown_option_of_a_material_names_the_nearest():
    with pytest.raises(asperity.InputError, match="reference_temperature"):
        asperity.material("x.csv", reference_temperatur="20C")


@pytest.fixture
def measured(tmp_path):
    """Friction of a known rubber, written as a table."""
    velocities = np.geomspace(1e-2, 1e2, 6)
    mu = asperity.friction(SMALL, {"sliding.velocity": velocities, "elastomer.shear_modulus": 8e6}).mu
    file = tmp_path / "measured.csv"
    file.write_text("velocity,mu\n" + "".join(f"{v!r},{m!r}\n" for v, m in zip(velocities.tolist(), mu.tolist())))
    return {"velocity": velocities, "mu": mu}, file


def test_fit(measured, scene_file, tmp_path):
    columns, file = measured
    keys = ["elastomer.shear_modulus=1e6:1e8", "elastomer.relaxation_time"]
    run("fit", scene_file(SMALL), "--data", file, "--vary", keys[0], "--vary", keys[1], "--no-profiles",
        "-o", tmp_path / "out", "--quiet")
    fit = asperity.fit(scene_file(SMALL), file, keys, profiles=False)
    assert fit.to_json() == (tmp_path / "out/fit.json").read_text()
    assert_equal_columns(fit.points, (tmp_path / "out/fit.csv").read_text())
    # The numbers are those of the rubber that the table was made with.
    assert fit["elastomer.shear_modulus"] == pytest.approx(8e6, rel=1e-3)
    assert fit.scene["elastomer.shear_modulus"] == fit["elastomer.shear_modulus"]
    fit.save(tmp_path / "saved.json")
    remade(tmp_path / "saved.json")
    by_columns = asperity.fit(SMALL, columns, {"elastomer.shear_modulus": ("1MPa", "100MPa"),
                                               "elastomer.relaxation_time": None}, profiles=False)
    assert by_columns.data["parameters"] == fit.data["parameters"]
    # A table that is no file cannot be read again.
    by_columns.save(tmp_path / "columns.json")
    assert "does not say the options" in complaint("open", tmp_path / "columns.json", "--remake")
    assert fit.correlations.shape == (2, 2)


def test_a_fit_without_data_or_keys_is_refused(measured, scene_file, tmp_path):
    columns, _ = measured
    with pytest.raises(asperity.InputError, match="no measured friction is given"):
        asperity.fit(SMALL, None, "elastomer.shear_modulus")
    with pytest.raises(asperity.InputError) as caught:
        asperity.fit(SMALL, columns, "elastomer.shear_modules")
    assert "elastomer.shear_modulus" in str(caught.value)
    with pytest.raises(asperity.InputError):
        asperity.fit(SMALL, columns, ())
    with pytest.raises(asperity.InputError):
        asperity.fit(SMALL, {"velocity": [1, 2], "mu": [0.1, "x"]}, "elastomer.shear_modulus")
    # A number holds in all rows; a list of another length is a mistake.
    with pytest.raises(asperity.InputError, match="data 1: .*: velocity 2, mu 1"):
        asperity.fit(SMALL, {"velocity": [1, 2], "mu": [0.1]}, "elastomer.shear_modulus")
    with pytest.raises(asperity.InputError, match="elastomer.shear_modulus: .* neither None"):
        asperity.fit(SMALL, columns, {"elastomer.shear_modulus": (1e6, 1e7, 1e8)})


def test_pictures_are_those_of_the_program(scene_file, tmp_path):
    values = {**SMALL, "sweep": {"points": 3}}
    curve = asperity.curve(values)
    png = curve._repr_png_()
    assert png.startswith(b"\x89PNG") and len(png) > 10000
    run("curve", scene_file(values), "--quiet", "-o", tmp_path / "c.svg")
    assert curve.picture("svg") == (tmp_path / "c.svg").read_bytes()
    assert asperity.state(values)._repr_png_().startswith(b"\x89PNG")


def test_a_refused_picture_is_bad_input(scene_file):
    curve = asperity.curve({**SMALL, "sweep": {"points": 3}})
    with pytest.raises(asperity.InputError, match="^'.bmp' is not one of"):
        curve.picture("bmp")
    with pytest.raises(asperity.InputError, match="^--sise: unknown option"):
        curve.picture("png", "--sise", "1x1")


def test_an_unknown_column_is_named_with_those_there_are():
    curve = asperity.curve({**SMALL, "sweep": {"points": 3}})
    with pytest.raises(KeyError, match="no column 'mue'; columns are velocity, mu,"):
        curve["mue"]
    assert curve.get("mue") is None and "mue" not in curve


def test_without_the_program_there_are_tables_and_no_pictures(monkeypatch):
    monkeypatch.delenv("ASPERITY_PROGRAM")
    monkeypatch.setenv("PATH", "/nonexistent")
    curve = asperity.curve({**SMALL, "sweep": {"points": 3}})
    assert curve._repr_png_() is None
    assert curve._repr_html_().count("<tr>") == 4
    with pytest.raises(FileNotFoundError, match="not installed"):
        curve.picture()


def test_a_program_that_cannot_draw_is_said_and_interrupts_nothing(monkeypatch):
    curve = asperity.curve({**SMALL, "sweep": {"points": 3}})
    monkeypatch.setenv("ASPERITY_PROGRAM", "/bin/false")
    with pytest.warns(UserWarning, match="/bin/false drew no picture"):
        assert curve._repr_png_() is None
    with pytest.raises(RuntimeError):
        curve.picture()


def test_a_picture_is_kept_until_its_scene_changes(monkeypatch):
    scene = asperity.Scene(SMALL)
    first = scene._repr_png_()
    monkeypatch.setenv("ASPERITY_PROGRAM", "/bin/false")
    assert scene._repr_png_() is first
    scene["surface.seed"] = 7
    with pytest.warns(UserWarning):
        assert scene._repr_png_() is None
