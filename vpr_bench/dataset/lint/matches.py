"""What is odd about which references are right for which query."""

import re

import numpy as np
from numpy.typing import NDArray

from vpr_bench.dataset.lint.finding import Finding, Severity, listed, share
from vpr_bench.dataset.load import Case
from vpr_bench.types.traverse import Traverse

_FATES = {
    "exclude": "left out of every metric",
    "miss": "counted as a miss",
    "reject": "right to be answered with a low score",
}


def find_lonely(case: Case) -> list[Finding]:
    """Find queries that no reference is right for, and references that are right for no query."""
    truth, protocol = case.ground_truth, case.protocol
    findings = []
    lonely = np.flatnonzero(~truth.has_match)
    if len(lonely):
        message = (
            f"no true match for {share(len(lonely), truth.n_queries, 'query')}, and {_FATES[protocol.unmatched]}: "
            f"{_names(case.queries, lonely)}"
        )
        severity: Severity = "warning" if protocol.unmatched == "exclude" else "note"
        findings.append(Finding("query-without-match", severity, str(protocol), message))
    unused = np.setdiff1d(np.arange(truth.n_references), truth.references)
    if len(unused):
        message = (
            f"right for no query: {share(len(unused), truth.n_references, 'reference')}: "
            f"{_names(case.references, unused)}"
        )
        findings.append(Finding("reference-never-matched", "note", str(protocol), message))
    return findings


def find_asymmetric(case: Case) -> list[Finding]:
    """Find pairs of a listed ground truth that hold one way only.

    Where two traverses were filmed frame by frame at the same places, query 5 showing the place of reference 9 says
    that query 9 shows that of reference 5. Only then: elsewhere the two directions are different pairs.
    """
    truth = case.places.given
    if truth is None or not _frame_by_frame(case.references, case.queries):
        return []
    queries, references = truth.query_of_pair, truth.references
    there = truth.contains(references, queries)
    if there.all():
        return []
    one_way = np.flatnonzero(~there)
    pairs = [
        f"query {case.queries.name_of(queries[pair])} has reference {case.references.name_of(references[pair])}, "
        f"but {case.queries.name_of(references[pair])} has not {case.references.name_of(queries[pair])}"
        for pair in one_way[:2]
    ]
    message = f"listed one way only: {share(len(one_way), len(queries), 'pair')}: "
    return [Finding("asymmetric", "warning", f"{case.protocol.pairing}@given", message + "; ".join(pairs))]


def _frame_by_frame(references: Traverse, queries: Traverse) -> bool:
    """Whether image *i* of one traverse has the number, or the name, of image *i* of the other."""
    if len(references) != len(queries):
        return False
    marks = [[_mark(traverse.name_of(index)) for index in range(len(traverse))] for traverse in (references, queries)]
    return marks[0] == marks[1] and len(set(marks[0])) == len(marks[0])


def _mark(name: str) -> str:
    stem = name.rpartition("/")[2].rpartition(".")[0]
    numbers = re.findall(r"[0-9]+", stem)
    return numbers[-1].lstrip("0") if numbers else stem


def _names(traverse: Traverse, indices: NDArray[np.intp]) -> str:
    return listed([traverse.name_of(index) for index in indices])
