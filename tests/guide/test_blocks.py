"""Every block of commands of the page $ASPERITY_PAGE does what the page says, and each picture that
the page shows is there afterwards. Without the Python module its blocks are left out."""

import os
import re
import shutil

import blocks

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ["ASPERITY_PROGRAM"]
PAGE = os.environ["ASPERITY_PAGE"]


def prepare(folder):
    """The folder of a reader: the program, ./dev, and files under the names that pages use."""
    tools = folder / "tools"
    tools.mkdir()
    os.symlink(PROGRAM, tools / "asperity")
    # ./dev run is the program; what else it does, tests/dev looks at.
    dev = folder / "dev"
    dev.write_text(f'#!/bin/sh\ncase $1 in\n  run) shift; [ $# = 0 ] || exec "{PROGRAM}" "$@" ;;\n'
                   "  test | package) ;;\n  *) exit 2 ;;\nesac\n")
    dev.chmod(0o755)
    shutil.copy(f"{ROOT}/tests/core/measured/files/sdf-1.sdf", folder / "scan.sdf")
    shutil.copy(f"{ROOT}/resources/materials/measurements/epdm_70.csv", folder / "dma.csv")
    (folder / "measured.csv").write_text(
        "velocity (mm/s),mu,mu_error\n1,4.6e-5,4e-6\n10,4.4e-4,2e-5\n100,1.9e-3,1e-4\n1000,2.4e-3,1e-4\n")
    return {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "HOME": str(folder)}


def test_blocks_of_the_page(tmp_path):
    environment = prepare(tmp_path)
    found = blocks.blocks_of(PAGE)
    assert found or os.path.basename(PAGE) in ("speed.md", "theory.md"), "the page has no block"
    for block in found:
        if block.language == "python" and environment.get("PYTHONPATH", "") == "":
            continue
        blocks.run_block(block, tmp_path, environment)
    text = open(PAGE, encoding="utf-8").read()
    for target in re.findall(r"!\[[^\]]*\]\(([^)]*)\)", re.sub(r"```.*?```", "", text, flags=re.S)):
        beside = os.path.join(os.path.dirname(PAGE), target)
        assert os.path.exists(beside) or (tmp_path / target).exists(), f"no picture {target}"


def test_a_block_that_fails_is_noticed(tmp_path):
    """The test itself: other output, another status and a language of its own are errors."""
    environment = dict(os.environ)
    for language, text in (("console", "$ echo one\ntwo\n"), ("console", "$ false\n"),
                           ("sh", "false\ntrue\n"), ("cobol", "")):
        try:
            blocks.run_block(blocks.Block("page", 1, language, text), tmp_path, environment)
        except AssertionError:
            continue
        raise RuntimeError(f"{language}: {text} was taken for right")
    assert blocks.run_block(blocks.Block("page", 1, "console", "$ echo one\none\n"), tmp_path, environment)
