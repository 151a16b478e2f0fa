"""Every kind of figure at the widths of one and of two columns of a journal, as its PDF says it: the
width that was asked for, fonts inside, no letter below 6 pt, none outside of the page, nothing left
out or shortened. The sizes of letters are those of the boxes that pdftotext gives: a font's box is
as high as its ascent and descent together."""

import os
import re
import shutil
import subprocess

import pytest

PROGRAM = os.environ["ASPERITY_PROGRAM"]
RESOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../resources")
SURFACE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../core/measured/files/sdf-1.sdf")
DMA = f"{RESOURCES}/materials/measurements/epdm_70.csv"

FEW = ["--set", "ensemble.realizations=4"]
DATA = "velocity (mm/s),mu,mu_error\n1,4.6e-5,4e-6\n10,4.4e-4,2e-5\n100,1.9e-3,1e-4\n1000,2.4e-3,1e-4\n"
ONE_FILE = {
    "curve": ["curve", "figure_2.json", *FEW],
    "several curves": ["curve", "figure_2.json", *FEW, "--with", "surface.hurst=0.5", "--with",
                       "surface.hurst=0.9"],
    "data": ["curve", "figure_2.json", *FEW, "--data", "measured.csv", "--theory",
             "eq_11,complete_contact"],
    "difference": ["curve", "figure_2.json", *FEW, "--compare", "linear:2"],
    "over": ["curve", "figure_2.json", *FEW, "--over", "load.normal_force=1mN:10N:9"],
    "map": ["map", "figure_2.json", "--set", "ensemble.realizations=1", "--x",
            "sliding.velocity=1e-5:1e3:16", "--y", "load.normal_force=1mN:10N:16"],
    "contact": ["render", "figure_1.json"],
    "contact in tints": ["render", "figure_1.json", "--theme", "paper"],
    "contact and curve": ["render", "figure_1.json", *FEW, "--layout", "both"],
    "contact and strips": ["render", "start.json", "--layout", "transient"],
    "motion": ["motion", "reversal.json"],
    "line": ["surface", "figure_1.json"],
    "measured surface": ["surface", SURFACE],
    "cut-off": ["cutoff", "figure_2.json", *FEW],
    "sensitivity": ["sensitivity", "figure_2.json", *FEW],
}
FOLDERS = {
    "figures": ["figure", "1", "3", "4", "5", "6", "master", "spacing", "--realizations", "2"],
    # Its curve of the paper's algorithm takes more time than all the others.
    "figure 2": ["figure", "2", "--realizations", "2", "--set", "surface.elements=1000"],
    "fit": ["fit", "figure_2.json", *FEW, "--data", "measured.csv", "--vary", "surface.rms_height",
            "--vary", "elastomer.relaxation_time"],
    "material": ["material", DMA],
    "accuracy": ["accuracy", "figure_2.json", "--set", "ensemble.realizations=2", "--set",
                 "surface.elements=500"],
}
SIZES = ("86mmx60mm", "178mmx90mm")
BOX = 1.1641  # height of the box of DejaVu Sans, in sizes of the font
LEAST = 6.0   # pt


def check(pdf, size):
    width = float(size.split("mm")[0])
    info = subprocess.run(["pdfinfo", pdf], capture_output=True, text=True, check=True).stdout
    page = [float(number) for number in re.search(r"Page size: +([\d.]+) x ([\d.]+)", info).groups()]
    assert page[0] == pytest.approx(width / 25.4 * 72, abs=0.6), f"{pdf}: {page[0]} pt wide"
    assert page[1] < 3.1 * page[0], f"{pdf} is {page[1]} pt high"
    fonts = subprocess.run(["pdffonts", pdf], capture_output=True, text=True, check=True).stdout
    lines = fonts.splitlines()[2:]
    assert lines, f"{pdf} has no letters"
    for line in lines:
        assert re.search(r" yes (yes|no) +yes ", line), f"{pdf}: {line}"  # embedded, with Unicode
    boxes = subprocess.run(["pdftotext", "-bbox", pdf, "-"], capture_output=True, text=True,
                           check=True).stdout
    words = re.findall(r'<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">'
                       r"(.*?)</word>", boxes)
    assert len(words) > 5, f"{pdf}: {words}"
    for *edges, word in words:
        left, top, right, bottom = (float(edge) for edge in edges)
        assert "\u2026" not in word, f"{pdf}: {word} is shortened"
        assert left > -0.5 and top > -2 and right < page[0] + 0.5 and bottom < page[1] + 2, \
            f"{pdf}: {word} is at the edge"
        # A short word may be as wide as high, so that nobody can tell how it is turned.
        sides = sorted((right - left, bottom - top))
        if len(word) <= 3:
            height = sides[1]
        else:
            height = right - left if bottom - top > 2 * (right - left) else bottom - top
        assert height / BOX > LEAST - 0.15 or len(word) == 1, f"{pdf}: {word}, {height / BOX} pt"
    text = " ".join(word for *_, word in words)
    assert not re.search(r"\band \d+ more\b", text), f"{pdf}: the legend is not whole: {text}"


def run(arguments, folder):
    done = subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True,
                          timeout=250, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("kind", ONE_FILE)
def test_figure(kind, size, tmp_path):
    (tmp_path / "measured.csv").write_text(DATA)
    run([*ONE_FILE[kind], "--style", "journal", "--size", size, "-o", "figure.pdf"], tmp_path)
    check(tmp_path / "figure.pdf", size)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("kind", FOLDERS)
def test_figures_of_a_folder(kind, size, tmp_path):
    (tmp_path / "measured.csv").write_text(DATA)
    run([*FOLDERS[kind], "--style", "journal", "--size", size, "-o", "out"], tmp_path)
    made = sorted((tmp_path / "out").glob("*.pdf"))
    assert made
    for pdf in made:
        check(pdf, size)


def test_tables_open_elsewhere(tmp_path):
    """With Python's own reader, and with pandas as the guide says."""
    import csv

    run(["curve", "figure_2.json", *FEW, "-o", "curve.csv"], tmp_path)
    text = (tmp_path / "curve.csv").read_text(encoding="utf-8")
    body = text[text.index("\n") + 1:]
    assert text.startswith("# asperity: {")
    dialect = csv.Sniffer().sniff(body)
    assert dialect.delimiter == ","
    rows = list(csv.reader(body.splitlines(), dialect))
    assert len({len(row) for row in rows}) == 1 and rows[0][:2] == ["velocity", "mu"]
    pandas = pytest.importorskip("pandas")
    frame = pandas.read_csv(tmp_path / "curve.csv", comment="#", float_precision="round_trip")
    assert list(frame.columns) == rows[0]
    assert [float(row[1]) for row in rows[1:]] == list(frame["mu"])


@pytest.mark.skipif(shutil.which("pdftops") is None, reason="pdftops is missing")
def test_eps_is_as_large_as_the_pdf(tmp_path):
    run(["curve", "figure_2.json", *FEW, "--style", "journal", "-o", "a.eps"], tmp_path)
    eps = (tmp_path / "a.eps").read_text(encoding="latin-1")
    assert eps.startswith("%!PS-Adobe-3.0 EPSF")
    assert re.search(r"^%%BoundingBox: 0 0 244 17[56]$", eps, flags=re.M)
    assert "DejaVuSans" in eps and "CreationDate" not in eps
    assert max(len(line) for line in eps.splitlines() if line.startswith("%asperity")) <= 255
