"""Results as columns of numbers by name."""

from collections.abc import Mapping

from . import _core


class Table(Mapping):
    """Columns by name: ``table["mu"]`` or ``table.mu``, each an array of numpy.

    All columns have one shape. A value that does not apply is NaN; texts (``notes``) are arrays of
    str. Units are SI and stand in ``table.units``; what a column means is in ``asperity.columns()``.
    ``dict(table)`` and ``pandas.DataFrame(dict(table))`` work.
    """

    def __init__(self, columns, units=None):
        self._columns = columns
        self._units = units or {}

    def __getitem__(self, name):
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"there is no column {name!r}; columns are "
                           f"{', '.join(self._columns)}") from None

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    def __getattr__(self, name):
        if not name.startswith("_") and name in self._columns:
            return self._columns[name]
        raise AttributeError(f"there is no column or attribute {name!r}; "
                             f"columns are {', '.join(self.__dict__.get('_columns', ()))}")

    def __dir__(self):
        return [*super().__dir__(), *self._columns]

    @property
    def units(self):
        """dict of str: the SI unit of each column; empty for a pure number."""
        units = {entry["name"]: entry["unit"] for entry in _core.columns()}
        return {name: self._units.get(name, units.get(name, "")) for name in self._columns}

    @property
    def shape(self):
        """tuple of int: the shape of every column."""
        return next(iter(self._columns.values())).shape if self._columns else (0,)

    def __repr__(self):
        return (f"<{type(self).__name__} of shape {self.shape}: {', '.join(self._columns)}>")

    def _repr_html_(self):
        shown, kept = [], 12
        columns = {name: column.ravel() for name, column in self._columns.items()}
        rows = len(next(iter(columns.values()))) if columns else 0
        places = list(range(rows)) if rows <= kept else [*range(kept // 2), None,
                                                         *range(rows - kept // 2, rows)]
        for place in places:
            cells = ("<td>…</td>" * len(columns) if place is None else
                     "".join(f"<td>{_cell(column[place])}</td>" for column in columns.values()))
            shown.append(f"<tr>{cells}</tr>")
        units = self.units
        head = "".join(f"<th>{name}{f' ({units[name]})' if units[name] else ''}</th>"
                       for name in columns)
        return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(shown)}</tbody></table>"


def _cell(value):
    if isinstance(value, str):
        return value
    return "" if value != value else f"{value:.6g}"


def table_columns(columns):
    """Makes arrays of the lists of texts among the columns."""
    import numpy

    return {name: column if isinstance(column, numpy.ndarray) else numpy.array(column, dtype=str)
            for name, column in columns.items()}


def columns_of_csv(text):
    """The columns of a table of the program as arrays: numbers where all cells are, else texts."""
    import csv
    import numpy

    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    columns = {}
    for number, name in enumerate(rows[0]):
        cells = [row[number] for row in rows[1:]]
        try:
            columns[name] = numpy.array([float(cell) if cell else float("nan") for cell in cells])
        except ValueError:
            columns[name] = numpy.array(cells, dtype=str)
    return columns
