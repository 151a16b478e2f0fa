"""Friction of a viscoelastic elastomer that slides over a rough line (Li et al., PRL 111, 034301).

>>> import asperity
>>> scene = asperity.Scene("figure_1.json", load={"normal_force": "20mN"})
>>> curve = asperity.curve(scene)                       # mu over velocity
>>> contact = asperity.state(scene)                     # x, z, u, gap, p of one contact
>>> table = asperity.friction(scene, {"load.normal_force": forces})   # many states in one call

Numbers are SI, angles radians. A text may have a unit: ``"20mN"``, ``"10 MPa"``, ``"40 °C"``. Keys
are those of scene files; ``asperity.parameters()`` lists them. Results are those of the program
``asperity`` to the last bit. Bad input raises ``asperity.InputError`` with the program's message.

Every function that computes takes ``threads`` (0: as many as the machine has; the result does not
depend on it) and ``progress``, a function that is called with the part of the work that is done,
0 to 1. While it computes other Python threads run, and Ctrl+C ends it.
"""

import os
import time
from collections.abc import Mapping

from . import _core
from ._core import InputError
from .tables import Table, columns_of_csv, table_columns

__version__ = _core.version
__all__ = ["Contact", "Curve", "Fit", "InputError", "Map", "Material", "Motion", "Scene",
           "Sensitivity", "States", "Surface", "Table", "columns", "curve", "fit", "friction", "map",
           "march", "material", "parameters", "sensitivity", "state", "surface"]

_SCENES = os.path.join(os.path.dirname(__file__), "scenes")


# ---- scenes

def _plain(key, value):
    """A value as JSON has it: a text with a unit becomes the number in the key's SI unit."""
    if key in _SECTIONS or isinstance(value, Mapping):
        return value  # what is wrong with a section or its name is said by the reader
    kind = _core.kind(key)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if kind not in ("real", "whole"):
        return value
    if isinstance(value, str):
        return _core.number(key, value)
    if isinstance(value, float) and not value - value == 0:
        return _core.number(key, repr(value))  # refuses it
    if kind == "whole" and isinstance(value, float) and value.is_integer():
        return int(value)
    return value


def _dotted(name):
    return name.replace("__", ".") if isinstance(name, str) else str(name)


# Keys that are no values themselves but sections of keys: "surface", "elastomer.shift".
_SECTIONS = {".".join(parts[:n]) for entry in _core.parameters()
             for parts in [entry["key"].split(".")] for n in range(1, len(parts))}


def _flat(values):
    """Pairs of dotted keys and values of nested mappings."""

    def walk(before, members):
        for name, value in members.items():
            key = before + _dotted(name)
            if isinstance(value, Mapping) and key in _SECTIONS:
                yield from walk(key + ".", value)
            else:
                yield key, value

    return list(walk("", values))


def _file_text(values):
    """A scene file with these values."""
    import json

    root = {}
    for key, value in _flat(values):
        if key != "schema":
            value = _plain(key, value)
        place = root
        *sections, last = key.split(".")
        for section in sections:
            place = place.setdefault(section, {})
        if last in place:
            raise _input_error(key, "is given twice")
        place[last] = value
    return json.dumps(root, default=str)


def _assignments(values):
    """The values as KEY=VALUE, which the program reads as those of --set."""
    import json

    texts = []
    for key, value in _flat(values):
        value = _plain(key, value)
        if isinstance(value, (list, tuple, dict, bool)) or value is None:
            value = json.dumps(value, default=str)
        elif isinstance(value, float):
            value = repr(float(value))
        texts.append(f"{key}={value}")
    return texts


def _input_error(key, message, file=None):
    """An InputError of a key or an argument, or of a file where the key is None, or of neither."""
    subject = key or file
    error = InputError(f"{subject}: {message}" if subject else message)
    error.file, error.key, error.message = file, key, message
    return error


def _nearest_scene(name):
    """The shipped scene whose name a mistyped one is nearest to; empty where none is near."""
    known = [file.removesuffix(".json") for file in sorted(os.listdir(_SCENES))]
    return _core.nearest_word(name.removesuffix(".json"), known)


