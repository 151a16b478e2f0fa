"""The guide that the build made: complete, self-contained, with an anchor for all it is asked for."""

import os
import re
import subprocess
from html.parser import HTMLParser

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TEXT = open(os.environ["ASPERITY_GUIDE"], encoding="utf-8").read()


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.anchors, self.targets, self.loaded, self.tags = [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.tags.append(tag)
        if "id" in attributes:
            self.anchors.append(attributes["id"])
        if tag == "a" and "href" in attributes:
            self.targets.append(attributes["href"])
        for name in ("src", "data", "poster"):
            if name in attributes:
                self.loaded.append(attributes[name])
        if tag == "link":
            self.loaded.append(attributes.get("href", ""))


PAGE = Page(TEXT)


def test_it_needs_nothing_else():
    assert PAGE.loaded and all(part.startswith("data:") for part in PAGE.loaded)
    assert "script" not in PAGE.tags
    styles = "".join(re.findall(r"<style.*?</style>", TEXT, flags=re.S))
    assert "prefers-color-scheme: dark" in styles
    assert not re.search(r"url\((?!data:)|@import", styles)


def test_anchors_are_unique_and_links_find_them():
    assert len(PAGE.anchors) == len(set(PAGE.anchors))
    inner = [target[1:] for target in PAGE.targets if target.startswith("#")]
    assert len(inner) > 20
    assert set(inner) <= set(PAGE.anchors)
    outer = [target for target in PAGE.targets if not target.startswith("#")]
    assert all(target.startswith("https://") for target in outer), outer


def test_installed_files_that_it_names_are_in_the_sources():
    """What the packages install as examples, from where (resources/linux)."""
    folders = {"asperity": "resources", "python3-asperity": "app/python/examples"}
    named = set(re.findall(r"/usr/share/doc/([a-z0-9-]+)/examples/?([a-z_./]*)", TEXT))
    assert {package for package, _ in named} == set(folders)
    for package, path in named:
        assert os.path.exists(os.path.join(ROOT, folders[package], path)), (package, path)
    words = re.sub(r"\s+", " ", re.sub(r'"data:[^"]*"', "", TEXT))
    assert "resources/" not in re.sub(r"in the sources: <code>[^<]*</code>", "", words)


def test_pages_and_sections_have_anchors_of_their_own():
    """A heading without one would change its address with its words."""
    pages = [name for name in os.listdir(f"{ROOT}/resources/guide") if name.endswith(".md")]
    for name in pages:
        text = open(f"{ROOT}/resources/guide/{name}", encoding="utf-8").read()
        text = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
        for heading in re.findall(r"^#+ .*$", text, flags=re.M):
            anchor = re.search(r"\{#([a-z0-9-]+)\}$", heading)
            assert anchor, f"{name}: {heading}"
            assert anchor[1] in PAGE.anchors, f"{name}: {heading} is not in the guide"


def test_every_equation_that_the_program_names_is_there():
    named = set()
    for folder in ("core", "app", "ui"):
        for path, _, files in os.walk(f"{ROOT}/{folder}"):
            for name in files:
                if not name.endswith((".h", ".cpp", ".py")):
                    continue
                code = open(f"{path}/{name}", encoding="utf-8").read()
                for text in re.findall(r'"(?:[^"\\\n]|\\.)*"', code):
                    for numbers in re.findall(r"Eqs?\. ?\(?(\(?\d+\)?(?:(?:, | and | to )\(?\d+\)?)*)", text):
                        named |= {int(number) for number in re.findall(r"\d+", numbers)}
    assert {11, 13, 14, 17} <= named and max(named) <= 17
    for number in named:
        assert f"eq-{number}" in PAGE.anchors, f"Eq. ({number})"
    # Each is an equation, with its number beside it.
    for number in range(1, 18):
        part = TEXT[TEXT.index(f'id="eq-{number}"'):]
        part = part[:part.index("</div>")]
        assert "<math" in part and f"({number})</span>" in part


def test_formulas_are_mathml():
    assert TEXT.count("<math") > 60
    assert 'class="math' not in TEXT  # what pandoc could not convert


def test_the_dictionary_is_the_program_s():
    keys = subprocess.run([os.environ["ASPERITY_PROGRAM"], "check", "--help", "keys"],
                          capture_output=True, text=True, check=True).stdout
    named = re.findall(r"^  ([a-z_.0-9]+) ", keys, flags=re.M)
    assert len(named) > 60
    for key in named:
        assert "key-" + key.replace(".", "-") in PAGE.anchors, key
    columns = subprocess.run([os.environ["ASPERITY_PROGRAM"], "columns"], capture_output=True,
                             text=True, check=True).stdout
    for name in re.findall(r"^([a-z][a-z_0-9]*)(?: \[|$)", columns, flags=re.M):
        assert f"<code>{name}</code>" in TEXT, name
    for command in ("curve", "render", "study-run", "columns"):
        assert f"options-{command}" in PAGE.anchors
