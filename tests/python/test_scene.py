"""asperity.Scene: reading, units, changes, and the program's own messages."""

import copy
import json
import pickle

import numpy as np
import pytest
from conftest import SMALL, complaint, run

import asperity


def test_defaults_are_those_of_an_empty_scene(scene_file):
    assert asperity.Scene().to_json() == asperity.Scene(scene_file({})).to_json()


def test_a_file_reads_as_the_program_reads_it(scene_file):
    file = scene_file(SMALL)
    canonical = run("open", file, "--json")
    assert json.loads(asperity.Scene(file).to_json()) == json.loads(canonical)
    assert asperity.Scene(str(file)) == asperity.Scene(SMALL)


def test_a_shipped_scene_has_its_name():
    assert "viscoelastic" in asperity.Scene("figure_1.json")["title"]
    assert asperity.Scene("figure_1") == asperity.Scene("figure_1.json")
    with pytest.raises(asperity.InputError, match="the nearest shipped scene is figure_2") as caught:
        asperity.Scene("figur_2.json")
    assert (caught.value.file, caught.value.key) == ("figur_2.json", None)
    with pytest.raises(asperity.InputError):
        asperity.Scene("no_such_scene.json")


@pytest.mark.parametrize("values", [
    {"load": {"normal_force": 0.02}},
    {"load": {"normal_force": "20mN"}},
    {"load.normal_force": "20 mN"},
    {"load.normal_force": np.float64(0.02)},
])
def test_dicts_nested_and_dotted_with_and_without_units(values):
    assert asperity.Scene(values)["load.normal_force"] == 0.02


def test_keywords_set_values_over_a_file(scene_file):
    file = scene_file({"load": {"normal_force": 1}})
    assert asperity.Scene(file, load__normal_force="20mN")["load.normal_force"] == 0.02
    assert asperity.Scene(file, load={"normal_force": 0.02})["load.normal_force"] == 0.02
    assert asperity.Scene(file, **{"load.normal_force": 0.02})["load.normal_force"] == 0.02


def test_numbers_keep_every_digit():
    for number in (0.1, 1 / 3, 1e-300 ** 0.01, 5e-7 * (1 + 2 ** -52)):
        scene = asperity.Scene({"surface.rms_height": number})
        assert scene["surface.rms_height"] == number
        scene["surface.rms_height"] = number * 2
        assert scene["surface.rms_height"] == number * 2


def test_lists_are_lists():
    arms = [{"modulus": 1e6, "relaxation_time": 1e-3}, {"modulus": 2e6, "relaxation_time": 1e-2}]
    scene = asperity.Scene(elastomer={"rheology": "prony", "equilibrium_modulus": "1MPa", "arms": arms})
    assert scene["elastomer.arms"] == arms
    scene["elastomer.arms"] = arms[:1]
    assert scene["elastomer.arms"] == arms[:1]


def test_set_changes_all_or_nothing_and_replace_copies():
    scene = asperity.Scene(SMALL)
    other = scene.replace({"surface.hurst": 0.9}, load__normal_force=1)
    assert (other["surface.hurst"], other["load.normal_force"]) == (0.9, 1)
    assert scene == asperity.Scene(SMALL)
    with pytest.raises(asperity.InputError):
        scene.set({"load.normal_force": 1, "surface.hurst": 7})
    assert scene == asperity.Scene(SMALL)
    scene.set("load.normal_force", "1 N")
    assert scene["load.normal_force"] == 1


def test_a_kind_that_changes_drops_what_has_no_meaning():
    scene = asperity.Scene({"surface": {"hurst": 0.5}})
    scene["surface.kind"] = "sine"
    assert "surface.hurst" not in scene and scene.get("surface.hurst") is None
    assert scene["surface.waves"] == 8
    with pytest.raises(asperity.InputError, match="has no meaning"):
        scene["surface.hurst"]