class Scene:
    """What slides over what: the values of a scene file, by dotted keys.

    ``Scene()`` has the defaults; ``Scene("file.json")`` reads a file or a shipped scene
    (``figure_1``); ``Scene({...})`` takes a dict, nested as in a file or with dotted keys.
    Keywords set values over that: a section as a dict, or a key with two underscores for the dot.

    >>> scene = Scene("figure_1.json", load__normal_force="20mN", ensemble={"realizations": 20})
    >>> scene["load.normal_force"]
    0.02
    >>> scene["surface.hurst"] = 0.8

    ``scene[key] = value`` and ``set`` change it, ``replace`` returns a changed copy. A change that
    is refused leaves it as it was. A key that changes a kind (``surface.kind``) drops the keys that
    have no meaning for the new one.
    """

    def __init__(self, source=None, /, **values):
        assignments = _assignments(values) if values else []
        if isinstance(source, Scene):
            self._core = _core.Scene(source._core)
            if assignments:
                self._core.assign(assignments)
        elif isinstance(source, Mapping):
            self._core = _core.Scene(_file_text(source), "", "", assignments)
        elif source is None:
            self._core = _core.Scene("{}", "", "", assignments)
        else:
            name = os.fspath(source)
            shipped = os.path.join(_SCENES, name if name.endswith(".json") else name + ".json")
            if not os.path.exists(name) and os.sep not in name and os.path.exists(shipped):
                with open(shipped, encoding="utf-8") as file:
                    self._core = _core.Scene(file.read(), os.path.basename(shipped), "", assignments)
            elif not os.path.exists(name) and (near := _nearest_scene(name)):
                raise _input_error(
                    None, f"there is no such file; the nearest shipped scene is {near}", name)
            else:
                self._core = _core.Scene(name, assignments)

    @classmethod
    def _of(cls, core):
        """The scene with this object of _core."""
        scene = cls.__new__(cls)
        scene._core = core
        return scene

    @classmethod
    def from_json(cls, text, folder=""):
        """The scene of a file's text; files that it names are relative to the folder."""
        return cls._of(_core.Scene(text, "", os.fspath(folder), []))

    @classmethod
    def from_result(cls, file):
        """The scene inside a picture, film or table that the program wrote."""
        return cls._of(_core.found_scene(os.fspath(file)))

    @property
    def folder(self):
        """str: the folder against which the files that the scene names are resolved."""
        return self._core.folder

    def __getitem__(self, key):
        value = self._core.value(_dotted(key))
        if _core.kind(_dotted(key)) == "list":
            import json

            return json.loads(value)
        return value

    def __setitem__(self, key, value):
        self._core.assign(_assignments({key: value}))

    def set(self, values=None, /, *value, **more):
        """Set one value, ``set("load.normal_force", "20mN")``, or several at once, as a dict or as
        keywords. All are set, or none where one is refused."""
        self._core.assign(_assignments(_given(values, value, more)))

    def replace(self, values=None, /, *value, **more):
        """Return a copy with other values, given as for ``set``."""
        changed = Scene(self)
        changed._core.assign(_assignments(_given(values, value, more)))
        return changed

    def copy(self):
        """Return an equal scene that can be changed on its own."""
        return Scene(self)

    def __contains__(self, key):
        return _dotted(key) in self._core.keys()

    def __iter__(self):
        return iter(self._core.keys())

    def __len__(self):
        return len(self._core.keys())

    def keys(self):
        """list of str: the keys that have a meaning in this scene."""
        return self._core.keys()

    def get(self, key, default=None):
        """The value of a key, or the default where the key has no meaning in this scene."""
        return self[key] if key in self else default

    def items(self):
        """Pairs of keys and values."""
        return [(key, self[key]) for key in self]

    def to_json(self):
        """The canonical scene file, as text."""
        return self._core.json()

    def to_dict(self):
        """The canonical scene file as nested dicts."""
        import json

        return json.loads(self.to_json())

    def save(self, file):
        """Write the canonical scene file."""
        with open(file, "w", encoding="utf-8") as opened:
            opened.write(self.to_json())

    def __eq__(self, other):
        return self._core == other._core if isinstance(other, Scene) else NotImplemented

    __hash__ = None

    def __reduce__(self):
        return Scene.from_json, (self.to_json(), self.folder)

    def __copy__(self):
        return Scene(self)

    def __deepcopy__(self, memo):
        return Scene(self)

    def __repr__(self):
        shown = ("surface.kind", "elastomer.rheology", "load.kind")
        return ("<Scene " + (repr(self["title"]) + ": " if self["title"] else "") +
                ", ".join(self[key] for key in shown) + f", {self['sliding.velocity']:g} m/s>")

    _seconds = 0

    def picture(self, extension="png", *options):
        """The contact as a picture, drawn by the program: bytes of PNG, SVG or PDF. options: more
        options of ``asperity render``."""
        from .pictures import draw

        return draw("render", self, *options, extension=extension)

    def _repr_png_(self):
        from .pictures import drawn_or_none

        return drawn_or_none(self)


