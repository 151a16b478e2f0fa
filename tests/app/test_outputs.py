"""Fonts, EPS, TIFF, columns and chart options as a user meets them on the command line."""

import csv
import json
import os
import re
import shutil
import struct
import subprocess

import pytest

PROGRAM = os.environ["ASPERITY_PROGRAM"]
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DMA = f"{ROOT}/resources/materials/measurements/epdm_70.csv"
CURVE = ["curve", "figure_2.json", "--set", "ensemble.realizations=3", "--set", "sweep.points=9"]
DATA = "velocity (mm/s),mu,mu_error\n1,4.6e-5,4e-6\n10,4.4e-4,2e-5\n100,1.9e-3,1e-4\n"


def run(folder, *arguments, environment=None):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True,
                          timeout=200, check=False, env=environment)


def made(folder, *arguments):
    done = run(folder, *arguments)
    assert done.returncode == 0, done.stderr
    return done


def refused(folder, *arguments, says, environment=None):
    before = sorted(os.listdir(folder))
    done = run(folder, *arguments, environment=environment)
    assert done.returncode == 2, done.stderr
    assert done.stderr.count("\n") == 1 and says in done.stderr, done.stderr
    assert sorted(os.listdir(folder)) == before


def columns_of(path):
    lines = [line for line in open(path, encoding="utf-8") if not line.startswith("#")]
    return next(csv.reader(lines))


# ---- TIFF


def tags_of(path):
    """The tags of a TIFF's first image: {number: (type, count, value)}; values that fit alone."""
    data = open(path, "rb").read()
    assert data[:4] == b"II*\0"
    (place,) = struct.unpack_from("<I", data, 4)
    (count,) = struct.unpack_from("<H", data, place)
    tags = {}
    for i in range(count):
        tag, kind, number, value = struct.unpack_from("<HHII", data, place + 2 + 12 * i)
        if kind == 2 and number > 4:
            value = data[value:value + number - 1].decode("ascii")
        elif kind == 5:
            value = struct.unpack_from("<II", data, value)
        elif kind == 3 and number == 1:
            value &= 0xFFFF
        tags[tag] = value
    return tags


def test_tiff_has_the_size_on_paper_and_its_scene(tmp_path):
    made(tmp_path, *CURVE, "--size", "86mmx60mm", "--dpi", "600", "-o", "a.tif", "-o", "a.png")
    tags = tags_of(tmp_path / "a.tif")
    assert (tags[256], tags[257]) == (2031, 1417)  # 86 and 60 mm at 600 dpi
    assert tags[282][0] == 600 * tags[282][1] and tags[296] == 2
    assert tags[277] == 3 and tags[259] == 5  # RGB, LZW
    assert tags[270].startswith('asperity: {"schema":"asperity-curve/1"')
    assert json.loads(made(tmp_path, "open", "a.tif", "--json").stdout) == json.loads(
        made(tmp_path, "open", "a.png", "--json").stdout)


def test_tiff_is_the_png_pixel_by_pixel(tmp_path):
    convert = shutil.which("convert")
    if convert is None:
        pytest.skip("ImageMagick is missing")
    for options in ([], ["--transparent"]):
        made(tmp_path, *CURVE, *options, "--size", "400x300", "-o", "a.tiff", "-o", "a.png")
        pixels = [subprocess.run([convert, name, "-depth", "8", "rgba:-"], cwd=tmp_path,
                                 capture_output=True, check=True).stdout for name in ("a.tiff", "a.png")]
        # Where nothing is seen, the colour below may differ.
        assert len(pixels[0]) == 400 * 300 * 4
        different = sum(pixels[0][i:i + 4] != pixels[1][i:i + 4] and pixels[1][i + 3] != 0
                        for i in range(0, len(pixels[0]), 4))
        assert different == 0