def test_it_is_a_mapping_that_copies_and_pickles(tmp_path):
    scene = asperity.Scene(SMALL)
    assert dict(scene)["surface.elements"] == 400
    for same in (copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene)),
                 asperity.Scene(scene.to_dict()), asperity.Scene.from_json(scene.to_json())):
        assert same == scene and isinstance(same, asperity.Scene)
    scene.save(tmp_path / "s.json")
    assert asperity.Scene(tmp_path / "s.json") == scene
    assert scene != 1 and scene != asperity.Scene()


# Each is refused by the program as a scene file; the module says the same, word for word.
WRONG = [
    {"surface": {"hurst": 1.4}},
    {"surface": {"hurts": 0.7}},
    {"surfaces": {"hurst": 0.7}},
    {"surface": {"kind": "sines"}},
    {"surface": {"kind": "sine", "hurst": 0.7}},
    {"load": {"normal_force": [1]}},
    {"load": {"normal_force": None}},
    {"load": {"normal_force": True}},
    {"load": 3},
    {"schema": "asperity-scene/2"},
    {"surface": {"elements": 2.5}},
    {"surface": {"kind": "profile"}},
    {"sweep": {"velocity_from": 1, "velocity_to": 0.1}},
    {"elastomer": {"rheology": "prony", "equilibrium_modulus": 1e6, "arms": [{"modulus": -1}]}},
    {"elastomer": {"material": "no_such_rubber"}},
    {"accuracy": {"scheme": "cubic", "target_relative_error": 0.01}},
]


@pytest.mark.parametrize("values", WRONG, ids=json.dumps)
def test_bad_input_has_the_programs_message(values, scene_file):
    file = scene_file(values)
    said = complaint("check", file)
    with pytest.raises(asperity.InputError) as of_dict:
        asperity.Scene(values)
    assert said == f"{file}: {of_dict.value}" or str(of_dict.value) == said
    with pytest.raises(asperity.InputError) as of_file:
        asperity.Scene(file)
    assert str(of_file.value) == said


def test_the_error_has_its_parts(scene_file):
    file = scene_file({"surface": {"hurst": 1.4}})
    with pytest.raises(ValueError) as caught:
        asperity.Scene(file)
    error = caught.value
    assert isinstance(error, asperity.InputError)
    assert (error.file, error.key) == (str(file), "surface.hurst")
    assert error.message == "1.4 is outside 0 to 1"
    assert str(error) == f"{file}: surface.hurst: 1.4 is outside 0 to 1"


@pytest.mark.parametrize("value", ["20 kg", "1.4", "", "nan", float("nan"), float("inf"), "x", None, [], {}])
def test_wrong_values_of_a_key_are_refused(value):
    scene = asperity.Scene()
    before = scene.to_json()
    for change in (lambda: scene.set("surface.hurst", value), lambda: asperity.Scene({"surface.hurst": value}),
                   lambda: asperity.Scene(surface__hurst=value)):
        with pytest.raises(asperity.InputError) as caught:
            change()
        assert caught.value.key == "surface.hurst"
    assert scene.to_json() == before


def test_a_key_given_twice_is_refused():
    with pytest.raises(asperity.InputError, match="twice"):
        asperity.Scene({"load": {"normal_force": 1}, "load.normal_force": 2})


def test_the_table_of_parameters_describes_every_key():
    rows = {row["key"]: row for row in asperity.parameters()}
    assert set(asperity.Scene().keys()) <= set(rows)
    assert rows["load.normal_force"]["unit"] == "N" and rows["surface.hurst"]["allowed"] == "0 to 1"
    assert all(row["meaning"] for row in rows.values())


def test_the_scene_of_a_result_is_found(tmp_path, scene_file):
    file = scene_file(SMALL)
    run("curve", file, "-o", tmp_path / "c.csv", "--quiet")
    assert asperity.Scene.from_result(tmp_path / "c.csv") == asperity.Scene(SMALL)


def test_a_scene_that_was_never_made_cannot_crash():
    # Debuggers and test reports show objects whose making has failed.
    empty = asperity.Scene.__new__(asperity.Scene)
    for use in (repr, str, dict, copy.copy, asperity.curve, asperity.state):
        with pytest.raises(AttributeError):
            use(empty)