def _given(values, value, more):
    if isinstance(values, str):
        if len(value) != 1:
            raise TypeError("one key and its value, or a dict, or keywords")
        return {values: value[0], **more}
    if value:
        raise TypeError("one key and its value, or a dict, or keywords")
    return {**(values or {}), **more}


def _scene(source):
    return source if isinstance(source, Scene) else Scene(source)


class _Result:
    """What results share: the scene, files as the program writes them, and a picture."""

    _verb = ""
    _seconds = 0.0

    @property
    def scene(self):
        """Scene: a copy of the scene that was computed."""
        return Scene._of(self._core.scene())

    def to_csv(self):
        """The table as the program writes it to a .csv file, with the line of its origin."""
        return self._core.csv()

    def to_json(self):
        """The answer as the program writes it to a .json file."""
        return self._core.json()

    def save(self, file):
        """Write .csv or .json, the same bytes as ``asperity VERB -o``, or a picture.
        ``asperity open --remake`` makes each of them again."""
        extension = os.path.splitext(os.fspath(file))[1].lower()
        if extension == ".csv":
            data = self.to_csv().encode()
        elif extension == ".json":
            data = self.to_json().encode()
        elif extension in (".png", ".svg", ".pdf"):
            data = self.picture(extension[1:])
        else:
            raise _input_error(
                None, "the extension is not .csv, .json, .png, .svg or .pdf", os.fspath(file))
        with open(file, "wb") as opened:
            opened.write(data)

    def picture(self, extension="png", *options):
        """The result as a picture, drawn (and for that computed again) by the program: bytes of
        PNG, SVG or PDF. options: more options of that command."""
        from .pictures import draw

        return draw(self._verb, self.scene, *options, extension=extension)

    def _repr_png_(self):
        from .pictures import drawn_or_none

        return drawn_or_none(self)

    def _repr_html_(self):
        from .pictures import can_be_drawn

        # A notebook that is given both shows the table.
        return None if can_be_drawn(self) else Table._repr_html_(self)


def _timed(function, *arguments):
    begin = time.perf_counter()
    result = function(*arguments)
    return result, time.perf_counter() - begin


# ---- curves and many states

class Curve(_Result, Table):
    """A friction curve: the columns of ``asperity curve``, one row for each value of the sweep."""

    _verb = "curve"

    def __init__(self, core, seconds=0.0):
        self._core, self._seconds = core, seconds
        Table.__init__(self, table_columns(core.columns()))

    @property
    def achieved_error(self):
        """float: with a target accuracy the largest relative error of mu; else NaN."""
        return self._core.achieved_error()

    @property
    def is_target_met(self):
        """bool: whether the target accuracy is met, where there is one."""
        return self._core.is_target_met()


def curve(scene, *, threads=0, progress=None):
    """Friction over the scene's sweep, averaged over its realizations, as ``asperity curve``.

    scene: Scene, dict or file; sliding must be steady. Returns a Curve, whose columns have shape
    (n,): the swept key (``velocity``, m/s, or the last word of ``sweep.key``), ``mu``,
    ``mu_standard_error``, ``contact_fraction``, ``indentation`` (m), ... Raises InputError for a
    scene that cannot run, RuntimeError where a force balance is not met.
    """
    return Curve(*_timed(_core.curve, _scene(scene)._core, threads, progress))


