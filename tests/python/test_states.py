"""One contact as views, and many states in one call."""

import gc
import time

import numpy as np
import pytest
from conftest import SMALL, complaint, run, table_of

import asperity


# ---- one contact

def test_the_contact_obeys_the_model():
    contact = asperity.state(SMALL)
    scene = contact.scene
    touches = contact.p > 0
    # Eqs. (1) and (2) of Li et al.: no penetration, no tension, and u = z - d in contact.
    assert np.all(contact.p >= 0) and np.all(contact.gap >= 0)
    assert np.all(contact.gap[touches] == 0)
    np.testing.assert_allclose(contact.u[touches], contact.z[touches], rtol=1e-9)
    assert np.all(contact.gap[~touches] >= -1e-12 * np.max(contact.gap))
    # Eq. (3): the line load adds up to the force, to the error of a sum over points.
    assert contact.normal_force == pytest.approx(scene["load.normal_force"], rel=1e-9)
    assert np.sum(contact.p) * contact.spacing == pytest.approx(contact.normal_force, rel=0.05)
    assert contact.mu == pytest.approx(contact.tangential_force / contact.normal_force, rel=1e-12)
    # The lowest point of the line lies between two of its points.
    assert -contact.indentation <= contact.z.min() <= -0.95 * contact.indentation
    assert contact.x[-1] == pytest.approx(contact.length - contact.spacing)
    assert np.all(contact.time_since_contact[touches] == 0)


def test_the_contact_is_that_of_a_figure_of_the_program(tmp_path):
    # Figure 1 writes the shape of its contact; its points are those of a stated oversampling.
    run("figure", "1", "-o", tmp_path, "--quiet", "--set", "accuracy.oversampling=2")
    name = next(path for path in tmp_path.rglob("*.csv"))
    rows = [line.split(",") for line in name.read_text().splitlines() if not line.startswith("#")]
    scene = asperity.Scene.from_result(name)
    contact = asperity.state(scene)
    for column, values in {"position": contact.x, "line_height": contact.z, "surface_height": contact.u,
                           "pressure": contact.p}.items():
        place = rows[0].index(column)
        expected = np.array([float(row[place]) for row in rows[1:]])
        if column == "line_height":  # z - d, rounded twice or once
            np.testing.assert_allclose(values, expected, rtol=1e-12, atol=1e-15 * contact.indentation)
        else:
            np.testing.assert_array_equal(values, expected, err_msg=column)


def test_realizations_differ_and_a_single_line_has_one():
    assert asperity.state(SMALL).mu != asperity.state(SMALL, realization=1).mu
    for wrong in (-1, 1):
        with pytest.raises(asperity.InputError) as caught:
            asperity.state({"surface": {"kind": "sine"}}, realization=wrong)
        assert caught.value.key == "realization"


def test_arrays_are_views_that_outlive_the_contact():
    contact = asperity.state(SMALL)
    first, second = contact.p, contact.p
    assert first.__array_interface__["data"] == second.__array_interface__["data"]  # no copy
    assert not first.flags.writeable and not first.flags.owndata
    with pytest.raises(ValueError):
        first[0] = 1
    kept = first.copy()
    piece = first[3:50:2]
    del contact, first, second
    gc.collect()
    for _ in range(20):
        asperity.state(SMALL, realization=2)  # would use the memory again
    np.testing.assert_array_equal(piece, kept[3:50:2])


def test_the_columns_of_a_table_outlive_it():
    mu = asperity.curve(SMALL).mu
    kept = mu.copy()
    gc.collect()
    asperity.curve({**SMALL, "surface": {"seed": 9, "elements": 400}})
    np.testing.assert_array_equal(mu, kept)


# ---- many states

def test_overrides_are_the_curves_of_the_changed_scenes():
    forces = np.geomspace(1e-3, 1, 5)
    table = asperity.friction(SMALL, {"load.normal_force": forces})
    assert list(table)[:3] == ["load.normal_force", "velocity", "mu"]
    for force, mu, depth in zip(forces, table.mu, table.indentation):
        scene = asperity.Scene(SMALL, load={"normal_force": force},
                               sweep={"velocity_from": 1, "velocity_to": 1, "points": 1})
        curve = asperity.curve(scene)
        assert mu == pytest.approx(curve.mu[0], rel=1e-7)
        assert depth == pytest.approx(curve.indentation[0], rel=1e-7)