def test_tiff_and_eps_are_made_again(tmp_path):
    for name in ("a.tif", "a.eps"):
        if name == "a.eps" and shutil.which("pdftops") is None:
            continue
        made(tmp_path, *CURVE, "--style", "journal", "-o", name)
        first = (tmp_path / name).read_bytes()
        made(tmp_path, "open", name, "--remake", "-o", "b" + name)
        assert (tmp_path / ("b" + name)).read_bytes() == first


# ---- EPS


def test_eps_without_its_tool(tmp_path):
    refused(tmp_path, *CURVE, "-o", "a.eps", says="poppler-utils",
            environment={**os.environ, "PATH": "/nonexistent"})


# ---- fonts


def installed(family):
    listed = subprocess.run(["fc-list", ":", "family"], capture_output=True, text=True,
                            check=False).stdout
    return any(family in line.split(",") for line in listed.splitlines())


serif = pytest.mark.skipif(not shutil.which("fc-list") or not installed("DejaVu Serif"),
                           reason="the font DejaVu Serif is missing")


@serif
def test_another_font_is_in_the_files_alone(tmp_path):
    made(tmp_path, *CURVE, "--font", "dejavu serif", "--style", "journal", "-o", "a.pdf", "-o",
         "a.svg", "-o", "a.png")
    fonts = subprocess.run(["pdffonts", "a.pdf"], cwd=tmp_path, capture_output=True, text=True,
                           check=True).stdout.splitlines()[2:]
    assert any("DejaVuSerif" in line for line in fonts)
    assert all(" yes " in line for line in fonts)
    svg = (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert 'text{font-family:"DejaVu Serif","DejaVu Sans"' in svg
    assert '@font-face{font-family:"DejaVu Serif"' in svg
    made(tmp_path, *CURVE, "--style", "journal", "-o", "b.png")
    assert (tmp_path / "a.png").read_bytes() != (tmp_path / "b.png").read_bytes()


@serif
def test_a_font_is_kept_for_the_next_time(tmp_path):
    made(tmp_path, *CURVE, "--font", "DejaVu Serif", "-o", "a.svg")
    made(tmp_path, "open", "a.svg", "--remake", "-o", "b.svg")
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_the_usual_font_by_its_name_changes_nothing(tmp_path):
    made(tmp_path, *CURVE, "-o", "a.svg")
    made(tmp_path, *CURVE, "--font", "DejaVu Sans", "-o", "b.svg")
    strip = lambda name: re.sub(r"<metadata>.*?</metadata>", "",
                                (tmp_path / name).read_text(encoding="utf-8"), flags=re.S)
    assert strip("a.svg") == strip("b.svg")


@serif
def test_an_unknown_font_names_the_nearest(tmp_path):
    refused(tmp_path, *CURVE, "--font", "DejaVu Seriff", "-o", "a.pdf",
            says="no font family 'DejaVu Seriff' is installed; did you mean 'DejaVu Serif'?")
    refused(tmp_path, *CURVE, "--font", "Zzzzzzzzzzzzzzzzzzzz", "-o", "a.pdf", says="fc-list")


def test_a_font_is_of_pictures(tmp_path):
    refused(tmp_path, *CURVE, "--font", "DejaVu Serif", "-o", "a.csv", says="belongs to pictures")


# ---- columns


def test_columns_of_a_map(tmp_path):
    wanted = ["normal_force", "velocity", "mu"]
    map_ = ["map", "figure_2.json", "--set", "ensemble.realizations=1", "--x",
            "sliding.velocity=0.01:1:3", "--y", "load.normal_force=1mN:1N:3"]
    made(tmp_path, *map_, "--columns", ",".join(wanted), "-o", "a.csv", "-o", "a.json")
    made(tmp_path, *map_, "-o", "all.csv")
    assert columns_of(tmp_path / "a.csv") == wanted
    points = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))["points"]
    assert len(points) == 9 and all(list(point) == wanted for point in points)
    rows = [list(csv.DictReader(line for line in open(tmp_path / name, encoding="utf-8")
                                if not line.startswith("#"))) for name in ("a.csv", "all.csv")]
    assert [row["mu"] for row in rows[0]] == [row["mu"] for row in rows[1]]
    refused(tmp_path, *map_, "--columns", "muu", "-o", "b.csv", says="did you mean 'mu'?")