class States(Table):
    """Steady states side by side: the overridden keys, then the columns of a curve.

    scene: the scene without the overrides; computed: how many states had to be slid, the others
    being equal to one of them; kernel_seconds: the processor time (s) of sliding them, of all
    threads and of other calls that ran at the same time.
    """

    def __init__(self, scene, columns, units, computed, kernel_seconds):
        Table.__init__(self, columns, units)
        self.scene, self.computed, self.kernel_seconds = Scene(scene), computed, kernel_seconds


def _values(key, value):
    """The values of a key as an array of numbers in its SI unit; a list may have texts with units."""
    import numpy

    if isinstance(value, str):
        return numpy.array(_core.number(key, value), dtype=float)
    values = numpy.asarray(value)
    parts = values.flat if values.dtype.kind == "O" else [values]
    if any(numpy.iscomplexobj(part) for part in parts):
        raise _input_error(key, "is complex; a real number is needed")
    if values.dtype.kind in "USO":
        flat = [_core.number(key, one) if isinstance(one, str) else float(one) for one in values.flat]
        return numpy.array(flat, dtype=float).reshape(values.shape)
    return values.astype(float)


def _units_of(keys):
    units = {entry["key"]: entry["unit"] for entry in _core.parameters()}
    return {key: units.get(key, "") for key in keys}


def _slid(scene, overrides, threads, progress):
    import numpy

    scene = _scene(scene)
    overrides = {_dotted(key): value for key, value in overrides.items()}
    for key in overrides:
        _core.kind(key)  # an unknown one names the nearest
    arrays = {key: _values(key, value) for key, value in overrides.items()}
    shaped = dict(zip(arrays, numpy.broadcast_arrays(*arrays.values()))) if arrays else {}
    shape = next(iter(shaped.values())).shape if shaped else ()
    flat = [numpy.ascontiguousarray(values, dtype=float).ravel() for values in shaped.values()]
    if flat and flat[0].size == 0:
        raise _input_error(next(iter(shaped)), "no value is given")
    columns, computed, seconds = _core.friction(scene._core, list(shaped), flat, threads, progress)
    columns = {name: column.reshape(shape) for name, column in table_columns(columns).items()}
    given = {key: numpy.array(values) for key, values in shaped.items()}
    return States(scene, {**given, **columns}, _units_of(shaped), computed, seconds)


def friction(scene, overrides=None, /, *, threads=0, progress=None, **more):
    """Steady friction of the scene with many other values, in one call.

    overrides: dict of dotted keys to numbers or arrays, which are broadcast against each other; each
    element is one state, which slides at its ``sliding.velocity`` on the same random lines as all
    others. Texts may have units. Keywords are keys with two underscores for the dot.

    States that differ only in force, moduli, rms height, temperature, relaxation time or velocity
    share their lines and run side by side. Returns States: the overridden keys and the columns of
    a curve, each of the broadcast shape. Raises InputError with the key of a value that is not
    allowed.

    >>> forces = numpy.geomspace(1e-3, 1, 1000)
    >>> table = asperity.friction(scene, {"load.normal_force": forces})
    >>> table["load.normal_force"], table.mu
    """
    return _slid(scene, {**(overrides or {}), **more}, threads, progress)


class Map(_Result, Table):
    """Friction over two keys: both keys and the columns of a curve, shape (len(y), len(x)).

    ``x``, ``y``: the values of the two sides, in the keys' units; computed: how many states had to
    be slid, the others being equal to one of them.
    """

    _verb = "map"

    def __init__(self, core, seconds, x_key, y_key):
        self._core, self._seconds = core, seconds
        self.x, self.y, self.computed = core.x(), core.y(), core.computed()
        self._sides = x_key, y_key
        shape = (len(self.y), len(self.x))
        columns = {name: column.reshape(shape)
                   for name, column in table_columns(core.columns()).items()}
        Table.__init__(self, {**_grid(x_key, self.x, y_key, self.y), **columns},
                       _units_of((x_key, y_key)))

    def picture(self, extension="png", *options):
        """The map as a picture with contour lines, drawn (and for that computed again) by the
        program: bytes of PNG, SVG or PDF. options: more options of ``asperity map``."""
        from .pictures import draw

        return draw("map", self.scene, *self._options, *options, extension=extension)