def test_overrides_are_broadcast():
    table = asperity.friction(SMALL, {"sliding.velocity": np.geomspace(0.1, 10, 4)[:, np.newaxis],
                                      "elastomer.shear_modulus": [5e6, "10MPa", 2e7]})
    assert table.shape == (4, 3) == table.mu.shape == table["sliding.velocity"].shape
    assert table["elastomer.shear_modulus"][2, 1] == 1e7
    one = asperity.friction(SMALL, sliding__velocity=10.0, elastomer__shear_modulus="20 MPa")
    assert one.shape == () and one.mu == pytest.approx(table.mu[3, 2], rel=1e-9)
    assert table.units["elastomer.shear_modulus"] == "Pa" and table.units["indentation"] == "m"


def test_numbers_of_threads_are_those_of_the_program():
    for call in (asperity.curve, asperity.friction, asperity.march, asperity.sensitivity):
        for threads in (-1, 1025):
            with pytest.raises(asperity.InputError) as caught:
                call(SMALL, threads=threads)
            assert caught.value.key == "threads"


def test_threads_do_not_change_a_bit():
    overrides = {"load.normal_force": np.geomspace(1e-3, 1, 40)}
    one = asperity.friction(SMALL, overrides, threads=1)
    for threads in (2, 3, 0):
        np.testing.assert_array_equal(asperity.friction(SMALL, overrides, threads=threads).mu, one.mu)


def test_a_map_has_the_states_of_its_cells():
    cells = asperity.map(SMALL, "load.normal_force=1mN:1N:3", ("sliding.velocity", [0.1, 1]))
    assert cells.mu.shape == (2, 3)
    np.testing.assert_allclose(cells["load.normal_force"][0], [1e-3, np.sqrt(1e-3), 1], rtol=1e-12)
    np.testing.assert_array_equal(cells["sliding.velocity"][:, 0], [0.1, 1])
    table = asperity.friction(SMALL, {"load.normal_force": cells["load.normal_force"][1], "sliding.velocity": 1})
    np.testing.assert_allclose(cells.mu[1], table.mu, rtol=1e-8)


def test_a_map_is_the_programs(scene_file, tmp_path):
    sides = "load.normal_force=0.001:1:12", "sliding.velocity=0.1:10:7"
    run("map", scene_file(SMALL), "--x", sides[0], "--y", sides[1], "--quiet", "-o", tmp_path / "m.csv", "-o",
        tmp_path / "m.json")
    cells = asperity.map(SMALL, *sides)
    assert cells.mu.shape == (7, 12) == (len(cells.y), len(cells.x))
    assert cells.to_csv() == (tmp_path / "m.csv").read_text()
    assert cells.to_json() == (tmp_path / "m.json").read_text()
    columns = table_of((tmp_path / "m.csv").read_text())
    for name in ("normal_force", "velocity", "mu", "mu_standard_error", "contact_fraction", "indentation"):
        key = "load.normal_force" if name == "normal_force" else name
        assert cells[key].ravel().tolist() == [float(cell) for cell in columns[name]], name


def test_lists_and_ranges_make_the_same_map():
    by_range = asperity.map(SMALL, "load.normal_force=1mN:1N:4", "sliding.velocity=0.1:10:3")
    by_list = asperity.map(SMALL, ("load.normal_force", by_range.x), ("sliding.velocity", by_range.y.tolist()))
    assert list(by_list) == list(by_range)
    np.testing.assert_array_equal(by_list.mu, by_range.mu)
    np.testing.assert_array_equal(by_list["sliding.velocity"], by_range["sliding.velocity"])


@pytest.mark.parametrize("overrides, key", [
    ({"load.normal_forces": 1.0}, "load.normal_forces"),
    ({"load.normal_force": [1.0, -1.0]}, "load.normal_force"),
    ({"surface.hurst": np.array([0.5, 1.5])}, "surface.hurst"),
    ({"surface.kind": "sine"}, "surface.kind"),
    ({"load.depth": 1e-6}, "load.depth"),
    ({"surface.elements": [100, 100.5]}, "surface.elements"),
    ({"load.normal_force": [np.nan]}, "load.normal_force"),
    ({"load.normal_force": "3 kg"}, "load.normal_force"),
    ({"load.normal_force": []}, "load.normal_force"),
])
def test_wrong_overrides_name_their_key(overrides, key):
    with pytest.raises(asperity.InputError) as caught:
        asperity.friction(SMALL, overrides)
    assert caught.value.key == key


