"""The fenced blocks of a page of Markdown.

Conventions of README and guide: `sh` blocks are run as they stand, one after the other in one folder;
in a `console` block lines that begin with "$ " are commands and the others are exactly what they
print; `python` is run, `make` is the Makefile of the folder and makes its first target. Blocks of other
programs are run where these are installed. Any other language is an error of the page.
"""

import os
import re
import shutil
import subprocess

# Programs that a page may show, and how a block of theirs is run: None where the block is only text.
OTHERS = {"r": ["Rscript", "-"], "snakemake": ["snakemake", "--cores", "1", "scene.pdf", "-s", "-"],
          "latex": None, "markdown": None, "json": None, "text": None}
LONGEST = 300  # s, of one block


class Block:
    def __init__(self, page, line, language, text):
        self.place, self.language, self.text = f"{page}:{line}", language, text


def blocks_of(path):
    """All blocks of a page, in order."""
    blocks, language, start, lines = [], None, 0, []
    for number, line in enumerate(open(path, encoding="utf-8"), 1):
        if language is None and line.startswith("```"):
            words = re.findall(r"[a-z]+", line)
            language, start, lines = (words[0] if words else ""), number, []
        elif language is not None and line.rstrip() == "```":
            blocks.append(Block(os.path.basename(path), start, language, "".join(lines)))
            language = None
        elif language is not None:
            lines.append(line)
    assert language is None, f"{path}:{start}: the block has no end"
    return blocks


def run(words, folder, environment, text=""):
    return subprocess.run(words, cwd=folder, env=environment, input=text, timeout=LONGEST, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)


def run_console(block, folder, environment):
    """Each command prints what the page says it prints, and succeeds."""
    parts = re.split(r"^\$ (.*)\n", block.text, flags=re.M)
    assert parts[0] == "", f"{block.place}: a console block begins with a command"
    for command, expected in zip(parts[1::2], parts[2::2]):
        done = run(["bash", "-c", command], folder, environment)
        assert done.returncode == 0, f"{block.place}: {command}: {done.stdout}"
        assert done.stdout == expected, f"{block.place}: {command} printed\n{done.stdout}"


def run_block(block, folder, environment):
    """Runs a block. Returns whether it was run; asserts that it succeeds."""
    if block.language == "console":
        run_console(block, folder, environment)
        return True
    if block.language == "sh":
        words, text = ["bash", "-eu", "-o", "pipefail", "-c", block.text], ""
    elif block.language == "python":
        words, text = [environment["PYTHON"], "-B", "-"], block.text
    elif block.language == "make":
        words, text = ["make", "-f", "-"], block.text
    else:
        assert block.language in OTHERS, f"{block.place}: what is '{block.language}'?"
        words, text = OTHERS[block.language], block.text
        if words is None or shutil.which(words[0]) is None:
            return False
    done = run(words, folder, environment, text)
    assert done.returncode == 0, f"{block.place}:\n{block.text}\n{done.stdout}"
    return True