def _grid(x_key, x, y_key, y):
    import numpy

    x, y = numpy.asarray(x)[numpy.newaxis, :], numpy.asarray(y)[:, numpy.newaxis]
    x, y = numpy.broadcast_arrays(x, y)
    return {x_key: numpy.array(x), y_key: numpy.array(y)}


def _side(given):
    """Key and values of a side of a map: a text of a range, or a list."""
    if isinstance(given, str):
        key, equals, text = given.partition("=")
        if not equals:
            raise _input_error(given, "is not KEY=FROM:TO:N, such as load.normal_force=0.001:10:41")
        given = (key, text)
    key, values = given
    key = _dotted(key)
    _core.kind(key)
    if not isinstance(values, str):
        values = _values(key, values)
        if values.ndim != 1:
            raise _input_error(key, "a side of a map is a range or a list of numbers")
    return key, values


def map(scene, x, y, *, threads=0, progress=None):  # noqa: A001, the program's word
    """Friction over two keys, on common random lines, as ``asperity map``.

    x, y: ``"load.normal_force=1mN:1N:20"``, or a pair of a key and a range (``"1mN:1N:20:log"``) or
    a list of values. Returns a Map whose columns have shape (len(y), len(x)), the two keys among
    them; where a side is a list, States of the same shape, which no file of the program describes.
    """
    scene = _scene(scene)
    (x_key, x_values), (y_key, y_values) = _side(x), _side(y)
    if x_key == y_key:
        raise _input_error(y_key, "is both sides of the map; they need two different keys")
    if isinstance(x_values, str) and isinstance(y_values, str):
        core, seconds = _timed(_core.map, scene._core, [x_key, x_values], [y_key, y_values], threads,
                               progress)
        found = Map(core, seconds, x_key, y_key)
        found._options = ("--x", f"{x_key}={x_values}", "--y", f"{y_key}={y_values}")
        return found
    if isinstance(x_values, str):
        x_values = _core.range_values(scene._core, x_key, x_values)
    if isinstance(y_values, str):
        y_values = _core.range_values(scene._core, y_key, y_values)
    return _slid(scene, _grid(x_key, x_values, y_key, y_values), threads, progress)


class Sensitivity(_Result, Table):
    """How friction changes with each parameter: the columns of ``asperity sensitivity``, and slopes.

    Columns of shape (n,), the largest exponent first: ``key``; ``value`` in its unit; ``mu_exponent``
    p d ln mu / d p, and ``mu_exponent_standard_error``; ``slope`` d ln mu / d ln p, or d ln mu / d p
    (in the inverse of the key's unit) where ``is_logarithmic`` is False, for values that may be 0 or
    below, and ``slope_standard_error``. Errors are those of the mean over the lines.
    """

    _verb = "sensitivity"

    def __init__(self, core, seconds=0.0):
        import numpy

        self._core, self._seconds = core, seconds
        names = ("key", "value", "mu_exponent", "mu_exponent_standard_error", "slope",
                 "slope_standard_error", "is_logarithmic")
        columns = list(zip(*core.rows())) or [()] * len(names)
        kinds = (str, float, float, float, float, float, bool)
        Table.__init__(self, {name: numpy.array(column, dtype=kind)
                              for name, column, kind in zip(names, columns, kinds)})


def sensitivity(scene, *, threads=0, progress=None):
    """How friction changes with each parameter, at the scene's velocity, on common random lines.

    scene: Scene, dict or file; sliding must be steady. Returns a Sensitivity, a table of shape (n,)
    with a row for each number that friction depends on.
    """
    return Sensitivity(*_timed(_core.sensitivity, _scene(scene)._core, threads, progress))


# ---- one contact, motions, surfaces