def test_complex_values_are_refused():
    key = "load.normal_force"
    for value in (1e-3 + 2e-3j, np.array([1e-3, 2e-3j]), [np.complex64(1e-3)],
                  np.array([1e-3, np.complex64(2e-3j)], dtype=object)):
        for call in (lambda: asperity.friction(SMALL, {key: value}),
                     lambda: asperity.map(SMALL, (key, np.atleast_1d(value)),
                                          "sliding.velocity=1:2:2")):
            with pytest.raises(asperity.InputError) as caught:
                call()
            assert str(caught.value) == f"{key}: is complex; a real number is needed"


def test_too_many_states_are_refused_before_they_are_made():
    with pytest.raises(asperity.InputError, match="more than 200000"):
        asperity.friction(SMALL, {"load.normal_force": np.linspace(1e-3, 1, 200001)})
    with pytest.raises(asperity.InputError, match="more than 100000 cells"):
        asperity.map(SMALL, "load.normal_force=1mN:1N:1000", "sliding.velocity=1:2:1000")


def test_wrong_sides_of_a_map():
    for x in ("load.normal_force", "load.normal_force=1:2", ("load.normal_force", "1:2:0"),
              ("load.normal_force", 1.0), ("surface.file", "1:2:3")):
        with pytest.raises(asperity.InputError):
            asperity.map(SMALL, x, ("sliding.velocity", [1, 2]))
    with pytest.raises(asperity.InputError, match="both sides"):
        asperity.map(SMALL, ("sliding.velocity", [1, 2]), ("sliding.velocity", [1, 2]))


def test_sensitivities_are_those_of_the_program(scene_file, tmp_path):
    file = scene_file(SMALL)
    run("sensitivity", file, "--quiet", "-o", tmp_path / "s.csv", "-o", tmp_path / "s.json")
    table = asperity.sensitivity(SMALL)
    assert table.to_csv() == (tmp_path / "s.csv").read_text()
    assert table.to_json() == (tmp_path / "s.json").read_text()
    columns = table_of((tmp_path / "s.csv").read_text())
    for name, cells in columns.items():
        assert table[name].tolist() == [cell if name == "key" else float(cell) for cell in cells]
    target = {**SMALL, "accuracy": {"target_relative_error": 0.1}}
    with pytest.raises(asperity.InputError) as caught:
        asperity.sensitivity(target)
    assert complaint("sensitivity", scene_file(target)).endswith(str(caught.value))


def test_sensitivities_are_slopes_of_friction_on_the_same_lines():
    table = asperity.sensitivity(SMALL)
    slopes = dict(zip(table["key"].tolist(), table.slope.tolist()))
    scene = asperity.Scene(SMALL)
    oversampling = scene["accuracy.oversampling"]
    assert oversampling == 0  # chosen, and held while a parameter changes
    h = 1e-3
    for key in ("load.normal_force", "elastomer.relaxation_time"):
        values = scene[key] * np.exp([-h, h])
        low, high = asperity.friction(SMALL, {key: values}).mu
        assert slopes[key] == pytest.approx(np.log(high / low) / (2 * h), rel=2e-3)
    # Friction in units of h depends on F_N/(G h) alone: mu = h f(F_N/(G h)).
    assert slopes["surface.rms_height"] + slopes["load.normal_force"] == pytest.approx(1, abs=1e-3)
    assert slopes["elastomer.shear_modulus"] == pytest.approx(-slopes["load.normal_force"], abs=1e-3)
    assert np.all(table.slope_standard_error > 0) and table.is_logarithmic.any()


def test_a_thousand_overrides_cost_what_the_kernel_costs():
    scene = asperity.Scene(ensemble={"realizations": 5})
    forces = np.geomspace(1e-3, 1, 1000)
    asperity.friction(scene, {"load.normal_force": forces[:10]})  # numpy, threads
    begin = time.process_time()
    table = asperity.friction(scene, {"load.normal_force": forces}, threads=1)
    whole = time.process_time() - begin
    assert table.computed == 1000
    assert whole <= 1.2 * table.kernel_seconds, (whole, table.kernel_seconds)
