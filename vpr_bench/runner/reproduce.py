"""A stored run done again, exactly: the same method on the same images, asked in the same way."""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from vpr_bench.dataset.load import Case
from vpr_bench.errors import DamagedError, DataError, UsageError, closest, one_line
from vpr_bench.files.atomic import write_bytes
from vpr_bench.method.build import BuiltMethod, build_method, find_method
from vpr_bench.method.rebuild import called, places_of, rebuilding
from vpr_bench.method.trust import UntrustedError
from vpr_bench.method.version import version_of
from vpr_bench.registry import NOT_INSTALLED
from vpr_bench.runner.images import OtherImagesError, case_of
from vpr_bench.runner.provenance import SourceState
from vpr_bench.runner.record import RunKey, RunRecord
from vpr_bench.runner.run import RunOptions, run, run_key
from vpr_bench.runner.store import RunStore, StoredRun

MADE_HERE = "reproduction.txt"
"""Lies in the folder of a run that is a reproduction, and may be overwritten by the next one."""

_NOTE = b"`vpr-bench reproduce` did a run again, and this is what it answered. The next time, it is overwritten.\n"
_LONGEST = 200  # characters that a message quotes of a value; run.json may be anybody's


def reproduce(
    original: StoredRun, store: RunStore, methods: Sequence[str] = (), dataset: str | None = None
) -> StoredRun:
    """Do a run again; a reproduction that was interrupted is continued, one that is complete is done anew.

    Nothing is asked before method, weights and images are known to be those of the run.

    Parameters
    ----------
    original : StoredRun
        It is left as it is.
    store : RunStore
        Where the new one goes; in its folder, ``MADE_HERE`` says what it is.
    methods : sequence of str
        Where methods are that are not installed: ``path/to/file.py:Class``. A run alone cannot have a file executed.
    dataset : str, optional
        Where the images are, if they are a folder of one's own.

    Raises
    ------
    UsageError
        If a method must be named by the user, or one is named that the run does not have, or the new run would take
        the place of one that is no reproduction.
    DataError
        If version, parameters or weights of the method or the images are no longer those of the run, or are missing.
    VprBenchError
        If the method fails; names the query.
    """
    built = rebuild(original.record, methods)
    case = same_case(original, dataset)
    key = original.record.key
    options = RunOptions(key.seed, key.k, key.limit, key.threads, timeout=original.record.timeout)
    found = run_key(case, built, options)
    for name, value in _plain(found).items():  # the rest of it, which only an edited run.json can contradict
        _check(original.record, f"The {name} in its key", _plain(key)[name], value, "Its run.json contradicts itself.")
    there = store.folder(found)
    if there.resolve() == original.folder.resolve():
        raise UsageError(f"The new run would take the place of {there}. Give another folder with --output.")
    stored = _is_complete(store, found)
    if stored and not (there / MADE_HERE).exists():
        raise UsageError(f"{there} is no reproduction, and not overwritten. Give another folder with --output.")
    again = run(case, built, store, replace(options, overwrite="always" if stored else "only-missing"))
    write_bytes(again.folder / MADE_HERE, _NOTE)
    return again


def rebuild(record: RunRecord, methods: Sequence[str] = ()) -> BuiltMethod:
    """Make the method of a run, with the methods inside it, as it was.

    Parameters and errors are those of :func:`reproduce`.
    """
    key = record.key
    with rebuilding(_places(key, methods)):
        try:
            for name, version in _versions(key.method, key.version, key.parameters):
                _check(record, f"The version of {name}", version, _version_here(name))
            built = build_method(key.method, key.parameters)
        except UntrustedError:
            raise
        except UsageError as error:
            raise DataError(f"{error}\n{_made_with(record)}") from None
    _check(record, f"The weights of {key.method}", key.weights, built.weights)
    for name, value in _json(built.parameters).items():
        _check(record, f"The parameter {name}", key.parameters.get(name), value)
    return built


def same_case(original: StoredRun, dataset: str | None = None) -> Case:
    """Load the images and places of a run.

    Parameters and errors are those of :func:`reproduce`.
    """
    protocol, record = original.protocol, original.record
    advice = (
        f"The run had other images, or other places for them. See `vpr-bench data verify {protocol.source}`; "
        "say where a folder of yours is with --dataset PATH."
    )
    try:
        return case_of(protocol, record.key.dataset_digest, dataset)
    except OtherImagesError as error:
        raise _other(record, "The digest of the images", error.recorded, error.found, advice) from None
    except UsageError as error:
        if dataset is not None:
            raise
        raise DataError(f"{error} If its images are a folder of yours, say where with --dataset PATH.") from None


def _is_complete(store: RunStore, key: RunKey) -> bool:
    try:
        return store.find(key) is not None
    except DamagedError:
        return False


def _places(key: RunKey, methods: Sequence[str]) -> dict[str, str]:
    """Return what the user calls the methods of a run that are not installed, by what the run calls them."""
    known = [name for name, _ in _versions(key.method, key.version, key.parameters)]
    places = places_of({method: called(method) for method in methods})
    for name in places:
        if name not in known:
            raise UsageError(f"The run has no method {name!r}. {closest(name, map(one_line, known))}")
    return places


def _versions(method: str, version: str, parameters: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield a method and those inside it, each with its version."""
    yield method, version
    for value in parameters.values():
        if _is_method(value):
            yield from _versions(value["method"], str(value.get("version")), value["parameters"])


def _is_method(value: Any) -> bool:
    """Say whether a parameter is a method inside, as :meth:`BuiltMethod.as_parameter` writes it."""
    return (
        isinstance(value, Mapping)
        and value.keys() == {"method", "version", "parameters", "weights"}
        and isinstance(value["method"], str)
        and isinstance(value["parameters"], Mapping)
    )


def _version_here(name: str) -> str:
    entry, _ = find_method(name)
    return version_of(entry, entry.load())


def _check(record: RunRecord, what: str, recorded: Any, found: Any, advice: str = "") -> None:
    """Refuse to go on where something is not as it was.

    Raises
    ------
    DataError
        Says what, what was recorded and found, and what to do.
    """
    if recorded != found:
        raise _other(record, what, recorded, found, advice)


def _other(record: RunRecord, what: str, recorded: Any, found: Any, advice: str = "") -> DataError:
    return DataError(
        f"{one_line(what):.{_LONGEST}} is not that of the run: recorded was {_quoted(recorded)}, "
        f"found is {_quoted(found)}.\n{advice or _made_with(record)}"
    )


def _made_with(record: RunRecord) -> str:
    """Say what has to be installed to have the run's own code."""
    noted = record.provenance
    needed = [f"vpr-bench {record.machine.libraries.get('vpr-bench', 'of unknown version')}{_at(noted.source)}"]
    if noted.origin == NOT_INSTALLED:
        needed.append(f"the file of its method as it was then{_at(noted.method_source)}")
    elif noted.origin is not None and not noted.origin.startswith("vpr-bench "):
        needed.append(f"{noted.origin}{_at(noted.method_source)}")
    return f"Do it again with what it was made with: {one_line(' and '.join(needed))}."


def _at(state: SourceState | None) -> str:
    return "" if state is None else f" ({state})"


def _quoted(value: Any) -> str:
    return (
        "none" if value is None else f"{one_line(value if isinstance(value, str) else json.dumps(value)):.{_LONGEST}}"
    )


def _plain(key: RunKey) -> dict[str, Any]:
    return _json(key.model_dump(mode="json"))


def _json(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values as they are after they have stood in a file."""
    read: dict[str, Any] = json.loads(json.dumps(dict(values)))
    return read