class Contact:
    """One line in steady contact, from ``asperity.state``.

    Arrays of shape (n,) over one period, views that cannot be written to and stay valid as long as
    someone holds them: ``x`` (m) along the line; ``z`` (m) the rigid line and ``u`` (m) the surface
    of the elastomer, both above the undeformed surface; ``gap`` (m) z - u, 0 in contact; ``p`` (N/m)
    line load; ``slope`` dz/dx; ``time_since_contact`` (s); ``power`` (W/m) dissipated.

    Numbers: ``indentation`` (m), ``normal_force``, ``tangential_force`` (N), ``mu``,
    ``mu_interface``, ``contact_fraction``, ``rms_slope_contact``, ``power_dissipated`` (W),
    ``velocity`` (m/s), ``length``, ``spacing`` (m), ``residual`` of the force balance.
    """

    _ARRAYS = ("x", "z", "u", "gap", "p", "slope", "time_since_contact", "power")
    _NUMBERS = ("indentation", "normal_force", "tangential_force", "mu", "mu_interface",
                "contact_fraction", "rms_slope_contact", "power_dissipated", "velocity", "length",
                "spacing", "residual")

    def __init__(self, core, seconds=0.0):
        self._core, self._seconds = core, seconds

    def __getattr__(self, name):
        if name in Contact._ARRAYS or name in Contact._NUMBERS:
            return getattr(self._core, name)
        raise AttributeError(f"a contact has no {name!r}; it has "
                             f"{', '.join(Contact._ARRAYS + Contact._NUMBERS)}")

    def __dir__(self):
        return [*super().__dir__(), *Contact._ARRAYS, *Contact._NUMBERS]

    @property
    def scene(self):
        """Scene: a copy of the scene that was computed."""
        return Scene._of(self._core.scene())

    def __repr__(self):
        return (f"<Contact of {len(self.x)} points: mu {self.mu:.4g}, contact fraction "
                f"{self.contact_fraction:.4g}, indentation {self.indentation:.4g} m>")

    def picture(self, extension="png", *options):
        """The contact as a picture, as ``Scene.picture``; of realization 0."""
        return self.scene.picture(extension, *options)

    def _repr_png_(self):
        return self.scene._repr_png_()


def state(scene, *, realization=0, progress=None):
    """The steady contact of one line at the scene's velocity, at the scene's own points.

    scene: Scene, dict or file; realization: which of the random lines, from 0 on. Returns a Contact. Raises InputError for a
    scene that cannot run, RuntimeError where the force balance is not met.
    """
    return Contact(*_timed(_core.state, _scene(scene)._core, realization, progress))


class Motion(_Result, Table):
    """A motion in time: the columns of ``asperity motion``, one row for each time step."""

    _verb = "motion"
    _options = ()

    def __init__(self, core, seconds=0.0):
        self._core, self._seconds = core, seconds
        Table.__init__(self, core.columns())

    @property
    def mu_error(self):
        """float: error of mu by elements and time steps (root mean square), not exceeded in 95 of 100 random scenes."""
        return self._core.mu_error()

    @property
    def relative_error(self):
        """float: the same over the root mean square of mu."""
        return self._core.relative_error()

    def picture(self, extension="png", *options):
        """The motion as a picture of all its lines, drawn by the program: bytes of PNG, SVG or PDF.
        options: more options of ``asperity motion``."""
        from .pictures import draw

        return draw("motion", self.scene, *self._options, *options, extension=extension)


def march(scene, *, every=1, lines=1, threads=0, progress=None):
    """A motion that is not steady, in time, as ``asperity motion``.

    scene: Scene, dict or file, whose sliding is not steady; every: time steps for a row; lines: realizations 0, 1, ..., one after another in the table.
    Returns a Motion, whose columns have shape (n,): ``time`` (s), ``displacement`` (m),
    ``velocity`` (m/s), ``normal_force`` (N), ``tangential_force`` (N), ``mu``, ``indentation`` (m),
    ``contact_fraction``, ``contact_spots``, ``power_in``, ``power_dissipated`` (W),
    ``mu_interface``, ``realization``.
    """
    found = Motion(*_timed(_core.march, _scene(scene)._core, every, lines, threads, progress))
    found._options = ("--every", str(every), "--lines", str(lines))
    return found


