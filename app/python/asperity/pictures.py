"""Pictures of results, drawn by the program `asperity`.

Why a process of its own: the pictures are those of the program to the last byte, this process needs
neither Qt nor a display, and no second Qt can meet the one of matplotlib or Spyder. The module is
imported with the first picture.
"""

import json
import os
import shutil
import subprocess
import tempfile

from . import InputError, Scene, _input_error


def program():
    """The path of the program: $ASPERITY_PROGRAM, or `asperity` on the PATH; None where there is none."""
    return os.environ.get("ASPERITY_PROGRAM") or shutil.which("asperity")


def _with_whole_paths(scene):
    """The scene as a file that can lie in any folder."""
    root = json.loads(scene.to_json())
    folder = os.path.abspath(scene.folder or ".")

    def whole(section, name):
        path = os.path.join(folder, section.get(name) or "")
        if section.get(name) and os.path.exists(path):
            section[name] = path

    whole(root.get("surface", {}), "file")
    whole(root.get("elastomer", {}), "material")
    for table in root.get("comparison", {}).get("data", []):
        whole(table, "file")
    return json.dumps(root)


def draw(verb, scene, *options, extension="png"):
    """Runs ``asperity VERB`` on the scene and returns the bytes of the picture.

    Raises FileNotFoundError where the program is not installed, and with the line of the program
    InputError where it refuses the scene or an option, RuntimeError where it fails.
    """
    found = program()
    if not found:
        raise FileNotFoundError("pictures are drawn by the program asperity, which is not "
                                "installed (Debian package asperity)")
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "scene.json")
        picture = os.path.join(folder, "picture." + extension)
        with open(name, "w", encoding="utf-8") as file:
            file.write(_with_whole_paths(scene))
        run = subprocess.run([found, verb, name, "-o", picture, "--quiet", *options],
                             stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            line = run.stderr.strip().replace(name + ": ", "").replace(picture + ": ", "")
            line = line.removeprefix("asperity: ") or "no picture was made"
            if run.returncode != 2:
                raise RuntimeError(line)
            raise _input_error(None, line)
        with open(picture, "rb") as file:
            return file.read()


def can_be_drawn(result):
    """Whether a notebook draws a result unasked: the program is there and takes some seconds. It
    computes what it draws."""
    return program() is not None and result._seconds <= 10


def drawn_or_none(result):
    """The picture of a result for a notebook, drawn once; None where it is not drawn unasked."""
    if not can_be_drawn(result):
        return None
    scene = result.to_json() if isinstance(result, Scene) else None
    kept = result.__dict__.get("_picture")
    if kept is None or kept[0] != scene:
        try:
            kept = result.__dict__["_picture"] = (scene, result.picture())
        except (InputError, RuntimeError) as error:
            # A notebook that asked for nothing is not interrupted: the program may be another one.
            import warnings

            warnings.warn(f"{program()} drew no picture: {error}", stacklevel=2)
            return None
    return kept[1]
