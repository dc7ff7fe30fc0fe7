"""What is timed: a method with its parameters, fitted now or kept as a map."""

import time
from dataclasses import dataclass

from vpr_bench.errors import UsageError, blaming
from vpr_bench.maps.map import Map
from vpr_bench.method.build import BuiltMethod
from vpr_bench.method.interfaces import Method
from vpr_bench.types.traverse import Traverse


@dataclass(frozen=True, eq=False)
class Variant:
    """One of the methods that are timed side by side.

    Attributes
    ----------
    name : str
        As it was asked for, for tables.
    built : BuiltMethod
        Not fitted yet.
    kept : Map, optional
        Has been fitted already, and is read instead.
    """

    name: str
    built: BuiltMethod
    kept: Map | None = None

    @classmethod
    def of_map(cls, name: str, kept: Map) -> "Variant":
        """Take what a map holds.

        Raises
        ------
        UsageError, DataError
            If its method is unknown, another version, or cannot read it.
        """
        return cls(name, kept.built, kept)

    def fitted(self, references: Traverse) -> tuple[Method, float | None]:
        """Return the method that knows the references, and the seconds that fitting took; None for a map.

        Raises
        ------
        UsageError
            If the map is of another number of references.
        DataError
            If an image cannot be decoded, or the map cannot be read.
        VprBenchError
            If the method fails.
        """
        if self.kept is not None:
            if len(self.kept) != len(references):
                raise UsageError(
                    f"The map {self.kept.folder} has {len(self.kept)} references, and {references.name} has "
                    f"{len(references)}: side by side all methods know the same places."
                )
            return self.kept.method, None
        start = time.perf_counter()
        with blaming(f"The method {self.built.id!r} failed while fitting"):
            self.built.method.fit(references)
        return self.built.method, time.perf_counter() - start