class Surface(_Result, Table):
    """A rigid line: the columns ``position`` and ``height`` (m), shape (n,), as views, and more.

    ``slope``: dz/dx at the points, shape (n,). ``data``: the answer of ``asperity surface --json``
    as a dict, with ``statistics`` and, of a measured surface, ``reading``, ``values`` and
    ``notes``. ``spectrum``: a Table of ``wave_number`` (1/m) and ``power_spectral_density`` (m^3),
    or None. ``facts``: what a file was taken for, a list of sentences.
    """

    _verb = "surface"

    def __init__(self, core, seconds=0.0):
        import json

        self._core, self._seconds = core, seconds
        self.data = json.loads(core.json())
        self.facts = core.facts()
        Table.__init__(self, {"position": core.position(), "height": core.height()})

    @property
    def slope(self):
        """Array of shape (n,): dz/dx just right of each point."""
        return self._core.slope()

    @property
    def statistics(self):
        """dict: length, points, spacing, rms_height, rms_slope, lowest, highest; SI."""
        return self.data["statistics"]

    @property
    def spectrum(self):
        """Table of the line's power spectral density; None where it has no modes."""
        import numpy

        found = self.data["spectrum"]
        if found is None:
            return None
        return Table({name: numpy.array(values) for name, values in found.items()},
                     {"wave_number": "1/m", "power_spectral_density": "m^3"})

    def __repr__(self):
        return (f"<Surface of {self.shape[0]} points: length {self.statistics['length']:.4g} m, rms "
                f"height {self.statistics['rms_height']:.4g} m, rms slope "
                f"{self.statistics['rms_slope']:.4g}>")


def surface(source, *, realization=0, progress=None, **values):
    """The rigid line of a scene, or of the file of a measured surface, as ``asperity surface``.

    source: Scene, dict, scene file, or a measured profile or topography of any kind that the
    program reads. A line that the program wrote is taken as it is, a profile; any other file is
    processed as a measured surface. values: keys of the scene, such as
    ``surface={"height_unit": "um"}``. Returns a Surface.
    """
    file = ""
    if isinstance(source, (str, os.PathLike)) and _core.is_surface_file(os.fspath(source)):
        file = os.fspath(source)
        scene = Scene._of(_core.surface_file_scene(file, _assignments(values)))
    else:
        scene = Scene(source, **values)
    return Surface(*_timed(_core.surface, scene._core, file, realization, progress))


# ---- materials and fits

class Material:
    """A rubber from measurements: ``asperity.material``.

    ``data``: material.json as a dict (``equilibrium_modulus`` Pa, ``arms``, ``shift``, ...).
    ``prony``, ``isotherms``, ``shifts``: the program's tables; the last two are None of a ready
    Prony series. ``summary``: what was measured and how good the fit is, a list of sentences.
    """

    def __init__(self, core):
        import json

        self._core = core
        self.data = json.loads(core.json())
        self.summary = core.summary()
        self.prony = Table(columns_of_csv(core.prony_csv()))
        measured = core.is_measured()
        self.isotherms = Table(columns_of_csv(core.isotherms_csv())) if measured else None
        self.shifts = Table(columns_of_csv(core.shifts_csv())) if measured else None

    def to_json(self):
        """The text of material.json, which a scene names as ``elastomer.material``."""
        return self._core.json()

    def save(self, file):
        """Write material.json."""
        with open(file, "w", encoding="utf-8") as opened:
            opened.write(self.to_json())

    def __repr__(self):
        return f"<Material {self.data['name']!r}: {len(self.data['arms'])} arms>"


def material(file, *, progress=None, **options):
    """A material from a table of measured moduli or a ready Prony series, as ``asperity material``.

    options: those of the program with underscores, such as ``reference_temperature="20C"``,
    ``terms=12``, ``shift="table"``, ``modulus="tension"``, ``poisson_ratio=0.49``,
    ``leave_out=["-10C"]``, ``vertical_shifts=True``, ``strain="1%"``, ``frequency_column``,
    ``modulus_unit="MPa"``, ``name``, ``source``. Returns a Material.
    """
    written = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        for one in value if isinstance(value, (list, tuple)) else [value]:
            if one is None or one is False:
                continue
            written.append((option, "true" if one is True else str(one)))
    return Material(_core.material(os.fspath(file), written, progress))