def test_columns_of_several_tables(tmp_path):
    """Each table has those columns that are its own."""
    made(tmp_path, "figure", "2", "6", "--realizations", "2", "--set", "surface.elements=300",
         "--columns", "mu,velocity,plateau", "-o", "f")
    assert columns_of(tmp_path / "f/figure_2.csv") == ["mu", "velocity"]
    assert columns_of(tmp_path / "f/figure_6.csv") == ["plateau"]
    made(tmp_path, "material", DMA, "--columns", "temperature,frequency", "-o", "m")
    assert columns_of(tmp_path / "m/isotherms.csv") == ["temperature", "frequency"]
    refused(tmp_path, "figure", "2", "--columns", "plateau", "-o", "g", says="'plateau' is not a column")


def test_columns_of_fit_accuracy_and_batch(tmp_path):
    (tmp_path / "measured.csv").write_text(DATA)
    made(tmp_path, "fit", "figure_2.json", "--set", "ensemble.realizations=3", "--data",
         "measured.csv", "--vary", "elastomer.relaxation_time", "--columns", "mu_measured,velocity",
         "-o", "fit")
    assert columns_of(tmp_path / "fit/fit.csv") == ["mu_measured", "velocity"]
    made(tmp_path, "accuracy", "figure_2.json", "--set", "surface.elements=300", "--set",
         "ensemble.realizations=2", "--columns", "region,method,relative_error", "-o", "accuracy")
    assert columns_of(tmp_path / "accuracy/accuracy.csv") == ["region", "method", "relative_error"]
    (tmp_path / "batch.json").write_text(json.dumps(
        {"schema": "asperity-batch/1", "entries": [
            {"name": "one", "scene": "figure_2.json", "show": "curve",
             "set": {"ensemble.realizations": 2, "sweep.points": 5}}]}))
    made(tmp_path, "batch", "batch.json", "--columns", "name,mu", "--regions", "off", "--legend",
         "none", "-o", "b")
    assert columns_of(tmp_path / "b/results.csv") == ["name", "mu"]
    made(tmp_path, "batch", "batch.json", "-o", "c")
    assert (tmp_path / "b/one.png").read_bytes() != (tmp_path / "c/one.png").read_bytes()


def test_chart_options_of_a_batch_without_a_chart(tmp_path):
    (tmp_path / "batch.json").write_text(json.dumps(
        {"schema": "asperity-batch/1",
         "entries": [{"name": "one", "scene": "figure_1.json", "show": "contact"}]}))
    refused(tmp_path, "batch", "batch.json", "--regions", "off", "-o", "b",
            says="no entry of the batch shows one")


@pytest.mark.parametrize("name", [file.removesuffix(".json")
                                  for file in sorted(os.listdir(f"{ROOT}/resources/materials"))
                                  if file.endswith(".json")])
def test_a_shipped_material_is_what_the_program_makes_of_its_measurement(name, tmp_path):
    with open(f"{ROOT}/resources/materials/{name}.json", encoding="utf-8") as file:
        shipped = json.load(file)
    made(tmp_path, "material", f"{os.path.dirname(DMA)}/{name}.csv", "-o", "m",
         "--name", shipped["name"], "--source", shipped["source"])
    again = json.loads((tmp_path / "m/material.json").read_text(encoding="utf-8"))
    assert again["measurement"]["facts"] == shipped["measurement"]["facts"]
    for now, then in [*zip(again["arms"], shipped["arms"], strict=True),
                      *zip(again["measurement"]["shifts"], shipped["measurement"]["shifts"], strict=True)]:
        assert now == pytest.approx(then)