class Fit:
    """Parameters that fit measured friction: ``asperity.fit``.

    ``parameters``: a Table of ``key``, ``value``, ``low``, ``high`` (in the key's unit),
    ``standard_error`` (of ln value where ``is_logarithmic``), ``is_determined``, ``is_at_limit``.
    ``scene``: the scene with the best values. ``points``: a Table of what was measured and computed
    (columns of fit.csv). ``correlations``: array of shape (k, k). ``data``: the rest of fit.json as
    a dict, with ``chi_squared``, ``degrees_of_freedom``, ``profiles``, ``combinations``, ``notes``.
    """

    def __init__(self, core):
        import json
        import numpy

        self._core = core
        self.data = json.loads(core.json())["fit"]
        self.scene = Scene._of(core.scene())
        self.points = Table(columns_of_csv(core.csv()))
        rows = self.data["parameters"]
        self.parameters = Table({
            name: numpy.array([float("nan") if row[name] is None else row[name] for row in rows])
            for name in rows[0]})
        self.correlations = numpy.array(self.data["correlations"], dtype=float)

    def __getitem__(self, key):
        """The fitted value of a key, in its unit."""
        for row in self.data["parameters"]:
            if row["key"] == key:
                return row["value"]
        raise KeyError(key)

    def to_json(self):
        """The text of fit.json."""
        return self._core.json()

    def save(self, file):
        """Write fit.json. ``asperity open --remake`` makes it again where all tables are files."""
        with open(file, "w", encoding="utf-8") as opened:
            opened.write(self.to_json())

    def __repr__(self):
        values = ", ".join(f"{row['key']} = {row['value']:.5g} ({row['low']:.5g} to "
                           f"{row['high']:.5g}) {row['unit']}".rstrip()
                           for row in self.data["parameters"])
        return f"<Fit: {values}; χ² = {self.data['chi_squared']:.4g}>"


def _data_text(table, columns):
    """A table of measured friction as text. A single value holds in all rows."""
    import numpy

    names = [str(name) for name in columns]
    arrays = [numpy.asarray(values) for values in columns.values()]
    if len({array.shape for array in arrays if array.shape}) > 1:
        lengths = ", ".join(f"{name} {array.size}" for name, array in zip(names, arrays))
        raise _input_error(table, f"the columns have different numbers of values: {lengths}")
    arrays = numpy.broadcast_arrays(*arrays)
    lines = [",".join(names)]
    for row in zip(*(array.ravel().tolist() for array in arrays)):
        lines.append(",".join(cell if isinstance(cell, str) else repr(cell) for cell in row))
    return "\n".join(lines) + "\n"


def _range_text(key, limits):
    if limits is None:
        return key
    if isinstance(limits, str) or not hasattr(limits, "__len__") or len(limits) != 2:
        raise _input_error(key, f"{limits!r} is neither None nor (low, high)")
    low, high = (limit if isinstance(limit, str) else repr(float(limit)) for limit in limits)
    return f"{key}={low}:{high}"


def fit(scene, data=None, vary=(), *, profiles=True, threads=0, progress=None):
    """Fit parameters of a scene to measured friction, as ``asperity fit``.

    data: a file, a dict of columns (``velocity`` m/s, ``mu``; where known ``mu_error``,
    ``normal_force`` N, ``nominal_pressure`` Pa, ``temperature`` K), or a list of these; None: the
    tables that the scene names. vary: a key, a list of keys (``"KEY"`` or ``"KEY=LOW:HIGH"``), or a
    dict of keys to None or (low, high). profiles=False leaves out the profiles of the objective,
    which take most of the time. Returns a Fit.
    """
    given = [] if data is None else data if isinstance(data, (list, tuple)) else [data]
    files = [os.fspath(one) for one in given if not isinstance(one, Mapping)]
    names = [f"data {number + 1}" for number in range(len(given))]
    tables = [(name, _data_text(name, one)) for name, one in zip(names, given)
              if isinstance(one, Mapping)]
    if isinstance(vary, Mapping):
        keys = [_range_text(_dotted(key), limits) for key, limits in vary.items()]
    else:
        keys = [vary] if isinstance(vary, str) else [str(key) for key in vary]
    return Fit(_core.fit(_scene(scene)._core, files, tables, keys, profiles, threads, progress))


# ---- dictionaries

def columns():
    """Every column of every table: a list of dicts of name, unit, meaning, equation, tables."""
    return _core.columns()


def parameters():
    """Every key of a scene: a list of dicts of key, kind, label, symbol, unit, allowed, default,
    meaning."""
    return _core.parameters()
